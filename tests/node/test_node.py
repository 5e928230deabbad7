"""Nodes: their entities, their names on the graph, and their destruction."""

from __future__ import annotations

import re
import threading
from collections.abc import Callable
from functools import partial

import pytest
from tests.conftest import wait_until

from tfloom import _native
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.rcl_interfaces.msg import Log, SetParametersResult
from tfloom.interfaces.std_msgs.msg import Int32, String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node.context.context import Context
from tfloom.node.executing.executor import executor_of
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSPolicyKind, QoSProfile, qos_profile_rosout_default, qos_profile_sensor_data
from tfloom.node.qos.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions
from tfloom.node.values.exceptions import (
    InvalidHandle,
    NotInitializedException,
    RCLError,
)
from tfloom.node.values.serialization import deserialize_message
from tfloom.node.values.type_support import check_for_type_support
from tfloom.node.wait_for_message import wait_for_message
from tfloom.rosidl import cdr

MakeNode = Callable[..., Node]


def test_published_message_reaches_the_callback(
    node: Node, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    heard: list[str] = []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
    executor.add_node(node)
    for word in ("a", "b", "c"):
        publisher.publish(String(data=word))
    spin_until(lambda: len(heard) == 3)
    assert heard == ["a", "b", "c"]


def test_callback_with_two_arguments_receives_the_stamps(
    node: Node, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    infos: list[dict[str, int]] = []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda _, info: infos.append(info), 10)
    executor.add_node(node)
    before_ns = node.get_clock().now().nanoseconds
    publisher.publish(String())
    spin_until(lambda: infos)
    assert before_ns <= infos[0]["source_timestamp"] <= infos[0]["received_timestamp"]


def test_any_callable_with_a_fitting_signature_is_accepted(node: Node) -> None:
    class Callable2:
        def __call__(self, msg: String, info: dict[str, int]) -> None: ...

        def method(self, msg: String, more: int = 1) -> None: ...

    def three(a: int, b: int, c: int) -> None: ...

    for callback in (
        print,
        max,  # a built-in without a signature
        [].append,
        partial(three, 1, 2),
        partial(three, 1),
        Callable2(),
        Callable2().method,
    ):
        node.create_subscription(String, "chatter", callback, 10)
    with pytest.raises(RuntimeError, match="one argument"):
        node.create_subscription(String, "chatter", three, 10)
    assert node.count_subscribers("chatter") == 7


def test_raw_bytes_are_published_and_received(
    node: Node, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    heard: list[bytes] = []
    publisher = node.create_publisher(Int32, "number", 10)
    node.create_subscription(Int32, "number", heard.append, 10, raw=True)
    executor.add_node(node)
    publisher.publish(cdr.encode(Int32(data=7)))
    spin_until(lambda: heard)
    assert cdr.decode(Int32, heard[0]).data == 7


@pytest.mark.parametrize(
    "data", [b"", b"\x00\x01\x00\x00", b"\x00\x01\x00\x00\xff\xff\xff\xff", b"\x09" * 40]
)
def test_undecodable_message_is_dropped_with_one_warning(
    node: Node,
    executor: SingleThreadedExecutor,
    spin_until: Callable[..., None],
    capsys: pytest.CaptureFixture[str],
    data: bytes,
) -> None:
    heard: list[str] = []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
    executor.add_node(node)
    for _ in range(5):
        publisher.publish(data)
    publisher.publish(String(data="good"))
    spin_until(lambda: heard)
    warnings = [line for line in capsys.readouterr().err.splitlines() if "WARN" in line]
    assert len(warnings) == 1
    assert (
        f"Dropped a message of {len(data)} bytes on /chatter that is not a valid std_msgs/msg/String: "
        in warnings[0]
    )


def test_sink_receives_the_bytes_and_no_callback_runs(node: Node, executor: SingleThreadedExecutor) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    subscription = node.create_subscription(String, "chatter", lambda msg: pytest.fail("called"), 10)
    executor.add_node(node)
    sink = _native.SampleQueue(10)
    subscription.feed(sink)
    publisher.publish(String(data="x"))
    executor.spin_once(timeout_sec=0)
    ((data, *_),) = sink.take()
    assert cdr.decode(String, data).data == "x"


@pytest.mark.parametrize("bad", [SetBool, Fibonacci])
def test_types_of_another_kind_are_rejected(node: Node, bad: type) -> None:
    text = f"The message type provided is not valid ({bad}), this might be a service or action"
    with pytest.raises(RuntimeError, match=f"^{re.escape(text)}$"):
        node.create_publisher(bad, "chatter", 10)
    with pytest.raises(RuntimeError, match=f"^{re.escape(text)}$"):
        node.create_subscription(bad, "chatter", print, 10)
    with pytest.raises(RuntimeError, match=f"^{re.escape(text)}$"):
        deserialize_message(b"", bad)
    check_for_type_support(bad)
    with pytest.raises(AttributeError, match="expected a message or service class"):
        check_for_type_support(int)


def test_services_are_on_the_graph(make_node: MakeNode) -> None:
    arguments = ["--ros-args", "-p", "start_type_description_service:=false"]
    server = make_node("server", start_parameter_services=False, cli_args=arguments)
    caller = make_node("caller", start_parameter_services=False, cli_args=arguments)
    server.create_service(SetBool, "set", lambda request, response: response)
    caller.create_client(SetBool, "set")
    expected = [("/set", ["std_srvs/srv/SetBool"])]
    assert caller.get_service_names_and_types() == expected
    assert caller.get_service_names_and_types_by_node("server", "/") == expected
    assert caller.get_client_names_and_types_by_node("caller", "/") == expected
    assert caller.get_client_names_and_types_by_node("server", "/") == []
    assert (caller.count_services("set"), caller.count_clients("/set")) == (1, 1)
    with pytest.raises(RuntimeError, match="no node '/nobody'"):
        caller.get_service_names_and_types_by_node("nobody", "/")


def test_parameters_override_qos(make_node: MakeNode) -> None:
    given = ["--ros-args", "-p", "qos_overrides./chatter.publisher.reliability:=best_effort"]
    given += ["-p", "qos_overrides./chatter.publisher.depth:=3"]
    given += ["-p", "qos_overrides./bad.subscription.reliability:=nonsense"]
    node = make_node(cli_args=given)
    options = QoSOverridingOptions.with_default_policies()
    publisher = node.create_publisher(String, "chatter", 10, qos_overriding_options=options)
    assert (publisher.qos_profile.depth, publisher.qos_profile.reliability.name) == (3, "BEST_EFFORT")
    assert node.get_parameter("qos_overrides./chatter.publisher.history").value == "keep_last"
    with pytest.raises(
        InvalidQosOverridesError, match="'nonsense', which is none of: system_default, reliable"
    ):
        node.create_subscription(String, "bad", print, 10, qos_overriding_options=options)
    refusing = QoSOverridingOptions(
        [QoSPolicyKind.DEADLINE],
        callback=lambda profile: SetParametersResult(successful=False, reason="mine"),
        entity_id="two",
    )
    with pytest.raises(InvalidQosOverridesError, match="mine"):
        node.create_publisher(String, "chatter", 10, qos_overriding_options=refusing)
    assert node.has_parameter("qos_overrides./chatter.publisher_two.deadline")


def test_wait_for_message_returns_the_next_message(make_node: MakeNode) -> None:
    listener, talker = make_node("listener"), make_node("talker")
    publisher = talker.create_publisher(String, "chatter", qos_profile_rosout_default)
    publisher.publish(String(data="kept"))
    found, message = wait_for_message(
        String, listener, "chatter", qos_profile=qos_profile_rosout_default, time_to_wait=10
    )
    assert found
    assert message.data == "kept"
    assert wait_for_message(String, listener, "silence", time_to_wait=0.01) == (False, None)
    assert listener.count_subscribers("chatter") == 0


def test_threads_that_wait_for_messages_of_one_node_each_get_theirs(make_node: MakeNode) -> None:
    listener, talker = make_node("listener"), make_node("talker")
    got: list[str] = []

    def wait(topic: str) -> None:
        got.append(wait_for_message(String, listener, topic)[1].data)

    waits = []
    for topic in ("first", "second"):
        thread = threading.Thread(target=wait, args=(topic,), daemon=True)
        thread.start()
        wait_until(lambda topic=topic: listener.count_subscribers(topic) and executor_of(listener))
        waits.append((topic, thread))
    for topic, thread in waits:  # the first thread spins for both, and leaves
        talker.create_publisher(String, topic, 10).publish(String(data=topic))
        thread.join(30)
    assert got == ["first", "second"]


def test_node_arguments_remap_names(make_node: MakeNode) -> None:
    node = make_node("alice", namespace="a/b", cli_args=["--ros-args", "-r", "__node:=bob", "-r", "in:=out"])
    assert node.get_name() == "bob"
    assert node.get_namespace() == "/a/b"
    assert node.get_fully_qualified_name() == "/a/b/bob"
    assert node.get_logger().name == "a.b.bob"
    assert node.create_publisher(String, "in", 10).topic_name == "/a/b/out"
    assert node.resolve_topic_name("in", only_expand=True) == "/a/b/in"
    assert node.resolve_service_name("~/s") == "/a/b/bob/s"


def test_global_arguments_apply_unless_disabled(monkeypatch: pytest.MonkeyPatch) -> None:
    context = Context()
    context.init(["program", "--ros-args", "-r", "__ns:=/there"])
    with Node("one", context=context) as one, Node("two", context=context, use_global_arguments=False) as two:
        assert one.get_fully_qualified_name() == "/there/one"
        assert two.get_fully_qualified_name() == "/two"
    context.destroy()


def test_node_requires_an_initialised_context(context: Context) -> None:
    with pytest.raises(NotInitializedException):
        Node("early", context=Context())
    context.shutdown()
    with pytest.raises(NotInitializedException):
        Node("late", context=context)


def test_graph_has_the_built_in_endpoints_of_a_node(make_node: MakeNode) -> None:
    one = make_node("one")
    two = make_node("two", namespace="/ns", enable_rosout=False)
    two.create_subscription(String, "chatter", print, qos_profile_sensor_data)
    assert one.get_fully_qualified_node_names() == ["/ns/two", "/one"]
    assert one.get_topic_names_and_types() == [
        ("/ns/chatter", ["std_msgs/msg/String"]),
        ("/parameter_events", ["rcl_interfaces/msg/ParameterEvent"]),
        ("/rosout", ["rcl_interfaces/msg/Log"]),
    ]
    assert one.count_publishers("/parameter_events") == 2
    assert one.count_publishers("/rosout") == 1
    assert one.get_publisher_names_and_types_by_node("two", "/ns") == [
        ("/parameter_events", ["rcl_interfaces/msg/ParameterEvent"])
    ]
    assert one.get_subscriber_names_and_types_by_node("two", "/ns") == [
        ("/ns/chatter", ["std_msgs/msg/String"])
    ]
    (info,) = one.get_subscriptions_info_by_topic("/ns/chatter")
    assert (info.node_name, info.node_namespace) == ("two", "/ns")
    assert info.qos_profile.reliability == qos_profile_sensor_data.reliability
    assert str(info.topic_type_hash) == String._TYPE_HASH
    with pytest.raises(RuntimeError, match="/nobody"):
        one.get_publisher_names_and_types_by_node("nobody", "/")
    assert one.wait_for_node("/ns/two", timeout=1.0)
    assert not one.wait_for_node("three", timeout=0.0)


def test_log_records_are_published_on_rosout(
    make_node: MakeNode, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    node, other = make_node("talker", namespace="/ns"), make_node("other")
    heard: list[Log] = []
    other.create_subscription(Log, "/rosout", heard.append, qos_profile_rosout_default)
    executor.add_node(other)
    node.get_logger().warning("mind the gap")
    node.get_logger().get_child("sub").info("below")
    spin_until(lambda: len(heard) == 2)
    first = heard[0]
    assert (first.level, first.name, first.msg) == (30, "ns.talker", "mind the gap")
    assert first.function == "test_log_records_are_published_on_rosout"
    assert first.file == __file__
    assert first.line > 0
    assert first.stamp.sec > 1_600_000_000
    assert heard[1].name == "ns.talker.sub"


def test_destroying_leaves_the_graph(make_node: MakeNode) -> None:
    stays, goes = make_node("stays"), make_node("goes")
    publisher = goes.create_publisher(String, "chatter", 10)
    subscription = goes.create_subscription(String, "chatter", print, 10)
    assert goes.destroy_subscription(subscription)
    assert not goes.destroy_subscription(subscription)
    assert stays.count_subscribers("chatter") == 0
    goes.destroy_node()
    goes.destroy_node()
    assert stays.get_node_names() == ["stays"]
    assert stays.count_publishers("chatter") == 0
    creations: list[Callable[[], object]] = [
        lambda: goes.create_publisher(String, "chatter", 10),
        lambda: goes.create_subscription(String, "chatter", print, 10),
        lambda: goes.create_service(SetBool, "set", print),
        lambda: goes.create_client(SetBool, "set"),
    ]
    for create in creations:
        with pytest.raises(InvalidHandle, match="the node /goes: it was destroyed"):
            create()
    assert stays.count_publishers("chatter") == stays.count_services("set") == 0
    with pytest.raises(InvalidHandle):
        publisher.publish(String())
    with pytest.raises(InvalidHandle), subscription.handle:
        pass


def test_publishing_after_shutdown_raises(node: Node, context: Context) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    context.shutdown()
    with pytest.raises(RCLError, match="context is invalid"):
        publisher.publish(String())
    node.destroy_node()


def test_subclass_can_use_any_attribute_names(context: Context, executor: SingleThreadedExecutor) -> None:
    class Mine(Node):
        def __init__(self) -> None:
            super().__init__("mine", context=context)
            self._executor = self._context = self._publishers = self._timers = self._entities = "mine"
            self._clock = self._logger = self._node_name = self._participant = "mine"

        def _add(self) -> None:
            pytest.fail("the node called a method of its subclass")

        _remove = _resolve = _add

    with Mine() as node:
        executor.add_node(node)
        node.create_timer(1.0, print)
        node.create_publisher(String, "chatter", 10)
        assert node.get_name() == "mine"
        assert node.executor is executor


def test_integer_qos_is_a_history_depth(node: Node) -> None:
    assert node.create_publisher(String, "chatter", 7).qos_profile == QoSProfile(depth=7)


def test_destroyed_node_raises_on_create(node: Node) -> None:
    node.destroy_node()
    for create in (
        lambda: node.create_publisher(String, "x", 10),
        lambda: node.create_subscription(String, "x", print, 10),
    ):
        with pytest.raises(InvalidHandle, match="cannot use the node /tester: it was destroyed"):
            create()


class NamesOfItsOwn(Node):
    """A program's node whose attributes have names that a node's parts could have, too."""

    def __init__(self, context: Context) -> None:
        super().__init__("names_of_its_own", context=context)
        self.entities: list[str] = []
        self.graph = self.parameters = self.names = self.owner = None
        self._graph: dict[str, str] = {}
        self._entities = self._names = self._clock = self._logger = self._context = self._owned = None
        self.heard: list[str] = []
        self.create_subscription(String, "chatter", lambda message: self.heard.append(message.data), 10)
        self.publisher = self.create_publisher(String, "chatter", 10)


def test_a_program_chooses_names_of_its_own(
    context: Context, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    node = NamesOfItsOwn(context)
    executor.add_node(node)
    node.publisher.publish(String(data="hello"))
    spin_until(lambda: node.heard)
    assert node.heard == ["hello"]
    executor.remove_node(node)
    node.destroy_node()


def test_rules_of_ros_1_act_for_a_node_with_a_warning(
    local_context: Context, capfd: pytest.CaptureFixture[str]
) -> None:
    node = Node("nd", context=local_context, cli_args=["chat:=/x", "word"])
    assert node.resolve_topic_name("chat") == "/x"
    assert "[rcl]: Found remap rule 'chat:=/x'. This syntax is deprecated." in capfd.readouterr().err
    node.destroy_node()
