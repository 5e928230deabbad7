"""Interface types by name."""

from __future__ import annotations

import sys

from tfloom.rosidl.message import Message

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any

_classes: dict[str, Any] = {}


def get_message_class(name: str) -> type[Message]:
    """Return the class of a message: `geometry_msgs/msg/Twist`, or `geometry_msgs/Twist` for short.

    Those of tfloom come first, then those of any importable package `package.msg`.

    Raises:
        LookupError: there is no such message, with the nearest name that there is.
    """
    whole = name.replace("/", "/msg/") if name.count("/") == 1 else name
    found = _classes.get(whole)
    if found is None:
        found = _classes[whole] = _find(whole)
    return found


def register(cls: type[Message]) -> None:
    """Make a class known that no package holds, such as one made at run time."""
    _classes[cls._TYPE_NAME] = cls


def definitions_folder() -> Path:
    """Return where the definitions that come with tfloom are: `package/kind/Name.kind`."""
    from pathlib import Path

    return Path(__file__).parent / "definitions"


def interface_names(kind: str = "msg") -> list[str]:
    """Return the names of all interfaces of a kind (msg, srv, action) that come with tfloom, sorted."""
    return sorted(
        f"{path.parent.parent.name}/{kind}/{path.stem}"
        for path in definitions_folder().glob(f"*/{kind}/*.{kind}")
    )


def _find(name: str) -> type[Message]:
    parts = name.split("/")
    if len(parts) == 3 and all(part.isidentifier() for part in parts):
        package, kind, base = parts
        for module_name in (f"tfloom.interfaces.{package}.{kind}", f"{package}.{kind}"):
            found = getattr(_import(module_name), base, None)
            if isinstance(found, type) and issubclass(found, Message):
                return found
    raise LookupError(f"there is no message type '{name}'{_nearest(name)}")


def _import(module_name: str) -> Any:
    """Import a module, or give None if it or its package is not there. What fails inside it is raised."""
    try:
        __import__(module_name)
    except ModuleNotFoundError as error:
        if error.name is None or not module_name.startswith(error.name):
            raise
        return None
    return sys.modules[module_name]


def _nearest(name: str) -> str:
    import difflib

    known = interface_names()
    base = name.rpartition("/")[2]
    close = [each for each in known if each.endswith(f"/{base}")] or difflib.get_close_matches(name, known, 1)
    return f"; did you mean '{close[0]}'?" if close else ""
