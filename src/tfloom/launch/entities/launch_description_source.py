"""Where an included launch description comes from."""

from __future__ import annotations

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution, described
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["LaunchDescriptionSource"]


class LaunchDescriptionSource(HasPrivateNames):
    """Loads a launch description when it is needed.

    Args:
        launch_description: The description, if it is known already.
        location: The path of the file.
        method: How it is loaded, for people.
    """

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: SomeSubstitutionsType = "<string>",
        method: str = "unspecified mechanism from a script",
    ) -> None:
        self._launch_description = launch_description
        self._location: list[Substitution] = normalize_to_list_of_substitutions(location)
        self._method = method
        self._expanded_location: str | None = None

    @property
    def location(self) -> str:
        """Path of the file; before it is loaded, the description of its substitutions."""
        if self._expanded_location is not None:
            return self._expanded_location
        return described(self._location)

    @property
    def method(self) -> str:
        """How the description is loaded, for people."""
        return self._method

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """Load the description at the first call, and return it."""
        if self._expanded_location is None:
            self._expanded_location = perform_substitutions(context, self._location)
        if self._launch_description is None:
            self._launch_description = self._get_launch_description(self._expanded_location)
        return self._launch_description

    def location_without_context(self) -> str | None:
        """Return the location, or None if it isn't known before the launch."""
        try:
            return perform_substitutions(LaunchContext(), self._location)
        except Exception:  # any that a substitution raises without a context
            return None

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """Return the description if no substitution is needed to find it; None: one is, or it can't be loaded."""
        if self._launch_description is None:
            try:
                location = perform_substitutions(LaunchContext(), self._location)
                self._launch_description = self._get_launch_description(location)
            except Exception as error:  # of a user's file
                get_logger("launch").debug(f"not known before the launch: {self.location}: {error}")
        return self._launch_description

    def _get_launch_description(self, location: str) -> LaunchDescription:
        """Return the description of a file; derived classes implement it."""
        raise NotImplementedError(f"{type(self).__name__} has no method '_get_launch_description'")
