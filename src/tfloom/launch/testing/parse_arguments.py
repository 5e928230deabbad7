"""Launch arguments of a command line."""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["parse_launch_arguments"]


def parse_launch_arguments(launch_arguments: Iterable[str]) -> list[tuple[str, str]]:
    """Return the names and values of arguments, of which each is `name:=value`; the last value of a name holds.

    Raises:
        RuntimeError: an argument has another form.
    """
    parsed: dict[str, str] = {}
    for argument in launch_arguments:
        name, separator, value = argument.partition(":=")
        if not name or not separator:
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        parsed[name] = value
    return list(parsed.items())
