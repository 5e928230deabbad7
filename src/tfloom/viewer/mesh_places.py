"""Where the files of meshes are: in packages, and beside the description that names them."""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from urllib.parse import unquote, urlparse

from tfloom.common.files import open_regular, read_at_most
from tfloom.viewer.shapes import DisplayError
from tfloom.workspace.ament import PackageNotFoundError, get_package_share_path

__all__ = ["find_mesh"]

ENDINGS = (".stl", ".obj", ".ply", ".glb", ".dae")
"""Of the files that are read. A description comes from the wire, and no other file is its business."""
MAX_LEVELS = 8
"""Number of folders above a description in which packages are looked for."""
MAX_FOLDERS = 500
"""Number of folders in each of them that are looked at."""
MAX_MANIFEST_BYTES = 1024 * 1024


def find_mesh(uri: str, near: Path | None) -> Path:
    """Return the path of a mesh's file, which may be absent.

    Args:
        uri: `package://PACKAGE/PATH`, or `file://PATH`; with `near` also a path.
        near: The folder of the description, if that is a file's: packages are looked for around it, too.

    Raises:
        DisplayError: it is not the name of a mesh, or there is no such package.
    """
    try:
        parsed = urlparse(uri)
    except ValueError as error:
        raise DisplayError(f"{uri} is not a URI: {error}") from None
    if not parsed.path.lower().endswith(ENDINGS):
        raise DisplayError(f"{uri} is not a file of a mesh: its name ends in none of {', '.join(ENDINGS)}")
    if parsed.scheme == "file":
        return Path(unquote(parsed.path))
    if near is not None and not parsed.scheme:
        return near / uri
    if parsed.scheme not in {"package", "model"}:
        raise DisplayError(f"{uri} begins neither with package:// nor with file://")
    package, rest = parsed.netloc, unquote(parsed.path).lstrip("/")
    if not package:  # one slash too many, which readers of URDF leave out
        package, _, rest = rest.partition("/")
    return _find_in_package(package, rest, near, uri)


def _find_in_package(package: str, rest: str, near: Path | None, uri: str) -> Path:
    # The packages around a file are a user's own, and more are there than are installed.
    places = [] if near is None else list(_packages_around(near, package))
    with suppress(PackageNotFoundError, ValueError):
        places.append(get_package_share_path(package))
    # Last what is above the file: a package whose folder has another name, and no manifest.
    for place in [*places, *([] if near is None else _folders_above(near))]:
        if (place / rest).exists():
            return place / rest
    if places:
        return places[0] / rest
    around = "" if near is None else f", and none around {near}"
    raise DisplayError(
        f"there is no package '{package}'{around}, which {uri} is in: source its workspace before"
    )


def _folders_above(near: Path) -> list[Path]:
    """Return a folder and those that it is in, the nearest first."""
    return list(itertools.islice((near.absolute(), *near.absolute().parents), MAX_LEVELS))


@functools.lru_cache(MAX_FOLDERS)
def _packages_around(near: Path, package: str) -> tuple[Path, ...]:
    """Return the folders of a package of this name: one that a folder is in, then those beside it."""
    return tuple(_find_packages(near, package))


def _find_packages(near: Path, package: str) -> Iterator[Path]:
    if not re.fullmatch(r"[\w.-]+", package) or not package.strip("."):
        return
    above = _folders_above(near)
    for folder in above:
        if folder.name == package:
            yield folder
        yield from (found for found in (folder / package, folder / "share" / package) if found.is_dir())
    for folder in above:
        yield from (found for found in _folders(folder) if _has_name(found, package))


def _folders(folder: Path) -> list[Path]:
    try:
        return [found for found in itertools.islice(folder.iterdir(), MAX_FOLDERS) if found.is_dir()]
    except OSError:
        return []


def _has_name(folder: Path, package: str) -> bool:
    """Return whether a folder's package.xml is of a package of this name."""
    try:
        with open_regular(folder / "package.xml") as file:
            content = read_at_most(file, MAX_MANIFEST_BYTES) or b""
    except (OSError, ValueError):
        return False
    match = re.search(rb"<name>\s*([^<\s]+)\s*</name>", content)
    return match is not None and match[1] == package.encode()
