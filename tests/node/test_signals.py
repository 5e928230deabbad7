"""Ctrl-C and SIGTERM in programs."""

from __future__ import annotations

import ast
import math
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from itertools import permutations
from pathlib import Path

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


FORKING = """
import os, sys
import rclpy, rclpy.executors, rclpy.node  # once for all
for case in CASES:
    child = os.fork()
    if not child:
        break
    print("exit code", os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
else:
    sys.exit()
"""


def printed_by_each(start_program: StartProgram, cases: list[object], code: str) -> list[str]:
    """Return the lines of a program that runs for each `case` in a separate process, and these exit codes."""
    return printed_by(start_program, f"CASES = {cases!r}\n{FORKING}{code}")


def printed_by(start_program: StartProgram, code: str, *options: str) -> list[str]:
    """Run a program, check that it exits with 0, and return its lines."""
    program = start_program("python", *options, "-c", code)
    assert program.wait(60) == 0, program.output
    return program.lines


@pytest.fixture(autouse=True)
def local(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


IN_POOL = """
executor = rclpy.executors.MultiThreadedExecutor(2)
executor.add_node(node)
rclpy.spin = lambda _: executor.spin()
"""


@pytest.mark.parametrize(
    ("code", "number", "ends"),
    [
        (PROGRAM + IN_POOL + IN_MAIN.removeprefix(PROGRAM), signal.SIGINT, ["KeyboardInterrupt not ok"]),
        (PROGRAM + IN_POOL + IN_MAIN.removeprefix(PROGRAM), signal.SIGTERM, ["returned"]),
        (
            PROGRAM + IN_POOL + IN_THREAD.removeprefix(PROGRAM),
            signal.SIGINT,
            ["main KeyboardInterrupt", "returned"],
        ),
        (IN_MAIN, signal.SIGINT, ["KeyboardInterrupt not ok"]),
        (IN_MAIN, signal.SIGTERM, ["ExternalShutdownException not ok"]),
        (IN_THREAD, signal.SIGINT, ["ExternalShutdownException not ok", "main KeyboardInterrupt"]),
        (IN_THREAD, signal.SIGTERM, ["ExternalShutdownException not ok"]),
    ],
    ids=[
        "Ctrl-C, several threads",
        "SIGTERM, several threads",
        "Ctrl-C, several threads, spin on another one",
        "Ctrl-C",
        "SIGTERM",
        "Ctrl-C, spin on another thread",
        "SIGTERM, spin on another thread",
    ],
)
def test_a_signal_ends_a_spin(start_program: StartProgram, code: str, number: int, ends: list[str]) -> None:
    program = start_program("python", "-c", code)
    program.wait_for("spinning")
    program.signal(number)
    assert program.wait() == 0, program.output
    *lines, last = (line for line in program.lines if line != "spinning")
    assert (sorted(lines), last) == (ends, "end")


PUBLISHING = """
import os, random, signal, sys, threading, time
import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.experimental import EventsExecutor
from std_msgs.msg import String

sys.setswitchinterval(1e-5)  # else the thread that strikes would wait until the other one does
source = random.Random(7)
kinds = {"single": SingleThreadedExecutor, "multi": MultiThreadedExecutor, "events": EventsExecutor}
endings = set()

def strike(begun, number):
    begun.wait()
    time.sleep(source.random() * 0.005)
    os.kill(os.getpid(), number)

for kind, number in 15 * [(kind, number) for kind in kinds for number in (signal.SIGINT, signal.SIGTERM)]:
    rclpy.init()
    node = rclpy.create_node("publisher")
    publisher = node.create_publisher(String, "chatter", 10)
    begun = threading.Event()

    def work():
        begun.set()
        for _ in range(20):
            publisher.publish(String(data="hello"))

    node.create_timer(0.001, work)
    executor = kinds[kind]()
    executor.add_node(node)
    threading.Thread(target=strike, args=(begun, number)).start()
    try:
        executor.spin()
        endings.add((kind, number.name, "returned"))
    except BaseException as error:
        endings.add((kind, number.name, type(error).__name__))
    executor.shutdown()
    node.destroy_node()
    rclpy.try_shutdown()
print(sorted(endings))
"""


ENTERING = """
import signal, threading, time
import rclpy

rclpy.init()
lock = threading.Lock()
is_running = True
is_caught = threading.Event()

def strike():
    is_caught.wait()
    while is_running:
        time.sleep(0.0003)
        signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)

threading.Thread(target=strike, daemon=True).start()
interrupted = 0
end = time.monotonic() + 20.0
while interrupted < 30 and time.monotonic() < end:
    try:
        is_caught.set()
        rclpy.try_shutdown()
        rclpy.init()
        while True:
            with lock:
                pass
    except KeyboardInterrupt:
        interrupted += 1
    if lock.locked():
        break
is_running = False
print("kept" if lock.locked() else "free", interrupted > 0)
"""


def test_interrupted_program_keeps_no_lock(start_program: StartProgram) -> None:
    """Python 3.14 and later may run a handler between a lock's `__enter__` and the block of the `with`."""
    assert printed_by(start_program, ENTERING) == ["free True"]


def test_signal_during_publishing_is_reported_as_a_signal(start_program: StartProgram) -> None:
    (line,) = printed_by(start_program, PUBLISHING)
    assert set(ast.literal_eval(line)) == {
        ("single", "SIGTERM", "ExternalShutdownException"),
        ("multi", "SIGTERM", "returned"),
        ("events", "SIGTERM", "ExternalShutdownException"),
        *((kind, "SIGINT", "KeyboardInterrupt") for kind in ("single", "multi", "events")),
    }


DESTROYING = """
import signal, time, weakref

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

how, then = case
rclpy.init()
node = rclpy.create_node("early")
executor = rclpy.get_global_executor()
executor.add_node(node)
thing = Method() if how == "method" else Plain()
if how == "weakref":
    weakref.finalize(thing, strike)
try:
    del thing
    {"create_node": lambda: rclpy.create_node("late"), "spin": executor.spin, "sleep": lambda: time.sleep(60)}[then]()
except (KeyboardInterrupt, rclpy.exceptions.NotInitializedException) as error:
    print(type(error).__name__)
"""


def test_ctrl_c_during_a_destructor_ends_the_program_without_error_text(start_program: StartProgram) -> None:
    cases = [(how, then) for how in ("method", "weakref") for then in ("create_node", "spin", "sleep")]
    lines = printed_by_each(start_program, cases, DESTROYING)
    ends = lines[1::3]
    assert lines == [line for end in ends for line in ("struck", end, "exit code 0")]
    for (_, then), end in zip(cases, ends, strict=True):
        assert end == "KeyboardInterrupt" or (then, end) == ("create_node", "StoppedException")


def test_ctrl_c_during_an_import_is_raised_after_it(start_program: StartProgram, tmp_path: Path) -> None:
    """A module in C may replace the exception by an ImportError, as numpy's do."""
    (tmp_path / "slow_module.py").write_text(
        "import os, signal\nos.kill(os.getpid(), signal.SIGINT)\nfor _ in range(1000): pass\nwhole = True\n"
    )
    code = f"""
import sys, time
import rclpy
sys.path.insert(0, {str(tmp_path)!r})
rclpy.init()
try:
    import slow_module
    time.sleep(60)
except KeyboardInterrupt:
    print(sys.modules["slow_module"].whole)
"""
    assert printed_by(start_program, code) == ["True"]


def test_ctrl_c_is_raised_in_an_import_that_takes_long(start_program: StartProgram, tmp_path: Path) -> None:
    (tmp_path / "endless_module.py").write_text(
        "import os, signal, time\nos.kill(os.getpid(), signal.SIGINT)\ntime.sleep(60)\n"
    )
    code = f"""
import sys
import rclpy
sys.path.insert(0, {str(tmp_path)!r})
rclpy.init()
try:
    import endless_module
except KeyboardInterrupt:
    print("interrupted")
"""
    assert printed_by(start_program, code) == ["interrupted"]


def test_ctrl_c_while_asyncio_builds_its_loop_prints_nothing(start_program: StartProgram) -> None:
    code = """
import asyncio, os, signal
import rclpy

class Loop(asyncio.SelectorEventLoop):
    def __init__(self):
        os.kill(os.getpid(), signal.SIGINT)
        for _ in range(1000):
            pass
        super().__init__()

class Policy(asyncio.DefaultEventLoopPolicy):
    _loop_factory = Loop

asyncio.set_event_loop_policy(Policy())
rclpy.init()
try:
    asyncio.run(asyncio.sleep(60))
except KeyboardInterrupt:
    print("interrupted")
"""
    assert printed_by(start_program, code, "-W", "ignore") == ["interrupted"]


STRIKING_TWICE = """
import atexit, signal
from rclpy.executors import ExternalShutdownException

when, first, second = case

def strike():
    return os.kill(os.getpid(), second), [None for _ in range(1000)]

class Late:
    def __del__(self):
        strike() if when == "after the interpreter's exit hooks" else None

late = Late()
if when == "at exit":
    atexit.register(strike)
rclpy.init()
node = rclpy.create_node("ending")
node.create_timer(0.01, lambda: os.kill(os.getpid(), first))
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
rclpy.shutdown() if rclpy.ok() else rclpy.try_shutdown()
try:
    rclpy.shutdown()
except Exception:
    pass  # it was shut down by the signal; the handlers are restored nevertheless
if when == "after shutdown":
    strike()
print("ended")
raise SystemExit(3)
"""


def test_second_signal_right_after_the_first_keeps_the_exit_code(start_program: StartProgram) -> None:
    cases = [
        (when, int(first), int(second))
        for when in ("after shutdown", "at exit", "after the interpreter's exit hooks")
        for first, second in permutations((signal.SIGINT, signal.SIGTERM))
    ]
    assert printed_by_each(start_program, cases, STRIKING_TWICE) == 6 * ["ended", "exit code 3"]


STRIKING_LATE = """
import signal, time
from tfloom.node.executing import signals
signals.ECHO_S = 0.0
rclpy.init()
os.kill(os.getpid(), signal.SIGTERM)
while rclpy.ok():
    pass
try:
    rclpy.shutdown()
except Exception:
    pass
print("shut down", flush=True)
sys.stderr = None  # of the traceback of Ctrl-C
os.kill(os.getpid(), case)
time.sleep(60)
"""


def test_signal_long_after_the_one_that_shut_down_ends_the_program(start_program: StartProgram) -> None:
    numbers = [int(signal.SIGINT), int(signal.SIGTERM)]
    lines = printed_by_each(start_program, numbers, STRIKING_LATE)
    assert lines == [line for number in numbers for line in ("shut down", f"exit code {-number}")]


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


def test_a_daemon_thread_that_spins_ends_with_the_program(start_program: StartProgram) -> None:
    code = """
import threading
rclpy.init()
node = rclpy.create_node("left_behind")
publisher = node.create_publisher(__import__("std_msgs.msg", fromlist=["*"]).String, "chatter", 10)
node.create_timer(case, lambda: publisher.publish(publisher.msg_type()))
begun = threading.Event()
rclpy.get_global_executor().create_task(begun.set)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
begun.wait()
print("end")
"""
    busy_s, idle_s = 0.0001, 100.0
    assert printed_by_each(start_program, [busy_s, idle_s], code) == 2 * ["end", "exit code 0"]


@pytest.mark.timing
@pytest.mark.skipif(sys.platform == "win32", reason="process times are read as Linux and macOS have them")
def test_idle_node_uses_no_cpu_time(start_program: StartProgram) -> None:
    code = """
import time, rclpy
rclpy.init()
node = rclpy.create_node("idle")
for _ in range(6):
    begin = time.process_time()
    rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=0.5)
    print("used", time.process_time() - begin)
"""
    lines = printed_by(start_program, code)
    # The first turns discover; the least is not slowed down by what else the machine does.
    assert min(float(line.split()[1]) for line in lines) < 0.01


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
        rclpy.uninstall_signal_handlers()
