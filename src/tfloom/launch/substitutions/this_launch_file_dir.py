"""The folder of the launch file that is being launched."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure

__all__ = ["ThisLaunchFileDir"]


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
        found = context.get_locals_as_dict().get("current_launch_file_directory")
        if found is None:
            raise SubstitutionFailure("ThisLaunchFileDir used outside of a launch file (in a script)")
        return str(found)
