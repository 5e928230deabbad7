"""Every kind of callback of rclpy, each made to raise once: who learns of it, and that the next call is made.

Each function is a row. It returns what must have come out of spins, as the real rclpy's executors raise it; what else
may learn of an exception, as the caller of a method, it checks itself.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.faults.conftest import Fails, Injected, World

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult
from tfloom.interfaces.std_msgs.msg import Int32, String
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.clock.clock import ROSClock
from tfloom.node.clock.time_jump import JumpThreshold
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.task import Future
from tfloom.node.executing.waitable import Waitable
from tfloom.node.lifecycle.managed_entity import ManagedEntity
from tfloom.node.lifecycle.node import LifecycleNode, TransitionCallbackReturn
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import LivelinessPolicy, QoSProfile, ReliabilityPolicy
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time

Row = Callable[[World], list[Exception]]
Adapt = Callable[[Fails], Any]
"""What gives the failing function to rclpy: as it is, in a function of another form, or as one of several callbacks."""

EVERY_JUMP = JumpThreshold(
    min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1), on_clock_change=True
)


def _as_it_is(fails: Fails) -> Fails:
    return fails


def _with_info(fails: Fails) -> Callable[..., Any]:
    return lambda message, info: fails(message, info)  # noqa: PLW0108  # the second parameter asks for it


def _of(kind: Callable[..., Any], event: str) -> Adapt:
    return lambda fails: kind(**{event: fails})


# Topics and their events


def _messages(world: World, adapt: Adapt, **options: Any) -> list[Exception]:
    fails = Fails()
    publisher = world.connect(Int32, adapt(fails), **options)
    for number in range(3):
        publisher.publish(Int32(data=number))
    wait_until(lambda: fails.was_called(3), what="the messages after the failure")
    return [fails.error]


def _coroutine(fails: Fails) -> Callable[..., Any]:
    async def callback(*args: Any) -> Any:
        return fails(*args)

    return callback


def _matched(world: World, adapt: Adapt) -> list[Exception]:
    """Let a subscription, or publisher, with event callbacks meet two peers, of which the first leaves."""
    node, fails = world.node, Fails()
    callbacks = adapt(fails)
    if isinstance(callbacks, PublisherEventCallbacks):
        node.create_publisher(Int32, "events", 10, event_callbacks=callbacks)
        peers: Any = lambda: node.create_subscription(Int32, "events", print, 10)  # noqa: E731
        leave: Any = node.destroy_subscription
    else:
        node.create_subscription(Int32, "events", print, 10, event_callbacks=callbacks)
        peers, leave = lambda: node.create_publisher(Int32, "events", 10), node.destroy_publisher
    first = peers()
    wait_until(lambda: fails.was_called(1))
    wait_until(lambda: world.raised)
    leave(first)
    wait_until(lambda: fails.was_called(2), what="the event after the failure")
    return [fails.error]


def _incompatible_qos(world: World, adapt: Adapt) -> list[Exception]:
    fails = Fails()
    callbacks = adapt(fails)
    is_publisher = isinstance(callbacks, PublisherEventCallbacks)
    of_subscriptions: Any = SubscriptionEventCallbacks(use_default_callbacks=False)
    of_publishers: Any = PublisherEventCallbacks(use_default_callbacks=False)
    if is_publisher:
        of_publishers = callbacks
    else:
        of_subscriptions = callbacks
    reliable, best_effort = (
        QoSProfile(depth=1, reliability=policy)
        for policy in (ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT)
    )
    for _ in range(2):
        world.node.create_publisher(Int32, "qos", best_effort, event_callbacks=of_publishers)
        world.node.create_subscription(Int32, "qos", print, reliable, event_callbacks=of_subscriptions)
        wait_until(lambda: world.raised)
    wait_until(lambda: fails.was_called(2), what="the event after the failure")
    return [fails.error]


def _incompatible_type(world: World, adapt: Adapt) -> list[Exception]:
    fails = Fails()
    callbacks = adapt(fails)
    if isinstance(callbacks, PublisherEventCallbacks):
        world.node.create_publisher(Int32, "types", 1, event_callbacks=callbacks)
        meet: Any = lambda: world.node.create_subscription(String, "types", print, 1)  # noqa: E731
    else:
        world.node.create_subscription(Int32, "types", print, 1, event_callbacks=callbacks)
        meet = lambda: world.node.create_publisher(String, "types", 1)  # noqa: E731
    meet()
    wait_until(lambda: world.raised)
    meet()
    wait_until(lambda: fails.was_called(2), what="the event after the failure")
    return [fails.error]


LATE = Duration(seconds=0.05)
DEADLINE: dict[str, Any] = {"deadline": LATE}
"""Alone, because a writer whose liveliness is lost at the same time may end the watch for the deadline."""
LIVELINESS: dict[str, Any] = {
    "liveliness": LivelinessPolicy.MANUAL_BY_TOPIC,
    "liveliness_lease_duration": LATE,
}


def _late(world: World, adapt: Adapt, policies: dict[str, Any]) -> list[Exception]:
    """Publish once; then a deadline passes, again and again, or a liveliness is lost and regained."""
    if world.is_local:  # which reports neither
        return _matched(world, lambda fails: SubscriptionEventCallbacks(matched=fails))
    fails = Fails()
    callbacks = adapt(fails)
    is_publisher = isinstance(callbacks, PublisherEventCallbacks)
    qos = QoSProfile(depth=1, **policies)
    subscription = world.node.create_subscription(
        Int32, "late", print, qos, event_callbacks=None if is_publisher else callbacks
    )
    publisher = world.node.create_publisher(
        Int32, "late", qos, event_callbacks=callbacks if is_publisher else None
    )
    wait_until(lambda: publisher.get_subscription_count() and subscription.get_publisher_count())

    def is_called_again() -> bool:
        before = len(fails.calls)
        publisher.publish(Int32())
        wait_until(lambda: len(fails.calls) > before)
        return fails.was_called(2)

    wait_until(is_called_again, what="the event after the failure")
    return [fails.error]


def qos_overriding(world: World) -> list[Exception]:
    fails = Fails(lambda _: SimpleNamespace(successful=True, reason=""))
    options = QoSOverridingOptions.with_default_policies(callback=fails)

    def create() -> Any:
        return world.node.create_publisher(Int32, "overridden", 10, qos_overriding_options=options)

    with pytest.raises(Injected):
        create()
    assert world.node.count_publishers("overridden") == 0
    return []


# What a program triggers


def _timer(world: World, adapt: Adapt) -> list[Exception]:
    fails = Fails()
    world.node.create_timer(0.005, adapt(fails))
    wait_until(lambda: fails.was_called(3))
    return [fails.error]


def guard_condition(world: World) -> list[Exception]:
    fails = Fails()
    guard = world.node.create_guard_condition(fails)
    for number in (1, 2):
        guard.trigger()
        wait_until(lambda number=number: fails.was_called(number))
    return [fails.error]


def _waitable(world: World, failing: str) -> list[Exception]:
    """Let one method of a waitable raise, beside its guard condition, which is triggered twice."""
    fails = Fails()
    executed: list[object] = []

    class Waiting(Waitable):
        def __init__(self) -> None:
            super().__init__(MutuallyExclusiveCallbackGroup())
            self.guard = GuardCondition(None, None)
            self.index: int | None = None
            self.is_triggered = False
            self.fails_now = False

        def _fail(self, method: str) -> None:
            if self.fails_now and method == failing:
                self.fails_now = False
                fails()

        def add_to_wait_set(self, wait_set: Any) -> None:
            self._fail("add_to_wait_set")
            self.index = wait_set.add_guard_condition(self.guard)

        def is_ready(self, wait_set: Any) -> bool:
            self._fail("is_ready")
            self.is_triggered = wait_set.is_ready("guard_condition", self.index) or self.is_triggered
            return self.is_triggered

        def take_data(self) -> Any:
            self.is_triggered = False
            self._fail("take_data")
            return "data"

        async def execute(self, data: Any) -> None:
            self._fail("execute")
            executed.append(data)

    waiting = Waiting()
    world.node.add_waitable(waiting)
    waiting.guard.trigger()
    wait_until(lambda: executed)
    waiting.fails_now = True
    waiting.guard.trigger()
    wait_until(lambda: world.raised)
    before = len(executed)
    waiting.guard.trigger()
    wait_until(lambda: len(executed) > before, what="the waitable after the failure")
    return [fails.error]


def task(world: World) -> list[Exception]:
    fails = Fails()
    first, second = world.executor.create_task(fails), world.executor.create_task(fails)
    wait_until(lambda: first.done() and second.done())
    assert (first.exception(), second.exception()) == (fails.error, None)
    return [fails.error]


def task_coroutine(world: World) -> list[Exception]:
    fails = Fails()
    gate: Future[None] = Future()

    async def run() -> None:
        await gate
        fails()

    first, second = world.executor.create_task(run), world.executor.create_task(run())
    gate.set_result(None)
    wait_until(lambda: first.done() and second.done())
    return [fails.error]


def on_shutdown(world: World) -> list[Exception]:
    fails, other = Fails(), Fails()
    other.calls.append(())  # this one does not fail
    world.context.on_shutdown(fails)
    world.context.on_shutdown(other)
    world.check_others()
    world.context.shutdown()
    assert (fails.was_called(1), other.was_called(2)) == (True, True)
    return []


# Services and futures


def _calls(world: World, adapt: Adapt) -> list[Exception]:
    """Call a service whose callback fails, and again; the first call has no response, as from a real rclpy."""
    fails = Fails(lambda _, response: response)
    world.node.create_service(Trigger, "failing", adapt(fails))
    client = world.watch(world.node.create_client(Trigger, "failing"))
    assert client.wait_for_service(30)
    first, second = (client.call_async(Trigger.Request()) for _ in range(2))
    wait_until(second.done, what="the response after the failure")
    wait_until(lambda: world.raised)
    assert (first.done(), second.exception()) == (False, None)
    return [fails.error]


def _call(world: World) -> Future[Any]:
    assert world._client.wait_for_service(30)
    return world._client.call_async(Trigger.Request())


def done_callback_of_a_call(world: World) -> list[Exception]:
    fails, others = Fails(), Fails()
    others.calls.append(())
    future = _call(world)
    future.add_done_callback(fails)
    future.add_done_callback(others)
    wait_until(lambda: fails.was_called(1) and others.was_called(2))
    _call(world).add_done_callback(fails)
    wait_until(lambda: fails.was_called(2))
    return [fails.error]


def done_callback_of_a_future(world: World) -> list[Exception]:
    """Without an executor, the thread that completes the future prints the exception, and goes on."""
    fails, others = Fails(), Fails()
    others.calls.append(())
    future: Future[int] = Future()
    world.watch(future)
    future.add_done_callback(fails)
    future.add_done_callback(others)
    future.set_result(1)
    assert (fails.was_called(1), others.was_called(2), future.result()) == (True, True, 1)
    return []


def done_callback_of_an_executors_future(world: World) -> list[Exception]:
    fails, others = Fails(), Fails()
    others.calls.append(())
    future = world.executor.create_future()
    future.add_done_callback(fails)
    future.add_done_callback(others)
    future.set_result(1)
    wait_until(lambda: fails.was_called(1) and others.was_called(2))
    return [fails.error]


def resumption_of_a_future(world: World) -> list[Exception]:
    """The call that completes the future raises the exception; other tasks that await it go on."""
    fails, resumed = Fails(), []
    future: Future[int] = Future()
    future.when_complete(fails)

    async def wait() -> None:
        resumed.append(await future)

    waiting = world.executor.create_task(wait)
    asking = world.executor.create_task(lambda: None)
    wait_until(asking.done)  # the first task awaits now, but on a pool of threads, where it soon does
    wait_until(lambda: len(future._resumers) == 2)
    with pytest.raises(Injected):
        future.set_result(7)
    wait_until(waiting.done)
    assert resumed == [7]
    return []


def callback_beside_asyncio(world: World) -> list[Exception]:
    """An asyncio program awaits a call while a callback raises on the thread that spins."""
    fails = Fails()
    world.node.create_timer(0.005, fails)

    async def program() -> Any:
        return await _call(world)

    assert isinstance(asyncio.run(asyncio.wait_for(program(), 30)), Trigger.Response)
    wait_until(lambda: fails.was_called(2))
    return [fails.error]


# Actions


def _execute(goal: Any) -> Fibonacci.Result:
    goal.publish_feedback(Fibonacci.Feedback(sequence=[1]))
    goal.succeed()
    return Fibonacci.Result(sequence=[2])


def _action(world: World, execute: Callable[..., Any] = _execute, **callbacks: Any) -> ActionClient:
    world.watch(ActionServer(world.node, Fibonacci, "count", execute, **callbacks))
    client = world.watch(ActionClient(world.node, Fibonacci, "count"))
    assert client.wait_for_server(30)
    return client


def _send(client: ActionClient, **options: Any) -> Any:
    future = client.send_goal_async(Fibonacci.Goal(order=1), **options)
    wait_until(future.done, what="the response to a goal")
    return future.result()


def _succeeds(client: ActionClient, **options: Any) -> None:
    result = _send(client, **options).get_result_async()
    wait_until(result.done, what="the result of a goal")
    assert list(result.result().result.sequence) == [2]


def action_goal(world: World) -> list[Exception]:
    fails = Fails(lambda _: GoalResponse.ACCEPT)
    client = _action(world, goal_callback=fails)
    client.send_goal_async(Fibonacci.Goal(order=1))
    wait_until(lambda: world.raised)
    _succeeds(client)
    return [fails.error]


def action_handle_accepted(world: World) -> list[Exception]:
    fails = Fails(lambda goal: goal.execute())
    client = _action(world, handle_accepted_callback=fails)
    assert _send(client).accepted
    _succeeds(client)
    return [fails.error]


def action_execute(world: World) -> list[Exception]:
    """The goal is aborted, and the exception printed."""
    fails = Fails(_execute)
    client = _action(world, fails)
    result = _send(client).get_result_async()
    wait_until(result.done)
    assert result.result().status == 6  # aborted
    _succeeds(client)
    return []


def action_cancel(world: World) -> list[Exception]:
    """The goal of which the callback raised goes on; the others are asked, and the client has a response."""
    fails = Fails(lambda _: CancelResponse.ACCEPT)
    gate: Future[None] = Future()

    async def execute(goal: Any) -> Fibonacci.Result:
        await gate
        if goal.is_cancel_requested:
            goal.canceled()
            return Fibonacci.Result()
        return _execute(goal)

    client = _action(world, execute, cancel_callback=fails)
    goals = [_send(client) for _ in range(2)]
    from tfloom.interfaces.action_msgs.srv import CancelGoal

    future = client._cancel.call_async(CancelGoal.Request())  # of all goals
    wait_until(future.done, what="the response to the cancellation")
    assert len(future.result().goals_canceling) == 1
    gate.set_result(None)
    results = [goal.get_result_async() for goal in goals]
    wait_until(lambda: all(result.done() for result in results))
    assert sorted(result.result().status for result in results) == [4, 5]  # succeeded, canceled
    return [fails.error]


def action_feedback(world: World) -> list[Exception]:
    fails = Fails()
    client = _action(world)
    _succeeds(client, feedback_callback=fails)
    _succeeds(client, feedback_callback=fails)
    wait_until(lambda: fails.was_called(2))
    return [fails.error]


def action_goal_response(world: World) -> list[Exception]:
    fails = Fails()
    client = _action(world)
    for number in (1, 2):
        client.send_goal_async(Fibonacci.Goal(order=1)).add_done_callback(fails)
        wait_until(lambda number=number: fails.was_called(number))
    _succeeds(client)
    return [fails.error]


def action_result(world: World) -> list[Exception]:
    fails = Fails()
    client = _action(world)
    for number in (1, 2):
        _send(client).get_result_async().add_done_callback(fails)
        wait_until(lambda number=number: fails.was_called(number))
    return [fails.error]


# Parameters


def _set(world: World, value: int) -> Any:
    return world.node.set_parameters([Parameter("number", value=value)])[0]


def _declare(world: World) -> None:
    world.node.declare_parameter("number", 0)


def pre_set_parameters(world: World) -> list[Exception]:
    _declare(world)
    fails = Fails(lambda parameters: parameters)
    world.node.add_pre_set_parameters_callback(fails)
    with pytest.raises(Injected):
        _set(world, 1)
    assert world.node.get_parameter("number").value == 0
    assert _set(world, 2).successful
    return []


def on_set_parameters(world: World) -> list[Exception]:
    _declare(world)
    fails = Fails(lambda _: SetParametersResult(successful=True))
    world.node.add_on_set_parameters_callback(fails)
    with pytest.raises(Injected):
        _set(world, 1)
    assert world.node.get_parameter("number").value == 0
    assert _set(world, 2).successful
    return []


def post_set_parameters(world: World) -> list[Exception]:
    """The parameter is set, and the callback that was added before is called."""
    _declare(world)
    fails, others = Fails(), Fails()
    others.calls.append(())
    world.node.add_post_set_parameters_callback(others)
    world.node.add_post_set_parameters_callback(fails)
    with pytest.raises(Injected):
        _set(world, 1)
    assert (world.node.get_parameter("number").value, len(others.calls)) == (1, 2)
    assert _set(world, 2).successful
    return []


def _remote(world: World) -> AsyncParameterClient:
    client = AsyncParameterClient(world.node, "under_test")
    assert client.wait_for_services(30)
    return client


def on_set_parameters_by_a_client(world: World) -> list[Exception]:
    _declare(world)
    fails = Fails(lambda _: SetParametersResult(successful=True))
    world.node.add_on_set_parameters_callback(fails)
    client = _remote(world)
    client.set_parameters([Parameter("number", value=1)])
    wait_until(lambda: world.raised)
    future = client.set_parameters([Parameter("number", value=2)])
    wait_until(future.done)
    assert future.result().results[0].successful
    return [fails.error]


def parameter_client(world: World) -> list[Exception]:
    _declare(world)
    fails = Fails()
    client = _remote(world)
    for number in (1, 2):
        client.get_parameters(["number"], callback=fails)
        wait_until(lambda number=number: fails.was_called(number))
    return [fails.error]


def _events(world: World, add: Callable[[ParameterEventHandler, Fails], None]) -> list[Exception]:
    """Let the first of three callbacks of a handler raise, twice told of a change; the other two are called."""
    _declare(world)
    handler = ParameterEventHandler(world.node)
    fails, others, events = Fails(), Fails(), Fails()
    others.calls.append(())
    events.calls.append(())
    handler.add_parameter_callback("number", "under_test", others)
    handler.add_parameter_event_callback(events)
    add(handler, fails)
    wait_until(handler.parameter_event_subscription.get_publisher_count)
    wait_until(lambda: world.node.count_subscribers("/parameter_events"))
    for number in (1, 2):
        _set(world, number)
        wait_until(lambda number=number: fails.was_called(number), what="the event")
    wait_until(
        lambda: (others.was_called(3), events.was_called(3)) == (True, True), what="the other callbacks"
    )
    return [fails.error]


def _add_parameter_callback(handler: ParameterEventHandler, fails: Fails) -> None:
    handler.add_parameter_callback("number", "under_test", fails)


# Time


def _jumps(world: World, failing: str) -> list[Exception]:
    """Let the first of two callbacks of a clock raise at a jump, and check that the time is set, twice."""
    clock = world.watch(ROSClock())
    clock.set_ros_time_is_active(True)
    others = Fails()
    others.calls.append(())
    clock.create_jump_callback(EVERY_JUMP, **{failing: Fails()})
    clock.create_jump_callback(EVERY_JUMP, post_callback=others)
    with pytest.raises(Injected):
        clock.set_ros_time_override(Time(seconds=5, clock_type=clock.clock_type))
    assert (clock.now().nanoseconds, len(others.calls)) == (5 * 10**9, 2)
    clock.set_ros_time_override(Time(seconds=6, clock_type=clock.clock_type))
    assert (clock.now().nanoseconds, len(others.calls)) == (6 * 10**9, 3)
    return []


def jump_callback_at_the_start_of_simulated_time(world: World) -> list[Exception]:
    """The node hears /clock, and its timers run by it, although a callback for the jump to it raises."""
    from tfloom.interfaces.rosgraph_msgs.msg import Clock

    fails, ticks = Fails(), []
    world.node.get_clock().create_jump_callback(EVERY_JUMP, post_callback=fails)
    world.node.create_timer(1.0, lambda: ticks.append(world.node.get_clock().now().nanoseconds))
    with pytest.raises(Injected):
        world.node.set_parameters([Parameter("use_sim_time", value=True)])
    publisher = world.node.create_publisher(Clock, "/clock", 1)
    wait_until(publisher.get_subscription_count, what="a subscription to /clock")

    def has_ticked() -> bool:
        message = Clock()
        message.clock.sec = 1000 + len(fails.calls)
        publisher.publish(message)
        return len(ticks) > 1

    wait_until(has_ticked, what="timers by simulated time")
    return []


# Lifecycle


def _lifecycle(world: World, failing: str, labels: str) -> list[Exception]:
    """Let a transition's callback raise: `on_error` follows, and the node can be configured again."""
    fails = Fails(lambda _: TransitionCallbackReturn.SUCCESS)
    kind = type("Living", (LifecycleNode,), {failing: lambda _, state: fails(state)})
    node = kind("living", context=world.context)
    world.executor.add_node(node)
    try:
        results = [getattr(node, f"trigger_{label}")() for label in labels.split()]
        assert results[-1] is TransitionCallbackReturn.ERROR
        assert node.trigger_configure() is TransitionCallbackReturn.SUCCESS
        assert node.trigger_activate() is TransitionCallbackReturn.SUCCESS
    finally:
        world.executor.remove_node(node)
        node.destroy_node()
    return []


def on_error(world: World) -> list[Exception]:
    """The node is finalized, as after any failure of `on_error`."""

    class Living(LifecycleNode):
        def on_configure(self, state: Any) -> Any:
            raise Injected

        def on_error(self, state: Any) -> Any:
            raise Injected

    node = Living("living", context=world.context)
    assert node.trigger_configure() is TransitionCallbackReturn.ERROR
    assert node._state_machine.state.label == "finalized"
    node.destroy_node()
    return []


def managed_entity(world: World) -> list[Exception]:
    fails = Fails(lambda _: TransitionCallbackReturn.SUCCESS)

    class Managed(ManagedEntity):
        def on_configure(self, state: Any) -> Any:
            return fails(state)

    node = LifecycleNode("living", context=world.context)
    node.add_managed_entity(Managed())
    assert node.trigger_configure() is TransitionCallbackReturn.ERROR
    assert node.trigger_configure() is TransitionCallbackReturn.SUCCESS
    node.destroy_node()
    return []


_EVENTS: dict[str, Callable[..., list[Exception]]] = {
    "matched": _matched,
    "incompatible_qos": _incompatible_qos,
    "incompatible_type": _incompatible_type,
    "deadline": partial(_late, policies=DEADLINE),
    "liveliness": partial(_late, policies=LIVELINESS),
}
_ENDS = {"publisher": PublisherEventCallbacks, "subscription": SubscriptionEventCallbacks}
_TABLE: dict[str, Row] = {
    "subscription": partial(_messages, adapt=_as_it_is),
    "subscription_with_info": partial(_messages, adapt=_with_info),
    "subscription_raw": partial(_messages, adapt=_as_it_is, raw=True),
    "subscription_coroutine": partial(_messages, adapt=_coroutine),
    **{
        f"{event}_of_{end}": partial(row, adapt=_of(kind, event))
        for event, row in _EVENTS.items()
        for end, kind in _ENDS.items()
    },
    "timer": partial(_timer, adapt=_as_it_is),
    "timer_coroutine": partial(_timer, adapt=_coroutine),
    **{
        f"waitable_{method}": partial(_waitable, failing=method)
        for method in ("add_to_wait_set", "is_ready", "take_data", "execute")
    },
    "service": partial(_calls, adapt=_as_it_is),
    "service_coroutine": partial(_calls, adapt=_coroutine),
    "parameter_callback": partial(_events, add=_add_parameter_callback),
    "parameter_event_callback": partial(_events, add=ParameterEventHandler.add_parameter_event_callback),
    "jump_pre_callback": partial(_jumps, failing="pre_callback"),
    "jump_post_callback": partial(_jumps, failing="post_callback"),
    "on_configure": partial(_lifecycle, failing="on_configure", labels="configure"),
    "on_activate": partial(_lifecycle, failing="on_activate", labels="configure activate"),
    "on_deactivate": partial(_lifecycle, failing="on_deactivate", labels="configure activate deactivate"),
    "on_cleanup": partial(_lifecycle, failing="on_cleanup", labels="configure cleanup"),
    "on_shutdown_of_lifecycle": partial(_lifecycle, failing="on_shutdown", labels="shutdown"),
}
"""The rows that differ from others by what fails alone."""

ROWS: dict[str, Row] = _TABLE | {
    name: row
    for name, row in list(globals().items())
    if getattr(row, "__module__", None) == __name__ and not name.startswith("_") and callable(row)
}
