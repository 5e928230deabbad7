"""Transforming messages."""

from __future__ import annotations

import math
import subprocess
import sys
from copy import deepcopy
from typing import Any

import numpy as np
import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.geometry_msgs import msg as g
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2_ros import geometry
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_interface import (
    CONVERSIONS,
    BufferInterface,
    ConvertRegistration,
    NotImplementedException,
    Stamped,
    TransformRegistration,
    TypeException,
    convert,
)

# A translation by 10, 20, 30 m, and half a turn about x.
TRANSFORM = transform_stamped("B", "A", 2 * SECOND, (10.0, 20.0, 30.0), (1.0, 0.0, 0.0, 0.0))


def numbers(part: Any) -> list[float]:
    return [getattr(part, axis) for axis in "xyzw" if hasattr(part, axis)]


@pytest.fixture
def buffer() -> Buffer:
    buffer = Buffer()
    there = transform_stamped("A", "B", 2 * SECOND, (10.0, 20.0, 30.0), (1.0, 0.0, 0.0, 0.0))
    buffer.set_transform(there, "me")
    return buffer


HEADER = Header(stamp=Time(seconds=2).to_msg(), frame_id="A")


def test_points_are_transformed() -> None:
    point = g.PointStamped(point=g.Point(x=1.0, y=2.0, z=3.0))
    moved = geometry.do_transform_point(point, TRANSFORM)
    assert numbers(moved.point) == pytest.approx([11, 18, 27])
    assert moved.header == TRANSFORM.header
    assert moved.header is not TRANSFORM.header


@pytest.mark.parametrize(
    ("message", "field", "expected"),
    [
        (g.PointStamped(header=HEADER, point=g.Point(x=1.0, y=2.0, z=3.0)), "point", [-9, 18, 27]),
        (g.Vector3Stamped(header=HEADER, vector=g.Vector3(x=1.0, y=2.0, z=3.0)), "vector", [1, -2, -3]),
    ],
)
def test_buffer_transforms_registered_types(
    buffer: Buffer, message: Any, field: str, expected: list[float]
) -> None:
    before = deepcopy(message)
    moved = buffer.transform(message, "B", Duration(seconds=1))
    assert numbers(getattr(moved, field)) == pytest.approx(expected)
    assert (moved.header.frame_id, moved.header.stamp.sec) == ("B", 2)
    assert message == before
    again = buffer.transform_full(message, "B", Time(seconds=2), "A")
    assert numbers(getattr(again, field)) == pytest.approx(expected)


def test_transformed_pose_has_positive_w() -> None:
    pose = g.Pose(position=g.Point(x=1.0, y=2.0, z=3.0), orientation=g.Quaternion(x=1.0, y=0.0, z=0.0, w=0.0))
    moved = geometry.do_transform_pose(pose, TRANSFORM)
    assert numbers(moved.position) == pytest.approx([11, 18, 27])
    assert numbers(moved.orientation) == pytest.approx([0, 0, 0, 1])


def test_covariance_is_rotated() -> None:
    pose = g.PoseWithCovarianceStamped()
    pose.pose.pose.position = g.Point(x=1.0, y=2.0, z=3.0)
    pose.pose.covariance = np.tile(np.arange(1.0, 7.0), 6)
    moved = geometry.do_transform_pose_with_covariance_stamped(pose, TRANSFORM)
    odd, even = [1, -2, -3, 4, -5, -6], [-1, 2, 3, -4, 5, 6]
    assert moved.pose.covariance.reshape(6, 6).tolist() == [odd, even, even, odd, even, even]
    assert numbers(moved.pose.pose.position) == pytest.approx([11, 18, 27])


def test_covariance_of_a_long_quaternion(deviations: dict[str, dict[str, str]]) -> None:
    assert "tf2-covariance-length" in deviations
    covariance = np.diag([1.0, 2, 3, 4, 5, 6]).reshape(36)
    long = transform_stamped("B", "A", 0, (0.0, 0.0, 0.0), (0.0, 0.0, 5.0, 5.0))
    turned = geometry.transform_covariance(covariance, long).reshape(6, 6)
    assert np.allclose(turned, np.diag([2, 1, 3, 5, 4, 6]))


def test_quaternions_are_rotated() -> None:
    half = math.sqrt(0.5)
    turned = geometry.do_transform_quaternion_stamped(
        g.QuaternionStamped(quaternion=g.Quaternion(x=0.0, y=-half, z=0.0, w=half)), TRANSFORM
    )
    assert numbers(turned.quaternion) == pytest.approx([half, 0, -half, 0])


def test_wrenches_are_transformed() -> None:
    transform = transform_stamped("B", "A", 0, (0.0, -2.0, 0.0), (0.0, 0.0, -math.sqrt(0.5), math.sqrt(0.5)))
    two_one_three = g.Vector3(x=2.0, y=1.0, z=3.0)
    moved = geometry.do_transform_wrench_stamped(
        g.WrenchStamped(wrench=g.Wrench(force=two_one_three, torque=two_one_three)), transform
    )
    assert numbers(moved.wrench.force) == pytest.approx([1, -2, 3])
    assert numbers(moved.wrench.torque) == pytest.approx([-5, -2, 5])


def test_twists_and_velocities_are_transformed() -> None:
    transform = transform_stamped("B", "A", 0, (0.0, 2.0, 0.0))
    twist = g.Twist(linear=g.Vector3(x=1.0), angular=g.Vector3(z=3.0))
    for moved in (
        geometry.do_transform_twist_stamped(g.TwistStamped(twist=twist), transform).twist,
        geometry.do_transform_velocity_stamped(g.VelocityStamped(velocity=twist), transform).velocity,
    ):
        assert numbers(moved.linear) == pytest.approx([7, 0, 0])
        assert numbers(moved.angular) == pytest.approx([0, 0, 3])


def test_unstamped_messages_are_transformed() -> None:
    for kind in (g.Point, g.Point32):
        moved = geometry.do_transform_point(kind(x=1.0, y=2.0, z=3.0), TRANSFORM)
        assert type(moved) is kind
        assert numbers(moved) == pytest.approx([11, 18, 27])
    assert numbers(geometry.do_transform_vector3(g.Vector3(x=1.0, y=2.0, z=3.0), TRANSFORM)) == [1, -2, -3]
    half = math.sqrt(0.5)
    turned = geometry.do_transform_quaternion(g.Quaternion(x=0.0, y=-half, z=0.0, w=half), TRANSFORM)
    assert numbers(turned) == pytest.approx([half, 0, -half, 0])


def test_transforms_are_composed() -> None:
    a_from_c = transform_stamped("A", "C", SECOND, (1.0, 2.0, 3.0), (0.0, 0.0, 1.0, 0.0))
    b_from_c = geometry.do_transform_transform_stamped(a_from_c, TRANSFORM)
    assert (b_from_c.header, b_from_c.child_frame_id) == (TRANSFORM.header, "C")
    assert numbers(b_from_c.transform.translation) == pytest.approx([11, 18, 27])
    point = g.PointStamped(point=g.Point(x=0.3, y=-2.0, z=7.0))
    two_steps = geometry.do_transform_point(geometry.do_transform_point(point, a_from_c), TRANSFORM)
    assert numbers(geometry.do_transform_point(point, b_from_c).point) == pytest.approx(
        numbers(two_steps.point)
    )


def test_polygons_are_transformed() -> None:
    polygon = g.PolygonStamped(polygon=g.Polygon(points=[g.Point32(x=1.0, y=2.0, z=3.0)]))
    moved = geometry.do_transform_polygon_stamped(polygon, TRANSFORM)
    assert [numbers(point) for point in moved.polygon.points] == [pytest.approx([11, 18, 27])]


def test_transform_is_not_changed() -> None:
    before = deepcopy(TRANSFORM)
    geometry.do_transform_vector3(g.Vector3Stamped(), TRANSFORM)
    assert before == TRANSFORM


def test_zero_quaternion_is_the_identity() -> None:
    transform = transform_stamped("B", "A", 0, (1.0, 1.0, 1.0), (0.0, 0.0, 0.0, 0.0))
    moved = geometry.do_transform_point(g.PointStamped(point=g.Point(x=1.0)), transform)
    assert numbers(moved.point) == [2, 1, 1]


def test_unregistered_type_raises(buffer: Buffer) -> None:
    with pytest.raises(TypeException, match="is not loaded or supported"):
        buffer.transform(5, "B")


def unregistered_types(imported: str, *types: str) -> list[str]:
    """Return the notes of `transform` of each type in a program that has imported `imported` beside tf2_ros."""
    lines = [
        f"import tf2_ros, {imported}, geometry_msgs.msg, sensor_msgs.msg",
        f"for message_class in ({''.join(f'{cls}, ' for cls in types)}):",
        "    try:",
        "        tf2_ros.Buffer().transform(message_class(), 'map')",
        "    except tf2_ros.TypeException as error:",
        "        print(error, getattr(error, '__notes__', []))",
    ]
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)], capture_output=True, text=True, check=True
    )
    return [line.partition(" is not loaded or supported ")[2] for line in done.stdout.splitlines()]


def test_what_is_not_registered_names_the_import() -> None:
    types = ("geometry_msgs.msg.PointStamped", "geometry_msgs.msg.Pose", "sensor_msgs.msg.PointCloud2")
    cloud = "add `import tf2_sensor_msgs`, which registers the conversions of sensor_msgs"
    register = "add `import tf2_geometry_msgs`, which registers the conversions of geometry_msgs"
    stamped = "a Pose has no frame: transform a PoseStamped"
    assert unregistered_types("math", *types, "sensor_msgs.msg.Imu") == [
        f"['{register}']",
        f"['{stamped}, and {register}']",
        f"['{cloud}']",
        "[]",
    ]
    assert unregistered_types("tf2_geometry_msgs", *types[1:]) == [f"['{stamped}']", f"['{cloud}']"]


def test_the_imports_that_are_named_register_these_types() -> None:
    for module, types in CONVERSIONS.items():
        code = (
            f"import {module}; from tfloom.tf2_ros.buffer_interface import TransformRegistration as T, _ros_name;"
            "print(*('/'.join(_ros_name(cls)) for cls in T._functions))"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        assert types <= set(done.stdout.split())


def test_interface_methods_raise() -> None:
    interface = BufferInterface()
    with pytest.raises(TypeException) as raised:
        interface.transform(5, "B")
    assert raised.value.errstr == str(raised.value) == "Type <class 'int'> is not loaded or supported"
    queries = {
        interface.lookup_transform: 3, interface.can_transform: 3,
        interface.lookup_transform_full: 5, interface.can_transform_full: 5,
    }  # fmt: skip
    for ask, count in queries.items():
        with pytest.raises(NotImplementedException) as refused:
            ask(*["x"] * count)
        assert refused.value.errstr == "CanTransform or LookupTransform not implemented"


def test_custom_functions_can_be_registered(buffer: Buffer) -> None:
    class Landmark:
        header = HEADER
        x = 1.0

    class Numbers(list):
        pass

    TransformRegistration().add(Landmark, lambda mark, found: mark.x + found.transform.translation.x)
    assert buffer.transform(Landmark(), "B") == pytest.approx(1 - 10)
    registration = ConvertRegistration()
    registration.add_to_msg(Landmark, lambda mark: g.Point(x=mark.x))
    registration.add_from_msg(Numbers, lambda point: Numbers([point.x, point.y, point.z]))
    assert convert(Landmark(), Numbers) == [1, 0, 0]
    registration.add_convert((Landmark, Numbers), lambda mark: Numbers([mark.x]))
    assert convert(Landmark(), Numbers) == [1]
    assert registration.get_convert((Landmark, Numbers))(Landmark()) == [1]
    point = g.PointStamped(header=HEADER, point=g.Point(x=1.0))
    registration.add_convert((g.PointStamped, Numbers), lambda message: Numbers(numbers(message.point)))
    assert buffer.transform(point, "B", new_type=Numbers) == pytest.approx([-9, 20, 30])
    assert buffer.transform_full(point, "B", Time(seconds=2), "A", new_type=Numbers)[0] == pytest.approx(-9)


def test_convert_and_stamped() -> None:
    point = Stamped(g.PointStamped(), Time(seconds=3), "map")
    assert (point.header.frame_id, point.header.stamp.sec) == ("map", 3)
    same = convert(point, g.PointStamped)
    assert same == point
    assert same is not point
    assert convert(point, g.PoseStamped) is point  # both are messages, so a message converts to itself
    with pytest.raises(TypeException):
        convert(point, int)
