"""The events of publishers and subscriptions, by rclpy's names and numbers."""

from __future__ import annotations

from enum import IntEnum

from tfloom.rmw.errors import UnsupportedEventError
from tfloom.rmw.events import Event

__all__ = ["QoSPublisherEventType", "QoSSubscriptionEventType", "wire_event"]


class QoSPublisherEventType(IntEnum):
    """Events of a publisher."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    """Events of a subscription."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


class rmw_qos_policy_kind_t(IntEnum):  # noqa: N801  # rclpy's name, which programs print
    """The policies, as the status of an incompatible peer names them. Each equals that of `QoSPolicyKind`."""

    RMW_QOS_POLICY_INVALID = 1 << 0
    RMW_QOS_POLICY_DURABILITY = 1 << 1
    RMW_QOS_POLICY_DEADLINE = 1 << 2
    RMW_QOS_POLICY_LIVELINESS = 1 << 3
    RMW_QOS_POLICY_RELIABILITY = 1 << 4
    RMW_QOS_POLICY_HISTORY = 1 << 5
    RMW_QOS_POLICY_LIFESPAN = 1 << 6
    RMW_QOS_POLICY_DEPTH = 1 << 7
    RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION = 1 << 8
    RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS = 1 << 9

    def __str__(self) -> str:
        return f"{type(self).__name__}.{self.name}"


# Two tables, because members of the two enumerations are equal where their numbers are.
_PUBLISHER_EVENTS = {
    QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: Event.DEADLINE_MISSED,
    QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST: Event.LIVELINESS_LOST,
    QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: Event.INCOMPATIBLE_QOS,
    QoSPublisherEventType.RCL_PUBLISHER_MATCHED: Event.MATCHED,
}
_SUBSCRIPTION_EVENTS = {
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: Event.DEADLINE_MISSED,
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: Event.LIVELINESS_CHANGED,
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: Event.INCOMPATIBLE_QOS,
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST: Event.MESSAGE_LOST,
    QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED: Event.MATCHED,
}


def wire_event(event_type: QoSPublisherEventType | QoSSubscriptionEventType) -> Event:
    """Return the wire's event of a type.

    Raises:
        UnsupportedEventError: no wire reports it.
        TypeError: `event_type` is of neither enumeration.
    """
    if isinstance(event_type, QoSPublisherEventType):
        event = _PUBLISHER_EVENTS.get(event_type)
    elif isinstance(event_type, QoSSubscriptionEventType):
        event = _SUBSCRIPTION_EVENTS.get(event_type)
    else:
        raise TypeError(
            f"event_type must be a QoSPublisherEventType or QoSSubscriptionEventType, not {event_type!r}"
        )
    if event is None:
        # of the two INCOMPATIBLE_TYPE: neither table has them
        raise UnsupportedEventError(f"{event_type.name}: no wire here reports peers of another type")
    return event
