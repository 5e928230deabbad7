"""Find packages and their files by the ament index."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "InvalidResourceNameError",
    "InvalidResourceTypeNameError",
    "PackageNotFoundError",
    "RESOURCE_INDEX_SUBFOLDER",
    "get_package_prefix",
    "get_package_share_directory",
    "get_package_share_path",
    "get_packages_with_prefixes",
    "get_resource",
    "get_resource_types",
    "get_resources",
    "get_search_paths",
    "has_resource",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_index_python import constants as constants
    from ament_index_python import packages as packages
    from ament_index_python import resources as resources
    from ament_index_python import search_paths as search_paths
    from tfloom.workspace.ament import InvalidResourceNameError as InvalidResourceNameError
    from tfloom.workspace.ament import InvalidResourceTypeNameError as InvalidResourceTypeNameError
    from tfloom.workspace.ament import PackageNotFoundError as PackageNotFoundError
    from tfloom.workspace.ament import RESOURCE_INDEX_SUBFOLDER as RESOURCE_INDEX_SUBFOLDER
    from tfloom.workspace.ament import get_package_prefix as get_package_prefix
    from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory
    from tfloom.workspace.ament import get_package_share_path as get_package_share_path
    from tfloom.workspace.ament import get_packages_with_prefixes as get_packages_with_prefixes
    from tfloom.workspace.ament import get_resource as get_resource
    from tfloom.workspace.ament import get_resource_types as get_resource_types
    from tfloom.workspace.ament import get_resources as get_resources
    from tfloom.workspace.ament import get_search_paths as get_search_paths
    from tfloom.workspace.ament import has_resource as has_resource
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidResourceNameError="tfloom.workspace.ament",
        InvalidResourceTypeNameError="tfloom.workspace.ament",
        PackageNotFoundError="tfloom.workspace.ament",
        RESOURCE_INDEX_SUBFOLDER="tfloom.workspace.ament",
        constants="ament_index_python",
        get_package_prefix="tfloom.workspace.ament",
        get_package_share_directory="tfloom.workspace.ament",
        get_package_share_path="tfloom.workspace.ament",
        get_packages_with_prefixes="tfloom.workspace.ament",
        get_resource="tfloom.workspace.ament",
        get_resource_types="tfloom.workspace.ament",
        get_resources="tfloom.workspace.ament",
        get_search_paths="tfloom.workspace.ament",
        has_resource="tfloom.workspace.ament",
        packages="ament_index_python",
        resources="ament_index_python",
        search_paths="ament_index_python",
    )
