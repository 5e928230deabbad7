"""The refusal of launch files that include each other endlessly."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from tfloom.launch.core.invalid_launch_file_error import InvalidLaunchFileError
from tfloom.launch.core.launch_context import LaunchContext

__all__ = ["CircularIncludeError", "refuse_circle"]

_CHAIN = "included_launch_files"
_DEEPEST = 50


class CircularIncludeError(InvalidLaunchFileError):
    """A launch file includes itself, or others that include it.

    Args:
        files: The files of the circle; the last one is the first one again.
        problem: What is wrong with them.
    """

    def __init__(
        self, files: Sequence[str], problem: str = "launch files include each other in a circle"
    ) -> None:
        super().__init__()
        self.files = list(files)
        self._error_message = f"{problem}: {' -> '.join(self.files)}"


def refuse_circle(context: LaunchContext, path: str) -> None:
    """Note that a file is included now, in a variable of the context.

    A file may include itself if the launch configurations or the environment differ each time, because a condition may
    end that.

    Args:
        context: The context, whose variable `current_launch_file_path` is the including file, if any.
        path: Path of the included file.

    Raises:
        CircularIncludeError: the file includes itself with nothing changed, or 50 files include one another.
    """
    variables = context.get_locals_as_dict()
    including = variables.get("current_launch_file_path")
    chain: list[tuple[str, Any]] = list(variables.get(_CHAIN, ()))
    while chain and not _is_same_file(chain[-1][0], including):
        chain.pop()  # of a file that has been visited completely
    configurations: dict[str, Any] = dict(context.launch_configurations)
    for key, value in configurations.items():
        if isinstance(value, list):  # parameters and remappings, to which later actions add
            configurations[key] = list(value)
    state = (configurations, dict(context.environment))
    files = [file for file, _ in chain]
    for number, (file, earlier) in enumerate(chain):
        if _is_same_file(file, path) and earlier == state:
            raise CircularIncludeError([*files[number:], path])
    if len(chain) >= _DEEPEST:
        raise CircularIncludeError([*files[-3:], path], f"launch files are included {_DEEPEST} levels deep")
    context.extend_locals({_CHAIN: (*chain, (path, state))})


def _is_same_file(one: str, other: str | None) -> bool:
    return other is not None and os.path.realpath(one) == os.path.realpath(other)
