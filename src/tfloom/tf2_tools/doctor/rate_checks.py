"""Checks of how often transforms come: the rate, its variation, and gaps."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tfloom._native import Spread
from tfloom.tf2_tools.doctor.finding import Evidence, Finding
from tfloom.tf2_tools.doctor.limits import GAP_PERIODS, MIN_COUNT, MIN_JITTER_S, Limits
from tfloom.tf2_tools.doctor.subject import Subject, evidence_of, for_each_publisher
from tfloom.tf2_tools.text.counts import counted
from tfloom.tf2_tools.watch.model import Edge


def check_rates(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on rates. An edge with a gap is not looked at for its jitter, which the gap would dominate."""
    gaps = {edge: gap for edge in subject.moving if (gap := _gap(subject, edge, limits))}
    rare = ((edge, seen) for edge in subject.moving if (seen := _rarity(subject, edge, limits)))
    varying = (
        (edge, seen) for edge in subject.moving if edge not in gaps and (seen := _jitter(edge, limits))
    )
    yield from for_each_publisher("TF404", "publishes rarely: {}", rare)
    yield from for_each_publisher("TF405", "publishes at uneven times: {}", varying)
    yield from for_each_publisher("TF406", "paused: {}", gaps.items())


def _rarity(subject: Subject, edge: Edge, limits: Limits) -> Evidence | None:
    seen = edge.statistics
    if (
        subject.is_simulated and seen.stamp_period.count > 1
    ):  # a simulation's seconds may be longer or shorter
        period_s = seen.stamp_period.mean
    elif seen.receipt_period.count > 1:
        period_s = seen.receipt_period.mean
    else:
        period_s = (subject.times_ns[1] - seen.first_received_ns) / 1e9 / seen.count
    if period_s * limits.min_rate_hz <= 1.0:
        return None
    rate_hz = 1.0 / period_s
    text = f"{rate_hz:.2f} Hz, {counted(seen.count, 'transform')} in {subject.duration_s:.1f} s"
    return evidence_of(edge, text, rate_hz=rate_hz, count=seen.count)


def _jitter(edge: Edge, limits: Limits) -> Evidence | None:
    period = _period(edge)
    if period.count < MIN_COUNT:
        return None
    mean_s, deviation_s = without_longest(period)
    if deviation_s < MIN_JITTER_S or deviation_s < limits.max_jitter * mean_s:
        return None
    text = (
        f"the period is {mean_s:.3f} s with a standard deviation of {deviation_s:.3f} s, "
        f"{period.least:.3f} s to {period.greatest:.3f} s"
    )
    return evidence_of(edge, text, period_s=mean_s, deviation_s=deviation_s, longest_s=period.greatest)


def _period(edge: Edge) -> Spread:
    """Return the periods by stamps, which the network does not change; by receipt where few stamps advance."""
    seen = edge.statistics
    by_stamp = seen.stamp_period.count * 2 > seen.receipt_period.count
    return seen.stamp_period if by_stamp else seen.receipt_period


def without_longest(period: Spread) -> tuple[float, float]:
    """Return the mean and the standard deviation without the greatest value, because one pause is no jitter."""
    left = period.count - 1
    total = period.mean * period.count - period.greatest
    squares = (period.deviation**2 + period.mean**2) * period.count - period.greatest**2
    mean = total / left
    return mean, math.sqrt(max(0.0, squares / left - mean**2))


def _gap(subject: Subject, edge: Edge, limits: Limits) -> Evidence | None:
    seen = edge.statistics
    if seen.receipt_period.count < MIN_COUNT:
        return None
    silent_s = (subject.times_ns[1] - seen.last_received_ns) / 1e9
    mean_s, _ = without_longest(seen.receipt_period)
    by_stamp_s = without_longest(seen.stamp_period)[0] if seen.stamp_period.count >= MIN_COUNT else mean_s
    waits = (
        (seen.receipt_period.greatest, mean_s, "between two transforms"),
        (seen.stamp_period.greatest, by_stamp_s, "between two stamps"),
        (silent_s, mean_s, f"until the end{', after its publisher left' * edge.publisher.has_left}"),
    )
    gaps = [wait for wait in waits if wait[0] > max(limits.max_gap_s, GAP_PERIODS * wait[1])]
    if not gaps:
        return None
    gap_s, mean_s, where = max(gaps)
    text = f"{gap_s:.3f} s {where}; its period is {mean_s:.3f} s"
    return evidence_of(edge, text, gap_s=gap_s, period_s=mean_s, count=seen.count)
