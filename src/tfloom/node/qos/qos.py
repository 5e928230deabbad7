"""Quality of service as programs state it; `to_wire` gives what a backend takes."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import TYPE_CHECKING, Any

from tfloom.node.values.constants import INT64_MAX
from tfloom.node.values.duration import Duration
from tfloom.rmw import qos as wire

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

__all__ = [
    "DurabilityPolicy",
    "HistoryPolicy",
    "InvalidQoSProfileException",
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


class QoSPolicyKind(IntEnum):
    """The policies, as events and overriding options name them."""

    INVALID = 1 << 0
    DURABILITY = 1 << 1
    DEADLINE = 1 << 2
    LIVELINESS = 1 << 3
    RELIABILITY = 1 << 4
    HISTORY = 1 << 5
    LIFESPAN = 1 << 6
    DEPTH = 1 << 7
    LIVELINESS_LEASE_DURATION = 1 << 8
    AVOID_ROS_NAMESPACE_CONVENTIONS = 1 << 9


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return a policy's name, e.g. `DURABILITY`, from its number."""
    return QoSPolicyKind(policy_kind).name


class InvalidQoSProfileException(Exception):  # noqa: N818  # ROS's name
    """A profile whose settings don't go together."""

    def __init__(self, *args: object) -> None:
        super().__init__("Invalid QoSProfile", *args)


class QoSPolicyEnum(IntEnum):
    """A policy's choices, with the short names that command lines and parameters use."""

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the short names of all choices."""
        return [policy.short_key for policy in cls]

    @classmethod
    def get_from_short_key(cls, name: str) -> Self:
        """Return the policy of a short name.

        Raises:
            KeyError: there is none of that name.
        """
        return cls[name.upper()]

    @property
    def short_key(self) -> str:
        """The name in lower case, e.g. `keep_last`."""
        return self.name.lower()


class HistoryPolicy(QoSPolicyEnum):
    """Whether to keep all samples or the last `depth`."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether to send again what was lost."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    """Whether a late subscription gets what was published before."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    """Whether the wire asserts that a publisher is alive, or the publisher itself."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

BEST_AVAILABLE_DURATION = Duration(nanoseconds=INT64_MAX - 1)
"""Deadline or lease that follows the other side's."""


def _number(value: Any, name: str) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise TypeError(f"{name} must be an int, not {type(value).__name__}")
    if value < 0:
        raise ValueError(f"{name} must be greater than or equal to zero")
    return value


def _duration(value: Any, name: str) -> Duration:
    if not isinstance(value, Duration):
        raise TypeError(f"{name} must be a Duration, not {type(value).__name__}")
    return value


def _flag(value: Any, name: str) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{name} must be a bool, not {type(value).__name__}")
    return value


def _policy(kind: Callable[[Any], Any]) -> Callable[[Any, str], Any]:
    def convert(value: Any, name: str) -> Any:
        try:
            return kind(value)
        except ValueError:
            raise ValueError(f"{name} has no policy {value!r}") from None

    return convert


_FIELDS: dict[str, tuple[Any, Callable[[Any, str], Any]]] = {
    "history": (HistoryPolicy.KEEP_LAST, _policy(HistoryPolicy)),
    "depth": (10, _number),
    "reliability": (ReliabilityPolicy.RELIABLE, _policy(ReliabilityPolicy)),
    "durability": (DurabilityPolicy.VOLATILE, _policy(DurabilityPolicy)),
    "lifespan": (Duration(), _duration),
    "deadline": (Duration(), _duration),
    "liveliness": (LivelinessPolicy.SYSTEM_DEFAULT, _policy(LivelinessPolicy)),
    "liveliness_lease_duration": (Duration(), _duration),
    "avoid_ros_namespace_conventions": (False, _flag),
}


class QoSProfile:
    """The quality of service that a publisher offers, or a subscription requests.

    A duration of 0 means none; a policy of SYSTEM_DEFAULT leaves the choice to the wire.

    Args:
        history: KEEP_LAST keeps `depth` samples; KEEP_ALL has no such limit. Default: KEEP_LAST, given a `depth`.
        depth: How many samples are kept.
        reliability: Default RELIABLE.
        durability: Default VOLATILE.
        lifespan: After this time a sample is no longer delivered.
        deadline: The longest time expected between two samples.
        liveliness: Default SYSTEM_DEFAULT.
        liveliness_lease_duration: After this time without a sign of life a publisher counts as dead.
        avoid_ros_namespace_conventions: Use the topic's name on the wire as it stands.

    Raises:
        InvalidQoSProfileException: neither `history` nor `depth` is given, or KEEP_LAST without `depth`.
        TypeError: an argument is unknown or of the wrong type.
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
        unknown = kwargs.keys() - _FIELDS.keys()
        if unknown:
            raise TypeError(f"Invalid arguments passed to constructor: {', '.join(sorted(unknown))}")
        if "history" not in kwargs and "depth" not in kwargs:
            raise InvalidQoSProfileException("History and/or depth settings are required.")
        for name, (default, _) in _FIELDS.items():
            setattr(self, name, kwargs.get(name, default))
        if self.history == HistoryPolicy.KEEP_LAST and "depth" not in kwargs:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")

    def get_c_qos_profile(self) -> QoSProfile:
        """Return this object, in the place of rclpy's C profile."""
        return self

    def to_wire(self) -> wire.QoS:
        """Return the profile as a backend takes it, with the wire's choice for each SYSTEM_DEFAULT.

        Raises:
            InvalidQoSProfileException: a policy is UNKNOWN.
        """
        for policy in (self.history, self.reliability, self.durability, self.liveliness):
            if policy.name == "UNKNOWN":
                raise InvalidQoSProfileException(f"{type(policy).__name__} is UNKNOWN")
        return wire.QoS(
            reliability=wire.ReliabilityPolicy(self.reliability or ReliabilityPolicy.RELIABLE),
            durability=wire.DurabilityPolicy(self.durability or DurabilityPolicy.VOLATILE),
            history=wire.HistoryPolicy(self.history or HistoryPolicy.KEEP_LAST),
            depth=self.depth or 1,
            deadline_ns=self.deadline.nanoseconds or wire.INFINITE_NS,
            lifespan_ns=self.lifespan.nanoseconds or wire.INFINITE_NS,
            liveliness=wire.LivelinessPolicy(self.liveliness or LivelinessPolicy.AUTOMATIC),
            liveliness_lease_ns=self.liveliness_lease_duration.nanoseconds or wire.INFINITE_NS,
        )

    @classmethod
    def from_wire(cls, qos: wire.QoS) -> QoSProfile:
        """Return the profile of an endpoint on the graph; an endless duration is `Infinite`."""
        return cls(
            history=HistoryPolicy(qos.history),
            depth=qos.depth,
            reliability=ReliabilityPolicy(qos.reliability),
            durability=DurabilityPolicy(qos.durability),
            lifespan=Duration(nanoseconds=qos.lifespan_ns),
            deadline=Duration(nanoseconds=qos.deadline_ns),
            liveliness=LivelinessPolicy(qos.liveliness),
            liveliness_lease_duration=Duration(nanoseconds=qos.liveliness_lease_ns),
        )

    @staticmethod
    def field_names() -> list[str]:
        """Return the names of all settings."""
        return list(_FIELDS)

    def history_text(self) -> str:
        """Return history and depth as the tools print them: `KEEP_LAST (10)`."""
        if self.history is HistoryPolicy.KEEP_LAST:
            return f"{self.history.name} ({self.depth})"
        return self.history.name

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in _FIELDS)

    __hash__ = None  # type: ignore[assignment]  # it can be changed

    def __repr__(self) -> str:
        return f"QoSProfile({', '.join(f'{name}={getattr(self, name)!s}' for name in _FIELDS)})"


def _field(name: str, convert: Callable[[Any, str], Any]) -> property:
    slot = f"_{name}"

    def get(self: QoSProfile) -> Any:
        return getattr(self, slot)

    def set_(self: QoSProfile, value: Any) -> None:
        setattr(self, slot, convert(value, name))

    return property(get, set_)


for _name, (_, _convert) in _FIELDS.items():
    setattr(QoSProfile, _name, _field(_name, _convert))

qos_profile_unknown = QoSProfile(
    history=HistoryPolicy.UNKNOWN,
    depth=0,
    reliability=ReliabilityPolicy.UNKNOWN,
    durability=DurabilityPolicy.UNKNOWN,
    liveliness=LivelinessPolicy.UNKNOWN,
)
qos_profile_default = QoSProfile(depth=10)
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    depth=0,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
qos_profile_rosout_default = QoSProfile(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)
)
qos_profile_best_available = QoSProfile(
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    deadline=BEST_AVAILABLE_DURATION,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_duration=BEST_AVAILABLE_DURATION,
)


def qos_check_compatible(
    publisher_qos: QoSProfile, subscription_qos: QoSProfile
) -> tuple[QoSCompatibility, str]:
    """Return whether a publisher and a subscription of these profiles connect, and why not."""
    from tfloom.rmw.compatibility import incompatible_policies

    apart = incompatible_policies(publisher_qos.to_wire(), subscription_qos.to_wire())
    if not apart:
        return QoSCompatibility.OK, ""
    reasons = "".join(
        f"ERROR: {kind.name.lower()} of the publisher is less than the subscription asks for;"
        for kind in apart
    )
    return QoSCompatibility.ERROR, reasons


class QoSCompatibility(IntEnum):
    """Whether two profiles go together."""

    OK = 0
    WARNING = 1
    ERROR = 2


class QoSPresetProfiles(Enum):
    """The named profiles."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available

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
