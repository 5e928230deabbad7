"""Forward kinematics, beside numbers computed by hand and beside a second library."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.conftest import run_to_end
from tests.robot.test_urdf import LIMIT, joint, robot

from tfloom.robot.model import RobotModel
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import LookupException

ARM = Path(__file__).parents[1] / "golden" / "arm.urdf"
Matrix = NDArray[np.float64]


def turn(axis: str, angle: float) -> Matrix:
    """Return a rotation about an axis of the frame, as a matrix (4, 4)."""
    c, s = math.cos(angle), math.sin(angle)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    matrix = np.eye(4)
    matrix[i, i] = matrix[j, j] = c
    matrix[i, j], matrix[j, i] = -s, s
    return matrix


def move(x: float, y: float, z: float) -> Matrix:
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def arm_by_hand(shoulder: float, rail: float, roll: float) -> list[Matrix]:
    """Return the poses of the recorded arm's links, in the base."""
    steps = [
        move(0, 0, 0.5) @ turn("y", 0.1) @ turn("y", shoulder),
        move(0.4, 0, 0) @ turn("y", -0.5 * shoulder + 0.2),
        move(0.3, 0, 0) @ move(rail, 0, 0),
        turn("x", roll),
        move(0.1, 0, 0) @ turn("z", 1.5707963),
    ]
    poses = [np.eye(4)]
    for step in steps:
        poses.append(poses[-1] @ step)
    return poses


def random_robot(random: np.random.Generator, count: int) -> str:
    """Return a tree of `count` joints of one variable or none, with random origins and axes."""
    joints = []
    for i in range(count):
        kind = ("revolute", "continuous", "prismatic", "fixed")[int(random.integers(4))]
        xyz, rpy, axis = (" ".join(map(repr, random.normal(size=3).tolist())) for _ in range(3))
        inside = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{LIMIT.replace("-1", "-9").replace("2", "9")}'
        joints.append(joint(f"j{i}", f"l{int(random.integers(i + 1))}", f"l{i + 1}", kind, inside))
    links = "".join(f'<link name="l{i}"/>' for i in range(count + 1))
    return f'<robot name="r">{links}{"".join(joints)}</robot>'


def test_the_recorded_arm_equals_what_is_computed_by_hand() -> None:
    model = RobotModel.from_urdf(ARM)
    assert model.links == ("base", "upper", "lower", "slide", "spin", "tool")
    assert model.variables == ("shoulder", "rail", "roll")
    positions = np.random.default_rng(1).uniform(-3, 3, (100, 3))
    matrices = model.matrices(positions)
    assert matrices.shape == (100, 6, 4, 4)
    expected = np.array([arm_by_hand(*row) for row in positions.tolist()])
    np.testing.assert_allclose(matrices, expected, rtol=0, atol=1e-12)


def test_forward_kinematics_equal_those_of_a_second_library() -> None:
    urdf = pytest.importorskip("pytransform3d.urdf")
    random = np.random.default_rng(2)
    for count in (1, 5, 50):
        text = random_robot(random, count)
        model = RobotModel.from_urdf(text)
        theirs = urdf.UrdfTransformManager()
        theirs.load_urdf(text)
        for positions in random.uniform(-3, 3, (5, len(model.variables))):
            for name, position in zip(model.variables, positions.tolist(), strict=True):
                theirs.set_joint(name, position)
            ours = model.matrices(positions)
            for link, matrix in zip(model.links, ours, strict=True):
                expected = theirs.get_transform(link, model.links[0])
                np.testing.assert_allclose(matrix, expected, rtol=0, atol=1e-12)


def test_planar_and_floating_joints() -> None:
    model = RobotModel.from_urdf(
        robot(
            joint("drive", "a", "b", "planar", '<origin xyz="1 2 3"/><axis xyz="0 0 1"/>'),
            joint("fly", "b", "c", "floating", '<origin xyz="0 0 1" rpy="0 0 1.5"/>'),
            joint("wall", "c", "d", "planar"),
            joint("down", "d", "e", "planar", '<axis xyz="0 0 -1"/>'),
            links="abcde",
        )
    )
    assert model.variables == (
        *("drive/x", "drive/y", "drive/theta"),
        *("fly/trans_x", "fly/trans_y", "fly/trans_z", "fly/rot_x", "fly/rot_y", "fly/rot_z", "fly/rot_w"),
        *("wall/x", "wall/y", "wall/theta", "down/x", "down/y", "down/theta"),
    )
    half = math.sin(0.35), math.cos(0.35)
    poses = model.matrices(
        {
            "drive/x": 0.5,
            "drive/y": -0.5,
            "drive/theta": 0.3,
            "fly/trans_x": 7.0,
            "fly/rot_y": half[0],
            "fly/rot_w": half[1],
            "wall/x": 0.25,
            "wall/y": 0.5,
            "wall/theta": -0.2,
            "down/x": 1.0,
            "down/y": 2.0,
            "down/theta": 0.4,
        }
    )
    drive = move(1, 2, 3) @ move(0.5, -0.5, 0) @ turn("z", 0.3)
    fly = move(0, 0, 1) @ turn("z", 1.5) @ move(7, 0, 0) @ turn("y", 0.7)
    # z turned to x: the plane's x is -z, its y stays.
    wall = move(0, 0.5, -0.25) @ turn("x", -0.2)
    down = move(1, -2, 0) @ turn("z", -0.4)
    expected = [np.eye(4), drive, drive @ fly, drive @ fly @ wall, drive @ fly @ wall @ down]
    np.testing.assert_allclose(poses, expected, rtol=0, atol=1e-12)


def test_shapes_follow_those_of_the_positions() -> None:
    model = RobotModel.from_urdf(ARM.read_text())
    assert model.forward([0, 0, 0]).shape == (6, 7)
    assert model.forward(np.zeros((4, 3), np.float32)).shape == (4, 6, 7)
    assert model.forward(np.zeros((0, 3))).shape == (0, 6, 7)
    assert model.forward(np.zeros((3, 8)).T[:, ::1]).shape == (8, 6, 7)
    assert model.forward({}).shape == (6, 7)
    assert model.forward({"roll": np.zeros(5), "rail": 0.1}).shape == (5, 6, 7)
    assert model.joint_transforms({"rail": [0.1, 0.2]})[:, 2, 0].tolist() == [0.4, 0.5]
    np.testing.assert_array_equal(model.forward({"rail": 0.1, "roll": 2.0}), model.forward([0, 0.1, 2.0]))


def test_a_robot_of_one_link() -> None:
    model = RobotModel.from_urdf('<robot name="r"><link name="a"/></robot>')
    assert model.forward(np.zeros((2, 0))).tolist() == [[[0, 0, 0, 0, 0, 0, 1]]] * 2
    assert model.joint_transforms(np.zeros((2, 0))).shape == (2, 0, 7)
    assert model.store(Buffer(), [1, 2], np.zeros((2, 0))) == 0


@pytest.mark.parametrize(
    ("positions", "error", "text"),
    [
        ([0, 0], ValueError, r"of shape \(N, 3\) or \(3,\), not \(2,\)"),
        ([[[0, 0, 0]]], ValueError, r"not \(1, 1, 3\)"),
        (["a", "b", "c"], TypeError, "must be numbers"),
        ({"rol": 0}, KeyError, "no such position variable: rol; there are: shoulder, rail, roll"),
        ({"elbow": 0}, KeyError, "no such position variable: elbow"),
        ({"roll": [0, 0], "rail": [0, 0, 0]}, ValueError, "shape mismatch"),
    ],
)
def test_wrong_positions_raise(positions: object, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        RobotModel.from_urdf(ARM).forward(positions)  # type: ignore[arg-type]


def test_positions_over_time_go_into_a_buffer() -> None:
    model = RobotModel.from_urdf(str(ARM))
    stamps = np.arange(1, 51) * 100_000_000
    positions = np.random.default_rng(3).uniform(-1, 1, (50, 3))
    buffer = Buffer(None)
    assert model.store(buffer, stamps, positions, frame_prefix="left/", authority="me") == 4 * 50 + 1
    poses = model.forward(positions)
    for link, name in enumerate(model.links):
        found = buffer.lookup_many("left/base", f"left/{name}", stamps)
        np.testing.assert_allclose(found.positions, poses[:, link, :3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(found.rotations_xyzw, poses[:, link, 3:], rtol=0, atol=1e-12)


def test_one_row_for_each_stamp() -> None:
    model, buffer = RobotModel.from_urdf(ARM), Buffer()
    with pytest.raises(ValueError, match=r"stamps_ns must be of shape \(3,\), not \(2,\)"):
        model.store(buffer, [1, 2], np.zeros((3, 3)))
    with pytest.raises(LookupException):
        buffer.lookup("base", "tool")
    assert model.store(buffer, [1, 2], {}) == 4 * 2 + 1, "numbers hold for all stamps"


def test_a_missing_file(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="nothere"):
        RobotModel.from_urdf(tmp_path / "nothere.urdf")


def test_importing_the_model_imports_nothing_heavy() -> None:
    heavy = ["numpy", "inspect", "tfloom.interfaces"]
    code = f"import sys, tfloom.robot.model; print([m for m in {heavy} if m in sys.modules])"
    assert run_to_end([sys.executable, "-c", code]).stdout == "[]\n"
