"""Launch descriptions in Python files."""

from __future__ import annotations

from tfloom.launch.launch_description import LaunchDescription
from tfloom.launch.launch_description_source import LaunchDescriptionSource
from tfloom.launch.launch_description_sources.python_launch_file_utilities import (
    get_launch_description_from_python_launch_file,
)
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType

__all__ = ["PythonLaunchDescriptionSource"]


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    """The launch description that a Python file's `generate_launch_description()` returns.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, "interpreted python launch file")

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_python_launch_file(location)
