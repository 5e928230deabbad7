"""Definitions of messages, services and actions: of the workspaces, and those that tfloom brings."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator
from pathlib import Path

from tfloom.workspace import index

KINDS = ("msg", "srv", "action")
PRIMITIVES = {"bool", "byte", "char", "string", "wstring", "float32", "float64"} | {
    f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)
}


def interface_packages() -> dict[str, Path]:
    """Return the folder with the definitions of each package that has some, in order of their names."""
    own = {
        path.name: path for path in (index.OWN_PREFIX / "rosidl" / "definitions").iterdir() if path.is_dir()
    }
    built = {
        name: Path(prefix, "share", name) for name, prefix in index.resources("rosidl_interfaces").items()
    }
    return dict(sorted((own | built).items()))


def interfaces_of(folder: Path, kind: str) -> list[str]:
    """Return the names of a package's interfaces of a kind, without the package's, in order."""
    return sorted(path.stem for path in (folder / kind).glob(f"*.{kind}"))


def split_name(name: str) -> tuple[str, str, str]:
    """Return package, kind and name of an interface: `std_msgs/msg/String`, or `std_msgs/String` for short.

    Raises:
        LookupError: the name isn't of that form.
    """
    parts = name.split("/")
    if len(parts) == 2:
        package, base = parts
        folder = interface_packages().get(package)
        kind = next(
            (kind for kind in KINDS if folder and (folder / kind / f"{base}.{kind}").is_file()), "msg"
        )
        parts = [package, kind, base]
    if len(parts) != 3 or parts[1] not in KINDS or not all(part.isidentifier() for part in parts):
        known = [
            f"{package}/{kind}/{base}"
            for package, folder in interface_packages().items()
            for kind in KINDS
            for base in interfaces_of(folder, kind)
            if len(parts) == 1 and base.lower() == name.lower()
        ]
        near = f"\ndid you mean {' or '.join(known[:3])}?" if known else ""
        raise LookupError(f"an interface's name is like std_msgs/msg/String, not '{name}'{near}")
    return parts[0], parts[1], parts[2]


def read_definition(name: str) -> str:
    """Return the text of an interface's definition.

    Raises:
        LookupError: there is no such package, or no such interface in it; it names the nearest.
    """
    package, kind, base = split_name(name)
    folders = interface_packages()
    if package not in folders:
        raise LookupError(f"Unknown package '{package}'{_nearest(package, list(folders))}")
    path = folders[package] / kind / f"{base}.{kind}"
    if not path.is_file():
        known = [
            f"{package}/{each}/{other}" for each in KINDS for other in interfaces_of(folders[package], each)
        ]
        raise LookupError(
            f"Could not find the interface '{name}'{_nearest(f'{package}/{kind}/{base}', known)}"
        )
    return path.read_text("utf-8")


def _nearest(name: str, known: list[str]) -> str:
    near = difflib.get_close_matches(name, known, 1, 0.5)
    return f"\ndid you mean {near[0]}?" if near else ""


def expanded_definition(name: str, comments: str = "own") -> Iterator[str]:
    """Yield the lines of a definition, and under each field of an interface's type that type's, a tab deeper.

    Args:
        name: Full name of the interface.
        comments: Which comments stay: `all`, `none`, or those of the interface's `own` file.
    """
    name = "/".join(split_name(name))
    yield from _expand(name, comments, "", (name,))


def _expand(name: str, comments: str, indent: str, above: tuple[str, ...]) -> Iterator[str]:
    package = name.split("/", maxsplit=1)[0]
    keep = comments == "all" or (comments == "own" and not indent)
    for raw in read_definition(name).splitlines():
        line = raw.rstrip() if keep else _without_comment(raw)
        if line or (keep and not indent):
            yield indent + line
        inner = _type_of_field(raw, package)
        if inner and inner not in above:
            yield from _expand(inner, comments, indent + "\t", (*above, inner))


def _without_comment(line: str) -> str:
    """Return a line with no comment; a # between quotes begins none."""
    return re.sub(r"""("[^"]*"|'[^']*')|\s*\#.*""", lambda match: match[1] or "", line).rstrip()


def _type_of_field(line: str, package: str) -> str | None:
    """Return the full name of a field's type if that is an interface."""
    match = re.match(r"\s*([A-Za-z]\w*(?:/\w+)*)(?:<=\d+)?(?:\[[^\]]*\])?\s+[A-Za-z]\w*(?!\w)(?!\s*=)", line)
    if not match or match[1] in PRIMITIVES:
        return None
    parts = match[1].split("/")
    if len(parts) == 1:
        return f"{package}/msg/{parts[0]}"
    return f"{parts[0]}/msg/{parts[-1]}"
