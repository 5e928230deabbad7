"""The functions of `ros2run.api`: the programs of packages."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tfloom.cli.api.answers import argument_key
from tfloom.cli.api.pkg import PackageNotFound, get_executable_paths
from tfloom.cli.run import how_it_ended, package_programs
from tfloom.cli.shared.child import run_child
from tfloom.common.terminal import report
from tfloom.workspace import index

__all__ = [
    "ROS2RUN_MSG_PREFIX",
    "ExecutableNameCompleter",
    "MultipleExecutables",
    "get_executable_path",
    "run_executable",
]

ROS2RUN_MSG_PREFIX = "[ros2run]:"


class MultipleExecutables(Exception):
    """A package has several programs of one name.

    Args:
        paths: Their paths.
    """

    def __init__(self, paths: Sequence[str]) -> None:
        super().__init__(f"several programs have this name: {', '.join(paths)}")
        self.paths = paths


def get_executable_path(*, package_name: str, executable_name: str) -> str | None:
    """Return the path of a program of a package; for one of tfloom's own, that of a script that starts it.

    Returns:
        None if the package has no such program.

    Raises:
        PackageNotFound: there is no such package.
        MultipleExecutables: it has several of this name.
    """
    paths = [
        path
        for path in get_executable_paths(package_name=package_name)
        if index.program_name(Path(path)) == executable_name
    ]
    if len(paths) > 1:
        raise MultipleExecutables(paths)
    return paths[0] if paths else None


def run_executable(*, path: str, argv: Sequence[str], prefix: Sequence[str] | None = None) -> int:
    """Run a program to its end and return its exit code, -N if signal N ended it; a failure is a line on stderr.

    Raises:
        CommandError: it can't be started.
    """
    code = run_child([*(prefix or ()), *index.interpreter_with_space(Path(path)), path, *argv])
    if code:
        report(f"{ROS2RUN_MSG_PREFIX} {how_it_ended(code)}")
    return code


class ExecutableNameCompleter:
    """Lists the programs of the package that a command line names.

    Args:
        package_name_key: The argument with the package's name.
    """

    def __init__(self, *, package_name_key: str | None = None) -> None:
        self.package_name_key = argument_key(package_name_key, "package_name")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return their names.

        Raises:
            PackageNotFound: there is no such package.
        """
        package = getattr(parsed_args, self.package_name_key)
        programs = package_programs(package)
        if programs is None:
            raise PackageNotFound(package)
        return programs
