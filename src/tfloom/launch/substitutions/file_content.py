"""The content of a file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["FileContent"]


@expose_substitution("file-content")
class FileContent(Substitution):
    """The text of a file.

    Args:
        path: Path of the file, in UTF-8.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__()
        self._path = normalize_to_list_of_substitutions(path)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[FileContent], dict[str, Any]]:
        """Return the class and the arguments of `$(file-content path)`.

        Raises:
            AttributeError: there is not exactly one argument.
        """
        if len(data) != 1:
            raise AttributeError("file content substitutions expect 1 argument")
        return cls, {"path": data[0]}

    @property
    def path(self) -> list[Substitution]:
        """Path of the file."""
        return self._path

    def describe(self) -> str:
        """Return a description for people."""
        return f"FileContent({described(self._path)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the file's text.

        Raises:
            SubstitutionFailure: the file does not exist, or cannot be read as UTF-8.
        """
        path = perform_substitutions(context, self._path)
        try:
            return Path(path).read_text("utf-8")
        except FileNotFoundError as error:
            raise SubstitutionFailure(f"File not found: {path}") from error
        except (OSError, ValueError) as error:
            raise SubstitutionFailure(f"File cannot be read: {path}: {error}") from error
