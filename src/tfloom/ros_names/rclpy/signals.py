"""Handlers for SIGINT (Ctrl-C) and SIGTERM."""

from tfloom.node.executing.guard_condition import GuardCondition as GuardCondition
from tfloom.node.executing.signals import *
from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
