"""Axes of frames, and spikes to their parents, as models of few triangles, of which viser's client draws many copies.

Viser's own axes are three cylinders of 64 triangles in each frame, and its arrows have sixteen sides; without a
graphics card, thousands of them take most of the time of a picture.
"""

from __future__ import annotations

import json
import math
import struct
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from viser import SceneApi

__all__ = ["Spikes", "add_axes", "add_spikes", "axes_glb", "spikes_between"]

SIDES = 6
"""Of the prism that an axis is."""
LINEAR = 0.6038
"""The brightness of a colour by which the page shows it as 204 of 255, as those of viser's own axes."""
_FLOATS, _INDICES = 5126, 5123
"""What glTF calls 32-bit floats and 16-bit integers."""


def add_axes(
    scene: SceneApi,
    name: str,
    wxyzs: NDArray[np.float32],
    positions: NDArray[np.float32],
    length_m: float,
    radius_m: float,
) -> Any:
    """Return a node of viser's scene with axes at poses, whose number stays.

    Args:
        scene: The scene.
        name: The node's name.
        wxyzs: (N, 4), w first.
        positions: (N, 3) [m].
        length_m: Length of an axis [m], as in the node's `batched_scales`.
        radius_m: Radius of an axis [m].
    """
    return scene.add_batched_glb(
        name,
        axes_glb(radius_m / length_m),
        wxyzs,
        positions,
        batched_scales=np.full(len(positions), length_m, np.float32),
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


class Spikes(NamedTuple):
    """Where spikes are, as viser has it."""

    batched_positions: NDArray[np.float32]
    """(N, 3) [m]."""
    batched_wxyzs: NDArray[np.float32]
    """(N, 4), w first."""
    batched_scales: NDArray[np.float32]
    """(N, 3): the length and twice the half width [m]."""
    batched_colors: NDArray[np.uint8]
    """(N, 3)."""


def spikes_between(ends: NDArray[np.float64], colors: NDArray[np.uint8], radius_m: float) -> Spikes:
    """Return spikes from the first to the second end of each pair, where they are pointed.

    Args:
        ends: (N, 2, 3) [m].
        colors: (N, 3).
        radius_m: Half of the width at the first end [m].
    """
    ways = ends[:, 1] - ends[:, 0]
    lengths = np.linalg.norm(ways, axis=1)
    x, y, z = (ways / np.where(lengths > 0.0, lengths, 1.0)[:, np.newaxis]).T
    # The shortest turn from the x axis; where that is not one, half a turn about z.
    wxyzs = np.stack([1.0 + x, np.zeros(len(x)), -z, y], axis=1)
    wxyzs[1.0 + x < 1e-12] = (0.0, 0.0, 0.0, 1.0)
    wxyzs /= np.linalg.norm(wxyzs, axis=1)[:, np.newaxis]
    scales = np.stack([lengths, *[np.full(len(x), radius_m)] * 2], axis=1)
    return Spikes(ends[:, 0].astype(np.float32), wxyzs.astype(np.float32), scales.astype(np.float32), colors)


def add_spikes(scene: SceneApi, name: str, spikes: Spikes) -> Any:
    """Return a node of viser's scene with spikes, whose number may change with their poses."""
    corners = [(0.0, y, z) for y, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    sides = [(number, (number + 1) % 4, 4) for number in range(4)]
    return scene.add_batched_meshes_simple(
        name,
        np.array([*corners, (1.0, 0.0, 0.0)], np.float32),
        np.array([*sides, (0, 2, 1), (0, 3, 2)], np.uint32),
        **spikes._asdict(),
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


@lru_cache(maxsize=32)
def axes_glb(radius: float) -> bytes:
    """Return axes x, y and z of length 1, in red, green and blue that no light changes, as a binary glTF."""
    angles = np.arange(SIDES) * (2.0 * math.pi / SIDES)
    start = radius * np.stack([np.zeros(SIDES), np.cos(angles), np.sin(angles)], axis=1)
    prism = np.concatenate([start, start + np.array((1.0, 0.0, 0.0))])
    here = np.arange(SIDES)
    after = (here + 1) % SIDES
    fan = np.stack([np.zeros(SIDES - 2), here[1:-1], here[2:]], axis=1)
    faces = np.concatenate(
        [
            np.stack([here, after, SIDES + after], axis=1),
            np.stack([here, SIDES + after, SIDES + here], axis=1),
            SIDES + fan,
            fan[:, ::-1],
        ]
    )
    positions = np.concatenate([np.roll(prism, axis, axis=1) for axis in range(3)]).astype("<f4")
    colors = np.repeat(LINEAR * np.eye(3), len(prism), axis=0).astype("<f4")
    indices = np.concatenate([faces + axis * len(prism) for axis in range(3)]).astype("<u2")
    return _glb(positions, colors, indices)


def _glb(positions: NDArray[Any], colors: NDArray[Any], indices: NDArray[Any]) -> bytes:
    parts = [table.tobytes() for table in (positions, colors, indices)]
    starts = [0, len(parts[0]), len(parts[0]) + len(parts[1])]
    ends = {"min": positions.min(axis=0).tolist(), "max": positions.max(axis=0).tolist()}
    count = len(positions)
    content = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_materials_unlit"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2, "material": 0}]}
        ],
        "materials": [{"extensions": {"KHR_materials_unlit": {}}}],
        "accessors": [
            {"bufferView": 0, "componentType": _FLOATS, "count": count, "type": "VEC3", **ends},
            {"bufferView": 1, "componentType": _FLOATS, "count": count, "type": "VEC3"},
            {"bufferView": 2, "componentType": _INDICES, "count": indices.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": len(part)}
            for start, part in zip(starts, parts, strict=True)
        ],
        "buffers": [{"byteLength": sum(map(len, parts))}],
    }
    text = json.dumps(content).encode()
    chunks = b"".join(
        struct.pack("<I4s", len(chunk), kind) + chunk
        for kind, chunk in ((b"JSON", _padded(text, b" ")), (b"BIN\0", _padded(b"".join(parts), b"\0")))
    )
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def _padded(data: bytes, fill: bytes) -> bytes:
    """Return bytes whose number is divisible by four."""
    return data + fill * (-len(data) % 4)
