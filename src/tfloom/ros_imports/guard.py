"""The guard of the façades: refuse to mix tfloom's ROS names with those of a real ROS 2."""

from __future__ import annotations

import os
import sys

__all__ = ["claim", "is_elsewhere", "is_facade", "ros_class_repr", "ros_home", "ros_repr", "serves_rclpy"]

_HOUSE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_ROS_NAMES = os.path.join(_HOUSE, "ros_names") + os.sep


_DROP_IN_LINE = "from tfloom.drop_in import Buffer, TransformListener"
_BESIDE_DROP_IN = {"tf2_ros", "tf2_py"}
"""The façades in whose place a program of another `rclpy` imports `tfloom.drop_in`."""

_leads_to_facade: dict[str, bool] = {}
"""Whether a package is the façade, by its name, as the first error that was defined has found."""


def claim(name: str) -> None:
    """Check that `rclpy` is tfloom's too, so that a façade that needs it can be imported.

    Each façade calls this before its other imports. It imports nothing, except `rclpy` in a frozen program.

    Args:
        name: The façade's own name, for the text of the error.

    Raises:
        ImportError: `rclpy` is, or would be, imported from elsewhere, because a real ROS and tfloom in one program have
            incompatible nodes and messages.
    """
    if serves_rclpy():
        return
    where = _origin("rclpy")
    if where is None:
        advice = "call `tfloom.use_ros_names()` first"
    else:
        advice = f"install '{name}' for that ROS, or take that ROS out of PYTHONPATH to run on tfloom alone"
        if name in _BESIDE_DROP_IN:
            advice = f"to use tfloom's tf2 with the nodes of that rclpy, write `{_DROP_IN_LINE}`; otherwise {advice}"
    raise ImportError(
        f"'{name}' would come from tfloom, but 'rclpy' comes from {where or 'nowhere'}: {advice}.", name=name
    )


def is_elsewhere(name: str) -> bool:
    """Return whether a top-level package is, or would be, imported from a place other than tfloom's façades."""
    if getattr(sys, "frozen", False) and _is_frozen_rclpy_ours():
        return False
    where = _origin(name)
    return where is not None and not os.path.abspath(where).startswith(_ROS_NAMES)


def serves_rclpy() -> bool:
    """Return whether `rclpy` is, or would be, imported from tfloom; in a frozen program, also if there is none."""
    if getattr(sys, "frozen", False):
        return _is_frozen_rclpy_ours()
    where = _origin("rclpy")
    return where is not None and os.path.abspath(where).startswith(_ROS_NAMES)


def ros_home(module: str, own: str) -> str:
    """Return what an error has as its `__module__`, which tracebacks show: ROS's name where that leads to it.

    Only errors have it, because `inspect` reads a class's source from the file of its `__module__`: what users derive
    from, as `Node`, keeps the module that defines it, and shows ROS's name by `ros_repr`.

    Args:
        module: The module that defines it in ROS, whose façade has it, too.
        own: The module that defines it here.
    """
    package = module.partition(".")[0]
    is_ours = _leads_to_facade.get(package)
    if is_ours is None:
        # A frozen program would have to import the package to know, which may be loading these errors.
        is_ours = not getattr(sys, "frozen", False) and serves_rclpy() and not is_elsewhere(package)
        _leads_to_facade[package] = is_ours
    return module if is_ours else own


def ros_repr(instance: object) -> str:
    """Return `object`'s repr with the class's name in ROS: `<rclpy.node.Node object at 0x7f…>`.

    A class that ROS doesn't have, and all classes where ROS's name leads to other ones, keep their own name.
    """
    return f"<{_ros_name(type(instance))} object at {id(instance):#x}>"


def ros_class_repr(cls: type) -> str:
    """Return a class's repr with its name in ROS: `<class 'launch.action.Action'>`; otherwise as `ros_repr`."""
    name = _ros_name(cls)
    return repr(cls) if name == f"{cls.__module__}.{cls.__qualname__}" else f"<class '{name}'>"


def _ros_name(cls: type) -> str:
    from tfloom.ros_imports.homes import HOMES  # a table that few programs read

    own = f"{cls.__module__}.{cls.__qualname__}"
    home = HOMES.get(own)
    return own if home is None or ros_home(home, "") == "" else f"{home}.{cls.__qualname__}"


def is_facade(package: str, file: str) -> bool:
    """Return whether a package of interfaces is, or would be, imported from the façade beside a generated module.

    Args:
        package: Name of the package, as `geometry_msgs`.
        file: Path of the generated module: `…/tfloom/interfaces/geometry_msgs/msg.py`.
    """
    if getattr(sys, "frozen", False):
        return _is_frozen_facade(package)
    where = _origin(package)
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(file))))
    facade = os.path.join(root, "ros_names", package, "__init__.py")
    return where is not None and os.path.abspath(where) == facade


def _is_frozen_facade(package: str) -> bool:
    """Return whether a package of a frozen program is a façade: the path is the same for each ROS, its code is not."""
    try:
        module = __import__(package)
    except ModuleNotFoundError:
        return False
    return getattr(getattr(module, "__getattr__", None), "__module__", "") == "tfloom.ros_imports.modules"


def _is_frozen_rclpy_ours() -> bool:
    """Return whether the `rclpy` of a frozen program, if any, is tfloom's.

    PyInstaller and its like put all modules into one folder, so that the path of `rclpy` is the same for each ROS. But
    its `init` is defined in tfloom if the façade was frozen.
    """
    try:
        rclpy = __import__("rclpy")
    except ModuleNotFoundError:
        return True
    home = getattr(getattr(rclpy, "init", None), "__globals__", {}).get("__name__", "")
    return str(home).startswith("tfloom.")


def _origin(name: str) -> str | None:
    loaded = sys.modules.get(name)
    if loaded is not None:
        return getattr(loaded, "__file__", None)
    from importlib.machinery import PathFinder  # slow to import, and messages seldom need it

    spec = PathFinder.find_spec(name)
    return None if spec is None else spec.origin
