"""Where definitions come from: what a program defined, sourced workspaces, and those that come with tfloom."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from tfloom.rosidl import spec
from tfloom.rosidl.parse import parse_interface

KINDS = ("msg", "srv", "action")


class Source(NamedTuple):
    """The text of a definition, and where it stands."""

    text: str
    path: str


_defined: dict[str, Source] = {}


def replace(name: str, source: Source | None) -> Source | None:
    """Make the definition of `package/kind/Name` known, before all others, or forget it; return what it was."""
    before = _defined.pop(name, None)
    if source is not None:
        _defined[name] = source
    return before


def definition_name(name: str) -> str:
    """Return the definition that a type is part of: `turtlesim/srv/Spawn` for `turtlesim/srv/Spawn_Request`."""
    head, slash, base = name.rpartition("/")
    return f"{head}{slash}{base.partition('_')[0]}"


def find_source(name: str) -> Source | None:
    """Return the definition of `package/kind/Name`, or None."""
    if name in _defined:
        return _defined[name]
    path = find_path(name)
    return None if path is None else Source(path.read_text(encoding="utf-8"), str(path))


def find_path(name: str) -> Path | None:
    """Return the file that defines `package/kind/Name`, in a sourced workspace or of tfloom's own, or None."""
    parts = name.split("/")
    if len(parts) != 3 or parts[1] not in KINDS or not all(part.isidentifier() for part in parts):
        return None
    package, kind, base = parts
    for share in share_folders():
        path = share / package / kind / f"{base}.{kind}"
        if path.is_file():
            return path
    return None


def definitions_folder() -> Path:
    """Return the folder of the definitions that come with tfloom: `package/kind/Name.kind`."""
    return Path(__file__).parent / "definitions"


def interface_names(kind: str = "msg") -> list[str]:
    """Return the names of all interfaces of a kind (msg, srv, action) that come with tfloom, sorted."""
    return sorted(
        f"{path.parent.parent.name}/{kind}/{path.stem}"
        for path in definitions_folder().glob(f"*/{kind}/*.{kind}")
    )


def share_folders() -> Iterator[Path]:
    """Give the folders that hold `package/kind/Name.kind`: those of AMENT_PREFIX_PATH, then tfloom's own."""
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        if prefix:
            yield Path(prefix) / "share"
    yield definitions_folder()


def names_in(package_folder: Path) -> list[str]:
    """Return the names of the definitions in a package's folder, `package/{msg,srv,action}/Name.kind`, sorted."""
    return sorted(
        f"{package_folder.name}/{kind}/{path.stem}"
        for kind in KINDS
        for path in (package_folder / kind).glob(f"*.{kind}")
    )


def find_interface(name: str) -> spec.Interface:
    """Return the spec of `package/kind/Name`.

    Raises:
        LookupError: there is no such definition.
        ParseError: it can't be read.
    """
    source = find_source(name)
    if source is None:
        raise LookupError(f"there is no definition of '{name}'")
    return parse_interface(source.text, name, source.path)


def find_message(name: str) -> spec.Message:
    """Return the spec of a message, or of a message that is part of a service or an action.

    Raises:
        LookupError: there is no such message.
        ParseError: its definition can't be read.
    """
    interface = find_interface(definition_name(name))
    messages = (interface,) if isinstance(interface, spec.Message) else interface.messages
    for message in messages:
        if message.name == name:
            return message
    raise LookupError(f"there is no definition of '{name}'")
