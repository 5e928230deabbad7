"""The loading of launch files in Python."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType
from typing import Any

from tfloom.launch.launch_description import LaunchDescription
from tfloom.launch.launch_description_sources.missing_files import check_file
from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.ros_guard import ros_home

__all__ = [
    "InvalidPythonLaunchFileError",
    "get_launch_description_from_python_launch_file",
    "load_python_launch_file_as_module",
]

_FUNCTION = "generate_launch_description"


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
        raise ImportError(f"'{python_launch_file_path}' is no Python file")
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
