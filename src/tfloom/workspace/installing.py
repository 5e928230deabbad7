"""Installs the files that a plan names into a prefix, as copies or as symbolic links to the sources."""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from fnmatch import fnmatchcase
from pathlib import Path

from tfloom.common.files import write_file
from tfloom.workspace import index
from tfloom.workspace.cmake_plan import (
    Install,
    Pattern,
    Plan,
    PythonPackage,
    is_in,
    is_of_headers,
    name_in_build,
)
from tfloom.workspace.cmake_regex import Expression, RegexError
from tfloom.workspace.cmake_values import MAX_STEPS, TooMuchError
from tfloom.workspace.environment_hooks import WRAPPED_KINDS, EnvironmentHook, wrapper
from tfloom.workspace.program_scripts import read_console_scripts

_EXECUTE = stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH
_LEFT_OUT = {"__pycache__", ".git", ".svn"}


class InstallError(Exception):
    """Something can't be installed; the text names the line of CMakeLists.txt and what to do."""


class Installer:
    """The installation of one package.

    Args:
        source: The package's folder.
        name: Its name.
        prefix: The folder to install under; it is made.
        symlink: Link to the sources in place of copying, so that an edit needs no new build.
    """

    def __init__(self, source: Path, name: str, prefix: Path, *, symlink: bool = False) -> None:
        self._source = source
        self._name = name
        self._prefix = prefix
        self._symlink = symlink
        self._errors: list[str] = []
        self.warnings: list[str] = []
        """Sentences on what is installed, but does not work as it seems meant."""
        self.files: list[Path] = []
        """What is installed."""
        self.hooks: list[Path] = []
        """The scripts among it that are run when the workspace is sourced."""

    def install(self, plan: Plan) -> None:
        """Install the files, Python packages and resources of a plan, and the package's own marker.

        Raises:
            InstallError: a source is missing, or a destination is outside the prefix; everything else is installed.
            OSError: a file can't be read or written.
        """
        for python in plan.python_packages:
            with self._noted():
                self._install_python(python)
        for command in plan.installs:
            # No compiler will read headers, and those of a build are not there.
            if not (plan.compiled and is_of_headers(command)):
                with self._noted():
                    self._install(command, plan)
        for resource in plan.resources:
            self._write_resource(resource.kind, resource.content)
        for hook in plan.hooks:
            self._write_hook(hook)
        if plan.compiled:
            remark = plan.compiled[0]
            reason = f"{self._where(remark.line)} has {remark.text}"
            self._write_resource(index.LEFT_OUT, "\n".join([reason, *dict.fromkeys(plan.programs)]) + "\n")
        self._mark()
        if self._errors:
            raise InstallError("\n".join(self._errors))

    @contextmanager
    def _noted(self) -> Iterator[None]:
        """Note the error of a command instead of raising it, so that the others are carried out."""
        try:
            yield
        except InstallError as error:
            self._errors.append(str(error))

    def _mark(self) -> None:
        """Install package.xml and the package's marker in the ament index."""
        self._write_resource("packages", "")
        self._place(self._source / "package.xml", self._prefix / "share" / self._name / "package.xml")

    def _write_hook(self, hook: EnvironmentHook) -> None:
        """Install a script of `ament_environment_hooks`, and beside colcon's own what runs it."""
        share = Path("share", self._name)
        path = share / "environment" / hook.name
        self._write(self._prefix / path, hook.content)
        # In one folder: colcon takes the lines of a .dsv in place of a script of the same name.
        called = self._prefix / share / "hook" / hook.name
        content = wrapper(path.as_posix()).encode() if hook.kind in WRAPPED_KINDS else hook.content
        self._write(called, content)
        self.hooks.append(called)

    def _write_resource(self, kind: str, content: str) -> None:
        path = self._prefix / index.RESOURCE_INDEX / kind / self._name
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.is_symlink():
            path.unlink()
        write_file(path, content)
        self.files.append(path)

    def _install_python(self, package: PythonPackage) -> None:
        folder = self._source / package.folder
        if not folder.is_dir():
            raise self._error(package.line, f"there is no folder {package.folder} with the Python package")
        target = self._destination(package.destination, package.line) / package.name
        for path in _files(folder):
            place = target / path.relative_to(folder)
            self._place(path, place)
            if path.suffix == ".py" and not path.with_suffix(".pyi").exists():
                # A stub beside it is that of a module of the package's interfaces, which this one replaces.
                place.with_suffix(".pyi").unlink(missing_ok=True)
        if package.scripts_destination:
            self._write_scripts(package)

    def _write_scripts(self, package: PythonPackage) -> None:
        """Write a program for each of the `console_scripts` of the package's setup.cfg."""
        path = self._source / package.setup_cfg
        if not path.is_file():
            raise self._error(package.line, f"SCRIPTS_DESTINATION needs a setup.cfg, and there is no {path}")
        folder = self._destination(package.scripts_destination, package.line)
        try:
            scripts = read_console_scripts(path)
        except ValueError as error:
            raise self._error(package.line, str(error)) from None
        for name, text in scripts.items():
            self._write(folder / (f"{name}.py" if os.name == "nt" else name), text.encode(), executable=True)

    def _install(self, command: Install, plan: Plan) -> None:
        target = self._destination(command.destination, command.line)
        for name in command.sources:
            source = self._source / name
            generated = name_in_build(name)
            if generated is not None:
                self._install_generated(command, name, generated, plan, target)
            elif Path(name).is_absolute() and not source.is_relative_to(self._source):
                # A variable that isn't set leaves `/lib` of `${X}/lib`, which must not be copied.
                self.warnings.append(
                    f"{self._where(command.line)}: install({command.kind} …): {name} is outside of the package, so it "
                    "is left out"
                )
            elif command.kind == "DIRECTORY":
                self._install_folder(command, name, source, target, plan)
            elif source.is_file():
                self._install_file(command, source, target / (command.rename or source.name))
            elif not command.optional:
                self._lacks(plan, command.line, f"install({command.kind} …): there is no file {name}")

    def _lacks(self, plan: Plan, line: int, reason: str) -> None:
        """Raise an error about a missing source; in a package with C++ print it, because the build may make it."""
        if not plan.compiled:
            raise self._error(line, reason)
        self.warnings.append(f"{self._where(line)}: {reason}, so it is left out")

    def _install_generated(
        self, command: Install, name: str, generated: str, plan: Plan, target: Path
    ) -> None:
        """Write what `configure_file` has made of one file, or of all in a folder."""
        if command.kind != "DIRECTORY":
            base = target / (command.rename or Path(generated).name)
            self._write(base, plan.generated[generated], executable=command.kind == "PROGRAMS")
            return
        start = "" if generated == "." else f"{generated}/"
        base = target if name.endswith("/") or not start else target / Path(generated).name
        for path, data in plan.generated.items():
            if path.startswith(start):
                self._write(base / path.removeprefix(start), data)

    def _install_file(self, command: Install, source: Path, target: Path) -> None:
        runs = command.kind == "PROGRAMS"
        self._place(source, target, executable=runs)
        if runs and self._symlink and not _is_executable(source):
            self.warnings.append(
                f"{source} is not marked as executable, so it is copied, not linked: chmod +x {source}"
            )
        if not runs and self._is_program(target) and not _is_executable(target):
            self.warnings.append(
                f"{self._where(command.line)}: install(FILES …) puts {source.name} into lib/{self._name} without the "
                "permission to execute it, so `ros2 run` does not find it: use install(PROGRAMS …)"
            )

    def _is_program(self, target: Path) -> bool:
        return target.is_relative_to(self._prefix / "lib" / self._name)

    def _install_folder(self, command: Install, name: str, folder: Path, target: Path, plan: Plan) -> None:
        if not folder.is_dir():
            if not command.optional:
                self._lacks(plan, command.line, f"install(DIRECTORY …): there is no folder {name}")
            return
        # As CMake does: a slash at the end installs what is in the folder, not the folder.
        base = target if not name or name.endswith("/") else target / folder.name
        try:
            choice = _Choice(command)
            paths = [path for path in _files(folder) if choice.has(path.relative_to(folder).as_posix())]
        except (RegexError, TooMuchError) as error:
            raise self._error(command.line, f"install(DIRECTORY …): {error}") from None
        for path in paths:
            self._place(path, base / path.relative_to(folder))

    def _destination(self, text: str, line: int) -> Path:
        target = self._prefix / text
        if not is_in(self._prefix, target):
            raise self._error(line, f"DESTINATION {text} is outside the prefix {self._prefix}")
        return target

    def _make_room(self, target: Path) -> None:
        """Remove what is at the place of a file to install."""
        self.files.append(target)
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.is_symlink() or target.is_file():
            # Writing through a link of an earlier build would change the source.
            target.unlink()
        elif target.is_dir():
            shutil.rmtree(target)

    def _write(self, target: Path, data: bytes, *, executable: bool = False) -> None:
        """Write a file that has no source, replacing what is there."""
        self._make_room(target)
        write_file(target, data)
        if executable:
            target.chmod(target.stat().st_mode | _EXECUTE)

    def _place(self, source: Path, target: Path, *, executable: bool = False) -> None:
        """Copy or link a file, replacing what is there."""
        self._make_room(target)
        source = source.resolve()
        if self._symlink and (not executable or _is_executable(source)):
            target.symlink_to(source)
            return
        shutil.copy2(source, target)
        if executable:
            target.chmod(target.stat().st_mode | _EXECUTE)

    def _where(self, line: int) -> str:
        return f"{self._source / 'CMakeLists.txt'}:{line}"

    def _error(self, line: int, reason: str) -> InstallError:
        return InstallError(f"{self._where(line)}: {reason}")


def _files(folder: Path) -> Iterator[Path]:
    """Yield the files in a folder and its folders, in order; compiled Python and repositories' data are left out."""
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(set(folders) - _LEFT_OUT)
        for name in sorted(names):
            yield Path(parent, name)


class _Choice:
    """The files that the patterns of an `install(DIRECTORY …)` let through.

    Raises:
        RegexError: a pattern isn't a regular expression.
    """

    def __init__(self, install: Install) -> None:
        self._install = install
        self._steps = 0
        self._expressions = {
            pattern.text: Expression(pattern.text, self._count)
            for pattern in install.patterns
            if pattern.is_regex
        }

    def _count(self, steps: int) -> None:
        self._steps += steps
        if self._steps > MAX_STEPS:
            raise TooMuchError(f"its regular expressions take more than {MAX_STEPS} steps")

    def has(self, path: str) -> bool:
        """Return whether they let a file through; TooMuchError if that takes too many steps."""
        # An excluded folder excludes all that is in it, so each folder above the file is looked at, too. Patterns that
        # don't exclude matter with FILES_MATCHING only: then a file must match one of them.
        patterns = self._install.patterns
        if any(self._matches_here_or_above(path, pattern) for pattern in patterns if pattern.excludes):
            return False
        chosen = [pattern for pattern in patterns if not pattern.excludes]
        return not self._install.only_matching or any(self._matches(path, pattern) for pattern in chosen)

    def _matches_here_or_above(self, path: str, pattern: Pattern) -> bool:
        parts = path.split("/")
        return any(self._matches("/".join(parts[:end]), pattern) for end in range(1, len(parts) + 1))

    def _matches(self, path: str, pattern: Pattern) -> bool:
        """Return whether a pattern matches the end of a path, at a slash, or a regular expression any part of it."""
        if pattern.is_regex:
            return self._expressions[pattern.text].is_found_in(f"/{path}")
        return fnmatchcase(path, pattern.text) or fnmatchcase(f"/{path}", f"*/{pattern.text}")


def _is_executable(path: Path) -> bool:
    return os.access(path, os.X_OK)
