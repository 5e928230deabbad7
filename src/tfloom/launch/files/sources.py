"""Launch descriptions from files: their loading, and the sources by which another launch includes them."""

from __future__ import annotations

import errno
import os
import traceback
from collections.abc import Callable
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from types import ModuleType
from typing import Any

from tfloom.launch.core.base_classes import SomeSubstitutionsType
from tfloom.launch.core.error_places import describe_error
from tfloom.launch.core.invalid_launch_file_error import InvalidLaunchFileError
from tfloom.launch.core.missing import marked_as_missing
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.entities.launch_description_source import LaunchDescriptionSource
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, Parser
from tfloom.launch.utilities.texts import did_you_mean, nearest
from tfloom.ros_imports.guard import ros_home

__all__ = [
    "AnyLaunchDescriptionSource",
    "FrontendLaunchDescriptionSource",
    "InvalidPythonLaunchFileError",
    "PythonLaunchDescriptionSource",
    "get_launch_description_from_any_launch_file",
    "get_launch_description_from_frontend_launch_file",
    "get_launch_description_from_python_launch_file",
    "load_python_launch_file_as_module",
]

_EXTENSIONS = (".py", ".xml", ".yaml", ".yml")
_FUNCTION = "generate_launch_description"


class _MissingFileError(FileNotFoundError):
    """No file has a path; the text names the nearest one that exists."""

    def __str__(self) -> str:
        return f"{super().__str__()}{self._hint()}"

    def _hint(self) -> str:
        path = Path(str(self.filename))
        try:
            names = sorted(sibling.name for sibling in path.parent.iterdir())
        except OSError:
            return f" (there is no folder '{path.parent}')"
        files = {_stem(name): name for name in reversed(names) if name.endswith(_EXTENSIONS)}
        near = nearest(_stem(path.name), files)
        return "" if near is None else f"; did you mean '{files[near]}'?"


def _stem(name: str) -> str:
    """Return what is before `.launch.py`, because a common ending does not make names similar."""
    return name.partition(".")[0]


def check_file(path: str) -> None:
    """Check that a launch file exists.

    Raises:
        FileNotFoundError: no file has this path.
        IsADirectoryError: it is a folder.
    """
    if Path(path).is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), path)
    if not Path(path).exists():
        raise marked_as_missing(_MissingFileError(errno.ENOENT, os.strerror(errno.ENOENT), path))


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Return the launch description in a file.

    Args:
        frontend_launch_file_path: Path of the file.
        parser: The parser that loads it.

    Raises:
        OSError: the file cannot be read.
        InvalidFrontendLaunchFileError: it has an error. The text has the file, the line, and what is wrong.
    """
    check_file(frontend_launch_file_path)
    try:
        root, its_parser = parser.load(frontend_launch_file_path)
        return its_parser.parse_description(root)
    except (InvalidFrontendLaunchFileError, OSError):
        raise
    except Exception as error:
        message = describe_error(error, frontend_launch_file_path)
        raise InvalidFrontendLaunchFileError.with_message(message, error) from error


class InvalidPythonLaunchFileError(Exception):
    """A launch file in Python cannot be loaded. The text has the file, its line, and what is wrong."""

    __module__ = ros_home("launch.launch_description_sources.python_launch_file_utilities", __name__)


def load_python_launch_file_as_module(python_launch_file_path: str) -> ModuleType:
    """Execute a Python file, and return it as a module, which is not in `sys.modules`.

    Raises:
        OSError: the file cannot be read.
        Exception: what the file raises.
    """
    loader = SourceFileLoader("python_launch_file", python_launch_file_path)
    spec = spec_from_loader(loader.name, loader)
    if spec is None:
        raise ImportError(f"'{python_launch_file_path}' is not a Python file")
    module = module_from_spec(spec)
    loader.exec_module(module)
    return module


def get_launch_description_from_python_launch_file(python_launch_file_path: str) -> LaunchDescription:
    """Return what the function `generate_launch_description()` in a Python file returns.

    Raises:
        OSError: the file cannot be read.
        InvalidPythonLaunchFileError: the file or its function raises an error, which is the cause; it has no such
            function, or this returns no LaunchDescription.
    """
    check_file(python_launch_file_path)
    try:
        module = load_python_launch_file_as_module(python_launch_file_path)
        generate = _function_of(module, python_launch_file_path)
        description = generate()
    except InvalidPythonLaunchFileError:
        raise
    except Exception as error:
        text = _error_text(error, python_launch_file_path)
        raise InvalidPythonLaunchFileError(text) from error
    if not isinstance(description, LaunchDescription):
        code = getattr(generate, "__code__", None)
        place = f"{python_launch_file_path}:{code.co_firstlineno}" if code else python_launch_file_path
        raise InvalidPythonLaunchFileError(
            f"{place}: {_FUNCTION}() returns {_article(description)}, and should return a LaunchDescription"
        )
    return description


def _function_of(module: ModuleType, path: str) -> Callable[[], Any]:
    if not hasattr(module, _FUNCTION):
        near = did_you_mean(_FUNCTION, vars(module))
        raise InvalidPythonLaunchFileError(
            f"launch file at '{path}' does not contain the required function '{_FUNCTION}()'{near}"
        )
    function: Callable[[], Any] = getattr(module, _FUNCTION)
    return function


def _error_text(error: Exception, path: str) -> str:
    """Return an error's place in a launch file, its type and its text."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path]
    text = f"{type(error).__name__}: {error}"
    if isinstance(error, SyntaxError):
        text = f"{type(error).__name__}: {error.msg}"
        if error.filename == path:
            lines.append(error.lineno)
        elif error.filename is not None:
            text += f" ({error.filename}:{error.lineno})"
    return f"{path}:{lines[-1]}: {text}" if lines and lines[-1] else f"{path}: {text}"


def _article(value: object) -> str:
    return "None" if value is None else f"a value of type {type(value).__name__}"


def get_launch_description_from_any_launch_file(
    launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Return the launch description in a file, whose extension decides how it is loaded.

    Args:
        launch_file_path: Path of the file. With an unknown extension, every way is tried.
        parser: The parser for files in other languages than Python.

    Raises:
        OSError: the file cannot be read.
        InvalidLaunchFileError: it has an error. The text has the file, the line, and what is wrong.
    """
    check_file(launch_file_path)

    def load_frontend(path: str) -> LaunchDescription:
        return get_launch_description_from_frontend_launch_file(path, parser=parser)

    extension = Path(launch_file_path).suffix
    if extension == ".py":
        return _load_file(get_launch_description_from_python_launch_file, launch_file_path)
    if extension in {".xml", ".yaml", ".yml"} or Parser.is_filename_valid(launch_file_path):
        return _load_file(load_frontend, launch_file_path)
    return _try_all(load_frontend, launch_file_path)


def _load_file(loader: Callable[[str], LaunchDescription], path: str) -> LaunchDescription:
    try:
        return loader(path)
    except InvalidPythonLaunchFileError as error:
        raise InvalidLaunchFileError.with_message(str(error), error) from error


def _try_all(load_frontend: Callable[[str], LaunchDescription], path: str) -> LaunchDescription:
    failures: list[Exception] = []
    for loader in (load_frontend, get_launch_description_from_python_launch_file):
        try:
            return _load_file(loader, path)
        except InvalidLaunchFileError as error:
            failures.append(error)
    extensions = ", ".join(
        f".{extension}" for extension in sorted(Parser.get_file_extensions_from_parsers() | {"py"})
    )
    name = Path(path).suffix
    reason = f"its extension '{name}'" if name else "a file without an extension"
    likely = failures[0] if Path(path).read_bytes().lstrip().startswith(b"<") else failures[-1]
    raise InvalidLaunchFileError.with_message(
        f"{path}: The launch file may have a syntax error, or its format is unknown "
        f"({reason} is none of {extensions}): {likely}",
        likely,
    ) from likely


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
