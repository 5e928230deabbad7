"""Launch a file: start the programs that it names, and end them together."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tfloom.cli import launch_api
from tfloom.cli.parser import help_since
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import did_you_mean, way_to_package
from tfloom.ros_imports.ros_distro import set_ros_environment
from tfloom.workspace import index

ALL_OUTPUT_VARIABLE = "OVERRIDE_LAUNCH_PROCESS_OUTPUT"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `launch` takes."""
    parser.add_argument(
        "-n",
        "--noninteractive",
        action="store_true",
        help="launch without a terminal: signals are passed on to the programs",
    )
    parser.add_argument(
        "-d", "--debug", action="store_true", help="log each event, and the tracebacks of errors"
    )
    parser.add_argument(
        "--skip-missing",
        action="store_true",
        help="skip what needs packages, programs or launch files that aren't here, with a warning for each",
    )
    parser.add_argument(
        "-f",
        "--log-file-name",
        metavar="NAME",
        default="launch",
        help=help_since("lyrical", "name of the log file, without .log (default: launch)"),
    )
    shown = parser.add_mutually_exclusive_group()
    shown.add_argument(
        "-p",
        "--print",
        "--print-description",
        action="store_true",
        help="print what the file consists of, and launch nothing",
    )
    shown.add_argument(
        "-s",
        "--show-args",
        "--show-arguments",
        action="store_true",
        help="print the arguments that the file takes, and launch nothing",
    )
    parser.add_argument(
        "-a",
        "--show-all-subprocesses-output",
        action="store_true",
        help=f"show the output of all programs, also of those whose output is only logged ({ALL_OUTPUT_VARIABLE})",
    )
    parser.add_argument(
        "--launch-prefix",
        help="command to run each program with, for example --launch-prefix 'gdb -ex run --args'",
    )
    parser.add_argument(
        "--launch-prefix-filter",
        help="regular expression of the names of the programs that --launch-prefix is for",
    )
    _complete_by(_first_words, parser.add_argument("package_name", help="package, or path of a launch file"))
    _complete_by(
        _second_words,
        parser.add_argument("launch_file_name", nargs="?", help="name of a launch file of the package"),
    )
    _complete_by(
        _further_words,
        parser.add_argument(
            "launch_arguments",
            nargs="*",
            default=[],
            help="arguments: name:=value; of several with one name, the last one counts",
        ),
    )


def main(args: argparse.Namespace) -> int:
    """Launch the file, and return the exit code when all has ended; or print what it consists of, or takes."""
    set_ros_environment()
    path, arguments = find_launch_file(args)
    try:
        launch_api.parse_launch_arguments(arguments)
    except RuntimeError as error:
        raise CommandError(str(error)) from None
    if args.print or args.show_args:
        if not args.skip_missing:
            _show(path, args.print)
            return 0
        from tfloom.launch.core.missing import missing_packages_stood_in

        with missing_packages_stood_in():
            _show(path, args.print)
        return 0
    from tfloom.launch.logs.logging import launch_config

    if args.show_all_subprocesses_output:
        os.environ[ALL_OUTPUT_VARIABLE] = "both"
    for name in ("launch-prefix", "launch-prefix-filter"):
        if value := getattr(args, name.replace("-", "_")):
            arguments.append(f"{name}:={value}")
    try:
        launch_config.log_file_name = log_file_name = f"{args.log_file_name}.log"
    except ValueError as error:
        raise CommandError(f"--log-file-name: {error}") from None
    return launch_api.launch_a_launch_file(
        launch_file_path=path,
        launch_file_arguments=arguments,
        noninteractive=args.noninteractive,
        debug=args.debug,
        skip_missing=args.skip_missing,
        log_file_name=log_file_name,
    )


def _show(path: str, whole: bool) -> None:
    """Print a file's entities or its arguments.

    Raises:
        CommandError: the file can't be loaded.
    """
    show = launch_api.print_a_launch_file if whole else launch_api.print_arguments_of_launch_file
    try:
        show(launch_file_path=path)
    except BrokenPipeError:
        raise
    except Exception as error:
        place = "" if path in str(error) else f"{path}: "
        raise CommandError(f"{place}{error or type(error).__name__}") from error


def find_launch_file(args: argparse.Namespace) -> tuple[str, list[str]]:
    """Return the path of the launch file that a command line names, and the arguments for it.

    The first word is a package, or else a path.

    Raises:
        CommandError: there is no such package or file.
    """
    first, second = args.package_name, args.launch_file_name
    arguments = list(args.launch_arguments)
    if second is None or ":=" in second or (Path(first).exists() and not _is_package(first)):
        return _existing_file(first), ([] if second is None else [second]) + arguments
    try:
        return launch_api.get_share_file_path_from_package(package_name=first, file_name=second), arguments
    except KeyError as error:
        raise CommandError(f"Package '{first}' not found: \"{error}\"{_way_to_package(first)}") from None
    except ValueError as error:
        raise CommandError(str(error)) from None
    except FileNotFoundError as error:
        near = did_you_mean(second, launch_api.launch_files_of_package(first))
        raise CommandError(f"{error}{near or _listed(first)}") from None
    except launch_api.MultipleLaunchFilesError as error:
        raise CommandError(str(error)) from None


def _existing_file(path: str) -> str:
    """Return the path of a launch file that was given without a package.

    Raises:
        CommandError: there is no such file.
    """
    if Path(path).is_file():
        return path
    if _is_package(path):
        raise CommandError(f"name a launch file of the package {path}{_listed(path)}")
    if Path(path).is_dir():
        raise CommandError(f"{path} is a folder, not a launch file{_files_here(path, '')}")
    folder, name = os.path.split(path)
    if folder or "." in name:
        near = _files_here(folder, name) if Path(folder).is_dir() else ""
        raise CommandError(f"launch file '{path}' was not found{near}")
    raise CommandError(f"no package and no launch file is named '{path}'{_way_to_package(path)}")


def _files_here(folder: str, name: str) -> str:
    """Return a line with the launch files of a folder: those of a name near to `name`, or all if it is empty."""
    files = sorted(path.name for path in Path(folder).iterdir() if launch_api.is_launch_file(str(path)))
    if name:
        return did_you_mean(name, files)
    return f"\nlaunch files in it: {', '.join(files)}" if files else ""


def _listed(package: str) -> str:
    files = launch_api.launch_files_of_package(package)
    return f"\n{package} has: {', '.join(files) or 'no launch files'}"


def _is_package(name: str) -> bool:
    return index.find_package(name) is not None or name in index.own_packages()


def _way_to_package(name: str) -> str:
    return way_to_package(name, {*index.workspace_packages(), *index.own_packages()})


def _complete_by(completer: Any, action: argparse.Action) -> None:
    """Complete an argument by a function, which gets the typed part: `complete(prefix, parsed_args)`."""
    action.completer = completer  # type: ignore[attr-defined]  # an attribute that argcomplete reads


def _first_words(prefix: str, **_: Any) -> list[str]:
    """Return packages, launch files of the folder that was typed, and its folders."""
    folder, name = os.path.split(prefix)
    start = prefix.removesuffix(name)
    words = [] if folder else sorted({*index.workspace_packages(), *index.own_packages()})
    try:
        entries = sorted(os.scandir(folder or os.curdir), key=lambda entry: entry.name)
    except OSError:
        entries = []
    for entry in entries:
        if entry.name.startswith(".") and not name.startswith("."):
            continue
        if entry.is_dir():
            words.append(f"{start}{entry.name}{os.sep}")
        elif launch_api.is_launch_file(entry.path):
            words.append(f"{start}{entry.name}")
    return [word for word in words if word.startswith(prefix)]


def _second_words(prefix: str, parsed_args: argparse.Namespace, **_: Any) -> list[str]:
    """Return the launch files of the package, or the arguments of the file that was typed before."""
    if _is_package(parsed_args.package_name):
        files = launch_api.launch_files_of_package(parsed_args.package_name)
        return [name for name in files if name.startswith(prefix)]
    return _offered_arguments(prefix, parsed_args.package_name, [])


def _further_words(prefix: str, parsed_args: argparse.Namespace, **_: Any) -> list[str]:
    """Return the arguments of the file that were not typed before, each as `name:=`, or its choices."""
    typed = parsed_args.launch_arguments or []
    named = argparse.Namespace(**{**vars(parsed_args), "launch_arguments": list(typed)})
    try:
        path, before = find_launch_file(named)
    except CommandError:
        return []
    return _offered_arguments(prefix, path, before)


def _offered_arguments(prefix: str, path: str, before: Sequence[str]) -> list[str]:
    """Return the arguments of a file that begin with what was typed; none if it can't be loaded."""
    try:
        declared = launch_api.arguments_of_launch_file(path)
    except Exception:  # noqa: BLE001  # any of the user's file; the shell shows no error
        return []
    given_names = {argument.partition(":=")[0] for argument in before}
    words = []
    for argument in declared:
        if argument.name in given_names:
            continue
        start = f"{argument.name}:="
        if prefix.startswith(start) and argument.choices:
            words += [start + choice for choice in argument.choices]
        else:
            words.append(start)
    return [word for word in words if word.startswith(prefix) and word != prefix]
