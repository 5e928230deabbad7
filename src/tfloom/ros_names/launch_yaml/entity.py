"""Elements of launch files in YAML."""

from typing import TYPE_CHECKING

from tfloom.launch.yaml.entity import *

if TYPE_CHECKING:
    from tfloom.launch.frontend.type_utils import check_is_list_entity as check_is_list_entity
    from tfloom.launch.utilities.type_utils import AllowedTypesType as AllowedTypesType
    from tfloom.launch.utilities.type_utils import AllowedValueType as AllowedValueType
    from tfloom.launch.utilities.type_utils import is_instance_of as is_instance_of
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        check_is_list_entity="tfloom.launch.frontend.type_utils",
        AllowedTypesType="tfloom.launch.utilities.type_utils",
        AllowedValueType="tfloom.launch.utilities.type_utils",
        is_instance_of="tfloom.launch.utilities.type_utils",
    )
