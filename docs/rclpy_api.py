"""Writes docs/rclpy_api.md: the public Python names of ROS 2 Jazzy, and which of them are there.

The names are those that a real ROS 2 Jazzy has: `tests/golden/api_jazzy.json.gz` lists what a module defines, with
signatures, and `module_names.json` whatever else can be imported from it, because it imports that itself; left out are
modules and what Python has (typing, the standard library). What isn't there stands with its reason in
`rclpy_api_missing.txt`. `make api` runs this, and tests/test_rclpy_api.py holds all of them to each other.
"""

from __future__ import annotations

import gzip
import importlib
import inspect
import json
from collections import Counter
from collections.abc import Iterator
from enum import Enum
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).parent
GOLDEN = HERE.parent / "tests" / "golden" / "api_jazzy.json.gz"
IMPORTED = GOLDEN.with_name("module_names.json")
MISSING = HERE / "rclpy_api_missing.txt"
PAGE = HERE / "rclpy_api.md"

HEAD = """\
# The Python names of ROS 2 Jazzy

What programs import from ROS 2 Jazzy's Python packages, name by name, with the parameters and their defaults. A tick
stands where tfloom has the name, and takes the parameters by the same names, in the same order, with the same
defaults; a test looks at each. Where a name isn't there, or differs, the reason stands instead. Programs import names
from modules that merely import them, too, as in `from rclpy.node import QoSProfile`: these stand below a module's
table, and are the objects of their home.

Written by `docs/rclpy_api.py` from what a real ROS 2 Jazzy has and from `docs/rclpy_api_missing.txt`; `make api`.
"""

_COMPILED = ("rclpy._rclpy_pybind11", "_tf2", "tf2")
"""Homes that programs don't import: the compiled modules of rclpy and tf2_py."""
_OPENING, _CLOSING = "([{<", ")]}>"


class Name(NamedTuple):
    """A public name, or a member of a public class."""

    module: str
    path: str
    """Within the module: `Node`, `Node.get_name`."""
    kind: str
    """class, function, value, method, property, attribute or constant; import: the module merely imports it."""
    signature: str
    """As recorded, a constant's value, or the home of an import; empty where there is none."""

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
    """As code; None where there is none."""


def recorded() -> dict[str, dict[str, Any]]:
    """Return the public names of a real ROS 2 Jazzy, by module."""
    with gzip.open(GOLDEN, "rt", encoding="utf-8") as file:
        modules: dict[str, dict[str, Any]] = json.load(file)
    return modules


def imported() -> dict[str, list[Name]]:
    """Return the names that each module of a real ROS 2 Jazzy has by importing them."""
    defined = recorded()
    modules: dict[str, dict[str, str]] = json.loads(IMPORTED.read_text("utf-8"))
    return {
        module: [
            Name(module, name, "import", what.partition(" ")[2])
            for name, what in names.items()
            if name not in defined.get(module, {})
        ]
        for module, names in modules.items()
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


def missing() -> dict[str, str]:
    """Return the patterns of names that aren't there, or differ, and the reason of each."""
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
    """Return why a name isn't there, or differs; None if it is."""
    return next((reason for pattern, reason in reasons.items() if is_of(name, pattern)), None)


def is_of(name: Name, pattern: str) -> bool:
    """Return whether a pattern of `rclpy_api_missing.txt` stands for a name."""
    if pattern.endswith("()"):
        return name.kind == "class" and name.full == pattern[:-2]
    return fnmatchcase(name.full, pattern) or fnmatchcase(name.full, f"{pattern}.*")


def parameters_of(signature: str) -> list[Parameter]:
    """Return the parameters in a recorded signature, but for `self` and `cls`."""
    found: list[Parameter] = []
    kind = "positional"
    for part in _split(signature[1:]):
        name = part.split(":")[0].split("=")[0].strip()
        if name == "*":
            kind = "keyword"
        elif name.startswith("*"):
            found.append(Parameter(name, "variable", None))
            kind = "keyword"
        elif name not in {"self", "cls", "/"}:
            found.append(Parameter(name, kind, _default(part)))
    return found


def _split(text: str) -> list[str]:
    """Return the parts between commas up to the closing parenthesis, leaving brackets and quotes whole."""
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
    return [each.strip() for each in (*parts, part) if each.strip()]


def _default(part: str) -> str | None:
    depth = 0
    for place, letter in enumerate(part):
        depth += (letter in _OPENING) - (letter in _CLOSING)
        if letter == "=" and depth == 0:
            return part[place + 1 :].strip()
    return None


# What is there


def differences(name: Name) -> Iterator[str]:
    """Return what is amiss with one name of ours: nothing where it serves as the recorded one does."""
    try:
        owner: Any = importlib.import_module(name.module)
    except ModuleNotFoundError:
        yield "there is no such module"
        return
    first, _, member = name.path.partition(".")
    if not hasattr(owner, first):
        yield "it isn't there"
        return
    thing = getattr(owner, first)
    if name.kind == "import":
        yield from _home_differences(thing, name)
    elif member:
        yield from _member_differences(thing, member, name)
    elif name.kind == "class":
        if not isinstance(thing, type):
            yield f"it is no class, but {thing!r}"
        elif name.signature:
            yield from _signature_differences(name.signature, thing.__init__)
    elif name.kind == "function":
        yield from _signature_differences(name.signature, thing)


def _home_differences(thing: Any, name: Name) -> Iterator[str]:
    """Compare with the object of the home's public module: `geometry_msgs.msg` for `geometry_msgs.msg._pose`."""
    if not name.signature or name.signature.startswith(_COMPILED):
        return
    home = name.signature.partition("._")[0]
    if getattr(importlib.import_module(home), thing.__name__, None) is not thing:
        yield f"it is {thing!r}, and not of {home}"


def _member_differences(owner: type, member: str, name: Name) -> Iterator[str]:
    if name.kind == "constant":
        found = getattr(owner, member, None)
        if found is None or repr(getattr(found, "value", found)) != name.signature:
            yield f"it is {found}, not {name.signature}"
        return
    if name.kind != "method":
        if not hasattr(owner, member) and not _instances_have(owner, member):
            yield "it isn't there"
        return
    if not hasattr(owner, member):
        yield "it isn't there"
    elif not callable(getattr(owner, member)):
        yield "it can't be called"
    elif not isinstance(getattr(owner, member), type):
        static = inspect.getattr_static(owner, member)
        yield from _signature_differences(name.signature, getattr(static, "__func__", static))


def _instances_have(owner: type, member: str) -> bool:
    if issubclass(owner, Enum):
        return hasattr(next(iter(owner)), member)
    for cls in owner.__mro__:
        if member in cls.__dict__.get("__slots__", ()) or member in inspect.get_annotations(cls):
            return True
        code = getattr(cls.__dict__.get("__init__"), "__code__", None)
        if code is not None and member in code.co_names:
            return True
    return False


def _signature_differences(signature: str, function: Any) -> Iterator[str]:
    try:
        ours = _our_parameters(function)
    except ValueError:  # a compiled function that doesn't tell
        return
    theirs = parameters_of(signature)
    takes_anything = any(each.kind == "variable" for each in ours)
    by_name = {each.name: each for each in ours}
    for expected in theirs:
        if expected.kind == "variable":
            continue
        found = by_name.get(expected.name)
        if found is None:
            if not takes_anything:
                yield f"it has no parameter {expected.name}"
        elif found.kind != expected.kind:
            yield f"its parameter {expected.name} is {found.kind}, not {expected.kind}"
        elif expected.default is not None and _differ(found, expected):
            yield f"the default of {expected.name} is {found.default}, not {expected.default}"
    order = [each.name for each in theirs if each.kind == "positional"]
    if (
        order != [each.name for each in ours if each.kind == "positional"][: len(order)]
        and not takes_anything
    ):
        yield f"its parameters come in another order than {', '.join(order)}"
    known = {each.name for each in theirs}
    if "*args" not in known:
        yield from (
            f"it wants a parameter {each.name} that the recorded one has not"
            for each in ours
            if each.name not in known and each.default is None and each.kind != "variable"
        )


def _our_parameters(function: Any) -> list[Parameter]:
    kinds = {
        inspect.Parameter.POSITIONAL_OR_KEYWORD: "positional",
        inspect.Parameter.POSITIONAL_ONLY: "positional",
        inspect.Parameter.KEYWORD_ONLY: "keyword",
    }
    return [
        Parameter(
            each.name,
            kinds.get(each.kind, "variable"),
            None if each.default is inspect.Parameter.empty else repr(each.default),
        )
        for each in inspect.signature(function).parameters.values()
        if each.name not in {"self", "cls"}
    ]


def _differ(found: Parameter, expected: Parameter) -> bool:
    """Return whether two defaults are values that can be read off both texts, and aren't the same."""
    if found.default is None:
        return True
    try:
        ours, theirs = (json.loads(_as_json(text or "")) for text in (found.default, expected.default))
    except ValueError:
        return False
    return bool(ours != theirs)


def _as_json(text: str) -> str:
    # A list that nobody changes does as a tuple.
    words = {"None": "null", "True": "true", "False": "false", "()": "[]"}
    return words.get(text, text.replace("'", '"'))


# The page


def page() -> str:
    """Return the text of docs/rclpy_api.md."""
    modules, imports, reasons = recorded(), imported(), missing()
    packages: dict[str, list[str]] = {}
    for module in sorted({*modules, *imports}):
        packages.setdefault(module.split(".")[0], []).append(module)
    names = all_names()
    lines = [HEAD, "| package | names | there | |", "|---|---|---|---|"]
    for package in packages:
        own = [name for name in names if name.module.split(".")[0] == package]
        there = sum(reason_for(name, reasons) is None for name in own)
        lines.append(f"| {package} | {len(own)} | {there} | {reasons.get(package, '')} |")
    homes = _homes(modules)
    for package, members in packages.items():
        if package not in reasons:
            for module in members:
                lines += ["", f"## {module}", ""]
                lines += _module_lines(
                    module, modules.get(module, {}), imports.get(module, []), reasons, homes
                )
    return "\n".join(lines) + "\n"


def _homes(modules: dict[str, dict[str, Any]]) -> dict[str, str]:
    """Return for each class that stands in many modules the one that it is listed in."""
    homes: dict[str, str] = {}
    times: Counter[str] = Counter()
    for module in sorted(modules, key=lambda module: (module.count("."), module)):
        for name, entry in modules[module].items():
            if entry["kind"] == "class":
                key = name + json.dumps(entry, sort_keys=True)
                homes[key] = module
                times[key] += 1
    return {key: module for key, module in homes.items() if times[key] > 1}


def _module_lines(
    module: str,
    entries: dict[str, Any],
    imports: list[Name],
    reasons: dict[str, str],
    homes: dict[str, str],
) -> list[str]:
    rows = []
    for name in names_of(module, entries):
        top = name.path.split(".")[0]
        home = homes.get(top + json.dumps(entries[top], sort_keys=True), module)
        reason = reason_for(name, reasons)
        if home != module and reason is None:
            if name.path == top:
                rows.append(f"| `{top}` | as in {home} |")
        else:
            rows.append(f"| `{_shown(name)}` | {reason or '✓'} |")
    there = [f"`{name.path}`" for name in imports if reason_for(name, reasons) is None]
    rows += [
        f"| `{name.path}` | {reason} |"
        for name in imports
        if (reason := reason_for(name, reasons)) is not None
    ]
    lines = ["| name | there |", "|---|---|", *rows] if rows else []
    if rows and there:
        lines.append("")
    if there:
        lines.append(f"Imported there, and here: {', '.join(there)}.")
    return lines


def _shown(name: Name) -> str:
    if not name.signature:
        return name.path
    if name.kind == "constant":
        return f"{name.path} = {name.signature}"
    texts = []
    kind = "positional"
    for each in parameters_of(name.signature):
        if each.kind == "keyword" and kind == "positional":
            texts.append("*")
        kind = "keyword" if each.kind != "positional" else kind
        texts.append(each.name if each.default is None else f"{each.name}={_short(each.default)}")
    return f"{name.path}({', '.join(texts)})".replace("|", "\\|")


def _short(default: str) -> str:
    return "…" if default.startswith("<") or len(default) > 40 else default


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
