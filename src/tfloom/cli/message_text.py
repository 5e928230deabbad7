"""How a message becomes the text that is printed."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

from tfloom.rosidl.message import Message

TRUNCATE_LENGTH = 128
"""How many elements of arrays, bytes and strings are printed when no flag says so."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags that say how a message becomes text."""
    parser.add_argument("--full-length", "-f", action="store_true", help="print arrays and strings whole")
    parser.add_argument(
        "--truncate-length",
        "-l",
        type=int,
        default=TRUNCATE_LENGTH,
        help=f"print so many elements of arrays, bytes and strings (default: {TRUNCATE_LENGTH})",
    )
    parser.add_argument("--no-arr", action="store_true", help="print what arrays are, not what they hold")
    parser.add_argument("--no-str", action="store_true", help="print what strings are, not what they hold")
    parser.add_argument("--flow-style", action="store_true", help="print collections in one line")


def message_text(args: argparse.Namespace) -> Callable[[Any], str]:
    """Return what turns a message, or a field of one, into the text to print."""
    options = text_options(args)

    def text(value: Any) -> str:
        from tfloom.rosidl import yaml_text

        if args.json and not args.raw:
            return _json(value)
        if not isinstance(value, Message):
            return f"{value}" if args.csv else f"{value}\n---"
        if args.csv:
            flags = {name: options[name] for name in ("truncate_length", "no_arr", "no_str")}
            return yaml_text.message_to_csv(value, **flags)
        return f"{yaml_text.message_to_yaml(value, **options)}---"

    return text


def text_options(args: argparse.Namespace) -> dict[str, Any]:
    """Return the keywords of `yaml_text.message_to_yaml` that the flags ask for."""
    return {
        "truncate_length": None if args.full_length else args.truncate_length,
        "no_arr": args.no_arr,
        "no_str": args.no_str,
        "flow_style": args.flow_style,
    }


def _json(value: Any) -> str:
    import json

    from tfloom.rosidl.yaml_text import message_to_ordereddict

    return json.dumps(
        message_to_ordereddict(value) if isinstance(value, Message) else value,
        default=_plain,
        ensure_ascii=False,
    )


def _plain(value: Any) -> Any:
    """Return what JSON can hold of an array, bytes or a message inside an array."""
    if isinstance(value, Message):
        from tfloom.rosidl.yaml_text import message_to_ordereddict

        return message_to_ordereddict(value)
    return list(value)
