"""Definition files, `package/kind/Name.kind`, of sourced workspaces, then of tfloom."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

KINDS = ("msg", "srv", "action")


def find_path(name: str) -> Path | None:
    """Return the file that defines `package/kind/Name`, in a sourced workspace or in tfloom, or None."""
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
    """Return the folder of tfloom's definitions: `package/kind/Name.kind`."""
    return Path(__file__).parent / "definitions"


def interface_names(kind: str = "msg") -> list[str]:
    """Return the names of all tfloom's interfaces of a kind (msg, srv, action), sorted."""
    return sorted(
        f"{path.parent.parent.name}/{kind}/{path.stem}"
        for path in definitions_folder().glob(f"*/{kind}/*.{kind}")
    )


def share_folders() -> Iterator[Path]:
    """Yield the folders that hold `package/kind/Name.kind`: those of AMENT_PREFIX_PATH, then tfloom's own."""
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        if prefix:
            yield Path(prefix) / "share"
    yield definitions_folder()


def interfaces_of(package_folder: Path, kind: str) -> list[str]:
    """Return the names of a package's definitions of a kind, without package and kind, sorted."""
    return sorted(path.stem for path in (package_folder / kind).glob(f"*.{kind}"))


def names_in(package_folder: Path) -> list[str]:
    """Return the names of all definitions in a package's folder, `package/kind/Name`, sorted."""
    return sorted(
        f"{package_folder.name}/{kind}/{name}"
        for kind in KINDS
        for name in interfaces_of(package_folder, kind)
    )
