"""The folder of the launch's log."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.logging import launch_config
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution

__all__ = ["LaunchLogDir"]


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
