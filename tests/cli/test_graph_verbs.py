"""The verbs about the graph, in real processes over DDS, against the recorded output."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript


@pytest.fixture(scope="module", autouse=True)
def recorded_graph(module_domain_id: int, start_module_program: Callable[..., object]) -> None:
    """Run the recorded graph in its own domain."""
    start_module_program("python", Path(__file__).with_name("a_graph.py"), stdin=subprocess.PIPE).wait_for(
        "ready"
    )


@pytest.mark.parametrize(
    "name",
    [
        "topic_list",
        "topic_list_t",
        "topic_list_c",
        "topic_list_hidden",
        "topic_type",
        "topic_find",
        "topic_info",
        "topic_info_bad",
        "node_list",
    ],
)
def test_answers_match_the_recording(
    name: str,
) -> None:
    transcript.check(name)


def test_own_participant_is_not_counted(deviations: dict[str, dict[str, str]]) -> None:
    assert "cli-asker-uncounted" in deviations
    recorded = transcript.golden("topic_list_v")
    answer = transcript.run_here(*recorded.command)
    assert answer.text == recorded.text.replace("4 publishers", "3 publishers").rstrip("\n")
    assert answer.exit_code == recorded.exit_code


def test_topic_info_prints_each_endpoint() -> None:
    recorded = transcript.golden("topic_info_v")
    answer = transcript.run_here(*recorded.command)
    without_gid = [re.sub(r"GID: [0-9a-f.]+", "GID: #", text) for text in (answer.text, recorded.text)]
    assert without_gid[0] == without_gid[1].rstrip("\n")
    assert re.search(r"^GID: ([0-9a-f]{2}\.){15}[0-9a-f]{2}$", answer.text, re.MULTILINE)


def test_misspelt_topic_gives_the_nearest_names() -> None:
    for verb in ("info", "type"):
        answer = transcript.run_here("topic", verb, "/turtle1/pos")
        assert answer.exit_code == 1
        assert answer.text.startswith("Unknown topic '/turtle1/pos'\ndid you mean /turtle1/pose")


def test_list_is_complete_on_every_run() -> None:
    whole = transcript.golden("topic_list").text
    assert {transcript.run_here("topic", "list").text for _ in range(10)} == {whole}


def test_json_has_the_same_content() -> None:
    topics = json.loads(transcript.run_here("topic", "list", "--json").text)
    assert [topic["name"] for topic in topics] == transcript.golden("topic_list").text.splitlines()
    pose = next(topic for topic in topics if topic["name"] == "/turtle1/pose")
    assert pose == {
        "name": "/turtle1/pose",
        "types": ["turtlesim/msg/Pose"],
        "publishers": 1,
        "subscribers": 0,
    }
    nodes = json.loads(transcript.run_here("node", "list", "--json").text)
    assert nodes == transcript.golden("node_list").text.splitlines()
    info = json.loads(transcript.run_here("topic", "info", "/turtle1/pose", "--json").text)
    assert [end["node"] for end in info["publishers"]] == ["/turtlesim"]


def test_count_flags_print_numbers() -> None:
    assert transcript.run_here("node", "list", "-c").text == "3"
    assert transcript.run_here("topic", "find", "-c", "rcl_interfaces/msg/Log").text == "1"
    hidden = transcript.run_here("topic", "--include-hidden-topics", "list", "-c")
    assert hidden.text == "9"


@pytest.mark.parametrize("name", ["/a b", "", "/", "/1a", "a//b", "/a/"])
def test_invalid_name_gives_an_error_message(name: str) -> None:
    answer = transcript.run_here("topic", "info", name)
    assert answer.exit_code == 1
    assert answer.text.startswith(f"'{name}' can't be a topic's name")


@pytest.mark.parametrize(
    ("words", "what", "nearest"),
    [
        (("topic", "find", "turtlesim/msg/Pse"), "message", "turtlesim/msg/Pose"),
        (("service", "find", "std_srvs/srv/Emty"), "service", "std_srvs/srv/Empty"),
    ],
)
def test_unknown_type_finds_nothing_and_gives_the_nearest_types(
    words: tuple[str, ...], what: str, nearest: str, deviations: dict[str, dict[str, str]]
) -> None:
    assert "cli-nearest-names" in deviations
    answer = transcript.run_here(*words)
    said = f"there is no {what} type '{words[-1]}'\ndid you mean {nearest}?"
    assert (answer.text, answer.exit_code) == (said, 0)


def test_unused_type_finds_nothing() -> None:
    assert transcript.run_here("topic", "find", "std_msgs/msg/Int64") == (
        ["topic", "find", "std_msgs/msg/Int64"],
        "",
        0,
    )
