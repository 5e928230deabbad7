"""Who is measured beside tfloom: scipy by hand, and transform-tree and pytransform3d where they're installed."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from benchmarks.tf2.trees import Chain
from tfloom.tf2.buffer import Buffer


def optional(name: str) -> ModuleType | None:
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def fill(tree: Chain) -> Buffer:
    buffer = Buffer(None)
    for link in range(tree.depth):
        buffer.set_many(
            f"f{link}",
            f"f{link + 1}",
            tree.stamps_ns,
            tree.positions[link],
            tree.rotations_xyzw[link],
            "bench",
        )
    return buffer


class Scipy:
    """What people write by hand: np.interp for positions, Slerp for rotations, link by link."""

    name = "scipy by hand"

    def __init__(self, tree: Chain) -> None:
        spatial = importlib.import_module("scipy.spatial.transform")
        self._tree = tree
        self._slerps = [
            spatial.Slerp(tree.stamps_ns, spatial.Rotation.from_quat(tree.rotations_xyzw[link]))
            for link in range(tree.depth)
        ]

    def lookup_many(self, stamps_ns: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return positions (N, 3)."""
        position = np.zeros((len(stamps_ns), 3))
        for link in reversed(range(self._tree.depth)):
            own = np.stack(
                [
                    np.interp(stamps_ns, self._tree.stamps_ns, self._tree.positions[link, :, axis])
                    for axis in range(3)
                ],
                1,
            )
            position = own + self._slerps[link](stamps_ns).apply(position)
        return position


class Pytransform3d:
    """pytransform3d's TemporalTransformManager."""

    name = "pytransform3d"

    def __init__(self, tree: Chain) -> None:
        manager = importlib.import_module("pytransform3d.transform_manager")
        self._manager = manager.TemporalTransformManager()
        self._tree = tree
        for link in range(tree.depth):
            wxyz = np.roll(tree.rotations_xyzw[link], 1, axis=1)
            series = manager.NumpyTimeseriesTransform(
                tree.stamps_ns.astype(float), np.hstack((tree.positions[link], wxyz))
            )
            self._manager.add_transform(f"f{link + 1}", f"f{link}", series)

    def lookup_many(self, stamps_ns: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return positions (N, 3)."""
        moved: NDArray[np.float64] = self._manager.get_transform_at_time(
            self._tree.source_frame, self._tree.target_frame, stamps_ns.astype(float)
        )
        return moved[..., :3, 3]


PEERS = {"scipy": Scipy, "pytransform3d": Pytransform3d}
