"""What programs and their tests use of rclpy beyond its documented names: answers recorded from a real one."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.std_srvs.srv import Empty
from tfloom.node import client_library as rclpy
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.builtin.time_source import TimeSource
from tfloom.node.clock.clock import ROSClock
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import get_available_rmw_implementations
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum, TypeHash
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions, _declare_qos_parameters
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.names import expand_topic_name
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSPolicyEnum
from tfloom.rosidl.message import EncodeError

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
    timer = node.create_timer(1.0, print)
    guard = node.create_guard_condition(print)
    handles = [publisher.handle, timer.handle, guard.handle, node.handle]
    for handle in handles:
        with handle as entered:
            assert entered is handle
    node.destroy_node()
    for handle in handles:
        with pytest.raises(InvalidHandle, match="was destroyed"), handle:
            pass
    for destroyed in (publisher, timer, guard, node):
        with pytest.raises(InvalidHandle, match="was destroyed"), destroyed.handle:
            pass
    with pytest.raises(InvalidHandle, match="was destroyed"):
        guard.trigger()


def test_a_subscriptions_handle_takes_messages(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    handle = node.create_subscription(String, "chatter", print, 10).handle
    assert handle.take_message(String, False) is None
    publisher.publish(String(data="one"))
    publisher.publish(String(data="two"))
    message, info = handle.take_message(String, False)
    assert message == String(data="one")
    assert info["publisher_gid"]["data"] == publisher.gid
    assert sorted(info) == [
        "publication_sequence_number",
        "publisher_gid",
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


def test_a_text_that_is_not_utf_8_raises_where_it_is_published(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 1)
    with pytest.raises(UnicodeEncodeError) as caught:
        publisher.publish(String(data="Ragnar\udce9k"))
    assert isinstance(caught.value, EncodeError)
    assert str(caught.value).startswith("String.data must be text without lone surrogates, got ")


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


# names of endpoints


def test_endpoints_keep_the_name_that_they_were_given(make_node: Callable[..., Node]) -> None:
    node = make_node("names", namespace="/ns")
    publisher = node.create_publisher(String, "~/a", 1)
    subscription = node.create_subscription(String, "a", print, 1)
    client = node.create_client(Empty, "{node}")
    server = node.create_service(Empty, "b", lambda _, response: response)
    assert (publisher.topic, publisher.topic_name) == ("~/a", "/ns/names/a")
    assert (subscription.topic, subscription.topic_name) == ("a", "/ns/a")
    assert (client.srv_name, client.service_name) == ("{node}", "/ns/names")
    assert (server.srv_name, server.service_name) == ("b", "/ns/b")


def test_endpoints_name_their_nodes_logger(make_node: Callable[..., Node]) -> None:
    node = make_node("names", namespace="/ns")
    endpoints = (
        node.create_publisher(String, "a", 1),
        node.create_subscription(String, "a", print, 1),
        node.create_client(Empty, "b"),
        node.create_service(Empty, "b", lambda _, response: response),
    )
    for endpoint in endpoints:
        assert endpoint.logger_name == "ns.names"
        assert endpoint.handle.get_logger_name() == "ns.names"


@pytest.mark.parametrize("name", ["42", "a?", "{unknown}", ""])
def test_names_that_can_not_be_expanded_have_rclpys_text(node: Node, name: str) -> None:
    queries = (
        node.count_publishers,
        node.count_subscribers,
        node.count_clients,
        node.get_publishers_info_by_topic,
        lambda name: expand_topic_name(name, "n", "/"),
    )
    for query in queries:
        with pytest.raises(ValueError, match=re.escape(f"topic name '{name}' is invalid: ")):
            query(name)
    with pytest.raises(ValueError, match=r"^node name 'n\?' is invalid: "):
        expand_topic_name("a", "n?", "/")
    with pytest.raises(ValueError, match=r"^node namespace 'ns' is invalid: "):
        expand_topic_name("a", "n", "ns")


def test_names_of_nodes_in_queries_must_be_texts(node: Node) -> None:
    with pytest.raises(TypeError, match="must be str, not 1 and '/'"):
        node.get_publisher_names_and_types_by_node(1, "/")  # type: ignore[arg-type]


# deprecated names


@pytest.mark.parametrize(
    ("name", "policy"),
    [
        ("RMW_QOS_POLICY_HISTORY_KEEP_ALL", HistoryPolicy.KEEP_ALL),
        ("RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT", ReliabilityPolicy.BEST_EFFORT),
        ("RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL", DurabilityPolicy.TRANSIENT_LOCAL),
        ("RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC", LivelinessPolicy.MANUAL_BY_TOPIC),
    ],
)
def test_policies_have_their_names_of_c_with_a_warning(name: str, policy: QoSPolicyEnum) -> None:
    kind = type(policy).__name__
    with pytest.warns(UserWarning, match=f"^{kind}.{name} is deprecated. Use {kind}.{policy.name} instead.$"):
        assert getattr(type(policy), name) is policy


def test_policies_have_no_other_names() -> None:
    for name in ("RMW_QOS_POLICY_HISTORY_NEVER", "RMW_QOS_POLICY_DURABILITY_VOLATILE", "keep_all"):
        with pytest.raises(AttributeError, match=name):
            getattr(HistoryPolicy, name)


# arguments


def test_arguments_must_be_a_list_of_texts() -> None:
    with pytest.raises(TypeError, match="must be a list of arguments, not the text '--ros-args'"):
        Context().init("--ros-args")
    with pytest.raises(TypeError, match="must be a str, not 1 of class int"):
        Context().init([1])  # type: ignore[list-item]


def test_an_executor_needs_a_thread(context: Context) -> None:
    with pytest.raises(ValueError, match="at least one thread, not 0"):
        MultiThreadedExecutor(num_threads=0, context=context)


def test_the_end_that_a_number_names_is_known() -> None:
    info = TopicEndpointInfo(endpoint_type=2)
    assert info.endpoint_type is TopicEndpointTypeEnum.SUBSCRIPTION
    assert "Endpoint type: SUBSCRIPTION" in str(info)


def test_a_hash_of_the_wrong_length_is_invalid() -> None:
    assert str(TypeHash(version=1, value=b"a")) == "INVALID"
    assert str(TypeHash(version=1, value=bytes(32))) == f"RIHS01_{'0' * 64}"


# simulated time


def test_a_time_source_shows_what_it_follows(node: Node) -> None:
    source = TimeSource()
    assert source._node_weak_ref is None
    with pytest.raises(TypeError, match="Node must be of type Node, not int"):
        source.attach_node(5)  # type: ignore[arg-type]
    source.attach_node(node)
    clock = ROSClock()
    source.attach_clock(clock)
    assert source._node_weak_ref is not None
    assert source._node_weak_ref() is node
    assert source._associated_clocks == {clock}
    assert source._clock_sub is None
    source.ros_time_is_active = True
    assert source._clock_sub in node.subscriptions
    source.clock_callback(Clock(clock=Time(sec=5)))
    assert source._last_time_set.nanoseconds == clock.now().nanoseconds == 5_000_000_000
    source.detach_node()
    assert source._clock_sub is None
    assert source._node_weak_ref is None


# lifecycle


def test_a_lifecycle_node_has_rclpys_state_machine(context: Context) -> None:
    node = LifecycleNode("lifecycle", context=context)
    machine = node._state_machine
    assert machine.initialized
    assert machine.current_state == (1, "unconfigured")
    assert machine.available_states[-1] == (15, "errorprocessing")
    assert machine.available_transitions == [
        (1, "configure", 1, "unconfigured", 10, "configuring"),
        (5, "shutdown", 1, "unconfigured", 12, "shuttingdown"),
    ]
    assert len(machine.transition_graph) == 25
    assert machine.get_transition_by_label("configure") == 1
    node.trigger_configure()
    assert machine.current_state == (2, "inactive")
    with pytest.raises(RCLError, match="no transition configure from state inactive"):
        machine.get_transition_by_label("configure")
    services = (
        *("change_state", "get_state", "get_available_states"),
        *("get_available_transitions", "get_transition_graph"),
    )
    for name in services:
        assert getattr(node, f"_service_{name}").service_name == f"/lifecycle/{name}"
    node.destroy_node()


def test_results_of_transitions_have_labels() -> None:
    labels = [result.to_label() for result in TransitionCallbackReturn]
    assert labels == ["transition_success", "transition_failure", "transition_error"]
