"""Typed modules, for editors and type checkers, of packages that Python imports from their definitions."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from tfloom.rosidl import definition_files, sources, spec
from tfloom.rosidl.generate import generate
from tfloom.rosidl.references import check_references
from tfloom.workspace import index


class Stubs(NamedTuple):
    """The result of `write_stubs`."""

    written: list[Path]
    """The files, in order of their names."""
    left_out: list[str]
    """Name and error of each definition that can't be loaded."""


def write_stubs(folder: Path) -> Stubs:
    """Write `package/kind.pyi` for each package on AMENT_PREFIX_PATH that holds definitions and is not tfloom's own.

    Definitions that can't be loaded are left out.

    Args:
        folder: Where to write; it is made.

    Raises:
        OSError: a file can't be read or written.
    """
    found = Stubs([], [])
    for package, names in _workspace_interfaces().items():
        interfaces = list(_load(names, found.left_out))
        for kind in definition_files.KINDS:
            group = [each for each in interfaces if each.name.split("/")[1] == kind]
            if group:
                source = generate(group, sources.find_message, by="tfloom interfaces stubs")
                _write(folder / package / f"{kind}.pyi", source, found.written)
        if interfaces:
            text = f'"""The interfaces of {package}."""\n'
            _write(folder / package / "__init__.pyi", text, found.written)
    found.written.sort()
    return found


def _workspace_interfaces() -> dict[str, list[str]]:
    """Return the names of all definitions of each package on AMENT_PREFIX_PATH that is not tfloom's own."""
    own = index.own_packages()
    found: dict[str, set[str]] = {}
    for share in definition_files.workspace_folders():
        for folder in share.glob("*/"):
            if folder.name not in own:
                found.setdefault(folder.name, set()).update(definition_files.names_in(folder))
    return {package: sorted(names) for package, names in sorted(found.items()) if names}


def _load(names: Iterable[str], left_out: list[str]) -> Iterable[spec.Interface]:
    for name in names:
        try:
            interface = sources.find_interface(name)
            check_references(interface)
        except (LookupError, ValueError) as error:  # noqa: PERF203  # each has its own reason
            left_out.append(f"{name} is left out: {error}")
        else:
            yield interface


def _write(path: Path, text: str, written: list[Path]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    written.append(path)
