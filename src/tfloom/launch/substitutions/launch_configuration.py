"""The value of a launch configuration."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["LaunchConfiguration"]


@expose_substitution("var")
class LaunchConfiguration(Substitution):
    """The value of a launch configuration, as arguments and SetLaunchConfiguration set it.

    Args:
        variable_name: Name of the configuration.
        default: Value where it isn't set: anything that has a text, or a list of such; None: that is an error.
    """

    def __init__(
        self, variable_name: SomeSubstitutionsType, *, default: Any | Iterable[Any] | None = None
    ) -> None:
        super().__init__()
        self._variable_name = normalize_to_list_of_substitutions(variable_name)
        self._default: list[Substitution] | None = None
        if default is not None:
            parts = default if isinstance(default, Iterable) and not isinstance(default, str) else [default]
            self._default = normalize_to_list_of_substitutions(
                [part if isinstance(part, (str, Substitution)) else str(part) for part in parts]
            )

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[LaunchConfiguration], dict[str, Any]]:
        """Return the class and the arguments of `$(var name default)`.

        Raises:
            TypeError: there are not one or two arguments.
        """
        if len(data) not in {1, 2}:
            raise TypeError("var substitution expects 1 or 2 arguments")
        return cls, dict(zip(("variable_name", "default"), data, strict=False))

    @property
    def variable_name(self) -> list[Substitution]:
        """Name of the configuration."""
        return self._variable_name

    def describe(self) -> str:
        """Return a description for people."""
        return f"LaunchConfig({described(self._variable_name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the configuration's value.

        Raises:
            SubstitutionFailure: it isn't set, and there is no default.
        """
        name = perform_substitutions(context, self._variable_name)
        if name in context.launch_configurations:
            return context.launch_configurations[name]
        if self._default is None:
            near = did_you_mean(name, context.launch_configurations)
            raise SubstitutionFailure(f"launch configuration '{name}' does not exist{near}")
        return perform_substitutions(context, self._default)
