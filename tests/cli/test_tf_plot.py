"""`tf plot`: from a recording and from a live graph, and its errors."""

from __future__ import annotations

import math
import shlex
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.tf2_tools.recordings import MS, START_NS, recorded, transform, write_bag


@pytest.fixture(scope="module")
def bag(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of 10 s with a gap of 2 s, and a static transform that is recorded last."""
    messages = [
        recorded(now_ns, transform("map", "base", now_ns, (math.cos(i / 50), math.sin(i / 50), 0.0), i / 50))
        for i in range(500)
        if not 200 < i < 300
        for now_ns in [START_NS + i * 20 * MS]
    ]
    messages.append(
        recorded(START_NS + 11_000 * MS, transform("base", "лазер", START_NS), topic="/tf_static")
    )
    return write_bag(tmp_path_factory.mktemp("bag") / "robot", messages)


Run = Callable[..., tuple[int, str]]


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_a_recording_is_drawn_in_each_format(bag: Path, run_tf: Run, tmp_path: Path) -> None:
    for ending, start in {"png": b"\x89PNG", "svg": b"<svg", "pdf": b"%PDF"}.items():
        drawn = run_tf("plot", "map", "лазер", "--bag", bag, "--rpy", "-o", f"out.{ending}")
        assert drawn == (0, f"out.{ending}: 401 samples in 9.980 s, 1 without data")
        assert (tmp_path / f"out.{ending}").read_bytes().startswith(start)
    svg = (tmp_path / "out.svg").read_text("utf-8")
    assert ">лазер in map</text>" in svg
    assert "9.98 s, 401 samples, 1 gap, the longest 2 s" in svg


def test_a_live_graph_is_recorded_until_ctrl_c(
    domain_id: int, start_program: Callable[..., Any], run_tf: Run, tmp_path: Path
) -> None:
    plot = start_program("tfloom", "tf", "plot", "odom", "base", "--seconds", "60", "--wait", "20")
    start_program("python", Path(__file__).with_name("a_broadcaster.py")).wait_for("broadcasting")
    plot.wait_for("recording for 60 s; Ctrl-C ends it earlier")
    code, text = run_tf("plot", "odom", "base", "--seconds", "1", "-o", "1.svg")
    assert (code, "1.svg: " in text) == (0, True)
    plot.signal(signal.SIGINT)
    assert plot.wait() == 0
    samples = int(plot.output.split("tf_plot.png: ")[1].split()[0])
    assert 20 <= samples <= 3000
    assert (tmp_path / "tf_plot.png").read_bytes().startswith(b"\x89PNG")


def test_one_sample_is_drawn(run_tf: Run, tmp_path: Path) -> None:
    bag = write_bag(tmp_path / "robot", [recorded(START_NS, transform("map", "base", START_NS))])
    drawn = run_tf("plot", "map", "base", "--bag", bag, "-o", "1.svg")
    assert drawn == (0, "1.svg: 1 sample in 0.000 s")
    assert "0 s, 1 sample</text>" in (tmp_path / "1.svg").read_text("utf-8")


def test_static_transforms_are_not_recorded(
    domain_id: int, start_program: Callable[..., Any], run_tf: Run
) -> None:
    words = ("tfloom", "run", "tf2_ros", "static_transform_publisher")
    start_program(*words, "--frame-id", "base", "--child-frame-id", "laser").wait_for("publishing")
    refused = run_tf("plot", "base", "laser", "--seconds", "1e9")
    assert refused == (1, "laser does not move in base: all transforms between them are static")


def test_errors_say_what_to_do(bag: Path, run_tf: Run, tmp_path: Path) -> None:
    code, text = run_tf("plot", "map", "no where", "--bag", bag)
    explanation = ["tfloom", "tf", "explain", "map", "no where", "--bag", str(bag)]
    assert (code, text.count("\n")) == (1, 0)
    assert text.endswith(f" Try: {shlex.join(explanation)}")
    code, text = run_tf("plot", "base", "лазер", "--bag", bag)
    assert (code, text) == (1, "лазер does not move in base: all transforms between them are static")
    code, text = run_tf("plot", "a", "b", "-o", "a.jpg")
    assert (code, "'a.jpg' must end in .pdf, .png or .svg" in text) == (2, True)
    code, text = run_tf("plot", "a", "b", "-o", "missing/a.png")
    assert (code, "there is no folder missing" in text) == (2, True)
    assert list(tmp_path.iterdir()) == []
