"""What parts of the viewer do after their first life: after `clear`, `close`, `suspend`, `remove` or `forget`."""

from __future__ import annotations

import errno
import io
import sys
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from tests.conftest import wait_until
from tests.viewer.conftest import Page
from tests.viewer.messages import header, marker, pose
from tests.viewer.stages import Stage

from tfloom.interfaces.geometry_msgs.msg import Point32, Pose2D, PoseStamped
from tfloom.interfaces.std_msgs.msg import Float64, String
from tfloom.interfaces.visualization_msgs.msg import Marker
from tfloom.rmw.base import NodeName, Participant, Writer
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.transform import Transform
from tfloom.viewer import scene as scene_module
from tfloom.viewer.displays.kinds import kind_of
from tfloom.viewer.feed import Feed
from tfloom.viewer.frames import FramePoses
from tfloom.viewer.layout.layout import DisplayLayout, Layout, PlotLayout
from tfloom.viewer.page_command import PageError
from tfloom.viewer.plots import plots as plots_module
from tfloom.viewer.plots.plots import MAX_PLOTS, Plots
from tfloom.viewer.plots.series import Series
from tfloom.viewer.program import Viewer
from tfloom.viewer.scene import GREY, YELLOW
from tfloom.viewer.shapes import Box, DisplayError
from tfloom.viewer.topic_log import Cursor
from tfloom.viewer.topics import LiveTopics

S = 1_000_000_000
NODE = NodeName("/", "viewer")
HERE = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


# Series.


def test_series_that_was_cleared_counts_from_nothing() -> None:
    series = Series(10 * S)
    series.add(100 * S, 1.0)
    series.clear()
    assert (len(series), series.span, series.at(None), series.at(100 * S)) == (0, None, None, None)
    assert series.reduced_points(0, 100 * S, 10) == ([], [])
    series.add(5 * S, 2.0)
    series.add(6 * S, 3.0)
    assert (series.span, series.at(None), series.at(5 * S)) == ((5 * S, 6 * S), 3.0, 2.0)


# A display whose topic is read anew.


def test_last_message_stays_until_the_first_one_of_the_second_life(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose(1.0)), 9 * S)
    stage.view.set_display("/pose", on=True)
    stage.draw()
    (node,) = stage.drawn("/pose")
    stage.view.suspend()
    assert "/pose" not in stage.topics.logs
    stage.view.resume()
    stage.draw()
    assert stage.drawn("/pose") == [node]
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose(7.0)), 3 * S)
    stage.draw()
    assert [drawn.position[0] for drawn in stage.drawn("/pose")] == [7.0]


@pytest.mark.parametrize("error", [DisplayError("the wire refuses it"), ZeroDivisionError("a fault")])
def test_display_that_cant_be_read_again_is_shown_as_soon_as_it_can(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    stage.move("map", "a", 1.0, 2.0)
    for topic in ("/one", "/two"):
        stage.topics.add(topic, PoseStamped(header=header("map"), pose=pose()))
        stage.view.set_display(topic, on=True)
    stage.draw()
    feed = stage.view.feed("/one")
    assert feed is not None
    assert feed.display is not None
    feed.display.choice = "a choice"
    stage.view.suspend()
    opened = stage.topics.open

    def refuse(topic: str, depth: int = 0) -> Any:
        if topic == "/one":
            raise error
        return opened(topic, depth)

    with monkeypatch.context() as patch:
        patch.setattr(stage.topics, "open", refuse)
        classes, stage.topics.classes = stage.topics.classes, {"/two": PoseStamped}
        stage.view.resume()
        assert stage.view.feed("/one") is None
        stage.draw()
        assert (len(stage.drawn("/one")), len(stage.drawn("/two"))) == (0, 1)
    stage.topics.classes = classes
    stage.topics.add("/one", PoseStamped(header=header("map"), pose=pose()))
    stage.draw()
    assert len(stage.drawn("/one")) == 1
    again = stage.view.feed("/one")
    assert again is not None
    assert again.display is not None
    assert again.display.choice == "a choice"


def test_display_that_is_switched_off_and_on_shows_nothing_of_before(stage: Stage) -> None:
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/markers", marker(Marker.CUBE, 1))
    stage.view.set_display("/markers", on=True)
    stage.draw()
    assert len(stage.drawn("/markers")) == 1
    for _ in range(2):  # off twice is off
        stage.view.set_display("/markers", on=False)
        assert stage.drawn("/markers") == []
        assert stage.view.feed("/markers") is None
        assert "/markers" not in stage.topics.logs
    stage.view.set_display("/markers", on=True)
    stage.view.set_display("/markers", on=True)  # on twice is on
    stage.draw()
    assert stage.drawn("/markers") == []
    assert stage.status("/markers") == "no message at this time"
    stage.topics.add("/markers", marker(Marker.CUBE, 2))
    stage.draw()
    assert len(stage.drawn("/markers")) == 1


def test_topic_that_is_wanted_and_switched_off_is_not_shown_when_it_comes(stage: Stage) -> None:
    stage.view.want("/pose", "a choice")
    stage.view.set_display("/pose", on=False)
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()))
    stage.draw()
    assert stage.view.feed("/pose") is None


def test_choice_of_a_display_ends_with_it(stage: Stage) -> None:
    stage.view.want("/pose", "a choice")
    stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()))
    stage.draw()
    feed = stage.view.feed("/pose")
    assert isinstance(feed, Feed)
    assert feed.display is not None
    assert feed.display.choice == "a choice"
    stage.view.set_display("/pose", on=False)
    stage.view.set_display("/pose", on=True)
    again = stage.view.feed("/pose")
    assert again is not None
    assert again.display is not None
    assert again.display.choice == ""


# The scene.


def frames(*names: str) -> FramePoses:
    count = len(names)
    turns = np.tile((0.0, 0.0, 0.0, 1.0), (count, 1))
    parents = np.full(count, -1, np.int64)
    if count > 1:
        parents[1:] = 0
    return FramePoses(list(names), np.arange(3.0 * count).reshape(count, 3), turns, parents)


def test_frames_names_arrows_and_marks_come_again_after_they_were_gone(stage: Stage) -> None:
    scene = stage.scene
    for _ in range(3):
        scene.draw_frames(frames("a", "b", "c"), {"c"}, with_names=True)
        scene.draw_marks(np.ones((2, 3)))
        scene.draw_selection([np.zeros(3), np.ones(3)])
        assert len(stage.node("/frames/axes").batched_positions) == 2
        assert len(stage.node("/frames/stale").points) == 3
        assert len(stage.node("/frames/arrows").points) == 2
        assert [scene.named.text_of(name) for name in scene.named.poses.names] == ["a", "b", "c (stale)"]
        places = scene.places({"a", "c"})
        assert stage.node(places["c"]).position == pytest.approx([6.0, 7.0, 8.0])
        assert len(stage.node("/marks").points) == 24
        assert stage.node("/selection") is not None
        scene.draw_frames(frames(), set(), with_names=True)
        scene.draw_marks(np.empty((0, 3)))
        scene.draw_selection([])
        for name in ("/frames/axes", "/frames/stale", "/frames/arrows", "/marks", "/selection"):
            assert stage.node(name) is None
        assert scene.named.poses.names == []
        assert scene.places(set()) == {}
    assert [number for number in range(9) if stage.node(f"/frames/names/{number}")] == [0, 1]  # used again


def test_axes_and_arrows_of_another_length_are_at_the_same_places(stage: Stage) -> None:
    scene = stage.scene
    for length_m in (0.3, 1.0, 1.0, 0.3):
        scene.draw_frames(frames("a", "b"), set(), with_names=False, axes_m=length_m)
        assert stage.node("/frames/axes").batched_scales == pytest.approx([length_m] * 2)
        assert stage.node("/frames/arrows").head_length == pytest.approx(length_m / 5.0)
        assert stage.node("/frames/axes").batched_positions.tolist() == [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]]


def test_arrows_of_very_many_frames_are_spikes_and_few_are_arrows_again(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scene_module, "MAX_ARROWS", 3)
    scene = stage.scene
    many = frames("a", "b", "c", "d", "e")
    for _ in range(2):
        scene.draw_frames(frames("a", "b", "c", "d"), set(), with_names=False)
        assert stage.node("/frames/arrows").head_length > 0.0
        assert stage.node("/frames/spikes") is None
        for behind, more in ((set(), many), ({"c"}, many), (set(), frames(*"abcdefg"))):
            scene.draw_frames(more, behind, with_names=False)
            assert stage.node("/frames/arrows") is None
            spikes = stage.node("/frames/spikes")
            colors = [GREY if name in behind else YELLOW for name in more.names[1:]]
            assert [tuple(color) for color in spikes.batched_colors.tolist()] == colors
            # Each begins at its frame, and its tip is at the parent.
            for number, child in enumerate(more.positions[1:]):
                w, x, y, z = spikes.batched_wxyzs[number].tolist()
                place = Transform(child.tolist(), (x, y, z, w))
                tip = place.apply((float(spikes.batched_scales[number, 0]), 0.0, 0.0))
                assert spikes.batched_positions[number] == pytest.approx(child)
                assert tip == pytest.approx(more.positions[0].tolist(), abs=1e-4)
        scene.draw_frames(many, set(), with_names=False, axes_m=3.0)
        assert stage.node("/frames/spikes").batched_scales[:, 1:] == pytest.approx(0.1)
        scene.draw_frames(many, set(), with_names=False, with_arrows=False)
        assert stage.node("/frames/spikes") is None


def test_shape_that_was_hidden_or_taken_away_is_drawn_again(stage: Stage) -> None:
    box = Box((1.0, 1.0, 1.0), (0, 0, 0))
    draw = stage.scene.draw_display
    for _ in range(2):
        draw("/a", [(box, HERE), (box, None)])
        shown, hidden = stage.drawn("/a")
        assert (shown.visible, hidden.visible) == (True, False)
        draw("/a", [(box, None), (box, HERE)])
        assert (shown.visible, hidden.visible) == (False, True)
        draw("/a", [])
        assert stage.drawn("/a") == []


def test_click_after_frames_are_gone_selects_none_of_them(stage: Stage) -> None:
    clicked: list[str] = []
    stage.scene._on_frame = clicked.append
    stage.scene.draw_frames(frames("a", "b"), set(), with_names=False)
    event = type("Event", (), {"instance_index": 1})()
    stage.scene._clicked(event)
    stage.scene.draw_frames(frames("c"), set(), with_names=False)
    stage.scene._clicked(event)
    assert clicked == ["b"]


# Topics of a graph.


@pytest.fixture
def participant(domain_id: int) -> Iterator[Participant]:
    made = local.open_participant(domain_id)
    made.add_node(NODE)
    yield made
    made.close()


def writer_of(
    participant: Participant, topic: str, message_class: type[Any], *, latched: bool = False
) -> Writer:
    durability = DurabilityPolicy.TRANSIENT_LOCAL if latched else DurabilityPolicy.VOLATILE
    return participant.create_writer(NODE, topic_of(message_class, topic), QoS(durability=durability))


def readers_of(participant: Participant, topic: str) -> int:
    ends = participant.graph.endpoints()
    return sum(not end.is_writer and end.topic.name == topic for end in ends)


def texts(cursor: Cursor) -> list[str]:
    return [entry.message().data for entry in cursor.read()]


def test_topic_that_was_closed_is_read_anew_and_nobody_reads_it_meanwhile(participant: Participant) -> None:
    writer = writer_of(participant, "/text", String)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    first = topics.open("/text")
    writer.write(cdr.encode(String(data="one")))
    topics.poll()
    assert texts(first) == ["one"]
    for _ in range(2):
        first.close()
        assert readers_of(participant, "/text") == 0
    writer.write(cdr.encode(String(data="two")))
    topics.poll()
    second = topics.open("/text")
    assert readers_of(participant, "/text") == 1
    topics.poll()
    assert texts(second) == []
    writer.write(cdr.encode(String(data="three")))
    topics.poll()
    assert (texts(second), texts(first)) == (["three"], [])
    third = topics.open("/text")  # again, without a close
    assert readers_of(participant, "/text") == 1
    second.close()
    assert readers_of(participant, "/text") == 1
    assert texts(third) == ["three"]
    topics.close_all()
    assert readers_of(participant, "/text") == 0
    topics.poll()
    third.close()  # after the end of all


def test_topic_whose_publisher_left_and_came_back_is_told_and_read(participant: Participant) -> None:
    writer = writer_of(participant, "/text", String)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    assert topics.types()["/text"] == "std_msgs/msg/String"
    writer.close()
    assert "/text" not in topics.types()
    with pytest.raises(DisplayError, match="nobody publishes /text"):
        topics.open("/text")
    writer_of(participant, "/text", String)
    assert topics.types()["/text"] == "std_msgs/msg/String"
    topics.open("/text")
    topics.close_all()


def test_display_of_a_page_that_has_gone_is_read_when_the_next_one_comes(
    stage: Stage, participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its command is done after its end."""
    monkeypatch.setattr(stage, "topics", LiveTopics(participant, NODE, 60 * S, lambda: 5 * S))
    stage.move("map", "base", 1.0, 2.0)
    writer_of(participant, "/marker", Marker)
    stage.view.suspend()
    stage.view.set_display("/marker", on=True)
    assert readers_of(participant, "/marker") == 0
    for _ in range(2):
        stage.view.resume()
        stage.draw()
        assert readers_of(participant, "/marker") == 1
    stage.view.suspend()
    assert readers_of(participant, "/marker") == 0


def test_plot_of_a_page_that_has_gone_is_read_when_the_next_one_comes(
    stage: Stage, participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(stage, "topics", LiveTopics(participant, NODE, 60 * S, lambda: 5 * S))
    stage.move("map", "base", 1.0, 2.0)
    writer_of(participant, "/number", Float64)
    stage.view.suspend()
    stage.view.command({"op": "plot", "topic": "/number", "field": "data", "on": True})
    assert readers_of(participant, "/number") == 0
    stage.view.resume()
    stage.draw()
    assert readers_of(participant, "/number") == 1
    stage.view.suspend()
    assert readers_of(participant, "/number") == 0


@pytest.mark.parametrize("failing", ["tfloom.viewer.feed.make_display", "tfloom.viewer.feed.Replay"])
def test_display_that_can_not_be_made_leaves_no_reader(
    failing: str, stage: Stage, participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(stage, "topics", LiveTopics(participant, NODE, 60 * S, lambda: 5 * S))
    stage.move("map", "base", 1.0, 2.0)
    writer_of(participant, "/marker", Marker)
    with monkeypatch.context() as patch:
        patch.setattr(failing, lambda *_: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            stage.view.set_display("/marker", on=True)
    assert readers_of(participant, "/marker") == 0
    stage.view.set_display("/marker", on=True)
    monkeypatch.setattr(failing, lambda *_: 1 / 0)
    if failing.endswith("Replay"):
        stage.view.resume()  # which reads anew
        assert readers_of(participant, "/marker") == 0


def test_topic_that_can_not_be_taken_from_does_not_keep_others_from_being_read(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    writers = [writer_of(participant, topic, String) for topic in ("/one", "/two", "/three")]
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    cursors = [topics.open(topic) for topic in ("/one", "/two", "/three")]
    for writer in writers:
        writer.write(cdr.encode(String(data="said")))
    monkeypatch.setattr(next(iter(topics._logs.values()))[0], "take", lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        topics.poll()
    assert [texts(cursor) for cursor in cursors] == [[], ["said"], ["said"]]
    topics.close_all()


def test_topic_whose_last_publisher_leaves_while_it_is_opened(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer_of(participant, "/text", String)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    graph = topics._read_graph()
    answers = [graph, graph, {}]
    monkeypatch.setattr(topics, "_read_graph", lambda: answers.pop(0) if len(answers) > 1 else answers[0])
    with pytest.raises(DisplayError, match="nobody publishes"):
        topics.open("/text")


# Plots.


def test_plot_that_was_read_says_nothing_when_it_is_read_again(participant: Participant) -> None:
    writer = writer_of(participant, "/number", Float64)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    plots = Plots(topics, 60 * S)
    plots.add("/number", "data")
    assert plots.snapshot(None, None)[0]["status"] == "no message yet"
    writer.write(cdr.encode(Float64(data=1.0)))
    topics.poll()
    plots.poll()
    plots.suspend()
    plots.look()
    assert [(plot["status"], plot["values"]) for plot in plots.snapshot(None, None)] == [("", [1.0])]
    topics.close_all()


def test_plot_whose_field_is_not_in_the_type_of_a_later_publisher_does_not_end_the_others(
    participant: Participant,
) -> None:
    now_ns = [5 * S]
    topics = LiveTopics(participant, NODE, 60 * S, lambda: now_ns[0])
    plots = Plots(topics, 60 * S)
    writer = writer_of(participant, "/place", Pose2D)
    for field in ("x", "theta"):
        plots.add("/place", field)
    plots.suspend()
    writer.close()
    writer = writer_of(participant, "/place", Point32)
    plots.look()
    writer.write(cdr.encode(Point32(x=7.0)))
    topics.poll()
    plots.poll()
    shown = plots.snapshot(None, None)
    assert [plot["values"] for plot in shown] == [[7.0], []]
    assert "has no field theta" in shown[1]["status"]
    topics.close_all()


def test_plot_that_fails_does_not_end_the_others(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer = writer_of(participant, "/pose", PoseStamped)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    plots = Plots(topics, 60 * S)
    for axis in "xy":
        plots.add("/pose", f"pose.position.{axis}")
    number_at = plots_module.number_at
    monkeypatch.setattr(
        plots_module,
        "number_at",
        lambda message, path: 1 / 0 if "x" in str(path) else number_at(message, path),
    )
    writer.write(cdr.encode(PoseStamped(header=header(), pose=pose(1.0, 2.0))))
    topics.poll()
    plots.poll()
    shown = plots.snapshot(None, None)
    assert [plot["values"] for plot in shown] == [[], [2.0]]
    assert "ZeroDivisionError" in shown[0]["status"]
    topics.close_all()


def test_plot_that_was_removed_or_suspended_is_read_again(participant: Participant) -> None:
    writer = writer_of(participant, "/number", Float64)
    now_ns = [1 * S]
    topics = LiveTopics(participant, NODE, 60 * S, lambda: now_ns[0])
    plots = Plots(topics, 60 * S)

    def shown() -> list[Any]:
        now_ns[0] += S
        writer.write(cdr.encode(Float64(data=float(now_ns[0] // S))))
        plots.look()
        topics.poll()
        plots.poll()
        return [plot["values"] for plot in plots.snapshot(None, None)]

    plots.add("/number", "data")
    assert (shown(), shown()) == ([[2.0]], [[2.0, 3.0]])
    plots.suspend()
    assert readers_of(participant, "/number") == 0
    writer.write(cdr.encode(Float64(data=99.0)))
    assert shown()[0][:2] == [2.0, 3.0]  # what was read stays; what came meanwhile is not read
    assert readers_of(participant, "/number") == 1
    assert 99.0 not in shown()[0]
    plots.remove("/number", "data")
    assert readers_of(participant, "/number") == 0
    assert (plots.layout(), plots.snapshot(None, None)) == ((), [])
    plots.remove("/number", "data")
    plots.poll()
    plots.add("/number", "data")
    assert readers_of(participant, "/number") == 1
    assert len(shown()[0]) == 1
    topics.close_all()


def test_numbers_of_before_are_dropped_when_the_clock_of_a_topic_goes_back(participant: Participant) -> None:
    writer = writer_of(participant, "/number", Float64)
    now_ns = [0]
    topics = LiveTopics(participant, NODE, 10 * S, lambda: now_ns[0])
    plots = Plots(topics, 10 * S)
    plots.add("/number", "data")

    def shown(*seconds: int) -> Any:
        for second in seconds:
            now_ns[0] = second * S
            writer.write(cdr.encode(Float64(data=float(second))))
            topics.poll()
        plots.poll()
        return plots.snapshot(None, None)[0]["values"]

    assert shown(100, 101, 102, 95) == [95.0, 100.0, 101.0, 102.0]
    assert shown(50, 51) == [50.0, 51.0]
    plots.clear()
    assert plots.snapshot(None, None)[0]["values"] == []
    assert readers_of(participant, "/number") == 0
    plots.look()
    assert shown(52) == [52.0]
    topics.close_all()


def test_topic_that_is_shown_and_plotted_twice_has_one_reader_and_each_gets_all(
    participant: Participant,
) -> None:
    writer = writer_of(participant, "/pose", PoseStamped)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    plots = Plots(topics, 60 * S)
    kind = kind_of("/pose", "geometry_msgs/msg/PoseStamped")
    assert kind is not None
    buffer = Buffer()

    def publish(second: int) -> None:
        writer.write(cdr.encode(PoseStamped(header=header("map", second), pose=pose(float(second)))))
        topics.poll()
        plots.poll()

    def plotted() -> list[Any]:
        return [plot["values"] for plot in plots.snapshot(None, None)]

    feed = Feed("/pose", kind, topics.open("/pose"))
    publish(1)
    plots.add("/pose", "pose.position.x")
    publish(2)
    plots.add("/pose", "header.stamp.sec")
    publish(3)
    assert readers_of(participant, "/pose") == 1
    assert plotted() == [[1.0, 2.0, 3.0]] * 2  # also what came for the display, before they were plotted
    assert [placed[1][0][0] for placed in feed.draw(buffer, "map", None, 0) if placed[1]] == [3.0]
    assert [placed[1][0][0] for placed in feed.draw(buffer, "map", 2 * S, 0) if placed[1]] == [2.0]
    feed.close()
    publish(4)
    assert (readers_of(participant, "/pose"), plotted()) == (1, [[1.0, 2.0, 3.0, 4.0]] * 2)
    feed.read(topics.open("/pose"))
    plots.suspend()
    assert readers_of(participant, "/pose") == 1
    publish(5)
    plots.look()
    publish(6)
    assert plotted() == [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]] * 2
    feed.close()
    plots.suspend()
    assert readers_of(participant, "/pose") == 0


def test_plot_of_a_topic_goes_on_while_another_one_of_it_is_removed(participant: Participant) -> None:
    writer = writer_of(participant, "/pose", PoseStamped)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: 5 * S)
    plots = Plots(topics, 60 * S)
    for axis in "xy":
        plots.add("/pose", f"pose.position.{axis}")
    plots.remove("/pose", "pose.position.x")
    writer.write(cdr.encode(PoseStamped(header=header(), pose=pose(1.0, 2.0))))
    topics.poll()
    plots.poll()
    assert [plot["values"] for plot in plots.snapshot(None, None)] == [[2.0]]
    plots.remove("/pose", "pose.position.y")
    assert readers_of(participant, "/pose") == 0
    with pytest.raises(PageError, match="has no field nothing"):
        plots.add("/pose", "nothing")
    assert (plots.layout(), readers_of(participant, "/pose")) == ((), 0)
    topics.close_all()


# Pages.


def test_page_that_was_closed_leaves_nothing_and_the_next_one_gets_all(
    viewer: Viewer, open_page: Callable[[Viewer], Page]
) -> None:
    first = open_page(viewer)
    first.send(op="plot_fields", topic="/nothing")
    wait_until(lambda: first.name in viewer._scenes._pages, what="the page's own scene")
    viewer._asked_fields[first.name] = "/nothing"
    viewer._server._clients[first.name] = 77
    first.socket.close()
    wait_until(lambda: not viewer._is_open, what="the page's end")
    wait_until(lambda: first.name not in viewer._scenes._pages, what="the end of its own scene")
    assert first.name not in viewer._asked_fields
    assert first.name not in viewer._server._clients
    assert viewer._server.camera(first.name) is None
    viewer.pages.answer(first.name, {"done": "nobody gets this"})
    second = open_page(viewer)
    assert second.name != first.name
    second.send(op="names", on=False)
    second.wait_for(lambda: second.state["with_names"] is False)
    assert second.answers == []


def test_fault_is_told_again_to_pages_that_come_later(
    viewer: Viewer, open_page: Callable[[Viewer], Page], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(viewer.view, "snapshot", lambda: 1 / 0)

    def notes(page: Page) -> int:
        return sum("ZeroDivisionError" in line["text"] for line in page.log)

    from websockets.sync.client import connect

    address = viewer.pages.address.replace("http://", "ws://") + "api"
    for number in (1, 2):
        with connect(address, max_size=None, proxy=None) as socket:
            page = Page(socket)
            page.wait_for(lambda page=page, number=number: notes(page) == number)
        wait_until(lambda: not viewer._is_open, what="the page's end")
    monkeypatch.undo()
    again = open_page(viewer)
    again.wait_for(lambda: again.log)
    assert notes(again) == 2  # and not with each picture


# A simulation that is reset.


@pytest.mark.parametrize("looks", [True, False])
def test_nothing_of_before_stays_when_a_simulation_is_reset(
    looks: bool, stage: Stage, participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    now_ns = 50 * S
    monkeypatch.setattr(stage, "topics", LiveTopics(participant, NODE, 60 * S, lambda: now_ns))
    stage.move("map", "base", 1.0, 2.0)
    view = stage.view
    monkeypatch.setattr(view._source, "now_ns", lambda: now_ns, raising=False)
    passing = writer_of(participant, "/passing", Marker)
    kept = writer_of(participant, "/kept", Marker, latched=True)
    number = writer_of(participant, "/number", Float64)
    view.plots.add("/number", "data")
    for topic in ("/passing", "/kept"):
        view.set_display(topic, on=True)

    def drawn() -> tuple[int, int]:
        view.look_at_clock()
        stage.draw()
        return len(stage.drawn("/passing")), len(stage.drawn("/kept"))

    def write(*writers: Writer) -> None:
        for writer in writers:
            writer.write(cdr.encode(marker(Marker.CUBE, header=header("map", 0))))

    write(passing, kept)
    number.write(cdr.encode(Float64(data=7.0)))
    assert drawn() == (1, 1)
    now_ns -= 50_000_000  # two messages of /clock that have overtaken each other
    assert drawn() == (1, 1)
    view.command({"op": "hold", "stamp_ns": str(2 * S)})
    if not looks:
        view.suspend()
    now_ns = 1 * S
    view.look_at_clock()
    now_ns = 60 * S  # the new run goes further than the old one did
    view.look_at_clock()
    if not looks:
        view.resume()
    # What is kept for late subscriptions comes again.
    assert drawn() == (0, 1)
    assert stage.status("/passing") == "no message at this time"
    assert view._held_ns is None
    assert view.plots.snapshot(None, None)[0]["values"] == []
    assert set(view.buffer.parents().values()) == {None}
    write(passing)
    assert drawn() == (1, 1)
    view.suspend()


def test_scan_of_before_is_not_shown_after_a_reset(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    now_ns = 50 * S
    stage.topics.add("/pose", PoseStamped(header=header("map", 50), pose=pose()), 50 * S)
    monkeypatch.setattr(stage.view._source, "now_ns", lambda: now_ns, raising=False)
    stage.view.set_display("/pose", on=True)
    stage.view.look_at_clock()
    stage.draw()
    assert stage.drawn("/pose")
    now_ns = 1 * S
    stage.topics.logs.clear()  # what a wire has again: nothing
    stage.view.look_at_clock()
    stage.draw()
    assert stage.drawn("/pose") == []
    assert stage.topics.beginnings == 1
    assert stage.reports == ["the time on /clock has gone back: what is shown begins anew"]


def test_message_of_the_run_before_that_comes_late_does_not_hide_the_new_run(
    participant: Participant, monkeypatch: pytest.MonkeyPatch
) -> None:
    now_ns, now_s = [30 * S], [100.0]
    monkeypatch.setattr("tfloom.viewer.topics.time.monotonic", lambda: now_s[0])
    writer = writer_of(participant, "/pose", PoseStamped)
    latched = writer_of(participant, "/kept", PoseStamped, latched=True)
    topics = LiveTopics(participant, NODE, 60 * S, lambda: now_ns[0])
    topics.poll()
    now_ns[0] = 1 * S
    topics.begin_anew()
    cursors = {topic: topics.open(topic) for topic in ("/pose", "/kept")}

    def newest(topic: str, *seconds: int) -> int:
        for sec in seconds:
            (writer if topic == "/pose" else latched).write(
                cdr.encode(PoseStamped(header=header("map", sec), pose=pose()))
            )
            topics.poll()
        entry = cursors[topic].log.newest(None)
        assert entry is not None
        return entry.stamp_ns // S

    assert newest("/pose", 30, 1, 2) == 1  # those of 30 s, and of 2 s, are ahead of now
    assert newest("/kept", 30) == 30  # it is sent again, for this run
    now_s[0] += 2.0
    assert newest("/pose", 2) == 2  # its publisher's clock is ahead
    topics.close_all()


def test_step_of_the_machines_clock_drops_nothing(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    now_ns = 50 * S
    stage.topics.add("/pose", PoseStamped(header=header("map", 50), pose=pose()), 50 * S)
    view = stage.view_of(Buffer(), is_simulated=False)
    monkeypatch.setattr(view._source, "now_ns", lambda: now_ns, raising=False)
    view.set_display("/pose", on=True)
    view.look_at_clock()
    now_ns = 1 * S
    view.look_at_clock()
    feed = view.feed("/pose")
    assert feed is not None
    assert feed.newest(None) is not None
    assert stage.reports == []


# A program without an stderr.


@pytest.mark.parametrize("stderr", [None, "full"])
def test_layout_is_shown_where_what_is_missing_can_not_be_printed(
    stderr: str | None, stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Full(io.StringIO):
        def write(self, _: str) -> int:
            raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(sys, "stderr", None if stderr is None else Full())
    stage.move("map", "a", 1.0, 2.0)
    stage.topics.add("/strings", String(data="a"))
    many = tuple(PlotLayout("/strings", f"data{number}") for number in range(40))
    stage.view.apply(Layout(plots=many, displays=(DisplayLayout("/strings"),), trails=("a",)))
    stage.view._show_wanted()
    shown = stage.view.layout(None)
    assert (shown.trails, shown.displays, len(shown.plots)) == (("a",), (), MAX_PLOTS)
    assert capsys.readouterr().out == ""
