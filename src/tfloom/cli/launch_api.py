"""Search for launch files, and what `launch` does with one; ros2launch.api has these functions, too."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.workspace.ament import PackageNotFoundError, get_package_share_directory

if TYPE_CHECKING:
    from tfloom.launch.entities.launch_description import LaunchDescription

__all__ = [
    "LaunchFileNameCompleter",
    "MultipleLaunchFilesError",
    "arguments_of_launch_file",
    "get_launch_file_paths",
    "get_share_file_path_from_package",
    "is_launch_file",
    "launch_a_launch_file",
    "launch_files_of_package",
    "parse_launch_arguments",
    "print_a_launch_file",
    "print_arguments_of_launch_description",
    "print_arguments_of_launch_file",
]


class MultipleLaunchFilesError(Exception):
    """A package has several launch files of one name.

    Args:
        msg: The error's text.
        paths: The files.
    """

    def __init__(self, msg: str, paths: list[str]) -> None:
        super().__init__(msg)
        self.paths = paths


def get_share_file_path_from_package(*, package_name: str, file_name: str) -> str:
    """Return the path of the file of this name in the share folder of a package, or in a folder below it.

    Raises:
        PackageNotFoundError: there is no such package.
        FileNotFoundError: there is no such file.
        MultipleLaunchFilesError: there is more than one.
        ValueError: it is not a valid package name.
    """
    share = get_package_share_directory(package_name, print_warning=False)
    paths = [path for path in _files_below(share) if Path(path).name == file_name]
    if not paths:
        raise FileNotFoundError(
            f"file '{file_name}' was not found in the share directory of package '{package_name}' "
            f"which is at '{share}'"
        )
    if len(paths) > 1:
        listed = ", ".join(f"'{path}'" for path in paths)
        raise MultipleLaunchFilesError(
            f"file '{file_name}' was found more than once in the share directory of package '{package_name}': "
            f"[{listed}]",
            paths,
        )
    return paths[0]


def _files_below(folder: str) -> list[str]:
    return [str(Path(parent, name)) for parent, _, names in sorted(os.walk(folder)) for name in sorted(names)]


def is_launch_file(path: str) -> bool:
    """Return whether a path is that of a file, and has the name of a launch file: `*launch.py`, `.xml`, `.yaml`, …."""
    from tfloom.launch.frontend.parser import Parser

    extensions = ["py", *Parser.get_file_extensions_from_parsers()]
    return (
        str(path).endswith(tuple(f"launch.{extension}" for extension in extensions)) and Path(path).is_file()
    )


def get_launch_file_paths(*, path: str) -> list[str]:
    """Return the launch files in a folder and in those below it."""
    return [file for file in _files_below(path) if is_launch_file(file)]


def launch_files_of_package(package: str) -> list[str]:
    """Return the names of a package's launch files in order; empty where there is no such package."""
    try:
        share = get_package_share_directory(package, print_warning=False)
    except (PackageNotFoundError, ValueError):
        return []
    return sorted({Path(path).name for path in get_launch_file_paths(path=share)})


def parse_launch_arguments(launch_arguments: Iterable[str]) -> Any:
    """Return the name and value of each argument `name:=value`; of several with one name, the last one counts.

    Raises:
        RuntimeError: an argument isn't of this form.
    """
    values: dict[str, str] = {}
    for argument in launch_arguments:
        name, separator, value = argument.partition(":=")
        if not separator or not name or not value:
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        values[name] = value
    return values.items()


def _load(path: str) -> LaunchDescription:
    from tfloom.launch.files.sources import (
        get_launch_description_from_any_launch_file,
    )

    return get_launch_description_from_any_launch_file(path)


def print_a_launch_file(*, launch_file_path: str) -> None:
    """Print the entities of a launch file as a tree."""
    from tfloom.launch.launch_introspector import LaunchIntrospector

    print(LaunchIntrospector().format_launch_description(_load(launch_file_path)))


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the arguments of a launch description, each with its description and default."""
    from tfloom.launch.testing import arguments

    arguments.print_arguments_of_launch_description(launch_description=launch_description)


def arguments_of_launch_file(path: str) -> list[Any]:
    """Return the arguments of a launch file, and of the files that it includes."""
    return _load(path).get_launch_arguments()


def print_arguments_of_launch_file(*, launch_file_path: str) -> None:
    """Print the arguments of a launch file, and of the files that it includes."""
    print_arguments_of_launch_description(launch_description=_load(launch_file_path))


def launch_a_launch_file(
    *,
    launch_file_path: str,
    launch_file_arguments: Sequence[str],
    noninteractive: bool = False,
    args: Any = None,  # noqa: ARG001
    option_extensions: Any = None,  # noqa: ARG001
    debug: bool = False,
    skip_missing: bool = False,
    log_file_name: str = "launch.log",
) -> int:
    """Launch a file and return the exit code when all has ended.

    Args:
        launch_file_path: Path of the file.
        launch_file_arguments: Its arguments, each `name:=value`.
        noninteractive: Whether to launch without a terminal.
        args: Not used: for extensions, which tfloom has none of.
        option_extensions: Not used, as `args`.
        debug: Whether to log the events and the tracebacks of errors.
        skip_missing: Whether to skip what needs packages, programs and files that aren't here, in place of ending.
        log_file_name: Name of the launch's own log file.

    Raises:
        RuntimeError: an argument isn't of this form.
        ValueError: `log_file_name` is not the name of a file.
    """
    from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
    from tfloom.launch.entities.launch_description import LaunchDescription
    from tfloom.launch.files.sources import (
        AnyLaunchDescriptionSource,
    )
    from tfloom.launch.launch_service import LaunchService

    arguments = parse_launch_arguments(launch_file_arguments)
    service = LaunchService(
        argv=launch_file_arguments,
        noninteractive=noninteractive,
        debug=debug,
        log_file_name=log_file_name,
    )
    source = AnyLaunchDescriptionSource(launch_file_path)
    included = IncludeLaunchDescription(source, launch_arguments=arguments)
    service.include_launch_description(
        LaunchDescription(
            [
                included,
                _warning_of_undeclared(source, Path(launch_file_path).name, [name for name, _ in arguments]),
            ]
        )
    )
    if not skip_missing:
        return int(service.run())
    from tfloom.launch.core.missing import missing_packages_stood_in

    # The file itself is not skipped: if it can't be loaded, nothing is left to launch.
    service.context.run_state.unskippable = included
    with missing_packages_stood_in():
        return int(service.run())


_OF_LAUNCH = frozenset(
    {"launch-prefix", "launch-prefix-filter", "sigterm_timeout", "sigkill_timeout", "emulate_tty"}
)
"""Launch configurations that actions of launch read without a declaration."""


def _warning_of_undeclared(source: Any, file_name: str, given: Sequence[str]) -> Any:
    """Return an action that logs a warning for each given argument that the file and its inclusions don't declare.

    It runs when all of the file has been visited, because what a condition or a function includes is known then.
    """
    from tfloom.launch.actions.opaque import OpaqueFunction
    from tfloom.launch.logs.logging import get_logger

    def warn(context: Any) -> None:
        # Two sources, because a file declares by its description, and by what a condition or function included
        # meanwhile.
        declared = source.get_launch_description(context).get_launch_arguments()
        visited = context.declared_arguments
        names = list(dict.fromkeys([*(argument.name for argument in declared), *visited]))
        for name in given:
            if name not in names and name not in _OF_LAUNCH:
                get_logger("launch").warning(undeclared_text(name, names, file_name))

    return OpaqueFunction(function=warn)


def undeclared_text(name: str, declared: Sequence[str], file_name: str) -> str:
    """Return the warning of an argument that a launch file doesn't declare, with the nearest that it does."""
    import difflib

    text = f"argument '{name}' is not declared by {file_name}"
    if near := difflib.get_close_matches(name, declared, 3, 0.5):
        return f"{text}: did you mean {' or '.join(near)}?"
    return f"{text}, which declares {', '.join(declared) if declared else 'no arguments'}"


class LaunchFileNameCompleter:
    """Lists the launch files of the package that a command line names.

    Args:
        package_name_key: The argument with the package's name.
    """

    def __init__(self, *, package_name_key: str | None = None) -> None:
        self.package_name_key = "package_name" if package_name_key is None else package_name_key

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the names that begin with the prefix."""
        names = launch_files_of_package(getattr(parsed_args, self.package_name_key))
        return [name for name in names if name.startswith(prefix)]
