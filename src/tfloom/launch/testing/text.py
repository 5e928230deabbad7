"""Matches of expected texts: a text, a pattern, or several, in what a process has printed."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TypeAlias

__all__ = [
    "Expected",
    "Match",
    "build_line_match",
    "build_text_match",
    "normalize_lineseps",
    "remove_ansi_escape_sequences",
]

Match: TypeAlias = tuple[int, int]
"""Begin and end: of characters, or of lines."""
Expected: TypeAlias = "str | re.Pattern[str] | Iterable[Expected]"
"""A text, a compiled pattern, or several of them, which follow one another."""

_ANSI_ESCAPE = re.compile(r"\x1b\[[0-9;?]*[ -/]*[@-~]")


def normalize_lineseps(lines: str) -> str:
    """Return a text with the line separators of this system."""
    return re.sub(r"\r\n|\r|\n", os.linesep, lines)


def remove_ansi_escape_sequences(string: str) -> str:
    """Return a text without the codes for colours and for moves of a terminal's cursor."""
    return _ANSI_ESCAPE.sub("", string)


def build_text_match(expected_text: Expected, *, strict: bool = False) -> Callable[[str], Match | None]:
    """Return a function that takes a text, and returns where what is expected begins and ends in it, or None.

    Args:
        expected_text: A text, a pattern, or several, of which each follows the one before.
        strict: Whether it is at the begin of the text; of several, each is at the begin of a line, without other lines
            between.

    Raises:
        ValueError: `expected_text` is of another type.
    """
    if isinstance(expected_text, str):
        return _match_text(normalize_lineseps(expected_text), strict)
    if isinstance(expected_text, re.Pattern):
        return _match_pattern(expected_text, strict)
    parts = list(_flat(expected_text))
    if strict:
        lines = build_line_match(parts, strict=True)

        def match_lines(actual_text: str) -> Match | None:
            return None if lines(actual_text.splitlines()) is None else (0, len(actual_text))

        return match_lines
    return _match_in_order([build_text_match(part) for part in parts])


def build_line_match(
    expected_lines: Expected, *, strict: bool = False
) -> Callable[[Sequence[str]], Match | None]:
    """Return a function that takes lines, and returns the numbers of the first and after the last that match, or None.

    A pattern matches at the begin of a line. A text may be anywhere in it; if it has line breaks, each of its lines.

    Args:
        expected_lines: A text, a pattern, or several: each is found in a line after that of the one before.
        strict: Whether they are the first lines, without other lines between, and each text is at the begin of its
            line.

    Raises:
        ValueError: `expected_lines` is of another type.
    """
    matches = [
        _match_line(line, strict) for part in _flat(expected_lines) for line in _expected_lines_of(part)
    ]

    def match_strictly(actual_lines: Sequence[str]) -> Match | None:
        if len(actual_lines) < len(matches):
            return None
        all_match = all(matches_line(line) for matches_line, line in zip(matches, actual_lines, strict=False))
        return (0, len(matches)) if all_match else None

    def match(actual_lines: Sequence[str]) -> Match | None:
        first, at = -1, 0
        for matches_line in matches:
            while at < len(actual_lines) and not matches_line(actual_lines[at]):
                at += 1
            if at == len(actual_lines):
                return None
            first = at if first < 0 else first
            at += 1
        return max(first, 0), at

    return match_strictly if strict else match


def _flat(expected: Expected) -> Iterator[str | re.Pattern[str]]:
    """Yield the texts and patterns of nested lists."""
    if isinstance(expected, (str, re.Pattern)):
        yield expected
    elif isinstance(expected, Iterable):
        for part in expected:
            yield from _flat(part)
    else:
        raise ValueError(f"a text, a pattern or a list of them is expected, and {expected!r} is none")


def _expected_lines_of(expected: str | re.Pattern[str]) -> Sequence[str | re.Pattern[str]]:
    return [expected] if isinstance(expected, re.Pattern) else expected.splitlines() or [""]


def _match_line(expected: str | re.Pattern[str], strict: bool) -> Callable[[str], bool]:
    if isinstance(expected, re.Pattern):
        return lambda line: expected.match(line) is not None
    return lambda line: line.startswith(expected) if strict else expected in line


def _match_text(expected: str, strict: bool) -> Callable[[str], Match | None]:
    def match(actual_text: str) -> Match | None:
        begin = actual_text.find(expected)
        return None if begin < 0 or (strict and begin > 0) else (begin, begin + len(expected))

    return match


def _match_pattern(expected: re.Pattern[str], strict: bool) -> Callable[[str], Match | None]:
    def match(actual_text: str) -> Match | None:
        regex_match = expected.match(actual_text) if strict else expected.search(actual_text)
        return None if regex_match is None else regex_match.span()

    return match


def _match_in_order(matches: Sequence[Callable[[str], Match | None]]) -> Callable[[str], Match | None]:
    def match(actual_text: str) -> Match | None:
        first, at = -1, 0
        for find in matches:
            span = find(actual_text[at:])
            if span is None:
                return None
            first = at + span[0] if first < 0 else first
            at += span[1]
        return max(first, 0), at

    return match
