"""Programs of GoogleTest."""

from __future__ import annotations

from typing import Any

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.testing.actions.test import Test

__all__ = ["GTest"]


class GTest(Test):
    """Runs a program that GoogleTest made.

    Args:
        path: Of the program.
        timeout: Time after which it is shut down [s]; None for no limit.
        kwargs: As for ExecuteProcess.
    """

    def __init__(self, *, path: SomeSubstitutionsType, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(cmd=[path], timeout=timeout, **kwargs)
        self._path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """Path of the program."""
        return self._path
