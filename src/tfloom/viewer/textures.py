"""Textures: the pictures that a robot's description names for its forms."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tfloom.common.files import open_regular, read_at_most
from tfloom.viewer.mesh_places import find_texture
from tfloom.viewer.pictures import opened_picture
from tfloom.viewer.shapes import Color, DisplayError

__all__ = ["FileKey", "Texture", "content_of", "file_key", "read_texture"]

MAX_TEXTURE_BYTES = 32 * 1024 * 1024
"""Size of a file; its pixels have a limit of their own, `MAX_PIXELS` of `pictures.py`."""
MAX_SIDE_PX = 2048
"""Longer sides are reduced, because each mesh has its own copy of the picture on each page."""
MAX_KEPT = 4
"""Number of textures that are kept: the links of a robot share a few."""
PLAIN = 64
"""Range of a picture of one colour, of 256: a shade of black is black, and a JPEG is never even."""

FileKey = tuple[str, int, int]
"""Path, time of change and size of a file."""


class Texture(NamedTuple):
    """A picture for the surface of a form."""

    key: FileKey
    """By which it is known."""
    picture: Any
    """A picture of Pillow, of red, green and blue."""
    mean: Color
    """Its mean colour, for forms that have no texture coordinates."""
    is_plain: bool
    """Whether all of it has this colour."""


_kept: dict[FileKey, Texture | str] = {}
"""The textures that were used last, and why others can't be read."""


def read_texture(uri: str, near: Path | None = None) -> Texture:
    """Return the texture of a file. One thread may call it.

    Args:
        uri: As of a mesh: `package://PACKAGE/PATH`, or `file://PATH`; of a description from a file also a path.
        near: The folder of the description, if that is a file's; None: it came over the wire.

    Raises:
        DisplayError: there is no such file, or it is not a picture that can be read.
    """
    try:
        path = find_texture(uri, near)
        with open_regular(path) as file:
            key = file_key(path, file)
            made = _kept.pop(key, None) or _read(key, content_of(file, uri, MAX_TEXTURE_BYTES))
    except (OSError, ValueError) as error:
        raise DisplayError(f"{uri} can't be read: {getattr(error, 'strerror', None) or error}") from None
    _kept[key] = made
    while len(_kept) > MAX_KEPT:
        del _kept[next(iter(_kept))]
    if isinstance(made, str):
        raise DisplayError(f"{uri} is not a picture that can be read: {made}")
    return made


def file_key(path: Path, file: io.FileIO) -> FileKey:
    """Return by what an open file is known."""
    status = os.fstat(file.fileno())
    return str(path), status.st_mtime_ns, status.st_size


def content_of(file: io.FileIO, uri: str, most: int) -> bytes:
    """Return the bytes of a file.

    Raises:
        DisplayError: there are more than `most`.
        OSError: it can't be read.
    """
    size = os.fstat(file.fileno()).st_size
    content = read_at_most(file, most) if size <= most else None
    if content is None:
        raise DisplayError(f"{uri} has more than {most} bytes")
    return content


def _read(key: FileKey, content: bytes) -> Texture | str:
    """Return the texture of a file's bytes, or why there is none."""
    try:
        picture = opened_picture(content, MAX_SIDE_PX)
    except DisplayError as error:
        return str(error)
    pixels = np.asarray(picture).reshape(-1, 3)
    red, green, blue = (round(float(part)) for part in pixels.mean(axis=0))
    is_plain = bool(np.ptp(pixels, axis=0).max() < PLAIN)
    return Texture(key, picture, (red, green, blue), is_plain)
