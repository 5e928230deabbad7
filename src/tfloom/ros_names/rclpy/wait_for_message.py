"""Wait for one message of a topic."""

from typing import TYPE_CHECKING

from tfloom.node.context.utilities import timeout_sec_to_nsec as timeout_sec_to_nsec
from tfloom.node.executing.signals import SignalHandlerGuardCondition as SignalHandlerGuardCondition
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.wait_for_message import *

if TYPE_CHECKING:
    from tfloom.node.node import Node as Node
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Node="tfloom.node.node",
    )
