"""Types of attributes."""

from typing import TYPE_CHECKING

from tfloom.launch.frontend.type_utils import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.utilities.type_utils import AllowedTypesType as AllowedTypesType
    from tfloom.launch.utilities.type_utils import is_typing_list as is_typing_list
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.frontend.entity",
        AllowedTypesType="tfloom.launch.utilities.type_utils",
        is_typing_list="tfloom.launch.utilities.type_utils",
    )
