"""Ctrl-C and SIGTERM in programs."""

from __future__ import annotations

import ast
import math
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress

import pytest
from tests.conftest import Program

from tfloom.node.executing.signals import (
    SignalHandlerGuardCondition,
    SignalHandlerOptions,
    install_signal_handlers,
    uninstall_signal_handlers,
)

StartProgram = Callable[..., Program]

PROGRAM = """
import sys, threading, time
import rclpy
from rclpy.executors import ExternalShutdownException

def say(text):
    sys.stdout.write(text + "\\n")
    sys.stdout.flush()

rclpy.init()
node = rclpy.create_node("spinner")
node.create_timer(0.01, lambda: say("spinning"))

def spin():
    try:
        rclpy.spin(node)
        say("returned")
    except BaseException as error:
        say(type(error).__name__ + (" ok" if rclpy.ok() else " not ok"))
"""
IN_MAIN = PROGRAM + "spin()\nnode.destroy_node()\nrclpy.try_shutdown()\nprint('end')\n"
IN_THREAD = (
    PROGRAM
    + """
ended = threading.Event()  # until Python 3.13, a join that Ctrl-C broke off can't be taken up again
try:
    threading.Thread(target=lambda: (spin(), ended.set())).start()
    ended.wait()
except KeyboardInterrupt:
    say("main KeyboardInterrupt")
    ended.wait()
node.destroy_node()
rclpy.try_shutdown()
print("end")
"""
)


def run(start_program: StartProgram, code: str, number: int) -> list[str]:
    program = start_program("python", "-c", code)
    program.wait_for("spinning")
    program.signal(number)
    assert program.wait() == 0, program.output
    return [line for line in program.lines if line != "spinning"]


@pytest.fixture(autouse=True)
def local(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


def test_ctrl_c_raises_keyboard_interrupt(start_program: StartProgram) -> None:
    assert run(start_program, IN_MAIN, signal.SIGINT) == ["KeyboardInterrupt not ok", "end"]


def test_sigterm_raises_external_shutdown(start_program: StartProgram) -> None:
    assert run(start_program, IN_MAIN, signal.SIGTERM) == ["ExternalShutdownException not ok", "end"]


def test_ctrl_c_ends_a_spin_on_another_thread(start_program: StartProgram) -> None:
    lines = run(start_program, IN_THREAD, signal.SIGINT)
    assert sorted(lines[:2]) == ["ExternalShutdownException not ok", "main KeyboardInterrupt"]
    assert lines[2:] == ["end"]


def test_sigterm_ends_a_spin_on_another_thread(start_program: StartProgram) -> None:
    assert run(start_program, IN_THREAD, signal.SIGTERM) == ["ExternalShutdownException not ok", "end"]


PUBLISHING = """
import os, random, sys, threading, time
from collections import Counter
import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.experimental import EventsExecutor
from std_msgs.msg import String

number, kind, times = int(sys.argv[1]), sys.argv[2], int(sys.argv[3])
sys.setswitchinterval(1e-5)  # else the thread that strikes would wait until the other one does
source = random.Random(7)
endings = Counter()

def strike(begun):
    begun.wait()
    time.sleep(source.random() * 0.005)
    os.kill(os.getpid(), number)

for _ in range(times):
    rclpy.init()
    node = rclpy.create_node("publisher")
    publisher = node.create_publisher(String, "chatter", 10)
    begun = threading.Event()

    def work():
        begun.set()
        for _ in range(20):
            publisher.publish(String(data="hello"))

    node.create_timer(0.001, work)
    kinds = {"single": SingleThreadedExecutor, "multi": MultiThreadedExecutor, "events": EventsExecutor}
    executor = kinds[kind]()
    executor.add_node(node)
    threading.Thread(target=strike, args=(begun,)).start()
    try:
        executor.spin()
        endings["returned"] += 1
    except BaseException as error:
        endings[type(error).__name__] += 1
    executor.shutdown()
    node.destroy_node()
    rclpy.try_shutdown()
print(sorted(endings))
"""


@pytest.mark.parametrize("kind", ["single", "multi", "events"])
@pytest.mark.parametrize(
    ("number", "expected"),
    [
        (signal.SIGTERM, {"ExternalShutdownException"}),
        (signal.SIGINT, {"KeyboardInterrupt", "ExternalShutdownException"}),  # the other during a deletion
    ],
)
def test_signal_during_publishing_is_reported_as_a_signal(
    number: int, expected: set[str], kind: str, start_program: StartProgram
) -> None:
    program = start_program("python", "-c", PUBLISHING, str(int(number)), kind, "100")
    assert program.wait(60) == 0, program.output
    (line,) = program.lines
    assert set(ast.literal_eval(line)) <= expected


@pytest.mark.parametrize("how", ["method", "weakref"])
def test_ctrl_c_during_a_destructor_ends_the_program_without_error_text(
    how: str, start_program: StartProgram
) -> None:
    code = f"""
import os, signal, weakref, time
import rclpy

def strike():
    os.kill(os.getpid(), signal.SIGINT)
    for _ in range(1000):
        pass
    print("struck", flush=True)

class Method:
    def __del__(self):
        strike()

class Plain:
    pass

rclpy.init()
thing = Method() if "{how}" == "method" else Plain()
if "{how}" == "weakref":
    weakref.finalize(thing, strike)
del thing
try:
    rclpy.spin_once(rclpy.create_node("late"))
except rclpy.exceptions.NotInitializedException:
    print("ended")
"""
    program = start_program("python", "-c", code)
    assert program.wait() == 0
    assert program.lines == ["struck", "ended"]


def test_former_handlers_are_restored() -> None:
    from tfloom.node import client_library as rclpy
    from tfloom.node.executing.signals import get_current_signal_handlers_options

    mine: list[int] = []
    before = signal.signal(signal.SIGTERM, lambda number, frame: mine.append(number))
    try:
        inner = signal.getsignal(signal.SIGTERM)
        rclpy.init(args=[])
        assert get_current_signal_handlers_options() is rclpy.SignalHandlerOptions.ALL
        signal.raise_signal(signal.SIGTERM)
        assert mine == [signal.SIGTERM]
        assert not rclpy.ok()
        rclpy.try_shutdown()
        rclpy.uninstall_signal_handlers()
        assert signal.getsignal(signal.SIGTERM) is inner
        rclpy.init(args=[], signal_handler_options=rclpy.SignalHandlerOptions.NO)
        assert signal.getsignal(signal.SIGTERM) is inner
        rclpy.shutdown()
    finally:
        signal.signal(signal.SIGTERM, before)


def test_init_works_on_another_thread() -> None:
    import threading

    from tfloom.node import client_library as rclpy

    errors: list[BaseException] = []

    def life() -> None:
        try:
            rclpy.init(args=[])
            rclpy.create_node("elsewhere").destroy_node()
            rclpy.shutdown()
        except BaseException as error:  # noqa: BLE001
            errors.append(error)

    thread = threading.Thread(target=life)
    thread.start()
    thread.join(10)
    assert not errors


@pytest.mark.parametrize("period_s", [0.0001, 100.0], ids=["busy", "idle"])
def test_a_daemon_thread_that_spins_ends_with_the_program(
    period_s: float, start_program: StartProgram
) -> None:
    code = f"""
import threading, rclpy
rclpy.init()
node = rclpy.create_node("left_behind")
publisher = node.create_publisher(__import__("std_msgs.msg", fromlist=["*"]).String, "chatter", 10)
node.create_timer({period_s}, lambda: publisher.publish(publisher.msg_type()))
begun = threading.Event()
rclpy.get_global_executor().create_task(begun.set)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
begun.wait()
print("end")
"""
    program = start_program("python", "-c", code)
    assert program.wait() == 0
    assert program.lines == ["end"]


@pytest.mark.timing
@pytest.mark.skipif(sys.platform == "win32", reason="process times are read as Linux and macOS have them")
def test_idle_node_uses_no_cpu_time(start_program: StartProgram) -> None:
    code = """
import time, rclpy
rclpy.init()
node = rclpy.create_node("idle")
begin = time.process_time()
rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=1.0)
print("used", time.process_time() - begin)
"""
    program = start_program("python", "-c", code)
    assert program.wait() == 0
    assert float(program.lines[-1].split()[1]) < 0.02


def test_second_ctrl_c_does_not_interrupt_the_shutdown(start_program: StartProgram) -> None:
    slow_end = PROGRAM + (
        "rclpy.get_default_context().on_shutdown(lambda: (say('ending'), sys.stdin.readline(), say('ended')))\n"
    )
    program = start_program("python", "-c", slow_end, stdin=subprocess.PIPE)
    program.wait_for("ending")
    program.signal(signal.SIGINT)
    program.process.stdin.write("\n")
    program.process.stdin.flush()
    assert program.wait() == 0, program.output
    assert program.lines == ["ending", "ended"]


def test_signal_triggers_signal_guard_conditions(monkeypatch: pytest.MonkeyPatch) -> None:
    # Soon after an earlier test's signal, this one would be ignored as a repetition.
    monkeypatch.setattr("tfloom.node.executing.signals._interrupted_at", -math.inf)
    ended = SignalHandlerGuardCondition()
    ended.destroy()
    guard = SignalHandlerGuardCondition()
    with suppress(KeyboardInterrupt):
        install_signal_handlers(SignalHandlerOptions.SIGINT)
        try:
            signal.raise_signal(signal.SIGINT)
        finally:
            uninstall_signal_handlers()
    assert guard.becomes_ready()
    assert not ended.becomes_ready()
    guard.destroy()


def test_no_interrupt_is_raised_during_submission_to_a_pool() -> None:
    from concurrent.futures import thread

    from tfloom.node import client_library as rclpy
    from tfloom.node.executing.executors import MultiThreadedExecutor

    rclpy.init(args=[])
    try:
        MultiThreadedExecutor(2)
        amid_submit = compile("signal.raise_signal(signal.SIGINT)", thread.__file__, "exec")
        exec(amid_submit, {"signal": signal})
        assert not rclpy.ok()
        rclpy.try_shutdown()
        rclpy.init(args=[])
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    finally:
        rclpy.try_shutdown()
