"""Transforms PyKDL's stamped values. Importing this registers them for `Buffer.transform` and `convert`.

A value is stamped by `tf2_ros.Stamped(value, stamp, frame_id)`, which sets its `header`. Arguments are not changed.
"""

from __future__ import annotations

from copy import copy
from typing import Any, TypeVar

from tfloom.interfaces.geometry_msgs.msg import PointStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.kdl.frames import Frame, Twist, Vector, Wrench, frame_of
from tfloom.tf2_ros.buffer_interface import ConvertRegistration, Stamped, TransformRegistration
from tfloom.tf2_ros.geometry import value_of

__all__ = [
    "convert_vector",
    "do_transform_frame",
    "do_transform_twist",
    "do_transform_vector",
    "do_transform_wrench",
    "from_msg_vector",
    "to_msg_vector",
    "transform_to_kdl",
]

Value = TypeVar("Value", Vector, Frame, Twist, Wrench)


def transform_to_kdl(t: Any) -> Frame:
    """Return a TransformStamped or Transform message as a Frame; a zero quaternion is the identity.

    Raises:
        ValueError: the quaternion is not finite.
    """
    return frame_of(value_of(t))


def do_transform_vector(vector: Vector, transform: Any) -> Vector:
    """Return a Vector, taken as a point, transformed by a TransformStamped, with its header."""
    return _with_header(transform_to_kdl(transform) * vector, transform)


def do_transform_frame(frame: Frame, transform: Any) -> Frame:
    """Return a Frame transformed by a TransformStamped, with its header."""
    return _with_header(transform_to_kdl(transform) * frame, transform)


def do_transform_twist(twist: Twist, transform: Any) -> Twist:
    """Return a Twist transformed by a TransformStamped, with its header: ω' = R ω, v' = R v + cross(t, ω')."""
    return _with_header(transform_to_kdl(transform) * twist, transform)


def do_transform_wrench(wrench: Wrench, transform: Any) -> Wrench:
    """Return a Wrench transformed by a TransformStamped, with its header: F' = R F, τ' = R τ + cross(t, F')."""
    return _with_header(transform_to_kdl(transform) * wrench, transform)


def to_msg_vector(vector: Vector) -> PointStamped:
    """Return a stamped Vector as a PointStamped.

    Raises:
        AttributeError: the vector has no header.
    """
    message = PointStamped(header=_copied(vector.header))
    message.point.x, message.point.y, message.point.z = vector
    return message


def from_msg_vector(msg: Any) -> Vector:
    """Return a PointStamped as a stamped Vector."""
    return _stamped(Vector(msg.point.x, msg.point.y, msg.point.z), msg.header)


def convert_vector(vector: Vector) -> Vector:
    """Return a copy of a stamped Vector.

    Raises:
        AttributeError: the vector has no header.
    """
    return _stamped(Vector(vector), vector.header)


def _with_header(value: Value, transform: Any) -> Value:
    value.header = _copied(transform.header)
    return value


def _stamped(vector: Vector, header: Any) -> Vector:
    stamped: Vector = Stamped(vector, copy(header.stamp), header.frame_id)
    return stamped


def _copied(header: Any) -> Header:
    """Return a Header of tfloom's, number by number, because the given one may be of another package's class."""
    result = Header(frame_id=header.frame_id)
    result.stamp.sec, result.stamp.nanosec = header.stamp.sec, header.stamp.nanosec
    return result


TransformRegistration().add(Vector, do_transform_vector)
TransformRegistration().add(Frame, do_transform_frame)
TransformRegistration().add(Twist, do_transform_twist)
TransformRegistration().add(Wrench, do_transform_wrench)
ConvertRegistration().add_to_msg(Vector, to_msg_vector)
ConvertRegistration().add_from_msg(Vector, from_msg_vector)
ConvertRegistration().add_convert((Vector, Vector), convert_vector)
