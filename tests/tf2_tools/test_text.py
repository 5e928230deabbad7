"""tf2_echo's text: exactly the reference's, except for the zeros after a time's decimal point."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.recorded_outputs import recorded_output

from tfloom.tf2_tools.text import matrix_from_quaternion, rpy_from_matrix, transform_text

ROOT = Path(__file__).parents[2]
HALF = math.sqrt(0.5)


def test_text_equals_that_of_the_reference() -> None:
    golden = recorded_output("tf2_echo")
    reference = golden[golden.index("At time") :].split("At time")[1]
    ours = transform_text(0, (1.0, 2.0, 3.0), (0.0, 0.0, HALF, HALF))
    stamp, _, rest = ours.removeprefix("At time").partition("\n")
    reference_stamp, _, reference_rest = reference.partition("\n")
    assert rest + "\n" == reference_rest
    assert float(stamp) == float(reference_stamp)
    assert "| tf2-echo-nanoseconds |" in (ROOT / "docs" / "deviations.md").read_text()


@pytest.mark.parametrize(
    ("stamp_ns", "text"),
    [
        (0, "At time 0.000000000"),
        (1_005_000_000, "At time 1.005000000"),
        (1_795_257_550_785_885_001, "At time 1795257550.785885001"),
    ],
)
def test_nanoseconds_have_leading_zeros(stamp_ns: int, text: str) -> None:
    assert transform_text(stamp_ns, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)).startswith(text + "\n")


def quaternion_from_rpy(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


ANGLES = st.floats(-3.0, 3.0)


@given(ANGLES, st.floats(-1.5, 1.5), ANGLES)
def test_angles_survive_conversion(roll: float, pitch: float, yaw: float) -> None:
    matrix = matrix_from_quaternion(quaternion_from_rpy(roll, pitch, yaw))
    assert rpy_from_matrix(matrix) == pytest.approx((roll, pitch, yaw), abs=1e-6)


@given(ANGLES, st.sampled_from([1.0, -1.0]), ANGLES)
def test_yaw_is_zero_at_a_pitch_of_a_quarter_turn(roll: float, sign: float, yaw: float) -> None:
    quaternion = quaternion_from_rpy(roll, sign * math.pi / 2, yaw)
    matrix = matrix_from_quaternion(quaternion)
    exact = (*matrix[:2], (-sign, 0.0, 0.0))
    found = rpy_from_matrix(exact)
    assert found[1:] == (sign * math.pi / 2, 0.0)
    again = matrix_from_quaternion(quaternion_from_rpy(*found))
    for row, row_again in zip(matrix, again, strict=True):
        assert row == pytest.approx(row_again, abs=1e-6)


@given(st.tuples(ANGLES, ANGLES, ANGLES, ANGLES).filter(lambda q: sum(n * n for n in q) > 1e-3))
def test_rows_are_orthonormal(quaternion: tuple[float, float, float, float]) -> None:
    matrix = matrix_from_quaternion(quaternion)
    for i in range(3):
        for k in range(3):
            dot = sum(a * b for a, b in zip(matrix[i], matrix[k], strict=True))
            assert dot == pytest.approx(float(i == k), abs=1e-9)
