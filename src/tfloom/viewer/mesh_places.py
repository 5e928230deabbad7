"""Where the files of meshes and textures are: in packages, and beside the description that names them."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from urllib.parse import unquote, urlparse

from tfloom.viewer.shapes import DisplayError
from tfloom.workspace.ament import PackageNotFoundError, get_package_share_path
from tfloom.workspace.packages_around import folders_above, packages_around, packages_of_clones

__all__ = ["find_mesh", "find_texture"]

ENDINGS = (".stl", ".obj", ".ply", ".glb", ".dae")
"""Of the files that are read. A description comes from the wire, and no other file is its business."""
TEXTURE_ENDINGS = (".png", ".jpg", ".jpeg", ".webp")


def find_mesh(uri: str, near: Path | None) -> Path:
    """Return the path of a mesh's file, which may be absent.

    Args:
        uri: `package://PACKAGE/PATH`, or `file://PATH`; with `near` also a path.
        near: The folder of the description, if that is a file's: packages are looked for around it, too.

    Raises:
        DisplayError: it is not the name of a mesh, or there is no such package.
    """
    return _found(uri, near, "mesh", ENDINGS)


def find_texture(uri: str, near: Path | None) -> Path:
    """Return the path of a texture's file, which may be absent; as `find_mesh`.

    Raises:
        DisplayError: it is not the name of a picture that can be read, or there is no such package.
    """
    return _found(uri, near, "texture", TEXTURE_ENDINGS)


def _found(uri: str, near: Path | None, what: str, endings: tuple[str, ...]) -> Path:
    try:
        parsed = urlparse(uri)
    except ValueError as error:
        raise DisplayError(f"{uri} is not a URI: {error}") from None
    if not parsed.path.lower().endswith(endings):
        raise DisplayError(f"{uri} is not a file of a {what}: its name ends in none of {', '.join(endings)}")
    if parsed.scheme == "file":
        path = Path(unquote(parsed.path))
        return path if near is None or path.exists() else _moved(path, near)
    if near is not None and not parsed.scheme:
        return near / uri
    if parsed.scheme not in {"package", "model"}:
        raise DisplayError(f"{uri} begins neither with package:// nor with file://")
    package, rest = parsed.netloc, unquote(parsed.path).lstrip("/")
    if not package:  # one slash too many, which readers of URDF leave out
        package, _, rest = rest.partition("/")
    return _find_in_package(package, rest, near, uri)


def _moved(path: Path, near: Path) -> Path:
    """Return where a file is that was installed on another machine, as `…/share/PACKAGE/REST`; or its path there.

    An expanded description has such paths, and stands beside the package's sources.
    """
    parts = path.parts
    for number, part in enumerate(parts[:-2]):
        if part == "share":
            package = parts[number + 1]
            for folder in (*packages_around(near, package), *packages_of_clones(near, package)):
                if (found := folder.joinpath(*parts[number + 2 :])).exists():
                    return found
    return path


def _find_in_package(package: str, rest: str, near: Path | None, uri: str) -> Path:
    # The packages around a file are a user's own, and more are there than are installed.
    places = [] if near is None else list(packages_around(near, package))
    with suppress(PackageNotFoundError, ValueError):
        places.append(get_package_share_path(package))
    places += [] if near is None else packages_of_clones(near, package)
    # Last what is above the file: a package whose folder has another name, and no manifest.
    for place in [*places, *([] if near is None else folders_above(near))]:
        if (place / rest).exists():
            return place / rest
    if places:
        return places[0] / rest
    around = "" if near is None else f", and none around {near}"
    raise DisplayError(
        f"there is no package '{package}'{around}, which {uri} is in: source its workspace before"
    )
