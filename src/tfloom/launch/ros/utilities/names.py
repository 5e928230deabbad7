"""Names and namespaces of nodes, and remap rules."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeVar

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions

__all__ = [
    "OptionalText",
    "RemapRule",
    "RemapRules",
    "SomeRemapRule",
    "SomeRemapRules",
    "add_node_name",
    "get_node_name_count",
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "normalize_remap_rule",
    "normalize_remap_rules",
    "prefix_namespace",
    "remappings_error",
]


SomeRemapRule = tuple[SomeSubstitutionsType, SomeSubstitutionsType]
"""A name and its replacement, as a launch file gives them."""

SomeRemapRules = Iterable[SomeRemapRule]

RemapRule = tuple[Sequence[Substitution], Sequence[Substitution]]
"""A name and its replacement, normalized."""

RemapRules = Iterable[RemapRule]

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
        joined = ns if base_ns is None else base_ns
    elif not base_ns or is_namespace_absolute(ns):
        joined = ns
    else:
        joined = f"{base_ns.rstrip('/')}/{ns}"
    if joined is None or is_root_namespace(joined):
        return joined
    return joined.rstrip("/")


def remappings_error(remap_rules: Any) -> TypeError | None:
    """Return the error of what Node(remappings=…) can't take, or None, for callers whose tracebacks shall be short."""
    for rule in remap_rules if isinstance(remap_rules, (list, tuple, dict)) else ():
        if not isinstance(rule, tuple):
            return TypeError(
                f"Expected 'remap_rule' to be one of [{tuple!r}], but got '{rule}' of type '{type(rule)}': "
                "write remappings=[('from', 'to')]"
            )
        if len(rule) != 2:
            return TypeError(f"remap_rule must be a tuple of length 2, got length {len(rule)}: {rule!r}")
    return None


def normalize_remap_rule(remap_rule: SomeRemapRule) -> RemapRule:
    """Return a name and its replacement, each as a tuple of substitutions.

    Raises:
        TypeError: it is not a tuple of two.
    """
    ensure_argument_type(remap_rule, tuple, "remap_rule")
    if len(remap_rule) != 2:
        raise TypeError(f"remap_rule must be a tuple of length 2, got length {len(remap_rule)}")
    name, replacement = remap_rule
    return (
        tuple(normalize_to_list_of_substitutions(name)),
        tuple(normalize_to_list_of_substitutions(replacement)),
    )


def normalize_remap_rules(remap_rules: SomeRemapRules) -> Iterator[RemapRule]:
    """Yield the remappings, normalized."""
    yield from map(normalize_remap_rule, remap_rules)


_KEY = "unique_ros_node_names"


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node of a full name."""
    _names(context)[node_name] += 1


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return the number of nodes that a launch has started with a full name."""
    return _names(context)[node_name]


def _names(context: LaunchContext) -> Counter[str]:
    if _KEY not in context.get_locals_as_dict():
        context.extend_globals({_KEY: Counter[str]()})
    names: Counter[str] = context.get_locals_as_dict()[_KEY]
    return names
