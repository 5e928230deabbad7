"""The parser of launch files in XML, and launch descriptions in them."""

from __future__ import annotations

import os
from typing import TextIO

from tfloom.launch.core.substitution import SomeSubstitutionsType
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, read_content
from tfloom.launch.frontend.parser import Parser as BaseParser
from tfloom.launch.launch_description_sources.sources import FrontendLaunchDescriptionSource
from tfloom.launch.xml.elements import XmlError, read_elements
from tfloom.launch.xml.entity import Entity

__all__ = ["Parser", "XMLLaunchDescriptionSource"]


class Parser(BaseParser):
    """Reads launch files in XML."""

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return `xml`."""
        return {"xml"}

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root of a launch file, and its parser.

        Args:
            file: Its path, or the open file.

        Raises:
            OSError: the file cannot be read.
            InvalidFrontendLaunchFileError: it isn't well-formed XML.
        """
        name, content = read_content(file)
        try:
            return Entity(read_elements(content, name)), cls()
        except XmlError as error:
            message = f"{name}:{error.line}: {error}"
            raise InvalidFrontendLaunchFileError.with_message(message, error) from error


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in an XML file.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method="interpreted XML launch file", parser=Parser)
