"""The content of modules that `ros_finder` finds, created from definitions: `my_interfaces`, `my_interfaces.msg`."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import Any

from tfloom.rosidl import definition_files
from tfloom.rosidl.registry import find_by_definition

_PARTS = {
    "msg": ("",),
    "srv": ("", "_Request", "_Response", "_Event"),
    "action": ("", "_Goal", "_Result", "_Feedback", "_FeedbackMessage"),
}
"""The suffixes of the classes of one definition that a module lists; those of an action's services are found, too."""


def fill_module(module: ModuleType) -> None:
    """Give a module the attributes of a generated one, created at first access.

    Args:
        module: `my_interfaces`, or one of its kinds, as `my_interfaces.msg`.
    """
    package, _, kind = module.__name__.partition(".")
    if kind:
        _fill_kind(module, package, kind)
    else:
        _fill_package(module)


def _fill_package(module: ModuleType) -> None:
    package = module.__name__
    module.__doc__ = f"The interfaces of {package}, from the definitions in {_origin(module)}."

    def find_attribute(name: str) -> Any:
        if name in definition_files.KINDS:
            try:
                return import_module(f"{package}.{name}")
            except ModuleNotFoundError as error:
                if error.name != f"{package}.{name}":
                    raise
        raise AttributeError(f"module '{package}' has no attribute '{name}'", name=name, obj=module)

    vars(module)["__getattr__"] = find_attribute


def _fill_kind(module: ModuleType, package: str, kind: str) -> None:
    module.__doc__ = f"The {kind} definitions of {package}, from {_origin(module)}."

    def names() -> list[str]:
        bases = {
            name.rpartition("/")[2]
            for share in definition_files.workspace_folders()
            for name in definition_files.names_in(share / package)
            if name.split("/")[1] == kind
        }
        return sorted(f"{base}{part}" for base in bases for part in _PARTS[kind])

    def find_attribute(name: str) -> Any:
        if name == "__all__":
            return names()
        found = None if name.startswith("_") else find_by_definition(f"{package}/{kind}/{name}")
        if found is None:
            raise AttributeError(
                f"module '{module.__name__}' has no attribute '{name}': {_origin(module)} has no "
                f"{kind}/{name}.{kind}",
                name=name,
                obj=module,
            )
        return found

    vars(module)["__getattr__"] = find_attribute
    vars(module)["__dir__"] = lambda: sorted({*vars(module), *names()})


def _origin(module: ModuleType) -> str:
    spec = module.__spec__
    return str(spec.origin if spec is not None else None)
