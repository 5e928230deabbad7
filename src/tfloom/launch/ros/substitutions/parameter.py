"""A parameter that SetParameter has set as a substitution: `$(param NAME)`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.substitution import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.ros.configurations import global_parameters
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["Parameter"]


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
