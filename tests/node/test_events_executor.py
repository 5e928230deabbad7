"""The events executor: callbacks run in the order of their events."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
from collections.abc import Callable

import pytest
from tests.conftest import Program, wait_until

from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node.context.context import Context
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.events_executor import EventsExecutor
from tfloom.node.executing.task import Future
from tfloom.node.executing.timer import Timer
from tfloom.node.node import Node

MakeNode = Callable[..., Node]


def test_callbacks_run_in_the_order_of_their_events(node: Node, context: Context) -> None:
    order: list[str] = []
    with EventsExecutor(context=context) as executor:
        publishers = {name: node.create_publisher(Int32, name, 10) for name in "abc"}
        for name in "abc":
            node.create_subscription(Int32, name, lambda _, name=name: order.append(name), 10)
        executor.add_node(node)
        executor.spin_once(timeout_sec=0)
        for name in "cabcab":
            publishers[name].publish(Int32())
        executor.create_task(lambda: (order.append("task"), executor.shutdown()))
        executor.spin()
    assert order[:4] == ["c", "a", "b", "task"], "one of each, in the order in which they came"


def test_timers_run_in_the_order_of_their_deadlines(node: Node, context: Context) -> None:
    order: list[Timer] = []
    with EventsExecutor(context=context) as executor:

        def append(index: int) -> None:
            timers[index].cancel()
            order.append(timers[index])
            if len(order) == len(timers):
                executor.shutdown()

        periods = (0.03, 0.01, 0.02)
        timers = [
            node.create_timer(period, lambda index=index: append(index))
            for index, period in enumerate(periods)
        ]
        by_deadline = sorted(timers, key=lambda timer: timer.deadline_ns())
        executor.add_node(node)
        wait_until(lambda: all(timer.is_ready() for timer in timers))
        executor.spin()
    assert order == by_deadline


def test_rest_of_a_pass_runs_in_the_next_spin_after_an_error(node: Node, context: Context) -> None:
    ran: list[str] = []

    def fail() -> None:
        raise KeyError("mine")

    with EventsExecutor(context=context) as executor:
        executor.create_task(fail)
        executor.create_task(lambda: ran.append("second"))
        executor.create_task(executor.shutdown)
        executor.add_node(node)
        with pytest.raises(KeyError, match="mine"):
            executor.spin()
        assert ran == []
        executor.spin()
    assert ran == ["second"]


def test_exclusive_group_waits_for_the_end_of_a_coroutine(node: Node, context: Context) -> None:
    """Even on one thread, other callbacks run while a coroutine waits."""
    order: list[str] = []
    with EventsExecutor(context=context) as executor:
        gate: Future[None] = Future(executor=executor)
        group = MutuallyExclusiveCallbackGroup()

        async def waits() -> None:
            timer.cancel()
            order.append("begun")
            await gate
            order.append("ended")

        def finish() -> None:
            order.append("other")
            executor.shutdown()

        timer = node.create_timer(0.0, waits, group)
        node.create_timer(0.001, finish, group)
        node.create_timer(
            0.02, lambda: gate.done() or gate.set_result(None), MutuallyExclusiveCallbackGroup()
        )
        executor.add_node(node)
        executor.spin()
    assert order == ["begun", "ended", "other"]


def test_second_spinning_thread_raises(node: Node, context: Context) -> None:
    with EventsExecutor(context=context) as executor:
        executor.add_node(node)
        begun = threading.Event()
        node.create_timer(0.0, begun.set)
        thread = threading.Thread(target=executor.spin)
        thread.start()
        assert begun.wait(30)
        for spin in (
            executor.spin,
            executor.spin_once,
            lambda: executor.spin_until_future_complete(Future()),
        ):
            with pytest.raises(RuntimeError, match="already spinning"):
                spin()
        executor.shutdown(10)
        thread.join(10)
        assert not thread.is_alive()


def test_facade_of_events_executor_loads_no_heavy_module() -> None:
    code = (
        "import sys, rclpy, rclpy.experimental\n"
        "from rclpy.experimental.events_executor import EventsExecutor\n"
        "from rclpy.executors import Executor\n"
        "assert issubclass(EventsExecutor, Executor)\n"
        "print([m for m in ('numpy', 'asyncio', 'concurrent.futures') if m in sys.modules])\n"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert result.stdout == "[]\n"


@pytest.mark.parametrize(
    ("number", "error"),
    [(signal.SIGINT, "KeyboardInterrupt"), (signal.SIGTERM, "ExternalShutdownException")],
)
def test_signals_end_the_spin(start_program: Callable[..., Program], number: int, error: str) -> None:
    code = (
        "import rclpy\n"
        "from rclpy.experimental import EventsExecutor\n"
        "with rclpy.init():\n"
        "    node = rclpy.create_node('spinner')\n"
        "    node.create_timer(0.0, lambda: (timer.cancel(), print('spinning', flush=True)))\n"
        "    timer = next(node.timers)\n"
        "    try:\n"
        "        rclpy.spin(node, executor=EventsExecutor())\n"
        "    except BaseException as error:\n"
        "        print(type(error).__name__)\n"
    )
    program = start_program("python", "-c", code)
    program.wait_for("spinning")
    program.signal(number)
    assert program.wait() == 0
    assert program.lines == ["spinning", error]
