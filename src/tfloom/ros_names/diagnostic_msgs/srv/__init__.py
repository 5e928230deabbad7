"""The services of diagnostic_msgs."""

from tfloom.interfaces.diagnostic_msgs.srv import *
from tfloom.interfaces.diagnostic_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from diagnostic_msgs.srv import _add_diagnostics as _add_diagnostics
    from diagnostic_msgs.srv import _self_test as _self_test
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("diagnostic_msgs.srv")
