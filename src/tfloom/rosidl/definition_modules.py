"""The content of modules, created from definitions: `my_interfaces`, `my_interfaces.msg`.

`ros_imports/finder.py` finds the modules of packages that hold definitions and no Python. A built package has such
modules as files, each of which calls `fill_built_module`.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

from tfloom.ros_imports.guard import claim
from tfloom.ros_imports.modules import module_leaf
from tfloom.rosidl import definition_files
from tfloom.rosidl.class_modules import add_module
from tfloom.rosidl.registry import find_by_definition

_PARTS = {
    "msg": ("",),
    "srv": ("", "_Request", "_Response", "_Event"),
    "action": ("", "_Goal", "_Result", "_Feedback", "_FeedbackMessage"),
}
"""The suffixes of the classes of one definition that a module lists; those of an action's services are found, too."""


def fill_module(module: ModuleType, folder: str) -> None:
    """Give a module the attributes of a generated one, created at first access.

    Args:
        module: `my_interfaces`, or one of its kinds, as `my_interfaces.msg`.
        folder: The package's folder, which holds the definitions, for texts.
    """
    package, _, kind = module.__name__.partition(".")
    if kind:
        _fill_kind(module, package, kind, folder)
    else:
        _fill_package(module, folder)


def fill_built_module(name: str, file: str, prefix: str) -> None:
    """Give a module of a built package its attributes, as `fill_module`.

    Args:
        name: The module's `__name__`.
        file: The module's `__file__`.
        prefix: Path of the package's prefix, relative to the folder of `file`.

    Raises:
        ImportError: `rclpy` is another ROS's, whose nodes don't accept tfloom's messages.
    """
    package = name.partition(".")[0]
    claim(package)
    share = (Path(file).parent / prefix).resolve() / "share"
    definition_files.add_folder(share)
    fill_module(sys.modules[name], str(share / package))


def _fill_package(module: ModuleType, folder: str) -> None:
    package = module.__name__
    module.__doc__ = f"The interfaces of {package}, from the definitions in {folder}."

    def find_attribute(name: str) -> Any:
        if name in definition_files.KINDS:
            try:
                return import_module(f"{package}.{name}")
            except ModuleNotFoundError as error:
                if error.name != f"{package}.{name}":
                    raise
        raise AttributeError(f"module '{package}' has no attribute '{name}'", name=name, obj=module)

    vars(module)["__getattr__"] = find_attribute


def _fill_kind(module: ModuleType, package: str, kind: str, folder: str) -> None:
    module.__doc__ = f"The {kind} definitions of {package}, from {folder}."

    def bases() -> set[str]:
        shares = definition_files.workspace_folders()
        return {name for share in shares for name in definition_files.interfaces_of(share / package, kind)}

    def names() -> list[str]:
        return sorted(f"{base}{part}" for base in bases() for part in _PARTS[kind])

    for base in bases():
        add_module(f"{module.__name__}.{module_leaf(base)}", module.__name__)

    def find_attribute(name: str) -> Any:
        if name == "__all__":
            return names()
        if (definition_module := sys.modules.get(f"{module.__name__}.{name}")) is not None:
            return definition_module
        interface_class = None if name.startswith("_") else find_by_definition(f"{package}/{kind}/{name}")
        if interface_class is None:
            raise AttributeError(
                f"module '{module.__name__}' has no attribute '{name}': {folder} has no {kind}/{name}.{kind}",
                name=name,
                obj=module,
            )
        return interface_class

    vars(module)["__getattr__"] = find_attribute
    vars(module)["__dir__"] = lambda: sorted({*vars(module), *names()})
