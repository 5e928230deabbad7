"""Parsers of launch files in other languages than Python."""

from __future__ import annotations

import importlib
import os
import warnings
from pathlib import Path
from typing import Any, TextIO

from tfloom.launch.core.base_classes import Condition, Substitution
from tfloom.launch.core.entity import Entity
from tfloom.launch.core.error_places import describe_error, place_error
from tfloom.launch.core.invalid_launch_file_error import InvalidLaunchFileError
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.conditions import IfCondition, UnlessCondition
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.frontend.expose import instantiate_action, load_entry_points, load_launch_extensions
from tfloom.launch.frontend.parse_substitution import (
    parse_if_substitutions,
    parse_substitution,
    replace_escaped_characters,
)
from tfloom.launch.utilities.texts import did_you_mean
from tfloom.ros_imports.guard import ros_home

__all__ = ["InvalidFrontendLaunchFileError", "Parser", "read_content"]

_MODULES = {"xml": "tfloom.launch.files.xml_file", "yaml": "tfloom.launch.files.yaml_file"}
"""Modules of tfloom's own parsers, which are imported when a file needs them."""
_FORMATS = {".xml": "xml", ".yaml": "yaml", ".yml": "yaml"}


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """A launch file in another language than Python cannot be loaded."""

    __module__ = ros_home("launch.frontend.parser", __name__)


class Parser:
    """Base class of the parsers of launch files.

    A parser of a language overrides `load` and `get_file_extensions`, and may override `parse_substitution`. Packages
    register it by the entry point `launch.frontend.parser`. This class itself chooses among all parsers.
    """

    extensions_loaded = False
    frontend_parsers: dict[str, type[Parser]] | None = None
    """Parsers by the name of their language; None before `load_parser_implementations`."""

    @classmethod
    def load_launch_extensions(cls) -> None:
        """Import what other packages add, at the first call. Unknown tags and substitutions call it, too."""
        load_launch_extensions()
        Parser.extensions_loaded = True

    @classmethod
    def load_parser_implementations(cls) -> None:
        """Import all parsers, at the first call."""
        if Parser.frontend_parsers is None:
            installed = load_entry_points("launch.frontend.parser")
            # tfloom's own ones last, so that they take precedence over those of an installed ROS 2.
            Parser.frontend_parsers = {**installed, **{name: _own_parser(name) for name in _MODULES}}

    @classmethod
    def _parsers(cls) -> dict[str, type[Parser]]:
        cls.load_parser_implementations()
        return Parser.frontend_parsers or {}

    # Elements

    def parse_action(self, entity: Entity) -> Action:
        """Return the action of an element.

        Raises:
            RuntimeError: no action is exposed for its tag.
            ValueError: it has attributes or elements that the action does not have.
            Exception: what the action's `parse` raises. The error's text begins with the file and the line.
        """
        try:
            action: Action = instantiate_action(entity, self)
        except Exception as error:
            place_error(error, _place(entity))
            raise
        action.launch_place = _place(entity)
        return action

    def parse_condition(self, entity: Entity) -> Condition | None:
        """Return the condition of the attributes `if` and `unless`; None without them.

        Raises:
            RuntimeError: the element has both.
        """
        if_text, unless_text = (_condition_text(entity, name) for name in ("if", "unless"))
        if if_text is not None and unless_text is not None:
            raise RuntimeError("if and unless conditions can't be used simultaneously")
        if if_text is not None:
            return IfCondition(self.parse_substitution(if_text))
        return None if unless_text is None else UnlessCondition(self.parse_substitution(unless_text))

    def parse_substitution(self, value: str) -> list[Substitution]:
        """Return the texts and substitutions that a text consists of."""
        return parse_substitution(value)

    def parse_if_substitutions(self, value: Any) -> Any:
        """Return a value with its texts parsed: a text without substitutions, else the list of them."""
        return parse_if_substitutions(value)

    def escape_characters(self, value: str) -> str:
        """Return a text with each backslash and the character after it replaced by this character."""
        return replace_escaped_characters(value)

    def parse_description(self, entity: Entity) -> LaunchDescription:
        """Return the launch description of a file's root.

        Raises:
            RuntimeError: the root is not `launch`.
            Exception: as `parse_action`.
        """
        if entity.type_name != "launch":
            error = RuntimeError(f"Expected 'launch' as root tag, and it is '{entity.type_name}'")
            place_error(error, _place(entity))
            raise error
        try:
            deprecated = entity.get_attr("deprecated", optional=True)
            children = entity.children
        except Exception as error:
            place_error(error, _place(entity))
            raise
        return LaunchDescription(
            [self.parse_action(child) for child in children], deprecated_reason=deprecated
        )

    # Files

    @classmethod
    def get_available_extensions(cls) -> list[str]:
        """Return the names of the languages. Deprecated: use `get_file_extensions_from_parsers`."""
        _warn("get_available_extensions", "get_file_extensions_from_parsers")
        return list(cls._parsers())

    @classmethod
    def is_extension_valid(cls, extension: str) -> bool:
        """Return whether a language has a parser. Deprecated: use `is_filename_valid`."""
        _warn("is_extension_valid", "is_filename_valid")
        return extension in cls._parsers()

    @classmethod
    def get_parser_from_extension(cls, extension: str) -> type[Parser] | None:
        """Return the parser of a language. Deprecated: use `get_parsers_from_filename`.

        Raises:
            RuntimeError: there is none.
        """
        _warn("get_parser_from_extension", "get_parsers_from_filename")
        if extension not in cls._parsers():
            near = did_you_mean(extension, cls._parsers())
            raise RuntimeError(f"Not recognized frontend implementation: '{extension}'{near}")
        return cls._parsers()[extension]

    @classmethod
    def may_parse(cls, filename: str) -> bool:
        """Return whether this parser reads files with such a name."""
        return any(filename.endswith("." + extension) for extension in cls.get_file_extensions())

    @classmethod
    def is_filename_valid(cls, filename: str) -> bool:
        """Return whether any parser reads files with such a name."""
        return bool(cls.get_parsers_from_filename(filename))

    @classmethod
    def get_parsers_from_filename(cls, filename: str) -> list[type[Parser]]:
        """Return the parsers of files with such a name."""
        return [parser for parser in cls._parsers().values() if parser.may_parse(filename)]

    @classmethod
    def get_file_extensions_from_parsers(cls) -> set[str]:
        """Return the extensions of all parsers' files, without the dot before them."""
        return {extension for parser in cls._parsers().values() for extension in parser.get_file_extensions()}

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return the extensions of this parser's files, without the dot before them."""
        return set()

    @classmethod
    def load(cls, file: str | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root of a launch file, and its parser.

        Args:
            file: Its path, or the open file. Its name decides which parser reads it; else the first one that can.

        Raises:
            FileNotFoundError: there is no such file.
            InvalidFrontendLaunchFileError: no parser can read it.
        """
        # The name may leave no parser, as that of a temporary file does. Then each is tried in turn, and an open file
        # goes back to its beginning for the next one.
        name = os.fspath(file) if isinstance(file, (str, os.PathLike)) else str(getattr(file, "name", ""))
        parsers = _chosen_parsers(cls, name)
        failures = []
        for parser in parsers or list(cls._parsers().values()):
            try:
                return parser.load(file)
            except (FileNotFoundError, IsADirectoryError, PermissionError):
                raise
            except Exception as error:  # other packages' parsers raise what they like
                failures.append(error)
                if not isinstance(file, (str, os.PathLike)):
                    file.seek(0)
        # The error of the parser that the name stands for is the user's. After a mere trial of all, none of the errors
        # says what is wrong with the file.
        if len(failures) == 1 or (parsers and failures):
            message = describe_error(failures[0], name)
            raise InvalidFrontendLaunchFileError.with_message(message, failures[0]) from failures[0]
        raise InvalidFrontendLaunchFileError


def _own_parser(name: str) -> type[Parser]:
    parser: type[Parser] = importlib.import_module(_MODULES[name]).Parser
    return parser


def _chosen_parsers(cls: type[Parser], name: str) -> list[type[Parser]]:
    own = _FORMATS.get(Path(name).suffix)
    return [_own_parser(own)] if own is not None else cls.get_parsers_from_filename(name)


def _place(entity: Entity) -> str:
    """Return an element's place, which the elements of other packages' parsers may not have."""
    return str(getattr(entity, "place", ""))


def _condition_text(entity: Entity, name: str) -> str | None:
    """Return a condition's text. YAML's `true` and `1` have no quotation marks."""
    # Usually it is a text, with substitutions in it. What YAML has read as another type is asked for as it is.
    try:
        text: str | None = entity.get_attr(name, optional=True)
    except TypeError:
        value = entity.get_attr(name, data_type=None)
        if not isinstance(value, (bool, int)):
            raise
        text = str(value).lower()
    return text


def _warn(method: str, better: str) -> None:
    warnings.warn(f"Parser.{method} is deprecated, use Parser.{better} instead", stacklevel=3)


def read_content(file: str | os.PathLike[str] | TextIO) -> tuple[str, bytes]:
    """Return the path and the content of a file.

    Args:
        file: Its path, or the open file; without a name, `<string>` stands for the path.

    Raises:
        OSError: it cannot be read.
    """
    if isinstance(file, (str, os.PathLike)):
        return os.fspath(file), Path(file).read_bytes()
    content = file.read()
    name = str(getattr(file, "name", "<string>"))
    return name, content.encode() if isinstance(content, str) else content
