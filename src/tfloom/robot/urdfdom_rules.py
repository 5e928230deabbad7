"""Descriptions that urdfdom refuses, the parser of ROS's own programs, though they say all that frames need."""

from __future__ import annotations

import re

from tfloom.robot.urdf_faults import Remarks
from tfloom.robot.xml_elements import Element

__all__ = ["note_refusals"]

_NUMBER = re.compile(r"\s*[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
"""A number as a stream of C++ reads it: blanks may be before it, and nothing behind it."""
_NUMBERS = {
    "limit": ("lower", "upper", "effort", "velocity"),
    "dynamics": ("damping", "friction"),
    "safety_controller": ("k_velocity", "k_position", "soft_lower_limit", "soft_upper_limit"),
    "calibration": ("rising", "falling"),
    "mimic": ("multiplier", "offset"),
}
_VECTORS = {"origin": ("xyz", "rpy", "quat_xyzw"), "axis": ("xyz",)}


def note_refusals(robot: Element, remarks: Remarks) -> None:
    """Add a remark for each place for which urdfdom refuses a robot; what is wrong with its links it only prints."""
    _note_version(robot, remarks)
    materials: set[str] = set()
    for material in robot.all_of("material"):
        name = material.attributes.get("name", "")
        if name in materials:
            remarks.add(material.line, f"the material '{name}' exists already", "material", is_refused=True)
        materials.add(name)
    for joint in robot.all_of("joint"):
        for element in joint.children:
            where = f"of the joint '{joint.attributes.get('name', '')}'"
            for fault in _faults(element):
                remarks.add(element.line, f"<{element.tag}> {where} {fault}", fault, is_refused=True)


def _note_version(robot: Element, remarks: Remarks) -> None:
    version = robot.attributes.get("version")
    if version is None or re.fullmatch(r"\s*0*1\.\s*0+", version):
        return
    if version == "1.2":
        remarks.add(
            robot.line, f"the version '{version}' of the description is read by ROS 2 Lyrical and later"
        )
        return
    fault = f"the version '{version}' of the description is not 1.0"
    remarks.add(robot.line, fault, is_refused=True)


def _faults(element: Element) -> list[str]:
    attributes = element.attributes
    faults = [
        f"has {name}='{_shown(text)}', where a number is wanted without anything behind it"
        for name in _NUMBERS.get(element.tag, ())
        if name in attributes and not _NUMBER.fullmatch(text := element.written(name))
    ]
    faults += [
        f"has {name}='{_shown(text)}', where spaces alone may be between the numbers"
        for name in _VECTORS.get(element.tag, ())
        if name in attributes
        and not all(map(_NUMBER.fullmatch, filter(None, (text := element.written(name)).split(" "))))
    ]
    if element.tag == "dynamics" and not {"damping", "friction"} & attributes.keys():
        faults.append("has neither damping nor friction")
    if element.tag == "safety_controller" and "k_velocity" not in attributes:
        faults.append("has no k_velocity")
    return faults


def _shown(text: str) -> str:
    return text.replace("\t", "\\t").replace("\n", "\\n")
