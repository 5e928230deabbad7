"""Lists as text and as JSON."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Collection, Mapping
from typing import Any

from tfloom.cli.shared.json_text import json_text
from tfloom.common import terminal as terminal_text


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


def print_types(types: Mapping[str, Collection[str]], args: argparse.Namespace, *, only_count: bool) -> None:
    """Print one name on each line, with its types if the flags say so, or all as a JSON list, or their number."""
    if args.json:
        print_json([{"name": name, "types": list(kinds)} for name, kinds in types.items()])
    elif only_count:
        print(len(types))
    else:
        for name, kinds in types.items():
            print(f"{name} [{', '.join(kinds)}]" if args.show_types else name)


def print_json(value: Any) -> None:
    """Print a value as JSON, indented."""
    print(json_text(value, indent=2))
