"""Substitutions for the launch file itself, its folder and the folder of logs."""

from __future__ import annotations

from typing import ClassVar

from tfloom.launch.core.base_classes import ParsedSubstitution, SubstitutionFailure
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.logs.logging import launch_config

__all__ = ["LaunchLogDir", "ThisLaunchFile", "ThisLaunchFileDir"]


class _OfLaunchFile(ParsedSubstitution):
    """A path that the context has while a launch file is launched."""

    _local: ClassVar[str]
    """Name of the context's variable that has it."""

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}()"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: no launch file is being launched.
        """
        path = context.get_locals_as_dict().get(self._local)
        if path is None:
            raise SubstitutionFailure(f"{type(self).__name__} used outside of a launch file (in a script)")
        return str(path)


@expose_substitution("filename")
class ThisLaunchFile(_OfLaunchFile):
    """The absolute path of the launch file that the substitution is in."""

    _fault = "filename substitution doesn't expect arguments"
    _local = "current_launch_file_path"


@expose_substitution("dirname")
class ThisLaunchFileDir(_OfLaunchFile):
    """The absolute folder of the launch file that the substitution is in."""

    _fault = "dirname substitution doesn't expect arguments"
    _local = "current_launch_file_directory"


@expose_substitution("launch_log_dir")
@expose_substitution("log_dir")
class LaunchLogDir(ParsedSubstitution):
    """The absolute path of the folder of the launch's log."""

    _fault = "launch_log_dir/log_dir substitution doesn't expect arguments"

    def describe(self) -> str:
        """Return a description for people."""
        return "LaunchLogDir()"

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        return launch_config.log_dir
