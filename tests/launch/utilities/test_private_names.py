"""Names that are private in ROS's launch, and read by the tests of users' launch files."""

from __future__ import annotations

import pytest

from tfloom.launch.actions.event_actions import EmitEvent, Shutdown
from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.conditions import IfCondition
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.entities.launch_description_source import LaunchDescriptionSource
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.ros.actions.composable_nodes import ComposableNodeContainer, LoadComposableNodes
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.composable_node import ComposableNode
from tfloom.launch.ros.parameter_descriptions import ParameterFile, ParameterValue
from tfloom.launch.substitutions.variables import LaunchConfiguration


class Derived(Node):
    """A user's class, with an attribute that is named as one of Node's."""

    def __init__(self) -> None:
        super().__init__(
            package="pkg",
            executable="program",
            name="name",
            namespace="ns",
            arguments=["--flag"],
            remappings=[("from", "to")],
            parameters=[{"a": 1}],
            prefix="gdb",
            respawn=True,
            respawn_delay=1.5,
            condition=IfCondition("true"),
            on_exit=Shutdown(reason="ended"),
        )
        self._Derived__package = "own"


def test_what_a_node_was_constructed_with_has_its_private_names() -> None:
    node = Derived()
    given = ("package", "node_executable", "node_name", "node_namespace", "arguments")
    assert [getattr(node, f"_Node__{name}") for name in given] == ["pkg", "program", "name", "ns", ["--flag"]]
    assert [len(getattr(node, f"_Node__{name}")) for name in ("remappings", "parameters")] == [1, 1]
    assert node._ExecuteLocal__respawn_delay == 1.5
    assert node._ExecuteLocal__process_description._Executable__prefix[0].text == "gdb"
    assert node._Action__condition is node.condition
    assert isinstance(node._ExecuteLocal__on_exit, EmitEvent)
    assert node._ExecuteLocal__on_exit._EmitEvent__event._Shutdown__reason == "ended"
    assert node._Derived__package == "own"


def test_sources_descriptions_and_services_have_their_private_names() -> None:
    source = LaunchDescriptionSource(location="a.launch.py")
    include = IncludeLaunchDescription(source, launch_arguments=[("a", "b")])
    assert vars(include)["_IncludeLaunchDescription__launch_arguments"] == (("a", "b"),)
    assert include._IncludeLaunchDescription__launch_description_source is source
    assert source._LaunchDescriptionSource__location[0].text == "a.launch.py"
    assert LaunchDescription([include])._LaunchDescription__entities == [include]
    service = LaunchService()
    assert service._LaunchService__context is service.context


def test_substitutions_contexts_and_composable_nodes_have_their_private_names() -> None:
    assert LaunchConfiguration("a")._LaunchConfiguration__variable_name[0]._TextSubstitution__text == "a"
    assert LaunchContext()._LaunchContext__launch_configurations == {}
    assert ParameterFile("a.yaml")._ParameterFile__param_file[0].text == "a.yaml"
    assert ParameterValue(1)._ParameterValue__value == 1
    assert Derived()._Node__expanded_node_namespace == Node.UNSPECIFIED_NODE_NAMESPACE
    assert Derived()._Node__expanded_node_name == Node.UNSPECIFIED_NODE_NAME
    node = ComposableNode(
        package="p", plugin="q", name="n", namespace="ns", parameters=[{"a": 1}], remappings=[("b", "c")]
    )
    names = ("package", "node_plugin", "node_name", "node_namespace")
    assert [getattr(node, f"_ComposableNode__{name}")[0].text for name in names] == ["p", "q", "n", "ns"]
    assert node._ComposableNode__parameters is node.parameters
    assert node._ComposableNode__remappings is node.remappings
    nodes = [node]
    loading = LoadComposableNodes(target_container="c", composable_node_descriptions=nodes)
    assert loading._LoadComposableNodes__composable_node_descriptions is nodes
    container = ComposableNodeContainer(
        package="p", executable="e", name="n", namespace="", composable_node_descriptions=nodes
    )
    assert container._ComposableNodeContainer__composable_node_descriptions is nodes


@pytest.mark.parametrize(
    "name", ["_Node__nothing", "_Other__package", "_Nodepackage", "nothing", "__package", "_Node__"]
)
def test_other_names_are_still_absent(name: str) -> None:
    node = Derived()
    assert not hasattr(node, name)
    with pytest.raises(AttributeError, match=f"^'Derived' object has no attribute '{name}'$"):
        getattr(node, name)
