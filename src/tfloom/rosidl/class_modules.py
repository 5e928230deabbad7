"""The modules that interface classes name as theirs, one for each definition: `geometry_msgs.msg._pose_stamped`.

ROS's generator writes such a module for each definition. Programs derive a type's name from a class's `__module__`,
editors insert imports from these modules, and pickles name them. tfloom defines all classes of a package in one file,
which loads faster, or makes them at run time. So `sys.modules` gets a `DefinitionModule` for each definition when its
package is loaded, which looks its classes up when it is asked for them.

Classes name these modules only where the modules' package is tfloom's: beside a real ROS, such a name would lead to
that ROS's class.
"""

from __future__ import annotations

import sys

from tfloom.ros_imports.guard import is_facade, serves_rclpy
from tfloom.ros_imports.modules import module_leaf, submodules
from tfloom.rosidl import class_table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from importlib.abc import Loader
    from importlib.machinery import ModuleSpec
    from types import ModuleType
    from typing import Any
else:
    Loader = object  # importlib and types take longer to import than a few messages
    ModuleType = type(sys)

_METACLASS = "Metaclass_"


class DefinitionModule(ModuleType):
    """The module of one definition: its classes, and the `Metaclass_X` that ROS has for each class `X`."""

    def __init__(self, name: str, home: str) -> None:
        """Take the module's name, and that of the module in which its classes are defined."""
        super().__init__(name)
        self._home = home

    @property
    def __file__(self) -> str | None:  # type: ignore[override]  # of ModuleType, writeable
        """The file that defines the classes, which `inspect` reads."""
        return getattr(sys.modules.get(self._home), "__file__", None)

    @property
    def __spec__(self) -> ModuleSpec:  # type: ignore[override]  # as above
        """A spec, for programs that ask whether a module can be imported."""
        return _spec(self.__name__, None, origin=self._home)

    def __getattr__(self, name: str) -> Any:
        if name == "__all__":
            return self._class_names()
        if name.startswith(_METACLASS):
            metaclass = _metaclass(getattr(self, name.removeprefix(_METACLASS)))
            return vars(self).setdefault(name, metaclass)
        if not name.startswith("__"):
            __import__(self._home)
            value = getattr(sys.modules[self._home], name, None)
            if isinstance(value, type) and value.__module__ == self.__name__:
                return value
        raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")

    def __dir__(self) -> list[str]:
        names = self._class_names()
        return sorted({*vars(self), *names, *(f"{_METACLASS}{name}" for name in names)})

    def _class_names(self) -> list[str]:
        __import__(self._home)
        names = {*dir(sys.modules[self._home]), *vars(self)}
        leaf = self.__name__.rpartition(".")[2]
        return sorted(
            name for name in names if name[:1].isupper() and module_leaf(name.partition("_")[0]) == leaf
        )


def _spec(name: str, loader: Loader | None, **attributes: Any) -> ModuleSpec:
    from importlib.machinery import ModuleSpec

    return ModuleSpec(name, loader, **attributes)


class Metaclass(type):
    """What has the names of ROS's metaclasses; tfloom's classes are of plain `type`."""

    @classmethod
    def __import_type_support__(cls) -> None:
        """Do nothing, because tfloom's classes need no support by a library of their package."""


def _metaclass(interface_class: type[Any]) -> type[Metaclass]:
    name = f"{_METACLASS}{interface_class.__name__}"
    doc = f"Metaclass of message '{interface_class.__name__}'."
    return type(name, (Metaclass,), {"__module__": interface_class.__module__, "__doc__": doc})


def modules_of(home: str, file: str) -> Callable[[str], str]:
    """Return a function from the last part of a definition's module to what its classes have as `__module__`.

    It is for the generated modules of interfaces; where their package's name is not tfloom's, classes keep the module
    in which they are defined.

    Args:
        home: The `__name__` of a generated module, `tfloom.interfaces.geometry_msgs.msg`.
        file: Its `__file__`.
    """
    _, package, kind = home.rsplit(".", 2)
    if not is_facade(package, file):
        return lambda _leaf: home

    def module(leaf: str) -> str:
        return add_module(f"{package}.{kind}.{leaf}", home).__name__

    return module


def add_module(name: str, home: str) -> ModuleType:
    """Return the module of a definition, which is added to `sys.modules` if it is not there.

    Args:
        name: The module's name.
        home: Name of the module that has the classes.
    """
    module = sys.modules.get(name)
    if module is None:
        module = sys.modules[name] = DefinitionModule(name, home)
    return module


def module_of_made(definition: str) -> ModuleType | None:
    """Return the module for the classes that are made of a definition, `package/kind/Name`, at run time.

    Returns:
        None where that name leads to other classes: of another ROS, or of tfloom's definition of this name.
    """
    if not serves_rclpy():
        return None
    package, kind, base = definition.split("/")
    home = f"{package}.{kind}"
    name = f"{home}.{module_leaf(base)}"
    own = class_table.find_own(definition)
    if own is not None and own.__module__ == name:
        return None
    _MadePackages.add(package, home)
    return add_module(name, home)


class _MadePackages(Loader):
    """The finder of packages that exist only as classes made at run time, last in `sys.meta_path`."""

    def __init__(self) -> None:
        self._names: set[str] = set()

    @classmethod
    def add(cls, package: str, home: str) -> None:
        """Let a package be found, and its module `home`, unless another finder finds them."""
        finder = next((finder for finder in sys.meta_path if isinstance(finder, cls)), None)
        if finder is None:
            finder = cls()
            sys.meta_path.append(finder)
        finder._names |= {package, home}

    def find_spec(self, fullname: str, _path: object = None, _target: object = None) -> ModuleSpec | None:
        """Return the spec of a package with made classes, or of one of its kinds; None for any other name."""
        is_known = fullname in self._names and class_table.has_package(fullname.partition(".")[0])
        return _spec(fullname, self, is_package=True) if is_known else None

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Return None, for Python's own kind of module."""

    def exec_module(self, module: ModuleType) -> None:
        """Give the module a function that finds its classes or its kinds."""
        package, _, kind = module.__name__.partition(".")
        find_module = submodules(module.__name__)

        def find(name: str) -> Any:
            interface_class = class_table.registered(f"{package}/{kind}/{name}") if kind else None
            return find_module(name) if interface_class is None else interface_class

        vars(module)["__getattr__"] = find
