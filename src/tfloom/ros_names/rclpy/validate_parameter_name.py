"""Validation of parameter names."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.parameters.validate_parameter_name import validate_parameter_name as validate_parameter_name

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.parameters.exceptions import InvalidParameterException as InvalidParameterException
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidParameterException="tfloom.node.parameters.exceptions",
    )
