"""Launch descriptions in files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "AnyLaunchDescriptionSource",
    "FrontendLaunchDescriptionSource",
    "InvalidFrontendLaunchFileError",
    "InvalidLaunchFileError",
    "InvalidPythonLaunchFileError",
    "PythonLaunchDescriptionSource",
    "get_launch_description_from_any_launch_file",
    "get_launch_description_from_frontend_launch_file",
    "get_launch_description_from_python_launch_file",
    "load_python_launch_file_as_module",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.launch_description_sources import any_launch_description_source as any_launch_description_source
    from launch.launch_description_sources import any_launch_file_utilities as any_launch_file_utilities
    from launch.launch_description_sources import frontend_launch_description_source as frontend_launch_description_source
    from launch.launch_description_sources import frontend_launch_file_utilities as frontend_launch_file_utilities
    from launch.launch_description_sources import python_launch_description_source as python_launch_description_source
    from launch.launch_description_sources import python_launch_file_utilities as python_launch_file_utilities
    from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
    from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
    from tfloom.launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource as AnyLaunchDescriptionSource
    from tfloom.launch.launch_description_sources.any_launch_file_utilities import get_launch_description_from_any_launch_file as get_launch_description_from_any_launch_file
    from tfloom.launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
    from tfloom.launch.launch_description_sources.frontend_launch_file_utilities import get_launch_description_from_frontend_launch_file as get_launch_description_from_frontend_launch_file
    from tfloom.launch.launch_description_sources.python_launch_description_source import PythonLaunchDescriptionSource as PythonLaunchDescriptionSource
    from tfloom.launch.launch_description_sources.python_launch_file_utilities import InvalidPythonLaunchFileError as InvalidPythonLaunchFileError
    from tfloom.launch.launch_description_sources.python_launch_file_utilities import get_launch_description_from_python_launch_file as get_launch_description_from_python_launch_file
    from tfloom.launch.launch_description_sources.python_launch_file_utilities import load_python_launch_file_as_module as load_python_launch_file_as_module
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AnyLaunchDescriptionSource="tfloom.launch.launch_description_sources.any_launch_description_source",
        FrontendLaunchDescriptionSource="tfloom.launch.launch_description_sources.frontend_launch_description_source",
        InvalidFrontendLaunchFileError="tfloom.launch.frontend.parser",
        InvalidLaunchFileError="tfloom.launch.invalid_launch_file_error",
        InvalidPythonLaunchFileError="tfloom.launch.launch_description_sources.python_launch_file_utilities",
        PythonLaunchDescriptionSource="tfloom.launch.launch_description_sources.python_launch_description_source",
        any_launch_description_source="launch.launch_description_sources",
        any_launch_file_utilities="launch.launch_description_sources",
        frontend_launch_description_source="launch.launch_description_sources",
        frontend_launch_file_utilities="launch.launch_description_sources",
        get_launch_description_from_any_launch_file="tfloom.launch.launch_description_sources.any_launch_file_utilities",
        get_launch_description_from_frontend_launch_file="tfloom.launch.launch_description_sources.frontend_launch_file_utilities",
        get_launch_description_from_python_launch_file="tfloom.launch.launch_description_sources.python_launch_file_utilities",
        load_python_launch_file_as_module="tfloom.launch.launch_description_sources.python_launch_file_utilities",
        python_launch_description_source="launch.launch_description_sources",
        python_launch_file_utilities="launch.launch_description_sources",
    )
