"""Definition files, `package/kind/Name.kind` or `package/kind/Name.idl`, of sourced workspaces, then of tfloom.

Where a package has both of one name, as ROS's own do, the `.idl` is generated from the other, which has precedence. The
packages of the distribution `tfloom-interfaces`, if it is installed, count as tfloom's.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from tfloom.ros_imports import ros_distro
from tfloom.ros_imports.distributions import INTERFACES, find_prefix

KINDS = ("msg", "srv", "action")
IDL_SUFFIX = ".idl"


def find_path(name: str) -> Path | None:
    """Return the file that defines `package/kind/Name`, in a sourced workspace or in tfloom, or None."""
    parts = name.split("/")
    if len(parts) != 3 or parts[1] not in KINDS or not all(part.isidentifier() for part in parts):
        return None
    package, kind, base = parts
    return next(filter(None, (path_in(share / package, kind, base) for share in share_folders())), None)


def path_in(package_folder: Path, kind: str, base: str) -> Path | None:
    """Return the file in a package's folder that defines an interface, or None."""
    for suffix in (f".{kind}", IDL_SUFFIX):
        path = package_folder / kind / f"{base}{suffix}"
        if path.is_file():
            return path if package_folder.parent != definitions_folder() else _followed(path)
    return None


def _followed(path: Path) -> Path:
    """Return the file that has the form of the distribution that is followed, for one of tfloom's definitions."""
    later = later_folder() / path.relative_to(definitions_folder())
    return later if ros_distro.HAS_LATER_DEFINITIONS and later.is_file() else path


def forms_of(name: str) -> list[Path]:
    """Return the files of both forms of a definition that newer distributions have in another form; else none."""
    package, kind, base = name.split("/")
    paths = [folder / package / kind / f"{base}.{kind}" for folder in (definitions_folder(), later_folder())]
    return paths if all(path.is_file() for path in paths) else []


def definitions_folder() -> Path:
    """Return the folder of tfloom's definitions: `package/kind/Name.kind`."""
    return Path(__file__).parent / "definitions"


def later_folder() -> Path:
    """Return the folder of the definitions that have another form from Lyrical on."""
    return Path(__file__).parent / "definitions_lyrical"


def own_folders() -> list[Path]:
    """Return the folders of tfloom's definitions, and of those of `tfloom-interfaces` where it is installed."""
    extra = find_prefix(INTERFACES)
    return [definitions_folder()] if extra is None else [definitions_folder(), extra / "definitions"]


def interface_names(kind: str = "msg") -> list[str]:
    """Return the names of all tfloom's interfaces of a kind (msg, srv, action), sorted."""
    return sorted(
        f"{path.parent.parent.name}/{kind}/{path.stem}"
        for folder in own_folders()
        for path in folder.glob(f"*/{kind}/*.{kind}")
    )


_added: list[Path] = []
"""Folders of built packages that were imported: a program may have them on its Python path alone."""


def add_folder(share: Path) -> None:
    """Search a folder that holds `package/kind/Name.kind`, too, after those of AMENT_PREFIX_PATH."""
    if share not in _added:
        _added.append(share)


def workspace_folders() -> Iterator[Path]:
    """Yield the folders that may hold `package/kind/Name.kind`: on AMENT_PREFIX_PATH, then of imported packages."""
    ros_folders = [
        Path(prefix) / "share"
        for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
        if prefix
    ]
    yield from dict.fromkeys((*ros_folders, *_added))


def share_folders() -> Iterator[Path]:
    """Yield the folders that hold `package/kind/Name.kind`: a workspace's, then tfloom's own."""
    yield from workspace_folders()
    yield from own_folders()


def interfaces_of(package_folder: Path, kind: str) -> list[str]:
    """Return the names of a package's definitions of a kind, without package and kind, sorted."""
    suffixes = {f".{kind}", IDL_SUFFIX}
    return sorted({path.stem for path in (package_folder / kind).glob("*.*") if path.suffix in suffixes})


def names_in(package_folder: Path) -> list[str]:
    """Return the names of all definitions in a package's folder, `package/kind/Name`, sorted."""
    return sorted(
        f"{package_folder.name}/{kind}/{name}"
        for kind in KINDS
        for name in interfaces_of(package_folder, kind)
    )
