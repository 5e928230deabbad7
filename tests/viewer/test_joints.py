"""The joints that pages move: ranges, mimics, poses, and what a page may not ask for."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tfloom.robot.model import RobotModel
from tfloom.robot.urdf import parse_urdf
from tfloom.tf2.buffer import Buffer
from tfloom.viewer.joints import DescribedJoints, joint_command, joint_rows
from tfloom.viewer.page_command import PageError

ARM = Path(__file__).parents[2] / "examples" / "robot" / "arm.urdf"
LIMIT = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'
ODD = "".join(
    [
        '<robot name="odd">',
        *(f'<link name="{name}"/>' for name in "abcdef"),
        *(
            f'<joint name="{name}" type="{kind}"><parent link="a"/><child link="{child}"/>{rest}</joint>'
            for name, kind, child, rest in [
                ("off", "prismatic", "b", LIMIT.format(1, 3)),
                ("free", "continuous", "c", ""),
                ("far", "prismatic", "d", LIMIT.format(-1e300, 1e300)),
                (
                    "follower",
                    "revolute",
                    "e",
                    LIMIT.format(0, 1) + '<mimic joint="off" multiplier="2" offset="0.5"/>',
                ),
                ("fixed", "fixed", "f", ""),
            ]
        ),
        "</robot>",
    ]
)


class Robot:
    """A robot of a description, and its buffer."""

    def __init__(self, text: str) -> None:
        self.model = RobotModel(parse_urdf(text))
        self.buffer = Buffer(None)
        self.joints = DescribedJoints(self.model, self.buffer)

    def ask(self, **command: Any) -> None:
        joint_command(self.joints, command)

    def rows(self) -> dict[str, dict[str, Any]]:
        return {row["key"]: row for row in json.loads(json.dumps(joint_rows(self.joints), allow_nan=False))}

    def assert_stored(self) -> None:
        """Compare the buffer with the model at the positions that pages get."""
        free = {name: row["position"] for name, row in self.rows().items() if not row["follows"]}
        for link, pose in zip(self.model.links[1:], self.model.forward(free)[1:], strict=True):
            found = self.buffer.lookup(self.model.links[0], link)
            np.testing.assert_allclose([*found.translation, *found.rotation_xyzw], pose, atol=1e-9)


@pytest.fixture
def odd() -> Robot:
    return Robot(ODD)


@pytest.fixture
def arm() -> Robot:
    return Robot(ARM.read_text("utf-8"))


def test_joints_have_ranges_that_a_slider_can_have(odd: Robot) -> None:
    rows = odd.rows()
    assert list(rows) == ["off", "free", "far", "follower"]
    assert [(row["least"], row["greatest"], row["position"]) for row in rows.values()] == [
        (1.0, 3.0, 2.0),
        (-math.pi, math.pi, 0.0),
        (-1e6, 1e6, 0.0),
        (0.0, 1.0, 4.5),
    ]
    assert [row["unit"] for row in rows.values()] == ["m", "rad", "m", "rad"]
    assert [row["follows"] for row in rows.values()] == ["", "", "", "off"]
    odd.assert_stored()


def test_joint_is_moved_within_its_range_and_others_follow(odd: Robot) -> None:
    odd.ask(op="joint", name="off", position=1.25)
    assert (odd.rows()["off"]["position"], odd.rows()["follower"]["position"]) == (1.25, 3.0)
    odd.ask(op="joint", name="off", position=99)
    assert odd.rows()["off"]["position"] == 3.0
    odd.ask(op="joint", name="free", position=-99.0)
    assert odd.rows()["free"]["position"] == -math.pi
    odd.assert_stored()


def test_poses_are_of_rest_and_at_random(arm: Robot) -> None:
    rest = arm.rows()
    poses = []
    for _ in range(20):
        arm.ask(op="pose", to="random")
        poses.append([row["position"] for row in arm.rows().values()])
        arm.assert_stored()
        for row in arm.rows().values():
            assert row["follows"] or row["least"] <= row["position"] <= row["greatest"]
    spread = np.ptp(np.array(poses), axis=0)
    ranges = np.array([row["greatest"] - row["least"] for row in rest.values()])
    assert (spread > 0.3 * ranges).all()
    arm.ask(op="pose", to="rest")
    assert arm.rows() == rest


def test_rest_is_in_the_range(odd: Robot) -> None:
    odd.ask(op="joint", name="off", position=1.0)
    odd.ask(op="pose", to="rest")
    assert odd.rows()["off"]["position"] == 2.0


@pytest.mark.parametrize(
    ("command", "why"),
    [
        ({"op": "joint", "name": "follower", "position": 0.5}, "no joint 'follower' that can be moved"),
        ({"op": "joint", "name": "fixed", "position": 0.5}, "no joint 'fixed' that can be moved"),
        ({"op": "joint", "name": "off", "position": math.nan}, "position has to be a finite number"),
        ({"op": "joint", "name": "off"}, "position has to be a finite number"),
        ({"op": "joint", "position": 1.0}, "name has to be a text"),
        ({"op": "pose", "to": "bed"}, "a pose is rest or random"),
    ],
)
def test_what_cant_be_done_is_a_sentence(odd: Robot, command: dict[str, Any], why: str) -> None:
    before = odd.rows()
    with pytest.raises(PageError, match=why):
        odd.ask(**command)
    assert odd.rows() == before


def test_link_is_told_with_its_joint(odd: Robot) -> None:
    assert odd.joints.about("b") == "b is on a by the prismatic joint off"
    assert odd.joints.about("a") == odd.joints.about("nowhere") == ""


def test_nothing_is_kept_of_former_poses(arm: Robot) -> None:
    for _ in range(5):
        arm.ask(op="pose", to="random")
    assert all(edge.is_static for edge in arm.buffer.edges())
