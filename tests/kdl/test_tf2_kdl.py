"""tf2_kdl: PyKDL's values through a buffer, and their conversions."""

from __future__ import annotations

import math
import subprocess
import sys

import pytest
import tf2_geometry_msgs
import tf2_kdl
import tf2_ros
from builtin_interfaces.msg import Time
from geometry_msgs.msg import PointStamped, Transform, TransformStamped, TwistStamped, WrenchStamped
from PyKDL import Equal, Frame, Rotation, Twist, Vector, Wrench
from std_msgs.msg import Header


@pytest.fixture
def transform() -> TransformStamped:
    """Return map_from_base: a quarter turn to the left at (1, 2, 3)."""
    message = TransformStamped(header=Header(frame_id="map", stamp=Time(sec=7)), child_frame_id="base")
    message.transform.translation.x, message.transform.translation.y, message.transform.translation.z = (
        1.0,
        2.0,
        3.0,
    )
    message.transform.rotation.z = message.transform.rotation.w = math.sqrt(0.5)
    return message


@pytest.fixture
def buffer(transform: TransformStamped) -> tf2_ros.Buffer:
    buffer = tf2_ros.Buffer()
    buffer.set_transform(transform, "test")
    return buffer


FRAME = Frame(Rotation.RotZ(math.pi / 2), Vector(1, 2, 3))


def test_a_transform_is_a_frame(transform: TransformStamped) -> None:
    assert Equal(tf2_kdl.transform_to_kdl(transform), FRAME, 1e-15)
    assert tf2_kdl.transform_to_kdl(transform.transform) == FRAME
    assert tf2_kdl.transform_to_kdl(TransformStamped(transform=Transform())) == Frame()


@pytest.mark.parametrize(
    "value",
    [
        Vector(1, 0, 0),
        Frame(Rotation.RPY(0.1, 0.2, 0.3), Vector(4, 5, 6)),
        Twist(Vector(1, 2, 3), Vector(4, 5, 6)),
        Wrench(Vector(1, 2, 3), Vector(4, 5, 6)),
    ],
    ids=["vector", "frame", "twist", "wrench"],
)
def test_a_buffer_transforms_each_class(buffer: tf2_ros.Buffer, value: object) -> None:
    tf2_ros.Stamped(value, Time(sec=7), "base")
    result = buffer.transform(value, "map")
    assert type(result) is type(value)
    assert Equal(result, FRAME * value, 1e-14)
    assert (result.header.frame_id, result.header.stamp.sec) == ("map", 7)
    assert value.header.frame_id == "base", "the argument is unchanged"


def test_twists_and_wrenches_agree_with_those_of_tf2_geometry_msgs(transform: TransformStamped) -> None:
    twist, wrench = TwistStamped(), WrenchStamped()
    for first, second in (
        (twist.twist.linear, twist.twist.angular),
        (wrench.wrench.force, wrench.wrench.torque),
    ):
        first.x, first.y, first.z, second.x, second.y, second.z = 1.0, 2.0, 3.0, 4.0, 5.0, 6.0
    moved = tf2_geometry_msgs.do_transform_twist_stamped(twist, transform).twist
    ours = tf2_kdl.do_transform_twist(Twist(Vector(1, 2, 3), Vector(4, 5, 6)), transform)
    assert tuple(ours.vel) == pytest.approx((moved.linear.x, moved.linear.y, moved.linear.z))
    assert tuple(ours.rot) == pytest.approx((moved.angular.x, moved.angular.y, moved.angular.z))
    load = tf2_geometry_msgs.do_transform_wrench_stamped(wrench, transform).wrench
    ours = tf2_kdl.do_transform_wrench(Wrench(Vector(1, 2, 3), Vector(4, 5, 6)), transform)
    assert tuple(ours.force) == pytest.approx((load.force.x, load.force.y, load.force.z))
    assert tuple(ours.torque) == pytest.approx((load.torque.x, load.torque.y, load.torque.z))


def test_headers_are_copies(transform: TransformStamped) -> None:
    moved = tf2_kdl.do_transform_vector(Vector(), transform)
    transform.header.frame_id = "changed"
    assert moved.header.frame_id == "map"


def test_conversions_are_registered() -> None:
    point = tf2_ros.Stamped(Vector(1, 2, 3), Time(sec=5, nanosec=6), "base")
    message = tf2_ros.convert(point, PointStamped)
    assert isinstance(message, PointStamped)
    assert (message.point.x, message.point.y, message.point.z) == (1.0, 2.0, 3.0)
    assert (message.header.frame_id, message.header.stamp) == ("base", Time(sec=5, nanosec=6))
    again = tf2_ros.convert(message, Vector)
    assert (again, again.header) == (point, point.header)
    copied = tf2_ros.convert(point, Vector)
    copied[0] = 9.0
    assert (point[0], copied.header) == (1.0, point.header)


def test_a_buffer_converts_its_result(buffer: tf2_ros.Buffer) -> None:
    message = buffer.transform(
        tf2_ros.Stamped(Vector(1, 0, 0), Time(sec=7), "base"), "map", new_type=PointStamped
    )
    assert (message.point.x, message.point.y, message.point.z) == pytest.approx((1.0, 3.0, 3.0))
    point = PointStamped(header=Header(frame_id="base", stamp=Time(sec=7)))
    assert buffer.transform(point, "map", new_type=Vector) == Vector(1, 2, 3)


def test_a_value_without_a_header_is_named() -> None:
    for convert in (tf2_kdl.to_msg_vector, tf2_kdl.convert_vector):
        with pytest.raises(AttributeError, match=r"no header is set: see tf2_ros\.Stamped"):
            convert(Vector())


def test_without_tf2_kdl_the_error_names_it() -> None:
    code = (
        "import PyKDL, tf2_ros, traceback\n"
        "try: tf2_ros.Buffer().transform(PyKDL.Vector(), 'map')\n"
        "except tf2_ros.TypeException as error: traceback.print_exception(error)\n"
    )
    shown = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert "Type <class 'PyKDL.Vector'> is not loaded or supported" in shown.stderr
    assert "add `import tf2_kdl`, which registers the conversions of PyKDL" in shown.stderr
