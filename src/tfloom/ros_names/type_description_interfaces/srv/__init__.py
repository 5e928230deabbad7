"""The services of type_description_interfaces."""

from tfloom.interfaces.type_description_interfaces.srv import *
from tfloom.interfaces.type_description_interfaces.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from type_description_interfaces.srv import _get_type_description as _get_type_description
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("type_description_interfaces.srv")
