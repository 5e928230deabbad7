"""Motions over time: where data is missing, and charts that were looked at."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.tf2_tools.kept_pictures import assert_looks_as_kept

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import TransformException
from tfloom.tf2_tools.chart import BAND, axis_of, chart
from tfloom.tf2_tools.drawing.png import png_bytes
from tfloom.tf2_tools.drawing.shapes import Box, Group, Picture, Text
from tfloom.tf2_tools.drawing.shapes import Path as Line
from tfloom.tf2_tools.drawing.svg import svg_text
from tfloom.tf2_tools.motion import Motion, motion_of

PICTURE = Path(__file__).parent / "chart.png"
START_S = 1_795_257_550
CIRCLE = np.arange(0.0, 60.0, 0.02)


def insert(buffer: Buffer, parent: str, child: str, times_s: NDArray[np.float64]) -> None:
    """Insert a circle of 3 m with the yaw as its angle."""
    yaw = times_s / 6
    stamps = START_S * 1_000_000_000 + np.round(times_s * 1e9).astype(np.int64)
    zero = np.zeros_like(yaw)
    buffer.set_many(
        parent,
        child,
        stamps,
        np.column_stack([3 * np.cos(yaw), 3 * np.sin(yaw), 0.2 * np.sin(times_s)]),
        np.column_stack([zero, zero, np.sin(yaw / 2), np.cos(yaw / 2)]),
    )


def circle(times_s: NDArray[np.float64] = CIRCLE, target: str = "map", source: str = "camera") -> Motion:
    """Return the motion of a camera on a base that drives on a circle."""
    buffer = Buffer(None)
    insert(buffer, "map", "base", times_s)
    buffer.set("base", "camera", 0, (0.0, 0.0, 0.5), (0.0, 0.0, 0.0, 1.0), "", static=True)
    return motion_of(buffer, target, source)


def without(*gaps: tuple[float, float]) -> NDArray[np.float64]:
    keep = np.ones(len(CIRCLE), bool)
    for start, end in gaps:
        keep &= (start >= CIRCLE) | (end <= CIRCLE)
    return CIRCLE[keep]


def test_positions_and_angles_are_those_of_the_circle() -> None:
    motion = circle()
    assert len(motion.times_ns) == len(CIRCLE)
    assert motion.gaps_ns == []
    assert np.allclose(motion.positions[:, 0], 3 * np.cos(CIRCLE / 6))
    assert np.allclose(motion.positions[:, 2], 0.2 * np.sin(CIRCLE) + 0.5)
    wrapped = np.degrees(np.arctan2(np.sin(CIRCLE / 6), np.cos(CIRCLE / 6)))
    assert np.allclose(motion.angles_deg[:, 2], wrapped)
    assert np.allclose(motion.angles_deg[:, :2], 0.0)


def test_roll_and_pitch_have_their_signs() -> None:
    buffer = Buffer(None)
    half = math.radians(30.0) / 2
    for i in range(3):
        buffer.set("a", "rolled", 10**9 + i, (0.0,) * 3, (math.sin(half), 0.0, 0.0, math.cos(half)))
        buffer.set("a", "pitched", 10**9 + i, (0.0,) * 3, (0.0, -math.sin(half), 0.0, math.cos(half)))
    assert motion_of(buffer, "a", "rolled").angles_deg[0] == pytest.approx([30.0, 0.0, 0.0])
    assert motion_of(buffer, "a", "pitched").angles_deg[0] == pytest.approx([0.0, -30.0, 0.0])


def test_a_gap_of_any_edge_of_the_chain_is_a_gap() -> None:
    buffer = Buffer(None)
    insert(buffer, "map", "odom", without((10.0, 12.0)))
    insert(buffer, "odom", "base", without((11.0, 14.0), (20.0, 20.06)))
    motion = motion_of(buffer, "map", "base")
    spans = [
        ((start - START_S * 10**9) / 1e9, (end - START_S * 10**9) / 1e9) for start, end in motion.gaps_ns
    ]
    assert spans == [pytest.approx((10.0, 14.0), abs=0.021)]
    times = (motion.times_ns - START_S * 10**9) / 1e9
    assert not ((times > 10.03) & (times < 13.97)).any()
    assert [piece.stop - piece.start for piece in motion.pieces()] == [
        (times < 12.0).sum(),
        (times > 12.0).sum(),
    ]


def test_jitter_and_a_slower_edge_are_no_gaps() -> None:
    dice = np.random.default_rng(1)
    buffer = Buffer(None)
    insert(buffer, "map", "odom", np.sort(CIRCLE + dice.uniform(-0.009, 0.009, len(CIRCLE))))
    insert(buffer, "odom", "base", CIRCLE[::50])
    assert motion_of(buffer, "map", "base").gaps_ns == []


def test_static_chains_have_no_motion_and_unconnected_frames_raise() -> None:
    assert len(circle(target="base").times_ns) == 0
    with pytest.raises(TransformException, match="nowhere"):
        circle(target="nowhere")


def lines(picture: Picture, curve: str) -> list[int]:
    """Return the number of points of each line of a curve."""
    (group,) = [
        shape for shape in picture.shapes if isinstance(shape, Group) and shape.title.startswith(curve)
    ]
    return [len(shape.points) if isinstance(shape, Line) else 1 for shape in group.shapes]


def test_gaps_break_lines_and_have_a_band() -> None:
    picture = chart(circle(without((20.0, 23.5), (40.0, 40.4))), "robot.mcap")
    assert_looks_as_kept(PICTURE, png_bytes(picture))
    assert len(lines(picture, "x")) == 3
    assert len(lines(picture, "yaw")) == 5  # it passes 180 degrees twice
    assert sum(isinstance(shape, Box) and shape.fill == BAND for shape in picture.shapes) == 4 + 2
    texts = [shape.text for shape in picture.shapes if isinstance(shape, Text)]
    for text in ("camera in map", "position [m]", "yaw [deg]", "x", "yaw", "no data"):
        assert text in texts
    assert "robot.mcap, 60 s, 2807 samples, 2 gaps, the longest 3.5 s" in texts
    assert f"time [s] since {START_S}.000 (2026-11-21 10:39:10 UTC)" in texts


def test_all_angles_have_a_curve_each() -> None:
    picture = chart(circle(), "live", all_angles=True)
    assert [len(lines(picture, name)) for name in ("roll", "pitch", "yaw")] == [1, 1, 3]
    assert "no data" not in svg_text(picture)


def test_a_long_recording_has_as_many_points_as_columns_and_its_extremes() -> None:
    times = np.arange(0.0, 600.0, 0.002)
    motion = circle(times)
    motion.positions[123_456, 0] = 50.0
    picture = chart(motion, "long")
    assert sum(lines(picture, "x")) < 3000
    (group,) = [shape for shape in picture.shapes if isinstance(shape, Group) and shape.title.startswith("x")]
    highest = min(y for shape in group.shapes if isinstance(shape, Line) for _, y in shape.points)
    assert highest == pytest.approx(62.0 + 171.0 * (60.0 - 50.0) / 70.0, abs=30.0)


@pytest.mark.parametrize("times_s", [[0.0], [0.0, 0.0000001], [0.0, 1e-9], [0.0, 1e9]])
def test_odd_times_can_be_drawn(times_s: list[float]) -> None:
    assert svg_text(chart(circle(np.array(times_s)), "x" * 500)).count("</svg>") == 1


@pytest.mark.parametrize(
    ("low", "high", "degrees", "texts"),
    [
        (0.0, 1.0, False, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]),
        (-3.1, 3.1, False, ["-4", "-2", "0", "2", "4"]),
        (-179.0, 179.0, True, ["-180", "-90", "0", "90", "180"]),
        (2.0, 2.0, False, ["1.4", "1.6", "1.8", "2.0", "2.2", "2.4", "2.6"]),
        (
            0.0,
            1e-7,
            False,
            ["0.00000000", "0.00000002", "0.00000004", "0.00000006", "0.00000008", "0.00000010"],
        ),
        (0.0, 7e12, False, None),
        (0.0, 1.1, False, ["0.00", "0.25", "0.50", "0.75", "1.00", "1.25"]),
    ],
)
def test_ticks_are_round(low: float, high: float, degrees: bool, texts: list[str] | None) -> None:
    axis = axis_of(low, high, 5, degrees=degrees)
    assert axis.low <= low
    assert axis.high >= high
    if texts is not None:
        assert [axis.text(tick) for tick in axis.ticks] == texts
    assert len(set(map(axis.text, axis.ticks))) == len(axis.ticks) <= 7
