"""A QoS profile as rosbag2_py has it, and its conversions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.bag.qos_profiles import parse_profiles
from tfloom.node.qos.qos import QoSProfile
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, ReliabilityPolicy
from tfloom.rmw.qos import QoS as WireQoS

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["QoS", "convert_rclcpp_qos_to_rclpy_qos", "to_rclcpp_qos_vector", "wire_profile"]


class QoS:
    """A profile that its methods change; each returns the profile."""

    def __init__(self, depth: int) -> None:
        self._wire = WireQoS(depth=depth)

    @property
    def wire(self) -> WireQoS:
        """The profile for a wire."""
        return self._wire

    @classmethod
    def from_wire(cls, qos: WireQoS) -> Self:
        """Return a profile with a wire's values."""
        profile = cls(qos.depth)
        profile._wire = qos
        return profile

    def keep_last(self, depth: int) -> QoS:
        """Keep the last `depth` messages."""
        return self._with(self._wire._replace(history=HistoryPolicy.KEEP_LAST, depth=depth))

    def keep_all(self) -> QoS:
        """Keep all messages."""
        return self._with(self._wire._replace(history=HistoryPolicy.KEEP_ALL))

    def reliable(self) -> QoS:
        """Send again what was missed."""
        return self._with(self._wire._replace(reliability=ReliabilityPolicy.RELIABLE))

    def best_effort(self) -> QoS:
        """Send each message once."""
        return self._with(self._wire._replace(reliability=ReliabilityPolicy.BEST_EFFORT))

    def durability_volatile(self) -> QoS:
        """Send to those only that have subscribed."""
        return self._with(self._wire._replace(durability=DurabilityPolicy.VOLATILE))

    def transient_local(self) -> QoS:
        """Send kept messages to late subscriptions."""
        return self._with(self._wire._replace(durability=DurabilityPolicy.TRANSIENT_LOCAL))

    def history(self, policy: HistoryPolicy) -> QoS:
        """Set the history."""
        return self._with(self._wire._replace(history=HistoryPolicy(policy)))

    def reliability(self, policy: ReliabilityPolicy) -> QoS:
        """Set the reliability."""
        return self._with(self._wire._replace(reliability=ReliabilityPolicy(policy)))

    def durability(self, policy: DurabilityPolicy) -> QoS:
        """Set the durability."""
        return self._with(self._wire._replace(durability=DurabilityPolicy(policy)))

    def liveliness(self, policy: LivelinessPolicy) -> QoS:
        """Set the liveliness."""
        return self._with(self._wire._replace(liveliness=LivelinessPolicy(policy)))

    def __eq__(self, other: object) -> bool:
        return self._wire == other._wire if isinstance(other, QoS) else NotImplemented

    __hash__ = None  # type: ignore[assignment]  # it can be changed

    def __repr__(self) -> str:
        return f"QoS({self._wire})"

    def _with(self, wire: WireQoS) -> QoS:
        self._wire = wire
        return self


def convert_rclcpp_qos_to_rclpy_qos(arg0: QoS) -> QoSProfile:
    """Return rclpy's profile with the same values."""
    return QoSProfile.from_wire(arg0.wire)


def to_rclcpp_qos_vector(arg0: str, arg1: int) -> list[QoS]:  # each version's form is recognised
    """Return the profiles in the YAML text of a bag; the second argument is the version of its metadata."""
    return [QoS.from_wire(profile) for profile in parse_profiles(arg0)]


def wire_profile(qos: QoS | QoSProfile) -> WireQoS:
    """Return a profile of either class for a wire."""
    return qos.wire if isinstance(qos, QoS) else qos.as_stated()
