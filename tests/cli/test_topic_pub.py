"""`topic pub`: its output, its end, and its error messages."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program


def test_once_waits_for_a_subscription_and_matches_the_recording(
    domain_id: int, start_program: Callable[..., object]
) -> None:
    echo = start_program("tfloom", "topic", "echo", "--once", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist")
    recorded = transcript.golden("topic_pub_once")
    answer = transcript.run(*recorded.command)  # whose start takes as long as that of the subscription
    assert answer == (recorded.command, recorded.text.rstrip("\n"), 0)
    assert echo.wait() == 0
    # Before it, a line says that it waits, where the publisher took longer to start.
    assert "linear:\n  x: 0.5\n" in echo.output


def test_times_output_matches_the_recording(domain_id: int) -> None:
    recorded = transcript.golden("topic_pub_times")
    assert transcript.run_here(*recorded.command) == (recorded.command, recorded.text.rstrip("\n"), 0)


@pytest.mark.parametrize("name", ["topic_pub_badfield", "topic_pub_badvalue", "topic_pub_badtype"])
def test_errors_begin_as_recorded(name: str, domain_id: int, deviations: dict[str, dict[str, str]]) -> None:
    assert "cli-nearest-names" in deviations
    recorded = transcript.golden(name)
    answer = transcript.run_here(*recorded.command)
    assert answer.exit_code == recorded.exit_code
    assert answer.text.splitlines()[: recorded.text.count("\n") + 1] == recorded.text.splitlines()


def test_unknown_field_lists_the_existing_fields(domain_id: int) -> None:
    answer = transcript.run_here("topic", "pub", "/x", "geometry_msgs/msg/Twist", "{linear: {q: 1}}")
    assert answer.text.endswith("\nVector3 has: x, y, z")


@pytest.mark.parametrize(
    ("type_name", "values", "field"),
    [
        ("geometry_msgs/msg/Twist", "{linear: {x: 1, y: abc}}", "linear.y"),
        ("geometry_msgs/msg/Twist", "{linear: {x: 1}, angular: 3}", "angular"),
        (
            "nav_msgs/msg/Path",
            "{poses: [{header: auto}, {pose: {position: {z: up}}}]}",
            "poses[1].pose.position.z",
        ),
        ("sensor_msgs/msg/JointState", "{name: [a, b], position: [1, b]}", "position[1]"),
    ],
)
def test_unfitting_value_names_its_field(type_name: str, values: str, field: str, domain_id: int) -> None:
    answer = transcript.run_here("topic", "pub", "/x", type_name, values)
    assert answer.exit_code == 1
    assert answer.text.splitlines()[1:] == [f"in the field {field}"]


def test_malformed_yaml_is_shown_with_its_position(
    domain_id: int, deviations: dict[str, dict[str, str]]
) -> None:
    assert "cli-yaml-mistake" in deviations
    recorded = transcript.golden("topic_pub_badyaml")
    answer = transcript.run_here(*recorded.command)
    assert answer.exit_code == recorded.exit_code
    assert answer.text == (
        "The passed value isn't YAML: expected the node content, but found '<stream end>' at line 1, column 10:\n"
        "  {linear: \n"
        "           ^"
    )


def test_value_that_is_not_a_mapping_is_rejected(domain_id: int) -> None:
    answer = transcript.run_here("topic", "pub", "/x", "std_msgs/msg/String", "hi")
    assert answer.exit_code == 1
    assert answer.text == "The passed value needs to be a dictionary in YAML format, not 'hi'"


def test_invalid_rate_is_rejected(domain_id: int) -> None:
    answer = transcript.run_here("topic", "pub", "-r", "0", "/x", "std_msgs/msg/String")
    assert (answer.exit_code, answer.text) == (1, "rate must be greater than zero")


@pytest.mark.timing
def test_publishing_keeps_its_rate(domain_id: int, start_program: Callable[..., object]) -> None:
    start = time.monotonic()
    program = start_program(
        "tfloom", "topic", "pub", "-r", "50", "-t", "100", "-w", "0", "/x", "std_msgs/msg/Empty"
    )
    assert program.wait() == 0
    assert 1.98 < time.monotonic() - start < 6.0
    assert program.output.count("publishing #") == 100


def test_every_nth_message_is_printed(domain_id: int) -> None:
    words = ("topic", "pub", "-t", "6", "-r", "100", "-w", "0", "-p", "3", "/x", "std_msgs/msg/Empty")
    assert re.findall(r"#(\d+)", transcript.run_here(*words).text) == ["3", "6"]


def test_auto_headers_and_now_times_have_the_present_time(domain_id: int) -> None:
    now = int(time.time())
    words = ("topic", "pub", "-t", "1", "-w", "0", "/x", "geometry_msgs/msg/PointStamped", "{header: auto}")
    stamped = re.search(r"Time\(sec=(\d+), nanosec=", transcript.run_here(*words).text)
    assert stamped
    assert now <= int(stamped[1]) <= now + 60
    words = ("topic", "pub", "-t", "1", "-w", "0", "/x", "builtin_interfaces/msg/Time", "now")
    assert transcript.run_here(*words).exit_code == 1


def test_values_are_read_from_standard_input(domain_id: int, start_program: Callable[..., object]) -> None:
    import subprocess

    program = start_program(
        "tfloom", "topic", "pub", "--stdin", "-r", "100", "/x", "std_msgs/msg/String", stdin=subprocess.PIPE
    )
    program.process.stdin.write("data: one\n---\n---\ndata: two\n")
    program.process.stdin.close()
    assert program.wait() == 0
    assert re.findall(r"data='(\w+)'", program.output) == ["one", "two"]


def test_node_name_can_be_set(domain_id: int, start_program: Callable[..., object]) -> None:
    start_program("tfloom", "topic", "pub", "-n", "my_node", "/x", "std_msgs/msg/Empty").wait_for("#1")
    assert transcript.run_here("node", "list").text == "/my_node"


def test_incompatible_endpoints_are_reported_on_both_sides(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    echo = start_program(
        "tfloom", "topic", "echo", "--qos-reliability", "reliable", "/x", "std_msgs/msg/String"
    )
    pub = start_program(
        "tfloom", "topic", "pub", "--once", "--qos-reliability", "best_effort", "/x", "std_msgs/String"
    )
    policies = "RELIABILITY (offered RELIABILITY BEST_EFFORT, requested RELIABILITY RELIABLE"
    pub.wait_for(
        "WARNING: New subscription discovered on topic '/x', requesting incompatible QoS. "
        f"No messages will be sent to it. Last incompatible policy: {policies}"
    )
    echo.wait_for(
        "WARNING: New publisher discovered on topic '/x', offering incompatible QoS. "
        f"No messages will be received from it. Last incompatible policy: {policies}"
    )


@pytest.mark.parametrize("name", ["a b", "", "1st"])
def test_invalid_node_name_is_rejected(name: str) -> None:
    answer = transcript.run_here("topic", "pub", "-n", name, "/x", "std_msgs/msg/String")
    assert answer.exit_code == 1
    assert answer.text.startswith("Invalid node name: ")


@pytest.mark.parametrize(
    ("name", "type_name", "said"),
    [
        (
            "/turtle1/cmdvel",
            "geometry_msgs/msg/Twist",
            ["no subscription of /turtle1/cmdvel yet", "did you mean /turtle1/cmd_vel?"],
        ),
        (
            "/turtle1/cmd_vel",
            "std_msgs/msg/Empty",
            ["/turtle1/cmd_vel is subscribed to as geometry_msgs/msg/Twist, not as std_msgs/msg/Empty"],
        ),
    ],
)
def test_reason_for_missing_subscriptions_is_printed(
    name: str,
    type_name: str,
    said: list[str],
    domain_id: int,
    start_program: Callable[..., Program],
    deviations: dict[str, dict[str, str]],
) -> None:
    assert "cli-other-type" in deviations
    echo = start_program("tfloom", "topic", "echo", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist")
    start_program("tfloom", "topic", "pub", "-r", "10", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist")
    echo.wait_for("linear:")
    words = transcript.python_words(
        *("topic", "pub", "--once", name, type_name), constants={"tfloom.cli.topic.pub.HINT_S": 1.0}
    )
    program = start_program("python", *words)
    program.wait_for(said[-1])
    assert [line for line in program.lines if not line.startswith("Waiting for at least")] == said


def test_rate_output_matches_the_recording(domain_id: int, start_program: Callable[..., Program]) -> None:
    recorded = transcript.golden("topic_pub_rate")
    program = start_program("tfloom", *recorded.command)
    program.wait_for("publishing #5")
    lines = recorded.text.rstrip("\n").splitlines()
    assert program.lines[: len(lines)] == lines


def test_values_come_from_a_file(
    domain_id: int, start_program: Callable[..., Program], tmp_path: Path
) -> None:
    echo = start_program("tfloom", "topic", "echo", "--csv", "/x", "std_msgs/msg/String")
    file = tmp_path / "values.yaml"
    file.write_text("data: one\n---\ndata: two\n---\n", "utf-8")
    words = ("topic", "pub", "-r", "100", "-w", "1", "/x", "std_msgs/msg/String", "--yaml-file", str(file))
    answer = transcript.run_here(*words)
    assert answer.exit_code == 0
    assert re.findall(r"data='(\w+)'", answer.text) == ["one", "two"]
    echo.wait_for("two")
    assert echo.lines[-2:] == ["one", "two"]
    assert re.findall(r"data='(\w+)'", transcript.run_here(*words, "--once").text) == ["one"]


@pytest.mark.parametrize(
    ("text", "words", "error"),
    [
        ("data: a\n---\ndat: 3\n", (), "values.yaml, document 2: "),
        ("", (), "values.yaml holds no values"),
        ("data: a", ("{data: b}",), "--yaml-file gives the values"),
        ("data: a", ("--stdin",), "--yaml-file gives the values"),
        (None, (), "values.yaml can't be read: "),
    ],
)
def test_wrong_file_of_values_is_refused(
    text: str | None, words: tuple[str, ...], error: str, domain_id: int, tmp_path: Path
) -> None:
    file = tmp_path / "values.yaml"
    if text is not None:
        file.write_text(text, "utf-8")
    answer = transcript.run_here(
        "topic", "pub", "/x", "std_msgs/msg/String", *words, "--yaml-file", str(file)
    )
    assert answer.exit_code == 1
    assert error in answer.text
    assert "publisher" not in answer.text
