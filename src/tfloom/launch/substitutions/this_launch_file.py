"""The path of the launch file that is being launched."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure

__all__ = ["ThisLaunchFile"]


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
        found = context.get_locals_as_dict().get("current_launch_file_path")
        if found is None:
            raise SubstitutionFailure("ThisLaunchFile used outside of a launch file (in a script)")
        return str(found)
