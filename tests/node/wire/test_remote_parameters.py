"""Parameters of one node in another process, which the tests read and leave unchanged."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import Program
from tests.node.wire.conftest import PROGRAMS

from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter

Finish = Callable[..., Any]


@pytest.fixture(autouse=True)
def local_wire(wire_of_module: str) -> str:
    return wire_of_module


@pytest.fixture(scope="module", autouse=True)
def remote(wire_of_module: str, start_module_program: Callable[..., Program]) -> Iterator[None]:
    program = start_module_program("python", PROGRAMS / "parameters.py")
    program.wait_for("ready")
    yield
    program.end()


@pytest.fixture
def domain_id(module_domain_id: int) -> int:
    """Use the domain of the module for each test's node."""
    return module_domain_id


@pytest.fixture
def client(node: Node) -> AsyncParameterClient:
    client = AsyncParameterClient(node, "/ns/remote")
    assert client.wait_for_services(timeout_sec=20)
    return client


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("limited", 12, "Parameter limited out of range. Min: 0, Max: 10, value: 12"),
        (
            "limited",
            3,
            "The parameter value for limited is not a valid step. Min: 0, max: 10, value: 3, step: 2",
        ),
        ("part", 1.5, "Parameter part out of range Min: 0.0, Max: 1.0, value: 1.5"),
        ("fixed", 2, "Trying to set a read-only parameter: fixed."),
        ("integer", "x", "Wrong parameter type, expected 'Type.INTEGER' got 'Type.STRING'"),
        ("integer", 13, "thirteen is unlucky"),
        ("unknown", 1, "Invalid access to undeclared parameter(s): ['unknown']"),
    ],
)
def test_rejection_has_a_reason(
    client: AsyncParameterClient, finish: Finish, name: str, value: object, reason: str
) -> None:
    (before,) = finish(client.get_parameters(["integer"])).values
    good = Parameter("integer", value=6)
    refused, done = finish(client.set_parameters([Parameter(name, value=value), good])).results
    assert (refused.successful, refused.reason) == (False, reason)
    assert done.successful
    assert (
        finish(client.set_parameters([Parameter("integer", value=before.integer_value)]))
        .results[0]
        .successful
    )
    result = finish(client.set_parameters_atomically([good, Parameter(name, value=value)])).result
    assert (result.successful, result.reason) == (False, reason)
    assert finish(client.get_parameters(["integer"])).values == [before]


def test_lists_descriptions_and_unknown_names(client: AsyncParameterClient, finish: Finish) -> None:
    result = finish(client.list_parameters(["group"])).result
    assert (result.names, result.prefixes) == (["group.inner.deep"], ["group.inner"])
    assert finish(client.list_parameters(["group"], depth=1)).result.names == []
    limited, fixed, free = finish(client.describe_parameters(["limited", "fixed", "free"])).descriptors
    assert (limited.name, limited.description, limited.integer_range[0].step) == ("limited", "a number", 2)
    assert (fixed.read_only, free.dynamic_typing) == (True, True)
    assert not finish(client.get_parameters(["integer", "unknown"])).values
    assert not finish(client.get_parameters(["unset"])).values
    assert not finish(client.describe_parameters(["unknown"])).descriptors
