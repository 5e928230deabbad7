"""Find packages and their files by the ament index."""

from typing import TYPE_CHECKING

from tfloom.workspace.ament import RESOURCE_INDEX_SUBFOLDER as RESOURCE_INDEX_SUBFOLDER
from tfloom.workspace.ament import InvalidResourceNameError as InvalidResourceNameError
from tfloom.workspace.ament import InvalidResourceTypeNameError as InvalidResourceTypeNameError
from tfloom.workspace.ament import PackageNotFoundError as PackageNotFoundError
from tfloom.workspace.ament import get_package_prefix as get_package_prefix
from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory
from tfloom.workspace.ament import get_package_share_path as get_package_share_path
from tfloom.workspace.ament import get_packages_with_prefixes as get_packages_with_prefixes
from tfloom.workspace.ament import get_resource as get_resource
from tfloom.workspace.ament import get_resource_types as get_resource_types
from tfloom.workspace.ament import get_resources as get_resources
from tfloom.workspace.ament import get_search_paths as get_search_paths
from tfloom.workspace.ament import has_resource as has_resource

if TYPE_CHECKING:
    from ament_index_python import constants as constants
    from ament_index_python import packages as packages
    from ament_index_python import resources as resources
    from ament_index_python import search_paths as search_paths
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ament_index_python")
