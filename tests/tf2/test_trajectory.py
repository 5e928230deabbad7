"""Trajectories: their stamps, and what they are written as."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import ExtrapolationException, LookupException

SECOND = 1_000_000_000
START = 1_700_000_000 * SECOND


@pytest.fixture
def buffer() -> Buffer:
    """Return map -> odom at 10 Hz from 0 s to 1.9 s, odom -> base at 100 Hz from 0.05 s on; base -> lidar is static."""
    made = Buffer(None)
    coarse = START + np.arange(20) * (SECOND // 10)
    fine = START + SECOND // 20 + np.arange(200) * (SECOND // 100)
    made.set_many("map", "odom", coarse, np.zeros((20, 3)), np.tile([0, 0, 0, 1.0], (20, 1)))
    angle = np.arange(200) / 100
    way = np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1)
    turn = np.stack((0 * angle, 0 * angle, np.sin(angle / 2), np.cos(angle / 2)), axis=1)
    made.set_many("odom", "base", fine, way, turn)
    made.set("base", "lidar", 0, (0.0, 0.0, 1.0), (0, 0, 0, 1), static=True)
    return made


def test_stamps_are_those_of_the_chain_where_all_of_it_is_known(buffer: Buffer) -> None:
    trajectory = buffer.trajectory("map", "lidar")
    assert trajectory.stamps_ns[0] == START + SECOND // 20
    assert trajectory.stamps_ns[-1] == START + 19 * SECOND // 10
    assert (np.diff(trajectory.stamps_ns) > 0).all()
    assert len(trajectory.stamps_ns) == 186
    expected = buffer.lookup_many("map", "lidar", trajectory.stamps_ns)
    assert (trajectory.positions == expected.positions).all()
    assert trajectory.length_m == pytest.approx(1.85, abs=1e-3)
    assert trajectory.duration_s == 1.85


def test_resampled_at_a_rate(buffer: Buffer) -> None:
    trajectory = buffer.trajectory("map", "base", rate_hz=30)
    assert len(trajectory.stamps_ns) == 56
    steps = (trajectory.stamps_ns - trajectory.stamps_ns[0]) * 30 / 1e9
    assert np.abs(steps - np.arange(56)).max() < 1e-7
    part = buffer.trajectory(
        "map", "base", rate_hz=10, start_ns=START + SECOND, end_ns=START + 3 * SECOND // 2
    )
    assert part.stamps_ns.tolist() == [START + i * SECOND // 10 for i in range(10, 16)]
    assert len(buffer.trajectory("map", "base", rate_hz=10, start_ns=START + 9 * SECOND).stamps_ns) == 0


def test_at_the_stamps_of_another_topic(buffer: Buffer) -> None:
    stamps = START + np.array([-1, 1, 5]) * (SECOND // 5)
    with pytest.raises(ExtrapolationException) as caught:
        buffer.trajectory("map", "base", stamps)
    assert caught.value.index == 0  # type: ignore[attr-defined]
    trajectory = buffer.trajectory("map", "base", stamps, strict=False)
    assert trajectory.stamps_ns.tolist() == stamps[1:].tolist()


def test_static_chain_has_no_stamps(buffer: Buffer) -> None:
    assert len(buffer.trajectory("base", "lidar").stamps_ns) == 0
    assert buffer.trajectory("base", "lidar", rate_hz=5).length_m == 0


def test_wrong_arguments(buffer: Buffer) -> None:
    with pytest.raises(LookupException):
        buffer.trajectory("map", "nothing")
    with pytest.raises(ValueError, match="give stamps_ns or rate_hz, not both"):
        buffer.trajectory("map", "base", [START], rate_hz=1)
    for rate in (0, -1, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="rate_hz must be above 0"):
            buffer.trajectory("map", "base", rate_hz=rate)
    with pytest.raises(ValueError, match="more than 100 million stamps"):
        buffer.trajectory("map", "base", rate_hz=9e8)


def test_texts_of_tum_and_kitti(buffer: Buffer, tmp_path: Path) -> None:
    trajectory = buffer.trajectory("map", "lidar", rate_hz=20)
    tum = np.array([line.split() for line in trajectory.tum_text().splitlines()], float)
    assert tum.shape == (38, 8)
    assert (tum[:, 1:4] == trajectory.positions).all()
    assert (tum[:, 4:] == trajectory.rotations_xyzw).all()
    assert trajectory.tum_text().startswith("1700000000.050000000 1.0 0.0 1.0 0.0 0.0 0.0 1.0\n")
    kitti = np.array([line.split() for line in trajectory.kitti_text().splitlines()], float)
    assert (kitti.reshape(-1, 3, 4) == trajectory.matrices()[:, :3]).all()
    trajectory.write_tum(tmp_path / "a.tum")
    trajectory.write_kitti(tmp_path / "a.kitti")
    assert (tmp_path / "a.tum").read_text() == trajectory.tum_text()
    assert (tmp_path / "a.kitti").read_text() == trajectory.kitti_text()


def test_table_of_pandas(buffer: Buffer, monkeypatch: pytest.MonkeyPatch) -> None:
    trajectory = buffer.trajectory("map", "lidar")
    table = trajectory.to_pandas()
    assert list(table.columns) == ["x", "y", "z", "qx", "qy", "qz", "qw"]
    assert (table.index.as_unit("ns").asi8 == trajectory.stamps_ns).all()
    assert str(table.index.tz) == "UTC"
    assert (table[["x", "y", "z"]].to_numpy() == trajectory.positions).all()
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(
        ImportError, match="pandas is needed for a DataFrame: install it by `pip install pandas`"
    ):
        trajectory.to_pandas()


def test_what_notebooks_show(buffer: Buffer) -> None:
    buffer.set("map", "<b>&", 0, (0, 0, 0), (0, 0, 0, 1), static=True)
    tree = buffer._repr_html_()
    assert tree.index(">map</code>") < tree.index(">odom</code>") < tree.index(">lidar</code>")
    assert "20 samples, 10.0 Hz, 1700000000.000 to 1700000001.900" in tree
    assert ">&lt;b&gt;&amp;</code>" in tree
    assert tree.count("<ul") == tree.count("</ul>") == 4
    edge = next(edge for edge in buffer.edges() if edge.child_frame_id == "odom")
    assert ">map</code>" in edge._repr_html_()
    way = buffer.trajectory("map", "lidar")._repr_html_()
    assert "186" in way
    assert "<polyline points=" in way
    assert "<svg" not in buffer.trajectory("base", "lidar")._repr_html_()


def test_long_chain_is_shown() -> None:
    deep = Buffer(None)
    for i in range(3000):
        deep.set(f"f{i}", f"f{i + 1}", 0, (0, 0, 0), (0, 0, 0, 1), static=True)
    assert "2001 more frames" in deep._repr_html_()
