"""The value of an environment variable."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitutions.described import described
from tfloom.launch.substitutions.named_value import NamedValue
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["EnvironmentVariable"]


@expose_substitution("env")
class EnvironmentVariable(NamedValue):
    """The value of a variable in the context's environment.

    Args:
        name: Name of the variable.
        default_value: Text where there is no such variable; None: that is an error.
    """

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[EnvironmentVariable], dict[str, Any]]:
        """Return the class and the arguments of `$(env name default)`.

        Raises:
            TypeError: there are not one or two arguments.
        """
        if len(data) not in {1, 2}:
            raise TypeError("env substitution expects 1 or 2 arguments")
        return cls, dict(zip(("name", "default_value"), data, strict=False))

    def describe(self) -> str:
        """Return a description for people."""
        return f"EnvVar({described(self._name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the variable's value.

        Raises:
            SubstitutionFailure: there is no such variable, and no default.
        """
        name = perform_substitutions(context, self._name)
        value = context.environment.get(name)
        if value is not None:
            return value
        if self._default_value is None:
            near = did_you_mean(name, context.environment)
            raise SubstitutionFailure(f"environment variable '{name}' does not exist{near}")
        return perform_substitutions(context, self._default_value)
