"""Transforms messages of geometry_msgs. Importing this registers them for `Buffer.transform`.

Arguments are not changed. Messages may be of any class that has the fields; the result is of the same class.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeVar, cast

from tfloom.interfaces.geometry_msgs.msg import (
    PointStamped,
    PolygonStamped,
    PoseStamped,
    PoseWithCovarianceStamped,
    QuaternionStamped,
    TransformStamped,
    TwistStamped,
    Vector3Stamped,
    VelocityStamped,
    WrenchStamped,
)
from tfloom.tf2.transform import Transform
from tfloom.tf2_ros.buffer_interface import ConvertRegistration, TransformRegistration

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "do_transform_point",
    "do_transform_polygon",
    "do_transform_polygon_stamped",
    "do_transform_pose",
    "do_transform_pose_stamped",
    "do_transform_pose_with_covariance",
    "do_transform_pose_with_covariance_stamped",
    "do_transform_quaternion",
    "do_transform_quaternion_stamped",
    "do_transform_transform",
    "do_transform_transform_stamped",
    "do_transform_twist",
    "do_transform_twist_stamped",
    "do_transform_vector3",
    "do_transform_velocity_stamped",
    "do_transform_wrench",
    "do_transform_wrench_stamped",
    "from_msg_msg",
    "to_msg_msg",
    "transform_covariance",
    "value_of",
]

Triple = tuple[float, float, float]
Quadruple = tuple[float, float, float, float]
_Function = TypeVar("_Function", bound=Callable[..., Any])


def to_msg_msg(msg: Any) -> Any:
    """Return the message itself."""
    return msg


def from_msg_msg(msg: Any) -> Any:
    """Return the message itself."""
    return msg


def value_of(transform: Any) -> Transform:
    """Return a Transform or TransformStamped message as a value; a zero quaternion is the identity."""
    message = getattr(transform, "transform", transform)
    return Transform(_xyz(message.translation), _rotation(message.rotation))


def _taking(kinds: str) -> Callable[[_Function], _Function]:
    """Let a function say what it needs and what it got, in one frame, where an argument lacks a field."""

    def decorate(function: _Function) -> _Function:
        @wraps(function)
        def run(*args: Any, **kwargs: Any) -> Any:
            try:
                return function(*args, **kwargs)
            except AttributeError as error:
                given = " and ".join(type(argument).__name__ for argument in (*args, *kwargs.values()))
                needs = f"{function.__name__}() needs {kinds}, and a TransformStamped"
                # One of these functions may have called another, whose kind the program has not chosen.
                text = str(error).partition(": do_transform_")[0]
                raise AttributeError(f"{text}: {needs}, got {given}") from None

        return cast("_Function", run)

    return decorate


@_taking("a PointStamped, a Point or a Point32")
def do_transform_point(point: Any, transform: Any) -> Any:
    """Transform a PointStamped, whose new header is the TransformStamped's; or a Point or Point32."""
    if hasattr(point, "point"):
        return _stamped(point, transform, "point", do_transform_point)
    return _with_xyz(point, value_of(transform).apply(_xyz(point)))


@_taking("a Vector3Stamped or a Vector3")
def do_transform_vector3(vector3: Any, transform: Any) -> Any:
    """Rotate a Vector3Stamped, whose new header is the TransformStamped's; or a Vector3.

    A vector is rotated but not translated, because it has no position.
    """
    if hasattr(vector3, "vector"):
        return _stamped(vector3, transform, "vector", do_transform_vector3)
    return _with_xyz(vector3, _turned(value_of(transform), _xyz(vector3)))


@_taking("a Pose")
def do_transform_pose(pose: Any, transform: Any) -> Any:
    """Transform a Pose by a TransformStamped; its orientation has w ≥ 0."""
    result = type(pose)()
    moved = value_of(transform) @ Transform(_xyz(pose.position), _rotation(pose.orientation))
    _set_xyz(result.position, moved.translation)
    x, y, z, w = moved.rotation_xyzw
    _put_quaternion(result.orientation, (-x, -y, -z, -w) if w < 0 else (x, y, z, w))
    return result


@_taking("a PoseStamped")
def do_transform_pose_stamped(pose: Any, transform: Any) -> Any:
    """Transform a PoseStamped; its new header is the TransformStamped's."""
    return _stamped(pose, transform, "pose", do_transform_pose)


@_taking("a PoseWithCovariance")
def do_transform_pose_with_covariance(pose: Any, transform: Any) -> Any:
    """Transform a PoseWithCovariance by a TransformStamped."""
    result = type(pose)()
    result.pose = do_transform_pose(pose.pose, transform)
    result.covariance = transform_covariance(pose.covariance, transform)
    return result


@_taking("a PoseWithCovarianceStamped")
def do_transform_pose_with_covariance_stamped(pose: Any, transform: Any) -> Any:
    """Transform a PoseWithCovarianceStamped; its new header is the TransformStamped's."""
    return _stamped(pose, transform, "pose", do_transform_pose_with_covariance)


@_taking("a Polygon")
def do_transform_polygon(polygon: Any, transform: Any) -> Any:
    """Transform a Polygon by a TransformStamped."""
    result = type(polygon)()
    value = value_of(transform)
    result.points = [_with_xyz(point, value.apply(_xyz(point))) for point in polygon.points]
    return result


@_taking("a PolygonStamped")
def do_transform_polygon_stamped(polygon: Any, transform: Any) -> Any:
    """Transform a PolygonStamped; its new header is the TransformStamped's."""
    return _stamped(polygon, transform, "polygon", do_transform_polygon)


@_taking("a Quaternion")
def do_transform_quaternion(quaternion: Any, transform: Any) -> Any:
    """Rotate a Quaternion by a TransformStamped."""
    result = type(quaternion)()
    q = quaternion
    _put_quaternion(result, _product(value_of(transform).rotation_xyzw, (q.x, q.y, q.z, q.w)))
    return result


@_taking("a QuaternionStamped")
def do_transform_quaternion_stamped(quaternion: Any, transform: Any) -> Any:
    """Rotate a QuaternionStamped; its new header is the TransformStamped's."""
    return _stamped(quaternion, transform, "quaternion", do_transform_quaternion)


@_taking("a Transform")
def do_transform_transform(moved: Any, transform: Any) -> Any:
    """Return target_from_child from the Transform source_from_child and the TransformStamped target_from_source."""
    result = type(moved)()
    value = value_of(transform) @ value_of(moved)
    _set_xyz(result.translation, value.translation)
    _put_quaternion(result.rotation, value.rotation_xyzw)
    return result


@_taking("a TransformStamped")
def do_transform_transform_stamped(moved: Any, transform: Any) -> Any:
    """Return target_from_child, with the header of the TransformStamped target_from_source."""
    return _stamped(moved, transform, "transform", do_transform_transform, "child_frame_id")


@_taking("a Wrench")
def do_transform_wrench(wrench: Any, transform: Any) -> Any:
    """Transform a Wrench to the target frame: F' = R F, τ' = R τ + cross(t, F')."""
    result = type(wrench)()
    force, torque = _shifted(value_of(transform), _xyz(wrench.force), _xyz(wrench.torque))
    _set_xyz(result.force, force)
    _set_xyz(result.torque, torque)
    return result


@_taking("a WrenchStamped")
def do_transform_wrench_stamped(wrench: Any, transform: Any) -> Any:
    """Transform a WrenchStamped; its new header is the TransformStamped's."""
    return _stamped(wrench, transform, "wrench", do_transform_wrench)


@_taking("a Twist")
def do_transform_twist(twist: Any, transform: Any) -> Any:
    """Transform a Twist of the same body to the target frame: ω' = R ω, v' = R v + cross(t, ω')."""
    result = type(twist)()
    angular, linear = _shifted(value_of(transform), _xyz(twist.angular), _xyz(twist.linear))
    _set_xyz(result.angular, angular)
    _set_xyz(result.linear, linear)
    return result


@_taking("a TwistStamped")
def do_transform_twist_stamped(twist: Any, transform: Any) -> Any:
    """Transform a TwistStamped; its new header is the TransformStamped's."""
    return _stamped(twist, transform, "twist", do_transform_twist)


@_taking("a VelocityStamped")
def do_transform_velocity_stamped(velocity: Any, transform: Any) -> Any:
    """Transform a VelocityStamped; its new header is the TransformStamped's, its other frames are kept."""
    return _stamped(
        velocity, transform, "velocity", do_transform_twist, "body_frame_id", "reference_frame_id"
    )


def transform_covariance(cov_in: ArrayLike, transform: Any) -> NDArray[np.float64]:
    """Rotate a covariance (36,), row-major over x, y, z and rotations about them: R C Rᵀ for each 3 x 3 block."""
    import numpy as np

    turn = value_of(transform).matrix()[:3, :3]
    blocks = np.asarray(cov_in, np.float64).reshape(2, 3, 2, 3).swapaxes(1, 2)
    turned: NDArray[np.float64] = (turn @ blocks @ turn.T).swapaxes(1, 2).reshape(36)
    return turned


def _stamped(
    message: Any, transform: Any, part: str, do_transform: Callable[[Any, Any], Any], *kept: str
) -> Any:
    """Return a new message of the same class: the transform's header, `part` transformed, the `kept` fields copied.

    The header is copied number by number, because the two messages may be of different packages' classes.
    """
    result = type(message)()
    header, other = result.header, transform.header
    header.frame_id = other.frame_id
    header.stamp.sec, header.stamp.nanosec = other.stamp.sec, other.stamp.nanosec
    for name in kept:
        setattr(result, name, getattr(message, name))
    setattr(result, part, do_transform(getattr(message, part), transform))
    return result


def _with_xyz(part: Any, xyz: Triple) -> Any:
    """Return a new point or vector of the same class."""
    result = type(part)()
    _set_xyz(result, xyz)
    return result


def _xyz(part: Any) -> Triple:
    return part.x, part.y, part.z


def _set_xyz(part: Any, xyz: Triple) -> None:
    part.x, part.y, part.z = xyz


def _rotation(q: Any) -> Quadruple:
    """Return a quaternion (x, y, z, w); one of zeros, as in an unset message, is the identity."""
    rotation = (q.x, q.y, q.z, q.w)
    return rotation if any(rotation) else (0.0, 0.0, 0.0, 1.0)


def _put_quaternion(part: Any, xyzw: Quadruple) -> None:
    part.x, part.y, part.z, part.w = xyzw


def _turned(value: Transform, vector: Triple) -> Triple:
    return Transform((0.0, 0.0, 0.0), value.rotation_xyzw).apply(vector)


def _shifted(value: Transform, resultant: Triple, moment: Triple) -> tuple[Triple, Triple]:
    """Transform a force and its torque, or an angular and a linear velocity, to the target frame.

    f' = R f and m' = R m + t x f'.
    """
    fx, fy, fz = turned = _turned(value, resultant)
    mx, my, mz = _turned(value, moment)
    tx, ty, tz = value.translation
    return turned, (mx + (ty * fz - tz * fy), my + (tz * fx - tx * fz), mz + (tx * fy - ty * fx))


def _product(a: Quadruple, b: Quadruple) -> Quadruple:
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


_REGISTERED = {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    PolygonStamped: do_transform_polygon_stamped,
    QuaternionStamped: do_transform_quaternion_stamped,
    TransformStamped: do_transform_transform_stamped,
    WrenchStamped: do_transform_wrench_stamped,
    TwistStamped: do_transform_twist_stamped,
    VelocityStamped: do_transform_velocity_stamped,
}
for _kind, _function in _REGISTERED.items():
    TransformRegistration().add(_kind, _function)
for _kind in (Vector3Stamped, PoseStamped, PointStamped):
    ConvertRegistration().add_to_msg(_kind, to_msg_msg)
    ConvertRegistration().add_from_msg(_kind, from_msg_msg)
