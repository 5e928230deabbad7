"""Remappings in every form as tuples of substitutions."""

from __future__ import annotations

from collections.abc import Iterator

from tfloom.launch.ros.remap_rule_type import RemapRule, SomeRemapRule, SomeRemapRules
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["normalize_remap_rule", "normalize_remap_rules"]


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
