"""Nodes in C++ that a container loads: described only, because a container is a C++ program."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.conditions.if_condition import IfCondition as IfCondition
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IfCondition="tfloom.launch.conditions.if_condition",
    )
