"""Interactive markers: what a server tells, what pages do with them, and what the server hears of it."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import pytest
from tests.conftest import wait_until
from tests.viewer.conftest import Page, running, running_node, spinning
from tests.viewer.messages import header, marker, pose
from tests.viewer.scenes import Scene

from tfloom.interfaces.geometry_msgs.msg import Quaternion, TransformStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerControl,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
    Marker,
    MenuEntry,
)
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy
from tfloom.rmw.backends import open_participant
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.viewer import program
from tfloom.viewer.displays.interactive_markers import InteractiveMarkersDisplay, handle_of
from tfloom.viewer.interactive import markers_feed
from tfloom.viewer.interactive.dragging import Outbox
from tfloom.viewer.interactive.grabs import sight_of
from tfloom.viewer.interactive.markers_feed import MarkersFeed
from tfloom.viewer.live import live_viewer
from tfloom.viewer.program import Viewer
from tfloom_sensing.interactive_marker_server import InteractiveMarkerServer
from tfloom_sensing.menu_handler import MenuHandler

Feedback = InteractiveMarkerFeedback
Control = InteractiveMarkerControl
TOPIC = "/things/update"
HALF = 0.5**0.5


def control(mode: int, name: str = "", *markers: Marker, **fields: Any) -> InteractiveMarkerControl:
    return Control(name=name, interaction_mode=mode, markers=list(markers), **fields)


def local_cube() -> Marker:
    """Return a cube in the frame of its interactive marker."""
    return marker(Marker.CUBE, header=Header())


def thing(name: str = "thing", x: float = 0.0, *controls: Control, **fields: Any) -> InteractiveMarker:
    given = controls or (control(Control.MOVE_AXIS, "move"), control(Control.BUTTON, "push", local_cube()))
    made = InteractiveMarker(
        header=Header(frame_id="map"), name=name, pose=pose(x), scale=1.0, controls=list(given), **fields
    )
    made.pose.orientation.w = 1.0
    return made


# What a server tells, by the numbers of its updates.


def update(number: int, **fields: Any) -> InteractiveMarkerUpdate:
    return InteractiveMarkerUpdate(seq_num=number, type=InteractiveMarkerUpdate.UPDATE, **fields)


@pytest.fixture
def display() -> InteractiveMarkersDisplay:
    made = InteractiveMarkersDisplay({"descriptions": True, "axes": False})
    made.initialize(3, [thing("a"), thing("b", 1.0)])
    return made


def xs(display: InteractiveMarkersDisplay) -> dict[str, float]:
    return {name: known.message.pose.position.x for name, known in display.markers.items()}


def moved(name: str, x: float) -> InteractiveMarkerPose:
    return InteractiveMarkerPose(header=header(), pose=pose(x), name=name)


def test_updates_add_move_and_erase_in_their_order(display: InteractiveMarkersDisplay) -> None:
    display.take(update(4, markers=[thing("c", 2.0)], poses=[moved("a", 5.0), moved("nobody", 1.0)]), 0)
    display.take(update(5, erases=["b", "nobody"]), 0)
    assert xs(display) == {"a": 5.0, "c": 2.0}
    assert not display.needs_all


def test_updates_that_come_while_all_is_asked_for_are_taken_behind_it(
    display: InteractiveMarkersDisplay,
) -> None:
    display.clear()
    for number in (3, 4, 5):
        display.take(update(number, poses=[moved("a", float(number))]), 0)
    assert xs(display) == {}
    display.initialize(4, [thing("a", 4.0)])
    assert xs(display) == {"a": 5.0}
    assert not display.needs_all


@pytest.mark.parametrize("number", [1, 2, 5, 90])
def test_number_that_does_not_follow_asks_for_all_and_the_answer_counts(
    display: InteractiveMarkersDisplay, number: int
) -> None:
    display.take(update(number, poses=[moved("a", 7.0)]), 0)
    assert display.needs_all
    assert xs(display) == {"a": 0.0, "b": 1.0}
    display.initialize(number, [thing("a", 7.0)])
    assert (xs(display), display.needs_all) == ({"a": 7.0}, False)
    display.take(update(number + 1, poses=[moved("a", 8.0)]), 0)
    assert (xs(display), display.needs_all) == ({"a": 8.0}, False)


def test_update_twice_is_one_but_another_one_of_its_number_is_of_another_server(
    display: InteractiveMarkersDisplay,
) -> None:
    display.take(update(4, poses=[moved("a", 4.0)]), 0)
    display.take(update(4, poses=[moved("a", 4.0)]), 0)
    assert not display.needs_all
    display.take(update(4, poses=[moved("a", 9.0)]), 0)
    assert display.needs_all


def test_sign_of_life_of_a_server_whose_number_has_gone_on_asks_for_all(
    display: InteractiveMarkersDisplay,
) -> None:
    alive = InteractiveMarkerUpdate(type=InteractiveMarkerUpdate.KEEP_ALIVE, seq_num=3)
    display.take(alive, 0)
    assert not display.needs_all
    alive.seq_num = 4
    display.take(alive, 0)
    assert display.needs_all


def test_pose_of_the_server_waits_while_a_user_has_the_marker(display: InteractiveMarkersDisplay) -> None:
    known = display.markers["a"]
    known.is_dragged = True
    known.message.pose = pose(3.0)
    display.take(update(4, poses=[moved("a", 9.0)]), 0)
    assert xs(display)["a"] == 3.0
    display.take(update(5, markers=[thing("a", 10.0)]), 0)
    assert xs(display)["a"] == 3.0
    display.markers["a"].release()
    assert xs(display)["a"] == 10.0


def test_shape_that_can_not_be_drawn_is_told_and_hides_no_other(display: InteractiveMarkersDisplay) -> None:
    bad = thing("a", 0.0, control(Control.BUTTON, "b", marker(99), local_cube()))
    display.take(update(4, markers=[bad]), 0)
    assert len(display.parts_of(display.markers["a"])) == 1
    assert display.status == "a shape of 'a' can't be drawn: its type is 99, which is not known"
    display.take(update(5, markers=[thing("a")]), 0)
    assert display.status == ""


def test_each_mode_that_moves_has_its_own_handles() -> None:
    modes = {
        name: handle_of(control(getattr(Control, name)))
        for name in (
            *("NONE", "MENU", "BUTTON", "MOVE_AXIS", "MOVE_PLANE", "ROTATE_AXIS", "MOVE_ROTATE"),
            *("MOVE_3D", "ROTATE_3D", "MOVE_ROTATE_3D"),
        )
    }
    assert [name for name, handle in modes.items() if handle is None] == ["NONE", "MENU", "BUTTON"]
    handles = [handle for handle in modes.values() if handle is not None]
    assert len(set(handles)) == 7


def test_feedback_is_published_one_by_one_with_the_newest_pose_of_each_marker() -> None:
    written: list[tuple[str, int, float]] = []
    outbox = Outbox(lambda said: written.append((said.marker_name, said.event_type, said.pose.position.x)))

    def put(name: str, kind: int, x: float) -> None:
        outbox.put(Feedback(marker_name=name, event_type=kind, pose=pose(x)))

    for x in (1.0, 2.0):
        put("a", Feedback.POSE_UPDATE, x)
        put("b", Feedback.POSE_UPDATE, x)
    put("a", Feedback.MOUSE_UP, 2.0)
    put("a", Feedback.MOUSE_DOWN, 2.0)
    put("a", Feedback.POSE_UPDATE, 3.0)
    outbox.send_one()
    assert written == [("a", Feedback.POSE_UPDATE, 2.0)]
    outbox.flush()
    assert written[1:] == [
        ("b", Feedback.POSE_UPDATE, 2.0),
        ("a", Feedback.MOUSE_UP, 2.0),
        ("a", Feedback.MOUSE_DOWN, 2.0),
        ("a", Feedback.POSE_UPDATE, 3.0),
    ]
    outbox.send_one()
    assert len(written) == 5
    for _ in range(1000):
        put("a", Feedback.BUTTON_CLICK, 0.0)
    outbox.flush()
    assert len(written) == 1005


# On a graph: the server is a node's, the page is one, and its scene says what viser's client says.


class Things:
    """A server of markers, and what it has heard."""

    def __init__(self, node: Node, **options: Any) -> None:
        # The usual one keeps a single message: on a busy machine, nobody could say which ones it hears.
        options = {"feedback_sub_qos": QoSProfile(depth=100), **options}
        self.server = InteractiveMarkerServer(node, "/things", **options)
        self.heard: list[Feedback] = []

    def insert(self, *markers: InteractiveMarker) -> None:
        for made in markers:
            self.server.insert(made, feedback_callback=self.heard.append)
        self.server.applyChanges()

    def types(self, *kinds: int) -> list[int]:
        """Return the types of what was heard, signs of life left out."""
        return [one.event_type for one in list(self.heard) if one.event_type != Feedback.KEEP_ALIVE]


class Hand:
    """The scene of a page, as viser's client: what it drags and clicks; its page says that it is there."""

    def __init__(self, viewer: Viewer, page: Page) -> None:
        self.viewer, self.page = viewer, page
        self.scene = Scene(int(viewer.pages.address.rstrip("/").rpartition(":")[2]), page)
        self.scene.tell_camera()
        self.is_there = True
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._stay)
        self._thread.start()

    def _stay(self) -> None:
        while not self._over.wait(0.05):
            if self.is_there:
                try:
                    self.page.send(op="here")
                except Exception:  # noqa: BLE001  # the page was closed
                    return

    def end(self) -> None:
        self._over.set()
        self._thread.join()
        self.scene.abort()

    def show(self) -> MarkersFeed:
        self.page.wait_for(lambda: self.page.display(TOPIC))
        self.page.send(op="display", topic=TOPIC, on=True)
        wait_until(lambda: self.viewer.view.feed(TOPIC), what="the display")
        feed = self.viewer.view.feed(TOPIC)
        assert isinstance(feed, MarkersFeed)
        wait_until(lambda: feed.markers and self._is_known, what=f"the markers: {feed.status}")
        return feed

    @property
    def _is_known(self) -> bool:
        """Whether viser has the scene, and the viewer has heard of its page."""
        client = self.viewer._server.client_of(self.page.name)
        return self.viewer._is_holding(client)

    def gizmo(self, name: str = "thing", number: int = 0) -> Any:
        feed = self.viewer.view.feed(TOPIC)
        assert isinstance(feed, MarkersFeed)
        wait_until(lambda: (name, number) in feed._gizmos._nodes, what="the gizmo")
        return feed._gizmos._nodes[name, number][2]

    def say(self, kind: str, node: Any, **fields: Any) -> None:
        message = {"type": f"TransformControls{kind}Message", "name": node.name, "owner": "", **fields}
        self.scene.socket.send(msgspec.msgpack.encode(message))

    def grab(self, node: Any) -> None:
        self.say("DragStart", node)

    def move(self, node: Any, x: float, wxyz: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0)) -> None:
        self.say("Update", node, position=(x, 0.0, 0.0), wxyz=wxyz)

    def let_go(self, node: Any) -> None:
        self.say("DragEnd", node)

    def look_down(self) -> None:
        """Have the camera 5 m above the origin, looking down."""
        self.scene.tell_camera(position=(0.0, 0.0, 5.0), wxyz=(0.0, 1.0, 0.0, 0.0))
        client = self.viewer._server.client(self.page.name)
        assert client is not None
        wait_until(lambda: tuple(client.camera.position) == (0.0, 0.0, 5.0), what="the camera")

    def pull(self, phase: str, end: tuple[float, float, float], index: int = 0) -> None:
        """Drag a shape that was grabbed at the origin."""
        number = self.viewer.view._scene._display_numbers[TOPIC]
        message = {
            "type": "SceneNodeDragMessage",
            "phase": phase,
            "name": f"/displays/{number}/{index}",
            "instance_index": None,
            "start_position": (0.0, 0.0, 0.0),
            "start_screen_pos": (0.5, 0.5),
            "end_position": end,
            "end_screen_pos": (0.5, 0.5),
            "button": "left",
            "modifier": None,
            "owner": "",
        }
        self.scene.socket.send(msgspec.msgpack.encode(message))

    def click(self, index: int, modifier: str | None = None) -> None:
        number = self.viewer.view._scene._display_numbers[TOPIC]
        message = {
            "type": "SceneNodeClickMessage",
            "name": f"/displays/{number}/{index}",
            "instance_index": None,
            "ray_origin": (0.0, 0.0, 5.0),
            "ray_direction": (0.0, 0.0, -1.0),
            "screen_pos": (0.25, 0.5),
            "modifier": modifier,
            "owner": "",
        }
        self.scene.socket.send(msgspec.msgpack.encode(message))


@pytest.fixture
def things(spun: Node) -> Iterator[Things]:
    made = Things(spun)
    yield made
    made.server.shutdown()


@pytest.fixture
def hand(viewer: Viewer, page: Page) -> Iterator[Hand]:
    made = Hand(viewer, page)
    yield made
    made.end()


def test_drag_is_told_from_the_press_to_the_release(things: Things, hand: Hand) -> None:
    things.insert(thing(x=0.5))
    hand.show()
    node = hand.gizmo()
    wait_until(lambda: node.position[0] == 0.5, what="the gizmo at its marker")
    hand.grab(node)
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
    hand.move(node, 2.0)
    wait_until(lambda: len(things.types()) == 2, what="a pose")
    hand.move(node, 3.0)
    hand.let_go(node)
    wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
    poses = [one.pose.position.x for one in things.heard if one.event_type == Feedback.POSE_UPDATE]
    assert (poses[0], poses[-1]) == (2.0, 3.0)
    for said in things.heard:
        assert (said.marker_name, said.control_name, said.header.frame_id) == ("thing", "move", "map")
        assert said.client_id == things.heard[0].client_id != ""
    made = things.server.get("thing")
    assert made is not None
    wait_until(lambda: made.pose.position.x == 3.0, what="the server's marker")


@pytest.mark.parametrize("is_shape", [False, True])
def test_end_of_a_drag_counts_where_too_many_events_wait(
    things: Things, hand: Hand, monkeypatch: pytest.MonkeyPatch, is_shape: bool
) -> None:
    things.insert(handled())
    shown_shapes(hand)
    node = hand.gizmo()
    origin = (0.0, 0.0, 0.0)
    hand.pull("start", origin) if is_shape else hand.grab(node)
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
    monkeypatch.setattr(markers_feed, "MAX_EVENTS", 0)
    hand.pull("update", (1.0, 0.0, 0.0)) if is_shape else hand.move(node, 1.0)
    hand.pull("end", origin) if is_shape else hand.let_go(node)
    wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")


def test_marker_that_is_held_still_is_said_to_be_held(things: Things, hand: Hand) -> None:
    things.insert(thing())
    hand.show()
    node = hand.gizmo()
    hand.grab(node)
    wait_until(
        lambda: [one.event_type for one in things.heard].count(Feedback.KEEP_ALIVE) >= 3, what="signs of life"
    )
    assert things.types() == [Feedback.MOUSE_DOWN]
    hand.let_go(node)
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN, Feedback.MOUSE_UP], what="the release")


def test_pose_that_the_server_sets_in_its_callback_counts_when_the_marker_is_let_go(
    things: Things, hand: Hand
) -> None:
    things.insert(thing())
    feed = hand.show()
    things.server.setCallback(
        "thing", lambda said: things.server.setPose("thing", pose(1.0)), Feedback.POSE_UPDATE
    )
    node = hand.gizmo()
    hand.grab(node)
    hand.move(node, 4.0)
    wait_until(lambda: feed.markers["thing"].later is not None, what="the server's pose")
    assert feed.markers["thing"].message.pose.position.x == 4.0
    hand.let_go(node)
    wait_until(lambda: feed.markers["thing"].message.pose.position.x == 1.0, what="the server's pose")
    wait_until(lambda: node.position[0] == 1.0, what="the gizmo there")


def test_turn_of_a_control_that_is_turned_itself_turns_the_marker_by_as_much(
    things: Things, hand: Hand
) -> None:
    about_z = Quaternion(y=-HALF, w=HALF)  # its x axis is upwards
    things.insert(thing("thing", 0.0, control(Control.ROTATE_AXIS, "turn", orientation=about_z)))
    hand.show()
    node = hand.gizmo()
    wait_until(lambda: abs(node.wxyz[2] + HALF) < 1e-9, what="the turned gizmo")
    hand.grab(node)
    # A quarter about z, before the turn of the control.
    hand.move(node, 0.0, (0.5, 0.5, -0.5, 0.5))
    hand.let_go(node)
    wait_until(lambda: things.types()[-1:] == [Feedback.MOUSE_UP], what="the release")
    turn = [one for one in things.heard if one.event_type == Feedback.POSE_UPDATE][-1].pose.orientation
    assert (turn.x, turn.y, turn.z, turn.w) == pytest.approx((0.0, 0.0, HALF, HALF))


@pytest.mark.parametrize("way", ["page", "scene", "silence", "off"])
def test_drag_ends_with_a_release_when_its_page_is_gone(
    things: Things,
    hand: Hand,
    page: Page,
    way: str,
    viewer: Viewer,
    open_page: Callable[[Viewer], Page],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(program, "HERE_S", 0.5)
    things.insert(thing())
    hand.show()
    node = hand.gizmo()
    hand.grab(node)
    hand.move(node, 2.0)
    wait_until(lambda: Feedback.POSE_UPDATE in things.types(), what="a pose")
    if way == "page":
        page.socket.close()
    elif way == "scene":
        hand.scene.abort()
    elif way == "silence":
        hand.is_there = False
    else:
        page.send(op="display", topic=TOPIC, on=False)
    wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
    assert things.types() == [Feedback.MOUSE_DOWN, Feedback.POSE_UPDATE, Feedback.MOUSE_UP]
    # A second page has the marker then.
    second = Hand(viewer, open_page(viewer))
    try:
        second.show()
        other = second.gizmo()
        second.grab(other)
        # The server ignores others for a second after it was told of one.
        places = itertools.count(5)
        wait_until(
            lambda: second.move(other, next(places)) or things.heard[-1].pose.position.x >= 5.0,
            what="the pose of the second page",
        )
        second.let_go(other)
        wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="its release")
    finally:
        second.end()


def test_viewer_that_ends_lets_the_markers_go(
    domain_id: int, things: Things, open_page: Callable[[Viewer], Page]
) -> None:
    things.insert(thing())
    participant = open_participant(domain_id)
    try:
        with live_viewer(participant, topics=("/tf", "/tf_static"), history_s=30.0) as made:
            with running(made):
                hand = Hand(made, open_page(made))
                try:
                    hand.show()
                    hand.grab(hand.gizmo())
                    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
                except BaseException:
                    hand.end()
                    raise
            wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
            hand.end()
    finally:
        participant.close()


def test_page_that_was_lost_moves_nothing_until_it_grabs_again(
    things: Things, hand: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program, "HERE_S", 0.3)
    things.insert(thing())
    hand.show()
    node = hand.gizmo()
    hand.grab(node)
    hand.is_there = False
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN, Feedback.MOUSE_UP], what="the release")
    hand.is_there = True
    wait_until(lambda: hand._is_known, what="the page again")
    hand.move(node, 4.0)
    hand.let_go(node)
    hand.grab(node)
    wait_until(lambda: things.types()[2:] == [Feedback.MOUSE_DOWN], what="the next press")
    hand.let_go(node)
    assert Feedback.POSE_UPDATE not in things.types()


def test_second_page_waits_until_the_first_lets_go(
    things: Things, hand: Hand, viewer: Viewer, open_page: Callable[[Viewer], Page]
) -> None:
    things.insert(thing())
    feed = hand.show()
    node = hand.gizmo()
    second = Hand(viewer, open_page(viewer))
    try:
        wait_until(lambda: second._is_known, what="the second page")
        hand.grab(node)
        wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
        second.grab(node)
        second.move(node, 9.0)
        second.let_go(node)
        hand.move(node, 2.0)
        wait_until(lambda: feed.markers["thing"].message.pose.position.x == 2.0, what="the first one's pose")
        hand.let_go(node)
        wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
        assert {one.client_id for one in things.heard} == {things.heard[0].client_id}
        assert all(one.pose.position.x != 9.0 for one in things.heard)
        wait_until(lambda: node.position[0] == 2.0, what="the gizmo where the first one let it go")
    finally:
        second.end()


def test_marker_that_is_erased_under_the_hand_is_gone_and_may_come_again(things: Things, hand: Hand) -> None:
    things.insert(thing())
    feed = hand.show()
    node = hand.gizmo()
    hand.grab(node)
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
    things.server.erase("thing")
    things.server.applyChanges()
    wait_until(lambda: not feed.markers, what="no marker")
    wait_until(lambda: "has no markers" in feed.status, what="a sentence")
    hand.move(node, 7.0)
    hand.let_go(node)
    things.insert(thing(x=1.0))
    node = hand.gizmo()
    wait_until(lambda: node.position[0] == 1.0, what="the marker again")
    hand.grab(node)
    wait_until(lambda: things.types().count(Feedback.MOUSE_DOWN) == 2, what="the next press")
    hand.let_go(node)


def handled(mode: int = Control.MOVE_AXIS) -> InteractiveMarker:
    return thing(
        "thing", 0.0, control(mode, "move", local_cube()), control(Control.BUTTON, "push", local_cube())
    )


def shown_shapes(hand: Hand) -> MarkersFeed:
    """Show the display, and wait until its shapes are drawn."""
    feed = hand.show()
    hand.look_down()
    wait_until(lambda: len(hand.viewer.view._scene._displays.get(TOPIC, ())) >= 2, what="the nodes")
    hand.gizmo()
    return feed


def test_shape_of_a_control_is_dragged_and_its_gizmo_goes_with_it(things: Things, hand: Hand) -> None:
    things.insert(handled())
    shown_shapes(hand)
    node = hand.gizmo()
    hand.pull("start", (0.0, 0.0, 0.0))
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
    hand.pull("update", (1.0, 0.0, 0.0))
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN, Feedback.POSE_UPDATE], what="a pose")
    wait_until(lambda: node.position[0] == pytest.approx(1.0), what="the gizmo at its marker")
    hand.pull("end", (2.0, 0.5, 0.0))
    wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
    place = things.heard[-1].pose.position
    # Nearest on the axis to what is under the pointer, which is beside it.
    assert place.x == pytest.approx(2.0 * 25.0 / 25.25, rel=1e-6)
    assert (place.y, place.z) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert {said.control_name for said in things.heard} == {"move"}
    # A second life: from where it was let go.
    hand.pull("start", (0.0, 0.0, 0.0))
    hand.pull("end", (-1.0, 0.0, 0.0))
    wait_until(lambda: things.types().count(Feedback.MOUSE_UP) == 2, what="the second release")
    assert things.heard[-1].pose.position.x == pytest.approx(place.x - 1.0)


def test_shape_of_a_button_is_not_dragged_and_what_a_page_invents_moves_nothing(
    things: Things, hand: Hand, viewer: Viewer, open_page: Callable[[Viewer], Page]
) -> None:
    things.insert(handled(Control.MOVE_3D))
    feed = shown_shapes(hand)
    for phase in ("start", "update", "end"):
        hand.pull(phase, (1.0, 0.0, 0.0), 1)  # the button's
        # As it comes when the control was one that moves until a moment ago.
        sight = sight_of((0.0, 0.0, 5.0), (0.0, 1.0, 0.0, 0.0), (1.0, 0.0, 0.0))
        client = hand.viewer._server.client_of(hand.page.name)
        feed._put(markers_feed._Hold(client, 1, phase, sight, (0.0, 0.0, 0.0)))
    hand.pull("update", (1.0, 0.0, 0.0))  # without a start
    for end in ((float("nan"), 0.0, 0.0), (float("inf"), 0.0, 0.0), (1e300, 0.0, 0.0), (0.0, 0.0, 5.0)):
        hand.pull("start", end)
        hand.pull("update", end)
    hand.pull("start", (0.0, 0.0, 0.0))
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
    hand.pull("update", (float("nan"), 0.0, 0.0))
    second = Hand(viewer, open_page(viewer))
    try:
        wait_until(lambda: second._is_known, what="the second page")
        second.look_down()
        second.pull("start", (0.0, 0.0, 0.0))
        second.pull("update", (9.0, 0.0, 0.0))
        second.pull("end", (9.0, 0.0, 0.0))
        hand.pull("update", (0.5, 0.25, 0.0))
        wait_until(
            lambda: feed.markers["thing"].message.pose.position.y == pytest.approx(0.25), what="a pose"
        )
        hand.pull("end", (float("nan"), 0.25, 0.0))  # an end counts, whatever else it says
        wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
        assert {(one.client_id, one.control_name) for one in things.heard} == {
            (things.heard[0].client_id, "move")
        }
        assert all(one.pose.position.x <= 0.5 + 1e-9 for one in things.heard)
    finally:
        second.end()


@pytest.mark.parametrize("way", ["scene", "silence", "erased"])
def test_drag_of_a_shape_ends_with_its_page_or_its_marker(
    things: Things, hand: Hand, way: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program, "HERE_S", 0.5)
    things.insert(handled())
    feed = shown_shapes(hand)
    hand.pull("start", (0.0, 0.0, 0.0))
    hand.pull("update", (1.0, 0.0, 0.0))
    wait_until(lambda: Feedback.POSE_UPDATE in things.types(), what="a pose")
    if way == "erased":
        things.server.erase("thing")
        things.server.applyChanges()
        wait_until(lambda: not feed.markers, what="no marker")
        hand.pull("update", (2.0, 0.0, 0.0))
        things.insert(handled())
        shown_shapes(hand)
        hand.pull("update", (3.0, 0.0, 0.0))  # of the grab that has ended
        hand.pull("start", (0.0, 0.0, 0.0))
        wait_until(lambda: things.types().count(Feedback.MOUSE_DOWN) == 2, what="the next press")
        assert [one.pose.position.x for one in things.heard][-1] == pytest.approx(0.0, abs=1e-9)
        hand.pull("end", (0.0, 0.0, 0.0))
    elif way == "scene":
        hand.scene.abort()
    else:
        hand.is_there = False
    wait_until(lambda: things.types()[-1] == Feedback.MOUSE_UP, what="the release")
    wait_until(lambda: not feed._grabs, what="nothing held")


def test_shape_is_dragged_from_when_its_control_moves_until_it_does_no_longer(
    things: Things, hand: Hand
) -> None:
    things.insert(handled(Control.BUTTON))
    shown = hand.show()
    hand.look_down()
    scene = hand.viewer.view._scene
    wait_until(lambda: len(scene._displays.get(TOPIC, ())) >= 2, what="the nodes")

    def is_dragged() -> bool:
        return bool(scene._displays[TOPIC][0]._handle._impl.drag_cb)

    assert not is_dragged()
    things.insert(handled())
    wait_until(is_dragged, what="a shape that is dragged")
    things.insert(handled(Control.MENU))
    wait_until(lambda: not is_dragged(), what="one that isn't")
    assert shown.status == ""


def test_button_is_pushed_and_menu_is_told_to_the_page(things: Things, hand: Hand, page: Page) -> None:
    made = thing("thing", 0.0, control(Control.BUTTON, "push", local_cube()), description="A thing")
    things.insert(made)
    menu = MenuHandler()
    drive = menu.insert("drive")
    fast = menu.insert("fast", parent=drive, callback=lambda said: chosen.append(said.menu_entry_id))
    menu.setCheckState(fast, MenuHandler.CHECKED)
    chosen: list[int] = []
    menu.apply(things.server, "thing")
    things.server.applyChanges()
    feed = hand.show()
    wait_until(lambda: feed.markers["thing"].message.menu_entries and feed._drawn, what="the shapes")
    wait_until(lambda: hand.viewer.view._scene._displays.get(TOPIC), what="the nodes")
    hand.click(0)
    wait_until(lambda: things.types() == [Feedback.BUTTON_CLICK], what="the push")
    page.answers.clear()
    hand.click(0, "shift")
    told = page.answer("marker_menu")
    assert (told["title"], told["control"], told["at"]) == ("A thing", "push", [0.25, 0.5])
    assert [(entry["id"], entry["parent"], entry["title"]) for entry in told["entries"]] == [
        (drive, 0, "drive"),
        (fast, drive, "[x] fast"),
    ]
    asked = {"op": "marker_menu", "topic": TOPIC, "marker": "thing", "control": "push"}
    assert "no entry" in page.ask("error", **asked, entry=drive)  # it has entries of its own
    assert "no entry" in page.ask("error", **asked, entry=99)
    assert "no marker" in page.ask("error", **{**asked, "marker": "gone"}, entry=fast)
    page.send(**asked, entry=fast)
    wait_until(lambda: chosen == [fast], what="the choice")


def test_command_of_a_menu_is_named_and_not_run(things: Things, hand: Hand, page: Page) -> None:
    entry = MenuEntry(id=1, title="reboot", command="pkg node", command_type=MenuEntry.ROSRUN)
    things.insert(thing(menu_entries=[entry]))
    hand.show()
    said = page.ask("error", op="marker_menu", topic=TOPIC, marker="thing", control="", entry=1)
    assert said == "'reboot' would start a program by rosrun, which a page doesn't do"
    assert things.types() == []


def test_server_that_is_started_again_is_asked_again(
    domain_id: int, things: Things, hand: Hand, spun: Node
) -> None:
    things.insert(thing("old"), thing("thing"))
    feed = hand.show()
    wait_until(lambda: set(feed.markers) == {"old", "thing"}, what="the markers")
    things.server.shutdown()
    wait_until(lambda: not feed.markers, what="the end of the markers")
    with running_node(domain_id, "later") as node, spinning(node):
        later = Things(node)
        later.insert(thing("new", 3.0))
        wait_until(lambda: set(feed.markers) == {"new"} and not feed.status, what="the new server's marker")
        gizmo = hand.gizmo("new")
        hand.grab(gizmo)
        hand.let_go(gizmo)
        wait_until(lambda: later.types() == [Feedback.MOUSE_DOWN, Feedback.MOUSE_UP], what="a drag")


def test_server_that_takes_the_place_of_another_unheard_is_asked(
    domain_id: int, hand: Hand, spun: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    spun.create_publisher(InteractiveMarkerUpdate, TOPIC, 10)  # the topic is published all the time
    with running_node(domain_id, "first") as node, spinning(node):
        first = Things(node)
        first.insert(thing("old"))
        feed = hand.show()
        assert set(feed.markers) == {"old"}
        first.server._is_shut_down = True  # it erases nothing
    later = Things(spun)
    # What it publishes before the viewer is connected with it is lost.
    monkeypatch.setattr(later.server, "publish", lambda _: None)
    later.insert(thing("new"))
    wait_until(lambda: set(feed.markers) == {"new"}, what="the new server's marker")
    later.server.shutdown()


def test_server_that_ends_without_a_word_leaves_no_marker(domain_id: int, hand: Hand) -> None:
    with running_node(domain_id, "brief") as node, spinning(node):
        brief = Things(node)
        brief.insert(thing("thing"))
        feed = hand.show()
        gizmo = hand.gizmo()
        hand.grab(gizmo)
        brief.server._is_shut_down = True  # it erases nothing
    wait_until(lambda: not feed.markers, what="the end of the markers")
    wait_until(lambda: feed.status == f"nobody publishes {TOPIC}", what="the sentence")
    assert feed._dragging._drags == {}


def test_display_that_is_switched_off_and_on_has_its_markers_again(
    things: Things, hand: Hand, page: Page
) -> None:
    things.insert(thing())
    hand.show()
    name = hand.gizmo().name
    page.send(op="display", topic=TOPIC, on=False)
    wait_until(lambda: hand.viewer._server.scene.get_handle_by_name(name) is None, what="no gizmo")
    things.server.setPose("thing", pose(6.0))
    things.server.applyChanges()
    hand.show()
    node = hand.gizmo()
    wait_until(lambda: node.position[0] == 6.0, what="the marker where it is now")
    hand.grab(node)
    hand.let_go(node)
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN, Feedback.MOUSE_UP], what="a drag")


def test_time_that_is_held_ends_a_drag_and_hides_what_could_be_dragged(
    domain_id: int, things: Things, hand: Hand, spun: Node
) -> None:
    frames = TransformBroadcaster(spun)

    def turn(second: int) -> None:
        made = TransformStamped(header=header("map", second), child_frame_id="base")
        made.transform.rotation.w = 1.0
        frames.sendTransform(made)

    wait_until(lambda: spun.count_subscribers("/tf"), what="the viewer")
    things.insert(thing())
    feed = hand.show()
    for second in (100, 101, 102):
        turn(second)
    hand.page.wait_for(lambda: (hand.page.state["span"] or [0, 0])[1] == str(102 * 10**9))
    node = hand.gizmo()
    hand.grab(node)
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN], what="the press")
    hand.page.send(op="hold", stamp_ns=str(101 * 10**9))
    wait_until(lambda: things.types() == [Feedback.MOUSE_DOWN, Feedback.MOUSE_UP], what="the release")
    wait_until(lambda: "can't be dragged at an earlier time" in feed.status, what="the sentence")
    assert feed._gizmos._nodes == {}
    hand.page.send(op="hold", stamp_ns=None)
    wait_until(lambda: feed.status == "", what="the present")
    node = hand.gizmo()
    hand.grab(node)
    hand.let_go(node)
    wait_until(lambda: len(things.types()) == 4, what="another drag")


def test_server_without_a_response_is_named_and_asked_again(
    hand: Hand, spun: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(markers_feed, "RESPONSE_S", 0.3)
    monkeypatch.setattr(markers_feed, "AGAIN_S", 0.1)
    things = Things(spun)
    spun.destroy_service(things.server.get_interactive_markers_srv)
    hand.page.wait_for(lambda: hand.page.display(TOPIC))
    hand.page.send(op="display", topic=TOPIC, on=True)
    said = "there is no server of /things/get_interactive_markers"
    hand.page.wait_for(lambda: hand.page.display(TOPIC)["status"].startswith(said))
    things.insert(thing())
    things.server.get_interactive_markers_srv = spun.create_service(
        GetInteractiveMarkers, "/things/get_interactive_markers", things.server.getInteractiveMarkersCallback
    )
    hand.page.wait_for(lambda: hand.page.display(TOPIC)["status"] == "")
    assert hand.gizmo() is not None
    things.server.shutdown()


def test_server_of_best_effort_is_heard(spun: Node, hand: Hand) -> None:
    loose = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
    things = Things(spun, update_pub_qos=loose)
    things.insert(thing())
    feed = hand.show()
    things.server.setPose("thing", pose(2.0))
    things.server.applyChanges()
    wait_until(lambda: feed.markers["thing"].message.pose.position.x == 2.0, what="the move")
    things.server.shutdown()


def test_marker_in_a_frame_that_nobody_publishes_is_a_sentence(things: Things, hand: Hand) -> None:
    lost = thing("lost")
    lost.header.frame_id = "nowhere"
    things.insert(thing(), lost)
    feed = hand.show()
    hand.page.send(op="fixed_frame", frame="map")
    wait_until(
        lambda: feed.status == "the marker 'lost' is in the frame `nowhere`, which nobody publishes",
        what="the sentence",
    )
    things.server.erase("lost")
    things.server.applyChanges()
    wait_until(lambda: feed.status == "", what="its end")


def test_menu_of_thousands_of_entries_and_a_quaternion_of_no_length_end_nothing(
    things: Things, hand: Hand
) -> None:
    made = thing("thing", 0.0, control(Control.MOVE_3D, "move", orientation=Quaternion(w=0.0)))
    made.menu_entries = [MenuEntry(id=number, title="x") for number in range(1, 3000)]
    bad = thing("bad", 0.0, control(Control.MOVE_3D, "move", orientation=Quaternion(w=float("nan"))))
    things.insert(made, bad)
    feed = hand.show()
    wait_until(lambda: feed.status == "the orientation of a control is not finite", what="the sentence")
    node = hand.gizmo()
    hand.grab(node)
    hand.say("Update", node, position=(float("nan"), 0.0, 0.0), wxyz=(1.0, 0.0, 0.0, 0.0))
    hand.move(node, 1.0)
    hand.let_go(node)
    wait_until(lambda: things.types()[-1:] == [Feedback.MOUSE_UP], what="the release")
    poses = [one.pose.position.x for one in things.heard if one.event_type == Feedback.POSE_UPDATE]
    assert poses == [1.0]
