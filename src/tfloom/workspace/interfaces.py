"""Definitions of messages, services and actions, of sourced workspaces and of tfloom."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from pathlib import Path

from tfloom.rosidl.definition_files import (
    IDL_SUFFIX,
    KINDS,
    find_path,
    interfaces_of,
    names_in,
    own_folders,
    path_in,
    workspace_folders,
)
from tfloom.workspace import index


def interface_packages() -> dict[str, Path]:
    """Return the folder with the definitions of each package that has some, in order of their names.

    Of a workspace's packages these are the ones with ament's marker, and those whose folder holds definitions.
    """
    own = {path.name: path for folder in own_folders() for path in folder.iterdir() if path.is_dir()}
    built = {
        name: Path(prefix, "share", name) for name, prefix in index.resources("rosidl_interfaces").items()
    }
    unmarked = {
        folder.name: folder
        for share in reversed([*workspace_folders()])
        for folder in share.glob("*/")
        if names_in(folder)
    }
    return dict(sorted((own | unmarked | built).items()))


def known_interfaces(*kinds: str) -> list[str]:
    """Return the full names of all interfaces of these kinds, or of all kinds, package by package."""
    return [
        f"{package}/{kind}/{name}"
        for package, folder in interface_packages().items()
        for kind in kinds or KINDS
        for name in interfaces_of(folder, kind)
    ]


def split_name(name: str) -> tuple[str, str, str]:
    """Return package, kind and name of an interface: `std_msgs/msg/String`, or `std_msgs/String` for short.

    Raises:
        LookupError: the name isn't of that form.
    """
    parts = name.split("/")
    if len(parts) == 2:
        package, base = parts
        folder = interface_packages().get(package)
        kind = next((kind for kind in KINDS if folder and path_in(folder, kind, base) is not None), "msg")
        parts = [package, kind, base]
    if len(parts) != 3 or parts[1] not in KINDS or not all(part.isidentifier() for part in parts):
        candidates = [
            interface
            for interface in known_interfaces()
            if len(parts) == 1 and interface.rpartition("/")[2].lower() == name.lower()
        ]
        near = f"\ndid you mean {' or '.join(candidates[:3])}?" if candidates else ""
        raise LookupError(f"an interface's name is like std_msgs/msg/String, not '{name}'{near}")
    return parts[0], parts[1], parts[2]


def definition_path(name: str) -> Path:
    """Return the file of an interface's definition.

    Raises:
        LookupError: there is no such package, or no such interface in it; the text has the nearest name.
    """
    package, kind, base = split_name(name)
    folders = interface_packages()
    if package not in folders:
        raise LookupError(f"Unknown package '{package}'{_nearest(package, list(folders))}")
    path = find_path(f"{package}/{kind}/{base}")
    if path is None:
        candidates = [
            f"{package}/{other_kind}/{other}"
            for other_kind in KINDS
            for other in interfaces_of(folders[package], other_kind)
        ]
        missing = folders[package] / kind / f"{base}{IDL_SUFFIX}"
        raise LookupError(
            f"Could not find the interface '{missing}'{_nearest(f'{package}/{kind}/{base}', candidates)}"
        )
    return path


def _nearest(name: str, known: list[str]) -> str:
    near = difflib.get_close_matches(name, known, 1, 0.5)
    return f"\ndid you mean {near[0]}?" if near else ""


def expanded_definition(name: str, comments: str = "own") -> Iterator[str]:
    """Yield the lines of a definition, and below each field of an interface's type that type's, indented by a tab.

    The lines of an .idl file are yielded as they are.

    Args:
        name: Full name of the interface.
        comments: Comments to keep: `all`, `none`, or those of the interface's `own` file.
    """
    name = "/".join(split_name(name))
    yield from _expand(name, comments, "", (name,))


def _expand(name: str, comments: str, indent: str, above: tuple[str, ...]) -> Iterator[str]:
    from tfloom.rosidl.parse import message_in_field, without_comment

    package = name.split("/", maxsplit=1)[0]
    keep = comments == "all" or (comments == "own" and not indent)
    path = definition_path(name)
    lines = path.read_text("utf-8").splitlines()
    if path.suffix == IDL_SUFFIX:
        yield from (indent + line.rstrip() for line in lines)
        return
    for raw in lines:
        line = raw.rstrip() if keep else without_comment(raw)
        if line or (keep and not indent):
            yield indent + line
        inner = message_in_field(raw, package)
        if inner and inner not in above:
            yield from _expand(inner, comments, indent + "\t", (*above, inner))
