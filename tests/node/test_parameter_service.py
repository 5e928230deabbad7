"""The services that every node has, and their clients."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.interfaces.rcl_interfaces.msg import IntegerRange, LoggerLevel, ParameterDescriptor
from tfloom.interfaces.rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.turtlesim.srv import Spawn
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter, parameter_value_to_python
from tfloom.rosidl.registry import find_class

MakeNode = Callable[..., Node]
Finish = Callable[[Future[Any]], Any]


@pytest.fixture
def remote(make_node: MakeNode, executor: SingleThreadedExecutor) -> Node:
    remote = make_node("remote", namespace="/ns")
    limits = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=1)])
    remote.declare_parameter("a.number", 5, limits)
    remote.declare_parameter("free", "text", ParameterDescriptor(dynamic_typing=True))
    executor.add_node(remote)
    return remote


@pytest.fixture
def client(remote: Node, node: Node, executor: SingleThreadedExecutor) -> AsyncParameterClient:
    executor.add_node(node)
    client = AsyncParameterClient(node, "/ns/remote")
    assert client.wait_for_services(timeout_sec=5)
    assert client.services_are_ready()
    return client


def test_every_node_has_parameter_services(remote: Node) -> None:
    names = [service.service_name for service in remote.services]
    assert names == [
        f"/ns/remote/{name}"
        for name in (
            "describe_parameters",
            "get_parameters",
            "get_parameter_types",
            "list_parameters",
            "set_parameters",
            "set_parameters_atomically",
            "get_type_description",
        )
    ]


def test_parameter_services_can_be_disabled(make_node: MakeNode) -> None:
    arguments = ["--ros-args", "-p", "start_type_description_service:=false"]
    assert not list(make_node(start_parameter_services=False, cli_args=arguments).services)


def test_parameters_are_read(client: AsyncParameterClient, finish: Finish) -> None:
    listed = finish(client.list_parameters()).result.names
    assert listed == ["use_sim_time", "start_type_description_service", "a.number", "free"]
    assert finish(client.list_parameters(["a"], 1)).result.names == ["a.number"]
    values = finish(client.get_parameters(["a.number", "free"])).values
    assert [parameter_value_to_python(value) for value in values] == [5, "text"]
    assert list(finish(client.get_parameter_types(["a.number"])).types) == [2]
    (descriptor,) = finish(client.describe_parameters(["a.number"])).descriptors
    assert descriptor.integer_range[0].to_value == 10
    assert finish(client.get_parameters(["nope"])).values == []
    assert list(finish(client.get_parameter_types(["nope"])).types) == []
    assert finish(client.describe_parameters(["nope"])).descriptors == []


def test_parameters_are_set(client: AsyncParameterClient, remote: Node, finish: Finish) -> None:
    called: list[Future[Any]] = []
    wishes = [Parameter("a.number", value=value) for value in (7, 70, "x")] + [Parameter("nope", value=1)]
    results = finish(client.set_parameters(wishes, callback=called.append)).results
    assert [result.successful for result in results] == [True, False, False, False]
    assert "out of range" in results[1].reason
    assert "Wrong parameter type" in results[2].reason
    assert "undeclared" in results[3].reason
    assert remote.get_parameter("a.number").value == 7
    result = finish(client.set_parameters_atomically([wishes[0], wishes[1]])).result
    assert not result.successful
    assert [
        result.successful for result in finish(client.delete_parameters(["free", "a.number"])).results
    ] == [
        True,
        False,
    ]
    assert not remote.has_parameter("free")


def test_parameter_file_is_loaded(
    client: AsyncParameterClient, remote: Node, finish: Finish, tmp_path: Path
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/ns/remote: {ros__parameters: {a: {number: 3}}}\n")
    assert finish(client.load_parameter_file(str(path))).results[0].successful
    assert remote.get_parameter("a.number").value == 3
    path.write_text("/**: {ros__parameters: {a: {number: 99}}}\n")
    assert not finish(client.load_parameter_file_atomically(str(path), use_wildcard=True)).result.successful
    with pytest.raises(RuntimeError, match="Param file does not contain selected parameters"):
        client.load_parameter_file(str(path))


def test_load_file_of_other_nodes(
    client: AsyncParameterClient, remote: Node, finish: Finish, tmp_path: Path
) -> None:
    path = tmp_path / "p.yaml"
    other = "/somebody/else: {ros__parameters: {a: {number: 4}}}\n"
    path.write_text(other)
    assert finish(client.load_parameter_file(str(path))).results[0].successful
    assert remote.get_parameter("a.number").value == 4
    path.write_text("/*/remote: {ros__parameters: {a: {number: 5}}}\n" + other)
    assert finish(client.load_parameter_file(str(path))).results[0].successful
    assert remote.get_parameter("a.number").value == 5


def test_logger_levels_are_read_and_set(
    make_node: MakeNode, node: Node, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    remote = make_node("chatty", enable_logger_service=True)
    executor.add_node(remote)
    executor.add_node(node)
    set_client = node.create_client(SetLoggerLevels, "/chatty/set_logger_levels")
    get_client = node.create_client(GetLoggerLevels, "/chatty/get_logger_levels")
    assert set_client.wait_for_service(5)
    assert get_client.wait_for_service(5)
    before = finish(get_client.call_async(GetLoggerLevels.Request(names=["chatty"])))
    assert before.levels[0].level == 0  # none was set
    levels = [LoggerLevel(name="chatty", level=10), LoggerLevel(name="chatty", level=11)]
    results = finish(set_client.call_async(SetLoggerLevels.Request(levels=levels))).results
    assert [result.successful for result in results] == [True, False]
    assert results[1].reason == "Failed reason: Invalid logger level."
    assert finish(get_client.call_async(GetLoggerLevels.Request(names=["chatty"]))).levels[0].level == 10


def test_type_descriptions_are_returned(
    remote: Node, node: Node, executor: SingleThreadedExecutor, finish: Finish
) -> None:
    executor.add_node(node)
    client = node.create_client(GetTypeDescription, "/ns/remote/get_type_description")
    assert client.wait_for_service(5)
    request = GetTypeDescription.Request(type_name="geometry_msgs/msg/Twist", include_type_sources=True)
    response = finish(client.call_async(request))
    assert response.successful, response.failure_reason
    description = response.type_description
    assert [field.name for field in description.type_description.fields] == ["linear", "angular"]
    assert [referenced.type_name for referenced in description.referenced_type_descriptions] == [
        "geometry_msgs/msg/Vector3"
    ]
    assert [source.type_name for source in response.type_sources] == [
        "geometry_msgs/msg/Twist",
        "geometry_msgs/msg/Vector3",
    ]
    assert "Vector3 linear" in response.type_sources[0].raw_file_contents
    assert "float64 x" in response.type_sources[1].raw_file_contents
    for bad in (
        GetTypeDescription.Request(type_name="no/msg/Such"),
        GetTypeDescription.Request(type_name="nonsense"),
        GetTypeDescription.Request(type_name=String._TYPE_NAME, type_hash="RIHS01_00"),
    ):
        answer = finish(client.call_async(bad))
        assert not answer.successful
        assert answer.failure_reason


def test_type_descriptions_of_parts_and_custom_types_are_returned(
    remote: Node,
    node: Node,
    executor: SingleThreadedExecutor,
    finish: Finish,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The topics of actions and of service events have such types; tools request them by name."""
    own = tmp_path / "share" / "own_described" / "msg"
    own.mkdir(parents=True)
    (own / "Mine.msg").write_text("std_msgs/Header header\n", "utf-8")
    (own / "Broken.msg").write_text("int32\n", "utf-8")
    (own / "Latin.msg").write_bytes(b"int32 a # \xe4\n")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    executor.add_node(node)
    client = node.create_client(GetTypeDescription, "/ns/remote/get_type_description")
    assert client.wait_for_service(5)

    def ask(name: str) -> Any:
        return finish(client.call_async(GetTypeDescription.Request(type_name=name)))

    encodings = {
        name: [source.encoding for source in ask(name).type_sources[:2]]
        for name in (
            "own_described/msg/Mine",
            "turtlesim/srv/Spawn",
            "turtlesim/srv/Spawn_Event",
            "turtlesim/action/RotateAbsolute",
            "turtlesim/action/RotateAbsolute_SendGoal",
            "turtlesim/action/RotateAbsolute_FeedbackMessage",
        )
    }
    assert encodings == {
        "own_described/msg/Mine": ["msg", "msg"],
        "turtlesim/srv/Spawn": ["srv", "msg"],
        "turtlesim/srv/Spawn_Event": ["implicit", "msg"],
        "turtlesim/action/RotateAbsolute": ["action", "msg"],
        "turtlesim/action/RotateAbsolute_SendGoal": ["implicit", "msg"],
        "turtlesim/action/RotateAbsolute_FeedbackMessage": ["implicit", "implicit"],
    }
    for name in ("own_described/msg/Broken", "own_described/msg/Latin", "turtlesim/srv/Spawn_Nothing"):
        answer = ask(name)
        assert not answer.successful
        assert answer.failure_reason
    assert find_class("turtlesim/srv/Spawn") is Spawn  # not another type of the same name
