"""The base class of substitutions of a value that has a name."""

from __future__ import annotations

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["NamedValue"]


class NamedValue(Substitution):
    """The value of a name, as derived classes define.

    Args:
        name: The name.
        default_value: Text where the name has no value; None: that is an error.
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None
    ) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)
        self._default_value = (
            None if default_value is None else normalize_to_list_of_substitutions(default_value)
        )

    @property
    def name(self) -> list[Substitution]:
        """The name."""
        return self._name

    @property
    def default_value(self) -> list[Substitution] | None:
        """Text where the name has no value."""
        return self._default_value
