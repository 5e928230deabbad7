"""Each example's nodes on the in-process wire: they log what their docstrings state."""

from __future__ import annotations

import asyncio
import re
import threading
from collections.abc import Callable, Iterator
from types import ModuleType

import pytest

from tfloom.node import client_library as rclpy
from tfloom.node.executing.executors import MultiThreadedExecutor
from tfloom.node.log import log_output
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

Load = Callable[[str], ModuleType]
WaitUntil = Callable[..., None]


class Log:
    """Return the log so far."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self.capsys = capsys
        self.text = ""

    def has(self, *patterns: str) -> bool:
        self.text += self.capsys.readouterr().err
        return all(re.search(pattern, self.text) for pattern in patterns)


@pytest.fixture
def log(capsys: pytest.CaptureFixture[str]) -> Log:
    return Log(capsys)


@pytest.fixture(autouse=True)
def started(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    rclpy.init(args=[], signal_handler_options=rclpy.SignalHandlerOptions.NO)
    yield
    end()
    log_output.reset_levels()
    log_output.configure(file=None, console=True)


def end() -> None:
    """Shut the default context down, with all its nodes."""
    context = rclpy.get_default_context()
    rclpy.try_shutdown()
    context.destroy()


@pytest.fixture
def spin() -> Iterator[Callable[..., None]]:
    """Spin nodes on separate threads, until the test ends."""
    executors: list[MultiThreadedExecutor] = []
    threads: list[threading.Thread] = []
    errors: list[BaseException] = []

    def run(executor: MultiThreadedExecutor) -> None:
        try:
            executor.spin()
        except ExternalShutdownException:
            pass
        except BaseException as error:  # noqa: BLE001  # the test must know
            errors.append(error)

    def start(*nodes: rclpy.Node) -> None:
        executor = MultiThreadedExecutor(num_threads=4)
        executors.append(executor)
        for node in nodes:
            executor.add_node(node)
        threads.append(threading.Thread(target=run, args=(executor,)))
        threads[-1].start()

    yield start
    rclpy.get_default_context().try_shutdown()  # ends the calls that callbacks wait in
    for executor in executors:
        executor.shutdown(10.0)
    for thread in threads:
        thread.join(10.0)
        assert not thread.is_alive()
    assert errors == []


SCENES = {
    "topics": (
        ["topics/talker.py:Talker", "topics/listener.py:Listener"],
        [r"\[listener\]: I heard: Hello 2$"],
    ),
    "synchronized": (
        ["topics/synchronized.py:Weather", "topics/synchronized.py:Station"],
        [r"\[station\]: 22 °C at 101002 Pa$", r"\[station\]: 23 °C at 101003 Pa$"],
    ),
    "introspection": (
        ["services/introspection.py:WatchedAdder", "services/introspection.py:Watcher"],
        [
            r"\[watcher\]: request sent: 2 \+ 2$",
            r"\[watcher\]: request received: 2 \+ 2$",
            r"\[watcher\]: response sent: 4$",
            r"\[watcher\]: response received: 4$",
        ],
    ),
    "callback groups": (
        ["executors/callback_groups.py:SlowServer", "executors/callback_groups.py:Caller"],
        [r"\[caller\]: The answer: at last; [2-5] beats meanwhile$"],
    ),
    "coroutines": (
        [
            "services/add_server.py:AddServer",
            "executors/coroutines.py:Doubler",
            "executors/coroutines.py:Asker",
        ],
        [r"\[add_server\]: Asked for 2 \+ 1$", r"\[asker\]: 2 \* \(2 \+ 1\) = 6$"],
    ),
    "composition": (
        ["executors/composition.py:make_nodes"],
        [r"\[pipeline.first\]: 3 squared is 9$", r"\[pipeline.second\]: 9 squared is 81$"],
    ),
    "simulated time": (
        ["sim_time/clock.py:SimulationClock", "sim_time/simulated.py:Simulated"],
        [r"\[simulated\]: It is 10[1-9]\.\d s$", r"\[simulated\]: It is 11\d\.\d s$"],
    ),
    "transforms": (
        [
            "tf2/static_frame.py:StaticFrame",
            "tf2/moving_frame.py:MovingFrame",
            "tf2/where.py:Where",
            "tf2/time_travel.py:TimeTravel",
        ],
        [
            r"\[where\]: The laser is at -?[0-2]\.\d\d, -?[0-2]\.\d\d, 0\.50$",
            r"\[where\]: What it sees is at .*, 0\.50$",
            r"\[time_travel\]: In 0\.5 s it moved 0\.96 ahead, 0\.24 left, and turned 0\.50 rad$",
        ],
    ),
    "latched": (
        ["qos/latched.py:MapMaker", "qos/latched.py:Tourist"],
        [r"\[tourist\]: I have a map of the old town$"],
    ),
    "incompatible": (
        ["qos/incompatible.py:Radio", "qos/incompatible.py:Listeners"],
        [
            r"\[radio\]: Listeners: 1$",
            r"\[listeners\]: No news for the strict one: RELIABILITY doesn't fit$",
        ],
    ),
    "logs": (
        ["logs/levels.py:Chatterbox"],
        [
            r"\[WARN\] .*All may not be well$",
            r"\[FATAL\] .*All is lost$",
            r"\[DEBUG\] .*\[chatterbox\.detail\]: Seen",
            r"Only the first time: 1$",
            r"Not the first time: 2$",
            r"Each second: 1$",
            r"Each second: (9|1\d)$",
        ],
    ),
}


@pytest.mark.parametrize("scene", SCENES)
def test_examples_that_spin_log_their_lines(
    scene: str, load_example: Load, spin: Callable[..., None], log: Log, wait_until: WaitUntil
) -> None:
    makers, patterns = SCENES[scene]
    nodes: list[rclpy.Node] = []
    for maker in makers:
        path, name = maker.split(":")
        made = getattr(load_example(path), name)()
        nodes += made if isinstance(made, list) else [made]
    spin(*nodes)
    patterns = [f"(?m){pattern}" for pattern in patterns]
    wait_until(lambda: log.has(*patterns), what=f"{patterns}")
    absent = {
        "composition": "first\\]: 2 squared is 16",
        "logs": "Not seen|Only the first time: 2|Not the first time: 1$",
    }
    if scene in absent:
        assert not re.search(absent[scene], log.text, re.MULTILINE)


def test_example_waits_for_a_message(load_example: Load, spin: Callable[..., None], log: Log) -> None:
    waiter = rclpy.create_node("waiter")
    wait = load_example("topics/wait_once.py").wait
    assert not wait(waiter, 0.01)
    spin(load_example("topics/talker.py").Talker())
    assert wait(waiter)
    assert log.has(r"Nobody said anything for 0\.01 s", r"\[waiter\]: The next words: Hello \d")


def test_example_calls_a_service(load_example: Load, spin: Callable[..., None]) -> None:
    spin(load_example("services/add_server.py").AddServer())
    assert load_example("services/add_client.py").AddClient().ask(2, 3) == 5


def test_example_calls_a_service_while_a_thread_spins(load_example: Load, spin: Callable[..., None]) -> None:
    example = load_example("services/add_client_in_thread.py")
    node = rclpy.create_node("caller")
    client = node.create_client(load_example("services/add_server.py").AddTwoInts, "add_two_ints")
    spin(load_example("services/add_server.py").AddServer(), node)
    assert client.wait_for_service(10.0)
    assert example.add_up(node, client, [1, 2, 3, 4]) == 10


def test_example_calls_a_service_from_asyncio(
    load_example: Load, spin: Callable[..., None], log: Log
) -> None:
    example = load_example("services/add_client_in_asyncio.py")
    node = example.AddClientInAsyncio()
    spin(load_example("services/add_server.py").AddServer(), node)
    assert asyncio.run(example.work(node)) == 0
    assert log.has(r"\[add_client_in_asyncio\]: 3 \+ 4 = 7", r"\[add_client_in_asyncio\]: In all 21")


def test_example_sets_and_watches_parameters(
    load_example: Load, spin: Callable[..., None], log: Log, wait_until: WaitUntil
) -> None:
    spin(load_example("parameters/thruster.py").Thruster(), load_example("parameters/watch.py").Watch())
    assert load_example("parameters/tune.py").Tuner().tune()
    wait_until(lambda: log.has(r"\[watch\]: thrust became 7\.5", r"\[watch\]: thrust became 0\.5"))
    assert log.has(
        r"Its parameters: .*serial, side, .*thrust",
        r"thrust, in newton: 0\.0 to 10\.0",
        r"thrust = 7\.5: done",
        r"thrust = 70\.5: Parameter thrust out of range Min: 0\.0, Max: 10\.0",
        r"serial = 1: Trying to set a read-only parameter: serial",
        r"side = up: there is no side up",
        r"side = right: done",
        r"In the end: 0\.5, right",
        r"\[thruster\]: Now side is right",
    )


@pytest.mark.parametrize(
    ("parameters", "status", "last"),
    [
        (["order:=4"], 4, r"The goal succeeded: \[0, 1, 1, 2, 3, 5\]"),
        (["order:=30", "cancel_after:=2"], 5, r"The goal was canceled: \[0, 1, 1, 2(, \d+)*\]"),
        (["order:=-1"], 0, "The goal was rejected"),
    ],
)
def test_example_sends_a_goal(
    parameters: list[str], status: int, last: str, load_example: Load, spin: Callable[..., None], log: Log
) -> None:
    end()
    words = [word for parameter in parameters for word in ("-p", parameter)]
    rclpy.init(args=["--ros-args", *words], signal_handler_options=rclpy.SignalHandlerOptions.NO)
    spin(load_example("actions/fibonacci_server.py").FibonacciServer())
    assert load_example("actions/fibonacci_client.py").FibonacciClient().pursue() == status
    assert log.has(last)
    assert status != 4 or log.has(r"So far \[0, 1, 1\]")


def test_example_manages_a_lifecycle_node(load_example: Load, spin: Callable[..., None], log: Log) -> None:
    spin(load_example("lifecycle/sensor.py").Sensor())
    assert load_example("lifecycle/manager.py").Manager().drive()
    states = re.findall(r"\[manager\]: The sensor is (\w+)", log.text if log.has("finalized") else "")
    assert states == ["unconfigured", "inactive", "active", "inactive", "unconfigured", "finalized"]
    assert log.has(r"It measured \d+\.0", r"\[sensor\]: Deactivated after [1-9]\d* measurements")


def test_example_transforms_to_a_moving_frame(
    load_example: Load, spin: Callable[..., None], wait_until: WaitUntil
) -> None:
    node = load_example("tf2/fixed_frame.py").FixedFrame()
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    spin(node)

    def ahead_m() -> float | None:
        found = buffer.can_transform("base", "carrot", Time())
        return buffer.lookup_transform("base", "carrot", Time()).transform.translation.x if found else None

    wait_until(lambda: ahead_m() == 1.0)
    node.set_parameters([rclpy.Parameter("ahead", value=2.0)])
    wait_until(lambda: ahead_m() == 2.0)
    listener.unregister()
