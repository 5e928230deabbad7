"""Guard conditions: callbacks that the program triggers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.guard_condition import GuardCondition as GuardCondition

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.context.utilities import get_default_context as get_default_context
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        get_default_context="tfloom.node.context.utilities",
    )
