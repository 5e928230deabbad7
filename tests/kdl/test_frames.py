"""PyKDL's geometry against scipy and closed forms, its parts in place, and what is not in it."""

from __future__ import annotations

import copy
import math
import pickle
import subprocess
import sys

import numpy as np
import PyKDL
import pytest
from PyKDL import Equal, Frame, Rotation, SetToZero, Twist, Vector, Wrench, addDelta, diff, dot

from tfloom.kdl.frames import frame_of, transform_of
from tfloom.tf2.transform import Transform

NUMBERS = np.random.default_rng(18)
ANGLES = NUMBERS.uniform(-math.pi, math.pi, (200, 3))


def matrix(rotation: Rotation) -> np.ndarray:
    return np.array([[rotation[i, j] for j in range(3)] for i in range(3)])


def some_vector() -> Vector:
    return Vector(*NUMBERS.normal(size=3))


def some_frame() -> Frame:
    return Frame(Rotation.RPY(*NUMBERS.uniform(-3, 3, 3)), some_vector())


def near(a: object, b: object) -> bool:
    return Equal(a, b, 1e-12)


@pytest.mark.parametrize(("make", "axes"), [("RPY", "xyz"), ("EulerZYX", "ZYX"), ("EulerZYZ", "ZYZ")])
def test_angles_make_the_matrix_of_scipy(make: str, axes: str) -> None:
    from scipy.spatial.transform import Rotation as Scipy

    for angles in ANGLES:
        wanted = Scipy.from_euler(axes, angles).as_matrix()
        np.testing.assert_allclose(matrix(getattr(Rotation, make)(*angles)), wanted, atol=1e-15)


@pytest.mark.parametrize(
    ("make", "get"), [("RPY", "GetRPY"), ("EulerZYX", "GetEulerZYX"), ("EulerZYZ", "GetEulerZYZ")]
)
def test_angles_read_back_make_the_same_rotation(make: str, get: str) -> None:
    locked = [
        (a, b, c) for b in (0.0, math.pi / 2, -math.pi / 2, math.pi) for a in (0.0, 1.0) for c in (0.0, -2.0)
    ]
    for angles in [*ANGLES, *locked]:
        rotation = getattr(Rotation, make)(*angles)
        assert near(getattr(Rotation, make)(*getattr(rotation, get)()), rotation), angles


def test_axes_and_quaternions_equal_scipys() -> None:
    from scipy.spatial.transform import Rotation as Scipy

    for angles in ANGLES:
        rotation, wanted = Rotation.RPY(*angles), Scipy.from_euler("xyz", angles)
        np.testing.assert_allclose(tuple(rotation.GetRot()), wanted.as_rotvec(), atol=1e-12)
        sign = np.sign(np.dot(rotation.GetQuaternion(), wanted.as_quat()))
        np.testing.assert_allclose(rotation.GetQuaternion(), sign * wanted.as_quat(), atol=1e-12)
        assert near(Rotation.Quaternion(*wanted.as_quat()), rotation)
        angle, axis = rotation.GetRotAngle()
        assert near(Rotation.Rot(axis, angle), rotation)
        assert near(Rotation.Rot2(axis, angle), rotation)


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, math.pi - 1e-3, math.pi - 1e-9, math.pi])
def test_rotation_vectors_near_0_and_half_a_turn(angle: float) -> None:
    for axis in (Vector(1, 0, 0), Vector(0, -1, 0), Vector(1, 2, -3), Vector(-3, 1, 1)):
        axis.Normalize()
        rotation = Rotation.Rot(axis, angle)
        assert Equal(Rotation.Rot(rotation.GetRot(), rotation.GetRotAngle()[0]), rotation, 1e-6)
        found = rotation.GetRot().Norm(0)
        assert found == pytest.approx(angle, abs=1e-6)


def test_a_small_tolerance_finds_the_axis_of_a_small_angle() -> None:
    angle, axis = Rotation.RotY(1e-7).GetRotAngle(1e-12)
    assert angle == pytest.approx(1e-7)
    assert near(axis, Vector(0, 1, 0))


def test_products_are_those_of_matrices() -> None:
    for _ in range(50):
        a, b, v = some_frame(), some_frame(), some_vector()
        np.testing.assert_allclose(matrix((a * b).M), matrix(a.M) @ matrix(b.M), atol=1e-14)
        np.testing.assert_allclose(tuple(a * v), matrix(a.M) @ tuple(v) + tuple(a.p), atol=1e-14)
        np.testing.assert_allclose(tuple(v * b.p), np.cross(tuple(v), tuple(b.p)), atol=1e-14)
        assert dot(v, b.p) == pytest.approx(np.dot(tuple(v), tuple(b.p)))
        assert near(a * a.Inverse(), Frame())
        assert near(a.Inverse(v), a.Inverse() * v)


def test_change_of_frame_keeps_power_and_the_bodys_points() -> None:
    """The power of a wrench along a twist does not depend on the frame; a point of the body has one velocity."""
    for _ in range(50):
        frame, twist, wrench = (
            some_frame(),
            Twist(some_vector(), some_vector()),
            Wrench(some_vector(), some_vector()),
        )
        power = dot(twist, wrench)
        assert dot(frame * twist, frame * wrench) == pytest.approx(power, abs=1e-12)
        assert dot(wrench, twist) == pytest.approx(power, abs=1e-12)
        base = some_vector()
        assert dot(twist.RefPoint(base), wrench.RefPoint(base)) == pytest.approx(power, abs=1e-12)
        moved, point = frame * twist, some_vector()
        of_point = frame.M * (twist.vel + twist.rot * point)
        assert near(moved.vel + moved.rot * (frame * point), of_point)
        assert near(frame.Inverse(frame * twist), twist)
        assert near(frame.Inverse(frame * wrench), wrench)
        assert near(frame.M * twist, Frame(frame.M) * twist)


def test_add_delta_undoes_diff() -> None:
    for _ in range(50):
        for a, b in (
            (some_vector(), some_vector()),
            (some_frame().M, some_frame().M),
            (some_frame(), some_frame()),
            (Twist(some_vector(), some_vector()), Twist(some_vector(), some_vector())),
            (Wrench(some_vector(), some_vector()), Wrench(some_vector(), some_vector())),
        ):
            assert near(addDelta(a, diff(a, b, 0.1), 0.1), b)
            assert near(diff(a, b, dt=2), diff(a, b) / 2)


def test_integrating_a_turn_of_a_second() -> None:
    frame = Frame(Rotation.RotZ(0.5), Vector(1, 0, 0))
    for _ in range(1000):
        frame.Integrate(Twist(Vector(), Vector(0, 0, 0.3)), 1000)
    assert Equal(frame, Frame(Rotation.RotZ(0.8), Vector(1, 0, 0)), 1e-9)


def test_denavit_and_hartenbergs_parameters_are_four_motions() -> None:
    for a, alpha, d, theta in NUMBERS.uniform(-2, 2, (20, 4)):
        turn_z, turn_x = Frame(Rotation.RotZ(theta)), Frame(Rotation.RotX(alpha))
        move_x, move_z = Frame(Vector(a, 0, 0)), Frame(Vector(0, 0, d))
        assert near(Frame.DH(a, alpha, d, theta), turn_z * move_z * move_x * turn_x)
        assert near(Frame.DH_Craig1989(a, alpha, d, theta), move_x * turn_x * turn_z * move_z)


def test_parts_are_changed_in_place() -> None:
    frame, twist, wrench = Frame(), Twist(), Wrench()
    frame.p[0], frame.M[0, 1], twist.rot[2] = 1.0, 2.0, 3.0
    wrench.torque += Vector(0, 4, 0)
    assert (frame.p.x(), frame[0, 3], frame[0, 1], twist[5], wrench[4]) == (1.0, 1.0, 2.0, 3.0, 4.0)
    part = frame.p
    del frame
    assert tuple(part) == (1.0, 0.0, 0.0), "a part keeps the whole alive"
    alias = part
    alias += Vector(1, 1, 1)
    assert alias is part
    SetToZero(part)
    assert part == Vector()


@pytest.mark.parametrize(
    "copied", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))]
)
def test_copies_keep_all_digits_and_the_header(copied: object) -> None:
    for value in (some_vector(), some_frame().M, some_frame(), Twist(some_vector(), some_vector()), Wrench()):
        value.header = {"frame_id": "map"}
        other = copied(value)
        assert Equal(other, value, 1e-300)
        assert other.header == value.header
        assert (other.header is value.header) == (copied is copy.copy)
        assert not hasattr(type(value)(value), "header")


def test_a_rotation_pickled_by_the_original_is_read() -> None:
    rotation = Rotation.__new__(Rotation)
    rotation.__setstate__((0.1, 0.2, 0.3))
    assert near(rotation, Rotation.RPY(0.1, 0.2, 0.3))


@pytest.mark.parametrize("state", [(), (1.0,), (1.0, "a", 2.0), ((1.0, 2.0), {})])
def test_a_damaged_pickle_raises(state: tuple[object, ...]) -> None:
    for kind in (Vector, Rotation, Frame, Twist, Wrench):
        with pytest.raises((ValueError, TypeError, RuntimeError)):
            kind.__new__(kind).__setstate__(state)


def test_transforms_and_frames_are_the_same() -> None:
    for _ in range(20):
        transform = Transform.from_rpy(*NUMBERS.uniform(-3, 3, 3), tuple(NUMBERS.normal(size=3)))
        point = NUMBERS.normal(size=3)
        np.testing.assert_allclose(
            tuple(frame_of(transform) * Vector(*point)), transform.apply(point), atol=1e-14
        )
        np.testing.assert_allclose(transform_of(frame_of(transform)).matrix(), transform.matrix(), atol=1e-14)
    with pytest.raises(ValueError, match="no direction"):
        transform_of(Frame(Rotation.Quaternion(0, 0, 0, math.nan)))


def test_what_is_not_there_says_what_is() -> None:
    with pytest.raises(AttributeError, match=r"has no Chain: it has Vector, .*tfloom\.robot"):
        _ = PyKDL.Chain
    with pytest.raises(AttributeError, match=r"has no FrameVel.*Twist"):
        _ = PyKDL.FrameVel
    with pytest.raises(AttributeError, match="module 'PyKDL' has no attribute 'nothing'"):
        _ = PyKDL.nothing
    assert not hasattr(PyKDL, "Tree")


def test_numpys_numbers_are_factors() -> None:
    vector = Vector(1, 2, 3)
    for factor in (np.float64(2), np.float32(2), np.int64(2)):
        assert vector * factor == Vector(2, 4, 6)
    assert np.array(list(vector)).tolist() == [1, 2, 3]


def test_import_loads_neither_numpy_nor_messages() -> None:
    code = "import PyKDL, sys; print([m for m in sys.modules if m == 'numpy' or 'interfaces' in m])"
    shown = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert shown.stdout.strip() == "[]", shown
