"""The table of the façades, `names.yaml`: what is written by hand about each module with a ROS name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

__all__ = ["TABLE", "Facade", "Package", "TableError", "read_table"]

TABLE = Path(__file__).with_name("names.yaml")


class TableError(Exception):
    """A row of the table can't be read, or names something that is not there: which row, and what to write instead."""


@dataclass(frozen=True)
class Facade:
    """One module: its docstring, and what is to be known beside the recorded names."""

    doc: str
    also: tuple[str, ...] = ()
    """Names beside those that are recorded as defined here: tfloom's own, and values, whose origin is not recorded."""
    seen: tuple[str, ...] = ()
    """Names that the original only imports here, and that a public program was seen to import from here."""
    all_of: tuple[str, ...] = ()
    """Modules of tfloom whose `__all__` is what this module has; for modules of which no names are recorded."""
    names: Mapping[str, str] | None = None
    """Name: where it is implemented. For those that are ambiguous otherwise, or have another name there."""
    loads: tuple[str, ...] = ()
    """Modules that are imported for what their import does."""
    claim: bool = False
    """Whether its import raises an error beside the `rclpy` of another ROS."""
    package: bool = False
    """Whether it is a package though no module of the table is in it: the names of absent ones are explained."""
    eager: bool = False
    """Whether a package loads all names that it defines at once: they register themselves, or need OpenCV."""


@dataclass(frozen=True)
class Package:
    """The modules of one top-level package."""

    rooms: tuple[str, ...]
    """Where its names are implemented: the packages and modules that are searched, in order."""
    keeps_imports: bool
    """Whether a module has the names that the original only imports there; otherwise it has those in `seen`."""
    modules: Mapping[str, Facade]
    late: tuple[str, ...] = ()
    """Rooms of which no façade loads a name before a program uses it, because they load more than the rest."""
    folder: str = "src/tfloom/ros_names"
    """Where its façades are, within the repository."""


@cache
def read_table(path: Path = TABLE) -> dict[str, Package]:
    """Return the packages of the table, by name.

    Raises:
        TableError: a row has an unknown key, or a module is not in the package that lists it.
    """
    document: dict[str, dict[str, Any]] = yaml.safe_load(path.read_text("utf-8"))
    return {name: _package(name, rows) for name, rows in document.items()}


def _package(name: str, rows: dict[str, Any]) -> Package:
    modules = {module: _facade(module, row) for module, row in rows["modules"].items()}
    for module in modules:
        if module.split(".")[0] != name:
            raise TableError(
                f"{module} stands under {name} in names.yaml: move it to the package of its name"
            )
    rooms, late = (tuple(map(_in_tfloom, rows.get(key, ()))) for key in ("rooms", "late"))
    folder = rows.get("folder", Package.folder)
    return Package(rooms, rows.get("keeps_imports", True), modules, late, folder)


def _in_tfloom(room: str) -> str:
    """Return the whole name of a room, which is one of tfloom's unless it begins with another distribution's."""
    return room if room.startswith("tfloom_") else f"tfloom.{room}"


def _facade(module: str, row: str | dict[str, Any]) -> Facade:
    if isinstance(row, str):
        return Facade(row)
    values: dict[str, Any] = {
        key: tuple(value) if isinstance(value, list) else value for key, value in row.items()
    }
    try:
        return Facade(**values)
    except TypeError as error:
        raise TableError(f"the row of {module} in names.yaml: {error}") from error
