"""A program of a package as a substitution: `$(exec-in-pkg PROGRAM PACKAGE)`."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.missing import marked_as_missing
from tfloom.launch.core.substitution import (
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.ros.substitutions.find_package import FindPackagePrefix
from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.workspace import index

__all__ = ["ExecutableInPackage"]


@expose_substitution("exec-in-pkg")
@expose_substitution("exec-in-package")
class ExecutableInPackage(FindPackagePrefix):
    """The path of a program: in `PREFIX/lib/NAME` of a package, or a script that starts one of tfloom's own.

    Args:
        executable: Name of the program, or substitutions for it.
        package: Name of the package, or substitutions for it.
    """

    _arguments = ("executable", "package")
    _fault = "exec-in-pkg substitution expects 2 arguments, got {count}"

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        self._executable = normalize_to_list_of_substitutions(executable)

    @property
    def executable(self) -> list[Substitution]:
        """Name of the program."""
        return self._executable

    def describe(self) -> str:
        """Return a description for people."""
        return f"ExecInPkg(pkg={described(self.package)}, exec={described(self._executable)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            PackageNotFoundError: there is no such package.
            SubstitutionFailure: the package has no such program, or more than one.
            ValueError: it is not a valid package name.
        """
        prefix = super().perform(context)
        package = perform_substitutions(context, self.package)
        program = perform_substitutions(context, self._executable)
        folder = Path(prefix, "lib", package)
        if index.find_package(package) is None:
            return _own_program(context, package, program, folder)
        try:
            return _installed_program(package, program, prefix)
        except SubstitutionFailure as error:
            if index.replacement(package, prefix, program):
                return _own_program(context, package, program, folder)
            if reason := index.why_left_out(package, prefix, program):
                raise marked_as_missing(SubstitutionFailure(reason)) from error
            raise


def _own_program(context: LaunchContext, package: str, program: str, folder: Path) -> str:
    own = index.PROGRAMS.get(package, {})
    if program not in own:
        raise marked_as_missing(SubstitutionFailure(_not_found_message(program, folder, own)))
    from tfloom.launch.ros.temporary_files import script_for

    return script_for(context, package, program, own[program])


def _installed_program(package: str, program: str, prefix: str) -> str:
    folder = Path(prefix, "lib", package)
    if not folder.exists():
        text = f"package '{package}' found at '{prefix}', but libexec directory '{folder}' does not exist"
        raise marked_as_missing(SubstitutionFailure(text))
    programs = index.package_programs(package, prefix)
    matches = [path for path in programs if program in (index.program_name(path), path.name)]
    if not matches:
        hint = ""
        if blocked := index.find_unmarked_program(package, prefix, program):
            hint = f"\n{blocked} is not marked as executable: chmod +x {blocked}"
        program_names = map(index.program_name, programs)
        raise marked_as_missing(
            SubstitutionFailure(_not_found_message(program, folder, program_names) + hint)
        )
    # A program in the folder itself counts, before others of its name in folders below.
    return str(min(matches, key=lambda path: len(path.parts)))


def _not_found_message(program: str, folder: Path, program_names: Iterable[str]) -> str:
    hint = _nearest_program(program, sorted(set(program_names)))
    return f"executable '{program}' not found on the libexec directory '{folder}'{hint}"


def _nearest_program(program: str, program_names: list[str]) -> str:
    """Return the program of the nearest name as a text, else all of the package."""
    if near := did_you_mean(program, program_names):
        return near
    return f"; its programs are {', '.join(program_names)}" if program_names else "; it has no programs"
