"""Record the public names of an installed rclpy, with the signatures of its functions: run this in its Python.

    PEER/bin/python tests/oracles/record_rclpy_names.py tests/golden/api_kilted.json.gz

The answers have the form of `api_jazzy.json.gz`: by module, what it defines. Nothing of the sources is read; names,
signatures and constants are asked of the imported modules. The same names give the same bytes.
"""

from __future__ import annotations

import enum
import gzip
import importlib
import inspect
import json
import pkgutil
import re
import sys
import warnings
from pathlib import Path
from typing import Any

PACKAGE = "rclpy"
NOT_PUBLIC = re.compile(r"(^|\.)_|\.impl(\.|$)")
NOT_NAMES = {"TYPE_CHECKING", "annotations"}
"""What `from typing import …` and `from __future__ import …` leave in a module."""
ADDRESS = re.compile(r" at 0x[0-9a-f]+")


def signature_of(function: Any) -> str | None:
    """Return a signature without addresses, which differ from run to run; None if it can't be told."""
    try:
        return ADDRESS.sub("", str(inspect.signature(function)))
    except (TypeError, ValueError):
        return None


def member_of(owner: type, name: str) -> Any:
    """Return the form of a member: a signature, `property`, the value of a constant, or None for one of an enum."""
    value = inspect.getattr_static(owner, name)
    if isinstance(value, property) or inspect.isdatadescriptor(value):
        return "property"
    if issubclass(owner, enum.Enum) and name in owner.__members__:
        return None
    function = getattr(value, "__func__", value)
    if callable(function):
        return signature_of(function) or "(self, *args, **kwargs)"
    return value if isinstance(value, (bool, int, float)) else "attribute"


def class_entry(cls: type) -> dict[str, Any]:
    """Return bases, constructor and own public members of a class."""
    members = {name: member_of(cls, name) for name in vars(cls) if not name.startswith("_")}
    return {
        "kind": "class",
        "bases": [base.__name__ for base in cls.__bases__],
        "init": signature_of(cls.__init__) or "",
        "members": members,
    }


def entry_of(module: str, value: Any) -> dict[str, Any] | None:
    """Return what a module's name stands for; None for what another module defines."""
    if inspect.ismodule(value) or getattr(value, "__module__", module) != module:
        return None
    if inspect.isclass(value):
        return class_entry(value)
    if inspect.isfunction(value):
        return {"kind": "function", "signature": signature_of(value)}
    return {"kind": "value", "type": type(value).__name__}


def names_of(module: str) -> dict[str, Any]:
    """Return the public names that a module defines."""
    loaded = importlib.import_module(module)
    entries = {
        name: entry_of(module, value) for name, value in vars(loaded).items() if not name.startswith("_")
    }
    return {name: entry for name, entry in entries.items() if entry is not None and name not in NOT_NAMES}


def main(path: str) -> None:
    """Write the names to a file."""
    package = importlib.import_module(PACKAGE)
    found = pkgutil.walk_packages(package.__path__, f"{PACKAGE}.")
    modules = [PACKAGE, *(info.name for info in found if not NOT_PUBLIC.search(info.name))]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        names = {module: names_of(module) for module in sorted(modules)}
    text = json.dumps({module: entries for module, entries in names.items() if entries}, sort_keys=True)
    with Path(path).open("wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as zipped:
        zipped.write(text.encode())


if __name__ == "__main__":
    main(sys.argv[1])
