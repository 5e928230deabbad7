"""The parser of launch files in YAML, and launch descriptions in them."""

from __future__ import annotations

import os
from typing import TextIO

from tfloom.launch.core.substitution import SomeSubstitutionsType
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, read_content
from tfloom.launch.frontend.parser import Parser as BaseParser
from tfloom.launch.launch_description_sources.sources import FrontendLaunchDescriptionSource
from tfloom.launch.yaml.entity import Entity, Places

__all__ = ["Parser", "YAMLLaunchDescriptionSource"]


class Parser(BaseParser):
    """Reads launch files in YAML."""

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return `yaml` and `yml`."""
        return {"yaml", "yml"}

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root of a launch file, and its parser.

        Args:
            file: Its path, or the open file.

        Raises:
            OSError: the file cannot be read.
            InvalidFrontendLaunchFileError: it isn't YAML, or not a mapping with one key.
        """
        name, content = read_content(file)
        return _root(content, name), cls()


def _is_text(plain: str) -> bool:
    """Return whether a plain scalar is a text in ROS's files of parameters: 12:30, 0b11, 1_000, 2026-01-31."""
    from tfloom.node.values.scalars import parse_scalar

    return isinstance(parse_scalar(plain), str)


def _root(content: bytes, name: str) -> Entity:
    from tfloom.common.yaml import YamlError, load_placed  # loads yaml

    try:
        tree, lines = load_placed(content.decode(), mark_quoted=True, is_text=_is_text)
    except YamlError as error:
        message = f"{name}:{error.line}: {error}" if error.line is not None else f"{name}: {error}"
        raise InvalidFrontendLaunchFileError.with_message(message, error) from error
    except UnicodeDecodeError as error:
        raise InvalidFrontendLaunchFileError.with_message(
            f"{name}: it is not UTF-8: {error}", error
        ) from error
    if not isinstance(tree, dict) or not tree:
        actual_root = "it is empty" if not tree else f"it is a {type(tree).__name__}"
        message = f"{name}:1: {actual_root}, and should be a dictionary with the key 'launch'"
        raise InvalidFrontendLaunchFileError.with_message(message)
    if len(tree) > 1:
        keys = ", ".join(f"'{key}'" for key in tree)
        message = f"{name}:1: Expected only one root, 'launch', and there are {keys}"
        raise InvalidFrontendLaunchFileError.with_message(message)
    root = Entity(tree)
    root.set_places(Places(name, lines))
    return root


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in a YAML file.

    Args:
        launch_file_path: Path of the file.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method="interpreted YAML launch file", parser=Parser)
