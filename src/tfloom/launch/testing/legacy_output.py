"""Checks of output as the older LaunchTestService has them. PYTEST_DONT_REWRITE."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from tfloom.launch.testing.output import (
    expected_output_from_file,
    get_default_filtered_patterns,
    get_default_filtered_prefixes,
)
from tfloom.launch.testing.ros.output import basic_output_filter, get_rmw_output_filter

__all__ = [
    "create_output_lines_filter",
    "create_output_lines_test",
    "create_output_regex_test",
    "create_output_test_from_file",
    "get_default_filtered_patterns",
    "get_default_filtered_prefixes",
    "get_rmw_output_filter",
]

Check = Callable[[str], None]


def create_output_lines_filter(
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str | re.Pattern[str]] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """Return a function that takes a text, and returns it without the lines that are ignored."""
    return basic_output_filter(filtered_prefixes, filtered_patterns, filtered_rmw_implementation)


def create_output_lines_test(expected_lines: Sequence[str]) -> tuple[Check, list[str]]:
    """Return a check that an output has some lines, in any order, and these lines.

    The check takes the output, and raises AssertionError if a line is missing.
    """
    lines = list(expected_lines)

    def check(output: str) -> None:
        there = output.splitlines()
        missing = [line for line in lines if line not in there]
        if missing:
            raise AssertionError(f"lines are missing in the output: {missing}")

    return check, lines


def create_output_regex_test(
    expected_patterns: Sequence[str | re.Pattern[str]],
) -> tuple[Check, list[re.Pattern[str]]]:
    """Return a check that each of some patterns matches from the start of an output or of a line, and these patterns.

    The check takes the output, and raises AssertionError if a pattern matches none.
    """
    patterns = [re.compile(pattern) for pattern in expected_patterns]

    def check(output: str) -> None:
        there = output.splitlines()
        missing = [
            pattern.pattern
            for pattern in patterns
            if not any(pattern.match(text) for text in (output, *there))
        ]
        if missing:
            raise AssertionError(f"no line of the output matches: {missing}")

    return check, patterns


def create_output_test_from_file(output_file: str | Path) -> tuple[Check, list[str] | list[re.Pattern[str]]]:
    """Return the check of the lines of `FILE.txt`, or of the patterns of `FILE.regex`.

    Raises:
        RuntimeError: there is neither file.
    """
    expected = expected_output_from_file(output_file)
    patterns = [line for line in expected if isinstance(line, re.Pattern)]
    if patterns:
        return create_output_regex_test(patterns)
    return create_output_lines_test([line for line in expected if isinstance(line, str)])
