"""Actions: goals accepted, rejected, cancelled, aborted; feedback, states and results."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.action_msgs.msg import GoalInfo, GoalStatus
from tfloom.interfaces.action_msgs.srv import CancelGoal
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.node.action.client import MAX_ENDED, ActionClient
from tfloom.node.action.goal_states import GoalEvent
from tfloom.node.action.graph import (
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse, ServerGoalHandle
from tfloom.node.clock.clock import ROSClock
from tfloom.node.context.context import Context
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.time import ClockType
from tfloom.node.values.time import Time as RosTime
from tfloom.rmw.local import endpoints as local_endpoints
from tfloom.rmw.typed_names import new_goal_id

Finish = Callable[[Future[Any]], Any]


@pytest.fixture
def server_node(make_node: Callable[..., Node], executor: SingleThreadedExecutor) -> Node:
    node = make_node("server")
    executor.add_node(node)
    return node


@pytest.fixture
def client(node: Node, executor: SingleThreadedExecutor) -> ActionClient:
    executor.add_node(node)
    return ActionClient(node, Fibonacci, "fibonacci")


def fibonacci(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
    sequence = [0, 1]
    for index in range(1, goal_handle.request.order):
        sequence.append(sequence[index] + sequence[index - 1])
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
    goal_handle.succeed()
    return Fibonacci.Result(sequence=sequence)


class Gated:
    """An execute callback that waits until it is released or cancelled."""

    def __init__(self, executor: SingleThreadedExecutor) -> None:
        self.gates: list[Future[None]] = []
        self._executor = executor

    async def __call__(self, goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        gate: Future[None] = Future(executor=self._executor)
        self.gates.append(gate)
        await gate
        goal_handle.canceled() if goal_handle.is_cancel_requested else goal_handle.succeed()
        return Fibonacci.Result(sequence=[goal_handle.request.order])


def test_goal_is_accepted_executed_and_returns_its_result(
    server_node: Node, client: ActionClient, finish: Finish, spin_until: Callable[..., None]
) -> None:
    ActionServer(server_node, Fibonacci, "fibonacci", fibonacci)
    assert client.wait_for_server(timeout_sec=5)
    feedback: list[list[int]] = []
    future = client.send_goal_async(
        Fibonacci.Goal(order=5),
        feedback_callback=lambda message: feedback.append(list(message.feedback.sequence)),
    )
    handle = finish(future)
    assert handle.accepted
    assert handle.stamp.sec > 0
    response = finish(handle.get_result_async())
    assert response.status == handle.status == GoalStatus.STATUS_SUCCEEDED
    assert list(response.result.sequence) == [0, 1, 1, 2, 3, 5]
    spin_until(lambda: len(feedback) == 4)
    assert feedback == [[0, 1, 1], [0, 1, 1, 2], [0, 1, 1, 2, 3], [0, 1, 1, 2, 3, 5]]


def test_states_are_published_in_the_order_in_which_they_change(
    server_node: Node, client: ActionClient, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    """A thread has read the states, and publishes them when another thread has changed one."""
    goals: list[ServerGoalHandle] = []
    server = ActionServer(
        server_node, Fibonacci, "fibonacci", fibonacci, handle_accepted_callback=goals.append
    )
    assert client.wait_for_server(timeout_sec=5)
    for _ in range(2):
        finish(client.send_goal_async(Fibonacci.Goal(order=3)))
    published: list[list[int]] = []
    is_reading, may_publish = threading.Event(), threading.Event()

    def publish(message: Any) -> None:
        if not is_reading.is_set():
            is_reading.set()
            assert may_publish.wait(30)
        published.append([goal_status.status for goal_status in message.status_list])

    server._status = SimpleNamespace(publish=publish)
    slow = threading.Thread(target=goals[0].update, args=[GoalEvent.EXECUTE])
    slow.start()
    assert is_reading.wait(30)
    goals[1].update(GoalEvent.EXECUTE)
    may_publish.set()
    slow.join(30)
    assert published[-1] == [GoalStatus.STATUS_EXECUTING] * 2

    def fail(_: Any) -> None:
        raise RuntimeError("the wire has failed")

    # An error of one publication doesn't stop the next.
    server._status = SimpleNamespace(publish=fail)
    with pytest.raises(RuntimeError, match="the wire has failed"):
        goals[0].succeed()
    server._status = SimpleNamespace(publish=publish)
    goals[1].succeed()
    assert published[-1] == [GoalStatus.STATUS_SUCCEEDED] * 2


def test_goal_can_be_rejected(server_node: Node, client: ActionClient, finish: Finish) -> None:
    def judge(goal: Fibonacci.Goal) -> GoalResponse:
        return GoalResponse.ACCEPT if goal.order < 10 else GoalResponse.REJECT

    ActionServer(server_node, Fibonacci, "fibonacci", fibonacci, goal_callback=judge)
    rejected = finish(client.send_goal_async(Fibonacci.Goal(order=10)))
    assert not rejected.accepted
    assert finish(rejected.get_result_async()).status == GoalStatus.STATUS_UNKNOWN
    assert finish(client.send_goal_async(Fibonacci.Goal(order=1))).accepted


def test_goal_id_in_use_is_rejected(
    server_node: Node, client: ActionClient, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    ActionServer(server_node, Fibonacci, "fibonacci", Gated(executor))
    goal_id = new_goal_id()
    goals = [client.send_goal_async(Fibonacci.Goal(), goal_uuid=goal_id) for _ in range(2)]
    assert [finish(goal).accepted for goal in goals] == [True, False]


def test_several_goals_at_once_end_in_any_order(
    server_node: Node, client: ActionClient, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    gated = Gated(executor)
    ActionServer(server_node, Fibonacci, "fibonacci", gated)
    handles = [finish(client.send_goal_async(Fibonacci.Goal(order=order))) for order in range(3)]
    results = [handle.get_result_async() for handle in handles]
    while len(gated.gates) < 3:
        executor.spin_once(timeout_sec=1)
    for number in (2, 0, 1):
        gated.gates[number].set_result(None)
        assert list(finish(results[number]).result.sequence) == [number]


def test_accepted_cancel_ends_the_goal(
    server_node: Node, client: ActionClient, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    gated = Gated(executor)
    ActionServer(
        server_node, Fibonacci, "fibonacci", gated, cancel_callback=lambda handle: CancelResponse.ACCEPT
    )
    handle = finish(client.send_goal_async(Fibonacci.Goal()))
    result = handle.get_result_async()
    response = finish(handle.cancel_goal_async())
    assert response.return_code == CancelGoal.Response.ERROR_NONE
    assert response.goals_canceling[0].goal_id == handle.goal_id
    while not gated.gates:
        executor.spin_once(timeout_sec=1)
    gated.gates[0].set_result(None)
    assert finish(result).status == GoalStatus.STATUS_CANCELED
    late = finish(handle.cancel_goal_async())
    assert late.return_code == CancelGoal.Response.ERROR_GOAL_TERMINATED
    unknown = finish(client.cancel(new_goal_id()))
    assert unknown.return_code == CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID


def test_goals_are_cancelled_by_time_or_all(
    server_node: Node, client: ActionClient, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    server = ActionServer(
        server_node,
        Fibonacci,
        "fibonacci",
        Gated(executor),
        cancel_callback=lambda handle: CancelResponse.ACCEPT,
    )
    handles = [finish(client.send_goal_async(Fibonacci.Goal())) for _ in range(4)]
    until = GoalInfo(stamp=handles[1].stamp)
    until_or_one = GoalInfo(stamp=handles[1].stamp, goal_id=handles[3].goal_id)
    for which, ends in ((until, handles[:2]), (until_or_one, handles[3:]), (GoalInfo(), handles[2:3])):
        response = finish(client._cancel.call_async(CancelGoal.Request(goal_info=which)))
        assert [goal_info.goal_id for goal_info in response.goals_canceling] == [end.goal_id for end in ends]
    nothing = CancelGoal.Request(goal_info=GoalInfo(stamp=Time(sec=1)))
    assert finish(client._cancel.call_async(nothing)).return_code == CancelGoal.Response.ERROR_NONE
    server.destroy()


def test_cancel_is_rejected_by_default(
    server_node: Node, client: ActionClient, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    ActionServer(server_node, Fibonacci, "fibonacci", Gated(executor))
    handle = finish(client.send_goal_async(Fibonacci.Goal()))
    response = finish(handle.cancel_goal_async())
    assert (response.return_code, response.goals_canceling) == (CancelGoal.Response.ERROR_REJECTED, [])


def test_failing_execute_callback_aborts_the_goal(
    server_node: Node, client: ActionClient, finish: Finish, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        raise ValueError("mine")

    server = ActionServer(server_node, Fibonacci, "fibonacci", fails)
    handle = finish(client.send_goal_async(Fibonacci.Goal()))
    assert finish(handle.get_result_async()).status == GoalStatus.STATUS_ABORTED
    printed = capsys.readouterr().err
    assert ".action_server]: Error raised in execute callback: mine" in printed
    assert "ValueError: mine" in printed
    server.register_execute_callback(lambda goal_handle: None)
    handle = finish(client.send_goal_async(Fibonacci.Goal()))
    assert finish(handle.get_result_async()).status == GoalStatus.STATUS_ABORTED
    assert "Goal state not set, assuming aborted" in capsys.readouterr().err


def test_invalid_state_transitions_raise(
    server_node: Node, client: ActionClient, finish: Finish, spin_until: Callable[..., None]
) -> None:
    kept: list[ServerGoalHandle] = []
    ActionServer(server_node, Fibonacci, "fibonacci", fibonacci, handle_accepted_callback=kept.append)
    handle = finish(client.send_goal_async(Fibonacci.Goal(order=1)))
    result = handle.get_result_async()
    spin_until(lambda: kept)
    (goal,) = kept
    assert goal.status == GoalStatus.STATUS_ACCEPTED
    with pytest.raises(RCLError, match="from state ACCEPTED with event SUCCEED"):
        goal.succeed()
    with pytest.raises(RCLError, match="with event CANCELED"):
        goal.canceled()
    with pytest.raises(TypeError, match="Fibonacci_Feedback"):
        goal.publish_feedback(Fibonacci.Goal())
    goal.execute()
    assert finish(result).status == GoalStatus.STATUS_SUCCEEDED
    with pytest.raises(RCLError):
        goal.abort()


def test_results_expire_after_the_timeout(
    server_node: Node, client: ActionClient, finish: Finish, spin_until: Callable[..., None]
) -> None:
    server = ActionServer(server_node, Fibonacci, "fibonacci", fibonacci, result_timeout=0.02)
    handle = finish(client.send_goal_async(Fibonacci.Goal(order=1)))
    assert finish(handle.get_result_async()).status == GoalStatus.STATUS_SUCCEEDED
    spin_until(lambda: not server._goal_handles)
    assert finish(handle.get_result_async()).status == GoalStatus.STATUS_UNKNOWN


def test_results_expire_by_simulated_time(
    server_node: Node, client: ActionClient, finish: Finish, spin_until: Callable[..., None]
) -> None:
    """Where time jumps back, as of a simulation that begins again, or its source changes, the time begins anew."""
    clock = server_node.get_clock()
    assert isinstance(clock, ROSClock)
    server = ActionServer(server_node, Fibonacci, "fibonacci", fibonacci, result_timeout=10.0)

    def set_time(seconds: float) -> None:
        clock.set_ros_time_override(RosTime(seconds=seconds, clock_type=ClockType.ROS_TIME))
        spin_until(lambda: not server._expiry.has_next())

    def status() -> int:
        return int(finish(handle.get_result_async()).status)

    clock.set_ros_time_is_active(True)
    set_time(100.0)
    handle = finish(client.send_goal_async(Fibonacci.Goal(order=1)))
    assert status() == GoalStatus.STATUS_SUCCEEDED
    set_time(109.0)
    assert status() == GoalStatus.STATUS_SUCCEEDED
    set_time(2.0)
    set_time(11.0)
    assert status() == GoalStatus.STATUS_SUCCEEDED
    clock.set_ros_time_is_active(False)
    set_time(13.0)
    clock.set_ros_time_is_active(True)
    set_time(15.0)
    assert status() == GoalStatus.STATUS_SUCCEEDED
    set_time(40.0)
    spin_until(lambda: not server._goal_handles)
    assert status() == GoalStatus.STATUS_UNKNOWN


def test_blocking_calls_work_with_threads(make_node: Callable[..., Node], context: Context) -> None:
    server, caller = make_node("threaded_server"), make_node("caller")
    ActionServer(server, Fibonacci, "fibonacci", fibonacci)
    client = ActionClient(caller, Fibonacci, "fibonacci")
    with MultiThreadedExecutor(2, context=context) as executor:
        executor.add_node(server)
        executor.add_node(caller)
        end: Future[None] = Future()
        thread = threading.Thread(target=lambda: executor.spin_until_future_complete(end, timeout_sec=20))
        thread.start()
        try:
            assert client.wait_for_server(timeout_sec=5)
            response = client.send_goal(Fibonacci.Goal(order=3))
            assert list(response.result.sequence) == [0, 1, 1, 2]
        finally:
            end.set_result(None)
            thread.join(10)


def test_feedback_callbacks_of_ended_goals_are_dropped(
    server_node: Node, client: ActionClient, finish: Finish, spin_until: Callable[..., None]
) -> None:
    """Where nobody requests the results; those of the last goals stay, because feedback may arrive behind the end."""
    ActionServer(server_node, Fibonacci, "fibonacci", fibonacci)
    heard: list[int] = []
    goals = MAX_ENDED + 10
    for number in range(goals):
        finish(
            client.send_goal_async(
                Fibonacci.Goal(order=2), feedback_callback=lambda _, number=number: heard.append(number)
            )
        )
    spin_until(lambda: len(client._feedback_callbacks) == MAX_ENDED)
    spin_until(lambda: len(heard) == goals)
    assert sorted(heard) == list(range(goals))


def test_the_feedback_callback_of_a_goal_that_no_server_has_is_dropped(
    client: ActionClient, executor: SingleThreadedExecutor
) -> None:
    future = client.send_goal_async(Fibonacci.Goal(), feedback_callback=print)
    executor.spin_until_future_complete(future, timeout_sec=5)
    assert isinstance(future.exception(), NoResponseError)
    assert client._feedback_callbacks == {}


@pytest.mark.parametrize("hours", [-1, 0, 1])
def test_feedback_ends_with_the_result_whatever_the_servers_clock_says(
    hours: int, server_node: Node, node: Node, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the server sent before the result and waits behind it is delivered, what it sent after it is not."""
    now_ns = time.time_ns
    monkeypatch.setattr(
        local_endpoints, "time", SimpleNamespace(time_ns=lambda: now_ns() + hours * 3_600_000_000_000)
    )
    may_return = threading.Event()
    heard: list[int] = []
    late: list[ServerGoalHandle] = []

    def execute(goal_handle: ServerGoalHandle) -> Fibonacci.Result:
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[2]))
        goal_handle.succeed()
        late.append(goal_handle)
        return Fibonacci.Result()

    def hear(message: Any) -> None:
        heard.append(message.feedback.sequence[0])
        may_return.wait(30)

    # The first message occupies the callback group, so the second waits until after the result.
    client: ActionClient = ActionClient(
        node, Fibonacci, "shifted", callback_group=MutuallyExclusiveCallbackGroup()
    )
    with (
        ActionServer(server_node, Fibonacci, "shifted", execute),
        MultiThreadedExecutor(4, context=context) as spinning,
    ):
        spinning.add_node(node)
        spinning.add_node(server_node)
        thread = threading.Thread(target=spinning.spin)
        thread.start()
        try:
            assert client.wait_for_server(timeout_sec=30)
            handle = client.wait_for(client.send_goal_async(Fibonacci.Goal(), feedback_callback=hear))
            assert handle is not None
            assert handle.get_result() is not None
            late[0].publish_feedback(Fibonacci.Feedback(sequence=[3]))
            may_return.set()
            wait_until(lambda: len(heard) > 1)
        finally:
            may_return.set()
            spinning.shutdown()
            thread.join()
    assert heard == [1, 2]


def test_wait_for_a_server_that_never_comes_ends(client: ActionClient) -> None:
    assert not client.wait_for_server(timeout_sec=0.01)
    client.destroy()


def test_actions_are_on_the_graph(server_node: Node, client: ActionClient, node: Node) -> None:
    ActionServer(server_node, Fibonacci, "fibonacci", fibonacci)
    expected = [("/fibonacci", ["example_interfaces/action/Fibonacci"])]
    assert get_action_names_and_types(node) == expected
    assert get_action_server_names_and_types_by_node(node, "server", "/") == expected
    assert get_action_server_names_and_types_by_node(node, "tester", "/") == []
    assert get_action_client_names_and_types_by_node(node, "tester", "/") == expected


def test_events_of_an_actions_services_are_published(
    server_node: Node,
    client: ActionClient,
    node: Node,
    finish: Finish,
    executor: SingleThreadedExecutor,
    spin_until: Callable[..., None],
) -> None:
    gated = Gated(executor)
    server = ActionServer(
        server_node, Fibonacci, "fibonacci", gated, cancel_callback=lambda _: CancelResponse.ACCEPT
    )
    impl = Fibonacci.Impl
    services: dict[str, Any] = {
        "send_goal": impl.SendGoalService,
        "cancel_goal": impl.CancelGoalService,
        "get_result": impl.GetResultService,
    }
    events: dict[str, list[Any]] = {name: [] for name in services}
    for name, service in services.items():
        topic = f"/fibonacci/_action/{name}/_service_event"
        node.create_subscription(service.Event, topic, events[name].append, 100)

    def configure(state: ServiceIntrospectionState) -> None:
        for end in (client, server):
            end.configure_introspection(node.get_clock(), QoSProfile(depth=100), state)

    def cancel_a_goal() -> None:
        goal = finish(client.send_goal_async(Fibonacci.Goal(order=7)))
        result = goal.get_result_async()
        finish(goal.cancel_goal_async())
        gated.gates.pop().set_result(None)
        finish(result)

    info = ServiceEventInfo
    kinds = [info.REQUEST_SENT, info.REQUEST_RECEIVED, info.RESPONSE_SENT, info.RESPONSE_RECEIVED]
    configure(ServiceIntrospectionState.METADATA)
    cancel_a_goal()
    spin_until(lambda: all(len(got) == 4 for got in events.values()))
    for got in events.values():
        assert sorted(event.info.event_type for event in got) == sorted(kinds)
        assert len({(tuple(event.info.client_gid), event.info.sequence_number) for event in got}) == 1
        assert not any([*event.request, *event.response] for event in got)
        got.clear()
    configure(ServiceIntrospectionState.CONTENTS)
    cancel_a_goal()
    spin_until(lambda: all(len(got) == 4 for got in events.values()))
    sent = [event for event in events["send_goal"] if event.info.event_type == info.REQUEST_SENT]
    assert sent[0].request[0].goal.order == 7
    received = [event for event in events["get_result"] if event.info.event_type == info.RESPONSE_RECEIVED]
    assert list(received[0].response[0].result.sequence) == [7]
    configure(ServiceIntrospectionState.OFF)
    cancel_a_goal()
    assert all(len(got) == 4 for got in events.values())
    assert not [
        name
        for name, _ in node.get_topic_names_and_types()
        if "_service_event" in name and node.count_publishers(name)
    ]
    for end in (client, server):
        end.destroy()
        with pytest.raises(InvalidHandle):
            end.configure_introspection(
                node.get_clock(), QoSProfile(depth=1), ServiceIntrospectionState.METADATA
            )
