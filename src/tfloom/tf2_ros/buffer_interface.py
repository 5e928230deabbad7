"""The interface of buffers: transform objects by the functions registered for their types."""

from __future__ import annotations

from collections.abc import Callable, Collection
from copy import deepcopy
from typing import Any, ClassVar

from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import add_note
from tfloom.node.values.time import Time
from tfloom.ros_imports.guard import ros_home
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer_core import duration_error, frame_error, time_error

__all__ = [
    "BufferInterface",
    "ConvertRegistration",
    "NotImplementedException",
    "Stamped",
    "TransformRegistration",
    "TypeException",
    "convert",
]

NO_WAIT = Duration()

CONVERSIONS = {
    "tf2_geometry_msgs": {
        "geometry_msgs/PointStamped",
        "geometry_msgs/PolygonStamped",
        "geometry_msgs/PoseStamped",
        "geometry_msgs/PoseWithCovarianceStamped",
        "geometry_msgs/QuaternionStamped",
        "geometry_msgs/TransformStamped",
        "geometry_msgs/TwistStamped",
        "geometry_msgs/Vector3Stamped",
        "geometry_msgs/VelocityStamped",
        "geometry_msgs/WrenchStamped",
    },
    "tf2_sensor_msgs": {"sensor_msgs/PointCloud2"},
}
"""The types that `Buffer.transform` takes once a module is imported, by the module; for hints."""


class TypeException(Exception):
    """No function is registered for a type."""

    __module__ = ros_home("tf2_ros.buffer_interface", __name__)

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr


class NotImplementedException(Exception):
    """The buffer's class does not implement this query."""

    __module__ = ros_home("tf2_ros.buffer_interface", __name__)

    def __init__(self) -> None:
        super().__init__("CanTransform or LookupTransform not implemented")
        self.errstr = "CanTransform or LookupTransform not implemented"


class BufferInterface:
    """The queries of a buffer, and `transform` on top of them."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self, object_stamped: Any, target_frame: str, timeout: Any = NO_WAIT, new_type: Any = None
    ) -> Any:
        """Return `object_stamped`, which has a header, in `target_frame` at its own time.

        Args:
            object_stamped: An object of a type that a package such as tf2_geometry_msgs has registered.
            target_frame: Frame to express it in.
            timeout: The longest wait for the transform.
            new_type: Type to convert the result to.

        Raises:
            TypeException: nothing is registered for the object's type, or for `new_type`.
            TransformException: as from `lookup_transform`.
        """
        error = (
            frame_error(target_frame)
            or duration_error(timeout)
            or self._object_error(object_stamped, new_type)
        )
        if error is not None:
            raise error
        header = object_stamped.header
        transform = self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        return self._transformed(object_stamped, transform, new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Any,
        fixed_frame: str,
        timeout: Any = NO_WAIT,
        new_type: Any = None,
    ) -> Any:
        """Return `object_stamped` in `target_frame` at another time, by way of `fixed_frame`; see `transform`."""
        wrong_query = frame_error(target_frame) or frame_error(fixed_frame) or time_error(target_time)
        error = wrong_query or duration_error(timeout) or self._object_error(object_stamped, new_type)
        if error is not None:
            raise error
        header = object_stamped.header
        transform = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout
        )
        return self._transformed(object_stamped, transform, new_type)

    def _object_error(self, object_stamped: Any, new_type: Any) -> Exception | None:
        kind = type(object_stamped)
        if self._registered(kind) is None:
            return _unregistered(kind, getattr(self.registration, "_functions", ()))
        return None if new_type is None else self._conversion_error(kind, new_type)

    def _transformed(self, object_stamped: Any, transform: Any, new_type: Any) -> Any:
        transform_object: Any = self._registered(type(object_stamped))
        result = transform_object(object_stamped, transform)
        return result if new_type is None else self._converted(result, new_type)

    def _conversion_error(self, kind: Any, new_type: Any) -> Exception | None:
        conversion = _conversion(kind, new_type)
        return conversion if isinstance(conversion, TypeException) else None

    def _converted(self, result: Any, new_type: Any) -> Any:
        return convert(result, new_type)

    def _registered(self, kind: Any) -> Callable[..., Any] | None:
        return self.registration.find(kind)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any = NO_WAIT
    ) -> Any:
        """Return the transform from one frame to another."""
        raise NotImplementedException

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = NO_WAIT,
    ) -> Any:
        """Return the transform from one frame at one time to another frame at another time."""
        raise NotImplementedException

    def can_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Any = NO_WAIT) -> Any:
        """Return whether `lookup_transform` succeeds within `timeout`."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = NO_WAIT,
    ) -> Any:
        """Return whether `lookup_transform_full` succeeds within `timeout`."""
        query = target_frame, target_time, source_frame, source_time, fixed_frame
        try:
            self.lookup_transform_full(*query, timeout)
        except TransformException:
            return False
        return True


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """Set the header of `obj` to one with this stamp and frame, in place, and return `obj`."""
    message = stamp.to_msg() if isinstance(stamp, Time) else stamp
    obj.header = Header(frame_id=frame_id, stamp=message)
    return obj


class TransformRegistration:
    """The functions that transform objects, by type: one table for the whole process."""

    _functions: ClassVar[dict[Any, Callable[..., Any]]] = {}

    def print_me(self) -> None:
        """Print the registered functions, by the types that they transform."""
        print(self._functions)

    def add(self, key: Any, callback: Callable[..., Any]) -> None:
        """Register `callback(object, transform_stamped)` to transform objects of the type `key`."""
        self._functions[key] = callback

    def get(self, key: Any) -> Callable[..., Any]:
        """Return the function for a type.

        Raises:
            TypeException: no function is registered for it; a note names the package that registers one.
        """
        function = self.find(key)
        if function is None:
            raise _unregistered(key, self._functions)
        return function

    def find(self, key: Any) -> Callable[..., Any] | None:
        """Return the function for a type, or None."""
        return _find_function(self._functions, key)


class ConvertRegistration:
    """The functions that convert between types: one table for the whole process."""

    _to_msg: ClassVar[dict[Any, Callable[[Any], Any]]] = {}
    _from_msg: ClassVar[dict[Any, Callable[[Any], Any]]] = {}
    _convert: ClassVar[dict[tuple[Any, Any], Callable[[Any], Any]]] = {}

    def add_from_msg(self, key: Any, callback: Callable[[Any], Any]) -> None:
        """Register `callback(message)` to make an object of the type `key`."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: Any, callback: Callable[[Any], Any]) -> None:
        """Register `callback(object)` to make a message of an object of the type `key`."""
        self._to_msg[key] = callback

    def add_convert(self, key: tuple[Any, Any], callback: Callable[[Any], Any]) -> None:
        """Register `callback(object)` to convert from the type `key[0]` to the type `key[1]`."""
        self._convert[key] = callback

    def get_from_msg(self, key: Any) -> Callable[[Any], Any]:
        """Return the function that makes `key` of a message; raise TypeException without one."""
        if (function := _find_function(self._from_msg, key)) is None:
            raise _not_loaded(key)
        return function

    def get_to_msg(self, key: Any) -> Callable[[Any], Any]:
        """Return the function that makes a message of `key`; raise TypeException without one."""
        if (function := _find_function(self._to_msg, key)) is None:
            raise _not_loaded(key)
        return function

    def get_convert(self, key: tuple[Any, Any]) -> Callable[[Any], Any]:
        """Return the function that converts `key[0]` to `key[1]`; raise TypeException without one."""
        if (function := _find_function(self._convert, key)) is None:
            raise _not_loaded(key)
        return function


def convert(a: Any, b_type: Any) -> Any:
    """Return `a` converted to `b_type`: by the function registered for the two, as a copy, or by way of a message.

    Raises:
        TypeException: no such conversion is registered.
    """
    conversion = _conversion(type(a), b_type)
    if isinstance(conversion, TypeException):
        raise conversion
    return conversion(a)


def _conversion(kind: Any, new_type: Any) -> Callable[[Any], Any] | TypeException:
    """Return the function that converts objects of the type `kind`, or the error that there is none."""
    tables = ConvertRegistration
    if (direct := _find_function(tables._convert, (kind, new_type))) is not None:  # noqa: SLF001
        return direct
    if kind is new_type:
        return deepcopy
    if (from_msg := _find_function(tables._from_msg, new_type)) is None:  # noqa: SLF001
        return _not_loaded(new_type)
    if (to_msg := _find_function(tables._to_msg, kind)) is None:  # noqa: SLF001
        return _not_loaded(kind)
    return lambda given: from_msg(to_msg(given))


def _how_to_transform(key: Any, registered: Collection[Any]) -> str:
    """Return a sentence on what to import, or on the stamped type to use; empty if neither helps."""
    if getattr(key, "__module__", "") == "PyKDL":
        return "add `import tf2_kdl`, which registers the conversions of PyKDL"
    name = _ros_name(key)
    if name is None or isinstance(key, tuple):
        return ""
    package, base = name
    stamped = base if base.endswith("Stamped") or package == "sensor_msgs" else f"{base}Stamped"
    module = next(
        (module_name for module_name, types in CONVERSIONS.items() if f"{package}/{stamped}" in types), None
    )
    if module is None:
        return ""
    advice = [] if stamped == base else [f"a {base} has no frame: transform a {stamped}"]
    if all(_ros_name(message_class) != (package, stamped) for message_class in registered):
        advice.append(f"add `import {module}`, which registers the conversions of {package}")
    return ", and ".join(advice)


def _find_function(table: dict[Any, Callable[..., Any]], key: Any) -> Callable[..., Any] | None:
    return table.get(key) or table.get(_find_twin_key(table, key))


def _not_loaded(key: Any) -> TypeException:
    return TypeException(f"Type {key if isinstance(key, str) else str(key)} is not loaded or supported")


def _unregistered(kind: Any, registered: Collection[Any]) -> TypeException:
    error = _not_loaded(kind)
    if hint := _how_to_transform(kind, registered):
        add_note(error, hint)
    return error


def _find_twin_key(table: dict[Any, Callable[..., Any]], key: Any) -> Any:
    """Return the table's message class of the same ROS name, because a real ROS install has other classes."""
    name = _ros_name(key)
    return next(
        (message_class for message_class in table if name is not None and _ros_name(message_class) == name),
        None,
    )


def _ros_name(kind: Any) -> Any:
    if isinstance(kind, tuple):
        names = tuple(_ros_name(message_class) for message_class in kind)
        return None if None in names else names
    package, dot_msg, _ = f"{getattr(kind, '__module__', '')}.".partition(".msg.")
    return (package.rpartition(".")[2], kind.__name__) if dot_msg else None
