"""Classes made at run time from definitions, for types without a Python package.

    Custom = define("my_msgs/msg/Custom", "float64[<=3] ranges")
    classes = define_folder("my_ws/src/my_msgs")

Types of a sourced workspace need neither: `registry.get_message_class` and `from my_msgs.msg import Custom` find them.
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

from tfloom.rosidl import definition_files, registry, sources
from tfloom.rosidl.class_factory import LOCK, load
from tfloom.rosidl.parse import ParseError


def define(name: str, text: str, path: str | None = None) -> Any:
    """Make the class of a definition and register it by its name.

    Args:
        name: `package/kind/Name`; the kind (msg, srv or action) determines how the text is parsed.
        text: The text of a definition file.
        path: Path of the text, for errors; the text is IDL if it ends in `.idl`.

    Returns:
        A subclass of `Message`, `Service` or `Action`.

    Raises:
        ParseError: the text is not a definition, refers to an unknown message, or contains itself.
        ValueError: `name` is not an interface name.
    """
    # Parse before the lock is acquired and anything is registered: a text with a mistake changes nothing.
    sources.parse_source(_source(name, text, path), name)
    with LOCK:
        return _define(name, text, path)


def _source(name: str, text: str, path: str | None) -> sources.Source:
    return sources.Source(text, path or f"{name}.{'/'.join(name.split('/')[1:2])}")


def _define(name: str, text: str, path: str | None) -> Any:
    # The source is registered first, because loading looks definitions up by name, this one included. If the class
    # can't be made, the former definition of this name is valid again.
    before = sources.replace(name, _source(name, text, path))
    try:
        return load(name)
    except Exception:
        sources.replace(name, before)
        raise


def define_folder(folder: str | Path) -> dict[str, Any]:
    """Make the classes of all definitions in a package's folder, by name.

    Definitions that can't be loaded, because they can't be parsed or refer to what can't be loaded, are left out, and
    one warning names each with its file, line and reason.

    Args:
        folder: The folder of `msg`, `srv` and `action`; its name is the package's.

    Raises:
        FileNotFoundError: the folder holds no definitions.
        ValueError: none of them can be loaded; the text is that of the warning.
    """
    home = Path(folder).resolve()
    names = definition_files.names_in(home)
    if not names:
        raise FileNotFoundError(f"there are no definitions in {home}/{{{','.join(definition_files.KINDS)}}}")
    with LOCK:
        classes, failures = _define_all(home, names)
    if failures:
        reasons = "".join(f"\n  {name}: {error}" for name, error in sorted(failures.items()))
        text = f"{len(failures)} of {len(names)} definitions in {home} can't be loaded:{reasons}"
        if not classes:
            raise ValueError(text)
        warnings.warn(text, stacklevel=2)
    return classes


def _define_all(home: Path, names: list[str]) -> tuple[dict[str, Any], dict[str, Exception]]:
    """Return the classes of those definitions that can be loaded, and the errors of the others."""
    classes: dict[str, Any] = {}
    failures: dict[str, Exception] = {}
    before: dict[str, sources.Source | None] = {}
    for name in names:  # all of them, before any is loaded: they refer to one another
        _, kind, base = name.split("/")
        path = definition_files.path_in(home, kind, base) or home / kind / f"{base}.{kind}"
        try:
            before[name] = sources.replace(name, sources.read_source(path))
        except (OSError, ParseError) as error:
            failures[name] = error
    for name in before:
        try:
            classes[name] = load(name)
        except ValueError as error:  # each has its own reason
            failures[name] = error
    # A definition without a class must not stay: others would find it by name, and fail later and elsewhere.
    for name in failures.keys() & before.keys():
        sources.replace(name, before[name])
    return classes, failures


def __getattr__(name: str) -> Any:
    """Return a class by its type's name, because pickle finds classes as attributes of a module."""
    if "/" not in name:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    try:
        return registry.find_class(name)
    except LookupError as error:
        raise AttributeError(str(error)) from None
