"""Trees of several shapes and samplings: each pair of frames in both directions, as in tf2's tests."""

from __future__ import annotations

import pytest

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import ConnectivityException

SECOND = 1_000_000_000
UPRIGHT = (0.0, 0.0, 0.0, 1.0)
TREES = {  # by name; each child's parent, and its position in it
    "i": {"b": ("a", 1, 0), "c": ("b", 1, 0)},
    "y": {"b": ("a", 1, 0), "c": ("b", 1, 0), "d": ("b", 0, 1), "e": ("d", 0, 1)},
    "v": {"b": ("a", 1, 0), "c": ("b", 1, 0), "f": ("a", 0, 1), "g": ("f", 0, 1)},
    "1": {"2": ("1", 1, 0)},
    "1_v": {"b": ("a", 1, 0), "c": ("b", 1, 0), "f": ("a", 0, 1), "g": ("f", 0, 1), "2": ("1", 1, 0)},
}
CASES = [(shape, width) for shape in TREES for width in (0, SECOND // 1000, SECOND // 10, SECOND)]


def build(shape: str, stamp: int, width: int) -> Buffer:
    buffer = Buffer()
    for child, (parent, x, y) in TREES[shape].items():
        stamps = [stamp - width // 2 if stamp > width // 2 else 0, *([stamp] if width else [])]
        for when in stamps:
            assert buffer.set(parent, child, when, (x, y, 0), UPRIGHT)
    return buffer


def place(shape: str, frame: str) -> tuple[str, int, int]:
    """Return the root above a frame, and the frame's position in it."""
    x = y = 0
    while frame in TREES[shape]:
        frame, dx, dy = TREES[shape][frame]
        x, y = x + dx, y + dy
    return frame, x, y


@pytest.mark.parametrize("stamp", [SECOND, 10 * SECOND, 0])
@pytest.mark.parametrize(("shape", "width"), CASES)
def test_every_pair_of_frames(shape: str, width: int, stamp: int) -> None:
    buffer = build(shape, stamp, width)
    frames = sorted({name for child, (parent, *_) in TREES[shape].items() for name in (child, parent)})
    for target in frames:
        for source in frames:
            root, x, y = place(shape, target)
            other_root, to_x, to_y = place(shape, source)
            if root != other_root:
                assert not buffer.can(target, source, stamp)
                with pytest.raises(ConnectivityException):
                    buffer.lookup(target, source, stamp)
                continue
            assert buffer.can(target, source, stamp)
            transform = buffer.lookup(target, source, stamp)
            names = transform.frame_id, transform.child_frame_id
            assert (*names, transform.stamp_ns) == (target, source, stamp)
            assert transform.translation == (to_x - x, to_y - y, 0)
            assert transform.rotation_xyzw == UPRIGHT


def test_known_distances() -> None:
    tree = build("y", SECOND, SECOND)
    assert tree.lookup("a", "c", SECOND).translation == (2, 0, 0)
    assert tree.lookup("a", "e", SECOND).translation == (1, 2, 0)
    assert tree.lookup("c", "e", SECOND).translation == (-1, 2, 0)
    assert build("v", SECOND, SECOND).lookup("c", "g", SECOND).translation == (-2, 2, 0)
