"""Files of meshes, as binary glTF for the page."""

from __future__ import annotations

import io
import json
import math
import os
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from xml.parsers.expat import ExpatError

import numpy as np

from tfloom.common.files import open_regular, read_at_most
from tfloom.common.xml import make_parser
from tfloom.viewer.mesh_places import find_mesh
from tfloom.viewer.shapes import Color, DisplayError, Model

__all__ = ["read_model", "translucent"]

MAX_FILE_BYTES = 64 * 1024 * 1024
MAX_KEPT_BYTES = 256 * 1024 * 1024
"""Size of all meshes that are kept, of which the last one stays in any case."""
MAX_KEPT = 256
"""Number of meshes that are kept."""
MAX_SCALE = 1e6
GLB_MAGIC = b"glTF\2\0\0\0"

_Key = tuple[str, int, int, Color | None]
_kept: dict[_Key, bytes | DisplayError] = {}
"""The meshes that were used last, and why others can't be read, by path, time of change, size and colour."""


def read_model(
    uri: str, scale: tuple[float, float, float], color: Color | None = None, near: Path | None = None
) -> Model:
    """Return the mesh of a file. One thread may call it.

    Args:
        uri: `package://PACKAGE/PATH`, or `file://PATH`; of a description from a file also a path.
        scale: Along x, y and z.
        color: The colour of all of it; None: those of the file.
        near: The folder of the description, if that is a file's; None: it came over the wire.

    Raises:
        DisplayError: there is no such file, or it is not a mesh that can be read.
    """
    if not all(math.isfinite(part) and abs(part) < MAX_SCALE for part in scale):
        raise DisplayError(f"the scale of {uri} is not finite")
    path = find_mesh(uri, near)
    try:
        with open_regular(path) as file:
            status = os.fstat(file.fileno())
            key = str(path), status.st_mtime_ns, status.st_size, color
            return Model(_remembered(key, lambda: _glb(path, _content(file, uri), color)), scale)
    except (OSError, ValueError) as error:
        raise DisplayError(f"{uri} can't be read: {getattr(error, 'strerror', None) or error}") from None


def _content(file: io.FileIO, uri: str) -> bytes:
    """Return the bytes of a file.

    Raises:
        DisplayError: there are too many.
        OSError: it can't be read.
    """
    size = os.fstat(file.fileno()).st_size
    content = read_at_most(file, MAX_FILE_BYTES) if size <= MAX_FILE_BYTES else None
    if content is None:
        raise DisplayError(f"{uri} has more than {MAX_FILE_BYTES} bytes")
    return content


def _remembered(key: _Key, make: Callable[[], bytes]) -> bytes:
    """Return what was made of a file before, or make it; what can't be read isn't tried again until it changes.

    Raises:
        DisplayError: it can't be read.
    """
    made = _kept.pop(key, None)
    if made is None:
        try:
            made = make()
        except DisplayError as error:
            made = DisplayError(str(error))  # without the objects that its traceback would keep
    _kept[key] = made
    while len(_kept) > 1 and (
        len(_kept) > MAX_KEPT
        or sum(len(kept) for kept in _kept.values() if isinstance(kept, bytes)) > MAX_KEPT_BYTES
    ):
        del _kept[next(iter(_kept))]
    if isinstance(made, DisplayError):
        raise DisplayError(str(made))
    return made


def _glb(path: Path, data: bytes, color: Color | None) -> bytes:
    """Return a file's mesh as binary glTF; one that is glTF already is returned as it is.

    Raises:
        DisplayError: it can't be read.
    """
    import trimesh

    ending = path.suffix.lower().removeprefix(".")
    if ending == "glb" and color is None:
        if not data.startswith(GLB_MAGIC) or int.from_bytes(data[8:12], "little") != len(data):
            raise DisplayError(f"{path.name} is not a whole file of binary glTF, version 2")
        return data
    if ending == "dae" and find_spec("collada") is None:
        raise DisplayError(f"{path.name} is COLLADA, which needs pycollada: pip install pycollada")
    try:
        unit_m = _collada_unit_m(data) if ending == "dae" else 1.0
        # From bytes, not from the path: a file that names others, as its textures, doesn't get them.
        mesh: Any = trimesh.load(io.BytesIO(data), file_type=ending, force="mesh")
        _check(mesh)
        mesh.apply_scale(unit_m)
        if color is not None:
            # Of vertices, because trimesh needs scipy to write those of faces.
            colors = np.tile(np.array([*color, 255], np.uint8), (len(mesh.vertices), 1))
            mesh.visual = trimesh.visual.ColorVisuals(mesh, vertex_colors=colors)
        content = mesh.export(file_type="glb")
    except Exception as error:  # each format's reader has its own errors
        raise DisplayError(f"{path.name} is not a mesh that can be read: {error}") from None
    return bytes(content)


def translucent(glb: bytes, opacity: float) -> bytes:
    """Return a file of binary glTF whose materials have a share of their opacity; one that is damaged as it was."""
    length = int.from_bytes(glb[12:16], "little")
    try:
        parts = json.loads(glb[20 : 20 + length])
        materials = parts.setdefault("materials", [])
        for primitive in (one for mesh in parts["meshes"] for one in mesh["primitives"]):
            if "material" not in primitive:
                primitive["material"] = len(materials)
                materials.append({})
        for material in materials:
            surface = material.setdefault("pbrMetallicRoughness", {})
            red, green, blue, alpha = surface.get("baseColorFactor", (1.0, 1.0, 1.0, 1.0))
            surface["baseColorFactor"] = [red, green, blue, alpha * opacity]
            material["alphaMode"] = "BLEND"
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError):
        return glb
    text = json.dumps(parts).encode()
    text += b" " * (-len(text) % 4)
    rest = glb[20 + length :]
    total = 20 + len(text) + len(rest)
    return b"".join(
        (glb[:8], total.to_bytes(4, "little"), len(text).to_bytes(4, "little"), b"JSON", text, rest)
    )


def _check(mesh: Any) -> None:
    if not len(mesh.faces):
        raise DisplayError("it has no triangles")
    if not np.isfinite(mesh.vertices).all():
        raise DisplayError("a number of a vertex is not finite")


def _collada_unit_m(data: bytes) -> float:
    """Return the length of the unit of a COLLADA file [m], 1 where it says none. Its up axis changes nothing.

    Raises:
        ExpatError: it is not XML, or has entities.
    """
    unit_m = 1.0
    path: list[str] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal unit_m
        path.append(tag.rpartition("}")[2])
        if path == ["COLLADA", "asset", "unit"]:
            try:
                given = float(attributes.get("meter", "1"))
            except ValueError:
                given = 1.0
            if 0.0 < given < MAX_SCALE:
                unit_m = given

    def refuse(name: str) -> None:
        raise ExpatError(f"it has the entity '{name}', and entities are not supported")

    parser = make_parser(refuse, "}")
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: path.pop()
    parser.Parse(data, True)  # expat takes no keyword: this is all of the text
    return unit_m
