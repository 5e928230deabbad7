"""Checks that a class is a message or service class."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.type_support import check_for_type_support as check_for_type_support
from tfloom.node.values.type_support import check_is_valid_msg_type as check_is_valid_msg_type
from tfloom.node.values.type_support import check_is_valid_srv_type as check_is_valid_srv_type

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.exceptions import NoTypeSupportImportedException as NoTypeSupportImportedException
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        NoTypeSupportImportedException="tfloom.node.values.exceptions",
    )
