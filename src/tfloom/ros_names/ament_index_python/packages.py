"""Find packages by name."""

from tfloom.workspace.ament import PackageNotFoundError as PackageNotFoundError
from tfloom.workspace.ament import get_package_prefix as get_package_prefix
from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory
from tfloom.workspace.ament import get_package_share_path as get_package_share_path
from tfloom.workspace.ament import get_packages_with_prefixes as get_packages_with_prefixes
from tfloom.workspace.ament import get_resource as get_resource
from tfloom.workspace.ament import get_resources as get_resources
from tfloom.workspace.ament import get_search_paths as get_search_paths
