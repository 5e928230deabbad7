"""The content of a file."""

from __future__ import annotations

from pathlib import Path

from tfloom.launch.core.base_classes import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["FileContent"]


@expose_substitution("file-content")
class FileContent(ParsedSubstitution):
    """The text of a file.

    Args:
        path: Path of the file, in UTF-8.
    """

    _arguments = ("path",)
    _fault = "file content substitutions expect 1 argument"
    _error = AttributeError

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__()
        self._path = normalize_to_list_of_substitutions(path)

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
