"""Lifecycle nodes, their publishers and managed entities."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.lifecycle.node import LifecycleNode as Node
from tfloom.node.lifecycle.node import LifecycleNodeMixin as NodeMixin
from tfloom.node.lifecycle.node import LifecycleState as State
from tfloom.node.lifecycle.publisher import LifecyclePublisher as Publisher

__all__ = [
    "LifecycleNode",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "Node",
    "NodeMixin",
    "Publisher",
    "SimpleManagedEntity",
    "State",
    "TransitionCallbackReturn",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rclpy.lifecycle import managed_entity as managed_entity
    from rclpy.lifecycle import node as node
    from rclpy.lifecycle import publisher as publisher
    from tfloom.node.lifecycle.managed_entity import ManagedEntity as ManagedEntity
    from tfloom.node.lifecycle.managed_entity import SimpleManagedEntity as SimpleManagedEntity
    from tfloom.node.lifecycle.managed_entity import TransitionCallbackReturn as TransitionCallbackReturn
    from tfloom.node.lifecycle.node import LifecycleNode as LifecycleNode
    from tfloom.node.lifecycle.node import LifecycleNodeMixin as LifecycleNodeMixin
    from tfloom.node.lifecycle.node import LifecycleState as LifecycleState
    from tfloom.node.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LifecycleNode="tfloom.node.lifecycle.node",
        LifecycleNodeMixin="tfloom.node.lifecycle.node",
        LifecyclePublisher="tfloom.node.lifecycle.publisher",
        LifecycleState="tfloom.node.lifecycle.node",
        ManagedEntity="tfloom.node.lifecycle.managed_entity",
        SimpleManagedEntity="tfloom.node.lifecycle.managed_entity",
        TransitionCallbackReturn="tfloom.node.lifecycle.managed_entity",
        managed_entity="rclpy.lifecycle",
        node="rclpy.lifecycle",
        publisher="rclpy.lifecycle",
    )
