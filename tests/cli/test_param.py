"""The verbs about parameters, with turtlesim over DDS."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import transcript
import yaml
from tests.conftest import Program

pytestmark = pytest.mark.usefixtures("turtlesim")


@pytest.mark.parametrize("name", ["param_get", "param_get_bad", "param_describe"])
def test_answers_match_the_recording(name: str) -> None:
    transcript.check(name)


@pytest.mark.parametrize("name", ["param_set_bad", "param_set_range"])
def test_a_refused_value_gives_exit_code_1(name: str, deviations: dict[str, dict[str, str]]) -> None:
    assert "param-exit-code" in deviations
    recorded = transcript.golden(name)
    assert transcript.run_here(*recorded.command) == recorded._replace(exit_code=1)


@pytest.mark.usefixtures("turtlesim_to_change")
def test_set_output_matches_the_recording() -> None:
    transcript.check("param_set")


def test_failed_deletion_prints_the_reason_of_the_node(deviations: dict[str, dict[str, str]]) -> None:
    assert "param-delete-text" in deviations
    recorded = transcript.golden("param_delete")
    answer = transcript.run_here(*recorded.command)
    assert answer.exit_code == 1
    assert answer.text.startswith("Deleting parameter failed: ")
    assert transcript.run_here("param", "get", "--hide-type", "/turtlesim", "background_r").text == "69"


def test_lists_print_parameters_of_nodes() -> None:
    recorded = transcript.golden("param_list_node")
    assert transcript.run_here(*recorded.command) == recorded
    lines = recorded.text.splitlines()
    assert transcript.run_here("param", "list").text.splitlines() == ["/turtlesim:", *lines]
    typed = transcript.run_here("param", "list", "/turtlesim", "--param-type", "--filter", "_r$").text
    assert typed == "  background_r (type: integer)"
    assert (
        json.loads(transcript.run_here("param", "list", "--json").text)["/turtlesim"]["background_g"] is None
    )


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
    assert transcript.run_here("param", "list", *words).text == "  start_type_description_service"


def test_a_refused_file_gives_exit_code_1(tmp_path: Path) -> None:
    file = tmp_path / "parameters.yaml"
    file.write_text("/turtlesim:\n  ros__parameters:\n    background_r: fast\n")
    loaded = transcript.run_here("param", "load", "/turtlesim", str(file))
    assert loaded.exit_code == 1
    assert loaded.text.startswith("Set parameter background_r failed: ")


TYPED: dict[str, tuple[str, Any]] = {
    "serial": ("STRING", "0888"),
    "commit": ("STRING", "12e03"),
    "axis": ("STRING", "y"),
    "axes": ("STRING_ARRAY", ["x", "y", "n"]),
    "speed": ("STRING", "inf"),
    "no_text": ("STRING", ""),
    "lines": ("STRING", "a\nb\t\x85c"),
    "double": ("DOUBLE", 1e20),
    "least": ("DOUBLE", 5e-324),
    "limits": ("DOUBLE_ARRAY", [float("-inf"), 0.1]),
    "no_doubles": ("DOUBLE_ARRAY", []),
    "no_texts": ("STRING_ARRAY", []),
    "octets": ("BYTE_ARRAY", [b"\x00", b"\xff"]),
    "flags": ("BOOL_ARRAY", [True, False]),
}
TYPED_NODE = f"""
import sys
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter

inf = float("inf")
rclpy.init()
node = Node("typed")
for name, (kind, value) in {TYPED}.items():
    node.declare_parameter(name, Parameter.Type[kind])
    if sys.argv[1] == "set":
        assert node.set_parameters([Parameter(name, Parameter.Type[kind], value)])[0].successful
print("=", {{name: node.get_parameter(name).value for name in {list(TYPED)}}}, flush=True)
rclpy.spin(node)
"""


def test_each_value_comes_back_from_a_dump_with_its_type(
    start_program: Callable[..., Program], tmp_path: Path
) -> None:
    node = start_program(sys.executable, "-c", TYPED_NODE, "set")
    before = node.wait_for("= ")
    assert before == f"= { {name: value for name, (_, value) in TYPED.items()} }"
    file = tmp_path / "parameters.yaml"
    file.write_text(transcript.run_here("param", "dump", "/typed").text, "utf-8")
    loaded = transcript.run_here("param", "load", "/typed", str(file))
    others = [line for line in loaded.text.splitlines() if not line.endswith(" successful")]
    assert others == [
        (
            "Set parameter start_type_description_service failed: Trying to set a read-only parameter: "
            "start_type_description_service."
        )
    ]
    assert loaded.exit_code == 0  # because it has the value of the file
    again = start_program(sys.executable, "-c", TYPED_NODE, "read", "--ros-args", "--params-file", str(file))
    assert again.wait_for("= ") == before


@pytest.mark.usefixtures("turtlesim_to_change")
def test_dump_can_be_loaded(tmp_path: Path) -> None:
    dumped = transcript.run_here("param", "dump", "/turtlesim").text
    recorded = yaml.safe_load(transcript.golden("param_dump").text)["/turtlesim"]["ros__parameters"]
    ours = yaml.safe_load(dumped)["/turtlesim"]["ros__parameters"]
    assert ours == {**recorded, "background_r": 69}

    file = tmp_path / "parameters.yaml"
    file.write_text(dumped.replace("background_r: 69", "background_r: 12"))
    loaded = transcript.run_here("param", "load", "/turtlesim", str(file))
    assert "Set parameter background_r successful" in loaded.text.splitlines()
    assert transcript.run_here("param", "get", "--hide-type", "/turtlesim", "background_r").text == "12"


def test_invalid_arguments_give_an_error_message(tmp_path: Path) -> None:
    assert (
        transcript.run_here("param", "list", "/turtlesin").text == "Node not found\ndid you mean /turtlesim?"
    )
    near = transcript.run_here("param", "get", "/turtlesim", "backgroundr").text
    assert near.startswith("Parameter not set\ndid you mean background_")
    assert transcript.run_here("param", "describe", "/turtlesim", "nope").exit_code == 1
    missing = transcript.run_here("param", "load", "/turtlesim", str(tmp_path / "none.yaml"))
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
    dumped = transcript.run_here("param", "dump", "/ns/a_node").text
    parameters = yaml.safe_load(dumped)["/ns/a_node"]["ros__parameters"]
    assert parameters["a"]["number"] == 5
    assert "unset" not in parameters
    unset = transcript.run_here("param", "get", "/ns/a_node", "unset")
    assert (unset.text, unset.exit_code) == ("Parameter not set\nit is declared, and has no value", 1)
    file = tmp_path / "parameters.yaml"
    file.write_text(dumped)
    loaded = transcript.run_here("param", "load", "/ns/a_node", str(file)).text
    failed = [line for line in loaded.splitlines() if "failed" in line]
    assert [line.split()[2] for line in failed] == ["start_type_description_service"]  # It is read-only.
    assert transcript.run_here("param", "dump", "/ns/a_node").text == dumped


def test_get_prints_several_parameters_and_those_of_all_nodes() -> None:
    several = transcript.run_here("param", "get", "/turtlesim", "background_r", "background_b")
    assert several.text == "background_r: Integer value is: 69\nbackground_b: Integer value is: 255"
    bare = transcript.run_here("param", "get", "--hide-type", "/turtlesim", "background_r", "background_b")
    assert bare.text == "background_r: 69\nbackground_b: 255"
    everywhere = transcript.run_here("param", "get", "background_r")
    assert everywhere.text == "/turtlesim:\n  Integer value is: 69"
    assert json.loads(transcript.run_here("param", "get", "background_r", "--json").text) == {
        "/turtlesim": 69
    }
    assert json.loads(
        transcript.run_here("param", "get", "/turtlesim", "background_r", "background_g", "--json").text
    ) == {"background_r": 69, "background_g": 86}


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("get",), "name a parameter, or a node and its parameters"),
        (("get", "/turtlesim"), "name the parameters of /turtlesim to print"),
        (("get", "nobodys"), "Parameter not set\nno node has a parameter nobodys"),
        (("get", "/turtlesim", "background_r", "nobodys"), "Parameter not set"),
        (("set", "/turtlesim", "background_r", "1", "background_g"), "background_g has no value"),
        (("set", "/turtlesim", "background_r", "1", "background_r", "2"), "a parameter is given twice"),
    ],
)
def test_wrong_parameters_are_refused(words: tuple[str, ...], reason: str) -> None:
    answer = transcript.run_here("param", *words)
    assert answer.exit_code == 1
    assert answer.text.startswith(reason)


@pytest.mark.usefixtures("turtlesim_to_change")
def test_several_parameters_are_set_each_by_itself_or_all_or_none() -> None:
    words = ("param", "set", "/turtlesim", "background_r", "300", "background_g", "1")
    each = transcript.run_here(*words)
    assert each.exit_code == 1
    assert min(each.text.splitlines()).startswith("background_g: Set parameter successful")
    assert "background_r: Setting parameter failed: " in each.text

    def values() -> str:
        shown = ("param", "get", "--hide-type", "/turtlesim", "background_r", "background_g")
        return transcript.run_here(*shown).text

    assert values() == "background_r: 69\nbackground_g: 1"
    none = transcript.run_here(*words[:-1], "2", "--atomic")
    assert none.exit_code == 1
    assert none.text.startswith("Setting parameters failed: ")
    assert values() == "background_r: 69\nbackground_g: 1"
    both = transcript.run_here(
        "param", "set", "/turtlesim", "background_r", "3", "background_g", "2", "--atomic"
    )
    assert (both.exit_code, both.text) == (0, "Set parameters successful")
    assert values() == "background_r: 3\nbackground_g: 2"
