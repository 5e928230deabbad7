"""Lists as text and as JSON."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from tfloom.cli.json_text import json_text


def print_names(names: Collection[str], *, as_json: bool = False, only_count: bool = False) -> None:
    """Print one name on each line, or all as a JSON list, or their number."""
    if as_json:
        print_json(list(names))
    elif only_count:
        print(len(names))
    else:
        for name in names:
            print(name)


def print_json(value: Any) -> None:
    """Print a value as JSON, indented."""
    print(json_text(value, indent=2))
