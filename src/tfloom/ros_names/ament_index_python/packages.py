"""Find packages by name."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.ament import PackageNotFoundError as PackageNotFoundError
from tfloom.workspace.ament import get_package_prefix as get_package_prefix
from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory
from tfloom.workspace.ament import get_package_share_path as get_package_share_path
from tfloom.workspace.ament import get_packages_with_prefixes as get_packages_with_prefixes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.workspace.ament import get_resource as get_resource
    from tfloom.workspace.ament import get_resources as get_resources
    from tfloom.workspace.ament import get_search_paths as get_search_paths
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        get_resource="tfloom.workspace.ament",
        get_resources="tfloom.workspace.ament",
        get_search_paths="tfloom.workspace.ament",
    )
