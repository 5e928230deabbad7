"""What nodes, endpoints, timers and others answer after they were destroyed: as those of the real rclpy."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.clock.clock import Clock
from tfloom.node.context.context import Context
from tfloom.node.endpoints.client import Client
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.service import Service
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.timer import Rate, Timer
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import qos_profile_system_default
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import InvalidHandle

Make = Callable[..., Node]


class Handles(NamedTuple):
    """What a node has created."""

    node: Node
    publisher: Publisher
    subscription: Subscription
    client: Client
    service: Service
    timer: Timer
    guard: GuardCondition
    action: ActionClient
    server: ActionServer
    clock: Clock
    rate: Rate

    @classmethod
    def of(cls, node: Node) -> Handles:
        node.declare_parameter("speed", 1)
        return cls(
            node,
            node.create_publisher(String, "chatter", 1),
            node.create_subscription(String, "chatter", print, 1),
            node.create_client(Trigger, "serve"),
            node.create_service(Trigger, "serve", lambda _, response: response),
            node.create_timer(1.0, print),
            node.create_guard_condition(print),
            ActionClient(node, Fibonacci, "count"),
            ActionServer(node, Fibonacci, "count", print),
            node.get_clock(),
            node.create_rate(1.0),
        )


def entered(handle: Any) -> Any:
    with handle:
        return handle


OF_ENTITIES: list[Callable[[Handles], Any]] = [
    lambda of: of.publisher.publish(String()),
    lambda of: of.publisher.topic_name,
    lambda of: of.publisher.logger_name,
    lambda of: of.publisher.get_subscription_count(),
    lambda of: of.publisher.assert_liveliness(),
    lambda of: of.publisher.wait_for_all_acked(Duration(seconds=0)),
    lambda of: entered(of.publisher.handle),
    lambda of: entered(of.publisher.event_handlers[0]),
    lambda of: of.subscription.topic_name,
    lambda of: of.subscription.logger_name,
    lambda of: of.subscription.get_publisher_count(),
    lambda of: of.subscription.handle.take_message(String, raw=False),
    lambda of: entered(of.subscription.handle),
    lambda of: of.client.service_name,
    lambda of: of.client.logger_name,
    lambda of: of.client.service_is_ready(),
    lambda of: of.client.wait_for_service(0.0),
    lambda of: of.client.call_async(Trigger.Request()),
    lambda of: of.client.call(Trigger.Request(), 0.01),
    lambda of: of.client.configure_introspection(
        of.clock, qos_profile_system_default, ServiceIntrospectionState.OFF
    ),
    lambda of: entered(of.client.handle),
    lambda of: of.service.service_name,
    lambda of: of.service.logger_name,
    lambda of: of.service.configure_introspection(
        of.clock, qos_profile_system_default, ServiceIntrospectionState.OFF
    ),
    lambda of: entered(of.service.handle),
    lambda of: of.timer.cancel(),
    lambda of: of.timer.is_canceled(),
    lambda of: of.timer.is_ready(),
    lambda of: of.timer.reset(),
    lambda of: of.timer.time_since_last_call(),
    lambda of: of.timer.time_until_next_call(),
    lambda of: of.timer.timer_period_ns,
    lambda of: setattr(of.timer, "timer_period_ns", 5),
    lambda of: entered(of.timer.handle),
    lambda of: of.guard.trigger(),
    lambda of: entered(of.guard.handle),
    lambda of: of.action.server_is_ready(),
    lambda of: of.action.wait_for_server(0.0),
    lambda of: of.action.send_goal_async(Fibonacci.Goal()),
]
OF_NODES: list[Callable[[Handles], Any]] = [
    lambda of: of.node.get_name(),
    lambda of: of.node.get_namespace(),
    lambda of: of.node.get_fully_qualified_name(),
    lambda of: of.node.get_node_names(),
    lambda of: of.node.get_fully_qualified_node_names(),
    lambda of: of.node.get_node_names_and_namespaces(),
    lambda of: of.node.get_node_names_and_namespaces_with_enclaves(),
    lambda of: of.node.get_topic_names_and_types(),
    lambda of: of.node.get_service_names_and_types(),
    lambda of: of.node.get_publisher_names_and_types_by_node("handled", "/"),
    lambda of: of.node.get_subscriber_names_and_types_by_node("handled", "/"),
    lambda of: of.node.get_service_names_and_types_by_node("handled", "/"),
    lambda of: of.node.get_client_names_and_types_by_node("handled", "/"),
    lambda of: of.node.get_publishers_info_by_topic("chatter"),
    lambda of: of.node.get_subscriptions_info_by_topic("chatter"),
    lambda of: of.node.count_publishers("chatter"),
    lambda of: of.node.count_subscribers("chatter"),
    lambda of: of.node.count_clients("serve"),
    lambda of: of.node.count_services("serve"),
    lambda of: of.node.resolve_topic_name("chatter"),
    lambda of: of.node.resolve_service_name("serve"),
    lambda of: of.node.wait_for_node("handled", 1.0),
    lambda of: of.node.create_publisher(String, "other", 1),
    lambda of: of.node.create_subscription(String, "other", print, 1),
    lambda of: of.node.create_client(Trigger, "other"),
    lambda of: of.node.create_service(Trigger, "other", print),
    lambda of: of.node.declare_parameter("other", 1),
    lambda of: of.node.declare_parameters("", [("others", 1)]),
    lambda of: of.node.set_parameters([Parameter("speed", value=2)]),
    lambda of: of.node.set_parameters_atomically([Parameter("speed", value=2)]),
    lambda of: entered(of.node.handle),
]
ANSWERED: dict[str, Callable[[Handles], Any]] = {
    "get_logger": lambda of: of.node.get_logger().name == "handled",
    "log": lambda of: of.node.get_logger().info("after the end"),
    "clock": lambda of: of.clock.now().nanoseconds > 0,
    "get_clock": lambda of: of.node.get_clock() is of.clock,
    "executor": lambda of: of.node.executor is None,
    "context": lambda of: of.node.context.ok(),
    "group": lambda of: of.node.default_callback_group is not None,
    "get_parameter": lambda of: of.node.get_parameter("speed").value == 1,
    "has_parameter": lambda of: of.node.has_parameter("speed"),
    "list_parameters": lambda of: "speed" in of.node.list_parameters([], 0).names,
    "publishers": lambda of: list(of.node.publishers) == list(of.node.timers) == [],
    "destroy_publisher": lambda of: of.node.destroy_publisher(of.publisher) is False,
    "destroy_timer": lambda of: of.node.destroy_timer(of.timer) is False,
    "destroy_node": lambda of: of.node.destroy_node() is None,
    "timer's clock": lambda of: of.timer.clock is of.clock,
    "client's type": lambda of: of.client.srv_type is Trigger,
    "topic": lambda of: of.publisher.topic == "chatter",
    "add_node": lambda of: SingleThreadedExecutor(context=of.node.context).add_node(of.node),
    "handle": lambda of: of.node.handle is not None,
}


def _answers(of: Handles, access: Callable[[Handles], Any]) -> bool:
    with suppress(InvalidHandle):
        access(of)
        return True
    return False


def _answered(of: Handles, accesses: list[Callable[[Handles], Any]]) -> list[int]:
    """Return which of the accesses do not raise InvalidHandle."""
    return [index for index, access in enumerate(accesses) if _answers(of, access)]


def test_handles_of_a_destroyed_node_raise(make_node: Make) -> None:
    of = Handles.of(make_node("handled"))
    assert len(_answered(of, OF_NODES)) == len(OF_NODES), "they answer before"
    of = Handles.of(make_node("handled"))
    of.node.destroy_node()
    assert _answered(of, OF_ENTITIES) == []
    assert _answered(of, OF_NODES) == []


def test_destroyed_handles_of_a_node_raise(make_node: Make) -> None:
    of = Handles.of(make_node("handled"))
    assert len(_answered(of, OF_ENTITIES)) == len(OF_ENTITIES), "they answer before"
    node = of.node
    for destroy, entity in (
        (node.destroy_publisher, of.publisher),
        (node.destroy_subscription, of.subscription),
        (node.destroy_client, of.client),
        (node.destroy_service, of.service),
        (node.destroy_timer, of.timer),
        (node.destroy_guard_condition, of.guard),
    ):
        assert destroy(entity)
    of.action.destroy()
    of.server.destroy()
    assert _answered(of, OF_ENTITIES) == []
    for destroyed in (of.action, of.server):
        with pytest.raises(InvalidHandle):
            entered(destroyed)
    assert node.get_name() == "handled"
    assert node.create_publisher(String, "chatter", 1).topic_name == "/chatter"


@pytest.mark.parametrize("what", ANSWERED)
def test_a_destroyed_node_still_answers(make_node: Make, what: str) -> None:
    of = Handles.of(make_node("handled"))
    of.node.destroy_node()
    assert ANSWERED[what](of) in (True, None)


def test_a_destroyed_node_leaves_its_executor_and_still_names_it(make_node: Make) -> None:
    node = make_node("handled")
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        node.destroy_node()
        assert executor.get_nodes() == []
        assert node.executor is executor


def test_a_destroyed_node_creates_what_has_no_endpoint(make_node: Make) -> None:
    node = make_node("handled")
    node.destroy_node()
    ran: list[str] = []
    timer = node.create_timer(0.0, lambda: ran.append("timer"))
    guard = node.create_guard_condition(lambda: ran.append("guard"))
    node.create_rate(1.0)
    assert timer.is_ready()
    guard.trigger()
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        wait_until(lambda: executor.spin_once(timeout_sec=0.01) or set(ran) == {"timer", "guard"})


def test_a_destroyed_lifecycle_node_changes_its_state(make_node: Make) -> None:
    node = LifecycleNode("managed", context=make_node().context)
    node.destroy_node()
    assert node.trigger_configure().name == "SUCCESS"


@pytest.mark.parametrize("end", ["rate", "node"])
def test_every_sleep_returns_when_the_rate_is_destroyed(make_node: Make, end: str) -> None:
    node = make_node("handled")
    rate = node.create_rate(0.001)
    returned: list[None] = []
    threads = [threading.Thread(target=lambda: returned.append(rate.sleep())) for _ in range(3)]
    for thread in threads:
        thread.start()
    wait_until(lambda: len(rate._ticked._cond._waiters) == 3)
    if end == "rate":
        assert node.destroy_rate(rate)
        assert not node.destroy_rate(rate)
    else:
        node.destroy_node()
    for thread in threads:
        thread.join(20)
    assert returned == [None] * 3
    with pytest.raises(RuntimeError, match="destroyed"):
        rate.sleep()


def test_a_goal_that_ends_after_its_node_is_no_error(make_node: Make) -> None:
    servers, users = make_node("servers"), make_node("users")
    begun, gate, results = threading.Event(), threading.Event(), []

    def execute(goal_handle: Any) -> Fibonacci.Result:
        begun.set()
        assert gate.wait(20)
        servers.destroy_node()
        results.append("ended")
        return Fibonacci.Result()

    ActionServer(servers, Fibonacci, "count", execute)
    client = ActionClient(users, Fibonacci, "count")
    assert client.wait_for_server(20)
    with SingleThreadedExecutor(context=servers.context) as executor:
        executor.add_node(servers)
        client.send_goal_async(Fibonacci.Goal())
        gate.set()
        wait_until(lambda: executor.spin_once(timeout_sec=0.01) or results)


def test_what_is_created_after_the_end_is_destroyed_by_the_next_one(local_context: Context) -> None:
    node = Node("again", context=local_context)
    node.destroy_node()
    guard = node.create_guard_condition(lambda: None)
    guard.trigger()
    node.destroy_node()
    with pytest.raises(InvalidHandle):
        guard.trigger()
    node.destroy_node()
