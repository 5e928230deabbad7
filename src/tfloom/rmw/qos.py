"""The table of policies and named profiles, and the quality of service that a wire takes.

`tfloom.node.qos.qos` also has rclpy's `QoSProfile`, because that one is mutable, checks assigned values and holds
`Duration` objects; `tfloom.cli.shared.qos` makes the flags of the command line from this table, without loading a node.
"""

from __future__ import annotations

from enum import EnumMeta, IntEnum
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from typing_extensions import Self

INFINITE_NS = 0x7FFF_FFFF_FFFF_FFFF
"""The infinite duration [ns]: no deadline, no lifespan, no lease."""

BEST_AVAILABLE_NS = INFINITE_NS - 1
"""The duration [ns] that requests the best one compatible with the topic's other endpoints."""


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


class _PolicyType(EnumMeta):
    """The type of the policies' classes: gives their choices by the deprecated names of C, too.

    `HistoryPolicy.RMW_QOS_POLICY_HISTORY_KEEP_LAST` is `HistoryPolicy.KEEP_LAST`, with a warning.
    """

    if not TYPE_CHECKING:  # a type checker would accept any name

        def __getattr__(cls, name: str) -> Any:
            prefix = f"RMW_QOS_POLICY_{cls.__name__.removesuffix('Policy').upper()}_"
            choices = cls.__dict__.get("_member_map_", {})
            if name in choices:  # Python 3.10 and 3.11 find the choices here
                return choices[name]
            choice = name.removeprefix(prefix)
            if choice == name or choice not in choices:
                raise AttributeError(f"type object {cls.__name__!r} has no attribute {name!r}")
            import warnings

            warnings.warn(
                f"{cls.__name__}.{name} is deprecated. Use {cls.__name__}.{choice} instead.", stacklevel=2
            )
            return choices[choice]


class QoSPolicyEnum(IntEnum, metaclass=_PolicyType):
    """A policy's choices, with the short names that command lines and parameters use."""

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the short names of all choices."""
        return [policy.short_key for policy in cls]

    @classmethod
    def get_from_short_key(cls, name: str) -> Self:
        """Return the policy of a short name.

        Raises:
            KeyError: no policy has that short name.
        """
        return cls[name.upper()]

    @property
    def short_key(self) -> str:
        """The name in lower case, e.g. `keep_last`."""
        return self.name.lower()


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether a writer resends samples that a reader missed."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    """Whether a late reader receives samples that were written before."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class HistoryPolicy(QoSPolicyEnum):
    """Whether an endpoint keeps all samples or the last `depth`."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class LivelinessPolicy(QoSPolicyEnum):
    """What asserts that a writer is alive: the wire, or the writer itself."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


class QoS(NamedTuple):
    """The quality that a writer offers or a reader requests. Durations in nanoseconds; `INFINITE_NS`: no limit."""

    reliability: ReliabilityPolicy = ReliabilityPolicy.RELIABLE
    durability: DurabilityPolicy = DurabilityPolicy.VOLATILE
    history: HistoryPolicy = HistoryPolicy.KEEP_LAST
    depth: int = 10
    deadline_ns: int = INFINITE_NS
    lifespan_ns: int = INFINITE_NS
    liveliness: LivelinessPolicy = LivelinessPolicy.AUTOMATIC
    liveliness_lease_ns: int = INFINITE_NS

    def resolved(self, default_depth: int = 1) -> QoS:
        """Return this with each system default replaced by ROS's: reliable, volatile, keep the last, automatic.

        A duration of 0 becomes `INFINITE_NS`, as in ROS.

        Args:
            default_depth: What a depth of 0 becomes: 1 on DDS. With 0, the wire chooses.
        """
        return QoS(
            reliability=self.reliability or ReliabilityPolicy.RELIABLE,
            durability=self.durability or DurabilityPolicy.VOLATILE,
            history=self.history or HistoryPolicy.KEEP_LAST,
            depth=self.depth if self.depth > 0 else default_depth,
            deadline_ns=_limited(self.deadline_ns),
            lifespan_ns=_limited(self.lifespan_ns),
            liveliness=self.liveliness or LivelinessPolicy.AUTOMATIC,
            liveliness_lease_ns=_limited(self.liveliness_lease_ns),
        )


def _limited(duration_ns: int) -> int:
    return duration_ns if 0 < duration_ns < INFINITE_NS else INFINITE_NS


POLICIES: dict[str, type[QoSPolicyEnum]] = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}
"""The policies with named choices, by the name of their field."""

_UNSET = QoS(deadline_ns=0, lifespan_ns=0, liveliness=LivelinessPolicy.SYSTEM_DEFAULT, liveliness_lease_ns=0)

ROSOUT_DEFAULT = _UNSET._replace(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan_ns=10_000_000_000
)
PROFILES = {
    "unknown": _UNSET._replace(
        history=HistoryPolicy.UNKNOWN,
        depth=0,
        reliability=ReliabilityPolicy.UNKNOWN,
        durability=DurabilityPolicy.UNKNOWN,
        liveliness=LivelinessPolicy.UNKNOWN,
    ),
    "default": _UNSET._replace(depth=10),
    "system_default": _UNSET._replace(
        history=HistoryPolicy.SYSTEM_DEFAULT,
        depth=0,
        reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
        durability=DurabilityPolicy.SYSTEM_DEFAULT,
    ),
    "sensor_data": _UNSET._replace(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT),
    "services_default": _UNSET._replace(depth=10),
    "parameters": _UNSET._replace(depth=1000),
    "parameter_events": _UNSET._replace(depth=1000),
    "action_status_default": _UNSET._replace(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
    "best_available": _UNSET._replace(
        depth=10,
        reliability=ReliabilityPolicy.BEST_AVAILABLE,
        durability=DurabilityPolicy.BEST_AVAILABLE,
        deadline_ns=BEST_AVAILABLE_NS,
        liveliness=LivelinessPolicy.BEST_AVAILABLE,
        liveliness_lease_ns=BEST_AVAILABLE_NS,
    ),
}
"""The named profiles by short name, unresolved; see `QoS.resolved`."""


def unknown_policies(qos: QoS) -> list[str]:
    """Return the type names of the policies that are UNKNOWN, which can't be requested."""
    policies = (qos.history, qos.reliability, qos.durability, qos.liveliness)
    return [type(policy).__name__ for policy in policies if policy.name == "UNKNOWN"]
