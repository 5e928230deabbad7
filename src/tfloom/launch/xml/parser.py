"""The parser of launch files in XML."""

from __future__ import annotations

import os
from typing import TextIO

from tfloom.launch.frontend.file_contents import read_content
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError
from tfloom.launch.frontend.parser import Parser as BaseParser
from tfloom.launch.xml.elements import XmlError, read_elements
from tfloom.launch.xml.entity import Entity

__all__ = ["Parser"]


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
