"""The action that would start a container of nodes in C++."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.composable_node_container import (
        ComposableNodeContainer as ComposableNodeContainer,
    )
    from tfloom.launch.ros.actions.node import Node as Node
    from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        ComposableNode="tfloom.launch.ros.descriptions.composable_node",
        ComposableNodeContainer="tfloom.launch.ros.actions.composable_node_container",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        Node="tfloom.launch.ros.actions.node",
        Parser="tfloom.launch.frontend.parser",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        expose_action="tfloom.launch.frontend.expose",
    )
