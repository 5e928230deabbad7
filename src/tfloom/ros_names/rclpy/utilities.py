"""The default context, and the functions that use it."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.context.utilities import S_TO_NS as S_TO_NS
from tfloom.node.context.utilities import get_available_rmw_implementations as get_available_rmw_implementations
from tfloom.node.context.utilities import get_default_context as get_default_context
from tfloom.node.context.utilities import get_rmw_implementation_identifier as get_rmw_implementation_identifier
from tfloom.node.context.utilities import ok as ok
from tfloom.node.context.utilities import remove_ros_args as remove_ros_args
from tfloom.node.context.utilities import shutdown as shutdown
from tfloom.node.context.utilities import timeout_sec_to_nsec as timeout_sec_to_nsec
from tfloom.node.context.utilities import try_shutdown as try_shutdown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.context.context import Context as Context
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Context="tfloom.node.context.context",
    )
