"""Elements of launch files in XML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.xml.entity import Entity as Entity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.frontend.type_utils import check_is_list_entity as check_is_list_entity
    from tfloom.launch.utilities.type_utils import AllowedTypesType as AllowedTypesType
    from tfloom.launch.utilities.type_utils import AllowedValueType as AllowedValueType
    from tfloom.launch.utilities.type_utils import get_typed_value as get_typed_value
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AllowedTypesType="tfloom.launch.utilities.type_utils",
        AllowedValueType="tfloom.launch.utilities.type_utils",
        check_is_list_entity="tfloom.launch.frontend.type_utils",
        get_typed_value="tfloom.launch.utilities.type_utils",
    )
