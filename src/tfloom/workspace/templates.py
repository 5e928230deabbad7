"""Templates as `ament_package` fills them in: `@NAME@` is replaced by the value of NAME."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

__all__ = ["IS_WINDOWS", "configure_file", "configure_string"]

IS_WINDOWS = os.name == "nt"

_VARIABLE = re.compile(r"@([a-zA-Z0-9_]+)@")


def configure_file(template_file: str | os.PathLike[str], environment: Mapping[str, str]) -> str:
    """Return the text of a template file with its variables replaced, as `configure_string` does.

    Args:
        template_file: Path of the file, in UTF-8.
        environment: The values of the variables, by name.

    Raises:
        OSError: the file cannot be read.
    """
    return configure_string(Path(template_file).read_text("utf-8"), environment)


def configure_string(template: str, environment: Mapping[str, str]) -> str:
    """Return a template with each `@NAME@` replaced by the value of NAME, or by nothing if it has none.

    Args:
        template: The text.
        environment: The values of the variables, by name.
    """
    return _VARIABLE.sub(lambda match: environment.get(match[1], ""), template)
