"""A name that no other launch uses."""

from __future__ import annotations

import os

from tfloom.launch.core.base_classes import ParsedSubstitution, SomeSubstitutionsType, Substitution, described
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["AnonName"]


@expose_substitution("anon")
class AnonName(ParsedSubstitution):
    """A name made unique: the same for the same text everywhere in a launch, and another in each launch.

    Args:
        name: The text that the name begins with.
    """

    _arguments = ("name",)
    _fault = "anon substitution expects 1 argument"

    def __init__(self, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)

    @property
    def name(self) -> list[Substitution]:
        """Text that the name begins with."""
        return self._name

    def describe(self) -> str:
        """Return a description for people."""
        return f"AnonName({described(self._name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the name, which is made at the first call in a launch."""
        name = perform_substitutions(context, self._name)
        names = context.launch_configurations
        if "anon" + name not in names:
            names["anon" + name] = self.compute_name(name)
        return names["anon" + name]

    def compute_name(self, id_value: str) -> str:
        """Return a new name: the text, the host's name, the process id and a random number, as ROS allows them."""
        import random
        import socket

        number = random.randint(0, 2**63 - 1)  # noqa: S311  # it has to be unlikely, not secret
        name = f"{id_value}_{socket.gethostname()}_{os.getpid()}_{number}"
        return name.translate(str.maketrans(".-:", "___"))
