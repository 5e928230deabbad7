"""The verbs about parameters, with turtlesim over DDS."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
import yaml

TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node")
SPAWNED = "Spawning turtle [turtle1]"


@pytest.fixture(scope="module", autouse=True)
def turtlesim(module_domain_id: int, start_module_program: Callable[..., object]) -> None:
    start_module_program(*TURTLESIM).wait_for(SPAWNED)


@pytest.fixture
def turtlesim_to_change(domain_id: int, start_program: Callable[..., object]) -> None:
    """Start another turtlesim, on a separate domain."""
    start_program(*TURTLESIM).wait_for(SPAWNED)


@pytest.mark.parametrize(
    "name", ["param_get", "param_get_bad", "param_set_bad", "param_set_range", "param_describe"]
)
def test_answers_match_the_recording(name: str) -> None:
    recorded = transcript.golden(name)
    assert transcript.run(*recorded.command) == recorded


@pytest.mark.usefixtures("turtlesim_to_change")
def test_set_output_matches_the_recording() -> None:
    recorded = transcript.golden("param_set")
    assert transcript.run(*recorded.command) == recorded


def test_failed_deletion_prints_the_reason_of_the_node(deviations: dict[str, dict[str, str]]) -> None:
    assert "param-delete-text" in deviations
    recorded = transcript.golden("param_delete")
    answer = transcript.run(*recorded.command)
    assert answer.exit_code == recorded.exit_code
    assert answer.text.startswith("Deleting parameter failed: ")
    assert transcript.run("param", "get", "--hide-type", "/turtlesim", "background_r").text == "69"


def test_lists_print_parameters_of_nodes() -> None:
    recorded = transcript.golden("param_list_node")
    assert transcript.run(*recorded.command) == recorded
    lines = recorded.text.splitlines()
    assert transcript.run("param", "list").text.splitlines() == ["/turtlesim:", *lines]
    typed = transcript.run("param", "list", "/turtlesim", "--param-type", "--filter", "_r$").text
    assert typed == "  background_r (type: integer)"
    assert json.loads(transcript.run("param", "list", "--json").text)["/turtlesim"]["background_g"] is None


@pytest.mark.parametrize(
    "words",
    [
        ("--param-prefixes", "start_type_description_service", "nope", "/turtlesim"),
        ("/turtlesim", "--param-prefixes", "start_type_description_service"),
    ],
)
def test_the_node_is_found_after_prefixes_too(
    words: tuple[str, ...], deviations: dict[str, dict[str, str]]
) -> None:
    assert "param-prefixes-node" in deviations
    assert transcript.run("param", "list", *words).text == "  start_type_description_service"


@pytest.mark.usefixtures("turtlesim_to_change")
def test_dump_can_be_loaded(tmp_path: Path) -> None:
    dumped = transcript.run("param", "dump", "/turtlesim").text
    recorded = yaml.safe_load(transcript.golden("param_dump").text)["/turtlesim"]["ros__parameters"]
    ours = yaml.safe_load(dumped)["/turtlesim"]["ros__parameters"]
    assert ours == {**recorded, "background_r": 69}

    file = tmp_path / "parameters.yaml"
    file.write_text(dumped.replace("background_r: 69", "background_r: 12"))
    loaded = transcript.run("param", "load", "/turtlesim", str(file))
    assert "Set parameter background_r successful" in loaded.text.splitlines()
    assert transcript.run("param", "get", "--hide-type", "/turtlesim", "background_r").text == "12"


@pytest.mark.usefixtures("turtlesim_to_change")
def test_wildcard_parameters_are_loaded_unless_disabled(tmp_path: Path) -> None:
    file = tmp_path / "parameters.yaml"
    file.write_text("/**:\n  ros__parameters:\n    background_g: 3\n")
    refused = transcript.run("param", "load", "--no-use-wildcard", "/turtlesim", str(file))
    assert (refused.text, refused.exit_code) == (
        "Param file does not contain parameters for /turtlesim,only for nodes: ['/**'] ",
        1,
    )
    assert (
        transcript.run("param", "load", "/turtlesim", str(file)).text
        == "Set parameter background_g successful"
    )


def test_invalid_arguments_give_an_error_message(tmp_path: Path) -> None:
    assert transcript.run("param", "list", "/turtlesin").text == "Node not found\ndid you mean /turtlesim?"
    near = transcript.run("param", "get", "/turtlesim", "backgroundr").text
    assert near.startswith("Parameter not set\ndid you mean background_")
    assert transcript.run("param", "describe", "/turtlesim", "nope").exit_code == 1
    missing = transcript.run("param", "load", "/turtlesim", str(tmp_path / "none.yaml"))
    assert missing.text == f"can't read {tmp_path / 'none.yaml'}: No such file or directory"


A_NODE = """
import math
import rclpy
from rclpy.parameter import Parameter

rclpy.init()
node = rclpy.create_node("a_node", namespace="/ns")
values = {
    "a.flag": True, "a.number": 5, "a.b.real": math.nan, "a.b.tiny": 1e-7, "text": "yes", "digits": "5", "none": "",
    "letters": "h\\u00e9\\n", "flags": [True, False], "numbers": [1, -2], "reals": [1.0, math.nan, -math.inf],
    "texts": ["a", "1", "true"],
}
for name, value in values.items():
    node.declare_parameter(name, value)
node.declare_parameter("unset", Parameter.Type.STRING_ARRAY)
print("ready", flush=True)
rclpy.spin(node)
"""


def test_values_of_every_type_survive_set_and_get(
    domain_id: int, tmp_path: Path, start_program: Callable[..., object]
) -> None:
    start_program("python", "-c", A_NODE).wait_for("ready")
    dumped = transcript.run("param", "dump", "/ns/a_node").text
    parameters = yaml.safe_load(dumped)["/ns/a_node"]["ros__parameters"]
    assert parameters["a"]["number"] == 5
    assert "unset" not in parameters
    file = tmp_path / "parameters.yaml"
    file.write_text(dumped)
    loaded = transcript.run("param", "load", "/ns/a_node", str(file)).text
    failed = [line for line in loaded.splitlines() if "failed" in line]
    assert [line.split()[2] for line in failed] == ["start_type_description_service"]  # It is read-only.
    assert transcript.run("param", "dump", "/ns/a_node").text == dumped
