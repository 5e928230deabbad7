"""Substitutions for the launch file itself, its folder and the folder of logs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.logging import launch_config
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure

__all__ = ["LaunchLogDir", "ThisLaunchFile", "ThisLaunchFileDir"]


@expose_substitution("filename")
class ThisLaunchFile(Substitution):
    """The absolute path of the launch file that the substitution is in."""

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[ThisLaunchFile], dict[str, Any]]:
        """Return the class and the arguments of `$(filename)`.

        Raises:
            TypeError: there are arguments.
        """
        if data:
            raise TypeError("filename substitution doesn't expect arguments")
        return cls, {}

    def describe(self) -> str:
        """Return a description for people."""
        return "ThisLaunchFile()"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: no launch file is being launched.
        """
        path = context.get_locals_as_dict().get("current_launch_file_path")
        if path is None:
            raise SubstitutionFailure("ThisLaunchFile used outside of a launch file (in a script)")
        return str(path)


@expose_substitution("dirname")
class ThisLaunchFileDir(Substitution):
    """The absolute folder of the launch file that the substitution is in."""

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[ThisLaunchFileDir], dict[str, Any]]:
        """Return the class and the arguments of `$(dirname)`.

        Raises:
            TypeError: there are arguments.
        """
        if data:
            raise TypeError("dirname substitution doesn't expect arguments")
        return cls, {}

    def describe(self) -> str:
        """Return a description for people."""
        return "ThisLaunchFileDir()"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: no launch file is being launched.
        """
        folder = context.get_locals_as_dict().get("current_launch_file_directory")
        if folder is None:
            raise SubstitutionFailure("ThisLaunchFileDir used outside of a launch file (in a script)")
        return str(folder)


@expose_substitution("launch_log_dir")
@expose_substitution("log_dir")
class LaunchLogDir(Substitution):
    """The absolute path of the folder of the launch's log."""

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[LaunchLogDir], dict[str, Any]]:
        """Return the class and the arguments of `$(launch_log_dir)`.

        Raises:
            TypeError: there are arguments.
        """
        if data:
            raise TypeError("launch_log_dir/log_dir substitution doesn't expect arguments")
        return cls, {}

    def describe(self) -> str:
        """Return a description for people."""
        return "LaunchLogDir()"

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        return launch_config.log_dir
