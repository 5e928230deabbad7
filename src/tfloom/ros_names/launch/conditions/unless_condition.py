"""A condition that holds where a text is false."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.conditions.unless_condition import UnlessCondition as UnlessCondition

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.conditions.if_condition import IfCondition as IfCondition
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IfCondition="tfloom.launch.conditions.if_condition",
    )
