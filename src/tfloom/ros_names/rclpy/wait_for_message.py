"""Wait for one message of a topic."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.wait_for_message import wait_for_message as wait_for_message

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.context.utilities import timeout_sec_to_nsec as timeout_sec_to_nsec
    from tfloom.node.executing.signals import SignalHandlerGuardCondition as SignalHandlerGuardCondition
    from tfloom.node.node import Node as Node
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Node="tfloom.node.node",
        QoSProfile="tfloom.node.qos.qos",
        SignalHandlerGuardCondition="tfloom.node.executing.signals",
        timeout_sec_to_nsec="tfloom.node.context.utilities",
    )
