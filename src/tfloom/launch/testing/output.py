"""Expected output of processes, and filters of lines that tests ignore."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from tfloom.launch.testing.text import (
    Expected,
    build_line_match,
    build_text_match,
    remove_ansi_escape_sequences,
)

__all__ = [
    "basic_output_filter",
    "expect_output",
    "expected_output_from_file",
    "get_default_filtered_patterns",
    "get_default_filtered_prefixes",
]


def get_default_filtered_prefixes() -> list[str]:
    """Return the beginnings of lines that are ignored: those of lines with a process's id and its exit code."""
    return ["pid", "rc"]


def get_default_filtered_patterns() -> list[str]:
    """Return the patterns of lines that are ignored: none."""
    return []


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str | re.Pattern[str]] | None = None,
) -> Callable[[str], str]:
    """Return a function that takes a text, and returns it without the lines that are ignored.

    Args:
        filtered_prefixes: Beginnings of these lines; None for `get_default_filtered_prefixes()`.
        filtered_patterns: Patterns, of which one matches the beginning of such a line; None for
            `get_default_filtered_patterns()`.
    """
    prefixes = tuple(get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    expressions = get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns
    patterns = [re.compile(pattern) for pattern in expressions]

    def keeps(line: str) -> bool:
        return not line.startswith(prefixes) and not any(pattern.match(line) for pattern in patterns)

    def without_ignored(output: str) -> str:
        return "".join(line for line in output.splitlines(keepends=True) if keeps(line))

    return without_ignored


def expect_output(
    text: str | None = None,
    *,
    lines: Sequence[str] | None = None,
    expected_text: Expected | None = None,
    expected_lines: Expected | None = None,
    strip_ansi_escape_sequences: bool = True,
    strict: bool = False,
) -> bool:
    """Return whether a text, or lines, have what is expected.

    Args:
        text: The text; in place of `lines`.
        lines: The lines.
        expected_text: What is expected, as a text, a pattern or several that follow one another; in place of
            `expected_lines`.
        expected_lines: What is expected, each in a line after that of the one before.
        strip_ansi_escape_sequences: Whether codes for colours are removed first.
        strict: Whether it is at the begin, lines without others between, and texts at the begin of their lines. More
            may follow.

    Raises:
        ValueError: neither or both of `expected_text` and `expected_lines`, or of `text` and `lines`, are given.
    """
    if (expected_text is None) == (expected_lines is None):
        raise ValueError("Either expected lines or text, but not both, must be specified")
    if (text is None) == (lines is None):
        raise ValueError("Either lines or text, but not both, must be specified")
    whole = text if text is not None else os.linesep.join(lines or ())
    if strip_ansi_escape_sequences:
        whole = remove_ansi_escape_sequences(whole)
    if expected_lines is not None:
        return build_line_match(expected_lines, strict=strict)(whole.splitlines()) is not None
    expected: Expected = expected_text if expected_text is not None else ""
    return build_text_match(expected, strict=strict)(whole) is not None


def expected_output_from_file(path: str | Path, encoding: str | None = None) -> list[str | re.Pattern[str]]:
    """Return the lines of `PATH.txt`, or those of `PATH.regex` as patterns.

    Args:
        path: The file, without its suffix.
        encoding: Of the file; None for UTF-8.

    Raises:
        RuntimeError: there is neither file.
    """
    text, patterns = Path(f"{path}.txt"), Path(f"{path}.regex")
    if text.is_file():
        return list(text.read_bytes().decode(encoding or "utf-8").splitlines())
    if patterns.is_file():
        return [re.compile(line) for line in patterns.read_bytes().decode(encoding or "utf-8").splitlines()]
    raise RuntimeError(f"could not find output check file: neither {text} nor {patterns} is there")
