"""The variables of loops."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitutions.described import described
from tfloom.launch.substitutions.named_value import NamedValue
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["ForEachVar", "ForLoopIndex"]


@expose_substitution("for-var")
class ForEachVar(NamedValue):
    """The value that a variable of `ForEach` has in an iteration.

    Args:
        name: Name of the variable.
        default_value: Text in iterations that give it no value; None: that is an error.
    """

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[ForEachVar], dict[str, Any]]:
        """Return the class and the arguments of `$(for-var name default)`.

        Raises:
            ValueError: there are not one or two arguments.
        """
        if len(data) not in {1, 2}:
            raise ValueError(f"{cls.__name__} substitution expects 1 or 2 arguments")
        return cls, dict(zip(("name", "default_value"), data, strict=False))

    @classmethod
    def get_local_arg_name(cls, name: str) -> str:
        """Return the name of the context's variable that holds the value."""
        return f"ForEachVar__{name}"

    def describe(self) -> str:
        """Return a description for people."""
        default = described(self._default_value or [])
        return f"{type(self).__name__}(name={described(self._name)}, default_value={default})"

    def perform(self, context: LaunchContext) -> str:
        """Return the value in the current iteration.

        Raises:
            RuntimeError: the iteration gives no value, and there is no default.
        """
        name = perform_substitutions(context, self._name)
        value = getattr(context.locals, self.get_local_arg_name(name), None)
        if value is not None:
            return str(value)
        if self._default_value is None:
            raise RuntimeError(
                f"No value available for {type(self).__name__} '{name}' and no default value provided"
            )
        return perform_substitutions(context, self._default_value)


@expose_substitution("index")
class ForLoopIndex(ForEachVar):
    """The index of an iteration of `ForLoop`.

    Args:
        name: Name of the loop's index.
    """

    def __init__(self, name: SomeSubstitutionsType, **_kwargs: Any) -> None:
        super().__init__(name)
