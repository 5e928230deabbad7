"""Eight links of 45° each close a ring: positions and quaternions, signs included, between any two of its frames."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from tfloom.tf2.buffer import Buffer

SECOND = 1_000_000_000
HALF = math.sqrt(2) / 2
POSITIONS = [
    (0, 0), (HALF - 1, HALF), (-1, 1), (-1 - HALF, HALF), (-2, 0),
    (-1 - HALF, -HALF), (-1, -1), (HALF - 1, -HALF), (0, 0),
]  # fmt: skip


def turn(links: int) -> tuple[float, float]:
    """Return z and w of a number of eighths of a turn: w > 0 up to a third of a turn and beyond two, else z > 0."""
    z, w = math.sin(links * math.pi / 8), math.cos(links * math.pi / 8)
    is_wide = 4 * w * w < 1
    sign = math.copysign(1, z if is_wide else w)
    return sign * z, sign * w


@pytest.mark.parametrize("stamp", [SECOND, 10 * SECOND, 0])
@pytest.mark.parametrize("width", [SECOND, SECOND // 1000, SECOND // 10])
def test_transforms_around_a_ring(stamp: int, width: int) -> None:
    buffer = Buffer(None)
    names = {
        sign: ["a", *(prefix + letter for letter in "bcdefghi")]
        for sign, prefix in ((1, ""), (-1, "inverse_"))
    }
    for sign, chain in names.items():
        rotation = (0.0, 0.0, math.sin(sign * math.pi / 8), math.cos(math.pi / 8))
        for parent, child in pairwise(chain):
            for when in (max(stamp - width // 2, 0), stamp):
                assert buffer.set(parent, child, when, (HALF - 1, sign * HALF, 0), rotation)
    for sign, chain in names.items():
        for i, target in enumerate(chain):
            for j, source in enumerate(chain):
                transform = buffer.lookup(target, source, stamp)
                x, y = POSITIONS[abs(j - i)]
                forward = sign if j > i else -sign
                z, w = turn((j - i) * sign)
                assert transform.stamp_ns == stamp
                assert transform.translation == pytest.approx((x, forward * y, 0), abs=1e-9)
                if abs(j - i) == 8:  # once around: of either sign, by rounding
                    assert abs(transform.rotation_xyzw[3]) == pytest.approx(1)
                else:
                    assert transform.rotation_xyzw == pytest.approx((0, 0, z, w), abs=1e-9)
