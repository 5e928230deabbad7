"""Run a program of a package, in a workspace or in tfloom."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from importlib import import_module
from pathlib import Path

from tfloom.cli.shared.errors import CommandError, refuse_bytes
from tfloom.cli.shared.names import did_you_mean, way_to_package
from tfloom.common.terminal import report
from tfloom.ros_imports.ros_distro import set_ros_environment
from tfloom.workspace import index


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `run` takes."""
    parser.add_argument(
        "--prefix", help="command to run the program with, for example --prefix 'gdb -ex run --args'"
    )
    parser.add_argument("package_name", help="package of the program")
    parser.add_argument("executable_name", help="name of the program")
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="arguments of the program")


def hint_after_error(args: argparse.Namespace) -> str:
    """Return a line with the programs of the package where the command line ends after its name."""
    package = getattr(args, "package_name", None)
    if package is None or getattr(args, "executable_name", None) is not None:
        return ""
    programs = package_programs(package)
    if programs is None:
        names = {*index.workspace_packages(), *index.PROGRAMS}
        return f"\nPackage '{package}' not found{way_to_package(package, names)}"
    return f"\n{package} has: {', '.join(programs) or 'no programs'}"


def package_programs(package: str) -> list[str] | None:
    """Return the names of a package's programs in order, or None if there is no such package."""
    prefix = index.find_package(package)
    if prefix is not None:
        installed = {index.program_name(path) for path in index.package_programs(package, prefix)}
        own = [name for name in index.PROGRAMS.get(package, ()) if index.replacement(package, prefix, name)]
        return sorted({*installed, *own})
    if package in index.own_packages():
        return sorted(index.PROGRAMS.get(package, {}))
    return None


def main(args: argparse.Namespace) -> int:
    """Run the program to its end and return its exit code, -N if signal N ended it."""
    set_ros_environment()
    # The command of a workspace's program, or, as a str, the function of one of tfloom's own. Such a one runs in this
    # process, if no --prefix asks for another.
    command = find_command(args.package_name, args.executable_name)
    if isinstance(command, str) and index.find_package(args.package_name) is not None:
        report(
            f"[ros2run]: starting tfloom's own {args.executable_name}, because that of the sourced workspace is in C++"
        )
    if not isinstance(command, str) and args.executable_name in index.PROGRAMS.get(args.package_name, {}):
        # Both have the program, and the user may not know that a sourced workspace precedes tfloom.
        report(
            f"[ros2run]: starting {command[-1]} of the sourced workspace, not tfloom's own {args.executable_name}"
        )
    if isinstance(command, str) and args.prefix is None:
        code = run_here(command, args.executable_name, args.argv)
    else:
        import shlex

        from tfloom.cli.shared.child import run_child

        if isinstance(command, str):
            command = [sys.executable, "-m", "tfloom", "run", args.package_name, args.executable_name]
        try:
            prefix = shlex.split(args.prefix or "")
        except ValueError as error:
            raise CommandError(f"can't read --prefix {args.prefix!r}: {error}") from None
        code = run_child([*prefix, *command, *args.argv])
    if code:
        report(f"[ros2run]: {how_it_ended(code)}")
    return code


def find_command(package: str, program: str) -> list[str] | str:
    """Return the command of a workspace's program, or `module:function` for one of tfloom's own.

    Raises:
        CommandError: no such package, no such program in it, or more than one.
    """
    prefix = index.find_package(package)
    if prefix is None:
        if package not in index.own_packages():
            names = {*index.workspace_packages(), *index.PROGRAMS}
            raise CommandError(f"Package '{package}' not found{way_to_package(package, names)}")
        own = index.PROGRAMS.get(package, {})
        if program not in own:
            raise CommandError(f"No executable found{did_you_mean(program, own)}")
        return own[program]
    programs = index.package_programs(package, prefix)
    paths = [path for path in programs if index.program_name(path) == program]
    if not paths:
        if own_program := index.replacement(package, prefix, program):
            return own_program
        if reason := _why_not_found(package, prefix, program):
            raise CommandError(f"No executable found: {reason}")
        raise CommandError(f"No executable found{did_you_mean(program, map(index.program_name, programs))}")
    if len(paths) > 1:
        listed = "".join(f"\n- {path}" for path in paths)
        raise CommandError(f"Multiple executables found:{listed}")
    return _command_of(paths[0])


def _why_not_found(package: str, prefix: str, program: str) -> str:
    """Return a sentence on a file of the program's name that is installed, but in a way that hides it; else empty."""
    if blocked := index.find_unmarked_program(package, prefix, program):
        return (
            f"{blocked} is not marked as executable: chmod +x {blocked}\n"
            "and in its package's source: install(PROGRAMS …) in CMakeLists.txt, or console_scripts in setup.py"
        )
    stray = Path(prefix, "bin", program)
    if stray.is_file():
        return (
            f"it is {stray}, not in lib/{package}: setup.cfg lacks two lines: "
            f"[install] and below it install_scripts=$base/lib/{package}"
        )
    return index.why_left_out(package, prefix, program)


def _command_of(path: Path) -> list[str]:
    if os.name == "nt" and path.suffix.lower() == ".py":
        return [sys.executable, str(path)]
    return [*index.interpreter_with_space(path), str(path)]


def run_here(target: str, name: str, argv: list[str]) -> int:
    """Run one of tfloom's own programs in this process and return its exit code.

    Raises:
        CommandError: its arguments are invalid.
    """
    refuse_bytes(argv)
    module, _, function = target.partition(":")
    sys.argv = [name, *argv]
    # The program handles signals, as in a separate process.
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    try:
        return int(getattr(import_module(module), function)(argv) or 0)
    except SystemExit as end:
        if isinstance(end.code, str):
            report(end.code)
            return 1
        return end.code or 0
    except Exception as error:
        if not _is_input_error(error):
            raise
        report(f"{name}: {error}")
        return 1


def _is_input_error(error: Exception) -> bool:
    """Return whether an error is about given names, parameters or ROS arguments, not a bug in tfloom."""
    from tfloom.node.context.arguments import UnknownROSArgsError
    from tfloom.node.parameters.exceptions import ParameterException
    from tfloom.node.values.exceptions import RCLError
    from tfloom.node.values.names import NameValidationException

    return isinstance(error, (NameValidationException, ParameterException, UnknownROSArgsError, RCLError))


def how_it_ended(code: int) -> str:
    """Return what ended a program: the name of a signal, or its exit code."""
    if code < 0 and (text := signal.strsignal(-code)):
        return text
    return f"Process exited with failure {code}"
