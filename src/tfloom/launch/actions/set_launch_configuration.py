"""Set a launch configuration."""

from __future__ import annotations

from tfloom.launch.actions.named_value import NamedValue
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["SetLaunchConfiguration"]


@expose_action("let")
class SetLaunchConfiguration(NamedValue):
    """Sets a launch configuration when it is executed; an earlier value is replaced.

    The configuration is a value of the running launch, which `LaunchConfiguration` substitutes. It lasts to the end of
    the scope: of the scoped group or else of the whole launch.

    Args:
        name: Name of the configuration; it may have substitutions.
        value: Its value; it may have substitutions.
        kwargs: As for Action.
    """

    def execute(self, context: LaunchContext) -> None:
        """Set it."""
        name = perform_substitutions(context, self.name)
        context.launch_configurations[name] = perform_substitutions(context, self.value)
