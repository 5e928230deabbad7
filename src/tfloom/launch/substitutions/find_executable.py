"""The path of an executable."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.missing import marked_as_missing
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.find_program import find_program
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["FindExecutable"]


@expose_substitution("find-exec")
class FindExecutable(Substitution):
    """The path of an executable that PATH leads to, or that the environment has whose Python launches.

    Args:
        name: Name of the executable.
    """

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[FindExecutable], dict[str, Any]]:
        """Return the class and the arguments of `$(find-exec name)`.

        Raises:
            AttributeError: there is not exactly one argument.
        """
        if len(data) != 1:
            raise AttributeError("find-exec substitution expects 1 argument")
        return cls, {"name": data[0]}

    @property
    def name(self) -> list[Substitution]:
        """Name of the executable."""
        return self._name

    def describe(self) -> str:
        """Return a description for people."""
        return f"FindExec({described(self._name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: no folder of PATH has the executable, nor has the environment that launches.
        """
        name = perform_substitutions(context, self._name)
        path = find_program(context, name)
        if path is None:
            raise marked_as_missing(SubstitutionFailure(f"executable '{name}' not found on the PATH"))
        return path
