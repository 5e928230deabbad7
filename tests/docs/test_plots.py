"""tools/plots.py: what it reads from a benchmark's output, and draws."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from tests.docs.page import DOCS
from tools import plots

OUTPUT = DOCS / "pictures" / "benchmark_tf2.txt"
TEXT = """\
== tf2
a peer is not installed
lookup, latest, depth 10, 1000 Hz                              0.184 µs            transform-tree        0.431      2.3 x
                                                                                   pytransform3d      3879.301  21083.2 x
a row with no peer                                             1.000 ms
"""  # noqa: E501 as printed


def test_rows_are_read() -> None:
    (row,) = plots.read_rows(TEXT)
    assert row.what == "lookup, latest, depth 10, 1000 Hz"
    assert row.times_ns == pytest.approx({"tfloom": 184, "transform-tree": 431, "pytransform3d": 3_879_301})


@pytest.mark.slow
def test_picture_of_the_page_shows_the_output(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    rows = plots.read_rows(OUTPUT.read_text("utf-8"))
    plots.draw(rows, tmp_path / "fast.svg")
    drawn, shown = (
        re.findall(r">([^<>]+)</text>", path.read_text("utf-8"))
        for path in (tmp_path / "fast.svg", DOCS / "pictures" / "fast.svg")
    )
    assert drawn == shown
    times = [time for row in rows if row.what in plots.ROWS for time in row.times_ns.values()]
    assert sum(any(plots.time_text(time) in text for text in shown) for time in times) == len(times) >= 10


def test_output_of_another_benchmark_is_rejected(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="the output has no row 'lookup, latest, depth 10, 1000 Hz'"):
        plots.draw(plots.read_rows(""), tmp_path / "fast.svg")
