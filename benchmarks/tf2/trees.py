"""The trees that all peers are filled with: chains of frames, sampled at a constant rate."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

START_NS = 100_000_000_000
LENGTH_S = 10


class Chain(NamedTuple):
    """f0 - f1 - … - f`depth`; each link moves smoothly."""

    depth: int
    stamps_ns: NDArray[np.int64]
    """(N,) the same for every link."""
    positions: NDArray[np.float64]
    """(depth, N, 3) [m]"""
    rotations_xyzw: NDArray[np.float64]
    """(depth, N, 4)"""

    @property
    def target_frame(self) -> str:
        return "f0"

    @property
    def source_frame(self) -> str:
        return f"f{self.depth}"

    @property
    def middle_ns(self) -> int:
        """A time in the middle, between two samples."""
        count = len(self.stamps_ns)
        return int(self.stamps_ns[count // 2] + self.stamps_ns[count // 2 + 1]) // 2


def chain(depth: int, rate_hz: int) -> Chain:
    random = np.random.default_rng(depth)
    count = LENGTH_S * rate_hz
    seconds = np.arange(count) / rate_hz
    phases = random.uniform(0, 2 * np.pi, (depth, 1, 4))
    waves = np.sin(seconds[None, :, None] * random.uniform(0.2, 1.0, (depth, 1, 4)) + phases)
    turns = random.normal(size=(depth, 1, 4)) + 0.3 * waves
    turns /= np.linalg.norm(turns, axis=2, keepdims=True)
    stamps = START_NS + np.arange(count) * (1_000_000_000 // rate_hz)
    return Chain(depth, stamps, waves[:, :, :3].copy(), turns)
