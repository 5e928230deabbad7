"""What follows an end: the second executor, the next endpoint of a name, a timer that was reset, a new context."""

from __future__ import annotations

import threading
from collections.abc import Callable
from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.rosgraph_msgs.msg import Clock as ClockMessage
from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node import client_library as rclpy
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.clock.time_jump import JumpThreshold
from tfloom.node.context.context import Context
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.executing.event_handler import SubscriptionEventCallbacks
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.node.log import log_output
from tfloom.node.log.logging import get_logger
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import InvalidHandle

MakeNode = Callable[..., Node]
SpinUntil = Callable[..., None]
Finish = Callable[[Future[Any]], Any]


@pytest.fixture
def spun(node: Node, executor: SingleThreadedExecutor) -> Node:
    """Return a node that the executor spins."""
    executor.add_node(node)
    return node


# Executors


def test_a_node_that_goes_from_executor_to_executor_is_run_by_the_last_one(
    node: Node, context: Context
) -> None:
    called: list[None] = []
    node.create_timer(0.0, lambda: called.append(None))
    first, second = (SingleThreadedExecutor(context=context) for _ in range(2))
    for former, present in ((None, first), (first, second), (second, first)):
        present.add_node(node)
        assert node.executor is present
        assert present.get_nodes() == [node]
        if former is not None:
            assert former.get_nodes() == []
            called.clear()
            former.spin_once(timeout_sec=0)
            assert called == []
            former.remove_node(node)  # which is not there any more
            assert node.executor is present
        present.spin_once(timeout_sec=30)
        assert called
        called.clear()
    first.shutdown()
    second.shutdown()


def test_a_node_that_is_added_again_does_what_it_did(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    heard: list[int] = []
    node.create_subscription(Int32, "numbers", lambda msg: heard.append(msg.data), 10)
    publisher = node.create_publisher(Int32, "numbers", 10)
    for number in range(3):
        executor.add_node(node)
        publisher.publish(Int32(data=number))
        spin_until(lambda number=number: number in heard)
        executor.remove_node(node)
        assert executor.get_nodes() == []
    assert heard == [0, 1, 2]


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_an_executor_follows_one_that_was_shut_down(
    kind: type[SingleThreadedExecutor], node: Node, context: Context
) -> None:
    called: list[None] = []
    node.create_timer(0.001, lambda: called.append(None))
    for _ in range(3):
        executor = kind(context=context)
        executor.add_node(node)
        called.clear()
        wait_until(lambda executor=executor: executor.spin_once(timeout_sec=0.1) or called)
        assert executor.shutdown()
        assert executor.get_nodes() == []
        # The node may go to the next one, or be left.
        assert node.executor is not executor or not executor._entities


# Contexts


def test_a_context_follows_one_that_was_shut_down() -> None:
    ends: list[int] = []
    for number in range(3):
        with rclpy.init(args=[], context=Context()) as life:
            life.context.on_shutdown(lambda number=number: ends.append(number))
            removed = lambda: ends.append(-1)  # noqa: E731
            life.context.add_shutdown_hook(removed)
            life.context.remove_shutdown_hook(removed)
            node = Node("again", context=life.context)
            assert node.get_node_names() == ["again"]
            rclpy.shutdown(context=life.context)
            node.destroy_node()
        assert ends == list(range(number + 1))
        assert life.context.participant is None
    late: list[None] = []
    life.context.on_shutdown(lambda: late.append(None))
    assert late == [None]
    with pytest.raises(RuntimeError):
        life.context.init([])


def test_the_default_context_is_new_after_each_shutdown() -> None:
    for _ in range(3):
        rclpy.init(args=[])
        assert rclpy.ok()
        node = rclpy.create_node("again")
        rclpy.spin_once(node, timeout_sec=0)
        node.destroy_node()
        rclpy.shutdown()
        assert not rclpy.ok()


# Endpoints


def test_the_next_subscription_of_a_topic_hears_alone(spun: Node, spin_until: SpinUntil) -> None:
    publisher = spun.create_publisher(Int32, "numbers", 10)
    heard: list[tuple[int, int]] = []
    for life in range(3):
        subscription = spun.create_subscription(
            Int32, "numbers", lambda msg, life=life: heard.append((life, msg.data)), 10
        )
        assert publisher.get_subscription_count() == 1
        publisher.publish(Int32(data=life))
        spin_until(lambda life=life: (life, life) in heard)
        publisher.publish(Int32(data=-1))  # which is not taken before the end
        assert spun.destroy_subscription(subscription)
        assert not spun.destroy_subscription(subscription)
        assert publisher.get_subscription_count() == 0
    assert heard == [(0, 0), (1, 1), (2, 2)]
    assert spun.count_subscribers("numbers") == 0


def test_the_next_publisher_of_a_topic_is_heard(spun: Node, spin_until: SpinUntil) -> None:
    heard: list[int] = []
    subscription = spun.create_subscription(Int32, "numbers", lambda msg: heard.append(msg.data), 10)
    for life in range(3):
        publisher = spun.create_publisher(Int32, "numbers", 10)
        assert subscription.get_publisher_count() == 1
        publisher.publish(Int32(data=life))
        spin_until(lambda life=life: heard[-1:] == [life])
        assert spun.destroy_publisher(publisher)
        assert not spun.destroy_publisher(publisher)
        with pytest.raises(InvalidHandle):
            publisher.publish(Int32())
        assert subscription.get_publisher_count() == 0


def test_the_next_handler_of_an_event_is_called_alone(spun: Node, spin_until: SpinUntil) -> None:
    matches: list[tuple[int, int]] = []
    for life in range(3):
        callbacks = SubscriptionEventCallbacks(
            matched=lambda status, life=life: matches.append((life, status.current_count))
        )
        subscription = spun.create_subscription(Int32, "events", print, 10, event_callbacks=callbacks)
        publisher = spun.create_publisher(Int32, "events", 10)
        spin_until(lambda life=life: (life, 1) in matches)
        spun.destroy_subscription(subscription)
        spun.destroy_publisher(publisher)
    assert [life for life, _ in matches] == sorted(life for life, _ in matches)
    assert list(spun.waitables) == []


def test_the_next_server_of_a_service_answers_alone(spun: Node, finish: Finish) -> None:
    client = spun.create_client(SetBool, "switch")
    for life in range(3):

        def answer(_: object, response: SetBool.Response, life: int = life) -> SetBool.Response:
            response.message = str(life)
            return response

        service = spun.create_service(SetBool, "switch", answer)
        assert client.wait_for_service(30)
        assert finish(client.call_async(SetBool.Request())).message == str(life)
        assert spun.destroy_service(service)
        assert not spun.destroy_service(service)
        assert not client.service_is_ready()


def test_a_destroyed_client_leaves_nothing_in_its_executor(
    spun: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, finish: Finish
) -> None:
    """Neither its watch on servers nor the timer of the requests that wait for a server."""
    before = len(executor._entities), len(list(spun._NodeBase__entities.entities()))
    for _ in range(3):
        client = spun.create_client(SetBool, "nobody")
        future = client.call_async(SetBool.Request())
        assert client.unsent_timer is not None
        timer = client.unsent_timer
        assert spun.destroy_client(client)
        assert future.cancelled()
        with pytest.raises(InvalidHandle):
            timer.is_ready()
        assert not spun.destroy_client(client)
        assert (len(executor._entities), len(list(spun._NodeBase__entities.entities()))) == before
    late = spun.create_client(SetBool, "nobody").call_async(SetBool.Request())
    spin_until(late.done)
    assert isinstance(late.exception(), NoResponseError)
    assert not future.done() or future.cancelled()


def test_a_client_goes_on_after_requests_that_were_removed(spun: Node, finish: Finish) -> None:
    asked: list[bool] = []

    def answer(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        asked.append(request.data)
        response.success = request.data
        return response

    client = spun.create_client(SetBool, "switch")
    removed = client.call_async(SetBool.Request(data=False))  # waits for a server
    client.remove_pending_request(removed)
    spun.create_service(SetBool, "switch", answer)
    assert client.wait_for_service(30)
    sent = client.call_async(SetBool.Request(data=False))
    client.remove_pending_request(sent)
    assert finish(client.call_async(SetBool.Request(data=True))).success
    assert asked == [False, True]
    assert not removed.done()
    assert not sent.done()
    assert client._pending == {}


def test_the_next_action_server_and_client_of_a_name_serve_goals(spun: Node, finish: Finish) -> None:
    for life in range(3):

        def execute(goal: Any, life: int = life) -> Fibonacci.Result:
            goal.publish_feedback(Fibonacci.Feedback(sequence=[life]))
            goal.succeed()
            return Fibonacci.Result(sequence=[life])

        feedback: list[int] = []
        server = ActionServer(spun, Fibonacci, "count", execute)
        client = ActionClient(spun, Fibonacci, "count")
        assert client.wait_for_server(30)
        for _ in range(2):
            sent = client.send_goal_async(
                Fibonacci.Goal(),
                feedback_callback=lambda msg, heard=feedback: heard.extend(msg.feedback.sequence),
            )
            result = finish(finish(sent).get_result_async())
            assert list(result.result.sequence) == [life]
        assert feedback == [life] * 2
        client.destroy()
        server.destroy()
        assert spun.count_publishers("count/_action/status") == 0
        assert spun.count_subscribers("count/_action/status") == 0
        assert spun.count_services("count/_action/send_goal") == 0
        assert spun.count_clients("count/_action/send_goal") == 0


# Timers, guard conditions, clocks


def test_a_timer_is_called_after_a_reset_and_never_after_its_end(spun: Node, spin_until: SpinUntil) -> None:
    called: list[None] = []
    others: list[None] = []
    timer = spun.create_timer(0.001, lambda: called.append(None))
    spun.create_timer(0.001, lambda: others.append(None))
    for end in ("cancel", "cancel", "destroy"):
        called.clear()
        spin_until(lambda: called)
        timer.cancel() if end == "cancel" else spun.destroy_timer(timer)
        called.clear()
        others.clear()
        spin_until(lambda: len(others) > 5)
        assert called == []
        if end == "cancel":
            assert timer.is_canceled()
            assert timer.time_until_next_call() is None
            timer.reset()
            assert not timer.is_canceled()
    with pytest.raises(InvalidHandle):
        timer.reset()
    assert not spun.destroy_timer(timer)


def test_a_rate_that_is_destroyed_ends_its_sleeps_and_another_one_ticks(node: Node, context: Context) -> None:
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=lambda: executor.spin_until_future_complete(over))
    over: Future[None] = Future()
    spinning.start()
    slow = node.create_rate(0.001)
    ended = threading.Event()

    def sleep() -> None:
        slow.sleep()
        ended.set()

    sleeper = threading.Thread(target=sleep, daemon=True)
    sleeper.start()
    assert not ended.wait(0.05)
    entities = len(list(node._NodeBase__entities.entities()))
    assert node.destroy_rate(slow)
    assert ended.wait(30)
    assert not node.destroy_rate(slow)
    assert len(list(node._NodeBase__entities.entities())) == entities - 1
    fast = node.create_rate(1000.0)
    for _ in range(3):
        fast.sleep()
    over.set_result(None)
    spinning.join(30)
    executor.shutdown()


def test_the_next_guard_condition_is_called_alone(spun: Node, spin_until: SpinUntil) -> None:
    called: list[int] = []
    for life in range(3):
        guard = spun.create_guard_condition(lambda life=life: called.append(life))
        guard.trigger()
        spin_until(lambda life=life: called[-1:] == [life])
        guard.trigger()  # which is not run before the end
        assert spun.destroy_guard_condition(guard)
        assert not spun.destroy_guard_condition(guard)
    assert called == [0, 1, 2]


def test_jump_callbacks_are_called_until_they_are_removed(node: Node) -> None:
    clock = node.get_clock()
    jumps: list[str] = []
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None)
    kept = clock.create_jump_callback(threshold, post_callback=lambda _: jumps.append("kept"))
    for life in ("first", "second"):
        handle = clock.create_jump_callback(threshold, post_callback=lambda _, life=life: jumps.append(life))
        node.set_parameters([Parameter("use_sim_time", value=True)])
        assert jumps == ["kept", life]
        handle.unregister()
        handle.unregister()
        node.set_parameters([Parameter("use_sim_time", value=False)])
        assert jumps == ["kept", life, "kept"]
        jumps.clear()
    kept.unregister()
    node.set_parameters([Parameter("use_sim_time", value=True)])
    assert jumps == []


def test_simulated_time_is_heard_again_after_it_was_left(spun: Node, spin_until: SpinUntil) -> None:
    publisher = spun.create_publisher(ClockMessage, "/clock", 10)
    for second in (7, 9):
        spun.set_parameters([Parameter("use_sim_time", value=True)])
        assert publisher.get_subscription_count() == 1
        message = ClockMessage()
        message.clock.sec = second
        publisher.publish(message)
        spin_until(lambda second=second: spun.get_clock().now().nanoseconds == second * 10**9)
        spun.set_parameters([Parameter("use_sim_time", value=False)])
        assert publisher.get_subscription_count() == 0
        assert spun.get_clock().now().nanoseconds > 10**15


# Parameters and states


def test_parameter_callbacks_are_called_until_they_are_removed(node: Node) -> None:
    node.declare_parameter("speed", 1.0)
    called: list[str] = []
    result = node.set_parameters([])

    def adder(kind: str, name: str) -> tuple[Callable[[Any], None], Callable[..., Any]]:
        def callback(parameters: list[Parameter]) -> Any:
            called.append(f"{kind} {name}")
            if kind == "pre":
                return parameters
            if kind == "on":
                from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult

                return SetParametersResult(successful=True)
            return None

        method = {
            "pre": "pre_set_parameters_callback",
            "on": "on_set_parameters_callback",
            "post": "post_set_parameters_callback",
        }[kind]
        getattr(node, f"add_{method}")(callback)
        return getattr(node, f"remove_{method}"), callback

    kept = [adder(kind, "kept") for kind in ("pre", "on", "post")]
    for life in ("first", "second"):
        added = [adder(kind, life) for kind in ("pre", "on", "post")]
        node.set_parameters([Parameter("speed", value=2.0)])
        assert sorted(called) == sorted(f"{k} {n}" for k in ("pre", "on", "post") for n in ("kept", life))
        called.clear()
        for remove, callback in added:
            remove(callback)
        node.set_parameters([Parameter("speed", value=3.0)])
        assert called == ["pre kept", "on kept", "post kept"]
        called.clear()
    for remove, callback in kept:
        remove(callback)
    node.set_parameters([Parameter("speed", value=4.0)])
    assert called == []
    assert result == []


def test_the_next_parameter_event_handler_is_called_alone(
    make_node: MakeNode, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    node = make_node()
    executor.add_node(node)
    node.declare_parameter("speed", 0)
    heard: list[tuple[str, int]] = []
    for number, life in enumerate(("first", "second"), 1):
        handler = ParameterEventHandler(node)
        removed = handler.add_parameter_callback("speed", node.get_name(), lambda p: heard.append(("", -1)))
        handler.add_parameter_callback(
            "speed", node.get_name(), lambda p, life=life: heard.append((life, p.value.integer_value))
        )
        handler.remove_parameter_callback(removed)
        node.set_parameters([Parameter("speed", value=number)])
        spin_until(lambda life=life, number=number: (life, number) in heard)
        handler.destroy()
    assert heard == [("first", 1), ("second", 2)]
    assert node.count_subscribers("/parameter_events") == 0


def test_a_lifecycle_node_is_configured_again_and_its_destroyed_publisher_is_left_alone(
    context: Context, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    node = LifecycleNode("managed", context=context)
    executor.add_node(node)
    heard: list[int] = []
    node.create_subscription(Int32, "numbers", lambda msg: heard.append(msg.data), 10)
    for life in range(3):
        publisher = node.create_lifecycle_publisher(Int32, "numbers", 10)
        node.trigger_configure()
        publisher.publish(Int32(data=-1))
        node.trigger_activate()
        assert publisher.is_activated
        publisher.publish(Int32(data=life))
        spin_until(lambda life=life: life in heard)
        node.trigger_deactivate()
        assert not publisher.is_activated
        publisher.publish(Int32(data=-2))
        node.trigger_cleanup()
        node.destroy_lifecycle_publisher(publisher)
        assert node.count_publishers("numbers") == 0
    assert heard == [0, 1, 2]
    node.destroy_node()


# Logs and futures


def test_listeners_of_logs_are_called_until_they_are_removed() -> None:
    heard: list[str] = []
    first, second = (lambda record, name=name: heard.append(f"{name} {record.message}") for name in "ab")
    log_output.add_listener("listened", first)
    log_output.add_listener("listened", second)
    for text in ("one", "two"):
        get_logger("listened").info(text)
        log_output.remove_listener("listened", second)
        log_output.remove_listener("listened", second)
        get_logger("listened").info(text)
        log_output.add_listener("listened", second)
    assert heard == ["a one", "b one", "a one", "a two", "b two", "a two"]
    for listener in (first, second):
        log_output.remove_listener("listened", listener)
    get_logger("listened").info("three")
    assert len(heard) == 6
    assert "listened" not in log_output._listeners


def test_done_callbacks_are_called_until_they_are_removed() -> None:
    called: list[str] = []
    future: Future[int] = Future()
    removed = lambda _: called.append("removed")  # noqa: E731
    for _ in range(2):
        future.add_done_callback(removed)
    future.add_done_callback(lambda _: called.append("kept"))
    assert [future.remove_done_callback(removed) for _ in range(3)] == [True, True, False]
    future.set_result(1)
    assert called == ["kept"]
    late: list[None] = []
    future.add_done_callback(lambda _: late.append(None))
    assert late == [None]
    cancelled: Future[int] = Future()
    cancelled.cancel()
    cancelled.cancel()
    assert cancelled.cancelled()


# Nodes


def test_the_next_node_of_a_name_is_whole_and_alone(
    context: Context, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    witness = Node("witness", context=context)
    for _ in range(3):
        node = Node("again", context=context)
        executor.add_node(node)
        node.create_service(SetBool, "switch", lambda _, response: response)
        client = node.create_client(SetBool, "switch")
        assert client.wait_for_service(30)
        finish(client.call_async(SetBool.Request()))
        assert witness.get_node_names().count("again") == 1
        node.destroy_node()
        node.destroy_node()
        assert executor.get_nodes() == []
        assert witness.get_node_names() == ["witness"]
        assert witness.count_services("switch") == 0
        assert witness.get_service_names_and_types_by_node("witness", "/") != []
        with pytest.raises(InvalidHandle):
            node.create_publisher(Int32, "numbers", 10)
    witness.destroy_node()


@pytest.mark.parametrize("kind", [np.float16, np.float32, Decimal, int])
def test_a_rate_of_any_number_has_the_exact_period(node: Node, kind: Callable[[int], Any]) -> None:
    assert node.create_rate(kind(5)).timer.timer_period_ns == 200_000_000


def test_a_client_names_its_context_also_when_it_is_destroyed(node: Node, context: Context) -> None:
    client = node.create_client(SetBool, "switch")
    assert client.context is context
    node.destroy_client(client)
    assert client.context is context
