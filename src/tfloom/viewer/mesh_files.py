"""Files of meshes, as binary glTF for the page."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple
from xml.parsers.expat import ExpatError

import numpy as np

from tfloom.common.files import open_regular
from tfloom.common.xml import make_parser
from tfloom.viewer.mesh_places import find_mesh
from tfloom.viewer.shapes import Color, DisplayError, Model
from tfloom.viewer.textures import FileKey, Texture, content_of, file_key

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["read_model", "translucent"]

MAX_FILE_BYTES = 64 * 1024 * 1024
MAX_KEPT_BYTES = 256 * 1024 * 1024
"""Size of all meshes that are kept, of which the last one stays in any case."""
MAX_KEPT = 256
"""Number of meshes that are kept."""
MAX_SCALE = 1e6
GLB_MAGIC = b"glTF\2\0\0\0"


class _Made(NamedTuple):
    """What was made of a file."""

    glb: bytes
    has_texture: bool = False


_Key = tuple[str, int, int, Color | None, FileKey | None]
_kept: dict[_Key, _Made | DisplayError] = {}
"""The meshes that were used last, and why others can't be read, by path, time of change, size, colour and texture."""


def read_model(
    uri: str,
    scale: tuple[float, float, float],
    color: Color | None = None,
    near: Path | None = None,
    texture: Texture | None = None,
) -> Model:
    """Return the mesh of a file. One thread may call it.

    Args:
        uri: `package://PACKAGE/PATH`, or `file://PATH`; of a description from a file also a path.
        scale: Along x, y and z.
        color: The colour of all of it; None: those of the file.
        near: The folder of the description, if that is a file's; None: it came over the wire.
        texture: What is on all of it, in place of a colour: a mesh without texture coordinates has its mean colour.

    Raises:
        DisplayError: there is no such file, or it is not a mesh that can be read.
    """
    if not all(math.isfinite(part) and abs(part) < MAX_SCALE for part in scale):
        raise DisplayError(f"the scale of {uri} is not finite")
    try:
        path = find_mesh(uri, near)
        with open_regular(path) as file:
            key = *file_key(path, file), color, texture.key if texture else None
            made = _remembered(
                key, lambda: _made(path, content_of(file, uri, MAX_FILE_BYTES), color, texture)
            )
    except (OSError, ValueError) as error:
        raise DisplayError(f"{uri} can't be read: {getattr(error, 'strerror', None) or error}") from None
    return Model(made.glb, scale, made.has_texture)


def _remembered(key: _Key, make: Callable[[], _Made]) -> _Made:
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
        or sum(len(kept.glb) for kept in _kept.values() if isinstance(kept, _Made)) > MAX_KEPT_BYTES
    ):
        del _kept[next(iter(_kept))]
    if isinstance(made, DisplayError):
        raise DisplayError(str(made))
    return made


def _made(path: Path, data: bytes, color: Color | None, texture: Texture | None) -> _Made:
    """Return a file's mesh as binary glTF; one that is glTF already, and has its own colours, is returned as it is.

    Raises:
        DisplayError: it can't be read.
    """
    import trimesh

    ending = path.suffix.lower().removeprefix(".")
    if ending == "glb" and color is None and texture is None:
        if not data.startswith(GLB_MAGIC) or int.from_bytes(data[8:12], "little") != len(data):
            raise DisplayError(f"{path.name} is not a whole file of binary glTF, version 2")
        return _Made(data)
    if ending == "dae" and find_spec("collada") is None:
        raise DisplayError(f"{path.name} is COLLADA, which needs pycollada: pip install pycollada")
    try:
        unit_m = _collada_unit_m(data) if ending == "dae" else 1.0
        # From bytes, not from the path: a file that names others, as its textures, doesn't get them.
        file, has_texture = io.BytesIO(data), False
        if texture is None:
            mesh: Any = trimesh.load(file, file_type=ending, force="mesh")
        else:
            mesh, has_texture = _textured(trimesh.load(file, file_type=ending, force="scene"), texture)
            color = texture.mean
        _check(mesh)
        mesh.apply_scale(unit_m)
        if color is not None and not has_texture:
            mesh.visual = _surface(None, baseColorFactor=[*_light_of(color), 255])
        content = mesh.export(file_type="glb")
    except Exception as error:  # each format's reader has its own errors
        raise DisplayError(f"{path.name} is not a mesh that can be read: {error}") from None
    return _Made(bytes(content), has_texture)


def _light_of(color: Color) -> Color:
    """Return a colour as glTF has it: by the amount of light, which sRGB's numbers are not."""
    parts = np.array(color) / 255.0
    light = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    red, green, blue = (round(255.0 * float(part)) for part in light)
    return red, green, blue


def _textured(scene: Any, texture: Texture) -> tuple[Any, bool]:
    """Return all of a scene as one mesh, and whether it has a texture: where nothing has coordinates, it has none.

    The parts are joined without their own materials, because trimesh would join these, too, as one picture with other
    coordinates.
    """
    import trimesh

    parts = [part for part in scene.dump() if hasattr(part, "faces")]
    coordinates = [_texture_coordinates(part) for part in parts]
    for part in parts:
        part.visual = trimesh.visual.ColorVisuals(part)
    mesh: Any = trimesh.util.concatenate(parts)
    if all(table is None for table in coordinates):
        return mesh, False
    uv = [
        np.zeros((len(part.vertices), 2)) if table is None else table
        for part, table in zip(parts, coordinates, strict=True)
    ]
    mesh.visual = _surface(np.concatenate(uv), baseColorTexture=texture.picture)
    return mesh, True


def _surface(uv: NDArray[np.float64] | None, **parts: Any) -> Any:
    """Return what trimesh has for a surface that is not of metal, as glTF's is by default."""
    import trimesh

    visual: Any = trimesh.visual
    material = visual.material.PBRMaterial(**parts, metallicFactor=0.0, roughnessFactor=1.0)
    return visual.TextureVisuals(uv=uv, material=material)


def _texture_coordinates(part: Any) -> NDArray[np.float64] | None:
    """Return the texture coordinates of a mesh's vertices (N, 2); None if it has none that a page can use."""
    table = getattr(part.visual, "uv", None)
    if table is None or np.shape(table)[:1] != (len(part.vertices),) or np.ndim(table) != 2:
        return None
    uv = np.asarray(table, np.float64)[:, :2]
    return uv if uv.shape[1] == 2 and (np.abs(uv) < MAX_SCALE).all() else None


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
