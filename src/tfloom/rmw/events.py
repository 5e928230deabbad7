"""Events of writers and readers: matched and unmatched peers, missed deadlines, lost liveliness, lost samples.

A status counts from the endpoint's opening; its changes count since it was taken last.
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple, TypeAlias, Union

from tfloom.rmw.qos import QoSPolicyKind


class Event(IntEnum):
    """The events. Both writers and readers have those without a mark."""

    MATCHED = 0
    INCOMPATIBLE_QOS = 1
    DEADLINE_MISSED = 2
    LIVELINESS_LOST = 3
    """Of writers: this one did not assert its liveliness in time."""
    LIVELINESS_CHANGED = 4
    """Of readers: a writer lost its liveliness, or regained it."""
    MESSAGE_LOST = 5
    """Of readers: samples that were lost."""


class Matched(NamedTuple):
    """How many peers have ever connected, and how many are connected now."""

    total_count: int
    total_count_change: int
    current_count: int
    current_count_change: int


class IncompatibleQoS(NamedTuple):
    """How many incompatible peers there were, and a policy that kept the last one from connecting."""

    total_count: int
    total_count_change: int
    last_policy_kind: IntEnum
    """A QoSPolicyKind; of what a node gives to callbacks, one of rclpy's names and the same number."""


class LivelinessChanged(NamedTuple):
    """How many connected writers are alive, and how many aren't."""

    alive_count: int
    not_alive_count: int
    alive_count_change: int
    not_alive_count_change: int


class Count(NamedTuple):
    """How often an event has occurred: deadlines missed, liveliness lost, messages lost."""

    total_count: int
    total_count_change: int


Status: TypeAlias = Union[Matched, IncompatibleQoS, LivelinessChanged, Count]  # noqa: UP007 - evaluated on 3.10

AT_FIRST: dict[Event, Status] = {
    Event.MATCHED: Matched(0, 0, 0, 0),
    Event.INCOMPATIBLE_QOS: IncompatibleQoS(0, 0, QoSPolicyKind.INVALID),
    Event.DEADLINE_MISSED: Count(0, 0),
    Event.LIVELINESS_LOST: Count(0, 0),
    Event.LIVELINESS_CHANGED: LivelinessChanged(0, 0, 0, 0),
    Event.MESSAGE_LOST: Count(0, 0),
}
"""The status of each event before it has occurred."""
