"""Files of meshes, as binary glTF for the page."""

from __future__ import annotations

import io
import math
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlparse

from tfloom.viewer.shapes import Color, DisplayError, Model
from tfloom.workspace.ament import PackageNotFoundError, get_package_share_path

__all__ = ["read_model"]

ENDINGS = (".stl", ".obj", ".ply", ".glb", ".dae")
"""Of the files that are read. A description comes from the wire, and no other file is its business."""
MAX_FILE_BYTES = 64 * 1024 * 1024
MAX_SCALE = 1e6


def read_model(uri: str, scale: tuple[float, float, float], color: Color | None = None) -> Model:
    """Return the mesh of a file.

    Args:
        uri: `package://PACKAGE/PATH`, or `file://PATH`.
        scale: Along x, y and z.
        color: The colour of all of it; None: those of the file.

    Raises:
        DisplayError: there is no such file, or it is no mesh that can be read.
    """
    if not all(math.isfinite(part) and abs(part) < MAX_SCALE for part in scale):
        raise DisplayError(f"the scale of {uri} is not finite")
    path = _path(uri)
    try:
        status = path.stat()
    except (OSError, ValueError) as error:
        raise DisplayError(f"{uri} can't be read: {getattr(error, 'strerror', None) or error}") from None
    if status.st_size > MAX_FILE_BYTES:
        raise DisplayError(f"{uri} has {status.st_size} bytes, more than {MAX_FILE_BYTES}")
    return Model(_glb(path, status.st_mtime_ns, color), scale)


def _path(uri: str) -> Path:
    parsed = urlparse(uri)
    if not parsed.path.lower().endswith(ENDINGS):
        raise DisplayError(f"{uri} is no file of a mesh: its name ends in none of {', '.join(ENDINGS)}")
    if parsed.scheme == "file":
        return Path(unquote(parsed.path))
    if parsed.scheme not in {"package", "model"}:
        raise DisplayError(f"{uri} begins neither with package:// nor with file://")
    try:
        share = get_package_share_path(parsed.netloc)
    except (PackageNotFoundError, ValueError):
        raise DisplayError(
            f"there is no package '{parsed.netloc}', which {uri} is in: source its workspace before"
        ) from None
    return share / unquote(parsed.path).lstrip("/")


@lru_cache(maxsize=256)
def _glb(path: Path, changed_ns: int, color: Color | None) -> bytes:  # noqa: ARG001  # a changed file is read anew
    """Return a file's mesh as binary glTF; one that is glTF already is returned as it is."""
    import trimesh

    ending = path.suffix.lower().removeprefix(".")
    data = path.read_bytes()
    if ending == "glb" and color is None:
        return data
    if ending == "dae" and find_spec("collada") is None:
        raise DisplayError(f"{path.name} is COLLADA, which needs pycollada: pip install pycollada")
    try:
        # From bytes, not from the path: a file that names others, as its textures, doesn't get them.
        mesh: Any = trimesh.load(io.BytesIO(data), file_type=ending, force="mesh")
        if color is not None:
            mesh.visual = trimesh.visual.ColorVisuals(mesh, face_colors=[*color, 255])
        content = mesh.export(file_type="glb")
    except Exception as error:  # noqa: BLE001  # each format's reader has its own errors
        raise DisplayError(f"{path.name} is no mesh that can be read: {error}") from None
    return bytes(content)
