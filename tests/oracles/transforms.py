"""A reference buffer, slow and simple: lists, linear search, 4 by 4 matrices, trigonometry."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]


class NoAnswerError(Exception):
    """There is no transform; `kind` is the reason: unknown, unconnected or extrapolation."""

    def __init__(self, kind: str) -> None:
        super().__init__(kind)
        self.kind = kind


@dataclass
class Sample:
    stamp: int
    parent: str
    translation: Matrix
    rotation: Matrix  # x, y, z, w


@dataclass
class OracleBuffer:
    cache_time_ns: int = 10_000_000_000
    moving: dict[str, list[Sample]] = field(default_factory=dict)
    static: dict[str, Sample] = field(default_factory=dict)
    names: set[str] = field(default_factory=set)

    def set(
        self,
        frame_id: str,
        child_frame_id: str,
        stamp: int,
        translation: tuple[float, ...],
        rotation: tuple[float, ...],
        *,
        static: bool = False,
    ) -> bool:
        q = np.asarray(rotation, float)
        sample = Sample(stamp, frame_id, np.asarray(translation, float), q / np.linalg.norm(q))
        self.names |= {frame_id, child_frame_id}
        if static:
            self.moving.pop(child_frame_id, None)
            self.static[child_frame_id] = sample
            return True
        self.static.pop(child_frame_id, None)
        history = self.moving.setdefault(child_frame_id, [])
        newest = max((s.stamp for s in history), default=0)
        history[:] = [s for s in history if s.stamp + self.cache_time_ns >= newest]
        if history and stamp < newest - self.cache_time_ns:
            return False
        if not any(_same(s, sample) for s in history):
            # After all that are not later, so that the last inserted is the newer among equals.
            place = sum(s.stamp <= stamp for s in history)
            history.insert(place, sample)
        return True

    def at(self, frame: str, stamp: int) -> tuple[str, Matrix] | None:
        """Return the parent and the matrix parent_from_frame; None for a root."""
        if frame in self.static:
            sample = self.static[frame]
            return sample.parent, matrix(sample.translation, sample.rotation)
        if frame not in self.moving:
            return None
        history = self.moving[frame]
        stamps = [s.stamp for s in history]
        if stamp in (0, stamps[-1]):
            sample = history[-1]
        elif stamp == stamps[0]:
            sample = history[0]
        elif len(history) == 1 or not stamps[0] < stamp < stamps[-1]:
            raise NoAnswerError("extrapolation")
        else:
            newer = next(i for i, s in enumerate(stamps) if s > stamp)
            a, b = history[newer - 1], history[newer]
            if a.parent == b.parent:
                r = (stamp - a.stamp) / (b.stamp - a.stamp)
                translation = a.translation + r * (b.translation - a.translation)
                return a.parent, matrix(translation, slerp(a.rotation, b.rotation, r))
            sample = a
        return sample.parent, matrix(sample.translation, sample.rotation)

    def newest_path(self, frame: str) -> list[tuple[str, int, str]]:
        """Return (frame, its newest stamp or 0, its newest parent) from `frame` up."""
        path = []
        while frame in self.static or frame in self.moving:
            newest = self.moving[frame][-1] if frame in self.moving else self.static[frame]
            path.append((frame, newest.stamp if frame in self.moving else 0, newest.parent))
            frame = newest.parent
        return path

    def latest_common_time(self, target: str, source: str) -> int:
        a, b = self.newest_path(target), self.newest_path(source)
        above_a = [target, *(parent for _, _, parent in a)]
        above_b = [source, *(parent for _, _, parent in b)]
        top = next((frame for frame in above_b if frame in above_a), None)
        if top is None:
            raise NoAnswerError("unconnected")
        stamps = [s for _, s, _ in a[: above_a.index(top)] + b[: above_b.index(top)] if s != 0]
        return min(stamps, default=0)

    def lookup(self, target: str, source: str, stamp: int) -> tuple[int, Matrix]:
        """Return the time used and the matrix target_from_source."""
        if target not in self.names or source not in self.names:
            raise NoAnswerError("unknown")
        if stamp == 0:
            stamp = self.latest_common_time(target, source)
        source_side = self.climb(source, stamp, target)
        target_side = self.climb(target, stamp, source)
        for top, top_from_source in source_side.items():
            if top in target_side:
                return stamp, np.linalg.inv(target_side[top]) @ top_from_source
        raise NoAnswerError("unconnected")

    def climb(self, frame: str, stamp: int, stop: str) -> dict[str, Matrix]:
        """Return, for each frame from `frame` up to the root or to `stop`, the matrix that_frame_from_frame."""
        passed = {frame: np.eye(4)}
        while frame != stop:
            try:
                link = self.at(frame, stamp)
            except NoAnswerError:
                break
            if link is None:
                break
            parent, parent_from_frame = link
            passed[parent] = parent_from_frame @ passed[frame]
            frame = parent
        return passed


def _same(a: Sample, b: Sample) -> bool:
    return (
        a.stamp == b.stamp
        and a.parent == b.parent
        and bool(np.all(a.translation == b.translation))
        and bool(np.all(a.rotation == b.rotation))
    )


def slerp(a: Matrix, b: Matrix, r: float) -> Matrix:
    """Rotate from a towards b on the shorter arc, by r times the angle between them."""
    if a @ b < 0:
        b = -b
    angle = 2 * math.atan2(float(np.linalg.norm(a - b)), float(np.linalg.norm(a + b)))
    if angle < 1e-12:
        return a
    result = (math.sin((1 - r) * angle) * a + math.sin(r * angle) * b) / math.sin(angle)
    return result / np.linalg.norm(result)


def matrix(translation: Matrix, q: Matrix) -> Matrix:
    x, y, z, w = q
    m = np.eye(4)
    m[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    m[:3, 3] = translation
    return m
