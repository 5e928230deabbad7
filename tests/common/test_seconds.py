"""Seconds that programs give: every public parameter that takes some takes numbers of each kind, and no NaN."""

from __future__ import annotations

import asyncio
import contextlib
import importlib
import inspect
import math
import pkgutil
import sys
import threading
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import tfloom
from tfloom.cli.api.lifecycle import (
    call_change_states,
    call_get_available_transitions,
    call_get_states,
    call_get_transition_graph,
)
from tfloom.cli.api.node import wait_for_node
from tfloom.cli.plugins.helpers import wait_for
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.std_msgs.msg import Empty
from tfloom.interfaces.std_srvs.srv import Trigger
from tfloom.interfaces.tf2_msgs.action import LookupTransform
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.ros.actions.ros_timer import ROSTimer
from tfloom.launch.testing.actions import GTest, PyTest, Test
from tfloom.launch.testing.fixtures import process as fixtures
from tfloom.launch.testing.io_handler import ActiveIoHandler
from tfloom.launch.testing.markers import retry_on_failure
from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler
from tfloom.launch.testing.process import ProcessProxy
from tfloom.launch.testing.readiness import ready_to_test_action_timeout
from tfloom.launch.testing.ros.topics import WaitForTopics
from tfloom.node import client_library
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.clock.clock import Clock
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import timeout_sec_to_nsec
from tfloom.node.executing.executors import MultiThreadedExecutor, SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.executing.timer import Timer
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.node.node import Node
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import TimeoutException, TimeoutObject
from tfloom.node.values.time import Time
from tfloom.node.wait_for_message import wait_for_message
from tfloom.tf2_ros.buffer_client import BufferClient

pytestmark = pytest.mark.filterwarnings("ignore::pytest.PytestCollectionWarning")

NAMES = {
    "period",
    "seconds",
    "nanoseconds",
    "time_to_wait",
    "frequency",
    "delay",
    "respawn_delay",
    "timer_period_ns",
}
"""The names of parameters that take seconds, beside those with `timeout`, `_sec` and `_nsec` in them."""

Later = Callable[[Callable[[], Any]], None]
"""Has a function called while the door waits, where it would wait for ever."""
Door = Callable[["Ends", Any, Later], Any]


class Ends:
    """What the doors wait on: a context, a node that is spun, and one that is not."""

    def __init__(self, context: Context) -> None:
        self.context = context
        self.node = Node("waiting", context=context)
        self.other = Node("other", context=context)
        self.executor = SingleThreadedExecutor(context=context)
        self.own = SingleThreadedExecutor(context=context)
        self.executor.add_node(self.other)
        self.thread = threading.Thread(target=self.executor.spin)
        self.thread.start()

    def close(self) -> None:
        self.executor.shutdown()
        self.thread.join()
        self.own.shutdown()
        self.node.destroy_node()
        self.other.destroy_node()


@pytest.fixture
def ends(monkeypatch: pytest.MonkeyPatch) -> Iterator[Ends]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    context = Context()
    context.init(["program"])
    ends = Ends(context)
    yield ends
    ends.close()
    context.destroy()


# Doors: each does with some seconds what a program does, and ends for whoever waits without a limit


def spin(name: str, *, by: str = "") -> Door:
    """Return the door of an executor's method; `by`: with a future, or with a TimeoutObject."""

    def door(ends: Ends, seconds: Any, later: Later) -> None:
        future: Future[Any] = Future(executor=ends.own)
        later(lambda: (future.set_result(1), ends.own.create_task(int)))
        arguments = [future] if "future" in name else []
        with contextlib.suppress(TimeoutException):
            getattr(ends.own, name)(*arguments, timeout_sec=TimeoutObject(seconds) if by else seconds)

    return door


def spin_by_function(name: str) -> Door:
    def door(ends: Ends, seconds: Any, later: Later) -> None:
        future: Future[Any] = Future(executor=ends.own)
        later(lambda: (future.set_result(1), ends.own.create_task(int)))
        arguments = [future] if "future" in name else []
        getattr(client_library, name)(ends.node, *arguments, executor=ends.own, timeout_sec=seconds)

    return door


def shut_down(kind: Any) -> Door:
    def door(ends: Ends, seconds: Any, later: Later) -> None:
        release, began = threading.Event(), threading.Event()
        executor = kind(context=ends.context)
        executor.create_task(lambda: (began.set(), release.wait(30)))
        thread = threading.Thread(target=executor.spin_once)
        thread.start()
        assert began.wait(30)
        later(release.set)
        try:
            executor.shutdown(seconds)
        finally:
            release.set()
            thread.join()
            executor.shutdown()

    return door


def call(ends: Ends, seconds: Any, later: Later) -> None:
    release = threading.Event()

    def respond(_: Any, response: Any) -> Any:
        assert release.wait(30)
        return response

    ends.other.create_service(Trigger, "call", respond)
    client = ends.node.create_client(Trigger, "call")
    assert client.wait_for_service(30)
    later(release.set)
    try:
        client.call(Trigger.Request(), timeout_sec=seconds)
    finally:
        release.set()


def wait_for_service(ends: Ends, seconds: Any, later: Later) -> None:
    client = ends.node.create_client(Trigger, "awaited")
    later(lambda: ends.other.create_service(Trigger, "awaited", lambda _, response: response))
    client.wait_for_service(seconds)


def wait_for_server(ends: Ends, seconds: Any, later: Later) -> None:
    client = ActionClient(ends.node, Fibonacci, "awaited_action")
    later(lambda: ActionServer(ends.other, Fibonacci, "awaited_action", lambda goal: Fibonacci.Result()))
    client.wait_for_server(seconds)


def wait_for_buffer_server(ends: Ends, seconds: Any, later: Later) -> None:
    client = BufferClient(ends.node, "buffer")
    later(lambda: ActionServer(ends.other, LookupTransform, "buffer", lambda goal: LookupTransform.Result()))
    client.wait_for_server(seconds)


def wait_for_parameter_services(ends: Ends, seconds: Any, later: Later) -> None:
    client = AsyncParameterClient(ends.node, "/awaited_node")
    later(lambda: new_node(ends, "awaited_node"))
    client.wait_for_services(seconds)


def wait_for_a_node(ends: Ends, seconds: Any, later: Later) -> None:
    later(lambda: new_node(ends, "awaited"))
    ends.node.wait_for_node("/awaited", seconds)


def wait_for_a_listed_node(ends: Ends, seconds: Any, later: Later) -> None:
    later(lambda: new_node(ends, "awaited"))
    wait_for_node(ends.node, False, "/awaited", seconds)  # type: ignore[arg-type]


def new_node(ends: Ends, name: str) -> None:
    ends.executor.add_node(Node(name, context=ends.context))


def wait_for_a_message(ends: Ends, seconds: Any, later: Later) -> None:
    publisher = ends.other.create_publisher(Empty, "messages", 1)

    def publish() -> None:
        while publisher.get_subscription_count() == 0:
            threading.Event().wait(0.001)
        publisher.publish(Empty())

    later(publish)
    wait_for_message(Empty, ends.node, "messages", time_to_wait=seconds)


def wait_for_topics(ends: Ends, seconds: Any, later: Later) -> None:
    waiting = WaitForTopics([("messages", Empty)], timeout=seconds)
    later(lambda: waiting._receiver("messages")(Empty()))
    try:
        waiting.wait()
    finally:
        waiting.shutdown()


def listen(method: str) -> Door:
    def door(ends: Ends, seconds: Any, later: Later) -> None:
        handler = ActiveIoHandler()
        later(handler.close)
        with contextlib.suppress(AssertionError):
            getattr(handler, method)("text", timeout=seconds)

    return door


def see(method: str) -> Door:
    def door(ends: Ends, seconds: Any, later: Later) -> None:
        handler = ActiveProcInfoHandler()
        later(handler.close)
        with contextlib.suppress(AssertionError):
            getattr(handler, method)("process", timeout=seconds)

    return door


def ask_process(method: str) -> Door:
    def door(ends: Ends, seconds: Any, later: Later) -> None:
        info, output = ActiveProcInfoHandler(), ActiveIoHandler()
        is_over = threading.Event()
        later(lambda: (is_over.set(), info.close(), output.close()))
        proxy = ProcessProxy(ExecuteProcess(cmd=["x"]), info, output)
        options = {} if "shutdown" in method else {"condition": lambda _: is_over.is_set()}
        getattr(proxy, method)(timeout=seconds, **options)

    return door


def await_process(name: str) -> Door:
    """Return the door of a function of launch_pytest, on whose launch nothing happens but a cancellation."""

    def door(ends: Ends, seconds: Any, later: Later) -> None:
        async def run() -> None:
            arguments = [lambda _: False] if "put" in name or "stderr" in name else []
            waiting = asyncio.ensure_future(
                getattr(fixtures, name)(
                    LaunchContext(), ExecuteProcess(cmd=["x"]), *arguments, timeout=seconds
                )
            )
            loop = asyncio.get_running_loop()
            later(lambda: loop.call_soon_threadsafe(waiting.cancel))
            with contextlib.suppress(asyncio.CancelledError, AssertionError):
                await waiting

        asyncio.run(run())

    return door


def launch(make: Callable[[Any], Any]) -> Door:
    """Return the door of an action, which is executed by a launch."""

    def door(ends: Ends, seconds: Any, later: Later) -> None:
        service = LaunchService(argv=[], noninteractive=True)
        service.include_launch_description(LaunchDescription([make(seconds)]))
        later(service.shutdown)
        assert service.run() == 0

    return door


def process(**options: Any) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", ""], **options)


def retry(ends: Ends, seconds: Any, later: Later) -> None:
    """Retry at once: a test that fails for ever may wait for ever."""

    @retry_on_failure(times=1, delay=seconds)
    def test() -> None:
        """Pass."""

    test()


def look(ends: Ends, seconds: Any, later: Later) -> None:
    is_over = threading.Event()
    later(is_over.set)
    wait_for(is_over.is_set, seconds)


def look_each(ends: Ends, seconds: Any, later: Later) -> None:
    wait_for(lambda: True, None, seconds)


def lifecycle(function: Callable[..., Any], **what: Any) -> Door:
    def door(ends: Ends, seconds: Any, later: Later) -> None:
        function(node=ends.node, timeout=seconds, **what)

    return door


def throttle(ends: Ends, seconds: Any, later: Later) -> None:
    for _ in range(2):
        RcutilsLogger("throttled").info("text", throttle_duration_sec=seconds)


WAITS: dict[str, Door] = {
    "rclpy.spin_once timeout_sec": spin_by_function("spin_once"),
    "rclpy.spin_until_future_complete timeout_sec": spin_by_function("spin_until_future_complete"),
    "rclpy.executors.Executor.spin_once timeout_sec": spin("spin_once"),
    "rclpy.executors.Executor.spin_until_future_complete timeout_sec": spin("spin_until_future_complete"),
    "rclpy.executors.Executor.spin_once_until_future_complete timeout_sec": spin(
        "spin_once_until_future_complete"
    ),
    "rclpy.executors.Executor.wait_for_ready_callbacks timeout_sec": spin("wait_for_ready_callbacks"),
    "rclpy.executors.TimeoutObject timeout": spin("spin_once_until_future_complete", by="object"),
    "rclpy.executors.Executor.shutdown timeout_sec": shut_down(SingleThreadedExecutor),
    "rclpy.executors.MultiThreadedExecutor.shutdown timeout_sec": shut_down(MultiThreadedExecutor),
    "rclpy.client.Client.call timeout_sec": call,
    "rclpy.client.Client.wait_for_service timeout_sec": wait_for_service,
    "rclpy.action.client.ActionClient.wait_for_server timeout_sec": wait_for_server,
    "rclpy.parameter_client.AsyncParameterClient.wait_for_services timeout_sec": wait_for_parameter_services,
    "rclpy.node.Node.wait_for_node timeout": wait_for_a_node,
    "rclpy.wait_for_message.wait_for_message time_to_wait": wait_for_a_message,
    "rclpy.action.server.ActionServer result_timeout": lambda ends, seconds, _: ActionServer(
        ends.node, Fibonacci, "kept", lambda goal: Fibonacci.Result(), result_timeout=seconds
    ),
    "rclpy.utilities.timeout_sec_to_nsec timeout_sec": lambda _, seconds, __: timeout_sec_to_nsec(seconds),
    "rclpy.logging.RcutilsLogger.info throttle_duration_sec": throttle,
    "tf2_ros.buffer_client.BufferClient.wait_for_server timeout_sec": wait_for_buffer_server,
    "tf2_ros.buffer_client.BufferClient timeout_padding": lambda ends, seconds, _: BufferClient(
        ends.node, "buffer", timeout_padding=seconds
    ),
    "launch.actions.TimerAction period": launch(lambda seconds: TimerAction(period=seconds, actions=[])),
    "launch_ros.actions.ROSTimer period": launch(lambda seconds: ROSTimer(period=seconds, actions=[])),
    "launch.actions.ExecuteLocal respawn_delay": launch(
        lambda seconds: process(respawn=True, respawn_max_retries=1, respawn_delay=seconds)
    ),
    "launch_testing.actions.Test timeout": launch(
        lambda seconds: Test(cmd=[sys.executable, "-c", ""], timeout=seconds)
    ),
    "launch_testing.actions.GTest timeout": launch(
        lambda seconds: GTest(path=sys.executable, timeout=seconds)
    ),
    "launch_testing.actions.PyTest timeout": lambda _, seconds, __: PyTest(path="x", timeout=seconds),
    "launch_testing.ready_to_test_action_timeout timeout": lambda _, seconds, __: (
        ready_to_test_action_timeout(seconds)
    ),
    "launch_testing.markers.retry_on_failure delay": retry,
    "launch_testing.ActiveIoHandler.waitFor timeout": listen("waitFor"),
    "launch_testing.ActiveIoHandler.assertWaitFor timeout": listen("assertWaitFor"),
    "launch_testing.ActiveProcInfoHandler.assertWaitForShutdown timeout": see("assertWaitForShutdown"),
    "launch_testing.ActiveProcInfoHandler.assertWaitForStartup timeout": see("assertWaitForStartup"),
    "launch_testing.tools.ProcessProxy.wait_for_output timeout": ask_process("wait_for_output"),
    "launch_testing.tools.ProcessProxy.wait_for_shutdown timeout": ask_process("wait_for_shutdown"),
    "launch_testing_ros.WaitForTopics timeout": wait_for_topics,
    **{
        f"launch_pytest.tools.process.{name} timeout": await_process(name)
        for name in (
            "assert_output",
            "assert_stderr",
            "wait_for_output",
            "wait_for_stderr",
            "wait_for_start",
            "wait_for_exit",
        )
    },
    "ros2cli.helpers.wait_for timeout": look,
    "ros2cli.helpers.wait_for period": look_each,
    "ros2node.api.wait_for_node timeout": wait_for_a_listed_node,
    "ros2lifecycle.api.call_get_states timeout": lifecycle(call_get_states, node_names=[]),
    "ros2lifecycle.api.call_get_available_transitions timeout": lifecycle(
        call_get_available_transitions, states={}
    ),
    "ros2lifecycle.api.call_get_transition_graph timeout": lifecycle(call_get_transition_graph, states={}),
    "ros2lifecycle.api.call_change_states timeout": lifecycle(call_change_states, transitions={}),
}
"""The calls in which a program waits: seconds that 64 bits of nanoseconds don't hold are not a limit."""

PERIODS: dict[str, Door] = {
    "rclpy.node.Node.create_timer timer_period_sec": lambda ends, seconds, _: ends.node.create_timer(
        seconds, int
    ),
    "rclpy.node.Node.create_rate frequency": lambda ends, seconds, _: ends.node.create_rate(
        1.0 / float(seconds)
    ),
    "rclpy.timer.Timer timer_period_ns": lambda ends, seconds, _: Timer(
        None, None, float(seconds) * 1e9, Clock(), context=ends.context
    ),
}
"""The doors of what comes again and again: seconds that 64 bits of nanoseconds don't hold are a ValueError."""

VALUES: dict[str, Door] = {
    "rclpy.duration.Duration seconds": lambda _, seconds, __: Duration(seconds=seconds),
    "rclpy.duration.Duration nanoseconds": lambda _, seconds, __: Duration(nanoseconds=float(seconds) * 1e9),
    "rclpy.time.Time seconds": lambda _, seconds, __: Time(seconds=seconds),
    "rclpy.time.Time nanoseconds": lambda _, seconds, __: Time(nanoseconds=float(seconds) * 1e9),
}
"""The doors of what holds a time: seconds that 64 bits of nanoseconds don't hold are an OverflowError, as there."""

NO_SECONDS = {
    "launch.actions.ExecuteLocal sigterm_timeout": "a text, or substitutions",
    "launch.actions.ExecuteLocal sigkill_timeout": "as above",
    "tf2_ros.buffer_client.BufferClient check_frequency": "accepted, and not used",
    "ros2cli.node.daemon.spawn_daemon timeout": "as above",
    "ros2cli.node.daemon.shutdown_daemon timeout": "as above",
    "rclpy.publisher.Publisher.wait_for_all_acked timeout": "a Duration",
    "tf2_ros.MessageFilter buffer_timeout": "as above",
    **{
        f"tf2_ros.{name} timeout": "as above"
        for name in [
            *(
                f"Buffer.{query}{full}"
                for query in ("can_transform", "lookup_transform")
                for full in ("", "_full")
            ),
            *(
                f"Buffer.{query}{full}_async"
                for query in ("wait_for_transform", "lookup_transform")
                for full in ("", "_full")
            ),
            *(f"BufferClient.lookup_transform{full}" for full in ("", "_full")),
            *(
                f"BufferInterface.{query}{full}"
                for query in ("can_transform", "lookup_transform", "transform")
                for full in ("", "_full")
            ),
        ]
    },
}
"""The parameters of such names that take no seconds, and why."""

DOORS = WAITS | PERIODS | VALUES


def is_of_seconds(name: str) -> bool:
    return name in NAMES or "timeout" in name or name.endswith(("_sec", "_nsec"))


def parameters_of_seconds() -> Iterator[tuple[Any, str, str]]:
    """Yield the functions and classes that ROS's names give, and each of their parameters that take seconds."""
    packages = [
        name
        for _, name, _ in pkgutil.iter_modules([str(HOUSE)])
        if not name.endswith(("_msgs", "_interfaces"))
    ]
    for package in packages:
        for module in modules_of(package):
            for name, thing in list(vars(module).items()):
                if not getattr(thing, "__module__", "") or name.startswith("_"):
                    continue
                yield from of_callable(thing, f"{module.__name__}.{name}")
                if inspect.isclass(thing):
                    for method, function in inspect.getmembers(thing, callable):
                        if not method.startswith("_"):
                            yield from of_callable(function, f"{module.__name__}.{name}.{method}")


HOUSE = tfloom.__path__[0] + "/ros_names"


def modules_of(package: str) -> Iterator[Any]:
    try:
        module = importlib.import_module(package)
    except ImportError:  # an extra that isn't installed
        return
    yield module
    for _, name, _ in pkgutil.walk_packages(getattr(module, "__path__", []), f"{package}."):
        if not name.rpartition(".")[2].startswith("_"):
            try:
                yield importlib.import_module(name)
            except ImportError:
                continue


def of_callable(thing: Any, path: str) -> Iterator[tuple[Any, str, str]]:
    home = inspect.unwrap(thing) if not inspect.isclass(thing) else thing.__init__
    home = getattr(home, "__func__", home)
    if not hasattr(home, "__code__") or "/tfloom/" not in home.__code__.co_filename:
        return
    for name in inspect.signature(home).parameters:
        if is_of_seconds(name):
            yield home, path, name


def resolved(door: str) -> tuple[Any, str]:
    """Return the function that a door is, and the name of its parameter."""
    path, _, parameter = door.partition(" ")
    parts = path.split(".")
    for length in range(len(parts) - 1, 0, -1):
        try:
            thing: Any = importlib.import_module(".".join(parts[:length]))
        except ImportError:
            continue
        for part in parts[length:]:
            thing = getattr(thing, part)
        home = inspect.unwrap(thing) if not inspect.isclass(thing) else thing.__init__
        return getattr(home, "__func__", home), parameter
    raise LookupError(door)


@pytest.mark.filterwarnings("ignore::UserWarning", "ignore::DeprecationWarning")
def test_every_parameter_that_takes_seconds_is_known() -> None:
    known = {
        (home.__code__, name)
        for home, name in map(resolved, [*DOORS, *NO_SECONDS])
        if hasattr(home, "__code__")
    }
    unknown = {
        f"{path} {name}" for home, path, name in parameters_of_seconds() if (home.__code__, name) not in known
    }
    assert unknown == set()


def now(_: Callable[[], Any]) -> None:
    """End nothing, because the time does."""


@pytest.mark.parametrize("door", DOORS)
@pytest.mark.parametrize("seconds", [math.nan, np.float16("nan"), Decimal("nan")], ids=repr)
def test_nan_is_a_value_error_at_the_call(door: str, seconds: Any, ends: Ends) -> None:
    with pytest.raises(ValueError, match=r"."):
        DOORS[door](ends, seconds, now)


@pytest.mark.parametrize("door", DOORS)
@pytest.mark.parametrize(
    "seconds",
    [
        np.float16(0.015625),
        np.float32(0.015625),
        np.longdouble(0.015625),
        np.array(0.015625),
        Fraction(1, 64),
    ],
    ids=repr,
)
def test_numbers_of_each_class_are_seconds(door: str, seconds: Any, ends: Ends) -> None:
    DOORS[door](ends, seconds, now)


@pytest.mark.parametrize("door", WAITS)
@pytest.mark.parametrize(
    "seconds", [1e10, math.inf, 10**400, np.float64(1e300)], ids=lambda seconds: f"{seconds!r:.6}"
)
def test_seconds_beyond_64_bits_are_no_limit(door: str, seconds: Any, ends: Ends) -> None:
    threads: list[threading.Thread] = []

    def later(function: Callable[[], Any]) -> None:
        threads.append(threading.Timer(0.05, function))
        threads[-1].start()

    WAITS[door](ends, seconds, later)
    for thread in threads:
        thread.join()


@pytest.mark.parametrize(
    ("door", "error"),
    [*dict.fromkeys(PERIODS, ValueError).items(), *dict.fromkeys(VALUES, OverflowError).items()],
)
@pytest.mark.parametrize("seconds", [1e10, math.inf, np.float64(1e290), np.float32("inf")], ids=repr)
def test_seconds_beyond_64_bits_are_refused(
    door: str, error: type[Exception], seconds: Any, ends: Ends
) -> None:
    with pytest.raises(error):
        DOORS[door](ends, seconds, now)


@pytest.mark.parametrize(
    "number", [*map(np.dtype, np.typecodes["AllInteger"]), *map(np.dtype, "efdg")], ids=str
)
def test_five_seconds_of_each_class_are_five_seconds(number: np.dtype[Any], ends: Ends) -> None:
    seconds = number.type(5)
    timer = ends.node.create_timer(seconds, lambda: None)
    rate = ends.node.create_rate(number.type(2))
    assert Duration(seconds=seconds).nanoseconds == Time(seconds=seconds).nanoseconds == 5 * 10**9
    assert timer.timer_period_ns == timeout_sec_to_nsec(seconds) == 5 * 10**9
    assert rate.timer.timer_period_ns == 5 * 10**8
    assert Duration(nanoseconds=seconds).nanoseconds == Time(nanoseconds=seconds).nanoseconds == 5
    assert [type(Duration(seconds=seconds).nanoseconds), type(timer.timer_period_ns)] == [int, int]


def test_a_duration_of_a_message_with_a_number_of_numpy_is_whole() -> None:
    message = Duration(seconds=7, nanoseconds=5).to_msg()
    message.sec, message.nanosec = np.int32(7), np.uint32(5)
    assert Duration.from_msg(message).nanoseconds == 7_000_000_005
    message.sec = np.int32(-7)
    assert Duration.from_msg(message).nanoseconds == -6_999_999_995


@pytest.mark.parametrize(
    "wrong", [b"5", [5], (5,), {5: 5}, None, 1j, np.array([1.0, 2.0]), np.str_("5")], ids=repr
)
@pytest.mark.parametrize("kind", [Duration, Time])
def test_what_is_not_a_number_is_refused_at_once(kind: Callable[..., Any], wrong: Any) -> None:
    with pytest.raises((TypeError, ValueError)):
        kind(seconds=wrong)
