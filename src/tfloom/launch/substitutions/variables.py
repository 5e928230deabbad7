"""Substitutions for values by their name."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tfloom.launch.core.base_classes import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.launch.utilities.texts import did_you_mean

__all__ = [
    "EnvironmentVariable",
    "ForEachVar",
    "ForLoopIndex",
    "LaunchConfiguration",
    "LocalSubstitution",
    "NamedValue",
]


class NamedValue(ParsedSubstitution):
    """The value of a name, as derived classes define.

    Args:
        name: The name.
        default_value: Text where the name has no value; None: that is an error.
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None
    ) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)
        self._default_value = (
            None if default_value is None else normalize_to_list_of_substitutions(default_value)
        )

    @property
    def name(self) -> list[Substitution]:
        """Name whose value is looked up, as substitutions."""
        return self._name

    @property
    def default_value(self) -> list[Substitution] | None:
        """Text where the name has no value."""
        return self._default_value


@expose_substitution("env")
class EnvironmentVariable(NamedValue):
    """The value of a variable in the context's environment.

    Args:
        name: Name of the variable.
        default_value: Text where there is no such variable; None: that is an error.
    """

    _arguments = ("name", "default_value")
    _optional = 1
    _fault = "env substitution expects 1 or 2 arguments"

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


@expose_substitution("var")
class LaunchConfiguration(ParsedSubstitution):
    """The value of a launch configuration, as arguments and SetLaunchConfiguration set it.

    Args:
        variable_name: Name of the configuration.
        default: Value where it isn't set: anything that has a text, or a list of such; None: that is an error.
    """

    _arguments = ("variable_name", "default")
    _optional = 1
    _fault = "var substitution expects 1 or 2 arguments"

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
            skipped = context.run_state.skipped_includes
            cause = f"; an included file that may set it was {' and was '.join(skipped)}" if skipped else ""
            raise SubstitutionFailure(f"launch configuration '{name}' does not exist{near}{cause}")
        return perform_substitutions(context, self._default)


class LocalSubstitution(Substitution):
    """The value of a variable in `context.locals`, or of an attribute of it.

    Args:
        expression: What would stand after `context.locals.` in Python, as `event.pid`.
        description: What describes it for people; None: the expression.
    """

    def __init__(self, expression: str, description: str | None = None) -> None:
        super().__init__()
        ensure_argument_type(expression, str, "expression", "LocalSubstitution")
        ensure_argument_type(description, (str, type(None)), "description", "LocalSubstitution")
        self._expression = expression
        self._description = description

    @property
    def expression(self) -> str:
        """What would stand after `context.locals.` in Python."""
        return self._expression

    @property
    def description(self) -> str | None:
        """What describes it for people."""
        return self._description

    def describe(self) -> str:
        """Return a description for people."""
        return f"LocalVar('{self._expression if self._description is None else self._description}')"

    def perform(self, context: LaunchContext) -> str:
        """Return the value as a text.

        Raises:
            SubstitutionFailure: the context has no such variable, or the expression fails.
        """
        try:
            # The launch file's author wrote the expression, as all of the launch file.
            return str(eval(f"context.locals.{self._expression}", {}, {"context": context}))  # noqa: S307
        except (AttributeError, LookupError, SyntaxError, TypeError, NameError) as error:
            raise SubstitutionFailure(f"LocalSubstitution '{self._expression}': {error}") from error


@expose_substitution("for-var")
class ForEachVar(NamedValue):
    """The value that a variable of `ForEach` has in an iteration.

    Args:
        name: Name of the variable.
        default_value: Text in iterations that give it no value; None: that is an error.
    """

    _arguments = ("name", "default_value")
    _optional = 1
    _fault = "{class_name} substitution expects 1 or 2 arguments"
    _error = ValueError

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
