"""Validation of full topic names."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.names import validate_full_topic_name as validate_full_topic_name

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.values.names import InvalidServiceNameException as InvalidServiceNameException
    from tfloom.node.values.names import InvalidTopicNameException as InvalidTopicNameException
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidServiceNameException="tfloom.node.values.names",
        InvalidTopicNameException="tfloom.node.values.names",
    )
