"""Lifecycle nodes, their publishers and managed entities."""

from tfloom.node.lifecycle.managed_entity import (
    ManagedEntity,
    SimpleManagedEntity,
    TransitionCallbackReturn,
)
from tfloom.node.lifecycle.node import LifecycleNode, LifecycleNodeMixin, LifecycleState
from tfloom.node.lifecycle.node import LifecycleNode as Node
from tfloom.node.lifecycle.node import LifecycleState as State
from tfloom.node.lifecycle.publisher import LifecyclePublisher
from tfloom.node.lifecycle.publisher import LifecyclePublisher as Publisher

__all__ = [
    "LifecycleNode",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "Node",
    "Publisher",
    "SimpleManagedEntity",
    "State",
    "TransitionCallbackReturn",
]
