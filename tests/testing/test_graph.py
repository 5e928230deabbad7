"""What a test waits for, and what it is told if that doesn't happen."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
from rclpy.context import Context
from rclpy.executors import Executor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Int32, String
from std_srvs.srv import Trigger

from tfloom.testing import graph as graph_module
from tfloom.testing.graph import NotSeenError, RosGraph
from tfloom.testing.transform_table import TableError


class Counter(Node):
    """Publishes 0, 1, 2 …, one each millisecond."""

    def __init__(self) -> None:
        super().__init__("counter")
        self.count = 0
        self.numbers = self.create_publisher(Int32, "numbers", 10)
        self.create_timer(0.001, self.next)

    def next(self) -> None:
        self.numbers.publish(Int32(data=self.count))
        self.count += 1


def test_wait_for_message(ros_graph: RosGraph, wait_for_message: Callable[..., Any]) -> None:
    ros_graph.add(Counter())
    assert wait_for_message(Int32, "numbers").data >= 0
    assert wait_for_message(Int32, "/numbers", where=lambda number: number.data >= 5).data == 5


def test_a_latched_message_from_before_is_received(
    ros_node: Node, wait_for_message: Callable[..., Any]
) -> None:
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    ros_node.create_publisher(String, "map", latched).publish(String(data="latched"))
    assert wait_for_message(String, "map").data == "latched"


def test_collect_keeps_the_order(ros_graph: RosGraph) -> None:
    numbers = ros_graph.collect(Int32, "numbers")
    ros_graph.add(Counter())
    ros_graph.spin_until(lambda: len(numbers) >= 5)
    assert [number.data for number in numbers[:5]] == [0, 1, 2, 3, 4]


def test_a_service_is_called_by_its_future(ros_graph: RosGraph, ros_node: Node) -> None:
    server = ros_graph.create_node("server", namespace="/ns")
    server.create_service(Trigger, "act", lambda _request, response: Trigger.Response(message="done"))
    future = ros_node.create_client(Trigger, "/ns/act").call_async(Trigger.Request())
    ros_graph.spin_until(future.done)
    assert future.result().message == "done"


def test_a_condition_that_another_thread_fulfils(ros_graph: RosGraph) -> None:
    ended = threading.Event()
    threading.Timer(0.01, ended.set).start()
    ros_graph.spin_until(ended.is_set)


def test_the_executor_takes_nodes_by_ros_own_names(
    ros_executor: Executor, ros_graph: RosGraph, wait_for_message: Callable[..., Any]
) -> None:
    node = Counter()
    ros_executor.add_node(node)
    wait_for_message(Int32, "numbers")
    ros_executor.remove_node(node)
    node.destroy_node()


def test_an_exception_in_a_callback_fails_the_test(ros_graph: RosGraph) -> None:
    for spin in (lambda: ros_graph.spin_until(lambda: False), ros_graph.spin_until_idle):
        node = ros_graph.create_node("faulty")
        node.create_subscription(String, "words", lambda message: int(message.data), 1)
        ros_graph.observer.create_publisher(String, "words", 1).publish(String(data="no number"))
        with pytest.raises(ValueError, match="invalid literal"):
            spin()
        node.destroy_node()


def failure(call: Callable[[], object]) -> str:
    with pytest.raises(NotSeenError) as caught:
        call()
    return str(caught.value)


def test_a_wait_in_vain_says_why(
    ros_graph: RosGraph, ros_node: Node, wait_for_message: Callable[..., Any]
) -> None:
    nobody = failure(lambda: wait_for_message(Int32, "numbrs", 0.01))
    assert nobody.startswith(
        "no message on /numbrs within 0.01 s: nobody publishes there; topics of the graph: "
    )
    assert "/rosout" in nobody
    assert "does not spin" not in nobody

    forgotten = Counter()
    idle = failure(lambda: wait_for_message(Int32, "numbers", 0.01))
    assert "published by counter, which sent nothing; this test does not spin /counter: " in idle
    assert idle.endswith("spin a node by ros_graph.add(node)")
    waited = failure(lambda: ros_graph.spin_until(lambda: False, 0.01, "a miracle"))
    assert waited.startswith("gave up after 0.01 s waiting for a miracle; this test does not spin /counter")

    ros_graph.add(forgotten)
    other = failure(lambda: wait_for_message(Int32, "numbers", 0.05, where=lambda number: number.data < 0))
    assert "others were received, of which `where` accepted none; the last: std_msgs.msg.Int32(data=" in other

    ros_node.create_publisher(String, "text", 1)
    wrong = failure(lambda: wait_for_message(Int32, "text", 0.01))
    assert wrong.endswith("test_node publishes std_msgs/msg/String there, not std_msgs/msg/Int32")


def test_bad_use_is_named(ros_graph: RosGraph) -> None:
    with pytest.raises(TypeError, match=r"takes a node, not the class Counter: create a node of it"):
        ros_graph.add(Counter)
    with pytest.raises(TypeError, match=r"takes a node, not 'counter'"):
        ros_graph.add("counter")
    with pytest.raises(TypeError, match=r"a function that returns whether to stop, not False"):
        ros_graph.spin_until(False)
    with pytest.raises(TableError, match="the table has no transform"):
        ros_graph.broadcast("")
    other = Context()
    other.init(args=[])
    node = Node("stranger", context=other)
    with pytest.raises(ValueError, match=r"the node /stranger is of another context than this test's"):
        ros_graph.add(node)
    other.destroy()


def test_callbacks_without_end_are_detected(ros_graph: RosGraph, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graph_module, "MAX_CALLBACKS", 100)
    node = ros_graph.create_node("echo")
    publisher = node.create_publisher(String, "words", 1)
    node.create_subscription(String, "words", publisher.publish, 1)
    publisher.publish(String())
    assert "callbacks have caused one another 100 times" in failure(ros_graph.spin_until_idle)


def test_a_shut_down_context_ends_a_wait(ros_graph: RosGraph, ros_context: Context) -> None:
    begin = time.monotonic()
    ros_context.shutdown()
    with pytest.raises(NotSeenError, match="rclpy was shut down during the wait for a condition"):
        ros_graph.spin_until(lambda: False, 60.0)
    assert time.monotonic() - begin < 30


@pytest.mark.ros_wire("dds")
@pytest.mark.wire
def test_over_dds(ros_graph: RosGraph, wait_for_message: Callable[..., Any], ros_domain: int) -> None:
    from tfloom.rmw.cyclone import wire as cyclonedds

    ros_graph.add(Counter())
    assert wait_for_message(Int32, "numbers", where=lambda number: number.data > 3).data > 3
    assert cyclonedds.is_joined(ros_domain)
