"""Elements of launch files in YAML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.yaml.entity import Entity as Entity
from tfloom.launch.yaml.entity import Places as Places

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.frontend.type_utils import check_is_list_entity as check_is_list_entity
    from tfloom.launch.utilities.type_utils import AllowedTypesType as AllowedTypesType
    from tfloom.launch.utilities.type_utils import AllowedValueType as AllowedValueType
    from tfloom.launch.utilities.type_utils import is_instance_of as is_instance_of
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AllowedTypesType="tfloom.launch.utilities.type_utils",
        AllowedValueType="tfloom.launch.utilities.type_utils",
        check_is_list_entity="tfloom.launch.frontend.type_utils",
        is_instance_of="tfloom.launch.utilities.type_utils",
    )
