"""`angles`: angles modulo a turn."""

from __future__ import annotations

import random
from math import isclose, pi

import pytest
from angles import (
    normalize_angle,
    normalize_angle_positive,
    shortest_angular_distance,
    shortest_angular_distance_with_limits,
    two_pi_complement,
)


@pytest.mark.parametrize("turns", [-2, -1, 0, 1, 3])
@pytest.mark.parametrize("angle", [0.0, 0.3, 3.0, -0.3, -3.0])
def test_normalized_angles(angle: float, turns: int) -> None:
    assert normalize_angle(angle + turns * 2 * pi) == pytest.approx(angle)
    assert normalize_angle_positive(angle + turns * 2 * pi) % (2 * pi) == pytest.approx(angle % (2 * pi))


def test_bounds() -> None:
    assert normalize_angle(pi) == pi
    assert normalize_angle(-pi) == pi
    assert 0.0 <= normalize_angle_positive(-1e-20) < 2 * pi + 1e-12
    assert (two_pi_complement(0.0), two_pi_complement(pi)) == (2 * pi, -pi)
    assert two_pi_complement(-pi / 2) == pytest.approx(3 * pi / 2)
    assert two_pi_complement(5 * pi / 2) == pytest.approx(-3 * pi / 2)


@pytest.mark.parametrize(
    ("start", "end", "turn"),
    [(0.0, 1.0, 1.0), (3.0, -3.0, 2 * pi - 6.0), (-3.0, 3.0, 6.0 - 2 * pi), (0.0, pi, pi)],
)
def test_shortest_distance(start: float, end: float, turn: float) -> None:
    assert shortest_angular_distance(start, end) == pytest.approx(turn)


@pytest.mark.parametrize(
    ("start", "end", "left", "right", "expected"),
    [
        (0.0, 1.0, -1.0, 1.0, (True, 1.0)),
        (1.0, -1.0, -1.0, 1.0, (True, -2.0)),
        (-2.5, 2.5, -2.6, 2.6, (True, 5.0)),  # the short way is beyond the limits
        (2.5, -2.5, 2.0, -2.0, (True, 2 * pi - 5.0)),  # ±π is between the limits
        (0.0, 2.0, -1.0, 1.0, (False, 2.0)),
        (2.0, 0.0, -1.0, 1.0, (False, -2.0)),
        (0.5, 2.0, -pi, pi, (True, 1.5)),
    ],
)
def test_distance_between_limits(
    start: float, end: float, left: float, right: float, expected: tuple[bool, float]
) -> None:
    is_within, turn = shortest_angular_distance_with_limits(start, end, left, right)
    assert (is_within, turn) == (expected[0], pytest.approx(expected[1]))


def test_turns_between_limits_stay_there() -> None:
    """Follow random turns in small steps: each of them is between the limits, and the last is at the end."""
    generator = random.Random(3)
    for _ in range(300):
        left, right = generator.uniform(-pi, pi), generator.uniform(-pi, pi)
        width = (right - left) % (2 * pi)
        start, end = (left + generator.random() * width for _ in range(2))
        is_within, turn = shortest_angular_distance_with_limits(start, end, left, right)
        assert is_within
        for step in range(11):
            assert (start + turn * step / 10 - left) % (2 * pi) <= width + 1e-9
        assert isclose(shortest_angular_distance(start + turn, end), 0.0, abs_tol=1e-9)
