"""Substitutions of packages, of the programs in them, and of ROS parameters."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any, ClassVar

from tfloom.launch.core.base_classes import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.missing import marked_as_missing
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.ros.configurations import global_parameters
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.launch.utilities.texts import did_you_mean
from tfloom.workspace import index
from tfloom.workspace.ament import PackageNotFoundError, get_package_prefix, get_package_share_directory

__all__ = ["ExecutableInPackage", "FindPackage", "FindPackagePrefix", "FindPackageShare", "Parameter"]


class FindPackage(ParsedSubstitution):
    """A folder of a package; derived classes define which.

    Args:
        package: Name of the package, or substitutions for it.
    """

    _arguments: ClassVar[tuple[str, ...]] = ("package",)
    _fault = "{class_name} substitution expects 1 argument, got {count}"
    _error = AttributeError

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        self._package = normalize_to_list_of_substitutions(package)

    @property
    def package(self) -> list[Substitution]:
        """Name of the package."""
        return self._package

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}(pkg={described(self._package)})"

    def find(self, package_name: str) -> str:
        """Return the folder of a package; derived classes implement it."""
        raise NotImplementedError(f"{type(self).__name__} has no method 'find', which returns the folder")

    def perform(self, context: LaunchContext) -> str:
        """Return the folder.

        Raises:
            PackageNotFoundError: there is no such package.
            ValueError: it is not a valid package name.
        """
        package = perform_substitutions(context, self._package)
        try:
            return self.find(package)
        except PackageNotFoundError as error:
            raise PackageNotFoundError(f"{error}{_nearest_package(package)}") from error


def _nearest_package(package: str) -> str:
    """Return what stands in for a package, or the package of the nearest name, as a text.

    It is empty if a workspace here has the package, or no name is near.
    """
    from tfloom.workspace import index
    from tfloom.workspace.unsourced import how_to_find

    if hint := how_to_find(package):
        # The error has how a workspace makes the package known already.
        return f"; {hint}" if hint == index.STAND_INS.get(package) else ""
    return did_you_mean(package, {*index.workspace_packages(), *index.own_packages()})


@expose_substitution("find-pkg-prefix")
class FindPackagePrefix(FindPackage):
    """The prefix that a package is installed under."""

    def find(self, package_name: str) -> str:
        """Return the prefix of a package."""
        return get_package_prefix(package_name)


@expose_substitution("find-pkg-share")
class FindPackageShare(FindPackage):
    """The folder of a package's files: `PREFIX/share/NAME`."""

    def find(self, package_name: str) -> str:
        """Return the share folder of a package."""
        return get_package_share_directory(package_name)


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


@expose_substitution("param")
class Parameter(ParsedSubstitution):
    """The value of a parameter that SetParameter has set in this scope.

    Args:
        name: Name of the parameter, or substitutions for it.
        default: Value if it isn't set, or substitutions for it.
    """

    _arguments = ("name", "default")
    _optional = 1
    _fault = "param substitution expects 1 or 2 arguments"

    def __init__(self, name: SomeSubstitutionsType, *, default: Any | Iterable[Any] | None = None) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)
        self._default = None if default is None else normalize_to_list_of_substitutions(_as_texts(default))

    @property
    def name(self) -> list[Substitution]:
        """Name of the parameter."""
        return self._name

    def describe(self) -> str:
        """Return a description for people."""
        return f"Parameter({described(self._name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the value as a text.

        Raises:
            SubstitutionFailure: it isn't set, and there is no default.
        """
        name = perform_substitutions(context, self._name)
        # The parameter that was set last counts, as in the node that is given all of them.
        for parameter in reversed(global_parameters(context)):
            if isinstance(parameter, tuple) and parameter[0] == name:
                return str(parameter[1])
        if self._default is None:
            raise SubstitutionFailure(
                f"parameter '{name}' is not set: no SetParameter before it, and no default"
            )
        return perform_substitutions(context, self._default)


def _as_texts(default: Any) -> Any:
    if isinstance(default, (str, Substitution)):
        return default
    if isinstance(default, Iterable):
        return [part if isinstance(part, Substitution) else str(part) for part in default]
    return str(default)
