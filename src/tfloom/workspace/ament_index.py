"""The functions of `ament_index_python.cli`: the resources of the ament index, printed."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

from tfloom.workspace.ament import get_resource, get_resource_types, get_resources, has_resource

__all__ = ["main", "resource_name_completer", "resource_type_completer"]


def main(argv: Sequence[str] | None = None) -> str | None:
    """Print the types of all resources, the resources of one type with their prefixes, or one with its content.

    Args:
        argv: The type and the name, both optional; None: those of the command line.

    Returns:
        The text of an error, for `sys.exit`; None if there is none.
    """
    parser = argparse.ArgumentParser(description="Print the resources of the ament index.")
    add = parser.add_argument
    add(
        "resource_type", nargs="?", help="print the resources of this type"
    ).completer = resource_type_completer  # type: ignore[attr-defined]  # argcomplete's
    add(
        "resource_name", nargs="?", help="print prefix and content of this resource"
    ).completer = resource_name_completer  # type: ignore[attr-defined]  # argcomplete's
    args = parser.parse_args(argv)
    if args.resource_type is None:
        print("\n".join(sorted(get_resource_types())))
        return None
    try:
        if args.resource_name is None:
            return _print_names(args.resource_type)
        return _print_content(args.resource_type, args.resource_name)
    except ValueError as error:
        return str(error)


def _print_names(resource_type: str) -> str | None:
    prefixes = get_resources(resource_type)
    if not prefixes:
        return f"No resources of the type '{resource_type}'"
    for name, prefix in sorted(prefixes.items()):
        print(f"{name}\t{prefix}")
    return None


def _print_content(resource_type: str, name: str) -> str | None:
    if not has_resource(resource_type, name):
        return f"No resource '{name}' of the type '{resource_type}'"
    content, prefix = get_resource(resource_type, name)
    print(prefix)
    if content:
        print(content)
    return None


def resource_type_completer(prefix: str | tuple[str, ...], **_: Any) -> list[str]:
    """Return the types of resources that begin with a text."""
    return sorted(name for name in get_resource_types() if name.startswith(prefix))


def resource_name_completer(
    prefix: str | tuple[str, ...], parsed_args: argparse.Namespace, **_: Any
) -> list[str]:
    """Return the resources of the typed type that begin with a text."""
    resource_type = getattr(parsed_args, "resource_type", None)
    if not resource_type:
        return []
    return sorted(name for name in get_resources(resource_type) if name.startswith(prefix))
