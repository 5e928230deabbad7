"""Messages of other classes, as in a real ROS install: read by attribute, with results of the same class."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.geometry_msgs import msg as g
from tfloom.interfaces.sensor_msgs import msg as s
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.values.time import Time
from tfloom.tf2_ros import geometry
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_interface import TypeException, convert
from tfloom.tf2_ros.point_clouds import point_cloud
from tfloom.tf2_ros.point_clouds.point_cloud2 import (
    create_cloud_xyz32,
    dtype_from_fields,
    read_points,
    read_points_list,
    read_points_numpy,
)

_classes: dict[type, type] = {}


def foreign(kind: type) -> type:
    """Return another class of the same ROS name and fields, with type checks as in ROS's classes."""
    if kind in _classes:
        return _classes[kind]
    package = kind.__module__.split(".")[0]
    names = list(kind.get_fields_and_field_types())

    def start(self: Any) -> None:
        ours = kind()
        for name in names:
            value = getattr(ours, name)
            is_message = hasattr(value, "get_fields_and_field_types")
            object.__setattr__(self, name, foreign(type(value))() if is_message else value)

    def assign(self: Any, name: str, value: Any) -> None:
        assert name in names, f"there is no field {name}"
        assert isinstance(value, type(getattr(self, name))), f"{name} can't be a {type(value)}"
        object.__setattr__(self, name, value)

    body = {"__init__": start, "__setattr__": assign, "__module__": f"{package}.msg._it"}
    _classes[kind] = type(kind.__name__, (), body)
    return _classes[kind]


def as_foreign(message: Any) -> Any:
    result = foreign(type(message))()
    for name in type(message).get_fields_and_field_types():
        value = getattr(message, name)
        if hasattr(value, "get_fields_and_field_types"):
            value = as_foreign(value)
        elif isinstance(value, list):
            value = [as_foreign(item) for item in value]
        object.__setattr__(result, name, value)
    return result


def require_equal(theirs: Any, ours: Any) -> None:
    """Check that all fields are equal, nested ones included, and that one side's are of foreign classes."""
    assert type(theirs) is foreign(type(ours))
    for name in type(ours).get_fields_and_field_types():
        value, expected = getattr(theirs, name), getattr(ours, name)
        if hasattr(expected, "get_fields_and_field_types"):
            require_equal(value, expected)
        elif isinstance(expected, list):
            assert len(value) == len(expected)
            for pair in zip(value, expected, strict=True):
                require_equal(*pair)
        else:
            assert np.array_equal(value, expected), name


TRANSFORM = transform_stamped("B", "A", 2 * SECOND, (10.0, 20.0, 30.0), (0.5, 0.5, 0.5, 0.5))
XYZ = g.Vector3(x=1.0, y=2.0, z=3.0)
TWIST = g.Twist(linear=XYZ, angular=XYZ)
POSE = g.Pose(position=g.Point(x=1.0, y=2.0, z=3.0))
WITH_COVARIANCE = g.PoseWithCovariance(pose=POSE, covariance=np.arange(36.0))
POLYGON = g.Polygon(points=[g.Point32(x=1.0), g.Point32(y=2.0)])
UNSTAMPED: list[tuple[Callable[..., Any], Any]] = [
    (geometry.do_transform_point, g.Point(x=1.0, y=2.0, z=3.0)),
    (geometry.do_transform_point, g.Point32(x=1.0, y=2.0, z=3.0)),
    (geometry.do_transform_vector3, XYZ),
    (geometry.do_transform_quaternion, g.Quaternion(x=1.0, w=0.0)),
    (geometry.do_transform_pose, POSE),
    (geometry.do_transform_pose_with_covariance, WITH_COVARIANCE),
    (geometry.do_transform_polygon, POLYGON),
    (geometry.do_transform_transform, TRANSFORM.transform),
    (geometry.do_transform_twist, TWIST),
    (geometry.do_transform_wrench, g.Wrench(force=XYZ, torque=XYZ)),
]
STAMPED: list[tuple[Callable[..., Any], Any]] = [
    (geometry.do_transform_point, g.PointStamped(point=g.Point(x=1.0, y=2.0, z=3.0))),
    (geometry.do_transform_vector3, g.Vector3Stamped(vector=XYZ)),
    (geometry.do_transform_quaternion_stamped, g.QuaternionStamped(quaternion=g.Quaternion(x=1.0, w=0.0))),
    (geometry.do_transform_pose_stamped, g.PoseStamped(pose=POSE)),
    (geometry.do_transform_pose_with_covariance_stamped, g.PoseWithCovarianceStamped(pose=WITH_COVARIANCE)),
    (geometry.do_transform_polygon_stamped, g.PolygonStamped(polygon=POLYGON)),
    (geometry.do_transform_transform_stamped, transform_stamped("A", "C", 2 * SECOND)),
    (geometry.do_transform_twist_stamped, g.TwistStamped(twist=TWIST)),
    (geometry.do_transform_velocity_stamped, g.VelocityStamped(velocity=TWIST, body_frame_id="C")),
    (geometry.do_transform_wrench_stamped, g.WrenchStamped(wrench=g.Wrench(force=XYZ, torque=XYZ))),
]
for _, stamped in STAMPED:
    stamped.header.frame_id = "A"
    stamped.header.stamp = Time(seconds=2).to_msg()


def name_of(value: object) -> str:
    return getattr(value, "__name__", type(value).__name__)


@pytest.mark.parametrize(("function", "message"), UNSTAMPED + STAMPED, ids=name_of)
def test_result_has_the_class_of_the_argument(function: Callable[..., Any], message: Any) -> None:
    require_equal(function(as_foreign(message), as_foreign(TRANSFORM)), function(message, TRANSFORM))


@pytest.mark.parametrize(("function", "message"), STAMPED, ids=name_of)
def test_buffer_transforms_foreign_messages(function: Callable[..., Any], message: Any) -> None:
    buffer = Buffer()
    buffer.set_transform(as_foreign(transform_stamped("B", "A", 2 * SECOND)), "me")
    expected = function(message, buffer.lookup_transform("B", "A", Time(seconds=2)))
    require_equal(buffer.transform(as_foreign(message), "B"), expected)
    require_equal(buffer.transform_full(as_foreign(message), "B", Time(seconds=2), "A"), expected)
    assert (expected.header.frame_id, expected.header.stamp.sec) == ("B", 2)


def test_static_foreign_messages_and_times() -> None:
    buffer = Buffer()
    buffer.set_transform_static(as_foreign(transform_stamped("B", "A", 0)), "me")
    at = as_foreign(Time(seconds=9).to_msg())
    assert buffer.lookup_transform("B", "A", at).header.stamp.sec == 9
    assert buffer.can_transform_full("B", at, "A", at, "B")


def test_foreign_messages_are_converted() -> None:
    point = as_foreign(STAMPED[0][1])
    assert convert(point, type(point)) is not point
    assert convert(point, g.PointStamped) is point  # a message is its own message
    with pytest.raises(TypeException, match="TFMessage'> is not loaded or supported"):
        convert(as_foreign(TFMessage()), g.PointStamped)


def test_foreign_clouds_are_transformed() -> None:
    cloud = create_cloud_xyz32(STAMPED[0][1].header, np.arange(12.0).reshape(4, 3))
    theirs = as_foreign(cloud)
    require_equal(
        point_cloud.do_transform_cloud(theirs, as_foreign(TRANSFORM)),
        point_cloud.do_transform_cloud(cloud, TRANSFORM),
    )
    assert (read_points(theirs) == read_points(cloud)).all()
    assert (read_points_numpy(theirs, ["x", "z"]) == read_points_numpy(cloud, ["x", "z"])).all()
    assert read_points_list(theirs) == read_points_list(cloud)
    assert dtype_from_fields(theirs.fields) == dtype_from_fields(cloud.fields)
    buffer = Buffer()
    buffer.set_transform(transform_stamped("B", "A", 2 * SECOND), "me")
    require_equal(buffer.transform(theirs, "B"), buffer.transform(cloud, "B"))
    assert isinstance(cloud, s.PointCloud2)
