"""The action that starts a lifecycle node, follows its state and changes it."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode as LifecycleNode
