"""The loading of launch files in any language."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tfloom.launch.frontend.parser import Parser
from tfloom.launch.invalid_launch_file_error import InvalidLaunchFileError
from tfloom.launch.launch_description import LaunchDescription
from tfloom.launch.launch_description_sources.frontend_launch_file_utilities import (
    get_launch_description_from_frontend_launch_file,
)
from tfloom.launch.launch_description_sources.missing_files import check_file
from tfloom.launch.launch_description_sources.python_launch_file_utilities import (
    InvalidPythonLaunchFileError,
    get_launch_description_from_python_launch_file,
)

__all__ = ["get_launch_description_from_any_launch_file"]


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
        except InvalidLaunchFileError as error:  # noqa: PERF203  # of two ways
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
