"""Sources that are files: bags of each storage, and files of static transforms."""

from __future__ import annotations

from pathlib import Path

import pytest

from tfloom.bag.errors import BagError
from tfloom.bag.tf_frames import frames
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.static_file import StaticTransform, file_text
from tfloom.tf2_tools.watch.sources import open_path

BAGS = Path(__file__).parents[2] / "golden" / "bags"


def test_bags_hold_the_edges_that_a_buffer_of_them_holds() -> None:
    wrong = {}
    for name in ("mcap", "sqlite3"):
        buffer = Buffer(None)
        seen = open_path(BAGS / name, buffer=buffer).observation()
        found = {
            (edge.child, edge.parent, edge.is_static, edge.statistics.newest_stamp_ns) for edge in seen.edges
        }
        expected = {
            (edge.child_frame_id, edge.frame_id, edge.is_static, edge.newest_ns)
            for edge in frames(BAGS / name).edges()
        }
        if {each[:3] for each in found} != {each[:3] for each in expected} or not found:
            wrong[name] = (found, expected)
        if {each for each in found if not each[2]} != {each for each in expected if not each[2]}:
            wrong[name] = (found, expected)
        assert len(buffer.edges()) == len(expected)
        assert {each.label for each in seen.publishers} == {str(BAGS / name)}
        assert 0 < seen.started_ns <= seen.taken_ns
    assert wrong == {}


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
