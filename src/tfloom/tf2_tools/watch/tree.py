"""The shape of the observed frames: chains, roots, separate trees and loops."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

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
        return self._roots.get(frame, frame)

    @cached_property
    def _roots(self) -> dict[str, str]:
        """The root of each frame; each edge is followed once, because a branch may be thousands of frames long."""
        roots: dict[str, str] = {}
        for frame in self.frames():
            branch: dict[str, None] = {}
            top = frame
            while top not in roots and top not in branch and top in self.parents:
                branch[top] = None
                top = self.parents[top]
            if top not in roots:
                roots[top] = min(self._loop_from(top)) if top in branch else top
            roots.update(dict.fromkeys(branch, roots[top]))
        return roots

    def _loop_from(self, frame: str) -> list[str]:
        loop = [frame]
        while (parent := self.parents[loop[-1]]) != frame:
            loop.append(parent)
        return loop

    def roots(self) -> list[str]:
        """Return the roots of all trees, in order of their names; for a loop, its first frame by name."""
        return sorted(set(self._roots.values()))

    def loops(self) -> list[list[str]]:
        """Return each loop, from its first frame by name upward."""
        return [self._loop_from(root) for root in self.roots() if root in self.parents]

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
