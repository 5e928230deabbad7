"""The messages of type_description_interfaces."""

from tfloom.interfaces.type_description_interfaces.msg import *
from tfloom.interfaces.type_description_interfaces.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from type_description_interfaces.msg import _field as _field
    from type_description_interfaces.msg import _field_type as _field_type
    from type_description_interfaces.msg import _individual_type_description as _individual_type_description
    from type_description_interfaces.msg import _key_value as _key_value
    from type_description_interfaces.msg import _type_description as _type_description
    from type_description_interfaces.msg import _type_source as _type_source
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("type_description_interfaces.msg")
