"""Checks of stamps: zero, ahead of now, by a clock that differs, too old."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from statistics import median

from tfloom.tf2_tools.diagnosis.catalogue import MIN_COUNT, Limits
from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding
from tfloom.tf2_tools.diagnosis.subject import (
    Subject,
    by_publisher,
    evidence_of,
    for_each_publisher,
    source_of,
)
from tfloom.tf2_tools.watch.model import Edge, stored_name

OTHER_TIME_S = 3600.0
"""If all stamps are further from now than this, they are of another time, as a simulation's: compare publishers."""
CONSTANT_PART = 0.2
"""An offset is constant if it varies by less than this part of it."""
MIN_JUMP_NS = 1_000_000_000
"""A smaller step back of the stamps is not a jump in time."""


def check_stamps(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on stamps."""
    offset_s = common_offset_s(subject)
    yield from for_each_publisher(
        "TF401", "sends moving frames with the stamp zero: {}", _zero_stamps(subject)
    )
    yield from for_each_publisher(
        "TF402", "stamps ahead of now: {}", _future_stamps(subject, limits, offset_s)
    )
    yield from _skewed_clocks(subject, limits, offset_s)
    yield from for_each_publisher("TF407", "sends transforms that are too old: {}", _old_transforms(subject))
    yield from for_each_publisher("TF408", "stamps went back in time: {}", _time_jumps(subject))


def common_offset_s(subject: Subject) -> float:
    """Return the time from the stamps to now, of most publishers, if it is long; else 0 [s]."""
    if subject.is_simulated:
        return 0.0
    # In a recording that was made from a simulation, all stamps are far from the times of receipt. The median over
    # edges is not moved by one publisher with a wrong clock, which is what `_skewed_clocks` looks for.
    means = [edge.statistics.delay.mean for edge in subject.moving if edge.statistics.delay.count]
    middle_s = median(means) if means else 0.0
    return middle_s if abs(middle_s) > OTHER_TIME_S else 0.0


def _zero_stamps(subject: Subject) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.moving:
        zero, count = edge.statistics.zero_stamps, edge.statistics.count
        if zero:
            yield edge, evidence_of(edge, f"{zero} of {count} transforms", zero_stamps=zero, count=count)


def _future_stamps(subject: Subject, limits: Limits, offset_s: float) -> Iterator[tuple[Edge, Evidence]]:
    if offset_s:
        return  # now is not of the stamps' time
    for edge in subject.moving:
        delay = edge.statistics.delay
        if delay.count and -delay.least > limits.max_ahead_s:
            text = f"by {-delay.least:.3f} s at most, {edge.statistics.ahead} of {edge.statistics.count} transforms"
            yield edge, evidence_of(edge, text, ahead_s=-delay.least, count=edge.statistics.count)


def _skewed_clocks(subject: Subject, limits: Limits, offset_s: float) -> Iterator[Finding]:
    for source, edges in by_publisher(subject.moving):
        stamped = [edge for edge in edges if edge.statistics.delay.count]
        count = sum(edge.statistics.delay.count for edge in stamped)
        if count < MIN_COUNT:
            continue
        # A wrong clock shifts all stamps by the same time; load or a slow network spreads them. So the offset must be
        # large, and the range of delays small beside it.
        mean_s = sum(e.statistics.delay.mean * e.statistics.delay.count for e in stamped) / count - offset_s
        width_s = max(e.statistics.delay.greatest for e in stamped) - min(
            e.statistics.delay.least for e in stamped
        )
        if abs(mean_s) <= limits.max_skew_s or width_s > CONSTANT_PART * abs(mean_s):
            continue
        whose = "those of the others" if offset_s else "now"
        side = "behind" if mean_s > 0 else "ahead of"
        figures = {"offset_s": -mean_s, "count": count}
        evidence = [Evidence(f"{count} stamps vary by {width_s:.3f} s{_clock_note(stamped[0])}", {**figures})]
        frames = sorted({edge.child for edge in stamped})
        yield Finding(
            "TF403",
            f"{source}: all stamps are {abs(mean_s):.3f} s {side} {whose}",
            [source],
            frames,
            evidence,
        )


def _clock_note(edge: Edge) -> str:
    """Return whether a publisher's host has another time, by the time of writing that DDS sends along."""
    traffic = edge.publisher.traffic
    if traffic is None or not traffic.transit.count:
        return ""
    # DDS stamps each message when it is written, by the clock of the sender's host. If that time fits ours, the host's
    # clock is right, and the node itself writes other stamps into its transforms.
    transit_s, delay_s = traffic.transit.mean, edge.statistics.delay.mean
    if abs(transit_s) < CONSTANT_PART * abs(delay_s):
        return (
            f"; its host's clock is right (messages take {1e3 * transit_s:.1f} ms): the node stamps them so"
        )
    return f"; its host's clock differs by {-transit_s:.3f} s"


def _time_jumps(subject: Subject) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.moving:
        if (back_ns := _jump_ns(subject, edge)) > 0:
            statistics = edge.statistics
            rejected, count = statistics.too_old, statistics.count
            text = f"by {back_ns / 1e9:.3f} s at most, {rejected} of {count} transforms are rejected as old"
            figures = {"rejected": rejected, "count": count}
            yield edge, evidence_of(edge, text, back_s=back_ns / 1e9, **figures)


def _jump_ns(subject: Subject, edge: Edge) -> int:
    """Return how far an edge's stamps went back to go on from there [ns]; 0: they did not.

    They may be those of a publisher that left, as before a simulation was restarted. A single old one is not a jump.
    """
    statistics = edge.statistics
    # After a jump, each transform is older than the newest one (`out_of_order`), but only the first is older than the
    # one before it (`steps_back`). A single old transform in between raises both by one.
    if statistics.largest_step_back_ns > MIN_JUMP_NS and statistics.out_of_order > statistics.steps_back + 1:
        return statistics.largest_step_back_ns
    if not statistics.too_old:
        return 0
    # The publisher's own stamps advance, but buffers reject them: the newer ones may be of a publisher that has left.
    former = [e.statistics for e in subject.edges_of[stored_name(edge.child)] if e.publisher.has_left]
    back_ns = max(
        (former_statistics.newest_stamp_ns - statistics.oldest_stamp_ns for former_statistics in former),
        default=0,
    )
    return back_ns if back_ns > MIN_JUMP_NS else 0


def _old_transforms(subject: Subject) -> Iterable[tuple[Edge, Evidence]]:
    for edge in subject.moving:
        statistics = edge.statistics
        if statistics.too_old and not _jump_ns(subject, edge):
            newest = max(
                subject.edges_of[stored_name(edge.child)], key=lambda other: other.statistics.newest_stamp_ns
            )
            age_s = (newest.statistics.newest_stamp_ns - statistics.oldest_stamp_ns) / 1e9
            whose = (
                "" if newest.publisher is edge.publisher else f", which is from {source_of(newest.publisher)}"
            )
            rejected, count = statistics.too_old, statistics.count
            text = f"{rejected} of {count} transforms, up to {age_s:.1f} s older than the newest{whose}"
            yield edge, evidence_of(edge, text, rejected=rejected, count=count, age_s=age_s)
