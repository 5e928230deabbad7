"""List the licences of what tfloom is built with, needs and is developed with: `make licenses`.

The licences come from the metadata of the packages that are installed in this environment, those that these packages
require included. The exit code is 1 if a licence isn't accepted for its use. Weak copyleft (LGPL, MPL) is accepted in
extras and development only; the GPL nowhere.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from tools.set_up import PACKAGES, STAGES, dependencies_of, read_project, requirements_of_extra

COMPILED_IN = "compiled in"
REQUIRED = "required"
DEVELOPMENT = "development"
PERMISSIVE = re.compile(
    r"0BSD|Apache|\bBSD|CC0|\bMIT\b|MIT-CMU|Expat|ISC|HPND|PSF|Python Software Foundation|Zlib|Unlicense|Public Domain"
)
WEAK = re.compile(r"LGPL|Lesser General Public|MPL|Mozilla Public|EPL|Eclipse Public")
STRONG = re.compile(r"\bA?GPL|(?<!Lesser )General Public License")
DECIDED = {
    "apsw": ("any-OSI", "Zlib", "its licence allows any that the OSI approves"),
    "cyclonedds": ("EPL-2.0, BSD-3-Clause", "BSD-3-Clause", "either one, at the user's choice"),
    "tfloom-ddsc": ("EPL-2.0 OR BSD-3-Clause", "BSD-3-Clause", "the same library"),
    "docutils": (
        "Public Domain, BSD License, GNU General Public License (GPL)",
        "BSD-2-Clause",
        "the GPL holds for a file of Emacs that wheels lack",
    ),
    "xacro": (
        "Copyright Robert Haschke, Bielefeld University",
        "BSD-3-Clause",
        "the metadata has the licence's text in place of its name",
    ),
}
"""Packages whose metadata needs a reader: what it states, the licence that is used, and the reason."""


@dataclass(frozen=True)
class Row:
    """A package: its name, version, licence, its strictest use, and why its licence isn't accepted (empty if it is)."""

    name: str
    version: str
    licence: str
    use: str
    fault: str


def stated_licence(package: metadata.PackageMetadata) -> str:
    """Return the licence that a package's metadata states: an SPDX expression, classifiers, or a name; or ''."""
    classifiers = [
        classifier.rpartition(" :: ")[2]
        for classifier in package.get_all("Classifier") or []
        if classifier.startswith("License :: ") and not classifier.endswith(":: OSI Approved")
    ]
    text, *_ = [*"".join(package.get_all("License") or []).strip().splitlines(), ""]
    name = "" if text == "UNKNOWN" else text.strip()
    return "".join(package.get_all("License-Expression") or []) or ", ".join(classifiers) or name


def fault_of(licence: str, use: str) -> str:
    """Return why a licence is not accepted for a use; '' if it is."""
    if not licence:
        return "the metadata names no licence"
    if STRONG.search(licence):
        return "the GPL is not accepted"
    if WEAK.search(licence):
        return "" if use not in {COMPILED_IN, REQUIRED} else "weak copyleft is accepted in extras only"
    return "" if PERMISSIVE.search(licence) else "unknown licence: decide in tools/licenses.py"


def row_of(name: str, use: str) -> Row | None:
    """Return the row of a package; None if it isn't installed, because another platform or stage needs it."""
    try:
        installed = metadata.distribution(name)
    except metadata.PackageNotFoundError:
        return None
    stated = stated_licence(installed.metadata)
    expected, decided, _ = DECIDED.get(canonicalize_name(name), (None, "", ""))
    licence = decided if stated == expected else stated
    return Row(canonicalize_name(name), installed.version, licence, use, fault_of(licence, use))


def names_of(requirements: Iterable[str], extras: Iterable[str] = ("",)) -> Iterator[tuple[str, set[str]]]:
    """Yield the names in requirements that hold here, each with the extras that are required."""
    for text in requirements:
        requirement = Requirement(text)
        if requirement.marker is None or any(requirement.marker.evaluate({"extra": e}) for e in extras):
            yield canonicalize_name(requirement.name), set(requirement.extras)


def uses(roots: Mapping[str, Iterable[str]]) -> dict[str, str]:
    """Return the strictest use of each package, by name, those that others require included.

    Args:
        roots: Requirements by use, the strictest use first.
    """
    use_of: dict[str, str] = {}
    followed: dict[str, set[str]] = {}
    """The extras whose requirements were followed, "" for none."""
    for use, requirements in roots.items():
        todo = list(names_of(requirements))
        while todo:
            name, extras = todo.pop()
            asked = {"", *extras} - followed.setdefault(name, set())
            if not asked or name == "tfloom":
                continue
            followed[name] |= asked
            use_of.setdefault(name, use)
            try:
                required = metadata.requires(name) or []
            except metadata.PackageNotFoundError:
                continue
            todo.extend(names_of(required, asked))
    return use_of


def roots_of_project() -> dict[str, list[str]]:
    """Return the requirements of pyproject.toml by use, the strictest use first.

    nanobind, with robin-map inside it, is compiled into the extension; a wheel holds their licences, and that of uPlot,
    whose files are in `viewer/page/`.
    """
    project = read_project(Path(sys.executable))
    extras: dict[str, list[str]] = project["project"]["optional-dependencies"]
    groups = [group for names, _ in STAGES.values() for group in names]
    return {
        COMPILED_IN: [
            requirement
            for requirement in project["build-system"]["requires"]
            if requirement.startswith("nanobind")
        ],
        REQUIRED: dependencies_of(project),
        **{f"extra {name}": requirements_of_extra(project, name) for name in extras if name != "all"},
        DEVELOPMENT: [requirement for group in groups for requirement in project["dependency-groups"][group]],
    }


def table(rows: Iterable[Row]) -> str:
    """Return rows as text in columns."""
    cells = [(row.name, row.version, row.use, row.licence[:60], row.fault) for row in rows]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
        for line in cells
    )


def main() -> int:
    """Print the table; return 1 if a licence is not accepted."""
    use_of = uses(roots_of_project())
    rows = [row for name, use in use_of.items() if (row := row_of(name, use)) is not None]
    print(table(rows))
    missing = sorted(use_of.keys() - {row.name for row in rows} - set(PACKAGES))
    faults = [row for row in rows if row.fault]
    print(f"{len(rows)} packages, {len(faults)} with a licence that is not accepted", end="")
    print(f"; not installed here: {', '.join(missing)}" if missing else "")
    for row in faults:
        print(f"{row.name} ({row.use}): {row.licence or '?'}: {row.fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
