"""`tf plot` as a process: from a recording and from a live graph, and its errors."""

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


def test_a_recording_is_drawn_in_each_format(
    bag: Path, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    starts = {"png": b"\x89PNG", "svg": b"<svg", "pdf": b"%PDF"}
    words = ("tfloom", "tf", "plot", "map", "лазер", "--bag", str(bag), "--rpy")
    plots = {ending: start_program(*words, "-o", f"out.{ending}", cwd=tmp_path) for ending in starts}
    for ending, plot in plots.items():
        assert plot.wait() == 0, plot.output
        assert plot.lines == [f"out.{ending}: 401 samples in 9.980 s, 1 without data"]
        assert (tmp_path / f"out.{ending}").read_bytes().startswith(starts[ending])
    svg = (tmp_path / "out.svg").read_text("utf-8")
    assert ">лазер in map</text>" in svg
    assert "9.98 s, 401 samples, 1 gap, the longest 2 s" in svg


def test_a_live_graph_is_recorded_until_ctrl_c(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path, wait_until: Callable[..., None]
) -> None:
    plot = start_program(
        "tfloom", "tf", "plot", "odom", "base", "--seconds", "60", "--wait", "20", cwd=tmp_path
    )
    start_program("python", Path(__file__).with_name("a_broadcaster.py")).wait_for("broadcasting")
    plot.wait_for("recording for 60 s; Ctrl-C ends it earlier")
    other = start_program(
        "tfloom", "tf", "plot", "odom", "base", "--seconds", "1", "-o", "1.svg", cwd=tmp_path
    )
    assert other.wait() == 0
    assert "1.svg: " in other.output
    plot.signal(signal.SIGINT)
    assert plot.wait() == 0
    samples = int(plot.output.split("tf_plot.png: ")[1].split()[0])
    assert 20 <= samples <= 3000
    assert (tmp_path / "tf_plot.png").read_bytes().startswith(b"\x89PNG")


def test_one_sample_is_drawn(start_program: Callable[..., Any], tmp_path: Path) -> None:
    bag = write_bag(tmp_path / "robot", [recorded(START_NS, transform("map", "base", START_NS))])
    plot = start_program(
        "tfloom", "tf", "plot", "map", "base", "--bag", str(bag), "-o", "1.svg", cwd=tmp_path
    )
    assert plot.wait() == 0, plot.output
    assert plot.lines == ["1.svg: 1 sample in 0.000 s"]
    assert "0 s, 1 sample</text>" in (tmp_path / "1.svg").read_text("utf-8")


def test_static_transforms_are_not_recorded(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    words = ("tfloom", "run", "tf2_ros", "static_transform_publisher")
    start_program(*words, "--frame-id", "base", "--child-frame-id", "laser").wait_for("publishing")
    plot = start_program("tfloom", "tf", "plot", "base", "laser", "--seconds", "1e9", cwd=tmp_path)
    assert plot.wait() == 1
    assert plot.lines == ["laser does not move in base: all transforms between them are static"]


def test_errors_say_what_to_do(bag: Path, start_program: Callable[..., Any], tmp_path: Path) -> None:
    def lines(*words: str) -> str:
        plot = start_program("tfloom", "tf", "plot", *words, cwd=tmp_path)
        assert plot.wait() in {1, 2}
        return str(plot.output)

    (line,) = lines("map", "no where", "--bag", str(bag)).splitlines()
    assert line.endswith(
        f" Try: {shlex.join(['tfloom', 'tf', 'explain', 'map', 'no where', '--bag', str(bag)])}"
    )
    assert "лазер does not move in base: all transforms between them are static" in lines(
        "base", "лазер", "--bag", str(bag)
    )
    assert "'a.jpg' must end in .pdf, .png or .svg" in lines("a", "b", "-o", "a.jpg")
    assert "there is no folder missing" in lines("a", "b", "-o", "missing/a.png")
    assert list(tmp_path.iterdir()) == []
