"""Write the façades in `src/tfloom/ros_names/` from the recorded names, the table, and what tfloom's modules define."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from tools.facades.recorded import imported_from, is_missing, recorded
from tools.facades.rooms import Provider, exported, index_names
from tools.facades.table import Facade, Package, TableError, read_table

__all__ = ["HOMES_PATH", "Generator", "generate_all"]

HOMES_PATH = "src/tfloom/ros_imports/homes.py"
"""The table of the modules that define classes in ROS, within the repository."""
_SHOWN = {"launch", "launch_ros", "rclpy"}
"""The packages whose objects show their class's name in ROS."""
_MESSAGES = re.compile(r"(\w+)\.(msg|srv|action)(\._.*)?")


@dataclass
class _Names:
    """The names of one façade: for each, the module that has it, and the name there."""

    eager: dict[str, tuple[str, str]] = field(default_factory=dict)
    deferred: dict[str, tuple[str, str]] = field(default_factory=dict)
    submodules: list[str] = field(default_factory=list)


def generate_all() -> dict[str, str]:
    """Return the files of the façades in the table and the table of homes, by path within the repository."""
    generator = Generator(read_table())
    return {**generator.files(), HOMES_PATH: _homes_text(generator.homes())}


class Generator:
    """The façades of a table.

    Raises:
        TableError: a name is implemented nowhere, or in several modules of tfloom, and the table doesn't say in which.
    """

    def __init__(
        self, table: Mapping[str, Package], index: Mapping[str, list[Provider]] | None = None
    ) -> None:
        self._table = table
        rooms = {room for package in table.values() for room in package.rooms}
        self._index = index_names(rooms=rooms) if index is None else index
        self._facades = {
            name: facade for package in table.values() for name, facade in package.modules.items()
        }
        self._recorded = recorded()

    def files(self) -> dict[str, str]:
        """Return the text of each file, by path."""
        files = {f"{package.folder}/{name}/py.typed": "" for name, package in self._table.items()}
        for module, facade in self._facades.items():
            path = module.replace(".", "/") + ("/__init__.py" if self._is_package(module) else ".py")
            files[f"{self._table[_top_package(module)].folder}/{path}"] = _text(
                module, facade, self.names(module)
            )
        return files

    def homes(self) -> dict[str, str]:
        """Return the module that defines a class in ROS, by the class's full name in tfloom: for `ros_repr`."""
        return {
            f"{room}.{name}": module
            for module in self._facades
            if _top_package(module) in _SHOWN
            for name, home in imported_from(module).items()
            if home == module and name[0].isupper() and not is_missing(f"{module}.{name}")
            for room, attribute in [self._home(module, name)]
            if attribute == name
        }

    def names(self, module: str) -> _Names:
        """Return the names of a façade, and where they come from."""
        facade = self._facades[module]
        result = _Names(submodules=self._submodules(module))
        for room in facade.all_of:
            result.eager.update((name, (room, name)) for name in exported(room))
        for name, is_eager in self._chosen(module):
            room, attribute = home = self._home(module, name)
            is_late = any(
                f"{room}.".startswith(f"{late}.") for late in self._table[_top_package(module)].late
            )
            # What is deferred has the same name in its module.
            (result.eager if (is_eager and not is_late) or attribute != name else result.deferred)[name] = (
                home
            )
        # A function that has the name of a submodule: the import of the submodule, later, would replace it.
        if "__getattr__" in result.deferred:  # a façade has one `__getattr__`: this or that of deferred names
            result.eager |= result.deferred
            result.deferred.clear()
        for name in set(result.submodules) & result.deferred.keys():
            result.eager[name] = result.deferred.pop(name)
        return result

    def _chosen(self, module: str) -> Iterator[tuple[str, bool]]:
        """Yield the names of a façade, and whether they are loaded with it: if it is the module that defines them."""
        facade, package = self._facades[module], self._table[_top_package(module)]
        homes, defined = imported_from(module), self._recorded.get(module, {})
        told = {*facade.also, *(facade.names or ())}
        exported_submodules = set(facade.also) & set(self._submodules(module))
        for name in sorted({*homes, *defined, *facade.seen, *told} - exported_submodules):
            if is_missing(f"{module}.{name}"):
                continue
            is_own = homes.get(name) == module or name in defined or name in told
            if is_own or name in facade.seen or package.keeps_imports:
                # A package has most of its names from its submodules, which a program need not load for one of them.
                is_here = homes.get(name) == module or not self._is_package(module) or facade.eager
                is_below = facade.eager and homes.get(name, "").startswith(f"{module}.")
                yield name, is_below or (is_own and is_here)

    def _home(self, module: str, name: str) -> tuple[str, str]:
        """Return the module of tfloom that has a name of a façade, and the name there.

        It is in the table, or follows from the recorded home of the name: a façade, whose names are found in the same
        way, or the module of a message. A value has no recorded home, so the façades that define its name are searched.
        """
        home = imported_from(module).get(name, "")
        facade = self._facades[module]
        if name in (facade.names or {}):
            return self._own_home(module, name)
        messages = _MESSAGES.fullmatch(home)
        if messages and messages[1] not in self._table:
            room = f"tfloom.interfaces.{messages[1]}.{messages[2]}"
            # Otherwise it is another name for a message, which a room of ours gives it, too.
            if name in exported(room):
                return room, name
        if home in self._facades:
            return self._own_home(home, name)
        if not home and name not in self._recorded.get(module, {}):
            definers = {self._own_home(other, name) for other in self._definers(name)}
            if len(definers) == 1:
                return definers.pop()
        return self._own_home(module, name)

    def _definers(self, name: str) -> list[str]:
        """Return the façades, packages apart, that define a name."""
        return [
            module
            for module, facade in self._facades.items()
            if not self._is_package(module)
            and (name in facade.also or name in self._recorded.get(module, {}))
        ]

    def _own_home(self, module: str, name: str) -> tuple[str, str]:
        """Return where a name is implemented that a façade defines itself: by the table, or in its rooms."""
        told = (self._facades[module].names or {}).get(name)
        if told is not None:
            room, _, attribute = told.rpartition(".")
            return room, attribute
        rooms = self._table[_top_package(module)].rooms
        for room in rooms:
            if (home := self._find(room, module, name)) is not None:
                return home, name
        raise TableError(
            f"{module}.{name} is nowhere in {', '.join(rooms)}: write where it is, as `names: {{{name}: …}}`"
        )

    def _find(self, room: str, module: str, name: str) -> str | None:
        """Return the module of a room that implements a name of a façade; None if none does."""
        providers = [
            provider
            for provider in self._index.get(name, [])
            if provider.module == room or provider.module.startswith(f"{room}.")
        ]
        # The module that is called as the façade is, if there is one: of the two classes IncludeLaunchDescription,
        # the action is in `tfloom.launch.actions.include_launch_description`.
        namesakes = [provider.module for provider in providers if _last(provider.module) == _last(module)]
        if namesakes:
            return min(namesakes, key=lambda other: (-_common_tail(other, module), other.count("."), other))
        best = [provider.module for provider in providers if provider.rank == providers[0].rank]
        if len(best) > 1:
            raise TableError(
                f"{module}.{name} may be that of {', '.join(best)}: write which, as `names: {{{name}: …}}`"
            )
        return best[0] if best else None

    def _is_package(self, module: str) -> bool:
        return module in self._packages

    @cached_property
    def _packages(self) -> set[str]:
        inner = {module.rpartition(".")[0] for module in self._facades}
        told = {module for module, facade in self._facades.items() if facade.package}
        return {*self._table, *inner, *told} - {""}

    def _submodules(self, module: str) -> list[str]:
        return sorted(name for name in self._children.get(module, ()) if not name.startswith("_"))

    @cached_property
    def _children(self) -> dict[str, list[str]]:
        children: dict[str, list[str]] = {}
        for module in self._facades:
            parent, _, name = module.rpartition(".")
            children.setdefault(parent, []).append(name)
        return children


def _top_package(module: str) -> str:
    return module.split(".", maxsplit=1)[0]


def _last(module: str) -> str:
    return module.rpartition(".")[2]


def _common_tail(left: str, right: str) -> int:
    """Return how many parts at their ends two dotted names have in common."""
    pairs = zip(reversed(left.split(".")), reversed(right.split(".")), strict=False)
    for number, (ours, theirs) in enumerate(pairs):
        if ours != theirs:
            return number
    return min(left.count("."), right.count(".")) + 1


def _text(module: str, facade: Facade, names: _Names) -> str:
    """Return the source of a façade."""
    end = "\n" if "\n" in facade.doc else ""
    blocks = [f'"""{facade.doc}{end}"""\n# Generated by tools/facades.']
    if facade.claim:
        blocks.append(f'from tfloom.ros_imports.guard import claim\n\nclaim("{_top_package(module)}")')
    shadowed = sorted(set(names.submodules) & names.eager.keys())
    imports = [f"import {name} as {name}" if "." not in name else f"import {name}" for name in facade.loads]
    imports += [f"import {module}.{name}" for name in shadowed]
    imports += [
        _import(*names.eager[name], name)
        for name in sorted(names.eager, key=lambda name: (names.eager[name], name))
    ]
    if imports:
        blocks.append("\n".join(imports))
    deferred = dict.fromkeys(sorted(set(names.submodules) - names.eager.keys()), (module, ""))
    deferred.update(names.deferred)
    # Most façades need no `__all__`, because `deferred` gives one. But for type checkers a name that has another one in
    # its module is only exported by it; `import package.submodule` adds the package itself to what a star import takes;
    # and where all is deferred, type checkers would take the submodules, too.
    renamed = [name for name, (_, attribute) in names.eager.items() if attribute != name]
    if shadowed or renamed or (names.deferred and not names.eager):
        listed = set(names.submodules) & set(facade.also)
        blocks.append(_exports(sorted({*names.eager, *names.deferred, *listed})))
    if deferred:
        blocks.append(_deferred(deferred))
    return "\n\n".join(blocks) + "\n"


def _homes_text(homes: Mapping[str, str]) -> str:
    rows = "".join(f'    "{own}": "{home}",\n' for own, home in sorted(homes.items()))
    return (
        '"""The modules that define classes in ROS, by the classes\' names here."""\n# Generated by tools/facades.\n'
        f'# ruff: noqa: E501\n\n__all__ = ["HOMES"]\n\nHOMES = {{\n{rows}}}\n'
    )


def _import(room: str, attribute: str, name: str) -> str:
    return f"from {room} import {attribute or name} as {name}"


def _exports(names: list[str]) -> str:
    listed = "".join(f'    "{name}",\n' for name in names)
    return f"__all__ = [\n{listed}]"


def _deferred(homes: Mapping[str, tuple[str, str]]) -> str:
    """Return the imports for type checkers, and the functions that do the same when a name is first used."""
    typed = "".join(
        f"    {_import(*homes[name], name)}\n" for name in sorted(homes, key=lambda name: (homes[name], name))
    )
    loaded = "".join(f'        {name}="{room}",\n' for name, (room, _) in sorted(homes.items()))
    return (
        f"TYPE_CHECKING = False\nif TYPE_CHECKING:\n{typed}else:\n"
        "    from tfloom.ros_imports.modules import deferred\n\n"
        f"    __getattr__, __dir__ = deferred(\n        __name__,\n{loaded}    )"
    )
