"""Whether two texts differ."""

from __future__ import annotations

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.substitutions.equals_substitution import EqualsSubstitution

__all__ = ["NotEqualsSubstitution"]


@expose_substitution("not-equals")
class NotEqualsSubstitution(EqualsSubstitution):
    """`false` if two values are equal, as `EqualsSubstitution` compares them, else `true`."""

    def perform(self, context: LaunchContext) -> str:
        """Return `true` or `false`."""
        return "false" if self._equal(context) else "true"
