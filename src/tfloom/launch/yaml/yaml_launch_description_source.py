"""Launch descriptions in YAML files."""

from __future__ import annotations

from tfloom.launch.core.substitution import SomeSubstitutionsType
from tfloom.launch.launch_description_sources.sources import FrontendLaunchDescriptionSource
from tfloom.launch.yaml.parser import Parser

__all__ = ["YAMLLaunchDescriptionSource"]


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in a YAML file.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method="interpreted YAML launch file", parser=Parser)
