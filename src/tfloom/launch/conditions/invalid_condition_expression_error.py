"""The error of a condition that is neither true nor false."""

from __future__ import annotations

from collections.abc import Sequence

from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described

__all__ = ["InvalidConditionExpressionError"]


class InvalidConditionExpressionError(ValueError):
    """A condition's text is neither true nor false.

    Args:
        expression: The text.
        unexpanded_expression: The substitutions whose text it is.
        valid_expressions: The texts that are allowed.
    """

    def __init__(
        self, expression: str, unexpanded_expression: Sequence[Substitution], valid_expressions: Sequence[str]
    ) -> None:
        super().__init__(
            f"invalid condition expression, expected one of [{', '.join(valid_expressions)}] "
            f"but got '{expression}', expanded from '{described(unexpanded_expression)}'"
        )
