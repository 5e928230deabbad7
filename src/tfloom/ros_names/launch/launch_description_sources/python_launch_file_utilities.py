"""The loading of launch files in Python."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_sources.python_launch_file_utilities import InvalidPythonLaunchFileError as InvalidPythonLaunchFileError
from tfloom.launch.launch_description_sources.python_launch_file_utilities import get_launch_description_from_python_launch_file as get_launch_description_from_python_launch_file
from tfloom.launch.launch_description_sources.python_launch_file_utilities import load_python_launch_file_as_module as load_python_launch_file_as_module
