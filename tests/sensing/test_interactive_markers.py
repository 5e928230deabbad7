"""Interactive markers: what clients hear and are answered, what users' feedback does, menus; each name."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
from typing import Any

import interactive_markers
import interactive_markers.interactive_marker_server
import interactive_markers.menu_handler
import pytest
from tests.sensing.spinning import spin_until

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.geometry_msgs.msg import Point, Pose
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerFeedback,
    InteractiveMarkerUpdate,
    MenuEntry,
)
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.names import InvalidServiceNameException
from tfloom.node.values.time import Time
from tfloom_sensing.interactive_marker_server import InteractiveMarkerServer, MarkerContext, UpdateContext
from tfloom_sensing.menu_handler import EntryContext, MenuHandler

POSE_UPDATE = InteractiveMarkerFeedback.POSE_UPDATE
MENU_SELECT = InteractiveMarkerFeedback.MENU_SELECT


def marker(name: str, x: float = 0.0, stamp: int = 0) -> InteractiveMarker:
    header = Header(frame_id="map", stamp=TimeMessage(sec=stamp))
    return InteractiveMarker(name=name, header=header, pose=pose(x))


def pose(x: float) -> Pose:
    return Pose(position=Point(x=float(x)))


def feedback(name: str, event_type: int, x: float = 0.0, client: str = "rviz", **fields: Any) -> Any:
    return InteractiveMarkerFeedback(
        marker_name=name, event_type=event_type, client_id=client, pose=pose(x), **fields
    )


class Client:
    """A viewer, as RViz is one."""

    def __init__(self, node: Node, server_node: Node) -> None:
        self.updates: list[InteractiveMarkerUpdate] = []
        node.create_subscription(InteractiveMarkerUpdate, "/things/update", self.updates.append, 100)
        self._feedback = node.create_publisher(InteractiveMarkerFeedback, "/things/feedback", 10)
        self._client = node.create_client(GetInteractiveMarkers, "/things/get_interactive_markers")
        self._executor = SingleThreadedExecutor(context=node.context)
        self._executor.add_node(node)
        self._executor.add_node(server_node)

    def next(self) -> InteractiveMarkerUpdate:
        """Return the next update."""
        spin_until(self._executor, lambda: self.updates)
        return self.updates.pop(0)

    def send(self, message: InteractiveMarkerFeedback) -> None:
        self._feedback.publish(message)

    def ask(self) -> GetInteractiveMarkers.Response:
        """Return all that is there."""
        assert self._client.wait_for_service(10)
        future = self._client.call_async(GetInteractiveMarkers.Request())
        self._executor.spin_until_future_complete(future, 10)
        return future.result()

    def close(self) -> None:
        self._executor.shutdown()


@pytest.fixture
def client(make_node: Callable[..., Node], node: Node) -> Iterator[Client]:
    client = Client(make_node("viewer"), node)
    yield client
    client.close()


@pytest.fixture
def server(node: Node, client: Client) -> Iterator[InteractiveMarkerServer]:
    server = InteractiveMarkerServer(node, "things")
    yield server
    server.shutdown()


def test_markers_come_and_move_and_go(server: InteractiveMarkerServer, client: Client) -> None:
    server.insert(marker("cube", 1))
    server.insert(marker("ball", 2))
    assert len(client.ask().markers) == 0
    server.applyChanges()
    update = client.next()
    assert (update.type, update.seq_num) == (InteractiveMarkerUpdate.UPDATE, 1)
    assert [marker.name for marker in update.markers] == ["cube", "ball"]
    answer = client.ask()
    assert answer.sequence_number == 1
    assert {marker.name: marker.pose.position.x for marker in answer.markers} == {"cube": 1, "ball": 2}

    assert server.setPose("cube", pose(5))
    assert server.setPose("ball", pose(6), Header(frame_id="odom"))
    server.applyChanges()
    update = client.next()
    assert update.seq_num == 2
    assert [(pose.name, pose.pose.position.x, pose.header.frame_id) for pose in update.poses] == [
        ("cube", 5, "map"),
        ("ball", 6, "odom"),
    ]
    assert server.erase("cube")
    server.applyChanges()
    assert client.next().erases == ["cube"]
    server.clear()
    server.applyChanges()
    update = client.next()
    assert (update.seq_num, update.erases) == (4, ["ball"])
    assert len(client.ask().markers) == 0
    server.applyChanges()
    assert server.seq_num == 4


def test_what_is_not_there(server: InteractiveMarkerServer) -> None:
    assert not server.erase("cube")
    assert not server.setPose("cube", pose(1))
    assert not server.setCallback("cube", print)
    assert server.get("cube") is None
    server.insert(marker("cube"))
    assert not server.setPose("cube", pose(1))  # as the reference: it isn't published yet
    assert server.erase("cube")
    server.applyChanges()
    assert server.marker_contexts == {}


def test_get_sees_what_is_pending(server: InteractiveMarkerServer) -> None:
    server.insert(marker("cube", 1))
    assert server.get("cube").pose.position.x == 1
    server.applyChanges()
    assert server.get("cube").pose.position.x == 1
    server.setPose("cube", pose(7), Header(frame_id="odom"))
    seen = server.get("cube")
    assert (seen.pose.position.x, seen.header.frame_id) == (7, "odom")
    assert server.marker_contexts["cube"].int_marker.pose.position.x == 1
    server.erase("cube")
    assert server.get("cube") is None
    server.clear()
    assert server.get("cube") is None
    server.applyChanges()
    assert server.get("cube") is None


def test_a_marker_is_replaced_and_keeps_its_callback(server: InteractiveMarkerServer) -> None:
    got: list[Any] = []
    server.insert(marker("cube", 1), feedback_callback=got.append)
    server.applyChanges()
    server.insert(marker("cube", 2))
    server.applyChanges()
    server.processFeedback(feedback("cube", MENU_SELECT))
    assert len(got) == 1
    assert server.get("cube").pose.position.x == 2


def test_feedback_moves_and_calls_back(server: InteractiveMarkerServer, client: Client) -> None:
    got: list[tuple[str, float]] = []
    server.insert(
        marker("cube", 1), feedback_callback=lambda feedback: got.append(("any", feedback.pose.position.x))
    )
    server.setCallback("cube", lambda feedback: got.append(("menu", feedback.menu_entry_id)), MENU_SELECT)
    server.applyChanges()
    client.next()
    client.send(feedback("cube", POSE_UPDATE, 9, header=Header(frame_id="elsewhere")))
    (moved,) = client.next().poses
    assert (moved.name, moved.pose.position.x, moved.header.frame_id) == ("cube", 9, "map")
    assert got == [("any", 9)]
    server.processFeedback(feedback("cube", MENU_SELECT, menu_entry_id=3))
    assert got[1:] == [("menu", 3)]
    server.setCallback("cube", None, MENU_SELECT)
    server.setCallback("cube", None, MENU_SELECT)
    server.processFeedback(feedback("cube", MENU_SELECT, 4))
    assert got[2:] == [("any", 4)]
    server.setCallback("cube", None)
    server.processFeedback(feedback("cube", MENU_SELECT, 5))
    server.processFeedback(feedback("ghost", MENU_SELECT))
    assert len(got) == 3


def test_a_stamped_marker_takes_the_header_of_the_feedback(server: InteractiveMarkerServer) -> None:
    server.insert(marker("cube", 1, stamp=5))
    server.applyChanges()
    server.processFeedback(feedback("cube", POSE_UPDATE, 2, header=Header(frame_id="odom")))
    assert server.get("cube").header.frame_id == "odom"


def test_feedback_beside_a_pending_change(server: InteractiveMarkerServer) -> None:
    server.insert(marker("cube", 1))
    server.applyChanges()
    server.insert(marker("cube", 2))
    server.processFeedback(feedback("cube", POSE_UPDATE, 3))
    assert server.get("cube").pose.position.x == 3


def test_a_callback_may_use_the_server(server: InteractiveMarkerServer, client: Client) -> None:
    server.insert(marker("button"), feedback_callback=lambda _each: server.erase("button"))
    server.applyChanges()
    client.next()
    client.send(feedback("button", InteractiveMarkerFeedback.BUTTON_CLICK))
    assert client.next().erases == ["button"]


def test_two_clients_take_turns(server: InteractiveMarkerServer, monkeypatch: pytest.MonkeyPatch) -> None:
    got: list[str] = []
    server.insert(marker("cube"), feedback_callback=lambda feedback: got.append(feedback.client_id))
    server.applyChanges()
    seconds = [100.0]
    monkeypatch.setattr(
        type(server.node.get_clock()),
        "now",
        lambda self: Time(seconds=seconds[0], clock_type=self.clock_type),
    )
    server.marker_contexts["cube"].last_feedback = server.node.get_clock().now()
    for client, after in (("first", 0.1), ("second", 0.5), ("first", 0.1), ("second", 1.1)):
        seconds[0] += after
        server.processFeedback(feedback("cube", MENU_SELECT, client=client))
    assert got == ["first", "first", "second"]


def test_shutdown_takes_all_away(node: Node, client: Client) -> None:
    before = (len(list(node.publishers)), len(list(node.subscriptions)), len(list(node.services)))
    server = InteractiveMarkerServer(
        node, "things", update_pub_qos=QoSProfile(depth=7), feedback_sub_qos=QoSProfile(depth=3)
    )
    assert server.update_pub.qos_profile.depth == 7
    assert server.feedback_sub.qos_profile.depth == 3
    server.insert(marker("cube"))
    server.applyChanges()
    client.next()
    for _ in range(2):
        server.shutdown()
    assert client.next().erases == ["cube"]
    assert (len(list(node.publishers)), len(list(node.subscriptions)), len(list(node.services))) == before


def test_a_server_that_never_was_ends_quietly(node: Node) -> None:
    with pytest.raises(InvalidServiceNameException):
        InteractiveMarkerServer(node, "no such name")
    gc.collect()


def test_contexts() -> None:
    context, update = MarkerContext(Time(seconds=3)), UpdateContext()
    assert (context.last_feedback.nanoseconds, context.last_client_id) == (3_000_000_000, "")
    assert update.update_type == UpdateContext.FULL_UPDATE
    assert (UpdateContext.POSE_UPDATE, UpdateContext.ERASE) == (1, 2)


def test_do_set_pose(server: InteractiveMarkerServer) -> None:
    server.insert(marker("cube"))
    server.applyChanges()
    server.doSetPose(None, "cube", pose(4), Header(frame_id="odom"))
    assert server.pending_updates["cube"].update_type == UpdateContext.POSE_UPDATE
    assert server.get("cube").pose.position.x == 4


def test_a_menu(server: InteractiveMarkerServer, capsys: pytest.CaptureFixture[str]) -> None:
    menu, got = MenuHandler(), []
    drive = menu.insert("Drive")
    fast = menu.insert(
        "Fast", parent=drive, callback=lambda feedback: got.append(("fast", feedback.marker_name))
    )
    menu.insert("Run", parent=drive, command_type=MenuEntry.ROSRUN, command="turtlesim turtlesim_node")
    hidden = menu.insert("Hidden", callback=got.append)
    menu.insert("Below", parent=hidden)
    silent = menu.insert("Silent")
    assert menu.setVisible(hidden, False)
    assert menu.setCheckState(fast, MenuHandler.CHECKED)
    assert menu.setCheckState(silent, MenuHandler.UNCHECKED)
    assert (menu.getTitle(fast), menu.getCheckState(fast), menu.getCheckState(drive)) == ("Fast", 1, 0)
    assert menu.insert("Lost", parent=99) is None
    assert capsys.readouterr().err == "Parent menu entry '99' not found\n"
    assert not menu.setVisible(99, True)
    assert not menu.setCheckState(99, 1)
    assert menu.getCheckState(99) is menu.getTitle(99) is None

    assert not menu.apply(server, "cube")
    server.insert(marker("cube"))
    assert menu.apply(server, "cube")
    server.applyChanges()
    entries = server.get("cube").menu_entries
    assert [
        (entry.title, entry.id, entry.parent_id, entry.command_type, entry.command) for entry in entries
    ] == [
        ("Drive", drive, 0, MenuEntry.FEEDBACK, ""),
        ("[x] Fast", fast, drive, MenuEntry.FEEDBACK, ""),
        ("Run", fast + 1, drive, MenuEntry.ROSRUN, "turtlesim turtlesim_node"),
        ("[ ] Silent", silent, 0, MenuEntry.FEEDBACK, ""),
    ]
    for handle in (fast, silent, 99):
        server.processFeedback(feedback("cube", MENU_SELECT, menu_entry_id=handle))
    assert got == [("fast", "cube")]


def test_a_menu_is_applied_again(server: InteractiveMarkerServer, client: Client) -> None:
    menu = MenuHandler()
    entry = menu.insert("Light")
    for name in ("a", "b"):
        server.insert(marker(name))
        menu.apply(server, name)
    server.applyChanges()
    client.next()
    menu.setCheckState(entry, MenuHandler.CHECKED)
    assert menu.reApply(server)
    server.applyChanges()
    assert {marker.name: marker.menu_entries[0].title for marker in client.next().markers} == {
        "a": "[x] Light",
        "b": "[x] Light",
    }
    server.erase("a")
    server.applyChanges()
    assert not menu.reApply(server)
    assert menu.managed_markers_ == {"b"}
    assert menu.reApply(server)


def test_parts_of_a_menu(capsys: pytest.CaptureFixture[str]) -> None:
    menu = MenuHandler()
    handle = menu.doInsert("Loose", MenuEntry.FEEDBACK, "", None)
    assert menu.top_level_handles_ == []
    entries: list[MenuEntry] = []
    assert menu.pushMenuEntries([handle], entries, 0)
    assert [entry.title for entry in entries] == ["Loose"]
    assert not menu.pushMenuEntries([99, handle], entries, 0)
    assert "context handle not found" in capsys.readouterr().err
    context = EntryContext()
    context.title, context.check_state = "Box", MenuHandler.UNCHECKED
    assert menu.makeEntry(context, 7, 2) == MenuEntry(id=7, parent_id=2, title="[ ] Box")


def test_the_package_hands_on() -> None:
    assert interactive_markers.InteractiveMarkerServer is InteractiveMarkerServer
    assert interactive_markers.MenuHandler is MenuHandler
    server, menu = interactive_markers.interactive_marker_server, interactive_markers.menu_handler
    assert (server.MarkerContext, server.UpdateContext) == (MarkerContext, UpdateContext)
    assert (menu.MenuHandler, menu.EntryContext) == (MenuHandler, EntryContext)
    assert InteractiveMarkerServer.DEFAULT_FEEDBACK_CALLBACK == 255
