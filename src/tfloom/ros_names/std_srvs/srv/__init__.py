"""The services of std_srvs."""

from tfloom.interfaces.std_srvs.srv import *
from tfloom.interfaces.std_srvs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from std_srvs.srv import _empty as _empty
    from std_srvs.srv import _set_bool as _set_bool
    from std_srvs.srv import _trigger as _trigger
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("std_srvs.srv")
