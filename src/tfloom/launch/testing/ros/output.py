"""Filters of what a wire prints by itself."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from tfloom.launch.testing import output
from tfloom.workspace import ament

__all__ = ["basic_output_filter", "get_rmw_output_filter"]


def get_rmw_output_filter(rmw_implementation: str, filter_type: str) -> list[str]:
    """Return the lines of a wire's filter, of the resource `rmw_output_<filter_type>` of its package.

    Args:
        rmw_implementation: Name of the wire.
        filter_type: `prefixes` or `patterns`.
    """
    resource = f"rmw_output_{filter_type}"
    if not ament.has_resource(resource, rmw_implementation):
        return []
    return [line for line in ament.get_resource(resource, rmw_implementation)[0].splitlines() if line]


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str | re.Pattern[str]] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """Return a function that takes a text, and returns it without the lines that are ignored.

    Args:
        filtered_prefixes: Beginnings of these lines; None for those of launch_testing.
        filtered_patterns: Patterns, of which one matches the beginning of such a line; None for none.
        filtered_rmw_implementation: Name of a wire, whose own lines are ignored, too.
    """
    prefixes = list(
        output.get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes
    )
    patterns = list(
        output.get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns
    )
    if filtered_rmw_implementation:
        prefixes += get_rmw_output_filter(filtered_rmw_implementation, "prefixes")
        patterns += get_rmw_output_filter(filtered_rmw_implementation, "patterns")
    return output.basic_output_filter(prefixes, patterns)
