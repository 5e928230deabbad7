"""What a program may do again and again: each public call that waits, creates or spins, once in a round."""

from __future__ import annotations

import asyncio
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from tfloom.interfaces.geometry_msgs.msg import PointStamped, TransformStamped
from tfloom.interfaces.std_msgs.msg import Header, String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.interfaces.turtlesim.action import RotateAbsolute
from tfloom.node import client_library as rclpy
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer, CancelResponse
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.context import utilities
from tfloom.node.context.context import Context
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.executing.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.executor import Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.signals import SignalHandlerGuardCondition
from tfloom.node.executing.task import Future
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import ExternalShutdownException, TimeoutException
from tfloom.node.values.time import Time
from tfloom.node.wait_for_message import wait_for_message
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.buffer_client import BufferClient
from tfloom.tf2_ros.buffer_server import BufferServer
from tfloom.tf2_ros.message_filter import MessageFilter
from tfloom.tf2_ros.message_filters import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    Subscriber,
    TimeSynchronizer,
)
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import StaticTransformListener, TransformListener

SOON_S = 0.001
LONG_S = 30.0
SOON = Duration(seconds=SOON_S)
EXECUTORS = (SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor)


class World:
    """A node that a program uses, and a peer that threads spin: with a server of each kind, messages, transforms."""

    def __init__(self, context: Context, folder: Path) -> None:
        self.context = context
        self.node = Node("user", context=context)
        self.peer = Node("peer", context=context, allow_undeclared_parameters=True)
        self.peer.declare_parameter("speed", 1.0)
        self.peer.create_service(SetBool, "serves", lambda _, response: response)
        self.peer.create_service(
            SetBool, "is_silent", lambda *_: self.release.wait(LONG_S) or SetBool.Response()
        )
        self.release = threading.Event()
        self.release.set()
        self._publisher = self.peer.create_publisher(String, "text", 1)
        self.peer.create_timer(0.002, lambda: self._publisher.publish(String(data="text")))
        self._actions = ActionServer(
            self.peer,
            RotateAbsolute,
            "turn",
            self._turn,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            result_timeout=0,
        )
        self.peer_buffer = Buffer()
        self._server = BufferServer(self.peer_buffer, self.peer)
        self.transform = TransformStamped(header=Header(frame_id="map"), child_frame_id="base")
        self.transform.transform.rotation.w = 1.0
        self.peer_buffer.set_transform_static(self.transform, "peer")
        self.client = self.node.create_client(SetBool, "serves")
        self.action_client = ActionClient(self.node, RotateAbsolute, "turn")
        self.parameters = AsyncParameterClient(self.node, "peer")
        self.buffer_client = BufferClient(self.node, "tf2_buffer_server")
        self.parameter_file = folder / "parameters.yaml"
        self.parameter_file.write_text("/peer:\n  ros__parameters:\n    speed: 2.0\n", "utf-8")
        self._executor = MultiThreadedExecutor(4, context=context)
        self._executor.add_node(self.peer)
        self._thread = threading.Thread(target=self._spin, daemon=True)
        self._thread.start()
        self.executor = SingleThreadedExecutor(context=context)
        assert self.client.wait_for_service(LONG_S)
        assert self.action_client.wait_for_server(LONG_S)
        assert self.parameters.wait_for_services(LONG_S)

    def _spin(self) -> None:
        with suppress(ExternalShutdownException):
            self._executor.spin()

    def _turn(self, goal: Any) -> RotateAbsolute.Result:
        while goal.request.theta > 0.5 and not goal.is_cancel_requested:
            threading.Event().wait(SOON_S)
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        return RotateAbsolute.Result()

    def finish(self, future: Future[Any]) -> Any:
        """Spin the node until a future is done."""
        rclpy.spin_until_future_complete(self.node, future, executor=self.executor, timeout_sec=LONG_S)
        assert future.done()
        return future.result()

    def goal(self, theta: float = 0.0) -> Any:
        """Send a goal, and return its handle."""
        return self.finish(self.action_client.send_goal_async(RotateAbsolute.Goal(theta=theta)))

    def close(self) -> None:
        self.context.try_shutdown()
        self._thread.join(LONG_S)
        self._executor.shutdown()
        for node in (self.node, self.peer):
            node.destroy_node()
        self.context.destroy()


Row = Callable[[World], object]
ROWS: dict[str, Row] = {}
COVERED: dict[str, str] = {}
"""By public call: the row that makes it."""


def covers(*calls: str) -> Callable[[Row], Row]:
    """Register a row, and the public calls that it makes."""

    def register(row: Row) -> Row:
        name = row.__name__.strip("_")
        ROWS[name] = row
        COVERED.update(dict.fromkeys(calls, name))
        return row

    return register


# Contexts and nodes


@covers(
    *("Context.init", "Context.shutdown", "Context.destroy", "Context.__init__"),
    *("client_library.init", "client_library.shutdown", "utilities.shutdown", "InitContextManager.__init__"),
)
def context(world: World) -> None:
    context = Context()
    with rclpy.init(args=[], context=context, domain_id=world.context.get_domain_id()):
        Node("brief", context=context).destroy_node()
    other = Context()
    other.init([], domain_id=world.context.get_domain_id())
    utilities.shutdown(context=other)


@covers("client_library.create_node", "Node.destroy_node", "Node.__init__", "TypeDescriptionService.__init__")
def node(world: World) -> None:
    rclpy.create_node("brief", context=world.context).destroy_node()


@covers(
    *("LifecycleNodeMixin.create_lifecycle_publisher", "LifecycleNodeMixin.destroy_lifecycle_publisher"),
    "LifecyclePublisher.__init__",
)
def lifecycle_node(world: World) -> None:
    node = LifecycleNode("managed", context=world.context)
    publisher = node.create_lifecycle_publisher(String, "managed_text", 1)
    node.trigger_configure()
    node.trigger_activate()
    publisher.publish(String())
    node.trigger_deactivate()
    node.destroy_lifecycle_publisher(publisher)
    node.destroy_node()


@covers("Node.wait_for_node")
def wait_for_node(world: World) -> None:
    assert not world.node.wait_for_node("nobody", SOON_S)
    assert world.node.wait_for_node("/peer", LONG_S)


# Topics


@covers(
    "Node.create_publisher", "Node.destroy_publisher", "Publisher.wait_for_all_acked", "Publisher.__init__"
)
def publisher(world: World) -> None:
    publisher = world.node.create_publisher(
        String, "heard", 1, event_callbacks=PublisherEventCallbacks(matched=print)
    )
    publisher.publish(String())
    assert publisher.wait_for_all_acked(SOON)
    world.node.destroy_publisher(publisher)


@covers(
    *("Node.create_subscription", "Node.destroy_subscription", "_EventCallbacks.create_event_handlers"),
    *("Subscription.__init__", "EventHandler.__init__"),
)
def subscription(world: World) -> None:
    subscription = world.node.create_subscription(
        String, "unheard", print, 1, event_callbacks=SubscriptionEventCallbacks(matched=print)
    )
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=0)
    world.node.destroy_subscription(subscription)


@covers("wait_for_message.wait_for_message")
def wait_for_a_message(world: World) -> None:
    received, _ = wait_for_message(String, world.node, "text", time_to_wait=LONG_S)
    assert received
    received, _ = wait_for_message(String, world.node, "no_text", time_to_wait=SOON_S)
    assert not received


# Services


@covers("Node.create_client", "Node.destroy_client", "Client.__init__", "Client.wait_for_service")
def client(world: World) -> None:
    client = world.node.create_client(SetBool, "nobody")
    assert not client.wait_for_service(SOON_S)
    world.node.destroy_client(client)
    assert world.client.wait_for_service(LONG_S)


@covers("Node.create_service", "Node.destroy_service", "Service.__init__", "ServiceEndpoint.__init__")
def service(world: World) -> None:
    service = world.node.create_service(SetBool, "brief", lambda _, response: response)
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=0)
    world.node.destroy_service(service)


@covers("Client.call")
def call(world: World) -> None:
    assert world.client.call(SetBool.Request(), timeout_sec=LONG_S) is not None


@covers("Client.call_async", "client_library.spin_until_future_complete")
def call_async(world: World) -> None:
    assert isinstance(world.finish(world.client.call_async(SetBool.Request())), SetBool.Response)


@covers("Client.get_pending_request")
def call_that_is_given_up(world: World) -> None:
    client = world.node.create_client(SetBool, "nobody")
    future = client.call_async(SetBool.Request())
    client.remove_pending_request(future)
    client.call_async(SetBool.Request())
    with suppress(NoResponseError):
        client.call(SetBool.Request(), timeout_sec=SOON_S)
    world.node.destroy_client(client)


# Actions


@covers("ActionClient.__init__", "ActionClient.destroy", "ActionClient.wait_for_server")
def action_client(world: World) -> None:
    client = ActionClient(world.node, RotateAbsolute, "nobody")
    assert not client.wait_for_server(SOON_S)
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=0)
    client.destroy()


@covers("ActionServer.__init__", "ActionServer.destroy")
def action_server(world: World) -> None:
    server = ActionServer(world.node, RotateAbsolute, "brief", print)
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=0)
    server.destroy()


@covers(
    *("ActionClient.send_goal_async", "ActionClient.get_result", "ClientGoalHandle.get_result_async"),
    "ServerGoalHandle.__init__",
)
def goal(world: World) -> None:
    handle = world.goal()
    world.finish(handle.get_result_async())


@covers(
    *("ActionClient.cancel", "ClientGoalHandle.cancel_goal_async", "ClientGoalHandle.get_result"),
    *("ClientGoalHandle.cancel_goal", "ActionClient.wait_for"),
)
def cancelled_goal(world: World) -> None:
    for cancel in (
        lambda handle: world.finish(handle.cancel_goal_async()),
        lambda handle: world.finish(world.action_client.cancel(handle.goal_id)),
    ):
        handle = world.goal(1.0)
        result = handle.get_result_async()
        cancel(handle)
        world.finish(result)


# Parameters


@covers(
    *("AsyncParameterClient.__init__", "AsyncParameterClient.wait_for_services"),
    *(
        "AsyncParameterClient.on_parameter_event",
        "ParameterEventHandler.__init__",
        "ParameterEventHandler.destroy",
    ),
)
def parameter_clients(world: World) -> None:
    node = Node("brief", context=world.context)
    client = AsyncParameterClient(node, "nobody")
    client.on_parameter_event(print)
    assert not client.wait_for_services(SOON_S)
    handler = ParameterEventHandler(node)
    handler.add_parameter_callback("speed", "peer", print)
    handler.destroy()
    node.destroy_node()


@covers(
    *("AsyncParameterClient.list_parameters", "AsyncParameterClient.get_parameters"),
    *("AsyncParameterClient.set_parameters", "AsyncParameterClient.set_parameters_atomically"),
    *("AsyncParameterClient.describe_parameters", "AsyncParameterClient.get_parameter_types"),
    *("AsyncParameterClient.delete_parameters", "AsyncParameterClient.load_parameter_file"),
    "AsyncParameterClient.load_parameter_file_atomically",
)
def parameters(world: World) -> None:
    client = world.parameters
    path = str(world.parameter_file)
    for future in (
        client.list_parameters(),
        client.get_parameters(["speed"]),
        client.set_parameters([Parameter("speed", value=3.0)]),
        client.set_parameters_atomically([Parameter("brief", value=3)]),
        client.describe_parameters(["speed"]),
        client.get_parameter_types(["speed"]),
        client.delete_parameters(["brief"]),
        client.load_parameter_file(path),
        client.load_parameter_file_atomically(path),
    ):
        world.finish(future)


# Time


@covers("Node.create_timer", "Node.destroy_timer", "Timer.__init__")
def timer(world: World) -> None:
    timer = world.node.create_timer(0.0, lambda: None)
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=LONG_S)
    timer.cancel()
    world.node.destroy_timer(timer)


@covers("Node.create_rate", "Node.destroy_rate", "Rate.__init__", "Rate.sleep")
def rate(world: World) -> None:
    rate = world.peer.create_rate(1000.0)
    rate.sleep()
    world.peer.destroy_rate(rate)


@covers("Clock.sleep_for", "Clock.sleep_until", "Clock.create_jump_callback", "JumpHandle.__init__")
def clock(world: World) -> None:
    clock = world.node.get_clock()
    clock.sleep_for(SOON, context=world.context)
    clock.sleep_until(clock.now() + SOON, context=world.context)
    from tfloom.node.clock.time_jump import JumpThreshold

    clock.create_jump_callback(
        JumpThreshold(min_forward=SOON, min_backward=None), post_callback=print
    ).unregister()


# Executors


@covers(
    *("Executor.__init__", "Executor.shutdown", "Executor.spin_once", "Executor.spin_until_future_complete"),
    *("Executor.spin_once_until_future_complete", "Executor.wait_for_ready_callbacks"),
    *("SingleThreadedExecutor.__init__", "MultiThreadedExecutor.__init__", "MultiThreadedExecutor.shutdown"),
    *(
        "EventsExecutor.__init__",
        "TaskRunner.create_task",
        "WorkQueue.create_task",
        "WorkQueue.create_future",
    ),
)
def executors(world: World) -> None:
    for kind in EXECUTORS:
        executor: Executor = kind(context=world.context)
        executor.add_node(world.node)
        executor.spin_once(timeout_sec=0)
        executor.spin_once(timeout_sec=SOON_S)
        executor.spin_until_future_complete(executor.create_task(lambda: None), LONG_S)
        future = executor.create_future()
        executor.create_task(future.set_result, None)
        executor.spin_once_until_future_complete(future, LONG_S)
        if kind is not EventsExecutor:
            with suppress(TimeoutException):
                next(executor.wait_for_ready_callbacks(timeout_sec=0))
        executor.remove_node(world.node)
        assert executor.shutdown()


@covers("Executor.spin", "EventsExecutor.spin", "client_library.spin")
def spin(world: World) -> None:
    for kind in EXECUTORS:
        executor: Executor = kind(context=world.context)
        executor.add_node(world.node)
        executor.create_task(executor.shutdown, 0)
        with suppress(ExternalShutdownException):
            executor.spin()
        executor.remove_node(world.node)
        executor.shutdown()


@covers("client_library.spin_once")
def spin_once(world: World) -> None:
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=0)
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=SOON_S)


@covers(
    *("Node.create_guard_condition", "Node.destroy_guard_condition", "GuardCondition.__init__"),
    "SignalHandlerGuardCondition.__init__",
)
def guard_conditions(world: World) -> None:
    guard = world.node.create_guard_condition(lambda: None)
    guard.trigger()
    rclpy.spin_once(world.node, executor=world.executor, timeout_sec=LONG_S)
    world.node.destroy_guard_condition(guard)
    GuardCondition(None, None, context=world.context).destroy()
    SignalHandlerGuardCondition(context=world.context).destroy()


# Transforms


@covers(
    *("TransformListener.__init__", "StaticTransformListener.__init__", "Buffer.__init__"),
    *("StaticTransformBroadcaster.__init__", "TransformBroadcaster.__init__"),
)
def listeners(world: World) -> None:
    node = Node("brief", context=world.context)
    StaticTransformBroadcaster(node).sendTransform(world.transform)
    TransformBroadcaster(node).sendTransform(world.transform)
    buffer = Buffer(node=node)
    for listener in (
        TransformListener(buffer, node),
        StaticTransformListener(buffer, node),
        TransformListener(buffer, node, spin_thread=True),
    ):
        listener.buffer = Buffer()
        listener.unregister()
    node.destroy_node()


@covers(
    *("Buffer.can_transform", "Buffer.can_transform_full", "Buffer.lookup_transform"),
    *("Buffer.lookup_transform_full", "BufferInterface.transform", "BufferInterface.transform_full"),
)
def lookups(world: World) -> None:
    buffer, now = world.peer_buffer, Time()
    assert buffer.can_transform("map", "base", now, SOON)
    assert not buffer.can_transform("map", "nobody", now, SOON)
    assert buffer.can_transform_full("map", now, "base", now, "map", SOON)
    buffer.lookup_transform("map", "base", now, SOON)
    buffer.lookup_transform_full("map", now, "base", now, "map", SOON)
    with suppress(TransformException):
        buffer.lookup_transform("map", "nobody", now, SOON)
    import tfloom.tf2_ros.geometry  # noqa: F401  # registers the type

    point = PointStamped(header=Header(frame_id="base"))
    buffer.transform(point, "map", SOON)
    buffer.transform_full(point, "map", now, "map", SOON)


@covers(
    *("Buffer.wait_for_transform_async", "Buffer.wait_for_transform_full_async"),
    *("Buffer.lookup_transform_async", "Buffer.lookup_transform_full_async"),
)
def waits_for_transforms(world: World) -> None:
    buffer, now = Buffer(), Time()
    futures = [
        buffer.wait_for_transform_async("map", "base", now),
        buffer.wait_for_transform_full_async("map", now, "base", now, "map"),
    ]
    given_up = buffer.wait_for_transform_async("map", "nobody", now)
    buffer.set_transform_static(world.transform, "peer")
    assert all(future.done() for future in futures)
    given_up.cancel()
    world.finish(world.executor.create_task(buffer.lookup_transform_async("map", "base", now)))
    world.finish(
        world.executor.create_task(buffer.lookup_transform_full_async("map", now, "base", now, "map"))
    )


@covers("BufferClient.__init__", "BufferClient.destroy", "BufferServer.__init__", "BufferServer.destroy")
def buffer_servers(world: World) -> None:
    server = BufferServer(world.peer_buffer, world.node, "brief")
    client = BufferClient(world.node, "brief")
    client.destroy()
    server.destroy()


@covers(
    *("BufferClient.lookup_transform", "BufferClient.lookup_transform_full", "BufferClient.wait_for_server"),
    *("BufferInterface.can_transform", "BufferInterface.lookup_transform"),
)
def buffer_client(world: World) -> None:
    assert world.buffer_client.wait_for_server(LONG_S)
    world.buffer_client.lookup_transform("map", "base", Time(), Duration(seconds=LONG_S))
    world.buffer_client.lookup_transform_full("map", Time(), "base", Time(), "map", Duration(seconds=LONG_S))


@covers(
    *("MessageFilter.__init__", "Subscriber.__init__", "Cache.__init__", "Chain.__init__"),
    *("TimeSynchronizer.__init__", "ApproximateTimeSynchronizer.__init__"),
)
def filters(world: World) -> None:
    node = Node("brief", context=world.context)
    subscribers = [Subscriber(node, PointStamped, topic) for topic in ("one", "two")]
    Cache(subscribers[0], 10)
    Chain(subscribers[0])
    TimeSynchronizer(subscribers, 10)
    ApproximateTimeSynchronizer(subscribers, 10, 0.1)
    waiting = MessageFilter(subscribers[0], Buffer(), "map", 1, node, SOON)
    waiting.add(PointStamped(header=Header(frame_id="nobody")))
    node.destroy_node()


@covers(
    *("AsyncNode.create_client", "AsyncNode.create_publisher", "AsyncNode.create_service"),
    *(
        "AsyncNode.create_subscription",
        "AsyncNode.create_timer",
        "AsyncNode.wait_for_node",
        "AsyncClock.sleep",
    ),
    *("AsyncClient.__init__", "AsyncClient.call", "AsyncClient.wait_for_service", "AsyncClock.__init__"),
    *(
        "AsyncPublisher.__init__",
        "AsyncService.__init__",
        "AsyncSubscription.__init__",
        "AsyncTimer.__init__",
    ),
)
def async_node(world: World) -> None:
    if sys.version_info < (3, 11):
        return
    from tfloom.node.async_node import AsyncNode

    async def use_all() -> None:
        node = AsyncNode("brief", context=world.context)
        received = asyncio.Event()
        node.create_subscription(String, "~/text", lambda _: received.set(), 10)
        publisher = node.create_publisher(String, "~/text", 10)
        node.create_service(SetBool, "~/switch", lambda _, response: response)
        client = node.create_client(SetBool, "~/switch")
        ticked = asyncio.Event()
        node.create_timer(0.001, ticked.set)
        async with node:
            await node.wait_for_node("/brief", 0.01)
            await client.wait_for_service(0.01)
            await client.call(SetBool.Request())
            while not received.is_set():
                publisher.publish(String())
                await node.get_clock().sleep(0.001)
            await ticked.wait()

    asyncio.run(use_all())


LOCAL = "- asks what is there: it neither waits nor creates"
ABSTRACT = "- raises: derived classes have it"
INTERNAL = "- tfloom's own: called by the rows"
OFF = {
    "BaseClient.__init__": ABSTRACT,
    "BasePublisher.__init__": ABSTRACT,
    "BaseService.__init__": ABSTRACT,
    "BaseSubscription.__init__": ABSTRACT,
    "BaseTimer.__init__": ABSTRACT,
    "Executor.spin_on_own_thread": INTERNAL,
    "ActionClient.send_goal": "- waits as `Client.call` does, of which `tests/node/test_action.py` has a test",
    "QoSEventHandler.__init__": "- the deprecated name of `EventHandler`",
    "BufferCore.can_transform_core": LOCAL,
    "BufferCore.can_transform_full_core": LOCAL,
    "BufferCore.lookup_transform_core": LOCAL,
    "BufferCore.lookup_transform_full_core": LOCAL,
    "BufferInterface.can_transform_full": ABSTRACT,
    "BufferInterface.lookup_transform_full": ABSTRACT,
}
