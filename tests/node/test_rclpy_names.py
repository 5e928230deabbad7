"""What programs and their tests use of rclpy beyond its documented names: answers recorded from a real one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.std_srvs.srv import Empty
from tfloom.node import client_library as rclpy
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.clock.clock import ROSClock
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import get_available_rmw_implementations
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions, _declare_qos_parameters
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import InvalidHandle

KINDS = (
    *("num_subscriptions", "num_guard_conditions", "num_timers"),
    *("num_clients", "num_services", "num_events"),
)


# node.executor


def test_a_node_names_its_last_executor(node: Node, executor: SingleThreadedExecutor) -> None:
    assert node.executor is None
    executor.add_node(node)
    assert node.executor is executor
    executor.remove_node(node)
    assert node.executor is executor
    node.executor = None
    assert node.executor is None


def test_a_node_names_the_executor_of_spin_once(node: Node, executor: SingleThreadedExecutor) -> None:
    rclpy.spin_once(node, executor=executor, timeout_sec=0)
    assert node.executor is executor
    assert node not in executor.get_nodes()


def test_spin_once_returns_a_node_to_no_executor_that_it_has_left(
    node: Node, context: Context, executor: SingleThreadedExecutor
) -> None:
    with SingleThreadedExecutor(context=context) as former:
        former.add_node(node)
        former.remove_node(node)
        rclpy.spin_once(node, executor=executor, timeout_sec=0)
        assert node not in former.get_nodes()


class ForeignExecutor:
    """An executor that derives from none of rclpy's, as tests of a program have."""

    def __init__(self) -> None:
        self.calls: list[str] = []

    def add_node(self, node: Node) -> bool:
        self.calls.append(f"add {node.get_name()}")
        return True

    def remove_node(self, node: Node) -> None:
        self.calls.append(f"remove {node.get_name()}")


def test_an_executor_of_the_programs_own_may_be_set(node: Node, executor: SingleThreadedExecutor) -> None:
    foreign: Any = ForeignExecutor()
    executor.add_node(node)
    node.executor = foreign
    assert node.executor is foreign
    assert node not in executor.get_nodes()
    node.create_timer(1.0, print)
    node.executor = None
    assert foreign.calls == ["add tester", "remove tester"]
    assert node.executor is None


def test_a_goal_that_is_executed_between_spins_runs_in_the_next(
    node: Node, executor: SingleThreadedExecutor
) -> None:
    accepted: list[Any] = []
    executed: list[str] = []

    def execute(goal_handle: Any) -> Any:
        executed.append("executed")
        goal_handle.succeed()
        return Fibonacci.Result()

    ActionServer(node, Fibonacci, "deferred", execute, handle_accepted_callback=accepted.append)
    client = ActionClient(node, Fibonacci, "deferred")
    sent = client.send_goal_async(Fibonacci.Goal())
    rclpy.spin_until_future_complete(node, sent, executor, timeout_sec=10)
    accepted[0].execute()
    assert executed == []
    result = sent.result().get_result_async()
    rclpy.spin_until_future_complete(node, result, executor, timeout_sec=10)
    assert (executed, result.done()) == (["executed"], True)


# Handles


def test_handles_of_what_was_destroyed_raise(make_node: Callable[..., Node]) -> None:
    node = make_node("handled")
    publisher = node.create_publisher(String, "chatter", 1)
    handles = [publisher.handle, node.handle]
    for handle in handles:
        with handle as entered:
            assert entered is handle
    node.destroy_node()
    for handle in handles:
        with pytest.raises(InvalidHandle, match="it was destroyed"), handle:
            pass
    for destroyed in (publisher, node):
        with pytest.raises(InvalidHandle, match="it was destroyed"):
            destroyed.handle  # noqa: B018


def test_a_subscriptions_handle_takes_messages(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    handle = node.create_subscription(String, "chatter", print, 10).handle
    assert handle.take_message(String, False) is None
    publisher.publish(String(data="one"))
    publisher.publish(String(data="two"))
    message, info = handle.take_message(String, False)
    assert message == String(data="one")
    assert sorted(info) == [
        "publication_sequence_number",
        "received_timestamp",
        "reception_sequence_number",
        "source_timestamp",
    ]
    raw, _ = handle.take_message(String, True)
    assert raw[:8] == b"\x00\x01\x00\x00\x04\x00\x00\x00"


def test_actions_count_their_entities(node: Node) -> None:
    ends = (
        ActionClient(node, Fibonacci, "x"),
        ActionServer(node, Fibonacci, "x", lambda _: Fibonacci.Result()),
    )
    assert [[getattr(end.get_num_entities(), kind) for kind in KINDS] for end in ends] == [
        [2, 0, 0, 3, 0, 0],
        [0, 0, 1, 0, 3, 0],
    ]


def test_a_c_profile_has_its_settings_as_a_dict() -> None:
    profile = qos_profile_sensor_data.get_c_qos_profile()
    assert profile.to_dict() == {
        "depth": 5,
        "history": 1,
        "reliability": 2,
        "durability": 2,
        "lifespan": Duration(),
        "deadline": Duration(),
        "liveliness": 0,
        "liveliness_lease_duration": Duration(),
        "avoid_ros_namespace_conventions": False,
    }
    assert {type(value) for value in profile.to_dict().values()} == {int, bool, Duration}
    assert QoSProfile(**profile.to_dict()) == qos_profile_sensor_data


def test_an_argument_that_is_not_utf_8_raises() -> None:
    context = Context()
    with pytest.raises(UnicodeEncodeError, match="character '\\\\udce9' in position 6"):
        rclpy.init(args=["my-node.py", "Ragnar\udce9k"], context=context)
    assert not context.ok()


def test_the_wire_inside_a_process_is_none_that_processes_can_meet_on() -> None:
    assert "rmw_cyclonedds_cpp" in get_available_rmw_implementations()
    assert "tfloom_local" not in get_available_rmw_implementations()


# Private names


def test_a_node_has_rclpys_private_names(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 1)
    subscription = node.create_subscription(String, "chatter", print, 1)
    client = node.create_client(Empty, "empty")
    service = node.create_service(Empty, "empty", lambda _, response: response)
    timer = node.create_timer(1.0, print)
    guard = node.create_guard_condition(print)
    node.declare_parameter("x", 5)
    node.add_on_set_parameters_callback(print)
    private: Any = node
    assert publisher in private._publishers
    assert private._subscriptions == [subscription]
    assert private._clients == [client]
    assert service in private._services
    assert private._timers == [timer]
    assert private._guards == [guard]
    assert private._parameters["x"].value == 5
    assert private._descriptors["x"].name == "x"
    assert private._parameter_overrides == {}
    assert private._allow_undeclared_parameters is False
    assert print in private._on_set_parameters_callbacks
    assert private._pre_set_parameters_callbacks == private._post_set_parameters_callbacks == []
    assert private._context is node.context
    assert private._logger is node.get_logger()
    assert private._clock is node.get_clock()
    assert private._default_callback_group is node.default_callback_group


def test_a_program_may_use_these_names_itself(context: Context) -> None:
    class Own(Node):
        def __init__(self) -> None:
            super().__init__("own", context=context)
            self._timers = {"tick": self.create_timer(1.0, print)}
            self._parameters = None

    node = Own()
    assert node._timers == {"tick": next(node.timers)}
    assert node.declare_parameter("x", 5).value == 5
    node.destroy_node()


def test_a_clock_has_rclpys_setter_of_simulated_time() -> None:
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    clock._set_ros_time_is_active(False)
    assert not clock.ros_time_is_active


def test_a_parameter_event_handler_has_its_callbacks(
    node: Node, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    executor.add_node(node)
    node.declare_parameter("a", 1)
    handler = ParameterEventHandler(node)
    called: list[str] = []
    first = handler.add_parameter_callback("a", "tester", lambda _: called.append("1"))
    second = handler.add_parameter_callback("a", "tester", lambda _: called.append("2"))
    events = [handler.add_parameter_event_callback(lambda _, i=i: called.append(f"e{i}")) for i in (1, 2)]
    assert handler._callbacks.parameter_callbacks == {("a", "/tester"): [second, first]}
    assert handler._callbacks.event_callbacks == events[::-1]
    node.set_parameters([Parameter("a", value=2)])
    spin_until(lambda: len(called) == 4)
    assert called == ["2", "1", "e2", "e1"]
    handler.remove_parameter_callback(first)
    assert handler._callbacks.parameter_callbacks == {("a", "/tester"): [second]}
    with pytest.raises(RuntimeError, match="Callback doesn't exist"):
        handler.remove_parameter_callback(first)


def test_qos_parameters_can_be_declared_without_an_endpoint(make_node: Callable[..., Node]) -> None:
    name = "qos_overrides./chatter.publisher.reliability"
    node = make_node("overridden", parameter_overrides=[Parameter(name, value="best_effort")])
    profile = QoSProfile(depth=10)
    _declare_qos_parameters(
        Publisher, node, "/chatter", profile, QoSOverridingOptions.with_default_policies()
    )
    assert profile.reliability == ReliabilityPolicy.BEST_EFFORT
    assert node.get_parameter(name).value == "best_effort"


def test_a_multi_threaded_executor_has_its_pool(context: Context) -> None:
    with MultiThreadedExecutor(num_threads=3, context=context) as executor:
        assert executor._executor._max_workers == 3
