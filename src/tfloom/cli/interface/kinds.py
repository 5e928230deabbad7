"""The kinds of interfaces, and the flags that select some."""

from __future__ import annotations

import argparse

from tfloom.rosidl.definition_files import KINDS

TITLES = {"msg": "Messages", "srv": "Services", "action": "Actions"}


def add_kind_flags(parser: argparse.ArgumentParser) -> None:
    """Add the flags that select messages, services or actions only."""
    parser.add_argument("-m", "--only-msgs", action="store_true", help="messages only")
    parser.add_argument("-s", "--only-srvs", action="store_true", help="services only")
    parser.add_argument("-a", "--only-actions", action="store_true", help="actions only")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def requested_kinds(args: argparse.Namespace) -> list[str]:
    """Return the kinds that the flags select; all without a flag."""
    asked = dict(zip(KINDS, (args.only_msgs, args.only_srvs, args.only_actions), strict=True))
    return [kind for kind in KINDS if asked[kind]] or list(KINDS)
