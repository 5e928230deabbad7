"""Each example as a user runs it: processes over DDS on loopback, with a clean end of each."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.spun import SpunNode, spun

EXAMPLES = Path(__file__).parents[2] / "examples"

# Programs that run until a signal, and the last output of each.
SPINNING: dict[str, dict[str, list[str]]] = {
    "topics": {
        "topics/talker.py": [r"\[talker\]: I say: Hello 2$"],
        "topics/listener.py": [r"\[listener\]: I heard: Hello \d+$"],
    },
    "synchronized": {"topics/synchronized.py": [r"\[station\]: 2\d °C at 10100\d Pa$"]},
    "introspection": {
        "services/introspection.py": [
            r"\[watcher\]: request sent: \d \+ \d$",
            r"\[watcher\]: request received: \d \+ \d$",
            r"\[watcher\]: response sent: \d$",
            r"\[watcher\]: response received: \d$",
        ]
    },
    "callback groups": {
        "executors/callback_groups.py": [r"\[caller\]: The answer: at last; [1-6] beats meanwhile$"]
    },
    "coroutines": {
        "services/add_server.py": [r"\[add_server\]: Asked for \d \+ 1$"],
        "executors/coroutines.py": [r"A task greets you$", r"\[asker\]: 2 \* \((\d) \+ 1\) = \d+$"],
    },
    "composition": {"executors/composition.py": [r"\[pipeline.second\]: 9 squared is 81$"]},
    "simulated time": {
        "sim_time/clock.py": [],
        "sim_time/simulated.py": [r"\[simulated\]: It is 1\d\d\.\d s$"],
    },
    "transforms": {
        "tf2/static_frame.py": [r"The laser is on its base$"],
        "tf2/moving_frame.py": [],
        "tf2/fixed_frame.py": [],
        "tf2/where.py": [r"The laser is at -?[0-2]\.\d\d, -?[0-2]\.\d\d, 0\.50$"],
        "tf2/time_travel.py": [r"it moved 0\.9\d ahead, 0\.2\d left, and turned 0\.(49|50|51) rad$"],
    },
    "deadline": {
        "qos/deadline.py": [
            r"\[promiser\]: I promised more: [1-9]\d* missed$",
            r"\[waiter\]: I was promised more: [1-9]\d* missed$",
            r"\[waiter\]: I got Message 1\d$",
        ]
    },
    "latched": {"qos/latched.py": [r"\[tourist\]: I have a map of the old town$"]},
    "incompatible": {
        "qos/incompatible.py": [
            r"\[radio\]: Listeners: 1$",
            r"No news for the strict one: RELIABILITY doesn't fit$",
        ]
    },
    "overridden": {
        "qos/overrides.py": [
            r"/frames\.publisher\.depth = 10$",
            r"/frames\.publisher\.reliability = reliable$",
            r"\[camera\]: Seen a frame$",
        ]
    },
    "logs": {"logs/levels.py": [r"Only the first time: 1$", r"Each second: (9|1\d)$"]},
}

# Programs that run until a signal, and those that end by themselves beside them, with their output.
ENDING: dict[str, tuple[list[str], dict[str, list[str]]]] = {
    "wait once": (["topics/talker.py"], {"topics/wait_once.py": [r"The next words: Hello \d+$"]}),
    "calls": (
        ["services/add_server.py"],
        {
            "services/add_client.py": [r"2 \+ 3 = 5$"],
            "services/add_client_in_asyncio.py": [r"3 \+ 4 = 7$", r"In all 21$"],
            "services/add_client_in_thread.py": [r"In all 10$"],
        },
    ),
    # Apart from the forked ones, because the collectors would hear each other's workers.
    "spawned processes": ([], {"executors/processes.py spawn": [r"By spawn: \[1, 4, 9\]$"]}),
    "parameters": (
        ["parameters/thruster.py", "parameters/watch.py"],
        {
            "parameters/tune.py": [
                r"serial = 1: Trying to set a read-only parameter",
                r"In the end: 0\.5, right$",
            ]
        },
    ),
    "goals": (
        ["actions/fibonacci_server.py"],
        {
            "actions/fibonacci_client.py --ros-args -p order:=3": [
                r"So far \[0, 1, 1\]$",
                r"The goal succeeded: \[0, 1, 1, 2, 3\]$",
            ],
            "actions/fibonacci_client.py --ros-args -p order:=30 -p cancel_after:=2": [
                r"That will do$",
                r"The goal was canceled: \[0, 1, 1, 2(, \d+)*\]$",
            ],
        },
    ),
    "navigation": (
        ["navigation/fake_navigation.py"],
        {
            "navigation/patrol.py": [
                r"bt_navigator is active$",
                r"[01]\.\d m to go to \(1\.0, 0\.0\)$",
                r"(?s)The goal succeeded$.*The goal succeeded$.*The goal was canceled$",
                r"The goal failed: the goal is beyond the map$",
                r"After the shutdown, a goal is accepted: False$",
            ]
        },
    ),
    "lifecycle": (
        ["lifecycle/sensor.py"],
        {"lifecycle/manager.py": [r"It measured \d+\.0$", "is finalized$"]},
    ),
    "forked processes": ([], {"executors/processes.py fork": [r"By fork: \[1, 4, 9\]$"]}),
}

Start = Callable[..., object]


def has(program: object, *patterns: str) -> bool:
    return all(re.search(pattern, program.output, re.MULTILINE) for pattern in patterns)


def end_well(number: signal.Signals, *programs: object) -> None:
    """Send a signal to programs, and check that they end with 0 and without a traceback."""
    for program in programs:
        program.signal(number)
    assert [program.wait() for program in programs] == [0] * len(programs), [
        program.output for program in programs
    ]
    for program in programs:
        assert "Traceback" not in program.output
        assert "Exception" not in program.output


@pytest.mark.parametrize("scene", SPINNING)
def test_spinning_programs_end_on_a_signal(
    scene: str, domain_id: int, start_program: Start, wait_until: Callable[..., None]
) -> None:
    programs = {start_program("python", EXAMPLES / path): lines for path, lines in SPINNING[scene].items()}
    wait_until(
        lambda: all(
            has(program, *lines) or program.process.poll() is not None for program, lines in programs.items()
        )
    )
    for program, lines in programs.items():
        assert has(program, *lines), program.output
    number = signal.SIGINT if list(SPINNING).index(scene) % 2 else signal.SIGTERM
    end_well(number, *programs)


def wait_for_node(name: str, domain_id: int) -> None:
    with spun(SpunNode("watcher", domain_id)) as watcher:
        assert watcher.node.wait_for_node(f"/{name}", 20.0)


@pytest.mark.parametrize("scene", ENDING)
def test_finite_programs_end_with_their_output(scene: str, domain_id: int, start_program: Start) -> None:
    others, clients = ENDING[scene]
    servers = [start_program("python", EXAMPLES / other) for other in others]
    for node in filter(None, map(UNASKED.get, others)):
        wait_for_node(node, domain_id)
    programs = {}
    for words, lines in clients.items():
        path, *arguments = words.split()
        programs[start_program("python", EXAMPLES / path, *arguments)] = lines
    for program, lines in programs.items():
        assert program.wait() == 0, program.output
        assert has(program, *lines), program.output
        assert "Traceback" not in program.output
    end_well(signal.SIGINT if list(ENDING).index(scene) % 2 else signal.SIGTERM, *servers)


@pytest.mark.parametrize("number", [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    "path",
    [
        "services/add_client.py",
        "services/add_client_in_asyncio.py",
        "services/add_client_in_thread.py",
        "topics/wait_once.py",
        # They wait by the same calls as those above.
        pytest.param("parameters/tune.py", marks=pytest.mark.slow),
        pytest.param("actions/fibonacci_client.py", marks=pytest.mark.slow),
        pytest.param("lifecycle/manager.py", marks=pytest.mark.slow),
        pytest.param("navigation/patrol.py", marks=pytest.mark.slow),
    ],
)
def test_waiting_program_ends_cleanly(
    path: str, number: signal.Signals, domain_id: int, start_program: Start
) -> None:
    program = start_program("python", EXAMPLES / path)
    wait_for_node(NODES.get(path, Path(path).stem), domain_id)
    program.signal(number)
    assert program.wait() == 0, program.output
    assert "Traceback" not in program.output


def test_parameters_override_the_quality_of_service(domain_id: int, start_program: Start) -> None:
    words = ["--ros-args", "--params-file", EXAMPLES / "qos" / "overrides.yaml"]
    words += ["-p", "qos_overrides./frames.publisher.reliability:=best_effort"]
    camera = start_program("python", EXAMPLES / "qos" / "overrides.py", *words)
    camera.wait_for("Seen a frame")
    for line in (
        "publisher.depth = 3",
        "publisher.reliability = best_effort",
        "subscription_viewer.depth = 10",
    ):
        assert f"/frames.{line}" in camera.output
    info = start_program("ros2", "topic", "info", "--verbose", "/frames")
    assert info.wait() == 0, info.output
    publisher, subscription = info.output.split("Subscription count")
    for policy in ("Reliability: BEST_EFFORT", "Durability: TRANSIENT_LOCAL"):
        assert policy in publisher
    for policy in ("Reliability: BEST_EFFORT", "Durability: VOLATILE"):
        assert policy in subscription
    end_well(signal.SIGINT, camera)


def test_program_rejects_an_override(domain_id: int, start_program: Start) -> None:
    words = ["--ros-args", "-p", "qos_overrides./frames.publisher.depth:=1000"]
    camera = start_program("python", EXAMPLES / "qos" / "overrides.py", *words)
    assert camera.wait() == 1
    assert "The camera doesn't start" in camera.output
    assert "more than 100 frames" in camera.output


UNASKED = {"parameters/watch.py": "watch"}
"""The nodes of programs that the others don't wait for."""
NODES = {
    "topics/wait_once.py": "waiter",
    "parameters/tune.py": "tuner",
    "lifecycle/manager.py": "manager",
    "navigation/patrol.py": "navigator",
}
