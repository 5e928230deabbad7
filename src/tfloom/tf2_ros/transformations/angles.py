"""Angles modulo a turn, as the ROS package `angles` has them [rad]."""

from __future__ import annotations

import math

__all__ = [
    "normalize_angle",
    "normalize_angle_positive",
    "shortest_angular_distance",
    "shortest_angular_distance_with_limits",
    "two_pi_complement",
]

_TURN = 2.0 * math.pi


def normalize_angle_positive(angle: float) -> float:
    """Return the same angle from 0 to below 2π."""
    return math.fmod(math.fmod(angle, _TURN) + _TURN, _TURN)


def normalize_angle(angle: float) -> float:
    """Return the same angle above -π, and up to π."""
    normalized = normalize_angle_positive(angle)
    return normalized - _TURN if normalized > math.pi else normalized


def shortest_angular_distance(from_angle: float, to_angle: float) -> float:
    """Return the shortest turn from one angle to another: above -π, and up to π."""
    return normalize_angle(to_angle - from_angle)


def two_pi_complement(angle: float) -> float:
    """Return the turn the other way round to the same angle: for one above 0 it is below 0, for 0 it is 2π."""
    turn = math.fmod(angle, _TURN) if abs(angle) > _TURN else angle
    return turn - _TURN if turn > 0 else turn + _TURN


def shortest_angular_distance_with_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """Return the shortest turn from one angle to another that stays between two limits.

    Args:
        from_angle: Where the turn begins.
        to_angle: Where it ends.
        left_limit: The lower limit, from -π to π.
        right_limit: The upper limit, from -π to π. If it is below the other one, ±π is between them.

    Returns:
        True and the turn; False, and the turn that would be shortest without limits, if one of the angles is beyond
        them.
    """
    short = shortest_angular_distance(from_angle, to_angle)
    width = normalize_angle_positive(right_limit - left_limit)
    if width == 0.0 and right_limit > left_limit:  # from -π to π: all angles
        width = _TURN
    start = normalize_angle_positive(from_angle - left_limit)
    end = normalize_angle_positive(to_angle - left_limit)
    if start > width or end > width:
        return False, short
    # Both are between the limits, so the turn that stays there is their difference, counted from the lower limit.
    return True, end - start
