"""URDF: the description of a robot in XML. What only simulation and display need is not read."""

from __future__ import annotations

import math

from tfloom.robot.description import MOVING, VARIABLES, Description, Joint, Limit, Mimic
from tfloom.robot.joint_tree import find_root
from tfloom.robot.mimicry import followers, unfit
from tfloom.robot.urdf_faults import Remarks, UrdfError
from tfloom.robot.urdf_values import number, origin_of, required, vector
from tfloom.robot.urdfdom_rules import note_refusals
from tfloom.robot.xml_elements import Element, read_xml

__all__ = ["UrdfError", "parse_urdf"]

LIMITED = ("revolute", "prismatic")
"""The types whose limits are required."""
_EXPAND = "expand it with 'ros2 run xacro xacro FILE'"


def parse_urdf(text: str | bytes, *, is_nested: bool = False) -> Description:
    """Return the robot that a URDF describes.

    What ROS's own parser takes is read as far as it makes sense; the description's `remarks` say what is wrong with it.

    Args:
        text: A str, or the bytes of a file, whose encoding its first line names.
        is_nested: Whether other elements may be around the robot, the first of which is taken.

    Raises:
        UrdfError: the text is not a valid description; its message has the line.
    """
    remarks = Remarks()
    outermost = read_xml(text, remarks)
    robot = outermost.first_within("robot") if is_nested else outermost
    if robot is None:
        raise UrdfError(outermost.line, f"there is no <robot> within <{outermost.tag}>")
    if robot.tag != "robot":
        raise UrdfError(robot.line, f"the outermost element is <{robot.tag}>, not <robot>")
    xacro = [element for element in robot.descendants() if _is_xacro(element)]
    for element in xacro:
        remarks.add(element.line, f"<{element.tag}> is xacro that was not expanded: {_EXPAND}", "xacro")
    try:
        name = required(robot, "name", "the robot")
        links = _links(robot)
        joints = _joints(robot, links, remarks)
        root = find_root(links, joints)
        followers(joints)  # raises for what can't be followed
    except UrdfError:
        if not xacro:
            raise
        raise UrdfError(xacro[0].line, f"this is xacro, not URDF: {_EXPAND}") from None
    note_refusals(robot, remarks)
    return Description(name, root, tuple(links), joints, remarks.collected())


def _is_xacro(element: Element) -> bool:
    return element.tag.startswith("xacro:") or any(
        "${" in value or "$(" in value for value in element.attributes.values()
    )


def _links(robot: Element) -> dict[str, int]:
    """Return the line of each link, by name."""
    links: dict[str, int] = {}
    for element in robot.all_of("link"):
        name = required(element, "name", "a link")
        if name in links:
            reason = f"the link '{name}' exists already: line {links[name]} has it"
            raise UrdfError(element.line, reason)
        links[name] = element.line
    if not links:
        raise UrdfError(robot.line, "the robot has no link")
    return links


def _joints(robot: Element, links: dict[str, int], remarks: Remarks) -> dict[str, Joint]:
    joints: dict[str, Joint] = {}
    for element in robot.all_of("joint"):
        joint = _joint(element, links)
        if joint.name in joints:
            reason = f"the joint '{joint.name}' exists already: line {joints[joint.name].line} has it"
            raise UrdfError(joint.line, reason)
        joints[joint.name] = joint
    for name, joint in joints.items():
        if joint.mimic is not None and (why := unfit(joint.mimic.joint, joints)):
            # The others move all the same; this one has its own position then, as in robot_state_publisher.
            remarks.add(joint.line, f"the joint '{name}' follows none, because it mimics {why}", "mimic")
            joints[name] = joint._replace(mimic=None)
    return joints


def _joint(element: Element, links: dict[str, int]) -> Joint:
    name = required(element, "name", "a joint")
    what = f"the joint '{name}'"
    kind = required(element, "type", what)
    if kind not in VARIABLES:
        raise UrdfError(element.line, f"{what} is of type '{kind}', which is none of: {', '.join(VARIABLES)}")
    return Joint(
        name=name,
        type=kind,
        parent=_link(element, "parent", what, links),
        child=_link(element, "child", what, links),
        origin=origin_of(element, what),
        axis=_axis(element, kind, what),
        line=element.line,
        limit=_limit(element, kind, what),
        soft_limit=_soft_limit(element, what),
        mimic=_mimic(element, kind, what),
        effort_limit=_effort_limit(element, what),
    )


def _link(element: Element, end: str, what: str, links: dict[str, int]) -> str:
    end_element = element.first(end)
    if end_element is None:
        raise UrdfError(element.line, f"{what} has no <{end}> link")
    name = required(end_element, "link", f"<{end}> of {what}")
    if name not in links:
        raise UrdfError(end_element.line, f"{what} has the {end} link '{name}', which does not exist")
    return name


def _axis(element: Element, kind: str, what: str) -> tuple[float, float, float]:
    axis = element.first("axis")
    if axis is None or kind in {"fixed", "floating"}:
        return 1.0, 0.0, 0.0
    x, y, z = vector(axis, "xyz", "1 0 0", what)
    largest = max(abs(x), abs(y), abs(z))
    if not largest:
        raise UrdfError(axis.line, f"the axis of {what} has no direction: it is zero")
    x, y, z = x / largest, y / largest, z / largest  # their squares can't overflow
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, z / length


def _limit(element: Element, kind: str, what: str) -> Limit | None:
    limit = element.first("limit")
    if limit is None:
        if kind in LIMITED:
            other = "; one without limits is 'continuous'" if kind == "revolute" else ""
            raise UrdfError(element.line, f"{what} is of type '{kind}' and has no <limit>{other}")
        return None
    for attribute in ("effort", "velocity"):
        number(limit, attribute, None, f"<limit> of {what}")
    return Limit(number(limit, "lower", 0.0, what), number(limit, "upper", 0.0, what))


def _effort_limit(element: Element, what: str) -> float | None:
    limit = element.first("limit")
    return None if limit is None else number(limit, "effort", None, f"<limit> of {what}")


def _soft_limit(element: Element, what: str) -> Limit | None:
    controller = element.first("safety_controller")
    if controller is None:
        return None
    lower = number(controller, "soft_lower_limit", -math.inf, what)
    return Limit(lower, number(controller, "soft_upper_limit", math.inf, what))


def _mimic(element: Element, kind: str, what: str) -> Mimic | None:
    mimic = element.first("mimic")
    if mimic is None or kind not in MOVING:
        return None
    if "joint" not in mimic.attributes:
        raise UrdfError(mimic.line, f"<mimic> of {what} has no joint")
    return Mimic(
        mimic.attributes["joint"], number(mimic, "multiplier", 1.0, what), number(mimic, "offset", 0.0, what)
    )
