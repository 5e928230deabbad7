"""Launch descriptions in XML files."""

from __future__ import annotations

from tfloom.launch.core.substitution import SomeSubstitutionsType
from tfloom.launch.launch_description_sources.sources import FrontendLaunchDescriptionSource
from tfloom.launch.xml.parser import Parser

__all__ = ["XMLLaunchDescriptionSource"]


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in an XML file.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method="interpreted XML launch file", parser=Parser)
