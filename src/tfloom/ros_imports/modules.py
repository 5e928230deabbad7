"""Imports of a façade on first use: submodules, and names whose modules the façade's other imports do not load.

After `import rclpy` alone, `rclpy.time.Time()` works in the original, because its modules import one another. For the
same reason `rclpy.client` has `Clock`, and programs import it from there. The façades import tfloom's rooms instead.
They defer such imports until first use, because `import rclpy` would be slower otherwise.

A façade has the deferred names twice: as imports under `if TYPE_CHECKING:`, for type checkers, and in the `else:` as
`__getattr__, __dir__ = deferred(__name__, Clock="tfloom.node.clock.clock")`. A package has its submodules there, too:
`from launch import actions as actions`, and `deferred(__name__, actions="launch")`. Both are generated from one table.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False  # neither typing nor importlib is imported, because the messages alone need neither
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType
    from typing import Any

__all__ = ["deferred", "module_leaf", "submodules"]

_OF_FACADES = {"TYPE_CHECKING", "claim", "deferred"}
"""What façades use themselves."""


def submodules(package: str) -> Callable[[str], ModuleType]:
    """Return the `__getattr__` of a package, which imports the submodule of a name.

    It raises AttributeError where there is no such module. The module of a definition, `geometry_msgs.msg._pose`, is in
    `sys.modules` when its package is loaded.

    Args:
        package: Name of the package.
    """

    def load(name: str) -> ModuleType:
        module = f"{package}.{name}"
        if not name.startswith("_") or module in sys.modules:
            try:
                __import__(module)
            except ModuleNotFoundError as error:
                if error.name != module:
                    raise
            else:
                return sys.modules[module]
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return load


def deferred(module: str, **homes: str) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return a module's `__getattr__`, which imports the home of a name, and the `__dir__` that lists these names.

    The `__getattr__` gives an `__all__`, too, so that `from rclpy.node import *` imports the deferred names like the
    others. Submodules are not in it, because a star import would load them all. For any other name it raises
    AttributeError.

    Args:
        module: Name of the module.
        homes: For each name, the module that has an object of this name; for a submodule, the module itself.
    """

    def load(name: str) -> Any:
        home = homes.get(name)
        if home is None:
            if name == "__all__":
                return public()
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        if home == module:
            __import__(f"{module}.{name}")
            return sys.modules[f"{module}.{name}"]
        __import__(home)
        value = getattr(sys.modules[home], name)
        setattr(sys.modules[module], name, value)
        return value

    def names() -> list[str]:
        return sorted({*vars(sys.modules[module]), *homes})

    def public() -> list[str]:
        return [
            name
            for name in names()
            if not name.startswith("_") and name not in _OF_FACADES and homes.get(name) != module
        ]

    return load, names


def module_leaf(base: str) -> str:
    """Return the last part of a definition's module: `_pose_stamped` of `PoseStamped`, `_u_int8` of `UInt8`."""
    neighbours = zip(f"_{base}", base, f"{base[1:]}_", strict=False)
    return "".join(
        f"_{letter}" if letter.isupper() and (not before.isupper() or after.islower()) else letter
        for before, letter, after in neighbours
    ).lower()
