"""Forms of pages, on a live graph: how they are made from types, and what is published, called and sent by them."""

from __future__ import annotations

import json
import random
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.viewer.conftest import OWN_TYPES, Page
from tests.viewer.test_driving import Robot

from tfloom._native import ReadyQueue
from tfloom.interfaces.action_msgs.msg import GoalStatus
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.geometry_msgs.msg import PoseStamped
from tfloom.interfaces.rcl_interfaces.msg import Log
from tfloom.interfaces.sensor_msgs.msg import Imu
from tfloom.interfaces.std_msgs.msg import Int64, String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.interfaces.turtlesim.srv import Spawn
from tfloom.interfaces.visualization_msgs.msg import MarkerArray
from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse, ServerGoalHandle
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared import peer_types
from tfloom.rmw.shared.service_request import ServiceRequest
from tfloom.rosidl.class_search import find_class
from tfloom.rosidl.definition_files import interface_names
from tfloom.viewer.forms import asking, filling, publishing, sending, type_form
from tfloom.viewer.forms.filling import fill
from tfloom.viewer.page_command import PageError
from tfloom.viewer.program import Viewer

OpenPage = Callable[[Viewer], Page]
FIBONACCI = "example_interfaces/action/Fibonacci"
SET_BOOL = "std_srvs/srv/SetBool"
MOVING = {"linear": {"x": 2.0}, "angular": {"z": -1.0}}


def sent(page: Page, state: str) -> str:
    """Wait until something that was sent is in a state; return the text."""
    rows = page.wait_for(
        lambda: [one["sent"] for one in page.answers if "sent" in one and one["sent"]["state"] == state]
    )
    return str(rows[-1]["text"])


def send(page: Page, what: str, name: str, values: Any, type_name: str = "", key: str = "1") -> None:
    page.answers.clear()
    page.send(op="send", key=key, what=what, name=name, type=type_name, values=values)


def ask(page: Page, *words: Any, state: str = "done", **options: Any) -> str:
    """Send what `send` does, wait until it is in a state, and return the text."""
    send(page, *words, **options)
    return sent(page, state)


# The form of a type.


def test_every_type_has_a_form_that_json_and_a_page_can_take() -> None:
    kinds = set()
    for name in interface_names("msg"):
        form = type_form.type_form(find_class(name))
        json.dumps(form, allow_nan=False)
        assert form["root"] == name
        for fields in form["types"].values():
            for field in fields:
                kinds.add(field["kind"])
                assert field["kind"] != "message" or field["base"] in form["types"]
    assert kinds == {"bool", "integer", "float", "text", "time", "message"}


def field_of(form: dict[str, Any], type_name: str, name: str) -> dict[str, Any]:
    return next(field for field in form["types"][type_name] if field["name"] == name)


def test_form_has_bounds_defaults_and_constants_as_choices() -> None:
    level = field_of(type_form.type_form(Log), "rcl_interfaces/msg/Log", "level")
    assert (level["kind"], level["min"], level["max"]) == ("integer", "0", "255")
    data = field_of(type_form.type_form(Int64), "std_msgs/msg/Int64", "data")
    assert (data["min"], data["max"]) == (str(-(2**63)), str(2**63 - 1))
    covariance = field_of(type_form.type_form(Imu), "sensor_msgs/msg/Imu", "orientation_covariance")
    assert (covariance["shape"], covariance["length"], covariance["value"]) == ("array", 9, ["0.0"] * 9)
    form = type_form.type_form(MarkerArray)
    kind = field_of(form, "visualization_msgs/msg/Marker", "type")
    assert ["CUBE", "1"] in kind["choices"]
    assert field_of(form, "visualization_msgs/msg/Marker", "ns")["choices"] == []
    assert field_of(form, "std_msgs/msg/Header", "stamp")["kind"] == "time"


def test_too_many_fields_are_no_form(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(type_form, "MAX_FIELDS", 20)
    with pytest.raises(PageError, match="visualization_msgs/msg/MarkerArray has more than 20 fields"):
        type_form.type_form(MarkerArray)


# From what is filled in to a message.


def test_defaults_of_a_form_fill_the_message_that_is_new() -> None:
    """What a page reads back from a form that nobody has changed is each type's new message."""

    def values_of(form: dict[str, Any], type_name: str) -> dict[str, Any]:
        values: dict[str, Any] = {}
        for field in form["types"][type_name]:
            if field["shape"] and field["kind"] in {"message", "time"}:
                if field["shape"] != "array":
                    values[field["name"]] = []
            elif field["kind"] == "message":
                values[field["name"]] = values_of(form, field["base"])
            elif field["kind"] == "time":
                values[field["name"]] = {"sec": "0", "nanosec": "0"}
            elif field["value"] or field["shape"] != "array":
                values[field["name"]] = field["value"]
        return values

    for name in interface_names("msg"):
        message_class = find_class(name)
        form = type_form.type_form(message_class)
        message = message_class()
        fill(message, values_of(form, name), 0)
        assert message == message_class() or "nan" in repr(message), name


def test_now_is_the_time_of_sending_and_numbers_may_be_texts() -> None:
    message = PoseStamped()
    fill(
        message,
        {"header": {"stamp": "now", "frame_id": "map"}, "pose": {"position": {"x": "1e3"}}},
        5_000_000_007,
    )
    assert (message.header.stamp.sec, message.header.stamp.nanosec) == (5, 7)
    assert message.pose.position.x == 1000.0
    number = Int64()
    fill(number, {"data": str(2**63 - 1)}, 0)
    assert number.data == 2**63 - 1


WRONG: list[tuple[type[Any], Any, str]] = [
    (PoseStamped, {"pose": {"position": {"x": "far"}}}, r"pose\.position\.x: .*'far'"),
    (PoseStamped, {"pose": {"position": {"w": 1}}}, "pose.position: .*no attribute 'w'"),
    (PoseStamped, {"pose": [1]}, "pose: .*expected to be a dictionary"),
    (PoseStamped, 3, "expected to be a dictionary"),
    (Int64, {"data": str(2**63)}, "data: .*outside"),
    (Int64, {"data": "9" * 10_000}, "data: "),
    (Int64, {"data": 1.5}, "not a whole number"),
    (Imu, {"orientation_covariance": [1, 2]}, "orientation_covariance"),
    (Imu, {"orientation_covariance": [[1]] * 9}, "orientation_covariance"),
    (MarkerArray, {"markers": [{"color": {"r": None}}]}, r"markers\[0\]\.color\.r"),
    (MarkerArray, {"markers": {"a": 1}}, "markers: .*expected to be a list"),
    (String, {"data": "\ud800"}, "data"),
]


def test_what_does_not_fit_is_refused_and_its_field_named() -> None:
    for message_class, values, sentence in WRONG:
        with pytest.raises(PageError, match=sentence):
            fill(message_class(), values, 0)


def test_message_that_a_short_text_makes_large_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(filling, "MAX_VALUES", 1000)
    fill(MarkerArray(), {"markers": [{}] * 10}, 0)
    with pytest.raises(PageError, match="at most 1000 values"):
        fill(MarkerArray(), {"markers": [{}] * 100}, 0)
    with pytest.raises(PageError, match="at most 1000 values"):
        fill(MarkerArray(), {"markers": [{"points": [{}] * 400}]}, 0)


# On a graph.


def test_page_gets_names_and_the_form_of_a_name(spun: Node, page: Page) -> None:
    spun.create_subscription(PoseStamped, "/aim", lambda _: None, 10)
    spun.create_service(SetBool, "/lamp", lambda _, response: response)
    ActionServer(spun, Fibonacci, "/count", lambda _: Fibonacci.Result())

    def names(what: str, name: str) -> Any:
        return dict(page.ask("form_names", op="form_names", what=what)["names"]).get(name)

    wait_until(lambda: names("topic", "/aim") == "geometry_msgs/msg/PoseStamped", what="the topic")
    wait_until(lambda: names("service", "/lamp") == SET_BOOL, what="the service")
    wait_until(lambda: names("action", "/count") == FIBONACCI, what="the action")
    assert names("service", "/count/_action/send_goal") is None
    form = page.ask("form", op="form", what="action", name="count", type="")
    assert form["name"] == "/count"
    assert [field["name"] for field in form["types"][form["root"]]] == ["order"]
    page.send(op="form", what="topic", name="/aim", type="std_msgs/String", key="form")
    assert "/aim has the type geometry_msgs/msg/PoseStamped, not std_msgs/msg/String" in sent(page, "error")


def test_message_is_published_at_a_rate_until_it_is_stopped_or_its_page_is_closed(
    spun: Node, viewer: Viewer, page: Page
) -> None:
    heard: list[tuple[float, PoseStamped]] = []
    spun.create_subscription(PoseStamped, "/aim", lambda said: heard.append((time.monotonic(), said)), 100)
    command = {"op": "send", "what": "topic", "name": "aim", "type": "geometry_msgs/msg/PoseStamped"}
    command |= {"values": {"header": {"stamp": "now"}, "pose": {"position": {"x": "2.5"}}}}
    for rate_hz in (-1.0, 1000.0):
        page.answers.clear()
        page.send(**command, key="0", rate_hz=rate_hz)
        assert "above 0 and at most 100 Hz" in sent(page, "error")
    page.send(**command, key="1", rate_hz=50.0)
    wait_until(lambda: len(heard) >= 50, what="messages")
    assert heard[49][0] - heard[0][0] > 0.5  # a burst would be over at once
    stamps = [(said.header.stamp.sec, said.header.stamp.nanosec) for _, said in heard]
    assert stamps == sorted(set(stamps))
    assert {said.pose.position.x for _, said in heard} == {2.5}
    page.answers.clear()
    page.send(op="cancel", key="1")
    count = int(sent(page, "done").split()[1])
    wait_until(lambda: len(heard) == count, what="the last message")
    page.send(**command, key="2", rate_hz=50.0)
    wait_until(lambda: len(heard) >= count + 5, what="messages")
    page.socket.close()
    wait_until(lambda: not viewer._live.forms._tasks, what="its end")
    graph = viewer._live.participant.graph
    wait_until(lambda: not any(end.topic.name == "/aim" and end.is_writer for end in graph.endpoints()))


def test_message_is_published_to_all_subscriptions_of_the_graph(
    spun: Node, viewer: Viewer, page: Page
) -> None:
    plain: list[PoseStamped] = []
    kept: list[PoseStamped] = []
    spun.create_subscription(PoseStamped, "/aim", plain.append, 10)
    spun.create_subscription(
        PoseStamped, "/aim", kept.append, QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    )
    graph = viewer._live.participant.graph
    wait_until(lambda: sum(end.topic.name == "/aim" for end in graph.endpoints()) == 2, what="subscriptions")
    before_s = time.time()
    send(page, "topic", "aim", {"header": {"stamp": "now"}, "pose": {"position": {"x": "2.5"}}})
    assert sent(page, "done") == "published on /aim: 2 subscriptions"
    wait_until(lambda: plain and kept, what="the message")
    assert plain[0].pose.position.x == kept[0].pose.position.x == 2.5
    assert before_s - 1 <= plain[0].header.stamp.sec <= time.time()
    send(page, "topic", "/nobody", {"data": "x"}, "std_msgs/msg/String")
    assert sent(page, "done") == "published on /nobody: 0 subscriptions"
    wait_until(lambda: any(end.topic.name == "/nobody" for end in graph.endpoints()), what="the writer")
    page.socket.close()
    wait_until(lambda: not any(end.topic.name == "/nobody" for end in graph.endpoints()), what="its end")


@pytest.mark.parametrize("end", ["stop", "page", "viewer"])
def test_velocity_at_a_rate_ends_with_zero(spun: Node, viewer: Viewer, page: Page, end: str) -> None:
    robot = Robot(spun)
    page.send(
        op="send",
        what="topic",
        name="cmd_vel",
        type="geometry_msgs/msg/Twist",
        key="1",
        values=MOVING,
        rate_hz=50.0,
    )
    wait_until(lambda: robot.is_moved, what="a velocity")
    viewer._live.forms.leave_topics()  # of the last page, which was closed while this one was opened
    count = len(robot.velocities)
    wait_until(lambda: len(robot.velocities) > count + 10, what="further velocities")
    if end == "stop":
        page.send(op="cancel", key="1")
    elif end == "page":
        page.socket.close()
    else:
        viewer._live.forms.close()
    wait_until(lambda: robot.is_stopped, what="the stop")


def test_publication_of_a_page_that_is_closed_ends_while_a_picture_takes_its_time(
    spun: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = Robot(spun)
    drawing, goes_on = threading.Event(), threading.Event()
    monkeypatch.setattr(viewer.view, "draw", lambda: (drawing.set(), goes_on.wait(30.0)))
    try:
        wait_until(drawing.is_set, what="a picture")
        for _ in range(2):
            page.send(
                op="send",
                what="topic",
                name="cmd_vel",
                type="geometry_msgs/msg/Twist",
                key="1",
                values=MOVING,
                rate_hz=50.0,
            )
        wait_until(lambda: robot.is_moved, what="a velocity")
        page.socket.close()
        wait_until(lambda: robot.is_stopped, what="the stop")
        wait_until(lambda: not viewer._live.forms._tasks, what="its end")
    finally:
        goes_on.set()


def test_velocity_at_a_rate_keeps_its_writer_while_many_others_are_used(
    spun: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sending, "MAX_WRITERS", 3)
    robot = Robot(spun)
    twist: dict[str, Any] = {"what": "topic", "type": "geometry_msgs/msg/Twist", "rate_hz": 50.0}
    page.send(op="send", name="cmd_vel", key="drive", values=MOVING, **twist)
    wait_until(lambda: robot.is_moved, what="a velocity")
    for number in range(2 * sending.MAX_WRITERS):
        said = ask(page, "topic", f"/other_{number}", {"data": "x"}, "std_msgs/msg/String", key=str(number))
        assert said == f"published on /other_{number}: 0 subscriptions"
    count = len(robot.velocities)
    wait_until(lambda: len(robot.velocities) > count, what="a further velocity")
    for number in range(1, sending.MAX_WRITERS):
        page.send(op="send", name=f"/held_{number}", key=f"held {number}", values={}, **twist)
        page.wait_for(
            lambda number=number: any(
                one["sent"]["key"] == f"held {number}" and one["sent"]["state"] == "feedback"
                for one in page.answers
                if "sent" in one
            )
        )
    said = ask(page, "topic", "/other", {"data": "x"}, "std_msgs/msg/String", key="other", state="error")
    assert said == "3 topics are published on already"
    page.send(op="cancel", key="drive")
    wait_until(lambda: robot.is_stopped, what="the stop")


class SlowWriter:
    """A writer that is matched with one more subscription at each question."""

    def __init__(self) -> None:
        self.matched = -1
        self.written: list[bytes] = []

    def matched_count(self) -> int:
        self.matched += 1
        return self.matched

    def write(self, data: bytes) -> None:
        self.written.append(data)


def test_message_waits_until_its_writer_is_matched_and_not_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[tuple[str, str]] = []
    writer = SlowWriter()
    publication = publishing.Publication(writer, "/x", b"data", (2, 1), lambda *words: said.append(words))
    assert [publication.step(), publication.step()] == [False, False]
    assert writer.written == []
    assert publication.step()
    assert writer.written == [b"data"]
    assert said == [("done", "published on /x: 1 subscription")]
    monkeypatch.setattr(publishing, "MATCH_S", -1.0)
    late = SlowWriter()
    assert publishing.Publication(late, "/x", b"data", (2, 0), lambda *words: said.append(words)).step()
    assert late.written == [b"data"]
    assert said[-1][1].endswith("0 subscriptions; 2 more with another quality of service, which get nothing")


def test_service_is_called_and_its_response_shown(spun: Node, page: Page) -> None:
    def spawn(request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
        response.name = f"{request.name} at {request.x:g}"
        return response

    spun.create_service(Spawn, "/spawn", spawn)
    send(page, "service", "/spawn", {"name": "t2", "x": "3"}, "turtlesim/srv/Spawn")
    assert sent(page, "done") == "name: t2 at 3\n"
    assert "x: " in ask(page, "service", "/spawn", {"x": "three"}, "turtlesim/srv/Spawn", state="error")


def test_service_that_is_not_there_or_does_not_respond_is_an_error_in_time(
    node: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(ServiceRequest.ask.__kwdefaults__, "server_s", 0.3)
    send(page, "service", "/gone", {}, SET_BOOL)
    assert sent(page, "error") == "there is no server of /gone: waited 0.3 s for it"
    send(page, "action", "/gone", {}, FIBONACCI)
    assert "there is no server of /gone/_action/send_goal" in sent(page, "error")
    monkeypatch.setitem(ServiceRequest.ask.__kwdefaults__, "response_s", 0.5)
    service = node.create_service(SetBool, "/silent", lambda _, response: response)  # nobody spins the node
    monkeypatch.setitem(ServiceRequest.ask.__kwdefaults__, "server_s", 20.0)
    send(page, "service", "/silent", {}, SET_BOOL)
    assert sent(page, "error") == "no response from /silent within 0.5 s"
    monkeypatch.setitem(ServiceRequest.ask.__kwdefaults__, "response_s", 60.0)
    send(page, "service", "/silent", {}, SET_BOOL, key="2")
    tasks = viewer._live.forms._tasks
    wait_until(lambda: any(one.key == "2" and one.task._request.is_sent for one in tasks), what="the request")
    node.destroy_service(service)
    assert sent(page, "error") == "the server of /silent has left without a response"


class Counting:
    """A server of /count that counts until it is released or cancelled."""

    def __init__(self, node: Node) -> None:
        self.handles: list[ServerGoalHandle] = []
        self._gate: Future[None] = Future(executor=node.executor)
        ActionServer(
            node,
            Fibonacci,
            "/count",
            self._run,
            goal_callback=lambda goal: GoalResponse.ACCEPT if goal.order < 10 else GoalResponse.REJECT,
            cancel_callback=self._cancel,
        )

    async def _run(self, handle: ServerGoalHandle) -> Fibonacci.Result:
        self.handles.append(handle)
        handle.publish_feedback(Fibonacci.Feedback(sequence=[7]))
        await self._gate
        handle.canceled() if handle.is_cancel_requested else handle.succeed()
        return Fibonacci.Result(sequence=[1, 2])

    def _cancel(self, _: object) -> CancelResponse:
        self._gate.set_result(None)
        return CancelResponse.ACCEPT

    def release(self) -> None:
        self._gate.set_result(None)


def test_goal_tells_its_feedback_and_its_result(spun: Node, page: Page) -> None:
    server = Counting(spun)
    send(page, "action", "/count", {"order": "3"}, FIBONACCI)
    assert sent(page, "accepted") == "the goal is accepted"
    assert sent(page, "feedback") == "sequence:\n- 7\n"
    assert server.handles[0].request.order == 3
    server.release()
    assert sent(page, "done") == "SUCCEEDED\nsequence:\n- 1\n- 2\n"
    send(page, "action", "/count", {"order": "10"}, FIBONACCI)
    assert sent(page, "error") == "the server rejected the goal"


def test_goal_is_canceled_by_its_page_alone(spun: Node, viewer: Viewer, open_page: OpenPage) -> None:
    server = Counting(spun)
    page, other = open_page(viewer), open_page(viewer)
    ask(page, "action", "/count", {"order": "3"}, FIBONACCI, key="a", state="accepted")
    other.send(op="cancel", key="a")
    ask(other, "topic", "/x", {}, "std_msgs/msg/Empty")  # after the cancel, which was not its own
    goal = viewer._live.forms._tasks[0].task
    assert not goal._is_cancel_wanted
    assert not goal._is_cancelling
    assert not server.handles[0].is_cancel_requested
    page.send(op="cancel", key="a")
    assert sent(page, "done").startswith("CANCELED\n")
    assert server.handles[0].status == GoalStatus.STATUS_CANCELED


def test_closed_page_cancels_its_goal(spun: Node, viewer: Viewer, page: Page) -> None:
    server = Counting(spun)
    ask(page, "action", "/count", {"order": "3"}, FIBONACCI, state="accepted")
    page.socket.close()
    wait_until(lambda: server.handles[0].status == GoalStatus.STATUS_CANCELED, what="the goal's end")
    forms = viewer._live.forms
    wait_until(lambda: not forms._tasks and not forms._orphans, what="the client's end")


def test_goal_of_a_page_that_was_closed_at_once_is_not_left(
    viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    forms = viewer._live.forms
    monkeypatch.setattr(sending.Sending, "_run", lambda _: None)
    idle = sending.Sending(forms._participant, forms._node, forms._now_ns)
    said: list[dict[str, Any]] = []
    command = {"op": "send", "key": "1", "what": "action", "name": "/x", "values": {}}
    idle.ask("page", {**command, "type": FIBONACCI}, said.append)
    idle.forget("page")
    idle._take_commands()
    assert [one["sent"]["state"] for one in said] == ["waiting"]
    assert idle._tasks == []
    assert idle._orphans == []  # it was never sent


class SmallWire:
    """A participant that opens no more than some ends, and counts those that are open."""

    def __init__(self, size: int) -> None:
        self.left = size
        self.open_count = 0

    def create_requester(self, *_: object) -> SmallWire:
        if not self.left:
            raise WireError("it opens no more")
        self.left -= 1
        self.open_count += 1
        return self

    create_reader = create_requester

    def notify(self, *_: object) -> None:
        pass

    watch_servers = notify

    def close(self) -> None:
        self.open_count -= 1


@pytest.mark.parametrize("size", range(4))
def test_goal_that_cannot_be_opened_leaves_nothing_open(size: int) -> None:
    small: Any = SmallWire(size)
    wire = asking.Wire(small, NodeName("/", "me"), ReadyQueue())
    with pytest.raises(WireError, match="no more"):
        asking.Goal(wire, "/count", Fibonacci, Fibonacci.Goal(), lambda *_: None)
    assert small.left == 0
    assert small.open_count == 0


def test_wrong_commands_get_a_sentence_and_forms_go_on(page: Page, monkeypatch: pytest.MonkeyPatch) -> None:
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"op": "form", "what": "dream", "name": "/x", "type": ""}, "what has to be topic, service, action"),
        ({"op": "form", "what": "topic", "name": "/x", "type": ""}, "nobody has /x: say its type"),
        ({"op": "form", "what": "topic", "name": "/x y", "type": "std_msgs/String"}, "x y"),
        ({"op": "form", "what": "topic", "name": "/x", "type": "no_pkg/No"}, "there is no message type"),
        ({"op": "form", "what": "service", "name": "/x", "type": "std_msgs/msg/String"}, "no service type"),
        ({"op": "form", "what": "topic", "name": 3, "type": ""}, "name has to be a text"),
        ({"op": "send", "what": "topic", "name": "/x", "type": "std_msgs/String", "values": 1}, "key has to"),
    ]
    for command, sentence in wrong:
        assert sentence in page.ask("error", **command), command
    for values in (None, [], {"data": {"a": "b"}, "x": 1}, {"data": [[[[[]]]]]}):
        assert ask(page, "topic", "/x", values, "std_msgs/msg/Int64", state="error")
    monkeypatch.setattr(sending, "MAX_OPEN", 0)
    assert "are under way already" in ask(page, "topic", "/x", {}, "std_msgs/msg/Int64", state="error")
    monkeypatch.setattr(sending, "MAX_OPEN", 5)
    assert ask(page, "topic", "/x", {"data": "5"}, "std_msgs/msg/Int64")


ODD = (
    *(None, True, -1, 1e400, "", "now", "auto", "x", "9" * 500),
    *([], {}, [[]], [{}], ["1", None], {"x": 1}, "\ud800"),
)


def test_odd_values_of_any_type_are_a_sentence_or_a_message() -> None:
    chance = random.Random(5)

    def odd(type_name: str, depth: int) -> Any:
        fields = find_class(type_name)._FIELDS
        values: dict[Any, Any] = {}
        for name, field in fields.items():
            base = field.partition("[")[0].partition("<")[0]
            if "/" in base and depth < 4 and chance.random() < 0.7:
                inner = odd(base, depth + 1)
                values[name] = [inner] * chance.randrange(3) if "[" in field else inner
            elif chance.random() < 0.4:
                values[name] = chance.choice(ODD)
        return values

    def outcome(message: Any, values: Any) -> str:
        try:
            fill(message, values, 7)
        except PageError:
            return "sentence"
        return "message"

    outcomes = Counter(
        outcome(find_class(name)(), odd(name, 0)) for name in interface_names("msg") for _ in range(6)
    )
    assert min(outcomes["sentence"], outcomes["message"]) > 50


# Types that another process alone has.


OWN = (
    ("topic", "/samples", {"at": ["4", "5", "6"]}, "published on /samples: 0 subscriptions"),
    ("service", "/weigh", {"part": {"count": "4"}}, "grams: 10.0\n"),
    ("action", "/sort", {"parts": [{"name": "b"}, {"name": "a"}]}, "SUCCEEDED\nsorted:\n- name: a\n"),
)


def test_forms_of_types_that_another_process_alone_has(
    page: Page, start_program: Callable[..., Program]
) -> None:
    start_program("python", OWN_TYPES).wait_for("ready")
    for what, name, values, answer in OWN:
        names = wait_for_name(page, what, name)
        form = page.ask("form", op="form", what=what, name=name, type="", key="form")
        assert (form["name"], form["type"]) == (name, names[name])
        assert form["types"][form["root"]][0]["name"] in {"header", "part", "parts"}
        assert ask(page, what, name, values).startswith(answer)


def wait_for_name(page: Page, what: str, name: str) -> dict[str, str]:
    """Wait until forms offer a name; return all names with their types."""
    while True:
        names = dict(page.ask("form_names", op="form_names", what=what)["names"])
        if name in names:
            return names


def test_description_that_was_not_announced_is_an_error_of_the_form(
    page: Page, start_program: Callable[..., Program]
) -> None:
    start_program("python", OWN_TYPES, "lie").wait_for("ready")
    wait_for_name(page, "topic", "/samples")
    page.send(op="form", what="topic", name="/samples", type="", key="form")
    said = sent(page, "error")
    assert "there is no message type 'lab_msgs/msg/Sample'" in said
    assert "; the description from /lab can't be used: " in said


@pytest.fixture
def mute(domain_id: int) -> Iterator[None]:
    """A node with a topic of an unknown type, which describes nothing."""
    wire = open_participant(domain_id)
    node = NodeName("/", "mute")
    wire.add_node(node)
    wire.create_writer(node, Topic("/plan", "secret_msgs/msg/Plan", f"RIHS01_{64 * '0'}"), QoS())
    yield
    wire.close()


@pytest.mark.usefixtures("mute")
def test_node_that_describes_nothing_is_an_error_in_time_and_nobody_else_waits_for_it(
    spun: Node, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    spun.create_service(SetBool, "/set", lambda _, response: response)
    monkeypatch.setattr(peer_types, "CALL_S", 0.3)
    page, other = open_page(viewer), open_page(viewer)
    wait_for_name(page, "topic", "/plan")
    page.send(op="form", what="topic", name="/plan", type="", key="form")
    said = sent(page, "error")
    assert said.endswith("; there is no server of /mute/get_type_description: waited 0.3 s for it")
    monkeypatch.setattr(peer_types, "CALL_S", 600.0)
    tasks = viewer._live.forms._tasks
    page.answers.clear()
    page.send(op="form", what="topic", name="/plan", type="", key="form")
    wait_until(lambda: len(tasks) == 1, what="the search")
    wait_for_name(other, "service", "/set")
    assert "success: false" in ask(other, "service", "/set", {})
    page.send(op="cancel", key="form")
    assert sent(page, "error") == "it was given up"
    page.send(op="form", what="topic", name="/plan", type="", key="form")
    wait_until(lambda: len(tasks) == 1, what="the next search")
    page.socket.close()
    wait_until(lambda: not tasks, what="its end with the page")
