"""The verbs about services and nodes, with a real server over DDS."""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program, wait_until

from tfloom.cli.shared.graph import joined_participant

A_SERVER = Path(__file__).with_name("a_server.py")


@pytest.fixture(scope="module", autouse=True)
def server(module_domain_id: int, start_module_program: Callable[..., object]) -> None:
    start_module_program("python", A_SERVER).wait_for("ready")


@pytest.mark.parametrize("name", ["service_info", "service_find", "service_type"])
def test_answers_match_the_recording(name: str) -> None:
    recorded = transcript.golden(name)
    if recorded.exit_code == 2:  # Recorded with a flag that these verbs don't have.
        with_flag = transcript.run_here(*recorded.command, "--no-daemon")
        assert with_flag == ([*recorded.command, "--no-daemon"], recorded.text, 2)
        answer = transcript.run_here(*recorded.command)
        assert answer.text == {"service_find": "/spawn", "service_type": "turtlesim/srv/Spawn"}[name]
    else:
        assert transcript.run_here(*recorded.command) == recorded


def test_list_prints_all() -> None:
    listed = transcript.run_here("service", "list", "-t").text.splitlines()
    recorded = transcript.golden("service_list_t").text.splitlines()
    ours = [line for line in listed if "/turtlesim/" not in line and "reset" not in line]
    assert ours == [line for line in recorded if line.startswith(("/clear ", "/spawn "))]
    assert "/reset [std_srvs/srv/Empty]" in listed
    assert transcript.run_here("service", "list", "-c").text == str(len(listed))
    names = [service["name"] for service in json.loads(transcript.run_here("service", "list", "--json").text)]
    assert names == [line.split()[0] for line in listed]


def test_node_info_prints_all_endpoints() -> None:
    answer = transcript.run_here("node", "info", "/turtlesim")
    sections = re.split(r"^  (?=\w)", answer.text, flags=re.MULTILINE)
    recorded = re.split(r"^  (?=\w)", transcript.golden("node_info").text, flags=re.MULTILINE)
    assert [part.splitlines()[0] for part in sections] == [part.splitlines()[0] for part in recorded]
    assert "    /spawn: turtlesim/srv/Spawn\n" in sections[3]
    assert sections[4] == "Service Clients:\n    /reset: std_srvs/srv/Empty\n"
    assert sections[5:] == ["Action Servers:\n\n", "Action Clients:"]
    as_json = json.loads(transcript.run_here("node", "info", "turtlesim", "--json").text)
    assert as_json["service_servers"]["/clear"] == ["std_srvs/srv/Empty"]


def test_unknown_node_gives_an_error_message() -> None:
    transcript.check("node_info_bad")
    assert transcript.run_here("node", "info", "/turtlesin").text.endswith("\ndid you mean /turtlesim?")


def test_invalid_arguments_give_an_error_message() -> None:
    assert (
        transcript.run_here("service", "type", "/spwn").text
        == "Unknown service '/spwn'\ndid you mean /spawn?"
    )
    wrong_type = transcript.run_here("service", "call", "/spawn", "turtlesim/srv/Spwn")
    assert transcript.without_waiting(wrong_type.text).startswith("The passed service type is invalid\n")
    message_type = transcript.run_here("service", "call", "/spawn", "turtlesim/msg/Pose")
    assert transcript.without_waiting(message_type.text).startswith("The passed service type is invalid\n")
    wrong_field = transcript.run_here("service", "call", "/spawn", "turtlesim/srv/Spawn", "{z: 1}")
    assert wrong_field.exit_code == 1
    assert wrong_field.text.endswith("Spawn_Request has: x, y, theta, name")


def test_requests_are_read_from_standard_input(start_program: Callable[..., object]) -> None:
    program = start_program(
        "tfloom", "service", "call", "--stdin", "/spawn", "turtlesim/srv/Spawn", stdin=subprocess.PIPE
    )
    program.process.stdin.write("name: a\n---\nname: b\n")
    program.process.stdin.close()
    assert program.wait() == 0
    assert re.findall(r"Spawn_Response\(name='(\w+)'\)", program.output) == ["a", "b"]


def test_rate_repeats_the_call(start_program: Callable[..., object]) -> None:
    program = start_program("tfloom", "service", "call", "-r", "20", "/clear", "std_srvs/srv/Empty")
    program.wait_for("response:")
    program.signal(2)
    assert program.wait() == 2
    assert "Traceback" not in program.output


def test_service_events_are_printed(start_program: Callable[..., Program]) -> None:
    echo = start_program("tfloom", "service", "echo", "/spawn", "--flow-style")
    as_json = start_program("tfloom", "service", "echo", "/spawn", "--json")
    with joined_participant() as observer:

        def readers() -> int:
            topics = [end.topic.name for end in observer.graph.endpoints() if not end.is_writer]
            return topics.count("/spawn/_service_event")

        wait_until(lambda: readers() == 2, what="both listeners")
    for number in range(20):  # the server may discover a listener later than the observer has
        # Each name is accepted for one turtle only.
        words = ("service", "call", "/spawn", "turtlesim/srv/Spawn", f"{{x: 2.0, name: heard_{number}}}")
        assert transcript.run_here(*words).exit_code == 0
        texts = (
            f"request: [{{x: 2.0, y: 0.0, theta: 0.0, name: heard_{number}}}]",
            f"response: [{{name: heard_{number}}}]",
        )
        is_heard = all(text in echo.output for text in texts)
        if is_heard and f'"response": [{{"name": "heard_{number}"}}]' in as_json.output:
            break
    else:
        pytest.fail(f"no call was ever printed by both:\n{echo.output}\n{as_json.output}")
    assert "info:\n  event_type: REQUEST_RECEIVED\n  stamp:" in echo.output
    assert "  event_type: RESPONSE_SENT\n" in echo.output


def test_echo_of_an_unknown_service_needs_a_type() -> None:
    answer = transcript.run_here("service", "echo", "/nope")
    assert (answer.exit_code, answer.text) == (
        1,
        "Could not determine the type of service '/nope': it isn't on the graph; pass its type",
    )


def test_waiting_for_a_misspelt_service_gives_the_nearest(
    start_program: Callable[..., object],
) -> None:
    words = ("service", "call", "/spwn", "turtlesim/srv/Spawn")
    quick = {"tfloom.cli.shared.calls.HINT_S": 1.0}
    call = start_program("python", *transcript.python_words(*words, constants=quick))
    call.wait_for("did you mean /spawn?")
    assert call.lines[:2] == ["waiting for service to become available...", "no server of /spwn yet"]


def test_verbose_info_describes_servers_and_clients() -> None:
    shown = transcript.run_here("service", "info", "-v", "/spawn").text.split("\n\n")
    assert shown[:2] == ["Type: turtlesim/srv/Spawn", "Clients count: 0"]
    lines = shown[3].splitlines()
    assert shown[2] == "Services count: 1"
    assert lines[:3] == ["Node name: turtlesim", "Node namespace: /", "Service type: turtlesim/srv/Spawn"]
    assert re.fullmatch(r"Service type hash: (RIHS01_[0-9a-f]{64}|INVALID)", lines[3])
    assert lines[4] == "Endpoint type: SERVER"
    count = int(lines[5].removeprefix("Endpoint count: "))
    assert count in (1, 2)
    assert sum(line.startswith("GID: ") for line in lines) == lines.count("  Reliability: RELIABLE") == count
    client = transcript.run_here("service", "info", "-v", "/reset").text.split("\n\n")
    assert client[1] == "Clients count: 1"
    assert "Endpoint type: CLIENT" in client[2].splitlines()


def test_call_has_the_requested_quality() -> None:
    call = ("service", "call", "/clear", "std_srvs/srv/Empty", "--timeout", "5")
    assert transcript.run_here(*call, "--qos-depth", "3").exit_code == 0
    wrong = transcript.run_here(*call, "--qos-reliability", "best_effort")
    passes = os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp"  # which matches all
    assert wrong.exit_code == int(not passes)
    assert passes or "/clear" in wrong.text
