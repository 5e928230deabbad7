"""view_frames in this process: frames with hostile names, and its files."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path

import pytest

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
    assert view_frames.run(node, Namespace(wait_time=0.5, output="out", formats=None)) == 1
    assert "can't draw these frames: " in capfd.readouterr().err
    assert list(tmp_path.iterdir()) == []
