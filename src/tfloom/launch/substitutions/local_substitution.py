"""The value of a variable of the context."""

from __future__ import annotations

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type

__all__ = ["LocalSubstitution"]


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
