"""Sources that are files: bags of each storage, and files of static transforms."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.bag.recordings import SECOND, START, drive, write_mcap, write_sqlite
from tests.bag.test_ros1 import write as write_ros1

from tfloom.bag.errors import BagError
from tfloom.bag.tf_frames import frames
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.static_file import file_text
from tfloom.tf2_tools.static_transform import StaticTransform
from tfloom.tf2_tools.watch.sources import open_path

BAGS = Path(__file__).parents[2] / "golden" / "bags"


def test_bags_hold_the_edges_that_a_buffer_of_them_holds(tmp_path: Path) -> None:
    paths = [
        BAGS / "mcap",
        BAGS / "sqlite3",
        write_mcap(tmp_path / "drive.mcap", drive(), "zstd"),
        write_sqlite(tmp_path / "drive.db3", drive()),
        write_ros1(tmp_path / "ros1.bag"),
    ]
    wrong = {}
    for path in paths:
        buffer = Buffer(None)
        seen = open_path(path, buffer=buffer).observation()
        found = {
            (
                edge.child,
                edge.parent,
                edge.is_static,
                *_newest(edge.is_static, edge.statistics.newest_stamp_ns),
            )
            for edge in seen.edges
        }
        expected = {
            (edge.child_frame_id, edge.frame_id, edge.is_static, *_newest(edge.is_static, edge.newest_ns))
            for edge in frames(path).edges()
        }
        if found != expected or not found or len(buffer.edges()) != len(expected):
            wrong[path.name] = (found, expected, buffer.edges())
        assert {publisher.label for publisher in seen.publishers} == {str(path)}
        assert 0 < seen.started_ns <= seen.taken_ns
    assert wrong == {}


def _newest(is_static: bool, stamp_ns: int) -> tuple[int, ...]:  # a flag of an edge
    """Return the stamp of an edge that moves, to be compared; a buffer keeps none of a static one."""
    return () if is_static else (stamp_ns,)


def test_a_drive_has_the_rates_that_were_recorded(tmp_path: Path) -> None:
    seen = open_path(write_mcap(tmp_path / "drive.mcap", drive(50))).observation()
    (edge,) = seen.edges_of("base_link")
    assert (edge.statistics.count, round(edge.rate_hz, 3)) == (50, 100.0)
    assert (seen.started_ns, seen.taken_ns) == (START, START + 49 * SECOND // 100)


def test_a_bag_without_transforms_names_those_it_has() -> None:
    with pytest.raises(
        BagError, match=r"neither /robot/tf nor /robot/tf_static; its topics of transforms are: /tf"
    ):
        open_path(BAGS / "mcap", topics=("/robot/tf", "/robot/tf_static"))


def test_a_file_of_statics_is_one_publisher(tmp_path: Path) -> None:
    path = tmp_path / "robot.yaml"
    path.write_text(file_text([StaticTransform("base", "laser", (1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0))]))
    source = open_path(path, buffer=Buffer())
    (edge,) = source.observation().edges
    assert (edge.parent, edge.is_static, edge.publisher.name) == ("base", True, str(path))
    assert source.buffer is not None
    assert source.buffer.lookup("base", "laser").translation == (1.0, 2.0, 3.0)
    assert source.now_ns() == source.observation().taken_ns
