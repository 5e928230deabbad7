"""List packages and their interfaces."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.get_interfaces import get_action_interfaces as get_action_interfaces
from tfloom.workspace.get_interfaces import get_interface_packages as get_interface_packages
from tfloom.workspace.get_interfaces import get_interface_path as get_interface_path
from tfloom.workspace.get_interfaces import get_interfaces as get_interfaces
from tfloom.workspace.get_interfaces import get_message_interfaces as get_message_interfaces
from tfloom.workspace.get_interfaces import get_service_interfaces as get_service_interfaces

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.workspace.ament import get_resource as get_resource
    from tfloom.workspace.ament import get_resources as get_resources
    from tfloom.workspace.ament import has_resource as has_resource
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        get_resource="tfloom.workspace.ament",
        get_resources="tfloom.workspace.ament",
        has_resource="tfloom.workspace.ament",
    )
