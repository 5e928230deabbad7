"""What façades load when it is named: modules, and names whose home a façade's own import would not load.

`import rclpy` makes `rclpy.time.Time()` work, because the original's modules import one another. For the same reason
`rclpy.client` has `Clock`, which programs import from there. The façades import tfloom's rooms instead, and load such
a name's room when the name is first used, because `import` would be slower otherwise.

A façade states such names under `if TYPE_CHECKING:` as imports, which type checkers read, and in its `else:` as
`__getattr__, __dir__ = deferred(__name__, Clock="tfloom.node.clock.clock")`.
"""

from __future__ import annotations

import sys
from importlib import import_module

TYPE_CHECKING = False  # typing loads nothing that a façade of messages needs
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType
    from typing import Any

__all__ = ["deferred", "submodules"]


def submodules(package: str) -> Callable[[str], ModuleType]:
    """Return a package's `__getattr__`, which imports the module of a name.

    It raises AttributeError where there is no such module.

    Args:
        package: Name of the package.
    """

    def load(name: str) -> ModuleType:
        if not name.startswith("_"):
            module = f"{package}.{name}"
            try:
                return import_module(module)
            except ModuleNotFoundError as error:
                if error.name != module:
                    raise
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return load


def deferred(module: str, **homes: str) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return a module's `__getattr__`, which imports the home of a name, and the `__dir__` that lists these names.

    The `__getattr__` raises AttributeError for any other name.

    Args:
        module: Name of the module.
        homes: For each name, the module that has an object of this name.
    """

    def load(name: str) -> Any:
        home = homes.get(name)
        if home is None:
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        found = getattr(import_module(home), name)
        setattr(sys.modules[module], name, found)
        return found

    def names() -> list[str]:
        return sorted({*vars(sys.modules[module]), *homes})

    return load, names
