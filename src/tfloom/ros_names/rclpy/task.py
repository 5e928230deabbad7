"""Futures and tasks."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.task import Future as Future
from tfloom.node.executing.task import Task as Task
from tfloom.node.executing.task import TaskRunner as TaskRunner
