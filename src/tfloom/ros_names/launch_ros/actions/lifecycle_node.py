"""The action that starts a lifecycle node, follows its state and changes it."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode as LifecycleNode
    from tfloom.launch.ros.actions.node import Node as Node
    from tfloom.launch.ros.events.lifecycle.change_state import ChangeState as ChangeState
    from tfloom.launch.ros.events.lifecycle.state_transition import StateTransition as StateTransition
    from tfloom.launch.ros.ros_adapters import get_ros_node as get_ros_node
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        ChangeState="tfloom.launch.ros.events.lifecycle.change_state",
        LifecycleNode="tfloom.launch.ros.actions.lifecycle_node",
        Node="tfloom.launch.ros.actions.node",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        StateTransition="tfloom.launch.ros.events.lifecycle.state_transition",
        get_ros_node="tfloom.launch.ros.ros_adapters",
    )
