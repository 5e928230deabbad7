"""The services of example_interfaces."""

from tfloom.interfaces.example_interfaces.srv import *
from tfloom.interfaces.example_interfaces.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from example_interfaces.srv import _add_two_ints as _add_two_ints
    from example_interfaces.srv import _set_bool as _set_bool
    from example_interfaces.srv import _trigger as _trigger
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("example_interfaces.srv")
