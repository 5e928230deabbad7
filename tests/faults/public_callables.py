"""Where the public names of tfloom take a function of the program's, read from their signatures."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import warnings
from collections.abc import Iterator
from types import ModuleType
from typing import Any

PACKAGES = (
    *("tfloom.ros_names.rclpy", "tfloom.ros_names.tf2_ros", "tfloom.ros_names.tf2_py"),
    *("tfloom.ros_names.message_filters", "tfloom.ros_names.rosbag2_py", "tfloom.ros_names.launch"),
    *("tfloom.ros_names.launch_ros", "tfloom.ros_names.launch_testing", "tfloom.ros_names.launch_pytest"),
    *("tfloom.ros_names.launch_testing_ros", "tfloom_sensing.ros_names.diagnostic_updater"),
    "tfloom_sensing.ros_names.interactive_markers",
)
"""The ROS packages of which programs call functions; the others are types, geometry and commands."""
OURS = ("tfloom.", "tfloom_sensing.")
"""The starts of our modules' names."""
NO_FUNCTIONS = ("callback_group", "CallbackGroup", "use_default_callbacks", "callback_handle")
"""Names of parameters, and annotations, that have `callback` in them and take no function."""


def public_modules(package: str) -> Iterator[ModuleType]:
    """Import a package of ROS's names and its public submodules."""
    top = importlib.import_module(package)
    yield top
    for info in pkgutil.walk_packages(top.__path__, f"{top.__name__}."):
        if not any(part.startswith("_") for part in info.name.split(".")):
            yield importlib.import_module(info.name)


def own_names(module: ModuleType) -> Iterator[Any]:
    """Return the classes and functions of tfloom that a module has, imported there or on first use."""
    for name in dir(module):
        if not name.startswith("_"):
            value = getattr(module, name)
            if str(getattr(value, "__module__", "")).startswith(OURS) and not inspect.ismodule(value):
                yield value


def functions_of(value: Any) -> Iterator[Any]:
    """Return a function, or the public methods and the constructor of a class."""
    if inspect.isfunction(value):
        yield value
    if inspect.isclass(value):
        for base in value.__mro__:
            if base.__module__.startswith(OURS):
                for name, member in vars(base).items():
                    function = getattr(member, "__func__", member)
                    if inspect.isfunction(function) and (not name.startswith("_") or name == "__init__"):
                        yield function


def takes_function(parameter: inspect.Parameter) -> bool:
    """Return whether a parameter takes a function of the program's, by its name or its annotation."""
    text = f"{parameter.name}: {parameter.annotation}"
    if any(word in text for word in NO_FUNCTIONS):
        return False
    return "callback" in text.lower() or "Callable" in text or parameter.name in ("cb", "fn")


def public_callables() -> set[str]:
    """Return `module.function(parameter)` for every function of a program's that the public names take."""
    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore"
        )  # of modules that are deprecated, which some names import on first use
        return {function for package in PACKAGES for function in _callables_of(package)}


def _callables_of(package: str) -> Iterator[str]:
    for module in public_modules(package):
        for value in own_names(module):
            for function in functions_of(value):
                for parameter in inspect.signature(function).parameters.values():
                    if takes_function(parameter):
                        where = function.__module__.removeprefix("tfloom.")
                        yield f"{where}.{function.__qualname__}({parameter.name})"
