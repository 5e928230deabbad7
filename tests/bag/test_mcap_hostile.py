"""MCAP files whose chunks, indexes and times aren't what they say, and large ones that are legal."""

from __future__ import annotations

import struct
import tracemalloc
import warnings
from collections.abc import Sequence
from pathlib import Path

import lz4.frame
import pytest
import zstandard

from tfloom.bag import BagWarning, open_bag
from tfloom.bag.reading import mcap_implausible
from tfloom.bag.reading.mcap_records import MAGIC, RECORD_HEADER, Opcode

MEGABYTE = 1 << 20


def record(opcode: int, content: bytes) -> bytes:
    return RECORD_HEADER.pack(opcode, len(content)) + content


def text(value: str) -> bytes:
    return struct.pack("<I", len(value)) + value.encode()


HEAD = MAGIC + record(Opcode.HEADER, text("") + text("test"))
CHANNEL = record(Opcode.CHANNEL, struct.pack("<HH", 1, 0) + text("/a") + text("cdr") + bytes(4))


def message(stamp_ns: int, data: bytes) -> bytes:
    return record(Opcode.MESSAGE, struct.pack("<HIQQ", 1, 0, stamp_ns, stamp_ns) + data)


def chunk(content: bytes, compression: str = "", times: tuple[int, int] = (5, 5)) -> tuple[bytes, bytes]:
    """Return a chunk at the beginning of a file, and its index."""
    stored = content
    if compression:
        library = zstandard if compression == "zstd" else lz4.frame
        stored = library.compress(content)
    about = struct.pack("<QQQI", *times, len(content), 0) + text(compression)
    found = record(Opcode.CHUNK, about + struct.pack("<Q", len(stored)) + stored)
    return found, index(len(HEAD), len(found), compression, len(stored), len(content), times)


def index(
    at: int, length: int, compression: str, stored: int, size: int, times: tuple[int, int] = (5, 5)
) -> bytes:
    return record(
        Opcode.CHUNK_INDEX,
        struct.pack("<QQQQIQ", *times, at, length, 0, 0)
        + text(compression)
        + struct.pack("<QQ", stored, size),
    )


def write(path: Path, data: bytes, indexes: Sequence[bytes], times: tuple[int, int] = (5, 5)) -> Path:
    """Write a file; without indexes one without a summary."""
    about = struct.pack("<QHIIIIQQI", 1, 0, 1, 0, 0, len(indexes), *times, 10) + struct.pack("<HQ", 1, 1)
    summary = CHANNEL + b"".join(indexes) + record(Opcode.STATISTICS, about) if indexes else b""
    data = HEAD + data + record(Opcode.DATA_END, bytes(4))
    footer = record(Opcode.FOOTER, struct.pack("<QQI", len(data) if summary else 0, 0, 0))
    path.write_bytes(data + summary + footer + MAGIC)
    return path


def read(path: Path) -> tuple[list[bytes], list[str], int]:
    """Return the messages of a file, the warnings, and the memory that reading took [bytes]."""
    tracemalloc.start()
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            found = [each.data for each in open_bag(path).messages()]
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert all(issubclass(each.category, BagWarning) for each in caught)
    return found, [str(each.message) for each in caught], most


@pytest.mark.parametrize("has_summary", [True, False])
@pytest.mark.parametrize("compression", ["zstd", "lz4"])
@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (bytes(100 * MEGABYTE), "have a record of kind 0 at byte 0, after 0 messages"),
        (
            CHANNEL + message(5, b"a") + bytes(100 * MEGABYTE),
            "have a record of kind 0 at byte 62, after 1 mes",
        ),
        (CHANNEL * (3 * MEGABYTE), "hold more than 131072 schemas and channels"),
        (record(Opcode.SCHEMA, bytes(100 * MEGABYTE)), "hold no message"),
        (CHANNEL + message(5, b"") * (3 * MEGABYTE), "hold more than 1048576 messages of one time"),
        (CHANNEL + message(5, bytes(100 * MEGABYTE))[:-9], "their last record isn't whole"),
    ],
    ids=["zeros", "zeros after a message", "channels", "no message", "tiny messages", "cut off"],
)
def test_chunk_of_a_large_size_without_messages_for_it_is_left_out(
    content: bytes, reason: str, compression: str, has_summary: bool, tmp_path: Path
) -> None:
    data, of_chunk = chunk(content, compression)
    path = write(tmp_path / "a.mcap", data, [of_chunk] if has_summary else [])
    found, said, most = read(path)
    assert found == []
    assert len(said) == 1
    assert said[0].startswith(f"{path}: byte ")
    assert f"bytes stand for {len(content)}, and {reason}" in said[0]
    assert most < 50 * MEGABYTE


@pytest.mark.parametrize("compression", ["zstd", "lz4"])
def test_large_message_that_compresses_well_is_read(compression: str, tmp_path: Path) -> None:
    """As of an empty map."""
    data, of_chunk = chunk(CHANNEL + message(5, bytes(100 * MEGABYTE)), compression)
    assert mcap_implausible.MIN_SIZE < 100 * MEGABYTE
    assert len(data) * mcap_implausible.MIN_RATIO < 100 * MEGABYTE
    for indexes in ([of_chunk], []):
        found, said, _ = read(write(tmp_path / "a.mcap", data, indexes))
        assert ([len(each) for each in found], said) == ([100 * MEGABYTE], [])


@pytest.mark.parametrize(
    ("stored", "size", "reason"),
    [
        (None, None, "more than fit before it"),
        (0, 0, "more than fit before it"),
        (0, MEGABYTE, "more than fit before it"),
    ],
)
def test_chunk_that_is_indexed_again_and_again_is_read_once(
    stored: int | None, size: int | None, reason: str, tmp_path: Path
) -> None:
    data, of_chunk = chunk(CHANNEL + message(5, b"a"))
    if stored is not None and size is not None:
        of_chunk = index(len(HEAD), len(data), "zstd", stored, size)
    found, said, most = read(write(tmp_path / "a.mcap", data, [of_chunk] * 20_000))
    assert found == [b"a"]
    assert len(said) == 1
    assert reason in said[0]
    assert most < 10 * MEGABYTE


def test_two_indexes_of_one_place_overlap(tmp_path: Path) -> None:
    data, _ = chunk(CHANNEL + message(5, b"a"))
    empty = index(len(HEAD), len(data), "zstd", 0, MEGABYTE)
    found, said, _ = read(write(tmp_path / "a.mcap", data, [empty, empty]))
    assert found == [b"a"]
    assert len(said) == 1
    assert " overlap" in said[0]


def test_many_empty_chunks_are_legal_and_take_no_memory(tmp_path: Path) -> None:
    data, of_chunk = chunk(CHANNEL + message(5, b"a"))
    empty, of_empty = chunk(b"")
    count = 10_000
    path = write(tmp_path / "a.mcap", data + empty * count, [of_chunk, *[of_empty] * count])
    found, said, most = read(path)
    assert (found, said) == ([b"a"], [])
    assert most < 4 * (len(of_empty) * count)
    found, said, most = read(write(path, data + empty * count, []))
    assert (found, said) == ([b"a"], [])
    assert most < MEGABYTE


def test_messages_outside_their_chunks_times_are_counted(tmp_path: Path) -> None:
    stamps = [1, 5, 6, 9, (1 << 63) + 1]
    content = CHANNEL + b"".join(message(each, str(each).encode()) for each in stamps)
    data, of_chunk = chunk(content, times=(5, 6))
    found, said, _ = read(write(tmp_path / "a.mcap", data, [of_chunk], (5, 6)))
    assert found == [b"1", b"5", b"6", b"9"]
    assert len(said) == 1
    assert "a chunk of messages is damaged: 3 of its messages have log times outside those that it" in said[0]
