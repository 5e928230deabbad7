"""The verbs of `tf` on a recording, without a graph."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from tests.bag.recordings import drive, write_mcap

from tfloom.tf2_tools.static_file import file_text, read_statics
from tfloom.tf2_tools.static_transform import StaticTransform

LIDAR = StaticTransform("base_link", "lidar", (0.5, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
Run = Callable[..., tuple[int, str]]


@pytest.fixture
def bag(tmp_path: Path) -> Path:
    """Return the path of a drive of half a second: map -> odom -> base_link at 100 Hz, and a static lidar."""
    return write_mcap(tmp_path / "drive.mcap", drive())


def test_statics_of_a_bag_are_saved_and_compared(run_tf: Run, bag: Path, tmp_path: Path) -> None:
    path = tmp_path / "statics.yaml"
    assert run_tf("save", path, "--bag", bag) == (0, f"{path}: 1 static transform")
    assert read_statics(path) == [LIDAR]
    assert run_tf("diff", bag, path) == (0, "")
    path.write_text(file_text([LIDAR._replace(frame_id="odom")]))
    assert run_tf("diff", bag, path) == (
        1,
        f"--- {bag}\n+++ {path}\n! lidar: its parent was base_link, and is odom",
    )


def test_bags_are_compared_with_their_moving_edges(run_tf: Run, bag: Path, tmp_path: Path) -> None:
    other = write_mcap(tmp_path / "other.mcap", drive(10))
    assert run_tf("diff", bag, other) == (0, "")
    still = write_mcap(
        tmp_path / "still.mcap", [message for message in drive() if message[0] == "/tf_static"]
    )
    assert run_tf("diff", bag, still) == (
        1,
        f"--- {bag}\n+++ {still}\n- odom -> base_link (moving)\n- map -> odom (moving)",
    )


def test_a_lookup_in_a_bag_is_explained(run_tf: Run, bag: Path) -> None:
    code, text = run_tf("explain", "map", "lidar", "--bag", bag)
    assert (code, f"limited by odom -> base_link of {bag}" in text) == (0, True)
    code, text = run_tf("explain", "map", "lidar", "--bag", bag, "--at", "+1")
    assert (code, "The recording has no later one" in text) == (1, True)
    code, text = run_tf("explain", "map", "lidar", "--bag", bag, "--at", "-0.2")
    assert (code, "(0.200 s ago) succeeds" in text) == (0, True)
    late = run_tf("explain", "map", "lidar", "--bag", bag, "--at", "+9000000000")
    assert late == (2, "argument --at: is not a time, because it is beyond the year 2262")


def test_a_bag_that_is_none(run_tf: Run, tmp_path: Path) -> None:
    path = tmp_path / "none.mcap"
    assert run_tf("save", "-", "--bag", path) == (1, f"{path}: there is no such file or folder")
    path.write_bytes(b"no bag")
    code, text = run_tf("explain", "a", "b", "--bag", path)
    assert (code, text.startswith(str(path))) == (1, True)
