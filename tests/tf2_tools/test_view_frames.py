"""view_frames in this process: frames with hostile names, and its files."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.tf2_tools.recordings import MS, START_NS, recorded, transform, write_bag

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.node import Node
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_tools import view_frames


@pytest.fixture
def node(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Node]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.chdir(tmp_path)
    init()
    node = Node("view_frames")
    yield node
    node.destroy_node()
    try_shutdown()


def test_a_frame_named_like_a_record_ends_in_a_sentence(
    node: Node, capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    transform = TransformStamped(child_frame_id="child")
    numbers = ("rate: x", "most_recent_transform: 0", "oldest_transform: 0", "buffer_length: 0")
    transform.header.frame_id = "\n  ".join(["p'", "broadcaster: 'b'", *numbers]) + "\n"
    transform.transform.rotation.w = 1.0
    StaticTransformBroadcaster(node).sendTransform(transform)
    assert view_frames.run(node, Namespace(wait_time=0.5, output="out", formats=None, bag=None)) == 1
    assert "can't draw these frames: " in capfd.readouterr().err
    assert list(tmp_path.iterdir()) == []


def bag_with_a_driving_robot(folder: Path) -> Path:
    """Write a recording of a robot that drives for two seconds."""
    messages = [
        recorded(now_ns, transform("odom", "base", now_ns, (i / 10, 0.0, 0.0)))
        for i in range(21)
        for now_ns in [START_NS + i * 100 * MS]
    ]
    messages.append(recorded(START_NS, transform("base", "laser", START_NS), topic="/tf_static"))
    return write_bag(folder / "drive", messages)


def test_the_frames_of_a_bag_are_drawn_without_listening(
    node: Node, capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    bag = bag_with_a_driving_robot(tmp_path)
    options = view_frames.parse_arguments(["--bag", str(bag), "-o", "out", "--format", "json,gv,png"])
    assert view_frames.run(node, options) == 0
    assert "Listening" not in capfd.readouterr().out
    tree = json.loads((tmp_path / "out.json").read_text("utf-8"))
    assert tree["frames"] == ["odom", "base", "laser"]
    assert tree["recorded_at_s"] == START_NS / 1e9 + 2.0
    moving, fixed = tree["transforms"]
    assert (moving["rate_hz"], moving["buffer_length_s"]) == (pytest.approx(10.5, abs=0.1), 2.0)
    assert (moving["publishers"], fixed["state"]) == (["recorded"], "static")
    assert '"odom" -> "base"[label=" Broadcaster: recorded' in (tmp_path / "out.gv").read_text("utf-8")


def test_what_is_no_bag_ends_in_a_sentence(
    node: Node, capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (tmp_path / "text.yaml").write_text("a: b\n")
    for path in ("missing", "text.yaml"):
        assert view_frames.run(node, view_frames.parse_arguments(["--bag", path, "-o", "out"])) == 1
        assert path in capfd.readouterr().err
    assert not (tmp_path / "out.gv").exists()


def test_an_infinite_wait_is_as_long_as_a_clock_can_count() -> None:
    assert [view_frames.parse_arguments(["-t", text]).wait_time for text in ("inf", "1e300", "2.5")] == [
        1e9,
        1e9,
        2.5,
    ]
