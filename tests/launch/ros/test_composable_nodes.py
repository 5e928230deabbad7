"""Composable nodes: the requests that load them, sent to a container that a test has in place of a C++ program."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from tests.launch.ros.conftest import make_package

from tfloom.interfaces.composition_interfaces.srv import LoadNode
from tfloom.launch.actions.group_action import GroupAction
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.conditions import IfCondition
from tfloom.launch.ros.actions.composable_nodes import (
    ComposableNodeContainer,
    LoadComposableNodes,
    get_composable_node_load_request,
)
from tfloom.launch.ros.actions.node_defaults import (
    PushROSNamespace,
    SetParameter,
    SetParametersFromFile,
    SetRemap,
)
from tfloom.launch.ros.composable_node import ComposableNode
from tfloom.launch.ros.utilities.names import get_node_name_count
from tfloom.node.context.context import Context
from tfloom.node.endpoints.client import Client, NoResponseError
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node

Launch = Callable[..., Any]
TEXT = TextSubstitution


class Container(Node):
    """Takes requests as a container does, and answers that it has loaded the nodes; but not those named `broken`."""

    def __init__(self, context: Context) -> None:
        super().__init__("container", context=context)
        self.requests: list[LoadNode.Request] = []
        self.create_service(LoadNode, "~/_container/load_node", self._load)

    def _load(self, request: LoadNode.Request, response: LoadNode.Response) -> LoadNode.Response:
        self.requests.append(request)
        response.success = request.node_name != "broken"
        response.error_message = "" if response.success else "no such plug-in"
        if response.success:
            response.full_node_name = f"{request.node_namespace.rstrip('/')}/{request.node_name}"
        return response


@pytest.fixture
def container(monkeypatch: pytest.MonkeyPatch, ros_domain: int) -> Iterator[Container]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", str(ros_domain))
    context = Context()
    context.init(args=[], domain_id=ros_domain)
    node = Container(context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    thread = Thread(target=executor.spin)
    thread.start()
    yield node
    executor.shutdown()
    thread.join()
    node.destroy_node()
    context.try_shutdown()


def load(*nodes: ComposableNode, target: Any = "/container") -> LoadComposableNodes:
    return LoadComposableNodes(composable_node_descriptions=list(nodes), target_container=target)


def node(name: str = "n", **kwargs: Any) -> ComposableNode:
    return ComposableNode(package="some_package", plugin="some::Plugin", name=name, **kwargs)


def test_container_that_leaves_while_it_loads_is_told(
    launch: Launch, container: Container, monkeypatch: pytest.MonkeyPatch
) -> None:
    def call_async(client: Client[Any, Any], _request: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_exception(
            NoResponseError(f"no response from {client.srv_name}: its server left the graph")
        )
        return future

    monkeypatch.setattr(Client, "call_async", call_async)
    ran = launch(load(node("first"), node("second")))
    text = "no response from /container/_container/load_node: its server left the graph"
    assert ran.lines == [f"[ERROR] [launch_ros.actions.load_composable_nodes]: {text}"]
    assert not container.requests


def test_nodes_are_loaded_in_order(launch: Launch, container: Container) -> None:
    ran = launch(load(node("first"), node("second", namespace="ns")))
    assert ran.code == 0
    assert ran.lines == [
        f"[INFO] [launch_ros.actions.load_composable_nodes]: Loaded node '{name}' in container '/container'"
        for name in ("/first", "/ns/second")
    ]
    first, second = container.requests
    assert (first.package_name, first.plugin_name, first.node_name) == (
        "some_package",
        "some::Plugin",
        "first",
    )
    assert (first.node_namespace, second.node_namespace) == ("", "/ns")
    assert not first.parameters
    assert not first.remap_rules
    assert not first.extra_arguments
    assert get_node_name_count(ran.service.context, "/ns/second") == 1


def test_a_node_that_cannot_be_loaded_is_reported_and_the_next_one_is_loaded(
    launch: Launch, container: Container
) -> None:
    ran = launch(load(node("broken"), node("next"), node("next")))
    assert ran.code == 0
    assert (
        "[ERROR] [launch_ros.actions.load_composable_nodes]: Failed to load node 'broken' of type 'some::Plugin' in "
        "container '/container': no such plug-in"
    ) in ran.lines
    assert (
        "[WARNING] [/container]: there are now at least 2 nodes with the name /next created within this launch context"
    ) in ran.lines


def test_a_launch_without_its_container_ends_at_the_shutdown(
    launch: Launch, container: Container, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tfloom.launch.actions.event_actions import Shutdown
    from tfloom.launch.actions.timer_action import TimerAction

    ran = launch(
        load(node(), target="/nowhere"), TimerAction(period=0.2, actions=[Shutdown(reason="enough")])
    )
    assert ran.code == 0
    assert (
        "[WARNING] [launch_ros.actions.load_composable_nodes]: Abandoning wait for the '/nowhere/_container/load_node' "
        "service, due to shutdown."
    ) in ran.lines


def values(parameters: Any) -> dict[str, Any]:
    from tfloom.node.parameters.parameter import Parameter

    return {parameter.name: Parameter.from_parameter_msg(parameter).value for parameter in parameters}


def test_a_request_has_what_the_node_and_its_surroundings_say(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/outer/inner/n: {ros__parameters: {of_node: 1}}\n/**: {ros__parameters: {of_all: 2}}\n")
    context = LaunchContext()
    for action in (
        PushROSNamespace("outer"),
        SetParameter("set", value=True),
        SetParametersFromFile(str(path)),
        SetRemap("a", "b"),
    ):
        action.visit(context)
    request = get_composable_node_load_request(
        node(
            [TEXT(text="n")],
            namespace="inner",
            parameters=[{"group": {"list": [1.5, 2.5], "text": "x"}}, {"of_all": 3}],
            remappings=[("c", TEXT(text="d"))],
            extra_arguments=[{"use_intra_process_comms": True}],
        ),
        context,
    )
    assert request is not None
    assert (request.node_name, request.node_namespace) == ("n", "/outer/inner")
    assert request.remap_rules == ["a:=b", "c:=d"]
    assert values(request.parameters) == {
        "set": True,
        "of_node": 1,
        "of_all": 3,
        "group.list": [1.5, 2.5],
        "group.text": "x",
    }
    assert values(request.extra_arguments) == {"use_intra_process_comms": True}


def test_a_node_whose_condition_does_not_hold_is_not_loaded(launch: Launch, container: Container) -> None:
    never = node("never", condition=IfCondition("false"))
    assert get_composable_node_load_request(never, LaunchContext()) is None
    launch(load(never, node("always", condition=IfCondition("true"))), load(never))
    assert [request.node_name for request in container.requests] == ["always"]


def test_a_container_that_is_a_program_here_is_started_and_asked(
    launch: Launch, container: Container, toys: Path
) -> None:
    make_package(toys, "toys", container="#!/bin/sh\n")
    ran = launch(
        GroupAction(
            [
                ComposableNodeContainer(
                    package="toys",
                    executable="container",
                    name="container",
                    namespace="/",
                    composable_node_descriptions=[node("inside")],
                )
            ]
        )
    )
    assert ran.code == 0, ran.lines
    assert any("Loaded node '/inside' in container '/container'" in line for line in ran.lines)


def test_a_container_needs_a_name_and_a_launch(launch: Launch) -> None:
    absent = ComposableNodeContainer(name="c", namespace="", package="nothere", executable="container")
    assert launch(load(node(), target=absent)).code == 1
    with pytest.raises(RuntimeError, match="no LaunchService runs"):
        load(node()).execute(LaunchContext())
    with pytest.raises(TypeError, match="'LoadComposableNodes' expected 'target_container'"):
        load(node(), target=7)
