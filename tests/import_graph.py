"""The import graph of a Python package, read from its syntax trees, and the rings in it.

Run `python tests/import_graph.py` for the imports of `src/tfloom` and the rings of each room.

There are three kinds of imports: those that run when the module is loaded, those inside functions, and those under
`if TYPE_CHECKING:`, which only annotations need. A ring is a set of modules that import one another, directly or
indirectly (a strongly connected component of more than one module).
"""

from __future__ import annotations

import argparse
import ast
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from enum import Enum
from pathlib import Path
from typing import NamedTuple

__all__ = ["Import", "Kind", "imports_of_file", "imports_of_package", "main", "rings"]

HOUSE = Path(__file__).parents[1] / "src" / "tfloom"


class Kind(Enum):
    """When an import takes place."""

    RUN_TIME = "at run time"
    FUNCTION = "in functions"
    ANNOTATION = "for annotations"


UP_TO: dict[Kind, tuple[Kind, ...]] = {
    Kind.RUN_TIME: (Kind.RUN_TIME,),
    Kind.FUNCTION: (Kind.RUN_TIME, Kind.FUNCTION),
    Kind.ANNOTATION: (Kind.RUN_TIME, Kind.FUNCTION, Kind.ANNOTATION),
}
"""The kinds that count for a ring of each kind."""


class Import(NamedTuple):
    """One imported module or name."""

    importer: str
    """Dotted name of the module that imports."""
    imported: str
    """Dotted name of the imported module."""
    path: Path
    line: int
    kind: Kind
    level: int
    """Number of dots of a relative import; 0 for an absolute one."""


def module_name(path: Path, source: Path) -> str:
    """Return the dotted name of a file below the folder `source`, which is on `sys.path`."""
    parts = path.relative_to(source).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def is_module(dotted: str, source: Path) -> bool:
    """Return whether a dotted name is a module or a package below `source`."""
    path = source / Path(*dotted.split("."))
    return path.is_dir() or path.with_suffix(".py").is_file()


def imports_of_file(path: Path, source: Path) -> Iterator[Import]:
    """Yield the imports of one file; `from package import module` is an import of `package.module`."""
    importer = module_name(path, source)
    for node, kind in _import_statements(ast.parse(path.read_text("utf-8")), Kind.RUN_TIME):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(importer, alias.name, path, node.lineno, kind, 0)
        else:
            package = node.module or ""
            for alias in node.names:
                name = f"{package}.{alias.name}"
                imported = name if is_module(name, source) else package
                yield Import(importer, imported, path, node.lineno, kind, node.level)


def _import_statements(node: ast.AST, kind: Kind) -> Iterator[tuple[ast.Import | ast.ImportFrom, Kind]]:
    """Yield the imports of a statement and those in it, without a look at expressions, which have none."""
    if isinstance(node, (ast.Import, ast.ImportFrom)):
        yield node, kind
        return
    if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and kind is Kind.RUN_TIME:
        kind = Kind.FUNCTION
    if isinstance(node, ast.If) and ast.unparse(node.test) in ("TYPE_CHECKING", "typing.TYPE_CHECKING"):
        for child in node.body:
            yield from _import_statements(child, Kind.ANNOTATION)
        for child in node.orelse:
            yield from _import_statements(child, kind)
        return
    for block in ("body", "handlers", "orelse", "finalbody", "cases"):
        for child in getattr(node, block, ()):
            yield from _import_statements(child, kind)


def imports_of_package(package: Path) -> list[Import]:
    """Return the imports of all files below a package's folder."""
    return [
        statement
        for path in sorted(package.rglob("*.py"))
        for statement in imports_of_file(path, package.parent)
    ]


def rings(imports: Iterable[Import], kind: Kind) -> list[list[str]]:
    """Return the rings among the modules that import, each sorted, counting the imports up to `kind`."""
    edges: dict[str, set[str]] = defaultdict(set)
    for statement in imports:
        if statement.kind in UP_TO[kind] and statement.imported != statement.importer:
            edges[statement.importer].add(statement.imported)
    return sorted(sorted(component) for component in _components(edges) if len(component) > 1)


def _components(edges: dict[str, set[str]]) -> Iterator[list[str]]:
    """Yield the sets of modules of which each reaches each other one, directly or not."""
    left = set(edges)
    while ends := {module for module in left if edges[module].isdisjoint(left)}:
        left -= ends  # whatever leads nowhere, or only to such modules, is in no ring
    reached: dict[str, set[str]] = {}
    for module in left:
        found, following = set[str](), edges[module] & left
        while following:
            found |= following
            following = set.union(*(edges[other] for other in following)) & left - found
        reached[module] = found
    while left:
        module = left.pop()
        ring = {module, *(other for other in reached[module] & left if module in reached[other])}
        left -= ring
        yield list(ring)


def room(module: str) -> str:
    """Return the room of a module: `node` for `tfloom.node.clock.clock`."""
    return module.split(".")[1] if "." in module else ""


def main(arguments: list[str] | None = None) -> int:
    """Print the number of imports of each kind, and the rings of each kind by room; return 0."""
    parser = argparse.ArgumentParser(
        description="Print the import graph of a package, and its rings by room."
    )
    parser.add_argument("package", nargs="?", type=Path, default=HOUSE, help="folder of the package")
    parser.add_argument("--edges", action="store_true", help="print each import, too")
    options = parser.parse_args(arguments)
    name = options.package.name
    statements = [
        statement
        for statement in imports_of_package(options.package)
        if room(statement.importer) not in ("ros_names", "interfaces")
        and statement.imported.split(".")[0] == name
    ]
    if options.edges:
        for edge in sorted(
            {(statement.importer, statement.imported, statement.kind.value) for statement in statements}
        ):
            print("{} -> {} ({})".format(*edge))
    modules = {statement.importer for statement in statements}
    print(f"{name}: {len(modules)} modules that import others of the package")
    for kind in Kind:
        print(
            f"  imports {kind.value}: {len({statement[:2] for statement in statements if statement.kind is kind})}"
        )
    for kind in Kind:
        circles = rings(statements, kind)
        print(f"rings, counting imports {', '.join(member.value for member in UP_TO[kind])}: {len(circles)}")
        by_room: Counter[str] = Counter(
            " and ".join(sorted({room(module) for module in circle})) for circle in circles
        )
        for where, count in sorted(by_room.items()):
            print(f"  {where}: {count}")
        for circle in circles:
            print(
                f"    {len(circle)} files: {' '.join(module.removeprefix(f'{name}.') for module in circle)}"
            )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
