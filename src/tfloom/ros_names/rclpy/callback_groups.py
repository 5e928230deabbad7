"""Callback groups: which callbacks may run at the same time."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup as ReentrantCallbackGroup
