"""Names in command-line arguments."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from typing import TYPE_CHECKING

from tfloom.cli.shared.errors import CommandError

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName


def full_name(name: str) -> str:
    """Return a name of the graph with its first slash."""
    return name if name.startswith("/") else f"/{name}"


def find_full_name(name: str, known: Collection[str], unknown: str) -> str:
    """Return the full one of the known names that a user has typed, perhaps without its first slash.

    Raises:
        CommandError: there is none; the text is `unknown`, with the nearest names.
    """
    full = full_name(name)
    if full not in known:
        raise CommandError(f"{unknown}{did_you_mean(full, known)}")
    return full


def full_topic_name(name: str, what: str = "topic") -> str:
    """Return a full name: `turtle1/pose` becomes `/turtle1/pose`. `what` is the kind of name, for the error.

    Raises:
        CommandError: it is not a valid name.
    """
    full = full_name(name)
    if not re.fullmatch(r"(/[A-Za-z_][A-Za-z0-9_]*)+", full):
        raise CommandError(
            f"'{name}' can't be a {what}'s name: each part between slashes has letters, digits and underscores, "
            "and does not begin with a digit"
        )
    return full


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return a line with up to three known names near to `name`, or an empty text."""
    import difflib

    near = difflib.get_close_matches(name, list(known), 3, 0.51)
    return f"\ndid you mean {or_list(near)}?" if near else ""


def way_to_package(package: str, known: Iterable[str]) -> str:
    """Return a line on how to make a package known that a workspace here holds, else the nearest known, or nothing."""
    from tfloom.workspace.unsourced import how_to_find

    hint = how_to_find(package)
    return f"\n{hint}" if hint else did_you_mean(package, known)


def or_list(names: Sequence[str]) -> str:
    """Return names joined as in a sentence: `a, b or c`."""
    return " or ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def named_node(name: str) -> NodeName:
    """Return a node of this name in the root namespace.

    Raises:
        CommandError: it is not a valid name of a node.
    """
    from tfloom.node.values.names import InvalidNodeNameException, validate_node_name
    from tfloom.rmw.base import NodeName

    try:
        validate_node_name(name)
    except InvalidNodeNameException as error:
        raise CommandError(str(error)) from None
    return NodeName("/", name)
