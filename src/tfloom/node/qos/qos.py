"""Quality of service in rclpy's classes; `QoSProfile.to_wire` converts a profile for a backend."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import TYPE_CHECKING, Any

from tfloom.common.seconds import duration_error
from tfloom.node.values.duration import Duration
from tfloom.rmw import qos as wire
from tfloom.rmw.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyEnum,
    QoSPolicyKind,
    ReliabilityPolicy,
)
from tfloom.ros_imports.guard import ros_home

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

__all__ = [
    "DeadlineBestAvailable",
    "DurabilityPolicy",
    "HistoryPolicy",
    "InvalidQoSProfileException",
    "LivelinessLeaseDurationeBestAvailable",
    "LivelinessPolicy",
    "QoSCompatibility",
    "QoSDurabilityPolicy",
    "QoSHistoryPolicy",
    "QoSLivelinessPolicy",
    "QoSPolicyEnum",
    "QoSPolicyKind",
    "QoSPresetProfiles",
    "QoSProfile",
    "QoSReliabilityPolicy",
    "ReliabilityPolicy",
    "qos_check_compatible",
    "qos_policy_name_from_kind",
    "qos_profile_action_status_default",
    "qos_profile_best_available",
    "qos_profile_default",
    "qos_profile_parameter_events",
    "qos_profile_parameters",
    "qos_profile_rosout_default",
    "qos_profile_sensor_data",
    "qos_profile_services_default",
    "qos_profile_system_default",
    "qos_profile_unknown",
]


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return a policy's name, e.g. `DURABILITY`, from its number."""
    return QoSPolicyKind(policy_kind).name


class InvalidQoSProfileException(Exception):
    """A profile with contradictory or missing settings."""

    __module__ = ros_home("rclpy.qos", __name__)

    def __init__(self, *args: object) -> None:
        super().__init__("Invalid QoSProfile", *args)


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

BEST_AVAILABLE_DURATION = Duration(nanoseconds=wire.BEST_AVAILABLE_NS)
"""A deadline or lease that is chosen to be compatible with the topic's other endpoints."""
DeadlineBestAvailable = BEST_AVAILABLE_DURATION
LivelinessLeaseDurationeBestAvailable = BEST_AVAILABLE_DURATION  # rclpy's spelling


def _checked_number(value: Any, name: str) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise TypeError(f"{name} must be an int, as 10, got {value!r} of class {type(value).__name__}")
    if value < 0:
        raise ValueError(f"{name} must be greater than or equal to zero")
    return value


def _checked_duration(value: Any, name: str) -> Duration:
    if not isinstance(value, Duration):
        raise duration_error(f"{name} must be a Duration", value)
    return value


def _checked_flag(value: Any, name: str) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{name} must be a bool, not {type(value).__name__}")
    return value


def _policy_converter(kind: type[IntEnum]) -> Callable[[Any, str], Any]:
    def convert(value: Any, name: str) -> Any:
        try:
            return kind(value)
        except ValueError:
            known = ", ".join(policy.name for policy in kind)
            raise ValueError(
                f"{name} has no policy {value!r}: write {kind.__name__}.NAME, with a name of {known}"
            ) from None

    return convert


_FIELDS: dict[str, tuple[Any, Callable[[Any, str], Any]]] = {
    "history": (HistoryPolicy.KEEP_LAST, _policy_converter(HistoryPolicy)),
    "depth": (10, _checked_number),
    "reliability": (ReliabilityPolicy.RELIABLE, _policy_converter(ReliabilityPolicy)),
    "durability": (DurabilityPolicy.VOLATILE, _policy_converter(DurabilityPolicy)),
    "lifespan": (Duration(), _checked_duration),
    "deadline": (Duration(), _checked_duration),
    "liveliness": (LivelinessPolicy.SYSTEM_DEFAULT, _policy_converter(LivelinessPolicy)),
    "liveliness_lease_duration": (Duration(), _checked_duration),
    "avoid_ros_namespace_conventions": (False, _checked_flag),
}

_NO_DEPTH = (
    "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
    "This will be interpreted as SYSTEM_DEFAULT"
)


class QoSProfile:
    """The quality of service that a publisher offers, or a subscription requests.

    A duration of 0 means none; a policy of SYSTEM_DEFAULT leaves the choice to the wire.

    Args:
        history: KEEP_LAST keeps `depth` samples; KEEP_ALL has no such limit. Default: KEEP_LAST, given a `depth`.
        depth: How many samples are kept.
        reliability: Default RELIABLE.
        durability: Default VOLATILE.
        lifespan: Time after which a sample is no longer delivered.
        deadline: The longest expected time between two samples.
        liveliness: Default SYSTEM_DEFAULT.
        liveliness_lease_duration: Time without an assertion of liveliness after which a publisher is not alive.
        avoid_ros_namespace_conventions: Whether to use the topic's name unchanged on the wire.

    Raises:
        InvalidQoSProfileException: neither `history` nor `depth` is given, or KEEP_LAST without `depth`.
        TypeError: an argument is unknown or of the wrong type.

    Warns:
        UserWarning: KEEP_LAST with a depth of 0, which leaves the depth to the wire.
    """

    __slots__ = tuple(f"_{name}" for name in _FIELDS)

    history: HistoryPolicy
    depth: int
    reliability: ReliabilityPolicy
    durability: DurabilityPolicy
    lifespan: Duration
    deadline: Duration
    liveliness: LivelinessPolicy
    liveliness_lease_duration: Duration
    avoid_ros_namespace_conventions: bool

    def __init__(self, **kwargs: Any) -> None:
        unknown_names = kwargs.keys() - _FIELDS.keys()
        if unknown_names:
            raise TypeError(f"Invalid arguments passed to constructor: {', '.join(sorted(unknown_names))}")
        if "history" not in kwargs and "depth" not in kwargs:
            raise InvalidQoSProfileException("History and/or depth settings are required.")
        # As `_set_fields`, written here because a wrong argument's traceback is to be short.
        for name, (default, convert) in _FIELDS.items():
            setattr(self, f"_{name}", convert(kwargs.get(name, default), name))
        if "depth" in kwargs:
            self._warn_of_no_depth()
        if self.history == HistoryPolicy.KEEP_LAST and "depth" not in kwargs:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")

    def _warn_of_no_depth(self) -> None:
        """Warn of a history without samples, at the line that called the caller."""
        if self.depth == 0 and self.history == HistoryPolicy.KEEP_LAST:
            import warnings

            warnings.warn(_NO_DEPTH, stacklevel=3)

    def get_c_qos_profile(self) -> rmw_qos_profile_t:
        """Return a copy of this profile, in place of rclpy's C profile."""
        profile = rmw_qos_profile_t.__new__(rmw_qos_profile_t)
        _set_fields(profile, {name: getattr(self, name) for name in _FIELDS})
        return profile

    def to_wire(self) -> wire.QoS:
        """Return the profile for a backend, with ROS's choice for each SYSTEM_DEFAULT, and the wire's for a depth of 0.

        Raises:
            InvalidQoSProfileException: a policy is UNKNOWN.
        """
        stated = self.as_stated()
        if unknown := wire.unknown_policies(stated):
            raise InvalidQoSProfileException(f"{unknown[0]} is UNKNOWN")
        return stated.resolved(default_depth=0)

    def as_stated(self) -> wire.QoS:
        """Return the settings unchanged, durations in nanoseconds."""
        return wire.QoS(
            reliability=self.reliability,
            durability=self.durability,
            history=self.history,
            depth=self.depth,
            deadline_ns=self.deadline.nanoseconds,
            lifespan_ns=self.lifespan.nanoseconds,
            liveliness=self.liveliness,
            liveliness_lease_ns=self.liveliness_lease_duration.nanoseconds,
        )

    @classmethod
    def from_wire(cls, qos: wire.QoS) -> QoSProfile:
        """Return the profile of an endpoint on the graph; a duration without limit is `Infinite`."""
        profile = cls.__new__(
            cls
        )  # without the warning of the constructor, because some peers announce no depth
        values = {
            "history": qos.history,
            "depth": qos.depth,
            "reliability": qos.reliability,
            "durability": qos.durability,
            "lifespan": Duration(nanoseconds=qos.lifespan_ns),
            "deadline": Duration(nanoseconds=qos.deadline_ns),
            "liveliness": qos.liveliness,
            "liveliness_lease_duration": Duration(nanoseconds=qos.liveliness_lease_ns),
        }
        _set_fields(profile, values)
        return profile

    @staticmethod
    def field_names() -> list[str]:
        """Return the names of all settings."""
        return list(_FIELDS)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in _FIELDS)

    __hash__ = None  # type: ignore[assignment]  # it can be changed

    def __repr__(self) -> str:
        return f"QoSProfile({', '.join(f'{name}={getattr(self, name)!s}' for name in _FIELDS)})"


class rmw_qos_profile_t(QoSProfile):  # noqa: N801  # ROS's name
    """A profile as rclpy's compiled module has it."""

    __slots__ = ()

    def to_dict(self) -> dict[str, int | bool | Duration]:
        """Return the settings by name, as QoSProfile takes them, with the numbers of the policies."""
        settings = {name: getattr(self, name) for name in _FIELDS}
        return {name: value.value if isinstance(value, Enum) else value for name, value in settings.items()}


def _set_fields(profile: QoSProfile, values: Mapping[str, Any]) -> None:
    """Set all fields: to `values`, or to their defaults."""
    for name, (default, convert) in _FIELDS.items():
        setattr(profile, f"_{name}", convert(values.get(name, default), name))


def _field_property(name: str, convert: Callable[[Any, str], Any]) -> property:
    slot = f"_{name}"

    def get(self: QoSProfile) -> Any:
        return getattr(self, slot)

    def set_(self: QoSProfile, value: Any) -> None:
        setattr(self, slot, convert(value, name))
        if name == "depth":
            self._warn_of_no_depth()

    return property(get, set_)


for _name, (_, _convert) in _FIELDS.items():
    setattr(QoSProfile, _name, _field_property(_name, _convert))

qos_profile_unknown = QoSProfile.from_wire(wire.PROFILES["unknown"])
qos_profile_default = QoSProfile.from_wire(wire.PROFILES["default"])
qos_profile_system_default = QoSProfile.from_wire(wire.PROFILES["system_default"])
qos_profile_sensor_data = QoSProfile.from_wire(wire.PROFILES["sensor_data"])
qos_profile_services_default = QoSProfile.from_wire(wire.PROFILES["services_default"])
qos_profile_parameters = QoSProfile.from_wire(wire.PROFILES["parameters"])
qos_profile_parameter_events = QoSProfile.from_wire(wire.PROFILES["parameter_events"])
qos_profile_action_status_default = QoSProfile.from_wire(wire.PROFILES["action_status_default"])
qos_profile_rosout_default = QoSProfile.from_wire(wire.ROSOUT_DEFAULT)
qos_profile_best_available = QoSProfile.from_wire(wire.PROFILES["best_available"])


def qos_check_compatible(
    publisher_qos: QoSProfile, subscription_qos: QoSProfile
) -> tuple[QoSCompatibility, str]:
    """Return whether a publisher and a subscription of these profiles connect, and the reasons if not.

    Returns:
        OK and ""; ERROR and the reasons; or WARNING and the reasons if policies of SYSTEM_DEFAULT or UNKNOWN leave it
        undetermined. Each reason ends with a semicolon.
    """
    from tfloom.node.qos.qos_compatibility import find_errors, find_warnings

    offered, requested = publisher_qos.as_stated(), subscription_qos.as_stated()
    if errors := find_errors(offered, requested):
        return QoSCompatibility.ERROR, "".join(f"ERROR: {error};" for error in errors)
    if warnings := find_warnings(offered, requested):
        return QoSCompatibility.WARNING, "".join(f"WARNING: {warning};" for warning in warnings)
    return QoSCompatibility.OK, ""


class QoSCompatibility(IntEnum):
    """Result of a check of two profiles."""

    OK = 0
    WARNING = 1
    ERROR = 2


class QoSPresetProfiles(Enum):
    """The profiles that ROS names for common purposes."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available
    ROSOUT_DEFAULT = qos_profile_rosout_default

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the short names, e.g. `sensor_data`."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile of a short name.

        Raises:
            KeyError: there is none of that name.
        """
        profile: QoSProfile = cls[name.upper()].value
        return profile
