"""Recorded goals are sent to action servers again: `bag play --send-actions-as-client`."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
import rosbag2_py
from tests.bag.written_bags import START_NS, STEP_NS, topic
from tests.conftest import wait_until

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError
from tfloom.bag.playing import played_goals
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.player import Player
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Recorder
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.interfaces.action_msgs.msg import GoalInfo
from tfloom.interfaces.action_msgs.srv import CancelGoal
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse
from tfloom.node.context.context import Context
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import qos_profile_system_default
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.rosidl import cdr

IMPL: Any = Fibonacci.Impl
SERVICES: dict[str, Any] = {
    "send_goal": IMPL.SendGoalService,
    "cancel_goal": IMPL.CancelGoalService,
    "get_result": IMPL.GetResultService,
}
EVENTS = {name: f"/fibonacci/_action/{name}/_service_event" for name in SERVICES}
TYPES = {
    name: f"example_interfaces/action/Fibonacci_{kind}_Event"
    for name, kind in {"send_goal": "SendGoal", "get_result": "GetResult"}.items()
} | {"cancel_goal": "action_msgs/srv/CancelGoal_Event"}
RECEIVED, SENT = ServiceEventInfo.REQUEST_RECEIVED, ServiceEventInfo.REQUEST_SENT


class Server:
    """An action server that a thread spins: its goals go on until they are cancelled, or `finish`.

    Args:
        context: The node's.
        name: Of the action.
        rejected: The order of the goals that it rejects.
    """

    def __init__(self, context: Context, name: str = "/fibonacci", rejected: int = -1) -> None:
        self.node = Node("server", context=context)
        self.handles: list[Any] = []
        self.cancelled: list[int] = []
        self.asked: list[bytes] = []
        """The ids whose results were asked for."""
        self.server = ActionServer(
            self.node,
            Fibonacci,
            name,
            None,
            goal_callback=lambda goal: GoalResponse.REJECT if goal.order == rejected else GoalResponse.ACCEPT,
            handle_accepted_callback=self.handles.append,
            cancel_callback=self._on_cancel,
        )
        self.server.configure_introspection(
            self.node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
        )
        self.node.create_subscription(
            IMPL.GetResultService.Event, f"{name}/_action/get_result/_service_event", self._on_event, 10
        )
        self.executor = SingleThreadedExecutor(context=context)
        self.executor.add_node(self.node)
        self._thread = Thread(target=self._spin)
        self._thread.start()

    def _spin(self) -> None:
        with suppress(ExternalShutdownException):
            self.executor.spin()

    def _on_event(self, event: Any) -> None:
        if event.info.event_type == RECEIVED:
            self.asked.append(bytes(bytearray(event.request[0].goal_id.uuid)))

    def _on_cancel(self, handle: Any) -> CancelResponse:
        self.cancelled.append(handle.request.order)
        self.finish(handle.request.order, cancelled=True)
        return CancelResponse.ACCEPT

    @property
    def orders(self) -> list[int]:
        return [handle.request.order for handle in self.handles]

    def finish(self, order: int, *, cancelled: bool = False) -> None:
        """Execute the last goal of an order to its end, as soon as it is cancelling if it is cancelled."""
        handle = next(handle for handle in reversed(self.handles) if handle.request.order == order)

        def execute(goal: Any) -> Any:
            if not cancelled:
                goal.succeed()
            elif goal.is_cancel_requested:
                goal.canceled()
            return Fibonacci.Result(sequence=[order])

        handle.execute(execute)

    def id_of(self, order: int) -> bytes:
        handle = next(handle for handle in reversed(self.handles) if handle.request.order == order)
        return bytes(bytearray(handle.goal_id.uuid))

    def end(self) -> None:
        self.executor.shutdown()
        self._thread.join()
        self.node.destroy_node()


@pytest.fixture
def server(local_context: Context) -> Iterator[Server]:
    server = Server(local_context)
    yield server
    server.end()


def stamp_of(step: int) -> Time:
    sec, nanosec = divmod(START_NS + step * STEP_NS, 10**9)
    return Time(sec=sec, nanosec=nanosec)


def recorded_id(number: int) -> UUID:
    return UUID(uuid=[number] * 16)


def goal(number: int) -> Any:
    return IMPL.SendGoalService.Request(goal_id=recorded_id(number), goal=Fibonacci.Goal(order=number))


def cancellation(number: int = 0, until: int | None = None) -> Any:
    stamp = Time() if until is None else stamp_of(until)
    return CancelGoal.Request(goal_info=GoalInfo(goal_id=recorded_id(number), stamp=stamp))


def result(number: int) -> Any:
    return IMPL.GetResultService.Request(goal_id=recorded_id(number))


Event = tuple[int, str, int, Any]
"""The step at which it was recorded [ms], the service, the kind, and the request or None."""


def write(folder: Path, *events: Event) -> Path:
    """Write a bag with events of an action's services, and with texts on /chatter and the action's feedback."""
    writer = BagWriter(folder)
    channels = {name: writer.add_topic(topic(EVENTS[name], TYPES[name])) for name in SERVICES}
    channels["feedback"] = writer.add_topic(topic("/fibonacci/_action/feedback", "std_msgs/msg/String"))
    channels["chatter"] = writer.add_topic(topic("/chatter", "std_msgs/msg/String"))
    last = max((step for step, *_ in events), default=0)
    words = [(step, name, String(data=name)) for name in ("feedback", "chatter") for step in (0, last)]
    encoded: list[tuple[int, str, Any]] = list(words)
    for step, name, kind, request in events:
        service = SERVICES[name]
        info = ServiceEventInfo(event_type=kind, stamp=stamp_of(step), sequence_number=step)
        encoded.append((step, name, service.Event(info=info, request=[] if request is None else [request])))
    for step, name, message in sorted(encoded, key=lambda event: event[0]):
        stamp_ns = START_NS + step * STEP_NS
        writer.push(channels[name], cdr.encode(message), stamp_ns, stamp_ns)
    writer.close()
    return folder


def event(step: int, request: Any, kind: int = RECEIVED) -> Event:
    names = {service.Request: name for name, service in SERVICES.items()}
    return step, names[type(request)], kind, request


class Played:
    """A player with the warnings that it has logged."""

    def __init__(self, player: Player, warnings: list[str]) -> None:
        self.player = player
        self.warnings = warnings

    def end(self) -> None:
        wait_until(self.player.ended.is_set, what="the end")


@contextmanager
def playing(path: Path, context: Context, **options: Any) -> Iterator[Played]:
    options = {"sends_goals": True, "has_keyboard": False} | options
    warnings: list[str] = []
    with open_bag(path) as bag, pytest.MonkeyPatch.context() as patch:
        from tfloom.node.log.rcutils_logger import RcutilsLogger

        patch.setattr(RcutilsLogger, "warning", lambda _, text, **__: warnings.append(text))
        player = Player(bag, PlayOptions(**options), context=context)
        player.start()
        try:
            yield Played(player, warnings)
        finally:
            player.stop()
            player.destroy_node()
    assert player.failure is None


def heard(context: Context, name: str) -> list[str]:
    """Return a list to which texts of a topic are added while `spin` of it is not needed: on this wire at once."""
    node = Node("hears", context=context)
    texts: list[str] = []
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    node.create_subscription(String, name, lambda message: texts.append(message.data), 10)
    Thread(target=_spin_quietly, args=(executor,), daemon=True).start()
    return texts


def _spin_quietly(executor: SingleThreadedExecutor) -> None:
    with suppress(ExternalShutdownException):
        executor.spin()


def test_a_recorded_client_acts_again(local_context: Context, server: Server, tmp_path: Path) -> None:
    """Goals, a cancellation and result requests of a live client, recorded and sent to the same server."""
    recorder = Recorder(
        tmp_path / "bag",
        WriterSettings(),
        RecordOptions(TopicChoice(actions=["/fibonacci"]), has_keyboard=False),
        context=local_context,
    )
    recorder.start()
    client = ActionClient(server.node, Fibonacci, "fibonacci")

    def answer(future: Any) -> Any:
        wait_until(future.done)
        return future.result()

    first = answer(client.send_goal_async(Fibonacci.Goal(order=1)))
    first_result = first.get_result_async()
    second = answer(client.send_goal_async(Fibonacci.Goal(order=2)))
    assert answer(second.cancel_goal_async()).goals_canceling
    wait_until(lambda: server.orders == [1, 2])
    server.finish(1)
    assert [*answer(first_result).result.sequence] == [1]
    wait_until(lambda: server.asked == [server.id_of(1)])
    recorded = [server.id_of(1), server.id_of(2)]
    recorder.stop()
    recorder.destroy_node()
    server.handles.clear()
    server.cancelled.clear()
    server.asked.clear()

    with playing(tmp_path / "bag", local_context, rate=50.0) as played:
        played.end()
        wait_until(lambda: server.cancelled == [2] and len(server.asked) == 1)
        assert server.orders == [1, 2]
        assert server.asked == [server.id_of(1)]
        assert not {*recorded} & {server.id_of(1), server.id_of(2)}  # which the server would have rejected
        assert not played.warnings
        assert server.cancelled == [2]


def test_what_the_action_has_published_is_left_out(
    local_context: Context, server: Server, tmp_path: Path
) -> None:
    path = write(tmp_path / "bag", event(0, goal(1)), event(9, result(1)))
    feedback, chatter = heard(local_context, "/fibonacci/_action/feedback"), heard(local_context, "/chatter")
    with playing(path, local_context) as played:
        played.end()
        wait_until(lambda: chatter == ["chatter", "chatter"])
        wait_until(lambda: server.asked == [server.id_of(1)])
    assert feedback == []
    with playing(path, local_context, sends_goals=False) as played:
        played.end()
        wait_until(lambda: feedback == ["feedback", "feedback"])
    assert server.orders == [1]


def test_requests_wait_until_their_goal_is_accepted(
    local_context: Context, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A server that answers late gets the cancellation and the result request after its answer, others at once."""
    path = write(
        tmp_path / "bag",
        event(0, goal(1)),
        event(1, cancellation(1)),
        event(2, result(1)),
        event(3, goal(2)),
    )
    node = Node("late", context=local_context)
    came: list[tuple[str, int]] = []
    with raw_server(node, came, accepts_after_s=0.3):
        with playing(path, local_context) as played:
            played.end()
            assert sorted(came[:2]) == [("send_goal", 1), ("send_goal", 2)]
            assert sorted(came[2:]) == [("cancel_goal", 1), ("get_result", 1)]
            assert not played.warnings
        came.clear()
        monkeypatch.setattr(played_goals, "ANSWER_S", 0.05)
        with playing(path, local_context) as played:
            played.end()
            assert came == [("send_goal", 1)]
            assert played.warnings == ["The server of '/fibonacci' has not answered 2 of the goals."]


@contextmanager
def raw_server(node: Node, came: list[tuple[str, int]], accepts_after_s: float) -> Iterator[None]:
    """Serve the three services of the action: goals are accepted after a time, and nothing happens to them."""
    orders: dict[bytes, int] = {}

    def key(goal_id: Any) -> bytes:
        return bytes(bytearray(goal_id.uuid))

    def on_goal(request: Any, response: Any) -> Any:
        orders[key(request.goal_id)] = request.goal.order
        came.append(("send_goal", request.goal.order))
        time.sleep(accepts_after_s)
        response.accepted = True
        return response

    def on_cancel(request: Any, response: Any) -> Any:
        came.append(("cancel_goal", orders[key(request.goal_info.goal_id)]))
        return response

    def on_result(request: Any, response: Any) -> Any:
        came.append(("get_result", orders[key(request.goal_id)]))
        return response

    for name, callback in (("send_goal", on_goal), ("cancel_goal", on_cancel), ("get_result", on_result)):
        node.create_service(SERVICES[name], f"/fibonacci/_action/{name}", callback)
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    thread = Thread(target=_spin_quietly, args=(executor,))
    thread.start()
    try:
        yield
    finally:
        executor.shutdown()
        thread.join()
        node.destroy_node()


def test_a_stop_cancels_the_goals_that_have_not_ended(
    local_context: Context, server: Server, tmp_path: Path
) -> None:
    path = write(
        tmp_path / "bag",
        *(event(step, goal(step)) for step in (1, 2, 3)),
        event(4, result(2)),
        (10_000, "send_goal", RECEIVED, goal(9)),
    )
    with playing(path, local_context) as played:
        wait_until(lambda: server.orders == [1, 2, 3] and len(server.asked) == 1)
        server.finish(2)
        wait_until(lambda: server.handles[1].status == 4)
        played.player.stop()
        assert sorted(server.cancelled) == [1, 3]
        assert played.player.ended.is_set()
    assert sorted(server.cancelled) == [1, 3]


def test_goals_go_on_behind_the_end_of_the_bag(
    local_context: Context, server: Server, tmp_path: Path
) -> None:
    with playing(write(tmp_path / "bag", event(0, goal(1))), local_context) as played:
        played.end()
        wait_until(lambda: server.orders == [1])
    assert server.cancelled == []


def test_a_seek_and_a_second_play_begin_anew(local_context: Context, server: Server, tmp_path: Path) -> None:
    path = write(
        tmp_path / "bag",
        event(0, goal(1)),
        event(20, cancellation(1)),
        event(30, goal(2)),
        event(9_000, result(2)),
    )
    with playing(path, local_context) as played:
        wait_until(lambda: server.orders == [1, 2] and server.cancelled == [1])
        assert played.player.playback.seek(START_NS + 25 * STEP_NS)
        wait_until(lambda: server.orders == [1, 2, 2])
        assert server.cancelled == [1, 2]
        # The cancellation of a goal before the seek is none of those that were sent.
        assert played.player.playback.seek(START_NS + 10 * STEP_NS)
        wait_until(lambda: server.orders == [1, 2, 2, 2])
        played.player.set_rate(100.0)
        played.end()
        wait_until(lambda: server.asked == [server.id_of(2)])
        assert server.cancelled == [1, 2, 2]
        # Nor is a result asked for of a goal that was sent in an earlier course.
        assert played.player.play_again(START_NS + 31 * STEP_NS, START_NS + 9_000 * STEP_NS)
        played.end()
        assert len(server.asked) == 1
        assert server.cancelled == [1, 2, 2, 2]
        assert played.player.play_again(START_NS, START_NS + 25 * STEP_NS)
        played.end()
        wait_until(lambda: server.cancelled == [1, 2, 2, 2, 1])
        assert server.orders == [1, 2, 2, 2, 1]
        assert not played.warnings


def test_paused_goals_are_sent_by_steps(local_context: Context, server: Server, tmp_path: Path) -> None:
    path = write(tmp_path / "bag", event(0, goal(1)), event(1, cancellation(1)), event(2, goal(2)))
    choice = TopicChoice(actions=["/fibonacci"])
    with playing(path, local_context, is_start_paused=True, choice=choice) as played:
        assert played.player.playback.burst(1) == 1
        wait_until(lambda: server.orders == [1])
        assert server.cancelled == []
        assert played.player.playback.step(2) == 2
        wait_until(lambda: server.orders == [1, 2] and server.cancelled == [1])


def test_a_request_for_all_cancels_those_of_the_player(
    local_context: Context, server: Server, tmp_path: Path
) -> None:
    client = ActionClient(server.node, Fibonacci, "fibonacci")
    client.send_goal_async(Fibonacci.Goal(order=100))
    wait_until(lambda: server.orders == [100])
    path = write(
        tmp_path / "bag",
        *(event(step, goal(step)) for step in (1, 3)),
        event(20, cancellation(until=2)),
        event(40, goal(5)),
        event(60, cancellation()),
    )
    with playing(path, local_context) as played:
        wait_until(lambda: server.cancelled == [1])
        played.end()
        wait_until(lambda: len(server.cancelled) >= 3)
    assert sorted(set(server.cancelled)) == [1, 3, 5]
    assert server.orders == [100, 1, 3, 5]


@pytest.mark.parametrize(
    ("events", "options", "said"),
    [
        (
            [(0, "send_goal", RECEIVED, None), event(1, cancellation(1))],
            {},
            "its introspection was set to metadata",
        ),
        ([event(0, goal(1)), event(1, result(1))], {}, "There is no action server of '/fibonacci'"),
        (
            [event(0, goal(1), SENT), (1, "send_goal", ServiceEventInfo.RESPONSE_RECEIVED, None)],
            {},
            "by its clients, not by its servers: they are sent with --service-requests-source client_introspection",
        ),
        (
            [event(0, goal(1)), (1, "send_goal", ServiceEventInfo.RESPONSE_SENT, None)],
            {"is_client_source": True},
            "by its servers, not by its clients: they are sent with --service-requests-source service_introspection",
        ),
    ],
)
def test_what_cannot_be_sent_is_said_once(
    events: list[Event],
    options: dict[str, Any],
    said: str,
    local_context: Context,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(played_goals, "SERVER_S", 0.1)
    path = write(tmp_path / "bag", *events, *((step + 100, *rest) for step, *rest in events))
    with playing(path, local_context, **options) as played:
        played.end()
    (warning,) = played.warnings
    assert said in warning


def test_both_ends_of_a_request_send_it_once(local_context: Context, server: Server, tmp_path: Path) -> None:
    path = write(tmp_path / "bag", event(0, goal(1), SENT), event(1, goal(1)), event(5, goal(2), SENT))
    for is_client_source, orders in ((False, [1]), (True, [1, 2])):
        server.handles.clear()
        with playing(path, local_context, is_client_source=is_client_source) as played:
            played.end()
            wait_until(lambda orders=orders: server.orders == orders)
            assert not played.warnings


def test_a_server_that_comes_late_and_one_that_rejects(local_context: Context, tmp_path: Path) -> None:
    path = write(
        tmp_path / "bag", event(0, goal(1)), event(1, goal(2)), event(2, cancellation(2)), event(3, goal(2))
    )
    with playing(path, local_context, remaps={"/fibonacci": "/other"}) as played:
        assert not played.player.started.wait(0.2)
        server = Server(local_context, "/other", rejected=2)
        try:
            played.end()
            wait_until(lambda: server.orders == [1])
            assert played.warnings == ["The server of '/other' has rejected a goal."]
        finally:
            server.end()


def test_an_action_without_events_of_goals(local_context: Context, tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "bag")
    feedback = writer.add_topic(topic("/fibonacci/_action/feedback", "std_msgs/msg/String"))
    unknown = writer.add_topic(topic("/odd/_action/send_goal/_service_event", "std_msgs/msg/String"))
    chatter = writer.add_topic(topic("/chatter", "std_msgs/msg/String"))
    for channel in (feedback, unknown, chatter):
        writer.push(channel, cdr.encode(String(data="x")), START_NS, START_NS)
    writer.close()
    with playing(tmp_path / "bag", local_context) as played:
        played.end()
        assert played.player.playback.is_stopped is False
    assert [text.partition(":")[0] for text in played.warnings] == [
        "Goals of '/fibonacci' can't be sent",
        "Goals of '/odd' can't be sent",
    ]


def test_damaged_events_are_left_out(local_context: Context, server: Server, tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "bag")
    channel = writer.add_topic(topic(EVENTS["send_goal"], TYPES["send_goal"]))
    whole = cdr.encode(
        IMPL.SendGoalService.Event(info=ServiceEventInfo(event_type=RECEIVED), request=[goal(1)])
    )
    for step, data in enumerate((b"", whole[:40], whole[:-3], whole)):
        stamp_ns = START_NS + step * STEP_NS
        writer.push(channel, data, stamp_ns, stamp_ns)
    writer.close()
    with playing(tmp_path / "bag", local_context) as played:
        played.end()
        wait_until(lambda: server.orders == [1])
    assert len(played.warnings) == 1
    assert "can't be read" in played.warnings[0]


def test_from_python_and_by_a_closed_player(
    local_context: Context, server: Server, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ros_domain: int
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(ros_domain))
    path = write(tmp_path / "bag", event(0, goal(1)), event(10_000, goal(2)))
    options = rosbag2_py.PlayOptions()
    options.send_actions_as_client = True
    player = rosbag2_py.Player(rosbag2_py.StorageOptions(str(path)), options)
    player.play()
    wait_until(lambda: server.orders == [1])
    del player  # ends it mid-goal
    wait_until(lambda: server.cancelled == [1])


@pytest.mark.parametrize("interrupts", [False, True])
def test_from_the_command_line(
    interrupts: bool, domain_id: int, tmp_path: Path, start_program: Callable[..., Any]
) -> None:
    path = write(
        tmp_path / "bag",
        event(0, goal(1)),
        event(1, result(1)),
        event(20_000 if interrupts else 300, goal(2)),
        event(20_001 if interrupts else 400, cancellation(2)),
    )
    context = Context()
    context.init(args=[], domain_id=domain_id)
    server = Server(context)
    try:
        play = start_program("tfloom", "bag", "play", str(path), "--send-actions-as-client")
        wait_until(lambda: server.orders[:1] == [1])
        wait_until(lambda: server.asked == [server.id_of(1)])
        if interrupts:
            play.signal(2)
            assert play.wait() == 0
            assert server.cancelled == [1]
        else:
            assert play.wait() == 0
            assert server.orders == [1, 2]
            wait_until(lambda: server.cancelled == [2])
    finally:
        server.end()
        context.destroy()


def test_a_refused_thread_ends_the_play(
    local_context: Context, server: Server, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    start, begun = Thread.start, []

    def refuse_the_second(thread: Thread) -> None:
        begun.append(thread)
        if len(begun) == 2:
            raise RuntimeError("can't start new thread")
        start(thread)

    with open_bag(write(tmp_path / "bag", event(0, goal(1)))) as bag:
        player = Player(bag, PlayOptions(sends_goals=True, has_keyboard=False), context=local_context)
        monkeypatch.setattr(Thread, "start", refuse_the_second)
        with pytest.raises(BagError, match="can't start new thread"):
            player.start()
        assert not begun[0].is_alive()
        player.start()
        wait_until(player.ended.is_set)
        wait_until(lambda: server.orders == [1])
        player.stop()
        player.destroy_node()
