"""A condition that holds where a text is false."""

from __future__ import annotations

from tfloom.launch.conditions.if_condition import IfCondition
from tfloom.launch.launch_context import LaunchContext

__all__ = ["UnlessCondition"]


class UnlessCondition(IfCondition):
    """A condition that holds if a text is `false` or `0`, and not if it is `true` or `1`, in any case."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the text is false now.

        Raises:
            InvalidConditionExpressionError: it is neither true nor false.
        """
        return not super().evaluate(context)
