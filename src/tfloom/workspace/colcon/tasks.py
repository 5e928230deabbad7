"""The tasks of colcon's verbs `build` and `test` for packages that are built without CMake."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from colcon_core.environment import create_environment_hooks, create_environment_scripts
from colcon_core.event.output import StderrLine
from colcon_core.shell import create_environment_hook
from colcon_core.task import TaskExtensionPoint

from tfloom.rosidl.parse import ParseError
from tfloom.workspace.cmake_lists import read_plan
from tfloom.workspace.cmake_plan import Plan
from tfloom.workspace.cmake_syntax import CMakeSyntaxError
from tfloom.workspace.colcon.identification import FAULT_KEY
from tfloom.workspace.colcon.pytest_tests import run_pytest_tests
from tfloom.workspace.installing import Installer, InstallError
from tfloom.workspace.interface_package import install_interfaces
from tfloom.workspace.leftovers import remove_former_files

_FAULTS = (ParseError, LookupError, ValueError)
"""What is raised about definitions that can't be built."""
LEFT_OUT_KEY = "tfloom_left_out"
"""The key, in the metadata of a package's descriptor, of the reason for which it is left out."""


def say(context: Any, text: str) -> None:
    """Print a sentence on stderr.

    It is posted in bytes, because colcon-output refuses the text that `TaskExtensionPoint.print` posts.

    Args:
        context: That of the task.
        text: The sentence.
    """
    context.put_event_into_queue(StderrLine(f"{text}\n".encode()))


class Task(TaskExtensionPoint):
    """A task whose package may be wanting without stopping the build of those that depend on it."""

    def _write_scripts(self, additional_hooks: list[Any] | None = None) -> None:
        """Write the scripts of the package's environment, without which colcon builds no package that depends on it."""
        args, package = self.context.args, self.context.pkg
        prefix = Path(args.install_base)
        hooks = list(create_environment_hooks(prefix, package.name))
        hooks += create_environment_hook(
            "ament_prefix_path", prefix, package.name, "AMENT_PREFIX_PATH", "", mode="prepend"
        )
        create_environment_scripts(
            package, args, default_hooks=hooks, additional_hooks=additional_hooks or []
        )

    def _say(self, text: str) -> None:
        say(self.context, text)


class BuildTask(Task):
    """Install what a CMakeLists.txt names, without CMake."""

    async def build(self, *, additional_hooks: list[Any] | None = None) -> int:
        """Install the package; return 1, after a sentence, if that is impossible."""
        hooks = list(additional_hooks or ())
        try:
            with _prefixes_on_path(self.context.dependencies.values()):
                hooks += self._install()
        except (CMakeSyntaxError, InstallError, *_FAULTS) as error:
            self._say(str(error))
            return 1
        except OSError as error:
            self._say(f"{error.filename}: {error.strerror}")
            return 1
        finally:
            self._write_scripts(hooks)
        return 0

    def _install(self) -> list[Path]:
        """Install the package, and return the scripts that it adds to its environment."""
        args, package = self.context.args, self.context.pkg
        source, prefix = Path(args.path), Path(args.install_base)
        if not (source / "CMakeLists.txt").is_file():
            raise InstallError(
                f"{source}: a package of build type ament_cmake needs a CMakeLists.txt; for a package with setup.py, "
                "write <build_type>ament_python</build_type> into package.xml"
            )
        symlink = bool(args.symlink_install)
        plan = read_plan(source, prefix)
        self._remark(plan, source)
        installer = Installer(source, package.name, prefix, symlink=symlink)
        files: list[Path] = []
        errors: list[Exception] = []
        try:
            if plan.interfaces:
                installed = install_interfaces(source, package.name, plan.interfaces, prefix, symlink=symlink)
                for warning in installed.warnings:
                    self._say(warning)
                files += installed.files
        except _FAULTS as error:
            # Launch files, settings and descriptions don't need the interfaces.
            errors.append(error)
        try:
            installer.install(plan)
        except InstallError as error:
            errors.append(error)
        for warning in installer.warnings:
            self._say(warning)
        if errors:
            raise InstallError("\n".join(str(error) for error in errors))
        remove_former_files(Path(args.build_base), prefix, files + installer.files)
        return installer.hooks

    def _remark(self, plan: Plan, source: Path) -> None:
        """Print what of the CMakeLists.txt is left out."""
        path = source / "CMakeLists.txt"
        if plan.compiled:
            first = plan.compiled[0]
            part = "left out" if plan.is_left_out else "built without its C++"
            reason = f"{path}:{first.line} has {first.text}, which needs C++ and a ROS install"
            self.context.pkg.metadata[LEFT_OUT_KEY] = f"is {part}"
            self._say(f"{self.context.pkg.name} is {part}: {reason}")
        for remark in plan.unknown:
            # Of a package in C++, other commands are mostly about what isn't compiled.
            if not plan.is_cpp or remark.text.startswith("install("):
                self._say(f"{path}:{remark.line}: {remark.text}")


class BrokenTask(Task):
    """Print the fault of a package that can't be built."""

    async def build(self, *, additional_hooks: list[Any] | None = None) -> int:
        """Print the fault, write the scripts that colcon expects, and fail."""
        self._say(self.context.pkg.metadata[FAULT_KEY])
        self._write_scripts(additional_hooks)
        return 1

    async def test(self, *, additional_hooks: list[Any] | None = None) -> int:
        """Print the fault, and fail."""
        self._say(self.context.pkg.metadata[FAULT_KEY])
        return 1


class TestTask(Task):
    """Run the tests of `ament_add_pytest_test` and `add_launch_test`; the others of a CMakeLists.txt are CTest's."""

    __test__ = False  # for pytest

    async def test(self, *, additional_hooks: list[Any] | None = None) -> int:  # noqa: PT028
        """Run the tests; return 1, after a sentence, if that is impossible."""
        args = self.context.args
        try:
            plan = read_plan(Path(args.path), Path(args.install_base), testing=True)
        except (CMakeSyntaxError, OSError) as error:
            self._say(str(error))
            return 1
        tests = plan.tests
        if plan.is_cpp:
            tests = [test for test in plan.tests if not test.launches]
        if len(tests) < len(plan.tests):
            left_out = len(plan.tests) - len(tests)
            self._say(
                f"{self.context.pkg.name}: {left_out} launch test{'s' * (left_out > 1)} of its C++ left out"
            )
        if not tests:
            return 0
        if find_spec("pytest") is None:
            self._say(f"the tests of {self.context.pkg.name} can't run: pip install pytest")
            return 1
        try:
            return await run_pytest_tests(self.context, tests)
        except (OSError, RuntimeError) as error:
            self._say(f"the tests of {self.context.pkg.name} can't run: {error}")
            return 1


@contextmanager
def _prefixes_on_path(prefixes: Any) -> Iterator[None]:
    """Put the prefixes of a package's dependencies first on AMENT_PREFIX_PATH, where definitions are looked up.

    The block awaits nothing, so that no other task sees the change.
    """
    before = os.environ.get("AMENT_PREFIX_PATH")
    there = [str(prefix) for prefix in dict.fromkeys(prefixes) if Path(prefix).is_dir()]
    os.environ["AMENT_PREFIX_PATH"] = os.pathsep.join([*there, *([before] if before else [])])
    try:
        yield
    finally:
        if before is None:
            del os.environ["AMENT_PREFIX_PATH"]
        else:
            os.environ["AMENT_PREFIX_PATH"] = before
