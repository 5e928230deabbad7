"""The path of an executable."""

from __future__ import annotations

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.missing import marked_as_missing
from tfloom.launch.core.substitution import (
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.substitutions.parsed import ParsedSubstitution
from tfloom.launch.utilities.find_program import find_program
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["FindExecutable"]


@expose_substitution("find-exec")
class FindExecutable(ParsedSubstitution):
    """The path of an executable that PATH leads to, or that the environment has whose Python launches.

    Args:
        name: Name of the executable.
    """

    _arguments = ("name",)
    _fault = "find-exec substitution expects 1 argument"
    _error = AttributeError

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)

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
