"""The peers that are measured in the same process as tfloom: transform-tree, pytransform3d, and scipy by hand.

Each looks up a tree's source frame in its target frame.
"""

from __future__ import annotations

import importlib
import importlib.util
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.tf2.trees import Tree
from tfloom.tf2.buffer import Buffer


def fill(tree: Tree, buffer: Buffer | None = None) -> Buffer:
    filled = Buffer(None) if buffer is None else buffer
    for link, (parent, child) in enumerate(tree.edges):
        filled.set_many(
            parent, child, tree.stamps_ns, tree.positions[link], tree.rotations_xyzw[link], "bench"
        )
    return filled


class UnableError(Exception):
    """A peer cannot look up frames in this tree."""


class Scipy:
    """A lookup as written by hand: np.interp for positions, Slerp for rotations, link by link."""

    name = "scipy by hand"
    module = "scipy"

    def __init__(self, tree: Tree) -> None:
        self._spatial: Any = importlib.import_module("scipy.spatial.transform")
        self._tree = tree
        self._branches = tree.branches()
        self._slerps = {
            link: self._spatial.Slerp(
                tree.stamps_ns, self._spatial.Rotation.from_quat(tree.rotations_xyzw[link])
            )
            for branch in self._branches
            for link in branch
        }

    def lookup_many(self, stamps_ns: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return positions (N, 3)."""
        return self.poses(stamps_ns)[0]

    def poses(self, stamps_ns: NDArray[np.int64]) -> tuple[NDArray[np.float64], Any]:
        """Return positions (N, 3) and the Rotation of N."""
        (down, down_turn), (up, up_turn) = (self._climb(branch, stamps_ns) for branch in self._branches)
        back = down_turn.inv()
        return back.apply(up - down), back * up_turn

    def _climb(self, links: list[int], stamps_ns: NDArray[np.int64]) -> tuple[NDArray[np.float64], Any]:
        position = np.zeros((len(stamps_ns), 3))
        turn = self._spatial.Rotation.identity(len(stamps_ns))
        for link in links:
            own = np.stack(
                [
                    np.interp(stamps_ns, self._tree.stamps_ns, self._tree.positions[link, :, axis])
                    for axis in range(3)
                ],
                1,
            )
            own_turn = self._slerps[link](stamps_ns)
            position, turn = own + own_turn.apply(position), own_turn * turn
        return position, turn


class Pytransform3d:
    """pytransform3d's TemporalTransformManager."""

    name = "pytransform3d"
    module = "pytransform3d"
    calls = 1

    def __init__(self, tree: Tree) -> None:
        manager = importlib.import_module("pytransform3d.transform_manager")
        self._manager = manager.TemporalTransformManager()
        self._tree = tree
        for link, (parent, child) in enumerate(tree.edges):
            wxyz = np.roll(tree.rotations_xyzw[link], 1, axis=1)
            series = manager.NumpyTimeseriesTransform(
                tree.stamps_ns.astype(float), np.hstack((tree.positions[link], wxyz))
            )
            self._manager.add_transform(child, parent, series)

    def lookup(self, stamp_ns: int) -> Any:
        return self._manager.get_transform_at_time(
            self._tree.source_frame, self._tree.target_frame, float(stamp_ns)
        )

    def lookup_many(self, stamps_ns: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return positions (N, 3)."""
        moved: NDArray[np.float64] = self._manager.get_transform_at_time(
            self._tree.source_frame, self._tree.target_frame, stamps_ns.astype(float)
        )
        return moved[..., :3, 3]


class TransformTree:
    """transform-tree, whose module is tf_tree, with a precompiled plan and a preallocated array."""

    name = "transform-tree"
    module = "tf_tree"
    calls = 2000

    def __init__(self, tree: Tree) -> None:
        tf_tree = importlib.import_module("tf_tree")
        # By default it interpolates along a screw; "lerpslerp" is tf2's interpolation.
        self.tree = tf_tree.build(tree.edges, capacity=len(tree.stamps_ns), interp="lerpslerp")
        for link, (parent, child) in enumerate(tree.edges):
            wxyz = np.roll(tree.rotations_xyzw[link], 1, axis=1)
            with self.tree.publisher(child, parent) as publisher:
                publisher.push_many(tree.stamps_ns, np.hstack((wxyz, tree.positions[link])))
        try:
            self._plan = self.tree.plan(tree.target_frame, tree.source_frame)
        except tf_tree.TfTreeError as error:
            raise UnableError(f"{self.name}: {error}") from None
        self._rows = np.empty((0, 7))

    def lookup(self, stamp_ns: int) -> Any:
        return self._plan.at(stamp_ns)

    def lookup_many(self, stamps_ns: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return positions (N, 3)."""
        if len(self._rows) != len(stamps_ns):
            self._rows = np.empty((len(stamps_ns), 7))
        self._plan.at_into(stamps_ns, self._rows, layout="quat")
        return self._rows[:, 4:]


PEERS: list[Any] = [TransformTree, Scipy, Pytransform3d]


def peers_of(tree: Tree) -> dict[str, Any]:
    """Return the installed peers by name, each filled with the tree; print which of them cannot look it up."""
    peers = {}
    for peer in PEERS:
        if importlib.util.find_spec(peer.module) is None:
            continue
        try:
            peers[peer.name] = peer(tree)
        except UnableError as error:
            print(error)
    return peers
