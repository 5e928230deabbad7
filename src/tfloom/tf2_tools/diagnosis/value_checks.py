"""Checks of transforms' values."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tfloom._native import EdgeStatistics, Step
from tfloom.tf2_tools.diagnosis.catalogue import MAX_SPIN_DEG_S, Limits
from tfloom.tf2_tools.diagnosis.finding import Evidence, Finding
from tfloom.tf2_tools.diagnosis.subject import Subject, evidence_of, for_each_publisher
from tfloom.tf2_tools.watch.model import Edge

REJECTED_NORM_ERROR = 0.005
"""From this difference of |q| from 1 on, listeners reject the transform: |q|² then differs by 0.01."""
SUDDEN = 3.0
"""A sudden step is faster than this number of usual ones."""
IMPOSSIBLE = 5.0
"""Times the greatest speed; a step that is faster is a teleport even if all steps are."""
MIN_UNCHANGED_COUNT = 5
"""Number of equal transforms on /tf from which a frame counts as fixed."""
MIN_UNCHANGED_S = 1.0


def check_values(subject: Subject, limits: Limits) -> Iterator[Finding]:
    """Yield the findings on values."""
    yield from for_each_publisher(
        "TF301", "sends numbers that are not finite: {}", _non_finite_values(subject)
    )
    yield from for_each_publisher(
        "TF302", "sends quaternions that are not of unit length: {}", _non_unit_quaternions(subject, limits)
    )
    yield from for_each_publisher("TF303", "lets a frame teleport: {}", _teleports(subject, limits))
    yield from for_each_publisher("TF501", "repeats what never changes: {}", _unchanging_edges(subject))
    yield from for_each_publisher("TF502", "changes static transforms: {}", _changed_statics(subject))


def _non_finite_values(subject: Subject) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.edges:
        count, bad = edge.statistics.count, edge.statistics.non_finite
        if bad:
            yield edge, evidence_of(edge, f"{bad} of {count} transforms", not_finite=bad, count=count)


def _non_unit_quaternions(subject: Subject, limits: Limits) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.edges:
        error = edge.statistics.worst_norm_error
        if error > limits.max_norm_error:
            effect = "is rejected" if error >= REJECTED_NORM_ERROR else "is accepted"
            text = f"|q| differs from 1 by {error:.3g}, which {effect} by listeners"
            yield edge, evidence_of(edge, text, norm_error=error)


def _teleports(subject: Subject, limits: Limits) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.moving:
        statistics = edge.statistics
        for step in (statistics.longest, statistics.fastest, statistics.widest):
            if _is_teleport(edge, step, limits):
                yield edge, _step_evidence(edge, step)
                break


def _is_teleport(edge: Edge, step: Step, limits: Limits) -> bool:
    """Return whether a step is long and sudden: those of a fast vehicle, or of a spinning sensor, are all long."""
    if step.elapsed_ns <= 0:
        return False
    elapsed_s, turn_deg = step.elapsed_ns / 1e9, math.degrees(step.angle_rad)
    usual_m_s, usual_deg_s = _usual_speeds(edge.statistics)
    # The step must be faster than a vehicle of this kind may be, and several times as fast as this one usually is. The
    # upper bound holds where every step is a jump, so that no usual speed exists to compare with.
    least_m_s = min(max(limits.max_speed_m_s, SUDDEN * usual_m_s), IMPOSSIBLE * limits.max_speed_m_s)
    is_far = step.distance > limits.max_jump_m and step.distance > least_m_s * elapsed_s
    least_deg_s = max(MAX_SPIN_DEG_S, SUDDEN * usual_deg_s)
    return is_far or (turn_deg > limits.max_turn_deg and turn_deg > least_deg_s * elapsed_s)


def _usual_speeds(statistics: EdgeStatistics) -> tuple[float, float]:
    """Return the mean speeds without the longest and the widest step [m/s, deg/s]; 0 with one step."""
    others = statistics.distance.count - 1
    if others < 1 or statistics.stamp_period.mean <= 0.0:
        return 0.0, 0.0
    # Take the longest step out of the mean: among few steps, a jump would raise the speed that it is compared with.
    distance = (statistics.distance.mean * (others + 1) - statistics.longest.distance) / others
    # The observer sums cosines of half the angles, not angles. Their mean gives an angle near the mean of the angles.
    cosine = (statistics.cosine.mean * (others + 1) - math.cos(statistics.widest.angle_rad / 2)) / others
    angle_deg = math.degrees(2 * math.acos(min(1.0, cosine)))
    return distance / statistics.stamp_period.mean, angle_deg / statistics.stamp_period.mean


def _step_evidence(edge: Edge, step: Step) -> Evidence:
    elapsed_s, turn_deg = step.elapsed_ns / 1e9, math.degrees(step.angle_rad)
    stamp = f"{step.stamp_ns / 1e9:.3f}"
    text = f"moved {step.distance:.3g} m and turned {turn_deg:.3g} deg within {elapsed_s:.3f} s, at {stamp}"
    figures = {"distance_m": step.distance, "angle_deg": turn_deg, "elapsed_s": elapsed_s}
    return evidence_of(edge, text, stamp_ns=step.stamp_ns, **figures)


def _unchanging_edges(subject: Subject) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.moving:
        statistics = edge.statistics
        duration_s = (statistics.last_received_ns - statistics.first_received_ns) / 1e9
        is_known = (
            statistics.count - statistics.non_finite >= MIN_UNCHANGED_COUNT and duration_s >= MIN_UNCHANGED_S
        )
        if is_known and statistics.changes == 0:
            text = f"{statistics.count} equal transforms in {duration_s:.1f} s"
            yield edge, evidence_of(edge, text, count=statistics.count, duration_s=duration_s)


def _changed_statics(subject: Subject) -> Iterator[tuple[Edge, Evidence]]:
    for edge in subject.edges:
        statistics = edge.statistics
        if edge.is_static and statistics.changes > 1:
            farthest_m = statistics.distance.greatest
            text = f"{statistics.changes} changes in {statistics.count} transforms, by {farthest_m:.3g} m at most"
            yield edge, evidence_of(edge, text, changes=statistics.changes, count=statistics.count)
