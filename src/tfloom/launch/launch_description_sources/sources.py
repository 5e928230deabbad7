"""Sources of launch descriptions: files in Python, XML and YAML."""

from __future__ import annotations

from tfloom.launch.core.substitution import SomeSubstitutionsType
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.entities.launch_description_source import LaunchDescriptionSource
from tfloom.launch.frontend.parser import Parser
from tfloom.launch.launch_description_sources.loading import (
    get_launch_description_from_any_launch_file,
    get_launch_description_from_frontend_launch_file,
    get_launch_description_from_python_launch_file,
)

__all__ = ["AnyLaunchDescriptionSource", "FrontendLaunchDescriptionSource", "PythonLaunchDescriptionSource"]


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    """The launch description in a file, whose extension decides how it is loaded.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, "interpreted launch file of any language")

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_any_launch_file(location)


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    """The launch description that a Python file's `generate_launch_description()` returns.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, "interpreted python launch file")

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_python_launch_file(location)


class FrontendLaunchDescriptionSource(LaunchDescriptionSource):
    """The launch description in a file that a parser reads.

    Args:
        launch_file_path: Path of the file.
        method: How it is loaded, for people.
        parser: The parser; Parser itself chooses the one for the file's name.
    """

    def __init__(
        self,
        launch_file_path: SomeSubstitutionsType,
        *,
        method: str = "interpreted frontend launch file",
        parser: type[Parser] = Parser,
    ) -> None:
        super().__init__(None, launch_file_path, method)
        self._parser = parser

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_frontend_launch_file(location, parser=self._parser)
