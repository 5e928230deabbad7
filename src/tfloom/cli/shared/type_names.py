"""Known types near to an unknown name."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable

from tfloom.cli.shared.names import or_list
from tfloom.common.terminal import report
from tfloom.workspace.interfaces import known_interfaces

FAMILIAR = ("std_msgs", "geometry_msgs", "sensor_msgs", "nav_msgs", "tf2_msgs", "std_srvs", "turtlesim")
"""Packages preferred to others with an interface of the same name."""
NEAR = 0.7
"""The least similarity, from 0 to 1, of a near name."""
SPREAD = 0.03
"""The largest difference in similarity from the nearest name."""
SAME_BASE = 0.95
"""Similarity of names that differ only before the last slash, or in upper and lower case."""


def did_you_mean_type(name: str, kind: str, live: Collection[str] = ()) -> str:
    """Return a line with the types of a kind (msg, srv, action) nearest to a name, or an empty text.

    Of types that are equally near, those in `live` are first, then those of familiar packages.
    """
    near = nearest_types(name, known_interfaces(kind) + list(live), live)
    return f"\ndid you mean {or_list(near)}?" if near else ""


def warn_if_unknown(name: str, kind: str, live: Collection[str]) -> None:
    """Print a line on stderr, with the nearest types, if a type is neither known here nor in `live`."""
    if name not in live and name not in known_interfaces(kind):
        what = {"msg": "message", "srv": "service"}.get(kind, kind)
        report(f"there is no {what} type '{name}'{did_you_mean_type(name, kind, live)}")


def nearest_types(name: str, known: Iterable[str], live: Collection[str] = ()) -> list[str]:
    """Return up to three known names near to a name, the nearest first; see `did_you_mean_type`."""
    likeness = {candidate: _likeness(name, candidate) for candidate in known}
    best = max(likeness.values(), default=0.0)
    near = [candidate for candidate, like in likeness.items() if like >= max(NEAR, best - SPREAD)]
    return sorted(
        near, key=lambda candidate: (candidate not in live, -likeness[candidate], _rank(candidate), candidate)
    )[:3]


def _likeness(name: str, type_name: str) -> float:
    name, type_name = name.lower(), type_name.lower()
    base, known_base = name.rpartition("/")[2], type_name.rpartition("/")[2]
    if name == type_name or base == known_base:
        return 1.0 if "/" not in name or name == type_name else SAME_BASE
    if "/" not in name:
        return SAME_BASE * _ratio(base, known_base)
    if name.count("/") == 1:
        package, _, last = type_name.partition("/")
        type_name = f"{package}/{last.rpartition('/')[2]}"
    return SAME_BASE * _ratio(name, type_name)


def _ratio(name: str, known: str) -> float:
    """Return difflib's similarity of two texts; 0 if it is too small for a near name, which most are at a glance."""
    least = NEAR / SAME_BASE
    if 2 * min(len(name), len(known)) < least * (len(name) + len(known)):
        return 0.0
    matcher = difflib.SequenceMatcher(None, name, known)
    return matcher.ratio() if matcher.quick_ratio() >= least else 0.0


def _rank(name: str) -> int:
    package = name.partition("/")[0]
    return FAMILIAR.index(package) if package in FAMILIAR else len(FAMILIAR)
