"""The page of the site that lists the public Python names of ROS 2 Jazzy, and which of them tfloom has.

`conf.py` writes it as `rclpy_api.md` when the site is built, from the recorded names (`tools/facades/`), without
importing tfloom. tests/test_recorded_names.py compares the names and signatures themselves.
"""

from __future__ import annotations

import json
from collections import Counter
from typing import Any

from tools.facades.recorded import (
    Name,
    all_names,
    imported,
    is_only_imported,
    missing,
    names_of,
    parameters_of,
    reason_for,
    recorded,
)
from tools.facades.table import read_table

HEAD = """\
# The Python names of ROS 2 Jazzy

The public names of ROS 2 Jazzy's Python packages, with their parameters and defaults. A tick means that tfloom has the
name, and accepts the parameters by the same names, in the same order, with the same defaults; a test checks each. If a
name is missing or differs, the reason is given instead. Programs also import names from modules that only import them
themselves, as in `from rclpy.node import QoSProfile`: these are listed after a module's table, and are the same objects
as in the modules that define them.
"""
WITHOUT_IMPORTS = (
    "without what a module only imports for itself, unless a program was seen to import it from there"
)


def page() -> str:
    """Return the text of the page."""
    modules, imports, reasons = recorded(), imported(), missing()
    packages: dict[str, list[str]] = {}
    for module in sorted({*modules, *imports}):
        packages.setdefault(module.split(".")[0], []).append(module)
    names = [name for name in all_names() if not is_only_imported(name)]
    lines = [HEAD, "| package | names | there | |", "|---|---|---|---|"]
    for package in packages:
        own = [name for name in names if name.module.split(".")[0] == package]
        there = sum(reason_for(name, reasons) is None for name in own)
        facades = read_table().get(package)
        note = "" if facades is None or facades.keeps_imports else WITHOUT_IMPORTS
        lines.append(f"| {package} | {len(own)} | {there} | {reasons.get(package, note)} |")
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
    """Return, for each class that is in several modules, the module in which it is listed."""
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
    imports = [name for name in imports if not is_only_imported(name)]
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
        lines.append(f"Other names, which tfloom has too: {', '.join(there)}.")
    return lines


def _shown(name: Name) -> str:
    if not name.signature:
        return name.path
    if name.kind == "constant":
        return f"{name.path} = {name.signature}"
    texts = []
    kind = "positional"
    for parameter in parameters_of(name.signature):
        if parameter.kind == "keyword" and kind == "positional":
            texts.append("*")
        kind = "keyword" if parameter.kind != "positional" else kind
        texts.append(
            parameter.name if parameter.default is None else f"{parameter.name}={_short(parameter.default)}"
        )
    return f"{name.path}({', '.join(texts)})".replace("|", "\\|")


def _short(default: str) -> str:
    return "…" if default.startswith("<") or len(default) > 40 else default
