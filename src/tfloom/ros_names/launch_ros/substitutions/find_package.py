"""Folders of packages as substitutions: `$(find-pkg-prefix NAME)` and `$(find-pkg-share NAME)`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.substitutions.find_package import FindPackage as FindPackage
from tfloom.launch.ros.substitutions.find_package import FindPackagePrefix as FindPackagePrefix
from tfloom.launch.ros.substitutions.find_package import FindPackageShare as FindPackageShare

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        get_package_share_directory="tfloom.workspace.ament",
    )
