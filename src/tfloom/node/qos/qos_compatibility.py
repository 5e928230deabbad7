"""Compatibility of a publisher and a subscription by their profiles, without the defaults of a wire."""

from __future__ import annotations

from typing import NamedTuple

from tfloom.rmw.qos import (
    BEST_AVAILABLE_NS,
    DurabilityPolicy,
    LivelinessPolicy,
    QoS,
    QoSPolicyEnum,
    ReliabilityPolicy,
)

__all__ = ["find_errors", "find_warnings"]

_UNDETERMINED = {"SYSTEM_DEFAULT", "UNKNOWN"}
"""Names of the policies that leave the choice to the wire."""


class _Choice(NamedTuple):
    """A policy with a weak and a strict value: a weak publisher and a strict subscription don't connect."""

    field: str
    weak: QoSPolicyEnum
    strict: QoSPolicyEnum
    incompatible: str
    both_undetermined: str
    publisher_undetermined: str
    """Text if the publisher's value is undetermined, and the subscription's strict."""
    subscription_undetermined: str
    """Text if the subscription's value is undetermined, and the publisher's weak."""

    def error(self, publisher: QoS, subscription: QoS) -> str | None:
        """Return the reason why the two can't connect, or None."""
        offered, requested = getattr(publisher, self.field), getattr(subscription, self.field)
        return self.incompatible if (offered, requested) == (self.weak, self.strict) else None

    def warning(self, publisher: QoS, subscription: QoS) -> str | None:
        """Return the reason why it is undetermined whether the two connect, or None."""
        offered, requested = getattr(publisher, self.field), getattr(subscription, self.field)
        text = None
        if offered.name in _UNDETERMINED and requested.name in _UNDETERMINED:
            text = self.both_undetermined
        elif offered.name in _UNDETERMINED and requested == self.strict:
            text = self.publisher_undetermined
        elif offered == self.weak and requested.name in _UNDETERMINED:
            text = self.subscription_undetermined
        return text and text.format(offered=offered.short_key, requested=requested.short_key)


_RELIABILITY = _Choice(
    "reliability",
    ReliabilityPolicy.BEST_EFFORT,
    ReliabilityPolicy.RELIABLE,
    "Best effort publisher and reliable subscription",
    "Publisher reliability is {offered} and subscription reliability is {requested}",
    "Reliable subscription, but publisher is {offered}",
    "Best effort publisher, but subscription is {requested}",
)
_DURABILITY = _Choice(
    "durability",
    DurabilityPolicy.VOLATILE,
    DurabilityPolicy.TRANSIENT_LOCAL,
    "Volatile publisher and transient local subscription",
    "Publisher durabilty is {offered} and subscription durability is {requested}",  # the reference's spelling
    "Transient local subscription, but publisher is {offered}",
    "Volatile publisher, but subscription is {requested}",
)
_LIVELINESS = _Choice(
    "liveliness",
    LivelinessPolicy.AUTOMATIC,
    LivelinessPolicy.MANUAL_BY_TOPIC,
    "Publisher's liveliness is automatic and subscription's is manual by topic",
    "Publisher liveliness is {offered} and subscription liveliness is {requested}",
    "Subscription's liveliness is manual by topic, but publisher's is {offered}",
    "Publisher's liveliness is automatic, but subscription's is {requested}",
)


def find_errors(publisher: QoS, subscription: QoS) -> list[str]:
    """Return the reasons why a publisher and a subscription can't connect.

    Args:
        publisher: The publisher's profile; a duration of 0 means none.
        subscription: The subscription's profile.
    """
    errors = [
        _RELIABILITY.error(publisher, subscription),
        _DURABILITY.error(publisher, subscription),
        _duration_error(
            publisher.deadline_ns,
            subscription.deadline_ns,
            "Subscription has a deadline, but publisher does not",
            "Subscription deadline is less than publisher deadline",
        ),
        _LIVELINESS.error(publisher, subscription),
        _duration_error(
            publisher.liveliness_lease_ns,
            subscription.liveliness_lease_ns,
            "Subscription has a liveliness lease duration, but publisher does not",
            "Subscription liveliness lease duration is less than publisher",
        ),
    ]
    return [error for error in errors if error is not None]


def find_warnings(publisher: QoS, subscription: QoS) -> list[str]:
    """Return the reasons why it is undetermined whether the two connect; arguments as of `find_errors`."""
    warnings = [
        choice.warning(publisher, subscription) for choice in (_RELIABILITY, _DURABILITY, _LIVELINESS)
    ]
    return [warning for warning in warnings if warning is not None]


def _duration_error(offered_ns: int, requested_ns: int, none_offered: str, too_long: str) -> str | None:
    if requested_ns == 0 or BEST_AVAILABLE_NS in {offered_ns, requested_ns}:
        return None
    if offered_ns == 0:
        return none_offered
    return too_long if requested_ns < offered_ns else None
