"""Launch descriptions in files of any language."""

from __future__ import annotations

from tfloom.launch.launch_description import LaunchDescription
from tfloom.launch.launch_description_source import LaunchDescriptionSource
from tfloom.launch.launch_description_sources.any_launch_file_utilities import (
    get_launch_description_from_any_launch_file,
)
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType

__all__ = ["AnyLaunchDescriptionSource"]


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    """The launch description in a file, whose extension decides how it is loaded.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, "interpreted launch file of any language")

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_any_launch_file(location)
