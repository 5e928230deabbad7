"""Classes made at run time from definitions, for types without a Python package.

    Custom = define("my_msgs/msg/Custom", "float64[<=3] ranges")
    classes = define_folder("my_ws/src/my_msgs")

Types of a sourced workspace need neither: `registry.get_message_class` finds their definitions.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tfloom.rosidl import definition_files, registry, sources
from tfloom.rosidl.class_factory import LOCK, load
from tfloom.rosidl.parse import parse_interface


def define(name: str, text: str, path: str | None = None) -> Any:
    """Make the class of a definition and register it by its name.

    Args:
        name: `package/kind/Name`; the kind (msg, srv or action) determines how the text is parsed.
        text: The text of a definition file.
        path: Path of the text, for errors.

    Returns:
        A subclass of `Message`, `Service` or `Action`.

    Raises:
        ParseError: the text is not a definition, refers to an unknown message, or contains itself.
        ValueError: `name` is not an interface name.
    """
    parse_interface(text, name, path)
    with LOCK:
        return _define(name, text, path)


def _define(name: str, text: str, path: str | None) -> Any:
    before = sources.replace(name, sources.Source(text, path or f"{name}.{name.split('/')[1]}"))
    try:
        return load(name)
    except Exception:
        sources.replace(name, before)
        raise


def define_folder(folder: str | Path) -> dict[str, Any]:
    """Make the classes of all definitions in a package's folder, by name.

    Args:
        folder: The folder of `msg`, `srv` and `action`; its name is the package's.

    Raises:
        FileNotFoundError: the folder holds no definitions.
        ParseError: a definition can't be parsed, or refers to an unknown message.
    """
    home = Path(folder).resolve()
    names = definition_files.names_in(home)
    if not names:
        raise FileNotFoundError(f"there are no definitions in {home}/{{{','.join(definition_files.KINDS)}}}")
    for name in names:
        _, kind, base = name.split("/")
        path = home / kind / f"{base}.{kind}"
        sources.replace(name, sources.Source(path.read_text(encoding="utf-8"), str(path)))
    with LOCK:
        return {name: load(name) for name in names}


def __getattr__(name: str) -> Any:
    """Return a class by its type's name, because pickle finds classes as attributes of a module."""
    if "/" not in name:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    try:
        return registry.find_class(name)
    except LookupError as error:
        raise AttributeError(str(error)) from None
