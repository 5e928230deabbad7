"""Typed modules, for editors and type checkers, of packages that Python imports from their definitions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from tfloom.common.files import write_file
from tfloom.rosidl import definition_files, sources, spec
from tfloom.rosidl.generate import definition_modules, generate
from tfloom.rosidl.references import check_references
from tfloom.rosidl.type_hash import FindSpec
from tfloom.workspace import index


class Stubs(NamedTuple):
    """The files that `write_stubs` has written, and the definitions that it has left out."""

    written: list[Path]
    """The files, in order of their names."""
    left_out: list[str]
    """Name and error of each definition that can't be loaded."""


def write_stubs(folder: Path) -> Stubs:
    """Write the stubs of each package on AMENT_PREFIX_PATH that holds definitions and is not tfloom's own.

    They are `package/kind/__init__.pyi`, and one for the module of each definition. Definitions that can't be loaded
    are left out.

    Args:
        folder: Where to write; it is made.

    Raises:
        OSError: a file can't be read or written.
    """
    result = Stubs([], [])
    for package, names in _workspace_interfaces().items():
        interfaces = list(_load(names, result.left_out))
        stubs = typed_modules(package, interfaces, sources.find_message, by="tfloom interfaces stubs")
        for path, text in stubs:
            _write(folder / package / path, text, result.written)
    result.written.sort()
    return result


def typed_modules(
    package: str, interfaces: Iterable[spec.Interface], find: FindSpec, *, by: str
) -> Iterator[tuple[str, str]]:
    """Yield path and text of each stub of a package: `__init__.pyi`, `msg/__init__.pyi`, `msg/_sphere.pyi`.

    Args:
        package: The package's name.
        interfaces: Its interfaces; without any, there are no stubs.
        find: Returns the message of a name, for references.
        by: The command that writes them, for the note at the top.
    """
    groups: dict[str, list[spec.Interface]] = {}
    for interface in interfaces:
        groups.setdefault(interface.name.split("/")[1], []).append(interface)
    kinds = [kind for kind in definition_files.KINDS if kind in groups]
    for kind in kinds:
        yield f"{kind}/__init__.pyi", generate(groups[kind], find, by=by)
        for name, text in definition_modules(f"{package}.{kind}", groups[kind]):
            yield f"{kind}/{name}.pyi", text
    if kinds:
        imports = "".join(f"from {package} import {kind} as {kind}\n" for kind in kinds)
        yield "__init__.pyi", f'"""The interfaces of {package}."""\n\n{imports}'


def _workspace_interfaces() -> dict[str, list[str]]:
    """Return the names of all definitions of each package on AMENT_PREFIX_PATH that is not tfloom's own."""
    own = index.own_packages()
    names_by_package: dict[str, set[str]] = {}
    for share in definition_files.workspace_folders():
        for folder in share.glob("*/"):
            if folder.name not in own:
                names_by_package.setdefault(folder.name, set()).update(definition_files.names_in(folder))
    return {package: sorted(names) for package, names in sorted(names_by_package.items()) if names}


def _load(names: Iterable[str], left_out: list[str]) -> Iterable[spec.Interface]:
    for name in names:
        try:
            interface = sources.find_interface(name)
            check_references(interface)
        except (LookupError, ValueError) as error:  # each has its own reason
            left_out.append(f"{name} is left out: {error}")
        else:
            yield interface


def _write(path: Path, text: str, written: list[Path]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    write_file(path, text)
    written.append(path)
