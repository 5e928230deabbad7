"""The programs of demo_nodes_py as processes over DDS, against the reference's output."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable

import pytest
from tests.conftest import Program, python_with
from tests.recorded_outputs import recorded_output
from tests.spun import SpunNode, spun

from tfloom.workspace import index

NAMES = [
    *("add_two_ints_client", "add_two_ints_client_async", "add_two_ints_server", "async_param_client"),
    *("introspection", "listener", "listener_qos", "listener_serialized", "matched_event_detect"),
    *("parameter_blackboard", "set_parameters_callback", "talker", "talker_qos", "use_logger_service"),
]
Start = Callable[..., Program]


@pytest.fixture
def start(start_program: Start, domain_id: int) -> Start:
    return lambda name, *words: start_program("tfloom", "run", "demo_nodes_py", name, *words)


def module_of(name: str) -> str:
    """Return the module of a program."""
    return index.PROGRAMS["demo_nodes_py"][name].partition(":")[0]


def main_of(name: str) -> str:
    """Return the Python code that runs a program."""
    function = index.PROGRAMS["demo_nodes_py"][name].partition(":")[2]
    return f"from {module_of(name)} import {function} as main; sys.exit(main(sys.argv[1:]))"


@pytest.fixture
def start_quick(start_program: Start, domain_id: int) -> Start:
    """Start programs with a module constant replaced: `start_quick("talker", {"PERIOD_S": 0.2}, *words)`."""

    def start(name: str, constants: dict[str, float], *words: str) -> Program:
        full = {f"{module_of(name)}.{constant}": value for constant, value in constants.items()}
        return start_program("python", *python_with(full, main_of(name), *words))

    return start


def masked(lines: list[str]) -> list[str]:
    return [re.sub(r"\[\d+\.\d{9}\]", "[stamp]", line) for line in lines]


def said(lines: list[str], node: str) -> list[str]:
    """Return the log of one node, without stamps."""
    return [line.split(f"[{node}]: ", 1)[1] for line in lines if f"[{node}]: " in line]


def end(*programs: Program, number: int = signal.SIGINT) -> None:
    """Stop programs, and check that they end with 0 and without a traceback."""
    for program in programs:
        program.signal(number)
    for program in programs:
        assert program.wait() == 0, program.output
        assert "Traceback" not in program.output


def test_programs_are_listed(start_program: Start) -> None:
    listed = start_program("tfloom", "pkg", "executables", "demo_nodes_py")
    assert listed.wait() == 0
    assert listed.lines == [f"demo_nodes_py {name}" for name in NAMES]


def test_listener_logs_the_messages_of_the_talker(start: Start, start_quick: Start) -> None:
    listeners = [start(name) for name in ("listener", "listener_qos", "listener_serialized")]
    talker = start_quick("talker", {"PERIOD_S": 0.3})
    golden = recorded_output("talker_log").splitlines()[1:-1]
    talker.wait_for(golden[2].split("]: ")[1])
    assert masked(talker.lines)[:3] == masked(golden)[:3]
    listener, best_effort, serialized = listeners
    listener.wait_for("[listener]: I heard: [Hello World: 2]")
    best_effort.wait_for("[listener_qos]: I heard: [Hello World: 2]")
    assert best_effort.lines[0].endswith("[listener_qos]: Best effort listener")
    serialized.wait_for(
        """[serialized_subscriber]: I heard: "b'\\x00\\x01\\x00\\x00\\x0f\\x00\\x00\\x00Hello World: 2\\x00\\x00'\""""
    )
    end(talker, listener, best_effort)
    end(serialized, number=signal.SIGTERM)


def test_reliable_talker_ends_after_its_messages(start: Start, start_quick: Start) -> None:
    listener = start("listener_qos", "--reliable", "-n", "1")
    listener.wait_for("Reliable listener")
    talker = start_quick("talker_qos", {"PERIOD_S": 0.4}, "--reliable", "--number_of_cycles", "2")
    assert talker.wait() == 0
    assert said(talker.lines, "talker_qos") == [
        "Reliable talker",
        'Publishing: "Hello World: 0"',
        'Publishing: "Hello World: 1"',
    ]
    assert listener.wait() == 0
    assert re.fullmatch(r"I heard: \[Hello World: [01]\]", said(listener.lines, "listener_qos")[1])


def test_clients_log_the_sum_of_two_and_three(start: Start) -> None:
    clients = [start(name) for name in ("add_two_ints_client", "add_two_ints_client_async")]
    for client in clients:
        client.wait_for("service not available, waiting again...")
    server = start("add_two_ints_server")
    for client in clients:
        assert client.wait() == 0
        assert said(client.lines, "add_two_ints_client") == ["Result of add_two_ints: 5"]
    assert said(server.lines, "add_two_ints_server") == ["Incoming request"] * 2
    assert server.lines[1::2] == ["a: 2 b: 3"] * 2
    end(server, number=signal.SIGTERM)


@pytest.mark.parametrize("number", [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.slow)])
def test_client_without_server_can_be_stopped(start: Start, number: int) -> None:
    client = start("add_two_ints_client")
    client.wait_for("service not available, waiting again...")
    end(client, number=number)


def test_matched_events_are_logged(start: Start) -> None:
    program = start("matched_event_detect")
    assert program.wait(60) == 0
    lines = said(program.lines, "matched_event_detection_node")
    assert lines == [
        line
        for other in ("subscription", "publisher")
        for line in (
            f"First {other} is connected.",
            f"The changed number of connected {other} is 1 and current number of connected {other} is 2",
            f"The changed number of connected {other} is -1 and current number of connected {other} is 1",
            f"Last {other} is disconnected.",
        )
    ]


def test_logger_levels_are_set_by_service(start: Start) -> None:
    program = start("use_logger_service")
    assert program.wait(60) == 0
    levels = {"default": 0, "debug": 10, "warn": 30, "error": 40}
    assert said(program.lines, "TestNode") == [
        line
        for name, level in levels.items()
        for line in (f"Output with {name} logger level:", f"Current logger level: {level}")
    ]
    seen = [("INFO", 1), ("WARN", 1), ("ERROR", 1), ("DEBUG", 2), ("INFO", 2), ("WARN", 2), ("ERROR", 2)]
    seen += [("WARN", 3), ("ERROR", 3), ("ERROR", 4)]
    assert said(program.lines, "LoggerServiceNode") == [
        f"Output {number} with {level} logger level." for level, number in seen
    ]


def test_parameters_of_another_node_are_set_and_read(start: Start, start_quick: Start) -> None:
    lonely = start_quick("async_param_client", {"PATIENCE_S": 0.3})
    assert lonely.wait() == 1
    assert lonely.lines[0] == (
        "parameter_blackboard is not available, start parameter blackboard with "
        "`ros2 run demo_nodes_py parameter_blackboard` before running this demo"
    )
    blackboard = start("parameter_blackboard", "--ros-args", "-p", "colour:=white")
    blackboard.wait_for(
        "Parameter blackboard node named '/parameter_blackboard' ready, and serving '3' parameters"
    )
    client = start("async_param_client")
    assert client.wait() == 0
    lines = said(client.lines, "async_param_client")
    loaded = {
        "other_int_parameter": "0",
        "int_parameter": "12",
        "string_parameter": "I smell the blood of an Englishman",
        "other_string_parameter": "One fish, two fish, Red fish, blue fish",
        "bool_parameter": "False",
    }
    names = ("int_parameter", "bool_parameter", "string_parameter")
    assert lines == [
        "Setting parameters:",
        *(line for name in names for line in (f"    {name}:", "        successful: True")),
        "Listing Parameters:",
        *(f"    - {name}" for name in names),
        "Getting parameters:",
        *("    - int_parameter: 10", "    - bool_parameter: False", "    - string_parameter: Fee Fi Fo Fum"),
        "Loading parameters: ",
        *(
            line
            for name, value in loaded.items()
            for line in (f"    {name}:", "        successful: True", f"        value: {value}")
        ),
        "Deleting parameters: ",
        *(
            line
            for name in ("other_int_parameter", "other_string_parameter", "string_parameter")
            for line in (f"    {name}:", "        successful: True", "        reason: ")
        ),
    ]
    end(blackboard)


def test_setting_one_parameter_sets_another(start: Start, domain_id: int) -> None:
    node = start("set_parameters_callback")
    with spun(SpunNode("setter", domain_id)) as setter:
        assert setter.set_parameter("/set_parameters_callback", "param1", 28.0).successful
        answer = setter.parameters_of("/set_parameters_callback").get_parameters(["param1", "param2"])
        setter.spin_until(answer.done)
    assert [value.double_value for value in answer.result().values] == [28.0, 4.0]
    end(node)


def test_service_events_are_published(
    start: Start, start_program: Start, domain_id: int, wait_until: Callable[..., None]
) -> None:
    def tells(event: str) -> bool:
        return re.search(rf"event_type: ({event})$", echo.output, re.MULTILINE) is not None

    program = start("introspection", "--ros-args", "-p", "service_configure_introspection:=contents")
    program.wait_for("[introspection_client]: Result of add_two_ints: 5")
    echo = start_program("tfloom", "service", "echo", "/add_two_ints")
    wait_until(lambda: tells("1|REQUEST_RECEIVED"))
    assert not tells("3|RESPONSE_RECEIVED")
    switch = "/introspection_client", "client_configure_introspection"
    with spun(SpunNode("setter", domain_id)) as setter:
        refused = setter.set_parameter(*switch, "all")
        assert "must be one of 'disabled', 'metadata', or 'contents" in refused.reason
        assert setter.set_parameter(*switch, "metadata").successful
    wait_until(lambda: tells("3|RESPONSE_RECEIVED"))
    end(program)


def test_unknown_argument_is_rejected(start_program: Start) -> None:
    """tests/cli/test_programs.py asks each program of the package the same, in one process."""
    program = start_program("tfloom", "run", "demo_nodes_py", "talker", "loudly")
    assert program.wait() == 2
    assert "talker: error: unrecognized arguments: loudly" in program.lines


def test_facade_exports_the_programs() -> None:
    from demo_nodes_py.services.add_two_ints_server import AddTwoIntsServer
    from demo_nodes_py.topics import listener, talker

    assert {talker.Talker.__name__, listener.Listener.__name__, AddTwoIntsServer.__name__} == {
        *("Talker", "Listener", "AddTwoIntsServer")
    }
