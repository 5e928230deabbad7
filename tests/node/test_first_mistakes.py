"""What newcomers get wrong: the answer says what to do."""

from __future__ import annotations

import gc
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tfloom.interfaces.rcl_interfaces.msg import Log
from tfloom.interfaces.std_msgs.msg import Int32, String
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.node import client_library as rclpy
from tfloom.node.context.context import Context
from tfloom.node.executing import executor as executor_module
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from tfloom.node.executing.executor import ENDLESS_HINT, NESTED_HINT, Executor
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.node.node import Node

SOURCES = Path(executor_module.__file__).parents[2]
WHAT_TO_DO = "has to call super().__init__('a_node_name')"


def warnings(capsys: pytest.CaptureFixture[str]) -> list[str]:
    return [line.partition("]: ")[2] for line in capsys.readouterr().err.splitlines() if "[WARN]" in line]


class Forgetful(Node):
    def __init__(self) -> None:
        pass


class TooLate(Node):
    def __init__(self, context: Context) -> None:
        self.publisher = self.create_publisher(String, "chatter", 10)
        super().__init__("too_late", context=context)


USES: dict[str, Callable[[Any], object]] = {
    "create_publisher": lambda node: node.create_publisher(String, "x", 1),
    "create_subscription": lambda node: node.create_subscription(String, "x", print, 1),
    "create_service": lambda node: node.create_service(Trigger, "x", print),
    "create_client": lambda node: node.create_client(Trigger, "x"),
    "create_rate": lambda node: node.create_rate(1.0),
    "create_timer": lambda node: node.create_timer(1.0, print),
    "create_guard_condition": lambda node: node.create_guard_condition(print),
    "declare_parameter": lambda node: node.declare_parameter("x", 1),
    "get_parameter": lambda node: node.get_parameter("x"),
    "has_parameter": lambda node: node.has_parameter("x"),
    "set_parameters": lambda node: node.set_parameters([rclpy.Parameter("x", value=1)]),
    "add_on_set_parameters_callback": lambda node: node.add_on_set_parameters_callback(print),
    "get_logger": lambda node: node.get_logger(),
    "get_clock": lambda node: node.get_clock(),
    "get_name": lambda node: node.get_name(),
    "get_topic_names_and_types": lambda node: node.get_topic_names_and_types(),
    "executor": lambda node: node.executor,
    "context": lambda node: node.context,
    "default_callback_group": lambda node: node.default_callback_group,
    "publishers": lambda node: node.publishers,
    "destroy_node": lambda node: node.destroy_node(),
}


@pytest.mark.parametrize("use", USES)
def test_a_node_whose_init_was_never_called_says_so(use: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(
        AttributeError, match=r"^this Forgetful is not a node yet: Forgetful.__init__ "
    ) as raised:
        USES[use](Forgetful())
    assert WHAT_TO_DO in str(raised.value)
    in_tfloom = [place for place in raised.traceback if SOURCES in place.path.parents]
    # A subclass's `destroy_node` calls that of its base.
    assert len(in_tfloom) <= (3 if use == "destroy_node" else 2)
    sys.__excepthook__(raised.type, raised.value, raised.tb)
    printed = capsys.readouterr().err
    assert WHAT_TO_DO in printed
    assert "Did you mean" not in printed  # one of the class's private names


def test_a_lifecycle_node_says_so(context: Context) -> None:
    class Forgetting(LifecycleNode):
        def __init__(self) -> None:
            pass

    with pytest.raises(AttributeError, match="this Forgetting is not a node yet"):
        Forgetting().create_timer(1.0, print)


def test_calling_init_last_says_so(context: Context) -> None:
    with pytest.raises(AttributeError, match="this TooLate is not a node yet") as raised:
        TooLate(context)
    assert WHAT_TO_DO in str(raised.value)


def test_spinning_it_says_so(executor: SingleThreadedExecutor) -> None:
    with pytest.raises(AttributeError, match="this Forgetful is not a node yet"):
        executor.add_node(Forgetful())


def test_attributes_of_the_programs_own_are_as_ever(node: Node) -> None:
    assert not hasattr(node, "mine")
    assert not hasattr(Forgetful(), "mine")
    with pytest.raises(AttributeError, match="'Forgetful' object has no attribute 'mine'"):
        Forgetful().mine  # noqa: B018


# Two types on one topic


@pytest.mark.parametrize("one_node", [True, False])
def test_two_types_on_one_topic_warn(
    one_node: bool, make_node: Callable[..., Node], capsys: pytest.CaptureFixture[str]
) -> None:
    first = make_node("first")
    second = first if one_node else make_node("second")
    first.create_publisher(String, "chatter", 10)
    second.create_publisher(String, "chatter", 10)
    second.create_subscription(String, "chatter", print, 10)
    assert warnings(capsys) == []
    second.create_subscription(Int32, "/chatter", print, 10)
    text = (
        "/chatter has two types in this program: std_msgs/msg/String, and here std_msgs/msg/Int32. "
        "Messages pass only between endpoints of one type"
    )
    assert warnings(capsys) == [text]
    second.create_subscription(Int32, "numbers", print, 10)
    assert warnings(capsys) == []


@pytest.mark.parametrize("is_kept", [True, False])
def test_a_topic_may_change_its_type(is_kept: bool, node: Node, capsys: pytest.CaptureFixture[str]) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    node.destroy_publisher(publisher)
    if not is_kept:
        del publisher
        gc.collect()
    node.create_publisher(Int32, "chatter", 10)
    assert warnings(capsys) == []


# Spinning inside a callback


@pytest.fixture
def short_hint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(executor_module, "NESTED_HINT_NS", 20_000_000)


@pytest.fixture(params=[SingleThreadedExecutor, MultiThreadedExecutor])
def outer(request: pytest.FixtureRequest, context: Context) -> Iterator[Executor]:
    with request.param(context=context) as executor:
        yield executor


def spin_until(executor: Executor, future: Future[Any]) -> None:
    executor.spin_until_future_complete(future, timeout_sec=30)
    assert future.done()


SPINS: dict[str, Callable[[Node, Future[Any], Executor], None]] = {
    "spin_once": lambda node, _, executor: rclpy.spin_once(node, executor=executor, timeout_sec=0.2),
    "spin_until_future_complete": lambda node, future, executor: rclpy.spin_until_future_complete(
        node, future, executor, timeout_sec=0.2
    ),
}


@pytest.mark.usefixtures("short_hint")
@pytest.mark.parametrize("spin", SPINS)
def test_a_spin_that_waits_for_its_own_group_says_what_to_do(
    spin: str, outer: Executor, node: Node, context: Context, capsys: pytest.CaptureFixture[str]
) -> None:
    """By its own executor, as the short functions spin by the global one."""
    never, done = Future[None](), Future[bool]()

    def wait() -> None:
        timer.cancel()
        tick = node.create_timer(0.001, lambda: never.set_result(None))
        with SingleThreadedExecutor(context=context) as inner:
            SPINS[spin](node, never, inner)
        tick.cancel()
        done.set_result(never.done())

    timer = node.create_timer(0.0, wait)
    outer.add_node(node)
    spin_until(outer, done)
    assert done.result() is False
    assert warnings(capsys) == [NESTED_HINT]


@pytest.mark.usefixtures("short_hint")
def test_in_its_own_executor_too(
    executor: SingleThreadedExecutor, node: Node, capsys: pytest.CaptureFixture[str]
) -> None:
    never, done = Future[None](), Future[None]()

    def wait() -> None:
        timer.cancel()
        node.create_timer(0.001, lambda: None)
        node.create_timer(
            0.005, lambda: None, MutuallyExclusiveCallbackGroup()
        )  # wakes the nested spin, often
        executor.spin_until_future_complete(never, timeout_sec=0.2)
        executor.spin_until_future_complete(never, timeout_sec=0.2)
        done.set_result(None)

    timer = node.create_timer(0.0, wait)
    executor.add_node(node)
    spin_until(executor, done)
    assert warnings(capsys) == [NESTED_HINT]


ENDLESS_SPINS: dict[str, Callable[[Node, Future[Any], Executor], None]] = {
    "spin_once": lambda node, _, executor: rclpy.spin_once(node, executor=executor),
    "spin_until_future_complete": rclpy.spin_until_future_complete,
}


@pytest.mark.parametrize("is_own", [True, False])
@pytest.mark.parametrize("spin", ENDLESS_SPINS)
def test_a_spin_without_a_limit_says_that_nothing_may_run(
    spin: str,
    is_own: bool,
    node: Node,
    context: Context,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """In a callback of a node with nothing else to run, which therefore waits for ever."""
    monkeypatch.setattr(executor_module, "ENDLESS_HINT_NS", 20_000_000)
    outer, inner = (SingleThreadedExecutor(context=context) for _ in range(2))
    waited_for, done = Future[None](), Future[None]()

    def wait() -> None:
        timer.cancel()
        executor = outer if is_own else inner
        thread = threading.Thread(target=end_after_hint, args=[executor])
        thread.start()
        ENDLESS_SPINS[spin](node, waited_for, executor)
        thread.join()
        done.set_result(None)

    def end_after_hint(executor: Executor) -> None:
        end = time.monotonic() + 3
        while not executor._has_hinted and time.monotonic() < end:
            time.sleep(0.005)
        executor.create_task(waited_for.set_result, None)

    timer = node.create_timer(0.0, wait)
    outer.add_node(node)
    with outer, inner:
        spin_until(outer, done)
    assert warnings(capsys) == [ENDLESS_HINT]


@pytest.mark.usefixtures("short_hint")
def test_a_spin_whose_future_is_completed_elsewhere_says_nothing(
    executor: SingleThreadedExecutor, node: Node, capsys: pytest.CaptureFixture[str]
) -> None:
    future, done = Future[None](), Future[None]()

    def wait() -> None:
        timer.cancel()
        node.create_timer(0.1, lambda: future.set_result(None), MutuallyExclusiveCallbackGroup())
        executor.spin_until_future_complete(future, timeout_sec=30)
        done.set_result(None)

    timer = node.create_timer(0.0, wait)
    executor.add_node(node)
    spin_until(executor, done)
    assert future.done()
    assert warnings(capsys) == []


@pytest.mark.usefixtures("short_hint")
def test_a_coroutine_that_keeps_its_group_says_nothing(
    executor: SingleThreadedExecutor, node: Node, capsys: pytest.CaptureFixture[str]
) -> None:
    gate: Future[None] = Future(executor=executor)

    async def wait() -> None:
        await gate

    node.create_timer(0.001, wait)
    executor.add_node(node)
    end = time.monotonic() + 0.1
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.01)
    assert warnings(capsys) == []


def test_a_thread_of_the_pool_that_waits_for_itself_is_told_so(
    context: Context, node: Node, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a timeout, for what nothing can complete; the executor goes on, and its end ends that wait."""
    monkeypatch.setattr(executor_module, "ENDLESS_HINT_NS", 20_000_000)
    ended, other_ran = threading.Event(), Future[None]()

    def wait() -> None:
        timer.cancel()
        executor.spin_until_future_complete(Future[None]())
        ended.set()

    with MultiThreadedExecutor(2, context=context) as executor:
        timer = node.create_timer(0.0, wait)
        executor.add_node(node)
        text = ""
        while ENDLESS_HINT not in text:
            executor.spin_once(timeout_sec=0.01)
            text += capsys.readouterr().err
        node.create_timer(0.0, lambda: other_ran.set_result(None), ReentrantCallbackGroup())
        spin_until(executor, other_ran)
        assert not ended.is_set()
    assert ended.wait(30)


# Two nodes of one name

REGISTERED = (
    "Publisher already registered for node name: 'twin'. If this is due to multiple nodes with the same name then all "
    "logs for the logger named 'twin' will go out over the existing publisher. As soon as that node is destroyed the "
    "next one of that name takes over."
)


def test_two_nodes_of_one_name_warn(
    make_node: Callable[..., Node], capsys: pytest.CaptureFixture[str]
) -> None:
    make_node("twin")
    make_node("twin", namespace="/elsewhere")
    make_node("twin", enable_rosout=False)
    assert warnings(capsys) == []
    make_node("twin")
    assert warnings(capsys) == [REGISTERED]


def test_a_name_may_be_used_again(make_node: Callable[..., Node], capsys: pytest.CaptureFixture[str]) -> None:
    make_node("twin").destroy_node()
    make_node("twin")
    assert warnings(capsys) == []


def test_a_record_of_twins_is_published_once(
    make_node: Callable[..., Node], spin_until: Callable[..., None], executor: SingleThreadedExecutor
) -> None:
    heard: list[str] = []
    listener = make_node("listener")
    listener.create_subscription(Log, "/rosout", lambda record: heard.append(record.msg), 100)
    executor.add_node(listener)
    first, second = make_node("twin"), make_node("twin")

    def heard_of_twins() -> list[str]:
        return [text for text in heard if not text.startswith("Publisher")]

    first.get_logger().info("one")
    second.get_logger().info("two")
    spin_until(lambda: len(heard_of_twins()) >= 2)
    first.destroy_node()
    second.get_logger().info("three")
    spin_until(lambda: len(heard_of_twins()) >= 3)
    assert heard_of_twins() == ["one", "two", "three"]
