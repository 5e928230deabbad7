"""A condition on a value that a launch configuration does not have."""

from __future__ import annotations

from tfloom.launch.conditions.launch_configuration_equals import LaunchConfigurationEquals
from tfloom.launch.launch_context import LaunchContext

__all__ = ["LaunchConfigurationNotEquals"]


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """A condition that holds if a launch configuration does not have a value. Deprecated: use NotEqualsSubstitution."""

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the configuration has another value now, or none."""
        return not super().evaluate(context)
