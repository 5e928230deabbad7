"""Contexts: initialisation, shutdown, signals, and their nodes."""

from __future__ import annotations

import gc
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress

import pytest

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node import client_library as rclpy
from tfloom.node.context.arguments import RCLInvalidROSArgsError
from tfloom.node.context.context import Context, live_contexts
from tfloom.node.context.utilities import own_defaults
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.signals import SignalHandlerOptions, get_current_signal_handlers_options
from tfloom.node.log.logging import get_logger_effective_level
from tfloom.node.node import Node
from tfloom.node.parameters.exceptions import InvalidParameterTypeException
from tfloom.node.values.exceptions import ExternalShutdownException, NotInitializedException, RCLError


def test_context_is_initialised_and_shut_down_once(context: Context) -> None:
    assert context.ok()
    with pytest.raises(RuntimeError, match="only be called once"):
        context.init([])
    context.shutdown()
    assert not context.ok()
    with pytest.raises(RCLError, match="already called"):
        context.shutdown()
    assert not context.try_shutdown()
    with pytest.raises(RuntimeError, match="must be initialized before"):
        Context().shutdown()


def test_shutdown_calls_the_callbacks(context: Context) -> None:
    called: list[str] = []

    class Listener:
        def gone(self) -> None:
            called.append("gone")

        def there(self) -> None:
            called.append("there")

    listener = Listener()
    context.on_shutdown(listener.there)
    context.on_shutdown(Listener().gone)
    context.on_shutdown(lambda: called.append("function"))
    context.shutdown()
    assert called == ["there", "function"]
    context.on_shutdown(lambda: called.append("late"))
    assert called[-1] == "late"
    with pytest.raises(TypeError, match="callable"):
        context.on_shutdown(5)  # type: ignore[arg-type]


def test_default_context_is_replaced_after_shutdown() -> None:
    for _ in range(3):
        rclpy.init(args=[])
        assert rclpy.ok()
        rclpy.create_node("again").destroy_node()
        rclpy.shutdown()
        assert not rclpy.ok()
    with pytest.raises(RuntimeError, match="must be initialized before"):
        rclpy.shutdown()
    rclpy.try_shutdown()


def test_threads_with_own_defaults_share_none(wait_until: Callable[..., None]) -> None:
    process = rclpy.get_default_context(), rclpy.get_global_executor()
    both_run = threading.Barrier(2, timeout=20.0)
    contexts = {name: Context() for name in ("one", "two")}
    names: dict[str, str] = {}
    ended: list[str] = []

    def run(name: str) -> None:
        with own_defaults(contexts[name]):
            rclpy.init(args=["--ros-args", "-r", f"__node:={name}"])
            node = rclpy.create_node("as_given")
            names[name] = node.get_name()
            executor = rclpy.get_global_executor()
            assert executor.context is node.context is contexts[name]
            both_run.wait()
            with suppress(ExternalShutdownException):
                rclpy.spin(node)
            assert rclpy.get_global_executor() is not process[1]
            ended.append(name)
            contexts[name].destroy()
        assert rclpy.get_default_context() is process[0]

    with ThreadPoolExecutor(2) as pool:
        one, two = (pool.submit(run, name) for name in contexts)
        wait_until(lambda: len(names) == 2 or one.done() or two.done())
        contexts["one"].interrupt()
        one.result(20.0)
        assert ended == ["one"]
        assert contexts["two"].ok()
        contexts["two"].interrupt()
        two.result(20.0)
    assert names == {"one": "one", "two": "two"}
    assert (rclpy.get_default_context(), rclpy.get_global_executor()) == process


def test_arguments_default_to_those_of_the_program(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.argv", ["prog", "--ros-args", "--log-level", "warn", "-r", "__node:=given"])
    with Context() as context, Node("own", context=context) as node:
        assert node.get_name() == "given"
        assert get_logger_effective_level("given").name == "WARN"


def test_invalid_arguments_leave_the_context_uninitialised() -> None:
    context = Context()
    with pytest.raises(RCLInvalidROSArgsError):
        context.init(["--ros-args", "-p", "x"])
    assert not context.ok()
    context.init([])
    context.destroy()


def test_domain_comes_from_the_environment_or_the_argument(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "17")
    one, two = Context(), Context()
    one.init([])
    two.init([], domain_id=18)
    assert (one.get_domain_id(), two.get_domain_id()) == (17, 18)
    with Node("a", context=one) as a, Node("b", context=two) as b:
        assert (a.get_node_names(), b.get_node_names()) == (["a"], ["b"])
    with pytest.raises(RuntimeError, match="lower than zero"):
        Context().init([], domain_id=-1)
    one.destroy()
    two.destroy()


def test_participant_closes_with_the_last_node_after_shutdown(
    context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    node = Node("last", context=context)
    watching = Context()
    watching.init([])
    with Node("watcher", context=watching) as watcher:
        context.shutdown()
        assert watcher.get_node_names() == ["last", "watcher"]
        node.destroy_node()
        assert watcher.get_node_names() == ["watcher"]
    watching.destroy()


def test_init_is_a_context_manager() -> None:
    before = signal.getsignal(signal.SIGTERM)
    with rclpy.init(args=["prog"]) as begun:
        assert rclpy.ok()
        assert begun.context is rclpy.get_default_context()
        assert signal.getsignal(signal.SIGTERM) is not before
    assert not rclpy.ok()
    assert signal.getsignal(signal.SIGTERM) is before
    other = Context()
    with suppress(KeyError), rclpy.init(args=[], context=other):
        assert other.ok()
        raise KeyError
    assert not other.ok()
    with rclpy.init(args=[]):
        rclpy.shutdown()
    other.destroy()


@pytest.mark.parametrize("options", [SignalHandlerOptions(number) for number in range(4)])
def test_init_handles_the_selected_signals(options: SignalHandlerOptions) -> None:
    with rclpy.init(args=[], signal_handler_options=options):
        assert get_current_signal_handlers_options() == options
    assert get_current_signal_handlers_options() == SignalHandlerOptions.NO


def test_other_contexts_handle_no_signals_by_default() -> None:
    before = signal.getsignal(signal.SIGINT)
    with rclpy.init(args=[], context=Context()):
        assert signal.getsignal(signal.SIGINT) is before


def test_spin_functions_run_callbacks() -> None:
    rclpy.init(args=[])
    node = rclpy.create_node("spun")
    ticks: list[int] = []
    node.create_timer(0.001, lambda: ticks.append(1))
    rclpy.spin_once(node, timeout_sec=1.0)
    assert ticks == [1]
    assert node not in rclpy.get_global_executor().get_nodes()
    future: rclpy.Future[int] = rclpy.Future()
    node.create_timer(0.001, lambda: future.set_result(1) if not future.done() else None)
    rclpy.spin_until_future_complete(node, future, timeout_sec=10)
    assert future.done()
    node.create_timer(0.001, rclpy.try_shutdown)
    rclpy.spin(node)
    assert not rclpy.ok()
    node.destroy_node()


def test_init_succeeds_after_ctrl_c() -> None:
    """As in a notebook, where shutdown isn't called after Ctrl-C."""
    rclpy.init(args=[])
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
    assert not rclpy.ok()
    rclpy.init(args=[])
    assert rclpy.ok()
    with pytest.raises(RuntimeError, match="only be called once"):
        rclpy.init(args=[])
    rclpy.shutdown()


def test_unreferenced_node_leaves_the_graph(context: Context) -> None:
    """As in a notebook, where a cell that creates a node is run again."""

    class Talker(Node):
        def __init__(self, fail: bool = False) -> None:
            super().__init__("talker", context=context)
            self.publisher = self.create_publisher(String, "chatter", 10)
            self.timer = self.create_timer(1.0, self.on_timer)
            if fail:
                raise ValueError("half made")

        def on_timer(self) -> None:
            pass

    with Node("watcher", context=context) as watcher, SingleThreadedExecutor(context=context) as executor:
        node = Talker()
        node = Talker()
        executor.add_node(node)
        with suppress(ValueError):
            Talker(fail=True)
        del node
        held = Node("held", context=context).create_publisher(String, "chatter", 10)
        gc.collect()
        Node("other", context=context)
        gc.collect()
        Node("another", context=context)
        names = sorted(watcher.get_node_names())
        assert names == ["another", "held", "talker", "watcher"]
        assert watcher.count_publishers("chatter") == 2
        held.publish(String(data="still there"))
        del held
        gc.collect()
        context.shutdown()
        assert sorted(watcher.get_node_names()) == ["talker", "watcher"]


def test_failed_node_creation_leaves_nothing_on_the_graph(context: Context) -> None:
    with Node("watcher", context=context) as watcher:
        with pytest.raises(InvalidParameterTypeException):
            Node("bad", context=context, cli_args=["--ros-args", "-p", "use_sim_time:=5"])
        assert watcher.get_node_names() == ["watcher"]


def test_node_creation_after_a_signal_raises_external_shutdown(context: Context) -> None:
    context.interrupt()
    with pytest.raises(ExternalShutdownException, match="a signal has shut the context down") as caught:
        Node("late", context=context)
    assert isinstance(caught.value, NotInitializedException)


def test_missing_init_raises_the_text_of_the_reference(context: Context) -> None:
    with pytest.raises(NotInitializedException) as caught:
        Node("early", context=Context())
    assert str(caught.value) == "rclpy.init() has not been called. msg:cannot create node"
    assert str(NotInitializedException()) == "rclpy.init() has not been called."
    with pytest.raises(RuntimeError, match=r"^Context must be initialized before it can be shutdown$"):
        Context().shutdown()


def test_handler_lists_contexts_while_other_threads_make_them() -> None:
    kept: list[Context] = []
    is_over = threading.Event()

    def make() -> None:
        while not is_over.is_set():
            context = Context()
            context.init(args=[], initialize_logging=False)
            kept.append(context)
            if len(kept) % 100 == 0:
                kept.clear()  # contexts leave as they come

    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    threads = [threading.Thread(target=make) for _ in range(2)]
    try:
        for thread in threads:
            thread.start()
        for _ in range(2000):
            live_contexts()
    finally:
        is_over.set()
        for thread in threads:
            thread.join()
        sys.setswitchinterval(before)
    kept.clear()
