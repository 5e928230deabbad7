"""Tests of pytest, as a process."""

from __future__ import annotations

import sys
from typing import Any

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.testing.actions.test import Test

__all__ = ["PyTest"]


class PyTest(Test):
    """Runs pytest.

    Args:
        path: Of the file or the folder with tests.
        timeout: Time after which it is shut down [s]; None for no limit.
        kwargs: As for ExecuteProcess.
    """

    def __init__(self, *, path: SomeSubstitutionsType, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(cmd=[sys.executable, "-m", "pytest", path], timeout=timeout, **kwargs)
        self._path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """Path of the file or the folder with tests."""
        return self._path
