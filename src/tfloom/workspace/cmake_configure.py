"""`configure_file` of CMakeLists.txt: a file with variables in it, as the command writes it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from tfloom.workspace.cmake_syntax import MAX_CHARACTERS
from tfloom.workspace.cmake_values import FALSE_VALUES, TooMuchError, Variables

_AT = r"@([A-Za-z0-9_./+-]+)@"
_BRACES = r"\$\{([A-Za-z0-9_./+-]+)\}"
_DEFINE = re.compile(r"^([ \t]*#[ \t]*)cmakedefine(01)?[ \t]+([A-Za-z0-9_]+)(.*)$", re.MULTILINE)


def configured(path: Path, variables: Variables, options: Sequence[str]) -> bytes:
    """Return the content of a file with its variables replaced.

    Args:
        path: The file.
        variables: By name; one that isn't set is empty.
        options: Those of the command: with `COPYONLY` nothing is replaced, with `@ONLY` only `@NAME@`.

    Raises:
        TooMuchError: the file has more than MAX_CHARACTERS bytes, or its variables take too many characters.
        OSError: it can't be read.
    """
    with path.open("rb") as file:
        data = file.read(MAX_CHARACTERS + 1)
    if len(data) > MAX_CHARACTERS:
        raise TooMuchError(f"{path} has more than {MAX_CHARACTERS} bytes")
    if "COPYONLY" in options:
        variables.count(len(data))
        return data
    # Bytes that aren't UTF-8 pass through unchanged.
    text = data.decode("utf-8", "surrogateescape")
    variables.count(len(text))
    text = _DEFINE.sub(lambda match: _definition(match, variables), text)
    reference = _AT if "@ONLY" in options else f"{_AT}|{_BRACES}"
    text = re.sub(reference, lambda match: variables.read(match[match.lastindex or 1]), text)
    return text.encode("utf-8", "surrogateescape")


def _definition(match: re.Match[str], variables: Variables) -> str:
    """Return the line of C that a `#cmakedefine` stands for."""
    start, as_number, name, rest = match.groups()
    is_on = variables.read(name).upper() not in FALSE_VALUES
    if as_number:
        return f"{start}define {name} {int(is_on)}"
    return f"{start}define {name}{rest}" if is_on else f"/* #undef {name} */"
