"""The public Python names of a real ROS 2 Jazzy, as recorded: which modules define them, and which only import them.

`tests/golden/api_jazzy.json.gz` has what each module defines or lists in `__all__`, with signatures, and
`module_names.json` all that programs can import from it, with the module that defines it. `missing.txt` lists what
tfloom lacks of these, and why.
"""

from __future__ import annotations

import gzip
import json
import re
from collections.abc import Iterator
from fnmatch import fnmatchcase, translate
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from tools.facades.table import read_table

GOLDEN = Path(__file__).parents[2] / "tests" / "golden" / "api_jazzy.json.gz"
IMPORTED = GOLDEN.with_name("module_names.json")
MISSING = Path(__file__).with_name("missing.txt")

ONLY_IMPORTED = "the original's file imports it for itself; it is there in the module that defines it"

_OPENING, _CLOSING = "([{<", ")]}>"


class Name(NamedTuple):
    """A public name, or a member of a public class."""

    module: str
    path: str
    """Within the module: `Node`, `Node.get_name`."""
    kind: str
    """class, function, value, method, property, attribute or constant; import: the module only imports it."""
    signature: str
    """The recorded signature, a constant's value, or the module that defines an import; empty if there is none."""

    @property
    def full(self) -> str:
        """Module and path."""
        return f"{self.module}.{self.path}"


class Parameter(NamedTuple):
    """One parameter of a signature."""

    name: str
    kind: str
    """positional, keyword, or variable (`*args`, `**kwargs`)."""
    default: str | None
    """As source code; None if there is none."""


@cache
def recorded() -> dict[str, dict[str, Any]]:
    """Return the public names of a real ROS 2 Jazzy, by module."""
    with gzip.open(GOLDEN, "rt", encoding="utf-8") as file:
        modules: dict[str, dict[str, Any]] = json.load(file)
    return {module: _of_ros(entries) for module, entries in modules.items()}


def _of_ros(entries: dict[str, Any]) -> dict[str, Any]:
    """Return the names of a module without one of Python's own, which many of the original's files import."""
    return {name: entry for name, entry in entries.items() if name != "TYPE_CHECKING"}


@cache
def _homes() -> dict[str, dict[str, str]]:
    modules: dict[str, dict[str, str]] = json.loads(IMPORTED.read_text("utf-8"))
    return {
        module: {name: what.partition(" ")[2] for name, what in _of_ros(names).items()}
        for module, names in modules.items()
    }


def imported_from(module: str) -> dict[str, str]:
    """Return the names of a module, each with the module that defines it, which is empty for values."""
    return _homes().get(module, {})


def imported() -> dict[str, list[Name]]:
    """Return the names that each module of a real ROS 2 Jazzy has by importing them."""
    defined = recorded()
    return {
        module: [
            Name(module, name, "import", home)
            for name, home in names.items()
            if name not in defined.get(module, {})
        ]
        for module, names in _homes().items()
    }


def all_names() -> list[Name]:
    """Return all names: what modules define, the members of their classes, and what they import."""
    modules, imports = recorded(), imported()
    return [
        name
        for module in sorted({*modules, *imports})
        for name in (*names_of(module, modules.get(module, {})), *imports.get(module, []))
    ]


def names_of(module: str, entries: dict[str, Any]) -> Iterator[Name]:
    """Return the names in a module and the members of its classes, in order."""
    for name, entry in sorted(entries.items()):
        signature = entry.get("signature") or entry.get("init") or ""
        yield Name(module, name, entry["kind"], signature)
        for member, what in sorted(entry.get("members", {}).items()):
            if what is None:  # a member of an enumeration
                yield Name(module, f"{name}.{member}", "attribute", "")
            elif not isinstance(what, str):
                yield Name(module, f"{name}.{member}", "constant", repr(what))
            else:
                is_method = what.startswith("(")
                yield Name(module, f"{name}.{member}", *(("method", what) if is_method else (what, "")))


@cache
def missing() -> dict[str, str]:
    """Return the patterns of names that are missing or differ, each with its reason."""
    reasons: dict[str, str] = {}
    patterns: list[str] = []
    for line in MISSING.read_text("utf-8").splitlines():
        if line.startswith("    "):
            reasons.update(dict.fromkeys(patterns, line.strip()))
            patterns = []
        elif line and not line.startswith("#"):
            patterns.append(line)
    return reasons


def reason_for(name: Name, reasons: dict[str, str]) -> str | None:
    """Return the reason why a name is missing or differs; None if it does neither."""
    if is_only_imported(name):
        return ONLY_IMPORTED
    if not _any_pattern().match(name.full):
        return None
    return next((reason for pattern, reason in reasons.items() if is_of(name, pattern)), None)


@cache
def _any_pattern() -> re.Pattern[str]:
    """Return an expression for what a pattern of `missing.txt` may match, because most names are matched by none."""
    patterns = [pattern.removesuffix("()") for pattern in missing()]
    return re.compile("|".join(translate(name) for pattern in patterns for name in (pattern, f"{pattern}.*")))


def is_missing(full: str) -> bool:
    """Return whether `missing.txt` names a name of a module; one that is there and differs isn't missing."""
    return _any_pattern().match(full) is not None and any(
        not pattern.endswith("()") and fnmatchcase(full, pattern) for pattern in missing()
    )


def is_only_imported(name: Name) -> bool:
    """Return whether a name is none of a façade's, because the original only imports it there for itself.

    Packages with `keeps_imports: false` in the table have, of these names, those that a program was seen to import.
    """
    package = read_table().get(name.module.split(".")[0])
    if name.kind != "import" or package is None or package.keeps_imports or name.signature == name.module:
        return False
    facade = package.modules.get(name.module)
    return facade is None or name.path not in {*facade.also, *facade.seen, *(facade.names or ())}


def is_of(name: Name, pattern: str) -> bool:
    """Return whether a pattern of `missing.txt` matches a name."""
    if pattern.endswith("()"):
        return name.kind in {"class", "function"} and name.full == pattern[:-2]
    return fnmatchcase(name.full, pattern) or fnmatchcase(name.full, f"{pattern}.*")


def parameters_of(signature: str) -> list[Parameter]:
    """Return the parameters in a recorded signature, without `self` and `cls`."""
    parameters: list[Parameter] = []
    kind = "positional"
    for part in _split(signature[1:]):
        name = part.split(":")[0].split("=")[0].strip()
        if name == "*":
            kind = "keyword"
        elif name.startswith("*"):
            parameters.append(Parameter(name, "variable", None))
            kind = "keyword"
        elif name not in {"self", "cls", "/"}:
            parameters.append(Parameter(name, kind, _default(part)))
    return parameters


def _split(text: str) -> list[str]:
    """Return the parts between commas up to the closing parenthesis; commas in brackets and quotes do not separate."""
    parts, part, depth, quote = [], "", 0, ""
    for letter in text:
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        elif letter in _OPENING:
            depth += 1
        elif letter in _CLOSING:
            if depth == 0:
                break
            depth -= 1
        if letter == "," and depth == 0 and not quote:
            parts.append(part)
            part = ""
        else:
            part += letter
    return [text.strip() for text in (*parts, part) if text.strip()]


def _default(part: str) -> str | None:
    depth = 0
    for place, letter in enumerate(part):
        depth += (letter in _OPENING) - (letter in _CLOSING)
        if letter == "=" and depth == 0:
            return part[place + 1 :].strip()
    return None
