"""Set an environment variable."""

from __future__ import annotations

from tfloom.launch.actions.named_value import NamedValue
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["SetEnvironmentVariable"]


@expose_action("set_env")
class SetEnvironmentVariable(NamedValue):
    """Sets an environment variable, when it is executed, for the processes that are started later in the scope.

    Args:
        name: Name of the variable; it may have substitutions.
        value: Its value; it may have substitutions.
        kwargs: As for Action.
    """

    def execute(self, context: LaunchContext) -> None:
        """Set it."""
        name = perform_substitutions(context, self.name)
        context.environment[name] = perform_substitutions(context, self.value)
