"""The view that pages share, without a graph: what can't be shown ends in a sentence, and nothing else ends."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from tests.viewer.messages import ARM, camera_info, cloud, depth_image, efforts, header, marker, pose, wrench
from tests.viewer.stages import Stage

from tfloom.interfaces.geometry_msgs.msg import Point, PoseStamped, PoseWithCovariance, WrenchStamped
from tfloom.interfaces.nav_msgs.msg import Odometry
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.tf2.buffer import Buffer
from tfloom.viewer.layout.layout import DisplayLayout, Layout
from tfloom.viewer.page_command import PageError
from tfloom.viewer.shapes import Ball, Box, Lines, Points, Shape

S = 1_000_000_000
HERE = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


# Transforms.


@pytest.mark.parametrize("x", [1e11, 4e12, 1e38, 1e300, 1e304, 1e308, -1.7e308])
def test_transform_of_any_length_is_told_and_drawn_if_a_page_can(stage: Stage, x: float) -> None:
    stage.move("map", "a", x, x / 2.0)
    stage.move("a", "b", x, -x)
    stage.move("map", "near", 1.0, 2.0)
    stage.view.command({"op": "trail", "frame": "b", "on": True})
    for frame in ("map", "b"):
        stage.view.command({"op": "select", "frame": frame})
    state = stage.draw()
    assert stage.reports == []
    assert "At time 2.0" in state["selection"]["text"]
    assert len(state["selection"]["plot"]["x"]) == 2
    for name, array in (
        ("/frames/axes", "batched_positions"),
        ("/frames/arrows", "points"),
        ("/trails/0", "points"),
    ):
        node = stage.node(name)
        assert node is None or np.isfinite(getattr(node, array)).all()
    assert len(stage.node("/frames/axes").batched_positions) == (4 if abs(x) < 1e12 else 2)
    notes = {row["frame"]: row["note"] for row in state["rows"]}
    assert ("not drawn" in notes["a"]) == (abs(x) > 1e12)
    assert "not drawn" not in notes["near"]


@pytest.mark.parametrize("name", ["\ud800", "a\0b", "x" * 100_000, "/map", ""])
def test_frame_of_any_name_can_be_asked_for_at_the_start(stage: Stage, name: str) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.view = stage.view_of(Buffer(), fixed_frame=name)
    stage.draw()
    stage.view.apply(Layout(fixed_frame=name, trails=(name, name, "a"), camera_frame=name))
    state = stage.draw()
    assert stage.reports == []
    assert "a" in state["trails"]


# Trails.


def line(y: float) -> np.ndarray:
    return np.array([[0.0, y, 0.0], [1.0, y, 0.0], [2.0, y, 0.0]])


def test_trail_keeps_its_node_whichever_others_come_and_go(stage: Stage) -> None:
    scene = stage.scene
    scene.draw_trails({"a": line(0.0), "b": line(1.0)})
    scene.draw_trails({"b": line(1.0)})
    kept = stage.node("/trails/1")
    scene.draw_trails({"b": line(1.5), "c": line(2.0)})
    assert stage.node("/trails/1") is kept
    assert [float(stage.node(f"/trails/{number}").points[0, 0, 1]) for number in (0, 1)] == [2.0, 1.5]
    scene.draw_trails({"c": line(3.0), "b": np.empty((0, 3))})
    assert stage.node("/trails/1") is None
    scene.draw_trails({"c": line(3.0), "b": line(4.0), "a": line(5.0)})
    assert [float(stage.node(f"/trails/{number}").points[0, 0, 1]) for number in range(3)] == [3.0, 4.0, 5.0]
    scene.draw_trails({})
    assert [stage.node(f"/trails/{number}") for number in range(3)] == [None] * 3


def test_trails_are_switched_on_and_off_in_any_order(stage: Stage) -> None:
    for frame, x in (("a", 1.0), ("b", 2.0), ("c", 3.0)):
        stage.move("map", frame, x, x + 0.5)
    for number, (frame, on) in enumerate(
        (("a", True), ("b", True), ("a", False), ("c", True), ("a", True), ("b", False), ("c", False))
    ):
        stage.view.command({"op": "trail", "frame": frame, "on": on})
        state = stage.draw()
        nodes = [node for place in range(4) if (node := stage.node(f"/trails/{place}")) is not None]
        firsts = sorted(float(node.points[0, 0, 0]) for node in nodes)
        assert firsts == sorted({"a": 1.0, "b": 2.0, "c": 3.0}[trail] for trail in state["trails"]), number
    assert stage.reports == []


# Parts that fail.


def test_part_that_fails_is_reported_and_ends_no_other(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.move("map", "a", 1.0, 2.0)

    def fail(*_: object, **__: object) -> None:
        raise ZeroDivisionError("a fault")

    for owner, name in (
        (stage.topics, "poll"),
        (stage.view.plots, "poll"),
        (stage.view.plots, "snapshot"),
        (stage.view.plots, "look"),
        (stage.scene, "draw_trails"),
        (stage.scene, "draw_selection"),
        (stage.scene, "draw_marks"),
        (stage.view, "_row"),
        (stage.view, "_plot"),
    ):
        monkeypatch.setattr(owner, name, fail)
    for frame in ("map", "a"):
        stage.view.command({"op": "select", "frame": frame})
    state = stage.draw()
    assert len(stage.node("/frames/axes").batched_positions) == 2
    assert state["frames"] == ["a", "map"]
    assert (state["rows"], state["plots"]) == ([], [])
    assert "ZeroDivisionError: a fault (test_view.py, line " in state["selection"]["text"]
    reported = {report.partition(":")[0] for report in stage.reports}
    assert len(reported) == 8
    assert all("ZeroDivisionError: a fault" in report for report in stage.reports)


def test_nodes_of_a_part_that_failed_are_drawn_again(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.view.command({"op": "trail", "frame": "a", "on": True})
    stage.draw()
    add = server_scene = stage.server.scene
    for name in ("add_line_segments", "add_batched_glb", "add_arrows"):
        add = getattr(server_scene, name)
        with monkeypatch.context() as patch:
            patch.setattr(type(server_scene), name, lambda *_, **__: 1 / 0)
            stage.move("map", name, 1.0, 2.0)
            stage.view.command({"op": "trail", "frame": "a", "on": True})
            stage.view.command({"op": "trail", "frame": name, "on": True})
            stage.draw()
        assert any("ZeroDivisionError" in report for report in stage.reports), add
        stage.reports.clear()
        stage.draw()
        assert stage.reports == []
        assert len(stage.node("/frames/axes").batched_positions) == len(stage.view.buffer.frame_names())
        assert stage.node("/trails/1") is not None


# Displays that fail.


def test_failing_display_keeps_no_old_shapes_and_tries_again_with_the_next_message(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()), S)
    stage.view.set_display("/pose", on=True)
    stage.draw()
    assert len(stage.drawn("/pose")) == 1
    feed = stage.view.feed("/pose")
    assert feed is not None
    calls: list[int] = []

    def fail(now_ns: int) -> None:
        calls.append(now_ns)
        raise ZeroDivisionError("a fault")

    with monkeypatch.context() as patch:
        patch.setattr(feed.display, "shapes", fail)
        stage.draw()
        stage.draw()
        assert len(calls) == 1
        assert "it can't be shown: ZeroDivisionError: a fault" in stage.status("/pose")
        assert stage.drawn("/pose") == []
        stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()), 2 * S)
        stage.draw()
        assert len(calls) == 2
    stage.draw()
    assert stage.drawn("/pose") == []
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()), 3 * S)
    stage.draw()
    assert (len(stage.drawn("/pose")), stage.status("/pose")) == (1, "")


def test_message_that_nobody_thought_of_is_a_sentence_and_the_next_one_is_shown(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()), S)
    stage.view.set_display("/pose", on=True)
    stage.draw()
    feed = stage.view.feed("/pose")
    assert feed is not None
    with monkeypatch.context() as patch:
        patch.setattr(stage.topics.log("/pose"), "_decode", lambda _: 1 / 0)
        stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()), 2 * S)
        stage.draw()
        assert "ZeroDivisionError" in stage.status("/pose")
        assert stage.drawn("/pose") == []
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()), 3 * S)
    stage.draw()
    assert (len(stage.drawn("/pose")), stage.status("/pose")) == (1, "")


BAD: list[Shape] = [
    Box((1.0, float("nan"), 1.0), (0, 0, 0)),
    Ball((float("inf"), 1.0, 1.0), (0, 0, 0)),
    Ball((1e13, 1.0, 1.0), (0, 0, 0)),
    Points(np.array([[0.0, 1e30, 0.0]], np.float32), np.zeros(3, np.uint8)),
    Points(np.zeros((2, 3), np.float32), np.zeros((5, 3), np.uint8)),
    Lines(np.zeros((3, 3), np.float32), np.zeros(3, np.uint8)),
]


@pytest.mark.parametrize("bad", BAD)
def test_shape_that_cant_be_drawn_hides_no_other_and_its_place_is_used_again(
    stage: Stage, bad: Shape
) -> None:
    good: list[Shape] = [Box((1.0, 1.0, 1.0), (0, 0, 0)), Ball((1.0, 1.0, 1.0), (0, 0, 0))]
    draw = stage.scene.draw_display
    for _ in range(2):
        assert draw("/a", [(good[0], HERE), (bad, HERE), (good[1], HERE)])
        assert len(stage.drawn("/a")) == 2
    assert draw("/a", [(shape, HERE) for shape in (good[0], good[1], good[1])]) == ""
    assert len(stage.drawn("/a")) == 3
    assert draw("/a", [(bad, HERE), (bad, HERE)])
    assert stage.drawn("/a") == []
    assert draw("/a", [(good[0], HERE)]) == ""
    assert len(stage.drawn("/a")) == 1
    assert draw("/a", []) == ""
    assert stage.drawn("/a") == []


def test_bad_marker_or_visual_hides_none_of_the_others(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.move("map", "a", 1.0, 2.0)
    bad = marker(Marker.MESH_RESOURCE, 2, mesh_resource="file://[x.stl")
    array = MarkerArray(markers=[marker(Marker.CUBE, 1), bad, marker(Marker.CUBE, 3)])
    stage.topics.add("/markers", array)
    visuals = "".join(
        f"<visual><geometry>{form}</geometry></visual>"
        for form in ('<box size="1 1 1"/>', '<mesh filename="file://[x.stl"/>', '<sphere radius="1e300"/>')
    )
    description = f'<robot name="r"><link name="a">{visuals}</link></robot>'
    stage.topics.add("/robot_description", String(data=description))
    for topic in ("/markers", "/robot_description"):
        stage.view.set_display(topic, on=True)
    state = stage.draw()
    assert len(stage.drawn("/markers")) == 2
    assert len(stage.drawn("/robot_description")) == 1
    rows = {row["topic"]: row["status"] for row in state["displays"]}
    assert "marker 2 of 'test': file://[x.stl is not a URI" in rows["/markers"]
    assert "file://[x.stl is not a URI" in rows["/robot_description"]


def test_lines_and_triangles_that_cant_be_drawn_leave_the_others_as_they_are(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    points = [Point(x=float(x)) for x in (1, 2, 3, np.nan, 5, 6, 7, 1e300, 9, 10)]
    stage.topics.add("/lines", marker(Marker.LINE_LIST, points=points))
    stage.topics.add("/triangles", marker(Marker.TRIANGLE_LIST, points=points))
    for topic in ("/lines", "/triangles"):
        stage.view.set_display(topic, on=True)
    stage.draw()
    (lines,) = stage.drawn("/lines")
    assert lines.points[:, :, 0].tolist() == [[1.0, 2.0], [5.0, 6.0], [9.0, 10.0]]
    (triangles,) = stage.drawn("/triangles")
    assert triangles.vertices[:, 0].tolist() == [1.0, 2.0, 3.0]


def test_frames_too_far_away_hide_what_is_in_them_alone(stage: Stage) -> None:
    stage.move("map", "far", 1e304, 1e305)
    stage.topics.add("/here", PoseStamped(header=header("map"), pose=pose()))
    stage.topics.add("/there", PoseStamped(header=header("far"), pose=pose()))
    for topic in ("/here", "/there"):
        stage.view.set_display(topic, on=True)
    stage.draw()
    assert stage.status("/here") == ""
    assert "further than 1e+12 m from map" in stage.status("/there")
    (there,) = stage.drawn("/there")
    assert not there.visible


# Settings of displays.


def force(x: float, frame: str = "a", sec: int = 1) -> WrenchStamped:
    return wrench((x, 0.0, 0.0), frame=frame, sec=sec)


def lengths(stage: Stage) -> list[float]:
    """Return the lengths of what is drawn, the greatest first."""
    return sorted(
        (round(float(node.vertices[:, 0].max()), 3) for node in stage.drawn("/wrench")), reverse=True
    )


def test_settings_of_a_layout_count_and_are_saved_with_the_display(
    stage: Stage, capsys: pytest.CaptureFixture[str]
) -> None:
    stage.move("map", "a", 1.0, 2.0)
    settings = (("force_color", (1, 2, 3)), ("force_scale", 10.0), ("opacity", 0.5))
    layout = Layout(
        displays=(DisplayLayout("/wrench", "", settings), DisplayLayout("/pose", "", settings[1:]))
    )
    stage.view.apply(layout)
    assert stage.view.layout(None).displays == layout.displays
    stage.topics.add("/wrench", force(2.0))
    stage.topics.add("/pose", PoseStamped(header=header("a"), pose=pose()))
    stage.draw()
    (node,) = stage.drawn("/wrench")
    assert (node.color, node.opacity, node.position[0]) == ((1, 2, 3), 0.5, 1.0)
    assert lengths(stage) == [26.0]
    assert len(stage.drawn("/pose")) == 1
    assert capsys.readouterr().err == (
        "tfloom: force_scale of /pose is not shown: Pose has no setting 'force_scale'\n"
    )
    assert stage.view.layout(None).displays == (
        DisplayLayout("/wrench", "", settings, "Wrench"),
        DisplayLayout("/pose", "", (("opacity", 0.5),), "Pose"),
    )


def test_settings_stay_where_a_topic_is_read_again_and_end_with_the_display(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.view.want("/wrench", settings=(("force_scale", 10.0),))
    stage.topics.add("/wrench", force(2.0))
    stage.draw()
    stage.view.suspend()
    with monkeypatch.context() as patch:
        patch.setattr(stage.topics, "open", lambda *_: 1 / 0)
        stage.view.resume()
    stage.topics.add("/wrench", force(2.0))
    stage.draw()
    stage.topics.add("/wrench", force(3.0), 2 * S)
    stage.draw()
    assert lengths(stage) == [39.0]
    stage.view.set_display("/wrench", on=False)
    stage.view.set_display("/wrench", on=True)
    stage.topics.add("/wrench", force(3.0), 2 * S)
    stage.draw()
    assert lengths(stage) == [7.8]


def test_history_is_that_of_the_time_that_is_shown_and_a_bad_message_hides_no_other(stage: Stage) -> None:
    stage.move("map", "a", *map(float, range(1, 10)))
    stage.view.want("/wrench", settings=(("history", 3), ("force_scale", 10.0)))
    stage.topics.add("/wrench", force(0.0))
    stage.draw()
    assert stage.status("/wrench") == (
        "the wrench can't be drawn: its arrows would be shorter than their width of 0.5"
    )
    for second in range(2, 9):
        size = math.nan if second == 7 else float(second)
        stage.topics.add("/wrench", force(size, sec=second), second * S)
    stage.draw()
    assert (lengths(stage), stage.status("/wrench")) == ([104.0, 78.0], "")
    assert sorted(node.position[0] for node in stage.drawn("/wrench")) == [6.0, 8.0]
    stage.view.command({"op": "hold", "stamp_ns": str(7 * S)})
    stage.draw()
    assert lengths(stage) == [78.0, 65.0]
    assert "its force is not finite" in stage.status("/wrench")
    stage.view.command({"op": "hold", "stamp_ns": str(3 * S)})
    stage.draw()
    assert (lengths(stage), stage.status("/wrench")) == ([39.0, 26.0], "")


def test_wrench_in_a_frame_that_is_not_there_is_a_sentence(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/wrench", force(2.0, "nowhere"))
    stage.view.set_display("/wrench", on=True)
    stage.draw()
    assert [node.visible for node in stage.drawn("/wrench")] == [False]
    assert "nowhere" in stage.status("/wrench")
    assert stage.reports == []


def points(*xs: float, sec: int = 1) -> Any:
    table = np.zeros(len(xs), [("x", "<f4"), ("y", "<f4"), ("z", "<f4")])
    table["x"] = xs
    made = cloud(table, "a")
    made.header.stamp.sec = sec
    return made


def test_setting_acts_at_once_on_what_is_drawn_and_is_saved(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/points", points(0.0, 1.0))
    stage.view.set_display("/points", on=True)
    stage.draw()
    for name, value in (("size", 0.5), ("style", "squares"), ("color_by", "flat"), ("color", [1, 2, 3])):
        stage.view.command({"op": "set", "topic": "/points", "setting": name, "value": value})
    state = stage.draw()
    (node,) = stage.drawn("/points")
    assert (node.point_size, node.point_shape, node.colors.tolist()) == (0.5, "square", [1, 2, 3])
    (row,) = state["displays"]
    assert (row["values"]["size"], row["values"]["color"], row["values"]["opacity"]) == (0.5, [1, 2, 3], 1.0)
    (saved,) = stage.view.layout(None).displays
    assert saved.kind == "PointCloud2"
    assert dict(saved.settings) == {"size": 0.5, "style": "squares", "color_by": "flat", "color": (1, 2, 3)}
    stage.view.command({"op": "set", "topic": "/points", "setting": "opacity", "value": 0.5})
    stage.draw()
    (faint,) = stage.drawn("/points")
    assert (faint.opacity, faint.batched_colors.tolist()) == (0.5, [[1, 2, 3]] * 2)
    for name in dict(saved.settings) | {"opacity": 0}:
        stage.view.command({"op": "set", "topic": "/points", "setting": name, "value": None})
    stage.draw()
    assert stage.view.layout(None).displays == (DisplayLayout("/points", kind="PointCloud2"),)
    (node,) = stage.drawn("/points")
    assert (node.point_size, node.point_shape) == (-0.003, "square")  # 3 pixels


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("size", 1e9, r"size has to be a number from 0\.0001 to 1000, not 1000000000\.0"),
        ("size", [[]], "size has to be a number"),
        ("style", "x" * 5000, "style has to be one of points, spheres, squares, boxes, not 'xxx"),
        ("glow", 1, "PointCloud2 has no setting 'glow'"),
    ],
)
def test_value_that_a_page_cant_set_is_a_sentence_and_changes_nothing(
    stage: Stage, name: str, value: Any, sentence: str
) -> None:
    stage.topics.add("/points", points(0.0))
    stage.view.set_display("/points", on=True)
    with pytest.raises(PageError, match=sentence) as refused:
        stage.view.command({"op": "set", "topic": "/points", "setting": name, "value": value})
    assert len(str(refused.value)) < 200
    with pytest.raises(PageError, match="/none is not shown"):
        stage.view.command({"op": "set", "topic": "/none", "setting": name, "value": value})
    with pytest.raises(PageError, match="TF has no setting 'x'"):
        stage.view.command({"op": "set_frames", "setting": "x", "value": True})
    assert dict(stage.view.layout(None).displays[0].settings) == {}


def test_clouds_decay_and_those_that_stay_keep_their_nodes(stage: Stage) -> None:
    stage.move("map", "a", *map(float, range(1, 8)))
    stage.view.want("/points", settings=(("decay_s", 2.5), ("color_by", "flat")))
    for second in range(1, 5):
        stage.topics.add("/points", points(0.1 * second, sec=second), second * S)
    stage.draw()

    def places() -> list[float]:
        return sorted(round(float(node.points[0, 0]), 1) for node in stage.drawn("/points"))

    assert places() == [2.2, 3.3, 4.4]
    before = [float(node.points[0, 0]) for node in stage.drawn("/points")]
    stage.topics.add("/points", points(0.5, sec=5), 5 * S)
    stage.draw()
    assert places() == [3.3, 4.4, 5.5]
    now = [float(node.points[0, 0]) for node in stage.drawn("/points")]
    assert (
        sum(x == y for x, y in zip(before, now, strict=True)) == 2
    )  # so that pages don't get all of them again
    stage.view.command({"op": "hold", "stamp_ns": str(2 * S)})
    stage.draw()
    assert places() == [1.1, 2.2]
    stage.view.command({"op": "hold", "stamp_ns": None})
    stage.view.command({"op": "set", "topic": "/points", "setting": "decay_s", "value": 0})
    stage.draw()
    assert places() == [5.5]


def test_odometry_is_kept_where_it_has_moved(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    settings = (("history", 3), ("position_tolerance", 0.5), ("speed", False))
    stage.view.want("/odom", settings=settings)
    for number, x in enumerate((0.0, 0.4, 1.0, 1.1, 2.0, 3.0, 3.1)):
        pose_at = PoseWithCovariance(pose=pose(x))
        stage.topics.add("/odom", Odometry(header=header("map"), pose=pose_at), S + number)
    stage.draw()
    assert sorted(node.position[0] for node in stage.drawn("/odom")) == [2.0, 3.0, 3.1]


def test_cloud_by_a_fixed_axis_changes_its_colours_with_its_pose(stage: Stage) -> None:
    stage.move("map", "a", 0.0, 10.0)
    axis = (
        ("color_by", "axis"),
        ("axis", "x"),
        ("axis_auto_range", False),
        ("axis_high", 10.0),
        ("axis_low", 0.0),
    )
    for opacity in (1.0, 0.5):
        stage.view.set_display("/points", on=False)
        stage.view.want("/points", settings=(*axis, ("opacity", opacity)))
        stage.topics.add("/points", points(0.0, sec=1), S)
        stage.view.command({"op": "hold", "stamp_ns": str(S)})
        stage.draw()
        (node,) = stage.drawn("/points")
        colors = node.colors if opacity == 1.0 else node.batched_colors
        assert colors.tolist() == [[255, 0, 0]]
        stage.topics.add("/points", points(0.0, sec=2), 2 * S)
        stage.view.command({"op": "hold", "stamp_ns": None})
        stage.draw()
        (node,) = stage.drawn("/points")
        colors = node.colors if opacity == 1.0 else node.batched_colors
        assert colors.tolist() == [[204, 0, 255]]


def test_topic_is_shown_twice_in_two_ways(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/points", points(0.0, 1.0))
    two = (
        DisplayLayout("/points", "x", (("style", "spheres"), ("size", 0.2)), "PointCloud2"),
        DisplayLayout("/points", "", (("color", (1, 2, 3)), ("color_by", "flat")), "PointCloud2"),
    )
    stage.view.apply(Layout(displays=two))
    state = stage.draw()
    assert [(row["topic"], row["of_topic"]) for row in state["displays"]] == [
        ("/points", "/points"),
        ("/points #2", "/points"),
    ]
    (first,), (second,) = stage.drawn("/points"), stage.drawn("/points #2")
    assert (first.point_size, second.point_size) == (0.2, -0.003)
    assert second.colors.tolist() == [1, 2, 3] != first.colors.tolist()
    assert stage.view.layout(None).displays == two
    stage.view.suspend()
    stage.view.resume()
    stage.topics.add("/points", points(5.0, sec=2), 2 * S)
    stage.draw()
    assert [len(node.points) for node in (*stage.drawn("/points"), *stage.drawn("/points #2"))] == [1, 1]
    stage.view.command({"op": "another", "topic": "/points", "kind": ""})
    stage.view.command({"op": "display", "topic": "/points", "on": False})
    state = stage.draw()
    assert [(row["topic"], row["on"]) for row in state["displays"]] == [
        ("/points", False),
        ("/points #2", True),
        ("/points #3", True),
    ]
    stage.view.command({"op": "another", "topic": "/points", "kind": "PointCloud2"})
    assert stage.draw()["displays"][0]["on"]
    with pytest.raises(PageError, match="there is no topic '/none'"):
        stage.view.command({"op": "another", "topic": "/none", "kind": "PointCloud2"})
    assert all(display.topic != "/none" for display in stage.view.layout(None).displays)


def depth(stage: Stage, topic: str = "/cam/depth") -> list[list[float]]:
    """Return the points of a depth image that are drawn."""
    stage.draw()
    return [point for node in stage.drawn(topic) if node.visible for point in node.points.tolist()]


def test_depth_image_is_a_cloud_by_the_info_beside_it_and_again_when_that_changes(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0, 3.0)
    stage.topics.add("/cam/depth", depth_image([[2.0, 0.0]]))
    stage.view.apply(Layout(displays=(DisplayLayout("/cam/depth", kind="DepthCloud"),)))
    stage.draw()
    assert stage.status("/cam/depth") == (
        "the cloud can't be drawn: nobody publishes its camera info, /cam/camera_info"
    )
    stage.topics.add("/cam/camera_info", camera_info(2, 1))
    assert depth(stage) == [[-1.0, 0.0, 2.0]]
    assert stage.status("/cam/depth") == ""
    stage.topics.add("/cam/camera_info", camera_info(2, 1, focal=4.0, sec=3), 3 * S)
    assert depth(stage) == [[-0.5, 0.0, 2.0]]
    stage.view.command({"op": "hold", "stamp_ns": str(2 * S)})
    assert depth(stage) == [[-1.0, 0.0, 2.0]]
    stage.view.command({"op": "hold", "stamp_ns": None})
    stage.topics.add("/cam/camera_info", camera_info(2, 1, focal=0.0, sec=4), 4 * S)
    assert depth(stage) == []
    assert "the camera info on /cam/camera_info can't be used: it is not calib" in stage.status("/cam/depth")
    stage.topics.add("/cam/camera_info", camera_info(2, 1, sec=5), 5 * S)
    assert depth(stage) == [[-1.0, 0.0, 2.0]]
    assert stage.view.layout(None).displays == (DisplayLayout("/cam/depth", kind="DepthCloud"),)
    assert stage.reports == []


def test_image_that_is_shown_may_be_a_cloud_too(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/cam/depth", depth_image([[2.0, 0.0]]))
    stage.topics.add("/cam/camera_info", camera_info(2, 1))
    stage.view.set_display("/cam/depth", on=True)
    row = next(row for row in stage.draw()["displays"] if row["topic"] == "/cam/depth")
    assert (row["kind"], row["kinds"], row["is_image"]) == ("Image", ["Image", "DepthCloud"], True)
    stage.view.command({"op": "another", "topic": "/cam/depth", "kind": "DepthCloud"})
    assert depth(stage, "/cam/depth #2") == [[-1.0, 0.0, 2.0]]
    assert list(stage.view.image_entries()) == ["/cam/depth"]
    stage.view.command({"op": "set", "topic": "/cam/depth #2", "setting": "color_by", "value": "flat"})
    stage.draw()
    assert [node.colors.tolist() for node in stage.drawn("/cam/depth #2")] == [[255, 255, 255]]


def test_depth_cloud_reads_its_info_only_while_it_is_shown_and_looked_at(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    def add(focal: float = 2.0, second: int = 1) -> None:
        stage.topics.add("/cam/camera_info", camera_info(2, 1, focal, second), second * S)
        stage.topics.add("/cam/depth", depth_image([[2.0, 0.0]], sec=second), second * S)

    stage.move("map", "a", 1.0, 2.0)
    stage.view.want("/cam/depth")
    stage.view._wanted["/cam/depth"] = DisplayLayout("/cam/depth", kind="DepthCloud")
    add()
    assert depth(stage) == [[-1.0, 0.0, 2.0]]
    stage.view.suspend()
    assert stage.topics.logs == {}
    stage.view.resume()
    assert depth(stage) == [[-1.0, 0.0, 2.0]]  # it stays until the first message
    add(4.0)
    assert depth(stage) == [[-0.5, 0.0, 2.0]]
    stage.view.set_display("/cam/depth", on=False)
    assert stage.topics.logs == {}
    stage.view._wanted["/cam/depth"] = DisplayLayout("/cam/depth", kind="DepthCloud")
    add(8.0)
    assert depth(stage) == [[-0.25, 0.0, 2.0]]
    feed = stage.view.feed("/cam/depth")
    assert feed is not None
    feed.forget()  # as where the time of a simulation goes back
    assert stage.topics.logs == {}
    feed.read(stage.topics.open("/cam/depth"))
    stage.topics.add("/cam/depth", depth_image([[2.0, 0.0]]))
    stage.topics.silences["/cam/camera_info"] = "its publisher keeps another policy"
    assert depth(stage) == []
    assert stage.status("/cam/depth").endswith(
        "there is no camera info on /cam/camera_info: its publisher keeps another policy"
    )
    stage.topics.add("/cam/camera_info", camera_info(2, 1))
    assert depth(stage) == [[-1.0, 0.0, 2.0]]
    feed.close()
    opened = stage.topics.open
    with monkeypatch.context() as patch:
        patch.setattr(stage.topics, "open", lambda *_: 1 / 0)
        assert depth(stage) == []
    assert stage.status("/cam/depth").startswith("it can't be shown")
    feed.read(opened("/cam/depth"))
    add(4.0, 2)
    assert depth(stage) == [[-0.5, 0.0, 2.0]]


def effort_lengths(stage: Stage) -> list[float]:
    """Return how far the arrows of the rail's efforts go along its axis."""
    stage.draw()
    nodes = [node for node in stage.drawn("/joint_states") if node.visible]
    return [round(float(node.vertices[:, 1].max()), 3) for node in nodes]


def test_robot_stays_as_it_is_when_its_description_comes_again(stage: Stage) -> None:
    """Each page would get all its meshes again."""
    box = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    text = f'<robot name="r"><link name="base">{box}</link></robot>'
    stage.move("base", "tool", 1.0, 2.0, 3.0)
    stage.topics.add("/robot_description", String(data=text))
    stage.view.set_display("/robot_description", on=True)
    stage.draw()
    (before,) = stage.view.drawn["/robot_description"]
    for second in (2, 3):
        stage.topics.add("/robot_description", String(data=text), second * S)
        stage.draw()
        (after,) = stage.view.drawn["/robot_description"]
        assert after[0] is before[0]
    stage.view.command({"op": "set", "topic": "/robot_description", "setting": "opacity", "value": 0.5})
    stage.draw()
    (after,) = stage.view.drawn["/robot_description"]
    assert getattr(after[0], "opacity", None) == 0.5
    for second in (4, 5):  # one that is none says so each time
        stage.topics.add("/robot_description", String(data="<robot"), second * S)
        stage.draw()
        assert stage.view.drawn["/robot_description"] == []
        assert "it is not a URDF" in stage.status("/robot_description")
    stage.topics.add("/robot_description", String(data=text), 6 * S)
    stage.draw()
    assert len(stage.view.drawn["/robot_description"]) == 1
    assert stage.status("/robot_description") == ""


def test_efforts_are_those_of_the_robot_that_is_described_now(stage: Stage) -> None:
    stage.move("map", "b", 1.0, 2.0)
    stage.topics.add("/joint_states", efforts(rail=2.0))
    stage.view.set_display("/joint_states", on=True)
    stage.draw()
    assert stage.status("/joint_states") == (
        "the effort can't be drawn: nobody publishes its robot description, /robot_description"
    )
    stage.topics.add("/robot_description", String(data=ARM))
    assert effort_lengths(stage) == [0.65]
    stage.topics.add("/robot_description", String(data=ARM.replace('effort="4"', 'effort="2"')))
    assert effort_lengths(stage) == [1.3]
    stage.topics.add("/arm/robot_description", String(data=ARM.replace('effort="4"', 'effort="1"')))
    name = "arm/robot_description"
    stage.view.command({"op": "set", "topic": "/joint_states", "setting": "description", "value": name})
    assert effort_lengths(stage) == [2.6]
    assert "/robot_description" not in stage.topics.logs
    stage.view.command({"op": "set", "topic": "/joint_states", "setting": "description", "value": "none"})
    assert effort_lengths(stage) == []
    assert stage.status("/joint_states").endswith("nobody publishes its robot description, /none")
    stage.view.set_display("/joint_states", on=False)
    assert stage.topics.logs == {}
    stage.view.set_display("/joint_states", on=True)
    stage.topics.add("/joint_states", efforts(rail=2.0))
    stage.topics.add("/robot_description", String(data=ARM))
    assert effort_lengths(stage) == [0.65]
    assert stage.reports == []


def test_axes_and_grid_need_no_topic(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.view.command({"op": "another", "topic": "", "kind": "Axes"})
    stage.view.command({"op": "set", "topic": "Axes", "setting": "frame", "value": "a"})
    stage.view.command({"op": "set", "topic": "Axes", "setting": "length", "value": 3})
    before = stage.view.extent()
    assert stage.node("/floor").visible
    stage.view.command({"op": "another", "topic": "", "kind": "Grid"})
    state = stage.draw()
    assert [(row["topic"], row["kind"], row["status"]) for row in state["displays"]] == [
        ("Axes", "Axes", ""),
        ("Grid", "Grid", ""),
    ]
    (axes,), (grid,) = stage.drawn("Axes"), stage.drawn("Grid")
    assert (axes.batched_scales.tolist(), axes.position[0]) == ([3.0], 2.0)
    assert not stage.node("/floor").visible
    assert before is None or stage.view.extent() is not None
    assert grid.vertices.min(axis=0)[:2] == pytest.approx((-5.0, -5.0), abs=0.01)
    stage.view.command({"op": "set", "topic": "Grid", "setting": "plane", "value": "yz"})
    stage.view.command({"op": "set", "topic": "Grid", "setting": "opacity", "value": 1})
    stage.draw()
    (grid,) = stage.drawn("Grid")
    assert np.abs(grid.points[..., 0]).max() == 0.0
    extent = stage.view.extent()
    assert extent is not None
    assert extent.low[1] > -4.0  # a grid is nothing that a camera goes back for
    layout = stage.view.layout(None)
    stage.view.command({"op": "display", "topic": "Grid", "on": False})
    assert stage.draw()["displays"][-1]["topic"] == "Axes"
    assert stage.node("/floor").visible
    stage.view.apply(layout)
    stage.draw()
    assert stage.view.layout(None).displays == layout.displays
    stage.view.command({"op": "set", "topic": "Axes", "setting": "frame", "value": "nowhere"})
    assert "nowhere" in stage.draw()["displays"][0]["status"]


def test_frames_are_shown_as_set(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.move("a", "b", 1.0, 2.0)
    stage.draw()
    assert len(stage.node("/frames/axes").batched_positions) == 3
    assert len(stage.node("/frames/arrows").points) == 2
    stage.view.command({"op": "set_frames", "setting": "hidden_frames", "value": ["a"]})
    state = stage.draw()
    assert state["frame_settings"]["hidden_frames"] == ["a"]
    assert len(stage.node("/frames/axes").batched_positions) == 2
    assert stage.node("/frames/arrows") is None  # the parent of b is not shown
    stage.view.command({"op": "set_frames", "setting": "hidden_frames", "value": []})
    stage.view.command({"op": "set_frames", "setting": "show_axes", "value": False})
    stage.draw()
    assert stage.node("/frames/axes") is None
    assert len(stage.node("/frames/arrows").points) == 2
    stage.view.command({"op": "set_frames", "setting": "show_arrows", "value": False})
    stage.draw()
    assert stage.node("/frames/arrows") is None
    layout = stage.view.layout(None)
    assert layout.frames == (("show_axes", False), ("show_arrows", False))
    stage.view.command({"op": "set_frames", "setting": "show_axes", "value": None})
    stage.view.apply(layout)
    assert stage.view.layout(None).frames == layout.frames


def test_frame_of_which_nothing_comes_is_hidden_after_the_timeout(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.view.command({"op": "set_frames", "setting": "timeout_s", "value": 3.0})
    stage.draw()
    assert len(stage.node("/frames/axes").batched_positions) == 2
    stage.view._source.now_ns = lambda: 10 * S
    stage.draw()
    grey, fresh = stage.node("/frames/stale"), stage.node("/frames/axes")
    assert grey is None
    assert len(fresh.batched_positions) == 1
