"""The error of a launch file that cannot be loaded."""

from __future__ import annotations

from collections.abc import Sequence

from tfloom.ros_imports.guard import ros_home

__all__ = ["InvalidLaunchFileError"]


class InvalidLaunchFileError(Exception):
    """A launch file cannot be loaded.

    Args:
        extension: Extension of the file, without its dot; "" if it is none of a known format.
        likely_errors: What the parsers raised.
    """

    __module__ = ros_home("launch.invalid_launch_file_error", __name__)

    def __init__(self, extension: str = "", *, likely_errors: Sequence[Exception] | None = None) -> None:
        super().__init__()
        self._likely_errors = list(likely_errors or [])
        if not extension or not self._likely_errors:
            self._error_message = "The launch file may have a syntax error, or its format is unknown"
            return
        caught = "multiple exceptions" if len(self._likely_errors) > 1 else "exception"
        lines = [f"Caught {caught} when trying to load file of format [{extension}]:"]
        lines += [f" - {type(error).__name__}: {error}" for error in self._likely_errors]
        self._error_message = "\n".join(lines)
        self.__cause__ = self._likely_errors[0]

    @classmethod
    def with_message(cls, message: str, cause: Exception | None = None) -> InvalidLaunchFileError:
        """Return an error with its own text.

        Args:
            message: What is wrong, with the file and the line.
            cause: The error that shows it.
        """
        error = cls()
        error._likely_errors = [cause] if cause is not None else []
        error._error_message = message
        error.__cause__ = cause
        return error

    def __str__(self) -> str:
        return self._error_message
