"""The viewer of a recording: any time of it, played, and messages as they were then."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from tests.bag.test_ros1 import write
from tests.conftest import wait_until
from tests.tf2_tools.recordings import START_NS, transform
from tests.viewer.conftest import Page, running
from tests.viewer.messages import pose, wrench

from tfloom.bag.errors import BagError
from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.cli.main import main
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import PoseStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.viewer.layout.layout import Layout
from tfloom.viewer.program import Viewer
from tfloom.viewer.recorded import RecordedTopics, recorded_viewer

S = 1_000_000_000


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """100 s of map → base along x by 1 m/s, a pose in base every 10 s, and one odd pose at the start alone."""
    folder = tmp_path / "recording"
    with closing(BagWriter(folder)) as writer:
        tf = writer.add_topic(Topic("/tf", "tf2_msgs/msg/TFMessage"))
        poses = writer.add_topic(Topic("/pose", "geometry_msgs/msg/PoseStamped"))
        once = writer.add_topic(Topic("/once", "geometry_msgs/msg/PoseStamped"))
        for second in range(101):
            stamp_ns = START_NS + second * S
            moved = TFMessage(transforms=[transform("map", "base", stamp_ns, (float(second), 0.0, 0.0))])
            writer.push(tf, cdr.encode(moved), stamp_ns, stamp_ns)
            head = Header(frame_id="base", stamp=Time(sec=stamp_ns // S))
            data = cdr.encode(PoseStamped(header=head, pose=pose()))
            if second % 10 == 0:
                writer.push(poses, data, stamp_ns, stamp_ns)
            if second == 1:
                writer.push(once, data, stamp_ns, stamp_ns)
    return folder


@pytest.fixture
def viewer(recording: Path) -> Iterator[Viewer]:
    with recorded_viewer(recording, topics=("/tf", "/tf_static")) as made, running(made):
        yield made


def place_of(viewer: Viewer, name: str) -> float | None:
    handle = viewer._server.scene.get_handle_by_name(name)
    return None if handle is None else float(handle.position[0])


def test_slider_goes_through_the_whole_recording(viewer: Viewer, page: Page) -> None:
    page.wait_for(lambda: page.row("base") and page.display("/pose"))
    assert page.state["is_live"] is False
    assert page.state["span"] == [str(START_NS), str(START_NS + 100 * S)]
    assert page.state["held_ns"] == str(START_NS)
    page.send(op="display", topic="/pose", on=True)
    page.send(op="hold", stamp_ns=str(START_NS + 57 * S))
    wait_until(lambda: place_of(viewer, "/displays/0/0") == 50.0, what="the pose of second 50")
    axes = viewer._server.scene.get_handle_by_name("/frames/axes")
    wait_until(lambda: np.sort(axes.batched_positions[:, 0]).tolist() == [0.0, 57.0])
    page.send(op="hold", stamp_ns=str(START_NS + 12 * S))
    wait_until(lambda: place_of(viewer, "/displays/0/0") == 10.0, what="the pose of second 10")


def test_recording_is_played_and_stands_at_its_end(page: Page) -> None:
    page.wait_for(lambda: page.state["span"])
    page.send(op="hold", stamp_ns=str(START_NS + 99 * S + S // 2))
    page.send(op="play", on=True)
    page.wait_for(lambda: page.state["is_playing"])
    page.wait_for(lambda: not page.state["is_playing"])
    assert page.state["held_ns"] == str(START_NS + 100 * S)
    assert "this is a recording" in page.ask("error", op="drive", topic="/cmd_vel", ahead=1, left=0)


def test_message_of_a_time_is_found_however_long_it_is_ago(recording: Path) -> None:
    from tfloom.bag.opening import open_bag

    with open_bag(recording) as bag:
        topics = RecordedTopics(bag)
        log = topics.open("/once").log
        assert log.newest(START_NS) is None
        entry = log.newest(START_NS + 99 * S)
        assert entry is not None
        assert entry.stamp_ns == START_NS + S
        assert entry.message().header.frame_id == "base"
        assert log.newest(START_NS + 98 * S) == entry
        many = topics.open("/pose").log
        for second in (0, 5, 9, 10, 11, 42, 100, 3, 99):
            found = many.newest(START_NS + second * S + 1)
            assert found is not None
            assert found.stamp_ns == START_NS + second // 10 * 10 * S


def test_wrenches_of_a_time_are_the_last_ones_before_it(tmp_path: Path) -> None:
    with closing(BagWriter(tmp_path / "wrenches")) as writer:
        tf = writer.add_topic(Topic("/tf", "tf2_msgs/msg/TFMessage"))
        wrenches = writer.add_topic(Topic("/wrench", "geometry_msgs/msg/WrenchStamped"))
        for second in range(21):
            stamp_ns = START_NS + second * S
            moved = TFMessage(transforms=[transform("map", "base", stamp_ns, (float(second), 0.0, 0.0))])
            writer.push(tf, cdr.encode(moved), stamp_ns, stamp_ns)
            data = cdr.encode(wrench((0.0, 0.0, 1.0 + second), frame="base", sec=stamp_ns // S))
            writer.push(wrenches, data, stamp_ns, stamp_ns)
    with recorded_viewer(tmp_path / "wrenches", topics=("/tf", "/tf_static")) as viewer:
        for history, seconds in ((1, [12]), (3, [12, 11, 10]), (50, range(12, -1, -1))):
            viewer.view.set_display("/wrench", on=False)
            viewer.view.want("/wrench", settings=(("history", history),))
            viewer.view._next_look_s = 0.0
            viewer.view.command({"op": "hold", "stamp_ns": str(START_NS + 12 * S + S // 2)})
            viewer.view.draw()
            nodes = [viewer._server.scene.get_handle_by_name(f"/displays/0/{index}") for index in range(14)]
            drawn = [(node.position[0], node.vertices[:, 2].max()) for node in nodes if node is not None]
            assert sorted(drawn, reverse=True) == [
                (second, pytest.approx(2.6 * (1.0 + second))) for second in seconds
            ]


@pytest.fixture
def late_map(tmp_path: Path) -> Path:
    """20 s of odom → base, of which map → odom is known from second 7 on."""
    folder = tmp_path / "late_map"
    with closing(BagWriter(folder)) as writer:
        tf = writer.add_topic(Topic("/tf", "tf2_msgs/msg/TFMessage"))
        for second in range(21):
            stamp_ns = START_NS + second * S
            pairs = [("odom", "base"), ("map", "odom")][: 1 + (second >= 7)]
            moved = TFMessage(transforms=[transform(*pair, stamp_ns, (1.0, 0.0, 0.0)) for pair in pairs])
            writer.push(tf, cdr.encode(moved), stamp_ns, stamp_ns)
    return folder


def shown_s(viewer: Viewer) -> float:
    viewer.view.draw()
    return (int(viewer.view.snapshot()["held_ns"]) - START_NS) / S


def test_recording_begins_where_its_frames_connect(late_map: Path) -> None:
    topics = ("/tf", "/tf_static")
    with recorded_viewer(late_map, topics=topics) as viewer:
        assert shown_s(viewer) == 7.0
        viewer.view.command({"op": "hold", "stamp_ns": str(START_NS)})
        assert shown_s(viewer) == 0.0  # the slider reaches what is before
        viewer.view.command({"op": "hold", "stamp_ns": str(START_NS + 20 * S)})
        viewer.view.command({"op": "play", "on": True})
        assert 7.0 <= shown_s(viewer) < 20.0
    with recorded_viewer(late_map, topics=topics, fixed_frame="odom") as viewer:
        assert shown_s(viewer) == 0.0
    with recorded_viewer(late_map, topics=topics) as viewer:
        viewer.apply(Layout(fixed_frame="odom"))
        assert shown_s(viewer) == 0.0
    with recorded_viewer(late_map, topics=topics, fixed_frame="nowhere") as viewer:
        assert shown_s(viewer) == 0.0
    with recorded_viewer(late_map, topics=topics) as viewer:
        viewer.view.start_after(2.5)
        assert shown_s(viewer) == 2.5
        assert viewer.view.layout(None).start_offset_s == 2.5
        viewer.view.start_after(0.0)
        with pytest.raises(ValueError, match=r"of 20\.000 s"):
            viewer.view.start_after(20.0)


def test_layout_says_where_a_recording_begins(late_map: Path, capfd: pytest.CaptureFixture[str]) -> None:
    for offset_s, begins_s in ((2.5, 2.5), (0.0, 0.0), (99.0, 7.0)):
        with recorded_viewer(late_map, topics=("/tf", "/tf_static")) as viewer:
            viewer.apply(Layout(start_offset_s=offset_s))
            assert shown_s(viewer) == begins_s
            assert viewer.view.layout(None).start_offset_s == offset_s  # as it was read
    text = "the layout's start_offset, 99 s, is not used: the transforms of the recording are of 20.000 s"
    assert capfd.readouterr().err.strip() == f"tfloom: {text}"


@pytest.mark.filterwarnings("ignore::tfloom.bag.errors.BagWarning")
def test_damaged_recording_begins_where_what_is_left_of_it_connects(late_map: Path) -> None:
    (file,) = late_map.glob("*.mcap")
    content = file.read_bytes()
    file.write_bytes(content[: len(content) * 2 // 3])  # cut off, as by a full disk
    with recorded_viewer(file, topics=("/tf", "/tf_static")) as viewer:
        span = viewer.view.snapshot()["span"]
        assert span is not None
        assert START_NS + 7 * S < int(span[1]) < START_NS + 20 * S
        assert shown_s(viewer) == 7.0


def test_what_is_no_recording_is_a_sentence(tmp_path: Path) -> None:
    with (
        pytest.raises(BagError, match="no such file"),
        recorded_viewer(tmp_path / "nothing", topics=("/tf", "/tf_static")),
    ):
        pass


@pytest.mark.parametrize("has_statics", [False, True])
def test_recording_without_moving_transforms_is_shown_by_its_own_times(
    tmp_path: Path, open_page: Callable[[Viewer], Page], has_statics: bool
) -> None:
    with closing(BagWriter(tmp_path / "poses")) as writer:
        poses = writer.add_topic(Topic("/pose", "geometry_msgs/msg/PoseStamped"))
        if has_statics:
            statics = writer.add_topic(Topic("/tf_static", "tf2_msgs/msg/TFMessage"))
            still = TFMessage(transforms=[transform("camera", "lens", START_NS, (0.0, 0.0, 1.0))])
            writer.push(statics, cdr.encode(still), START_NS, START_NS)
        for second in range(11):
            stamp_ns = START_NS + second * S
            head = Header(frame_id="camera", stamp=Time(sec=stamp_ns // S))
            data = cdr.encode(PoseStamped(header=head, pose=pose(x=float(second))))
            writer.push(poses, data, stamp_ns, stamp_ns)
    with recorded_viewer(tmp_path / "poses", topics=("/tf", "/tf_static")) as viewer, running(viewer):
        page = open_page(viewer)
        page.wait_for(lambda: page.display("/pose"))
        assert page.state["span"] == [str(START_NS), str(START_NS + 10 * S)]
        page.send(op="display", topic="/pose", on=True)
        page.send(op="hold", stamp_ns=str(START_NS + 7 * S))
        wait_until(lambda: place_of(viewer, "/displays/0/0") == 7.0, what="the pose of second 7")
        page.wait_for(lambda: page.state["fixed_frame"] == "camera")
        page.send(op="hold", stamp_ns=str(START_NS + 2 * S))
        wait_until(lambda: place_of(viewer, "/displays/0/0") == 2.0, what="the pose of second 2")


def test_transforms_on_other_topics_are_named(tmp_path: Path) -> None:
    with closing(BagWriter(tmp_path / "bag")) as writer:
        writer.add_topic(Topic("/robot1/tf", "tf2_msgs/msg/TFMessage"))
    with (
        pytest.raises(BagError, match="its topics of transforms are: /robot1/tf"),
        recorded_viewer(tmp_path / "bag", topics=("/tf", "/tf_static")),
    ):
        pass


def test_what_is_not_shown_of_a_recording_of_ros1_is_named(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    with recorded_viewer(write(tmp_path / "old.bag"), topics=("/tf", "/tf_static")) as viewer:
        assert "odom" in viewer.view.buffer.parents()
    said = capfd.readouterr().err
    assert f"{tmp_path}/old.bag is of ROS 1: its transforms are shown, and not /chatter." in said
    assert "rosbags-convert" in said


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("nothing",), "nothing: there is no such file or folder"),
        (("one", "--bag", "two"), "two recordings, two and one: the page shows one"),
        (("--start-offset", "3"), "argument --start-offset: only a recording has a start"),
        (("robot.rviz",), "robot.rviz is not a recording; to show a layout: --config robot.rviz"),
    ],
)
def test_recording_is_named_with_or_without_the_option(
    words: tuple[str, ...], text: str, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    assert main(["view", "--no-open", "--port", "0", *words]) == 1
    assert capfd.readouterr().err.strip() == text


def test_start_after_the_end_is_a_sentence(
    late_map: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    assert main(["view", "--no-open", "--port", "0", str(late_map), "--start-offset", "99"]) == 1
    text = "argument --start-offset: 99 s, but the transforms of the recording are of 20.000 s"
    assert capfd.readouterr().err.strip() == text
