"""The shape of the observed frames: chains, roots, separate trees and loops."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

__all__ = ["Tree"]


class Tree:
    """Frames by their parents.

    Args:
        parents: The parent of each child.
    """

    def __init__(self, parents: Mapping[str, str]) -> None:
        self.parents = dict(parents)
        self.children: dict[str, list[str]] = {}
        for child in sorted(self.parents):
            self.children.setdefault(self.parents[child], []).append(child)

    def __contains__(self, frame: str) -> bool:
        return frame in self.parents or frame in self.children

    def frames(self) -> list[str]:
        """Return all frames, in order of their names."""
        return sorted(self.parents.keys() | self.children.keys())

    def branch(self, frame: str) -> list[str]:
        """Return the frame and its ancestors up to the root, or up to the last one before a loop closes."""
        branch = [frame]
        seen = {frame}
        while (parent := self.parents.get(branch[-1])) is not None and parent not in seen:
            branch.append(parent)
            seen.add(parent)
        return branch

    def root(self, frame: str) -> str:
        """Return the frame's root; in a loop, its first frame by name."""
        branch = self.branch(frame)
        if branch[-1] not in self.parents:
            return branch[-1]
        return min(self._loop_from(branch[-1]))

    def _loop_from(self, frame: str) -> list[str]:
        loop = [frame]
        while (parent := self.parents[loop[-1]]) != frame:
            loop.append(parent)
        return loop

    def roots(self) -> list[str]:
        """Return the roots of all trees, in order of their names; for a loop, its first frame by name."""
        return sorted({self.root(frame) for frame in self.frames()})

    def loops(self) -> list[list[str]]:
        """Return each loop, from its first frame by name upward."""
        found = {}
        for frame in self.frames():
            top = self.branch(frame)[-1]
            if top in self.parents:
                first = min(self._loop_from(top))
                found[first] = self._loop_from(first)
        return [found[first] for first in sorted(found)]

    def walk(self, root: str) -> Iterator[tuple[int, str]]:
        """Yield the frames of a tree from its root down, each with its depth; children in order of their names."""
        waiting, seen = [(0, root)], {root}
        while waiting:
            depth, frame = waiting.pop()
            yield depth, frame
            for child in reversed(self.children.get(frame, [])):
                if child not in seen:
                    seen.add(child)
                    waiting.append((depth + 1, child))

    def chain(self, target: str, source: str) -> tuple[list[str], list[str]] | None:
        """Return the way from source to target: the source and its ancestors, and the target and its ancestors.

        Both end with the frame where they meet. None: they don't meet.
        """
        up, down = self.branch(source), self.branch(target)
        met = set(down)
        for place, frame in enumerate(up):
            if frame in met:
                return up[: place + 1], down[: down.index(frame) + 1]
        return None
