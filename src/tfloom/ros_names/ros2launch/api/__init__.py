"""Search for launch files, print them and launch them."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "InvalidLaunchFileError",
    "InvalidPythonLaunchFileError",
    "LaunchFileNameCompleter",
    "MultipleLaunchFilesError",
    "get_share_file_path_from_package",
    "is_launch_file",
    "launch_a_launch_file",
    "print_a_launch_file",
    "print_arguments_of_launch_description",
    "print_arguments_of_launch_file",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ros2launch.api import api as api
    from tfloom.cli.launch_api import LaunchFileNameCompleter as LaunchFileNameCompleter
    from tfloom.cli.launch_api import MultipleLaunchFilesError as MultipleLaunchFilesError
    from tfloom.cli.launch_api import get_share_file_path_from_package as get_share_file_path_from_package
    from tfloom.cli.launch_api import is_launch_file as is_launch_file
    from tfloom.cli.launch_api import launch_a_launch_file as launch_a_launch_file
    from tfloom.cli.launch_api import print_a_launch_file as print_a_launch_file
    from tfloom.cli.launch_api import print_arguments_of_launch_description as print_arguments_of_launch_description
    from tfloom.cli.launch_api import print_arguments_of_launch_file as print_arguments_of_launch_file
    from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
    from tfloom.launch.launch_description_sources.python_launch_file_utilities import InvalidPythonLaunchFileError as InvalidPythonLaunchFileError
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        InvalidLaunchFileError="tfloom.launch.invalid_launch_file_error",
        InvalidPythonLaunchFileError="tfloom.launch.launch_description_sources.python_launch_file_utilities",
        LaunchFileNameCompleter="tfloom.cli.launch_api",
        MultipleLaunchFilesError="tfloom.cli.launch_api",
        api="ros2launch.api",
        get_share_file_path_from_package="tfloom.cli.launch_api",
        is_launch_file="tfloom.cli.launch_api",
        launch_a_launch_file="tfloom.cli.launch_api",
        print_a_launch_file="tfloom.cli.launch_api",
        print_arguments_of_launch_description="tfloom.cli.launch_api",
        print_arguments_of_launch_file="tfloom.cli.launch_api",
    )
