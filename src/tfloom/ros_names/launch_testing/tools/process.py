"""Processes that a test starts."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.process import ProcessProxy as ProcessProxy
from tfloom.launch.testing.process import launch_process as launch_process

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.io_handler import ActiveIoHandler as ActiveIoHandler
    from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler as ActiveProcInfoHandler
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ActiveIoHandler="tfloom.launch.testing.io_handler",
        ActiveProcInfoHandler="tfloom.launch.testing.proc_info_handler",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
    )
