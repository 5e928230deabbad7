"""Sentences on a lookup outside the time that the chain covers."""

from __future__ import annotations

import math

from tfloom.tf2_tools.lookups.chain import Span
from tfloom.tf2_tools.lookups.lookup import Lookup
from tfloom.tf2_tools.text import NS_PER_S, seconds_text

__all__ = ["future", "one_sample", "past"]

STALE_PERIODS = 5.0
"""A publisher that has sent nothing for this many of its longest periods is said to have stopped."""
MIN_STALE_S = 0.5
"""And not before this time [s]."""
TIMEOUT_MARGIN = 1.2
"""The advised timeout is the longest wait seen so far, times this."""
LARGE_DELAY_S = 1.0
"""A mean delay above this points to clocks or to old data, rather than to computing [s]."""
FULL = 0.95
"""A history of this part of the buffer's length counts as full."""
SIMULATED_NS = 86_400 * 365 * 1_000_000_000
"""Stamps below this, a year after the epoch, are those of a simulation [ns]."""


def future(lookup: Lookup) -> list[str]:
    """Return why the newest transform is too old, and how long to wait."""
    span = lookup.chain.first_to_end if lookup.chain is not None else None
    if span is None:
        return []
    gap_s = (lookup.stamp_ns - span.newest_ns) / NS_PER_S
    sentences = [
        f"The newest transform of {span.name}, from {span.publishers}, is {seconds_text(gap_s)} older than that."
    ]
    ahead_s = (lookup.stamp_ns - lookup.now_ns) / NS_PER_S
    if _is_simulated(span) and lookup.now_ns > SIMULATED_NS:
        return [*sentences, "Its stamps are those of a simulation: give -s (--use-sim-time)."]
    if ahead_s > 0.0 and lookup.seen.is_live:
        sentences.append(
            f"The requested time is {seconds_text(ahead_s)} ahead of now: no transform can be there yet. "
            "Check the clock that stamps the request."
        )
        return sentences
    return sentences + _late_publisher(lookup, span)


def _is_simulated(span: Span) -> bool:
    return 0 < span.newest_ns < SIMULATED_NS


def _late_publisher(lookup: Lookup, span: Span) -> list[str]:
    """Return why the newest transform of an edge isn't newer, and how long to wait."""
    edge = span.last
    if edge is None:
        return []
    if not lookup.seen.is_live:
        return ["The recording has no later one: ask for a time before, or for the latest."]
    statistics = edge.statistics
    silent_s = (lookup.seen.taken_ns - statistics.last_received_ns) / NS_PER_S
    longest_period_s = max(statistics.receipt_period.greatest, statistics.stamp_period.greatest)
    # First the publishers that send no more, then one whose stamps are old, and last one that sends as it should.
    if edge.publisher.has_left:
        return [
            f"{edge.publisher.label} has left {seconds_text(silent_s)} after its last one: start it again."
        ]
    if silent_s > max(MIN_STALE_S, STALE_PERIODS * longest_period_s):
        before = (
            f", after one each {seconds_text(statistics.receipt_period.mean)}" if statistics.count > 1 else ""
        )
        return [
            f"{edge.publisher.label} has sent none for {seconds_text(silent_s)}{before}: check that it works."
        ]
    mean_s, worst_s = statistics.delay.mean, statistics.delay.greatest
    if mean_s > LARGE_DELAY_S:
        return [
            (
                f"Its stamps are {seconds_text(mean_s)} behind their receipt: compare the clocks of both machines, or "
                f"find out why {edge.publisher.label} sends old data. Until then, ask for the latest time."
            )
        ]
    # A request made just after a transform waits for the next one, and for that one's delay. A delay below zero, of
    # stamps ahead of now, is not a reason to wait less than a period.
    longest_wait_s = longest_period_s + max(0.0, worst_s)
    timeout_s = TIMEOUT_MARGIN * longest_wait_s
    return [
        (
            f"{edge.publisher.label} sends one each {seconds_text(statistics.stamp_period.mean)}, which arrives "
            f"{seconds_text(mean_s)} after its stamp (at most {seconds_text(worst_s)}). So a transform for now is "
            f"there after up to {seconds_text(longest_wait_s)}."
        ),
        (
            f"Give the lookup a timeout of {timeout_s:.2f} s or more, or ask for the latest time (Time()), or let a "
            "tf2_ros.MessageFilter wait."
        ),
    ]


def past(lookup: Lookup) -> list[str]:
    """Return why the oldest transform is too new, and what keeps more."""
    span = lookup.chain.last_to_begin if lookup.chain is not None else None
    other = lookup.chain.first_to_end if lookup.chain is not None else None
    if span is None or other is None:
        return []
    gap_s = (span.oldest_ns - lookup.stamp_ns) / NS_PER_S
    sentence = f"The oldest transform of {span.name}, from {span.publishers}, is {seconds_text(gap_s)} newer than that."
    if lookup.asked_ns == 0:
        ended = f"The edges have no common time, because {other.name} ended before."
        return [sentence, ended, *_late_publisher(lookup, other)]
    return [sentence, _short_history(lookup, span)]


def _short_history(lookup: Lookup, span: Span) -> str:
    """Return why there is no older transform of an edge, and what to do."""
    if not lookup.seen.is_live:
        return "The recording has no earlier one: ask for a later time."
    history_s = (span.newest_ns - span.oldest_ns) / NS_PER_S
    cache_s = math.inf if lookup.cache_time_ns is None else lookup.cache_time_ns / NS_PER_S
    if history_s >= FULL * cache_s:
        needed_s = math.ceil(1.2 * (span.newest_ns - lookup.stamp_ns) / NS_PER_S)
        return (
            f"A buffer keeps {seconds_text(cache_s)}: create it with a longer history, for example "
            f"Buffer(cache_time=Duration(seconds={needed_s})), or look up sooner."
        )
    listened_s = (lookup.seen.taken_ns - lookup.seen.started_ns) / NS_PER_S
    return (
        f"This command has listened for {seconds_text(listened_s)} only. A node that has listened for longer may have "
        "it; one that has just started must wait, or ask for the latest time."
    )


def one_sample(lookup: Lookup) -> list[str]:
    """Return which edges have a single transform."""
    spans = [
        span for span in (lookup.chain.moving if lookup.chain is not None else ()) if span.sample_count < 2
    ]
    return [
        f"There is one transform of {span.name}, from {span.publishers}, and it is valid at its own stamp only: "
        "publish it regularly, or if it never changes, on /tf_static."
        for span in spans
    ]
