"""Validation of node names."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.names import validate_node_name as validate_node_name

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.names import InvalidNodeNameException as InvalidNodeNameException
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidNodeNameException="tfloom.node.values.names",
    )
