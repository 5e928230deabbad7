"""Search for launch files, print them and launch them."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.cli.launch_api import LaunchFileNameCompleter as LaunchFileNameCompleter
from tfloom.cli.launch_api import MultipleLaunchFilesError as MultipleLaunchFilesError
from tfloom.cli.launch_api import get_launch_file_paths as get_launch_file_paths
from tfloom.cli.launch_api import get_share_file_path_from_package as get_share_file_path_from_package
from tfloom.cli.launch_api import is_launch_file as is_launch_file
from tfloom.cli.launch_api import launch_a_launch_file as launch_a_launch_file
from tfloom.cli.launch_api import parse_launch_arguments as parse_launch_arguments
from tfloom.cli.launch_api import print_a_launch_file as print_a_launch_file
from tfloom.cli.launch_api import print_arguments_of_launch_description as print_arguments_of_launch_description
from tfloom.cli.launch_api import print_arguments_of_launch_file as print_arguments_of_launch_file
from tfloom.workspace.ament import PackageNotFoundError as PackageNotFoundError
from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_description_sources.any_launch_file_utilities import get_launch_description_from_any_launch_file as get_launch_description_from_any_launch_file
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
        get_launch_description_from_any_launch_file="tfloom.launch.launch_description_sources.any_launch_file_utilities",
    )
