"""Serialization of messages to bytes and back."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.serialization import deserialize_message as deserialize_message
from tfloom.node.values.serialization import serialize_message as serialize_message

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.type_support import check_for_type_support as check_for_type_support
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        check_for_type_support="tfloom.node.values.type_support",
    )
