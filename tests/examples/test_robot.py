"""The example robots: the URDF is what the macros expand to, and the launch file shows their frames."""

from __future__ import annotations

import signal
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from tfloom.robot.model import RobotModel
from tfloom.robot.xml_elements import Element, read_xml

ROBOT = Path(__file__).parents[2] / "examples" / "robot"


def content(element: Element) -> tuple[object, ...]:
    """Return an element without its lines."""
    return element.tag, element.attributes, [content(child) for child in element.children]


@pytest.mark.parametrize("name", ["arm", "wheeled"])
def test_the_urdf_is_what_the_macros_expand_to(name: str, start_program: Callable[..., Any]) -> None:
    pytest.importorskip("xacro", reason="xacro is not installed: pip install 'tfloom[robot]'")
    program = start_program("tfloom", "run", "xacro", "xacro", ROBOT / f"{name}.urdf.xacro")
    assert program.wait() == 0, program.output
    assert content(read_xml(program.output)) == content(read_xml((ROBOT / f"{name}.urdf").read_bytes()))


def test_the_fingers_of_the_arm_close_together() -> None:
    arm = RobotModel.from_urdf(ROBOT / "arm.urdf")
    poses = arm.joint_transforms({"left_finger_slide": 0.02})
    names = [joint.name for joint in arm.joints]
    left, right = (poses[names.index(f"{side}_finger_slide"), :3] for side in ("left", "right"))
    np.testing.assert_allclose(left, [0.03, 0, 0.05], atol=1e-15)
    np.testing.assert_allclose(right, [-0.03, 0, 0.05], atol=1e-15)


def test_the_camera_looks_along_z() -> None:
    robot = RobotModel.from_urdf(ROBOT / "wheeled.urdf")
    pose = robot.matrices({})[robot.links.index("camera_optical")]
    np.testing.assert_allclose(pose[:3, 2], [np.cos(0.2), 0, -np.sin(0.2)], atol=1e-12)
    assert robot.variables == ("left_wheel_joint", "right_wheel_joint", "caster_swivel")


def test_the_launch_file_shows_the_robots_frames(domain_id: int, start_program: Callable[..., Any]) -> None:
    pytest.importorskip("xacro", reason="xacro is not installed: pip install 'tfloom[robot]'")
    launch = start_program("tfloom", "launch", ROBOT / "display.launch.py", "robot:=wheeled", "delta:=0.0")
    launch.wait_for("[tf2_echo-3] - Translation: [0.250, 0.000, 0.200]")
    launch.wait_for("Robot initialized")
    launch.signal(signal.SIGINT)
    assert launch.wait() == 0, launch.output


def test_how_far_the_arm_reaches(
    load_example: Callable[[str], ModuleType], capsys: pytest.CaptureFixture[str]
) -> None:
    load_example("robot/reach.py").main()
    text = capsys.readouterr().out
    assert "the tool is 0.059 m to 1.020 m from the base" in text
    assert "StampedTransform('base_link' from 'tool', stamp_ns=505000000" in text
