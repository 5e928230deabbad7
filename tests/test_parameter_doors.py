"""A parameter's value keeps its type and its text from where it is written to where it is read, through each door."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.awkward_values import EMPTY_LISTS, TEXTS, VALUES
from tests.cli import transcript
from tests.viewer.conftest import running_node, spinning

from tfloom.cli.api.param import call_set_parameters, load_parameter_file
from tfloom.cli.shared.interfaces import fill_message, parse_yaml
from tfloom.interfaces.rcl_interfaces.msg import Parameter as ParameterMsg
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue
from tfloom.interfaces.std_msgs.msg import String
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.parameter_descriptions import ParameterValue as LaunchValue
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters, to_parameters_list
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.client_library import init, spin_until_future_complete, try_shutdown
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import (
    Parameter,
    ParameterType,
    get_parameter_value,
    parameter_dict_from_yaml_file,
)
from tfloom.node.values.value_text import value_text
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.viewer.parameters import Parameters

PARAMETERS = [
    *(Parameter(name, value=value) for name, value in VALUES.items()),
    *(Parameter(name, ParameterType[kind], []) for name, kind in EMPTY_LISTS.items()),
]
EXPECTED = {parameter.name: repr(parameter) for parameter in PARAMETERS}


def declare(node: Node, name: str | None = None) -> None:
    """Declare the parameters by their types, without values."""
    for parameter in PARAMETERS:
        if name in (None, parameter.name):
            node.declare_parameter(parameter.name, parameter.type_)


def held(node: Node) -> dict[str, str]:
    """Return what a node holds, types included."""
    return {name: repr(node.get_parameter_or(name)) for name in EXPECTED}


@pytest.fixture
def written(domain_id: int) -> Iterator[Node]:
    """Return a node that has the values."""
    with running_node(domain_id, "written") as node:
        declare(node)
        assert all(result.successful for result in node.set_parameters(PARAMETERS))
        with spinning(node):
            yield node


@pytest.fixture
def read(domain_id: int) -> Iterator[Node]:
    """Return a node that has none of the values yet."""
    with running_node(domain_id, "read") as node:
        declare(node)
        with spinning(node):
            yield node


@pytest.fixture
def caller(domain_id: int) -> Iterator[Node]:
    init(args=[], domain_id=domain_id)  # the functions spin it in the executor of the default context
    node = Node("caller")
    yield node
    node.destroy_node()
    try_shutdown()


@pytest.fixture
def dumped(written: Node, tmp_path: Path) -> Path:
    """Return the file of `ros2 param dump`, for the node /read."""
    path = tmp_path / "parameters.yaml"
    text = transcript.run_here("param", "dump", "/written").text
    text = text.replace("/written:", "/read:", 1).replace("    start_type_description_service: true\n", "")
    path.write_text(f"{text}\n", "utf-8", newline="")
    return path


def test_a_dump_is_loaded_by_the_command(dumped: Path, read: Node) -> None:
    loaded = transcript.run_here("param", "load", "/read", str(dumped))
    assert loaded.exit_code == 0, loaded.text
    assert held(read) == EXPECTED


@pytest.mark.parametrize("function", ["load_parameter_file", "load_parameter_file_atomically"])
def test_a_dump_is_loaded_by_a_client(dumped: Path, read: Node, caller: Node, function: str) -> None:
    client = AsyncParameterClient(caller, "/read")
    assert client.wait_for_services(20.0)
    called = threading.Event()
    future = getattr(client, function)(str(dumped), callback=lambda _: called.set())
    spin_until_future_complete(caller, future, timeout_sec=20.0)
    response = future.result()
    results = response.results if function == "load_parameter_file" else [response.result]
    assert all(result.successful for result in results)
    assert called.is_set()
    assert held(read) == EXPECTED


def test_the_error_of_a_load_comes_from_its_future(dumped: Path, read: Node, caller: Node) -> None:
    client = AsyncParameterClient(caller, "/read")
    assert client.wait_for_services(20.0)
    future = client.load_parameter_file(str(dumped))
    for one in client._clients():
        caller.destroy_client(one)
    spin_until_future_complete(caller, future, timeout_sec=0.2)
    assert future.cancelled()
    assert not future.done()


@pytest.mark.usefixtures("written")
def test_a_dump_is_loaded_by_the_commands_functions(dumped: Path, read: Node, caller: Node) -> None:
    load_parameter_file(node=caller, node_name="/read", parameter_file=str(dumped), use_wildcard=False)
    assert held(read) == EXPECTED


def test_a_dump_is_the_file_of_a_node_and_a_dictionary(dumped: Path, domain_id: int) -> None:
    arguments = ["--ros-args", "-r", "__node:=read", "--params-file", str(dumped)]
    with running_node(domain_id, "one", cli_args=arguments) as node:
        declare(node)
        assert held(node) == EXPECTED
    found = {
        name: repr(Parameter.from_parameter_msg(message))
        for name, message in parameter_dict_from_yaml_file(dumped, target_nodes=["/read"]).items()
    }
    assert {name: found[name] for name in VALUES} == {name: EXPECTED[name] for name in VALUES}


def test_texts_of_the_command_line(domain_id: int) -> None:
    rules = [f"{parameter.name}:={value_text(parameter.value)}" for parameter in PARAMETERS]
    arguments = ["--ros-args", *(word for rule in rules for word in ("-p", rule))]
    with running_node(domain_id, "read", cli_args=arguments) as node:
        declare(node)
        assert held(node) == EXPECTED


def test_texts_are_set_by_the_commands_functions(read: Node, caller: Node) -> None:
    messages = [
        ParameterMsg(name=parameter.name, value=get_parameter_value(value_text(parameter.value)))
        for parameter in PARAMETERS
    ]
    given = repr(messages)
    response = call_set_parameters(node=caller, node_name="/read", parameters=messages)
    assert all(result.successful for result in response.results)
    assert held(read) == EXPECTED
    assert repr(messages) == given


@pytest.mark.parametrize("name", ["text19", "texts", "infinities", "octets", *EMPTY_LISTS])
def test_texts_are_set_by_the_command(read: Node, name: str) -> None:
    (parameter,) = [parameter for parameter in PARAMETERS if parameter.name == name]
    done = transcript.run_here("param", "set", "/read", name, value_text(parameter.value))
    assert done.text == "Set parameter successful"
    assert held(read)[name] == EXPECTED[name]


def test_what_the_page_shows_is_what_it_takes(written: Node, read: Node, domain_id: int) -> None:
    participant = open_participant(domain_id)
    name = NodeName("/", "page")
    participant.add_node(name)
    panel = Parameters(participant, name)

    def ask(command: dict[str, Any]) -> dict[str, Any]:
        answers: list[dict[str, Any]] = []
        is_there = threading.Event()
        panel.ask(command, lambda answer: (answers.append(answer), is_there.set()))
        assert is_there.wait(20.0)
        return answers[0]

    try:
        rows = ask({"op": "parameters", "node": "/written"})["parameters"]["values"]
        for row in rows:
            if row["name"] in EXPECTED:
                command = {"op": "set_parameter", "node": "/read", "name": row["name"], "value": row["value"]}
                assert "done" in ask(command), row
    finally:
        panel.close()
        participant.close()
    assert held(read) == EXPECTED


@pytest.mark.parametrize("is_described", [False, True])
def test_values_of_a_launch_reach_a_composable_node(is_described: bool) -> None:
    given = {
        name: LaunchValue(value, value_type=str) if is_described and isinstance(value, str) else value
        for name, value in VALUES.items()
        if name != "octets"  # launch files have no bytes
    }
    context = LaunchContext()
    evaluated = evaluate_parameters(context, normalize_parameters([given]))
    found = {
        parameter.name: repr(parameter) for parameter in to_parameters_list(context, "read", "/", evaluated)
    }
    assert found == {name: EXPECTED[name] for name in given}


@pytest.mark.parametrize("text", TEXTS, ids=repr)
def test_what_is_echoed_can_be_published(text: str) -> None:
    for flow_style in (False, True):
        read = String()
        fill_message(read, parse_yaml(message_to_yaml(String(data=text), flow_style=flow_style)))
        assert read.data == text
    value = ParameterValue(type=4, string_value=text, string_array_value=[text, ""])
    again = ParameterValue()
    fill_message(again, parse_yaml(message_to_yaml(value)))
    assert again == value
