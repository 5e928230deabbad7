"""Parameters of a node in another process: read, set, watched, and loaded from files."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program
from tests.node.wire.conftest import PROGRAMS

from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent, ParameterType
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter, parameter_value_to_python
from tfloom.node.qos.qos import ReliabilityPolicy

Start = Callable[..., Program]
Finish = Callable[..., Any]
SpinUntil = Callable[..., None]

TYPES = {
    "bool": (False, ParameterType.PARAMETER_BOOL),
    "integer": (-7, ParameterType.PARAMETER_INTEGER),
    "double": (2.5, ParameterType.PARAMETER_DOUBLE),
    "string": ("other", ParameterType.PARAMETER_STRING),
    "byte_array": ([b"\xff"], ParameterType.PARAMETER_BYTE_ARRAY),
    "bool_array": ([False], ParameterType.PARAMETER_BOOL_ARRAY),
    "integer_array": ([2**62], ParameterType.PARAMETER_INTEGER_ARRAY),
    "double_array": ([1e300, 0.0], ParameterType.PARAMETER_DOUBLE_ARRAY),
    "string_array": (["ä", ""], ParameterType.PARAMETER_STRING_ARRAY),
}


@pytest.fixture(autouse=True)
def local_wire(wire_of_module: str) -> str:
    return wire_of_module


@pytest.fixture
def domain_id(module_domain_id: int, start_program: Start) -> int:
    """Return the module's domain. The test's node ends before its programs; see `domain_id` of tests/conftest.py."""
    return module_domain_id


@pytest.fixture(scope="module")
def remote(wire_of_module: str, start_module_program: Start) -> Iterator[None]:
    """Run a node whose parameters most tests change; none needs to know what others have set."""
    program = start_module_program("python", PROGRAMS / "parameters.py")
    program.wait_for("ready")
    yield
    program.end()


def connected(node: Node, name: str) -> AsyncParameterClient:
    client = AsyncParameterClient(node, name)
    assert client.wait_for_services(timeout_sec=20)
    return client


@pytest.fixture
def client(node: Node, remote: None) -> AsyncParameterClient:
    return connected(node, "/ns/remote")


def values(response: Any) -> list[Any]:
    return [parameter_value_to_python(value) for value in response.values]


def test_values_of_every_type_survive_set_and_get(client: AsyncParameterClient, finish: Finish) -> None:
    types = finish(client.get_parameter_types(list(TYPES))).types
    assert list(types) == [kind for _, kind in TYPES.values()]
    wishes = [Parameter(name, value=value) for name, (value, _) in TYPES.items()]
    results = finish(client.set_parameters(wishes)).results
    assert [(result.successful, result.reason) for result in results] == [(True, "")] * len(TYPES)
    got = values(finish(client.get_parameters(list(TYPES))))
    assert [
        list(value) if kind >= 5 else value for value, (_, kind) in zip(got, TYPES.values(), strict=True)
    ] == [value for value, _ in TYPES.values()]


def test_changes_are_published_to_all_nodes(
    client: AsyncParameterClient, finish: Finish, spin_until: SpinUntil
) -> None:
    events: list[ParameterEvent] = []
    subscription = client.on_parameter_event(events.append)
    spin_until(lambda: subscription.get_publisher_count() == 2)  # this node's event, too
    # The first events may be lost, because a subscription is matched before its publisher sends to it.
    for marker in count(100):
        finish(client.set_parameters([Parameter("integer", value=marker)]))
        if events:
            break
    spin_until(lambda: events[-1].changed_parameters[0].value.integer_value == marker)
    events.clear()
    finish(client.set_parameters([Parameter("integer", value=8), Parameter("unset", value="set")]))
    finish(client.set_parameters([Parameter("free", value="another type")]))
    finish(client.delete_parameters(["free"]))
    finish(client.set_parameters([Parameter("integer", value=13)]))  # rejected: no event
    finish(client.set_parameters_atomically([Parameter("integer", value=1), Parameter("part", value=0.0)]))
    spin_until(lambda: len(events) == 5)
    assert {event.node for event in events} == {"/ns/remote"}
    told = [
        [
            [parameter.name for parameter in event.new_parameters],
            [parameter.name for parameter in event.changed_parameters],
            [parameter.name for parameter in event.deleted_parameters],
        ]
        for event in events
    ]
    assert told == [
        [[], ["integer"], []],
        [["unset"], [], []],
        [[], ["free"], []],
        [[], [], ["free"]],
        [[], ["integer", "part"], []],
    ]
    assert events[0].changed_parameters[0].value.integer_value == 8
    assert events[0].stamp.sec > 0


def test_qos_and_values_come_from_files_and_the_command_line(
    node: Node, start: Start, finish: Finish, spin_until: SpinUntil, tmp_path: Path
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(
        """
/**:
  ros__parameters:
    integer: 1
    qos_overrides:
      /ns/talk:
        publisher:
          reliability: best_effort
          depth: 3
/ns/local:
  ros__parameters:
    integer: 2
    string: from the file
    group: {inner: {deep: 9}}
"""
    )
    renamed = ["-r", "__node:=local", "-r", "chatter:=talk"]
    start("parameters", "--ros-args", "--params-file", path, "-p", "double:=9.5", *renamed)
    client = connected(node, "/ns/local")
    names = ["integer", "string", "double", "group.inner.deep"]
    assert values(finish(client.get_parameters(names))) == [2, "from the file", 9.5, 9]
    spin_until(lambda: node.count_publishers("/ns/talk"))
    (info,) = node.get_publishers_info_by_topic("/ns/talk")
    assert info.qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT
    prefix = "qos_overrides./ns/talk.publisher."
    listed = finish(client.list_parameters()).result.names
    assert [name for name in listed if name.startswith(prefix)] == [
        f"{prefix}{policy}" for policy in ("history", "depth", "reliability")
    ]
    (refused,) = finish(client.set_parameters([Parameter(f"{prefix}depth", value=5)])).results
    assert refused.reason == f"Trying to set a read-only parameter: {prefix}depth."


def test_parameter_file_is_loaded_into_a_running_node(
    client: AsyncParameterClient, finish: Finish, tmp_path: Path
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/ns/remote: {ros__parameters: {integer: 3, limited: 99}}\n")
    results = finish(client.load_parameter_file(str(path))).results
    assert [result.successful for result in results] == [True, False]
    path.write_text("/**: {ros__parameters: {integer: 4, limited: 98}}\n")
    assert not finish(client.load_parameter_file_atomically(str(path), use_wildcard=True)).result.successful
    assert values(finish(client.get_parameters(["integer", "limited"]))) == [3, 4]
