"""A buffer mapped from a file equals the live one; an invalid or incomplete file raises."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from tests.tf2.replay import outcome, require_equal

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import ConnectivityException
from tfloom.tf2_ros.buffer import Buffer as RosBuffer

SECOND = 1_000_000_000
START = 100 * SECOND
FRAMES = [f"f{index}" for index in range(9)]


def random_buffer(random: np.random.Generator) -> Buffer:
    """Static and moving frames: one changes its parent, one is removed, one pruned, one cleared."""
    buffer = Buffer(int(random.integers(5, 12)) * SECOND)
    for index, child in enumerate(FRAMES[1:], 1):
        parent = FRAMES[int(random.integers(0, index))]
        if random.random() < 0.2:
            numbers = random.normal(size=3).tolist(), random.normal(size=4).tolist()
            buffer.set(parent, child, 0, *numbers, "fixed", static=True)
            continue
        count = int(random.integers(1, 900))
        stamps = START + np.sort(random.integers(0, 20 * SECOND, count))
        buffer.set_many(
            parent, child, stamps, random.normal(size=(count, 3)), random.normal(size=(count, 4)), "mö"
        )
    buffer.set("f0", "f8", START + 25 * SECOND, (1, 2, 3), (0, 0, 0, 1))
    buffer.set("f0", "gone", START, (1, 2, 3), (0, 0, 0, 1))
    buffer.remove_frame("gone")
    return buffer


def queries(random: np.random.Generator) -> Iterator[tuple[str, str, int]]:
    for target, source in product(FRAMES, [*FRAMES, "gone"]):
        for stamp in [0, *random.integers(START - SECOND, START + 27 * SECOND, 12).tolist()]:
            yield target, source, stamp


@pytest.mark.parametrize("seed", range(8))
def test_mapped_equals_live_before_and_after_more_inserts(tmp_path: Path, seed: int) -> None:
    random = np.random.default_rng(seed)
    live = random_buffer(random)
    path = tmp_path / "tree.tf"
    live.freeze(path)
    content = path.read_bytes()
    mapped = Buffer.map(path)
    require_equal(live, mapped, queries(random))
    for child in FRAMES[1:]:
        for stamp in random.integers(START, START + 30 * SECOND, 400).tolist():
            numbers = random.normal(size=3).tolist(), random.normal(size=4).tolist()
            call = "f0", child, stamp, *numbers, "x"
            assert live.set(*call) == mapped.set(*call)
    require_equal(live, mapped, queries(random))
    assert path.read_bytes() == content


def test_samples_stay_in_the_file(tmp_path: Path) -> None:
    live = Buffer(None)
    count = 100_000
    rotations = np.tile((0.0, 0.0, 0.0, 1.0), (count, 1))
    live.set_many("a", "b", np.arange(1, count + 1), np.zeros((count, 3)), rotations)
    live.freeze(tmp_path / "big")
    mapped = Buffer.map(tmp_path / "big")
    assert mapped.memory < live.memory / 100
    assert mapped.cache_time_ns is None


def test_mapped_file_can_be_replaced(tmp_path: Path) -> None:
    path = tmp_path / "tree"
    first, second = Buffer(), Buffer()
    first.set("a", "b", 1, (1, 0, 0), (0, 0, 0, 1))
    second.set("a", "b", 1, (2, 0, 0), (0, 0, 0, 1))
    first.freeze(path)
    mapped = Buffer.map(path)
    second.freeze(path)
    assert mapped.lookup("a", "b").translation == (1, 0, 0)
    assert Buffer.map(path).lookup("a", "b").translation == (2, 0, 0)
    assert list(tmp_path.iterdir()) == [path]


def test_a_ros_buffer_maps_and_an_empty_buffer_freezes(tmp_path: Path) -> None:
    Buffer().freeze(tmp_path / "empty")
    mapped = RosBuffer.map(tmp_path / "empty")
    assert isinstance(mapped, RosBuffer)
    assert mapped.frame_names() == []


def test_missing_folder_raises_and_leaves_no_file(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError) as raised:
        Buffer().freeze(tmp_path / "none" / "tree")
    assert raised.value.filename == str(tmp_path / "none" / "tree")
    with pytest.raises(OSError):
        Buffer().freeze(tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_parent_with_the_reserved_name_is_kept(tmp_path: Path) -> None:
    """A name from /tf may be the reserved one. As in tf2, such a frame then has data, and no parent."""
    live = Buffer()
    for child in ("moving", "a"):
        live.set("NO_PARENT", child, 1, (1, 2, 3), (0, 0, 0, 1), "me")
    live.set("NO_PARENT", "fixed", 0, (1, 2, 3), (0, 0, 0, 1), "me", static=True)
    live.set("a", "b", 1, (1, 2, 3), (0, 0, 0, 1), "me")
    live.set("map", "NO_PARENT", 1, (1, 2, 3), (0, 0, 0, 1), "me")
    live.freeze(tmp_path / "tree")
    mapped = Buffer.map(tmp_path / "tree")
    names = ["moving", "fixed", "a", "b", "map", "NO_PARENT"]
    require_equal(live, mapped, product(names, names, (0, 1, 2)))
    with pytest.raises(ConnectivityException):
        live.lookup("moving", "fixed", 1)


@pytest.fixture(scope="module")
def sound() -> bytes:
    buffer = Buffer()
    buffer.set("map", "odom", 0, (1, 2, 3), (0, 0, 0, 1), "me", static=True)
    for stamp in range(1, 301):
        buffer.set("odom", "base", stamp, (stamp, 0, 0), (0, 0, 0, 1), "me")
    return buffer.frozen()


def test_every_truncation_raises(sound: bytes, tmp_path: Path) -> None:
    buffer = Buffer()
    for size in [*range(400), *range(400, len(sound), 97), len(sound) - 1]:
        shorter = bytearray(sound[:size])
        with pytest.raises(ValueError, match="byte "):
            buffer.map_frozen(bytes(shorter))
        if size >= 48:
            shorter[16:24] = struct.pack("=Q", size)  # so that only the parts' own sizes are wrong
            with pytest.raises(ValueError, match="byte "):
                buffer.map_frozen(bytes(shorter))
    assert buffer.frame_names() == []
    for content in (b"", sound[:100], b"#!/bin/sh\n" * 20):
        (tmp_path / "bad").write_bytes(content)
        with pytest.raises(ValueError, match="bad: byte "):
            Buffer.map(tmp_path / "bad")


@pytest.mark.parametrize(
    ("offset", "value", "text"),
    [
        (0, b"X", "no frozen buffer"),
        (8, b"\x01\x02\x03\x04", "byte order"),
        (12, struct.pack("=I", 2), "version 2"),
        (16, struct.pack("=Q", 1), "was 1 bytes long"),
        (24, struct.pack("=q", -1), "cache time"),
        (32, struct.pack("=Q", 2**64 - 1), "more frames"),
        (32, struct.pack("=Q", 2**31), "the list of frames"),
        (40, struct.pack("=Q", 2**63), "the text"),
        (40, struct.pack("=Q", 9), "takes"),
        (48, struct.pack("=I", 9), "unknown kind|no name"),
        (48, struct.pack("=I", 3), "no name"),
    ],
)
def test_wrong_header_raises(sound: bytes, offset: int, value: bytes, text: str) -> None:
    changed = sound[:offset] + value + sound[offset + len(value) :]
    with pytest.raises(ValueError, match=text):
        Buffer().map_frozen(changed)


def test_random_bytes_never_crash(sound: bytes) -> None:
    random = np.random.default_rng(1)
    refused = 0
    for _ in range(3000):
        changed = bytearray(sound)
        for _ in range(int(random.integers(1, 4))):
            # Mostly in the structure: the header, the frames, the texts, the first stamps, the parents.
            place = int(random.choice([random.integers(0, 400), random.integers(0, len(sound))]))
            changed[place] = int(random.integers(0, 256))
        buffer = Buffer()
        try:
            buffer.map_frozen(bytes(changed))
        except ValueError:
            refused += 1
            continue
        buffer.all_frames_as_yaml()
        for stamp in (0, 1, 5, 256, 257, 300, 301):
            outcome(buffer, "map", "base", stamp)
            buffer.set("odom", "base", stamp, (0, 0, 0), (0, 0, 0, 1))
    assert refused > 500
