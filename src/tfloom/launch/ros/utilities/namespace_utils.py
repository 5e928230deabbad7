"""Namespaces: absolute or not, and one under another."""

from __future__ import annotations

from typing import TypeVar

__all__ = [
    "OptionalText",
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "prefix_namespace",
]

OptionalText = TypeVar("OptionalText", str, None)


def is_root_namespace(ns: str) -> bool:
    """Return whether a namespace is the root, `/`."""
    return ns == "/"


def is_namespace_absolute(ns: str) -> bool:
    """Return whether a namespace begins with a slash."""
    return ns.startswith("/")


def make_namespace_absolute(ns: OptionalText) -> OptionalText:
    """Return a namespace with a slash before it, unless it has one; None for None."""
    if ns is None or is_namespace_absolute(ns):
        return ns
    return f"/{ns}"


def prefix_namespace(base_ns: str | None, ns: str | None) -> str | None:
    """Return a namespace under another; an absolute one alone. It has no slash at its end."""
    if not ns:
        joined = base_ns or ns
    elif not base_ns or is_namespace_absolute(ns):
        joined = ns
    else:
        joined = f"{base_ns.rstrip('/')}/{ns}"
    if joined is None or is_root_namespace(joined):
        return joined
    return joined.rstrip("/")
