"""`tfloom tf` names nodes of the real rclpy that publish transforms, and they hear the statics of `tf publish`."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.tf2_tools.static_file import file_text, read_statics
from tfloom.tf2_tools.static_transform import StaticTransform

from .conftest import FROM_US, THEIRS, TO_US, StartEnd
from .test_time_and_transforms import STAMP_NS, STATIC, tf_peer

__all__ = ["tf_peer"]

pytestmark = [pytest.mark.ros, pytest.mark.usefixtures("tf_peer")]


@pytest.mark.row("transforms", direction=TO_US)
def test_a_node_on_fast_dds_is_named(
    start_end: StartEnd, start_program: Callable[..., Any], tmp_path: Path
) -> None:
    theirs = start_end(THEIRS, "their_broadcaster")
    theirs("publisher", "tf_static", "transforms", "/tf_static", STATIC)
    theirs("publish", "tf_static", [["map", "odom", STAMP_NS, 0.5]])
    explain = start_program("tfloom", "tf", "explain", "map", "odom", "--json")
    assert explain.wait() == 0
    (link,) = json.loads(explain.output[explain.output.index("{") :])["chain"]
    assert [publisher["node"] for publisher in link["publishers"]] == ["/their_broadcaster"]
    path = tmp_path / "saved.yaml"
    assert start_program("tfloom", "tf", "save", path).wait() == 0
    assert read_statics(path) == [StaticTransform("map", "odom", (0.5, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))]


@pytest.mark.row("transforms", direction=FROM_US)
def test_published_statics_reach_a_node_on_fast_dds(
    start_end: StartEnd, start_program: Callable[..., Any], wait_until: Callable[..., None], tmp_path: Path
) -> None:
    path = tmp_path / "robot.yaml"
    path.write_text(file_text([StaticTransform("base", "laser", (0.25, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))]))
    start_program("tfloom", "tf", "publish", path).wait_for("until Ctrl-C")
    theirs = start_end(THEIRS, "their_listener")
    theirs("subscription", "tf_static", "transforms", "/tf_static", STATIC)
    wait_until(lambda: bool(theirs("received", "tf_static")), what="the static transforms")
    ((parent, child, _, x),) = theirs("received", "tf_static")[0]
    assert (parent, child, x) == ("base", "laser", 0.25)
