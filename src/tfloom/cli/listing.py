"""Lists as text and as JSON."""

from __future__ import annotations

import sys
from collections.abc import Collection
from typing import Any

from tfloom import terminal_text
from tfloom.cli.json_text import json_text


def print_names(names: Collection[str], *, as_json: bool = False, only_count: bool = False) -> None:
    """Print one name on each line, or all as a JSON list, or their number."""
    if as_json:
        print_json(list(names))
    elif only_count:
        print(len(names))
    else:
        is_terminal = terminal_text.is_terminal(sys.stdout)
        for name in names:
            print(terminal_text.shown_name(name) if is_terminal else name)


def print_json(value: Any) -> None:
    """Print a value as JSON, indented."""
    print(json_text(value, indent=2))
