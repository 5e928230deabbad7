"""The trees of the benchmarks: chains of frames and a humanoid, sampled at a constant rate."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

START_NS = 100_000_000_000
LENGTH_S = 10


class Tree(NamedTuple):
    """Frames whose links all move smoothly, and the two frames to look up."""

    edges: list[tuple[str, str]]
    """(frame_id, child_frame_id) of each link."""
    target_frame: str
    source_frame: str
    stamps_ns: NDArray[np.int64]
    """(N,), the same for every link."""
    positions: NDArray[np.float64]
    """(edges, N, 3) [m]"""
    rotations_xyzw: NDArray[np.float64]
    """(edges, N, 4)"""

    @property
    def middle_ns(self) -> int:
        """A time in the middle of the history, between two samples."""
        count = len(self.stamps_ns)
        return int(self.stamps_ns[count // 2] + self.stamps_ns[count // 2 + 1]) // 2

    @property
    def newest_ns(self) -> int:
        return int(self.stamps_ns[-1])

    def branches(self) -> tuple[list[int], list[int]]:
        """Return the links from the target and from the source up to where the two meet, as indices of edges."""
        above = {child: (index, parent) for index, (parent, child) in enumerate(self.edges)}

        def up(frame: str) -> list[int]:
            links = []
            while frame in above:
                index, frame = above[frame]
                links.append(index)
            return links

        target, source = up(self.target_frame), up(self.source_frame)
        while target and source and target[-1] == source[-1]:
            target.pop()
            source.pop()
        return target, source


def chain(depth: int, rate_hz: int) -> Tree:
    """Return the chain f0 - f1 - … - f`depth`, to be looked up from one end to the other."""
    edges = [(f"f{link}", f"f{link + 1}") for link in range(depth)]
    return _moving(edges, "f0", f"f{depth}", rate_hz)


def humanoid(rate_hz: int) -> Tree:
    """Return a body of a hundred frames, to be looked up from a finger to a foot."""
    edges = _limb("pelvis", "spine", 4) + _limb("spine4", "head", 4)
    for side in ("left", "right"):
        edges += _limb("pelvis", f"{side}_leg", 9) + _limb("spine4", f"{side}_arm", 9)
        for finger in range(5):
            edges += _limb(f"{side}_arm9", f"{side}_finger{finger}_", 5)
    edges += [("head4", f"sensor{index}") for index in range(99 - len(edges))]
    return _moving(edges, "left_leg9", "right_finger4_5", rate_hz)


def _limb(root: str, name: str, count: int) -> list[tuple[str, str]]:
    return [(f"{name}{link}" if link else root, f"{name}{link + 1}") for link in range(count)]


def _moving(edges: list[tuple[str, str]], target_frame: str, source_frame: str, rate_hz: int) -> Tree:
    count, links = LENGTH_S * rate_hz, len(edges)
    random = np.random.default_rng(links)
    seconds = np.arange(count) / rate_hz
    phases = random.uniform(0, 2 * np.pi, (links, 1, 4))
    waves = np.sin(seconds[None, :, None] * random.uniform(0.2, 1.0, (links, 1, 4)) + phases)
    turns = random.normal(size=(links, 1, 4)) + 0.3 * waves
    turns /= np.linalg.norm(turns, axis=2, keepdims=True)
    stamps = START_NS + np.arange(count) * (1_000_000_000 // rate_hz)
    return Tree(edges, target_frame, source_frame, stamps, waves[:, :, :3].copy(), turns)
