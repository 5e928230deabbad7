"""Where each name is implemented: an index of what the modules of tfloom define, read without importing them."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

__all__ = ["HOUSES", "ROOT", "Provider", "exported", "index_names"]

ROOT = Path(__file__).parents[2]
HOUSES = (ROOT / "src" / "tfloom", ROOT / "packages" / "tfloom-sensing" / "src" / "tfloom_sensing")
"""The import packages that implement names."""
_NOT_ROOMS = {"ros_names", "interfaces", "share", "__pycache__"}
"""Folders without implementations: the façades themselves, generated messages, and launch files."""


class Provider(NamedTuple):
    """A module that has a name."""

    module: str
    rank: int
    """0: defines it and lists it in `__all__`; 1: only lists it; 2: only defines it. Lower ranks come first."""


def index_names(*houses: Path, rooms: Collection[str] = ("",)) -> dict[str, list[Provider]]:
    """Return the modules that have each name of some import packages, those that define and export it first.

    Args:
        houses: The folders of the import packages; none: HOUSES.
        rooms: The packages and modules whose modules are read, because reading all takes seconds; "" is all.
    """
    index: dict[str, list[Provider]] = defaultdict(list)
    for module, tree in (item for house in houses or HOUSES for item in _modules(house, rooms)):
        defined, listed = set(_defined(tree.body)), set(_listed(tree.body))
        for name in defined | listed:
            rank = 0 if name in defined and name in listed else 1 if name in listed else 2
            index[name].append(Provider(module, rank))
    return {
        name: sorted(providers, key=lambda provider: (provider.rank, provider.module))
        for name, providers in index.items()
    }


@cache
def exported(module: str) -> list[str]:
    """Return what a module lists in `__all__`."""
    house = next(house for house in HOUSES if house.name == module.split(".", maxsplit=1)[0])
    path = house.parent.joinpath(*module.split("."))
    path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    return _listed(ast.parse(path.read_text("utf-8")).body)


def _modules(house: Path, rooms: Collection[str]) -> Iterator[tuple[str, ast.Module]]:
    for path in sorted(house.rglob("*.py")):
        parts = path.relative_to(house).with_suffix("").parts
        if _NOT_ROOMS.isdisjoint(parts) and "." not in parts[-1]:
            module = ".".join([house.name, *parts]).removesuffix(".__init__")
            if any(not room or f"{module}.".startswith(f"{room}.") for room in rooms):
                yield module, ast.parse(path.read_text("utf-8"))


def _defined(body: Iterable[ast.stmt]) -> Iterator[str]:
    """Yield the classes, functions and variables of a module, those in the branches of an `if` or `try` included."""
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name
        elif isinstance(node, ast.If):
            yield from _defined([*node.body, *node.orelse])
        elif isinstance(node, ast.Try):
            yield from _defined(node.body)
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (
                name.id for target in targets for name in ast.walk(target) if isinstance(name, ast.Name)
            )


def _listed(body: Iterable[ast.stmt]) -> list[str]:
    for node in body:
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and isinstance(node.value, (ast.List, ast.Tuple)):
            target = node.targets[0] if isinstance(node, ast.Assign) else node.target
            if isinstance(target, ast.Name) and target.id == "__all__":
                return [str(item.value) for item in node.value.elts if isinstance(item, ast.Constant)]
    return []
