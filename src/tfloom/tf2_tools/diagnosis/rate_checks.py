"""Checks of how often transforms come: the rate, its variation, and gaps."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tfloom._native import Spread
from tfloom.tf2_tools.diagnosis.catalogue import GAP_PERIODS, MIN_COUNT, MIN_JITTER_S, Limits
from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding
from tfloom.tf2_tools.diagnosis.subject import Subject, evidence_of, for_each_publisher
from tfloom.tf2_tools.text import counted
from tfloom.tf2_tools.watch.model import Edge


def check_rates(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on rates. An edge with a gap is not looked at for its jitter, which the gap would dominate."""
    gaps = {edge: gap for edge in subject.moving if (gap := _gap_evidence(subject, edge, limits))}
    rare = (
        (edge, evidence) for edge in subject.moving if (evidence := _low_rate_evidence(subject, edge, limits))
    )
    varying = (
        (edge, evidence)
        for edge in subject.moving
        if edge not in gaps and (evidence := _jitter_evidence(edge, limits))
    )
    yield from for_each_publisher("TF404", "publishes rarely: {}", rare)
    yield from for_each_publisher("TF405", "publishes at uneven times: {}", varying)
    yield from for_each_publisher("TF406", "paused: {}", gaps.items())


def _low_rate_evidence(subject: Subject, edge: Edge, limits: Limits) -> Evidence | None:
    statistics = edge.statistics
    if (
        subject.is_simulated and statistics.stamp_period.count > 1
    ):  # a simulation's seconds may be longer or shorter
        period_s = statistics.stamp_period.mean
    elif statistics.receipt_period.count > 1:
        period_s = statistics.receipt_period.mean
    else:
        period_s = (subject.times_ns[1] - statistics.first_received_ns) / 1e9 / statistics.count
    if period_s * limits.min_rate_hz <= 1.0:
        return None
    rate_hz = 1.0 / period_s
    text = f"{rate_hz:.2f} Hz, {counted(statistics.count, 'transform')} in {subject.duration_s:.1f} s"
    return evidence_of(edge, text, rate_hz=rate_hz, count=statistics.count)


def _jitter_evidence(edge: Edge, limits: Limits) -> Evidence | None:
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
    statistics = edge.statistics
    by_stamp = statistics.stamp_period.count * 2 > statistics.receipt_period.count
    return statistics.stamp_period if by_stamp else statistics.receipt_period


def without_longest(period: Spread) -> tuple[float, float]:
    """Return the mean and the standard deviation without the greatest value, because one pause is not jitter."""
    # The sums follow from mean and deviation: sum = mean n, and sum of squares = (deviation² + mean²) n. Subtract the
    # greatest value from both, and form mean and deviation anew.
    left = period.count - 1
    total = period.mean * period.count - period.greatest
    squares = (period.deviation**2 + period.mean**2) * period.count - period.greatest**2
    mean = total / left
    return mean, math.sqrt(max(0.0, squares / left - mean**2))


def _gap_evidence(subject: Subject, edge: Edge, limits: Limits) -> Evidence | None:
    statistics = edge.statistics
    if statistics.receipt_period.count < MIN_COUNT:
        return None
    silent_s = (subject.times_ns[1] - statistics.last_received_ns) / 1e9
    mean_s, _ = without_longest(statistics.receipt_period)
    by_stamp_s = (
        without_longest(statistics.stamp_period)[0] if statistics.stamp_period.count >= MIN_COUNT else mean_s
    )
    # Three waits can be a gap: between receipts, between stamps (a sender that paused, and whose messages came in a
    # burst afterwards), and from the last receipt to the end. Each is compared with the period of its own clock.
    waits = (
        (statistics.receipt_period.greatest, mean_s, "between two transforms"),
        (statistics.stamp_period.greatest, by_stamp_s, "between two stamps"),
        (silent_s, mean_s, f"until the end{', after its publisher left' * edge.publisher.has_left}"),
    )
    gaps = [wait for wait in waits if wait[0] > max(limits.max_gap_s, GAP_PERIODS * wait[1])]
    if not gaps:
        return None
    gap_s, mean_s, where = max(gaps)
    text = f"{gap_s:.3f} s {where}; its period is {mean_s:.3f} s"
    return evidence_of(edge, text, gap_s=gap_s, period_s=mean_s, count=statistics.count)
