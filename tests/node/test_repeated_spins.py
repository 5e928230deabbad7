"""Nodes that are spun again and again, and leave the executor in between: on both wires."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node import client_library as rclpy
from tfloom.node.context.context import Context
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.executing.callback_groups import CallbackGroup
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.node import Node


@pytest.fixture
def context(context_on_each_wire: Context) -> Context:
    return context_on_each_wire


class Hearing:
    """A node that hears numbers, and the publisher of these."""

    def __init__(self, node: Node, publisher: Publisher) -> None:
        self.node = node
        self.heard: list[int] = []
        self._publisher = publisher
        self._sent = 0
        self.subscription = node.create_subscription(
            Int32, "numbers", lambda msg: self.heard.append(msg.data), 10
        )
        wait_until(lambda: publisher.get_subscription_count() > 0)

    def send(self) -> None:
        self._sent += 1
        self._publisher.publish(Int32(data=self._sent))

    def has_heard_all(self) -> bool:
        return self.heard == list(range(1, self._sent + 1))


def spin_until(node: Node, executor: SingleThreadedExecutor, is_over: Callable[[], bool]) -> None:
    wait_until(lambda: rclpy.spin_once(node, executor=executor, timeout_sec=0.1) or is_over())


@pytest.fixture
def hearing(make_node: Callable[..., Node]) -> Hearing:
    return Hearing(make_node("hearing"), make_node("talking").create_publisher(Int32, "numbers", 10))


@pytest.fixture
def executor(context: Context) -> SingleThreadedExecutor:
    return SingleThreadedExecutor(context=context)


def test_a_node_is_in_no_executor_between_two_spins(
    hearing: Hearing, executor: SingleThreadedExecutor
) -> None:
    for _ in range(5):
        hearing.send()  # arrives before or during the next spin
        spin_until(hearing.node, executor, hearing.has_heard_all)
        assert executor.get_nodes() == []


def test_a_message_that_another_spin_passed_by_is_heard(
    hearing: Hearing, executor: SingleThreadedExecutor, make_node: Callable[..., Node]
) -> None:
    rclpy.spin_once(hearing.node, executor=executor, timeout_sec=0.0)
    other = make_node("other")
    ticks: list[None] = []
    other.create_timer(0.001, lambda: ticks.append(None))
    executor.add_node(other)
    hearing.send()
    wait_until(lambda: executor.spin_once(timeout_sec=0.1) or len(ticks) >= 3)
    assert hearing.heard == []
    spin_until(hearing.node, executor, hearing.has_heard_all)


def test_nodes_take_turns(
    hearing: Hearing, executor: SingleThreadedExecutor, make_node: Callable[..., Node]
) -> None:
    other = make_node("other")
    ticks: list[None] = []
    other.create_timer(0.001, lambda: ticks.append(None))
    for turn in range(1, 4):
        hearing.send()
        spin_until(other, executor, lambda turn=turn: len(ticks) >= 2 * turn)  # type: ignore[misc]
        spin_until(hearing.node, executor, hearing.has_heard_all)


def test_a_node_goes_on_in_another_executor(
    hearing: Hearing, executor: SingleThreadedExecutor, context: Context
) -> None:
    rclpy.spin_once(hearing.node, executor=executor, timeout_sec=0.0)
    with MultiThreadedExecutor(context=context) as second:
        second.add_node(hearing.node)
        hearing.send()
        wait_until(lambda: second.spin_once(timeout_sec=0.1) or hearing.has_heard_all())
        second.remove_node(hearing.node)
    hearing.send()
    spin_until(hearing.node, executor, hearing.has_heard_all)


def test_entities_that_changed_between_spins(
    hearing: Hearing, executor: SingleThreadedExecutor, make_node: Callable[..., Node]
) -> None:
    rclpy.spin_once(hearing.node, executor=executor, timeout_sec=0.0)
    later: list[int] = []
    publisher = make_node("late").create_publisher(Int32, "later", 10)
    subscription = hearing.node.create_subscription(Int32, "later", lambda msg: later.append(msg.data), 10)
    wait_until(lambda: publisher.get_subscription_count() > 0)
    publisher.publish(Int32(data=1))
    hearing.send()
    spin_until(hearing.node, executor, lambda: hearing.has_heard_all() and later == [1])
    hearing.node.destroy_subscription(subscription)
    publisher.publish(Int32(data=2))
    hearing.send()
    spin_until(hearing.node, executor, hearing.has_heard_all)
    assert later == [1]


def test_a_node_without_references_is_freed(
    make_node: Callable[..., Node], context: Context, executor: SingleThreadedExecutor
) -> None:
    node = Node("dropped", context=context)
    node.create_subscription(Int32, "numbers", print, 10)
    rclpy.spin_once(node, executor=executor, timeout_sec=0.0)
    rclpy.spin_once(node, executor=executor, timeout_sec=0.0)
    reference = weakref.ref(node)
    del node
    gc.collect()  # finalizes the node, which its context then holds until another one joins
    watcher = make_node("watcher")
    wait_until(lambda: watcher.get_node_names() == ["watcher"])
    gc.collect()
    assert reference() is None  # from Python 3.15 on only now: a finalizer no longer clears weak references


class Hesitant(CallbackGroup):
    """A group of a program: until `is_open`, it refuses each callback, when asked or when one begins."""

    def __init__(self, refuses_when_asked: bool) -> None:
        super().__init__()
        self.is_open = False
        self.refusals = 0
        self._refuses_when_asked = refuses_when_asked

    def can_execute(self, entity: object) -> bool:
        return self._is_admitted(self.is_open or not self._refuses_when_asked)

    def beginning_execution(self, entity: object) -> bool:
        return self._is_admitted(self.is_open)

    def _is_admitted(self, answer: bool) -> bool:
        self.refusals += not answer
        return answer

    def ending_execution(self, entity: object) -> None:
        pass


@pytest.mark.parametrize("refuses_when_asked", [True, False])
def test_a_message_that_a_group_refused_is_kept_between_spins(
    refuses_when_asked: bool, make_node: Callable[..., Node], executor: SingleThreadedExecutor
) -> None:
    node, group, heard = make_node(), Hesitant(refuses_when_asked), list[int]()
    publisher = node.create_publisher(Int32, "numbers", 10)
    node.create_subscription(Int32, "numbers", lambda msg: heard.append(msg.data), 10, callback_group=group)
    wait_until(lambda: publisher.get_subscription_count() > 0)
    publisher.publish(Int32(data=1))
    wait_until(lambda: rclpy.spin_once(node, executor=executor, timeout_sec=0.01) or group.refusals)
    executor.spin_once(timeout_sec=0.0)  # of other nodes
    group.is_open = True
    spin_until(node, executor, lambda: bool(heard))
    assert heard == [1]
