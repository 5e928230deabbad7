"""Lifecycle nodes, their publishers and managed entities."""

from typing import TYPE_CHECKING

from tfloom.node.lifecycle.managed_entity import (
    ManagedEntity,
    SimpleManagedEntity,
    TransitionCallbackReturn,
)
from tfloom.node.lifecycle.node import LifecycleNode, LifecycleNodeMixin, LifecycleState
from tfloom.node.lifecycle.node import LifecycleNode as Node
from tfloom.node.lifecycle.node import LifecycleNodeMixin as NodeMixin
from tfloom.node.lifecycle.node import LifecycleState as State
from tfloom.node.lifecycle.publisher import LifecyclePublisher
from tfloom.node.lifecycle.publisher import LifecyclePublisher as Publisher

if TYPE_CHECKING:
    from rclpy.lifecycle import managed_entity, node, publisher
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rclpy.lifecycle")

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
    "managed_entity",
    "node",
    "publisher",
]
