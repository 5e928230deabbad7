"""What a display says that can't be drawn: a sentence for each cause, which goes as soon as it is drawn again."""

from __future__ import annotations

import numpy as np
import pytest
from tests.conftest import wait_until
from tests.viewer.conftest import HAS_VISER
from tests.viewer.messages import cloud, header, pose
from tests.viewer.test_topic_reader import LOOSE, NODE, RELIABLE, Graph

from tfloom.interfaces.geometry_msgs.msg import PoseArray, PoseStamped
from tfloom.interfaces.std_msgs.msg import ColorRGBA, String
from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerUpdate, Marker
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.viewer import topic_reader
from tfloom.viewer.displays.kinds import KINDS, ROBOT, kind_of
from tfloom.viewer.feed import Feed
from tfloom.viewer.obstacles import THINGS, qos_text
from tfloom.viewer.topic_log import TopicLog

S = 1_000_000_000
STILL = (0.0, 0.0, 0.0, 1.0)
POINTS = np.zeros(3, [("x", "<f4"), ("y", "<f4"), ("z", "<f4")])


def test_each_display_in_the_scene_says_what_it_draws() -> None:
    labels = {kind.label for kind in (*KINDS.values(), ROBOT) if kind.module}
    assert not labels - THINGS.keys(), "a row in THINGS of viewer/obstacles.py"


class Cloud:
    """The display of a cloud, and the transforms."""

    def __init__(self) -> None:
        self.buffer = Buffer(None)
        self.buffer.set_log_callback(None)
        made = cloud(POINTS)
        self.log = TopicLog(3600 * S, lambda data: cdr.decode(type(made), data))
        kind = kind_of("/cloud", made._TYPE_NAME)
        assert kind is not None
        self.feed = Feed("/cloud", kind, self.log.open())

    def put(self, parent: str, child: str, second: float, *, is_static: bool = False) -> None:
        self.buffer.set(parent, child, int(second * S), (0.0, 0.0, 0.0), STILL, static=is_static)

    def take(self, frame: str, second: int) -> None:
        made = cloud(POINTS, frame)
        made.header = header(frame, second)
        self.log.add(second * S, cdr.encode(made))

    def said(self, held_s: float | None = None, fixed: str = "map") -> str:
        """Return the sentence of a picture; it is there whenever the cloud isn't."""
        held_ns = None if held_s is None else int(held_s * S)
        drawn = self.feed.draw(self.buffer, fixed, held_ns, 0)
        is_drawn = bool(drawn) and all(pose is not None for _, pose in drawn)
        assert is_drawn or self.feed.status
        return self.feed.status


@pytest.fixture
def shown() -> Cloud:
    return Cloud()


def test_frame_that_nobody_publishes_is_named_until_it_is_published(shown: Cloud) -> None:
    shown.put("map", "base_link", 1.0)
    shown.take("nowhere", 1)
    assert shown.said() == "the cloud is in the frame `nowhere`, which nobody publishes"
    shown.put("map", "nowhere", 1.0, is_static=True)
    assert shown.said() == ""
    shown.take("base_lnk", 2)
    assert shown.said() == (
        "the cloud is in the frame `base_lnk`, which nobody publishes; did you mean base_link?"
    )
    shown.take("base_link", 3)
    shown.put("map", "base_link", 3.0)
    assert shown.said() == ""


def test_frame_of_thousands_of_characters_leaves_the_sentence_its_end(shown: Cloud) -> None:
    shown.put("map", "a", 1.0)
    shown.take("n" * 3000, 1)
    assert shown.said().endswith("…`, which nobody publishes")


def test_fixed_frame_that_nobody_publishes_is_named(shown: Cloud) -> None:
    shown.put("odom", "laser", 1.0)
    shown.take("laser", 1)
    assert shown.said() == "nobody publishes the fixed frame `map`, and the cloud is in `laser`"
    shown.put("map", "odom", 1.0, is_static=True)
    assert shown.said() == ""


def test_trees_that_are_not_connected_are_named_by_their_roots(shown: Cloud) -> None:
    shown.put("earth", "map", 1.0)
    shown.put("base", "arm", 1.0)
    shown.put("arm", "camera", 1.0)
    shown.take("camera", 1)
    assert shown.said() == (
        "the cloud is in the frame `camera`, which is not connected to the fixed frame `map`: "
        "the root of its tree is `base`, that of the other `earth`"
    )
    shown.put("map", "base", 1.0, is_static=True)
    assert shown.said() == ""


def test_transforms_that_end_before_the_stamp_or_begin_after_it_are_told_with_the_gap(shown: Cloud) -> None:
    for second in range(10, 21):
        shown.put("map", "laser", second)
    shown.take("laser", 20)
    assert shown.said() == ""
    shown.take("laser", 24)
    assert shown.said() == (
        "the cloud is drawn where its frame is at another time: "
        "the transforms of `laser` end 4.00 s before its stamp"
    )
    shown.put("map", "laser", 24.0)
    assert shown.said() == ""
    shown.take("laser", 25)
    shown.put("map", "laser", 24.5)
    assert shown.said() == ""  # they come a little later than the message, as usual
    shown.take("laser", 8)
    assert shown.said(held_s=9.9).startswith(
        "the cloud can't be placed: the transforms of `laser` begin 0.10"
    )
    assert shown.said(held_s=9.9).endswith("0.100 s after the time that is shown")
    assert shown.said(held_s=12.0) == (
        "the cloud is drawn where its frame is at another time: "
        "the transforms of `laser` begin 2.00 s after its stamp"
    )
    shown.take("laser", 21)
    assert shown.said(held_s=22.0) == ""


def test_time_that_is_shown_beyond_the_transforms_is_told_and_goes(shown: Cloud) -> None:
    shown.put("map", "base", 10.0)
    shown.put("map", "base", 11.0)
    shown.put("base", "laser", 10.0)
    shown.put("base", "laser", 14.0)
    shown.take("laser", 13)
    assert shown.said(held_s=13.5) == (
        "the cloud can't be placed: the transforms of `base`, on the way from `laser` to `map` "
        "end 2.50 s before the time that is shown"
    )
    shown.put("map", "base", 14.0)
    assert shown.said(held_s=13.5) == ""


def test_transforms_of_no_common_time_are_told(shown: Cloud) -> None:
    shown.put("map", "base", 10.0)
    shown.put("map", "base", 11.0)
    shown.put("base", "laser", 15.0)
    shown.put("base", "laser", 16.0)
    shown.take("laser", 16)
    said = shown.said()
    assert said.startswith(
        "the cloud can't be placed: the transforms of `laser` begin 4.00 s after the newest"
    )
    shown.put("map", "base", 16.0)
    assert shown.said() == ""


def test_message_with_a_field_that_does_not_fit_is_told_until_the_next_good_one(shown: Cloud) -> None:
    shown.put("map", "laser", 1.0, is_static=True)
    bad = cloud(POINTS, "laser")
    bad.fields[2].name = "depth"
    shown.log.add(1 * S, cdr.encode(bad))
    assert shown.said() == "the cloud can't be drawn: it has no fields x, y and z, but x, y, depth"
    shown.log.add(2 * S, b"\x00\x01\x00\x00short")
    assert shown.said().startswith("the cloud can't be drawn: ")
    shown.take("laser", 3)
    assert shown.said() == ""


def test_policy_that_keeps_a_publisher_away_is_named_only_while_none_is_heard() -> None:
    loose, reliable = (end_with(qos) for qos in (LOOSE, RELIABLE))
    assert qos_text([loose], [RELIABLE]) == (
        "no message passes, because of its quality of service: a publisher: "
        "offered RELIABILITY BEST_EFFORT, requested RELIABILITY RELIABLE"
    )
    assert qos_text([loose, reliable], [RELIABLE]) == ""
    assert qos_text([loose], [RELIABLE, LOOSE]) == ""
    assert qos_text([], [RELIABLE]) == ""


def end_with(qos: QoS) -> EndpointInfo:
    return EndpointInfo(topic_of(String, "/t"), None, True, b"g" * 16, qos)


@pytest.fixture(params=["tfloom_local", pytest.param("rmw_cyclonedds_cpp", marks=pytest.mark.wire)])
def domain(request: pytest.FixtureRequest, domain_id: int, monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setenv("RMW_IMPLEMENTATION", request.param)
    return domain_id


def test_reader_says_which_policy_keeps_its_publishers_away(
    domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(topic_reader, "request_for", lambda _: topic_reader.RELIABLE)
    graph = Graph(domain, String)
    try:
        loose = graph.publish(LOOSE)
        graph.open()
        wait_until(
            lambda: "offered RELIABILITY BEST_EFFORT" in graph.topics.silence("/t", String._TYPE_NAME),
            what="the policy",
        )
        graph.publish(RELIABLE, "heard")
        graph.wait_for("heard")
        assert graph.topics.silence("/t", String._TYPE_NAME) == ""
        loose.close()
    finally:
        graph.topics.close_all()
        for participant in graph.participants:
            participant.close()


def test_topic_of_another_type_than_the_one_that_is_read_is_told(domain: int) -> None:
    graph = Graph(domain, String)
    try:
        writer = graph.publish(RELIABLE)
        graph.open()
        assert graph.topics.silence("/t", String._TYPE_NAME) == ""
        writer.close()
        wait_until(lambda: not graph.sees(writer), what="its end")
        assert graph.topics.silence("/t", String._TYPE_NAME) == ""
        other = graph.participants[1].create_writer(NODE, topic_of(ColorRGBA, "/t"), RELIABLE)
        wait_until(lambda: graph.sees(other), what="the other type")
        assert graph.topics.silence("/t", String._TYPE_NAME) == (
            "its publishers send std_msgs/msg/ColorRGBA, and this display shows std_msgs/msg/String: "
            "switch it off and on to show the other"
        )
        graph.publish(RELIABLE, "again")
        graph.wait_for("again")
        assert graph.topics.silence("/t", String._TYPE_NAME) == ""
    finally:
        graph.topics.close_all()
        for participant in graph.participants:
            participant.close()


if HAS_VISER:
    from tests.viewer.stages import Stage

    from tfloom.viewer.page_command import PageError
    from tfloom.viewer.shared_state import SharedView

    def row_of(stage: Stage, topic: str) -> tuple[str, bool, str] | None:
        rows = stage.draw()["displays"]
        return next(((row["kind"], row["on"], row["status"]) for row in rows if row["topic"] == topic), None)

    def test_display_that_waits_for_its_topic_has_a_row_that_says_so(stage: Stage) -> None:
        stage.move("map", "a", 1.0)
        stage.view.want("/late")
        assert row_of(stage, "/late") == ("", True, "nobody publishes it yet")
        stage.topics.add("/late", PoseStamped(header=header("map"), pose=pose()))
        assert row_of(stage, "/late") == ("Pose", True, "")
        stage.view.set_display("/late", on=False)
        stage.view.want("/later")
        stage.view.set_display("/later", on=False)
        assert row_of(stage, "/later") is None

    def test_topic_that_no_display_shows_says_so_in_its_row_until_it_is_gone(stage: Stage) -> None:
        stage.topics.add("/colors", ColorRGBA())
        assert row_of(stage, "/colors") is None
        stage.view.want("/colors")
        assert row_of(stage, "/colors") == ("", False, "no display shows std_msgs/msg/ColorRGBA")
        with pytest.raises(PageError, match="no display shows"):
            stage.view.set_display("/colors", on=True)
        del stage.topics.classes["/colors"]
        assert row_of(stage, "/colors") is None

    def test_interactive_markers_without_a_graph_are_a_sentence(stage: Stage) -> None:
        stage.topics.add("/things/update", InteractiveMarkerUpdate())
        stage.view.want("/things/update")
        assert row_of(stage, "/things/update") == (
            "InteractiveMarkers",
            False,
            "interactive markers are of a live graph: here is no server of them to be asked",
        )

    def test_what_keeps_messages_away_is_said_also_of_what_is_still_drawn(stage: Stage) -> None:
        stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()))
        stage.view.set_display("/pose", on=True)
        assert row_of(stage, "/pose") == ("Pose", True, "")
        stage.topics.silences["/pose"] = "its publishers send something else"
        assert row_of(stage, "/pose") == ("Pose", True, "its publishers send something else")
        del stage.topics.silences["/pose"]
        assert row_of(stage, "/pose") == ("Pose", True, "")

    def test_topic_whose_publishers_have_gone_says_so_where_nothing_is_drawn(stage: Stage) -> None:
        stage.topics.classes["/pose"] = PoseStamped
        stage.view.set_display("/pose", on=True)
        assert row_of(stage, "/pose") == ("Pose", True, "no message at this time")
        del stage.topics.classes["/pose"]
        assert row_of(stage, "/pose") == ("Pose", True, "nobody publishes it")
        stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()))
        assert row_of(stage, "/pose") == ("Pose", True, "")

    def test_topic_that_has_another_type_when_a_page_opens_again_has_its_display(stage: Stage) -> None:
        stage.topics.add("/pose", PoseStamped(header=header("map"), pose=pose()))
        stage.view.set_display("/pose", on=True)
        view: SharedView = stage.view
        view.suspend()
        stage.topics.logs.clear()
        stage.topics.add("/pose", PoseArray(header=header("map"), poses=[pose()]))
        view.resume()
        assert row_of(stage, "/pose") == ("PoseArray", True, "")

    def test_several_parts_in_frames_that_are_not_there_are_one_sentence(stage: Stage) -> None:
        stage.move("map", "a", 1.0, 2.0)
        for number, frame in enumerate(("gone", "a")):
            stage.topics.add(
                "/marker", Marker(type=Marker.CUBE, id=number, header=header(frame), pose=pose())
            )
        stage.view.set_display("/marker", on=True)
        assert row_of(stage, "/marker") == (
            "Marker",
            True,
            "a marker is in the frame `gone`, which nobody publishes",
        )
        assert len([node for node in stage.drawn("/marker") if node.visible]) == 1
