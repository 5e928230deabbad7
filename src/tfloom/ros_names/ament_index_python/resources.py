"""Read the resources of the ament index."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.ament import InvalidResourceNameError as InvalidResourceNameError
from tfloom.workspace.ament import InvalidResourceTypeNameError as InvalidResourceTypeNameError
from tfloom.workspace.ament import RESOURCE_INDEX_SUBFOLDER as RESOURCE_INDEX_SUBFOLDER
from tfloom.workspace.ament import get_resource as get_resource
from tfloom.workspace.ament import get_resource_types as get_resource_types
from tfloom.workspace.ament import get_resources as get_resources
from tfloom.workspace.ament import has_resource as has_resource

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.workspace.ament import get_search_paths as get_search_paths
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        get_search_paths="tfloom.workspace.ament",
    )
