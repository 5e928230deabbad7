"""The base class of substitutions, what arguments accept in their place, and the error of one that has no text."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Union

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.ros_imports.guard import ros_home, ros_repr

__all__ = [
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
    "Substitution",
    "SubstitutionFailure",
    "described",
]


class Substitution:
    """A text that is only known when the launch runs."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def perform(self, context: LaunchContext) -> str:
        """Return the text; derived classes implement it.

        Raises:
            NotImplementedError: the class has no `perform` of its own.
        """
        raise NotImplementedError(
            f"{type(self).__name__} has no method 'perform', which returns the substitution's text"
        )

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)


SomeSubstitutionsType = Union[str, Substitution, Iterable[str | Substitution]]
"""What an argument accepts where it takes substitutions: a text, a substitution, or a list of both, concatenated."""

SomeSubstitutionsType_types_tuple = (str, Substitution, Iterable)
"""The same for `isinstance`."""


class SubstitutionFailure(RuntimeError):  # noqa: N818  # ROS's name
    """A substitution cannot be performed.

    Args:
        msg: What is wrong.
    """

    __module__ = ros_home("launch.substitutions.substitution_failure", __name__)

    def __init__(self, msg: object) -> None:
        super().__init__(msg)


def described(substitutions: Iterable[Substitution]) -> str:
    """Return the descriptions of substitutions that are concatenated."""
    return " + ".join(substitution.describe() for substitution in substitutions)
