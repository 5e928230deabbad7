"""MCAP files whose chunks, indexes and times aren't what they say, and large ones that are legal."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Sequence
from pathlib import Path

import lz4.frame
import pytest
import zstandard
from tests.bag.recordings import watched

from tfloom.bag.reading import mcap_implausible
from tfloom.bag.reading.compression import MIN_RATIO, MIN_SIZE
from tfloom.bag.reading.mcap_records import MAGIC, RECORD_HEADER, Opcode

MEGABYTE = 1 << 20
LARGE = 12 * MEGABYTE


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
    at: int,
    length: int,
    compression: str,
    stored: int,
    size: int,
    times: tuple[int, int] = (5, 5),
    message_index: tuple[int, int] = (0, 0),
) -> bytes:
    """Return the index of a chunk, whose message index of channel 1 has an offset and a length; 0: it has none."""
    offset, index_length = message_index
    offsets = struct.pack("<HQ", 1, offset) if offset else b""
    return record(
        Opcode.CHUNK_INDEX,
        struct.pack("<QQQQI", *times, at, length, len(offsets))
        + offsets
        + struct.pack("<Q", index_length)
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


@pytest.mark.parametrize("has_summary", [True, False])
@pytest.mark.parametrize("compression", ["zstd", "lz4"])
@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda: bytes(LARGE), "have a record of kind 0 at byte 0, after 0 messages"),
        (lambda: CHANNEL + message(5, b"a") + bytes(LARGE), "of kind 0 at byte 62, after 1 mess"),
        (lambda: CHANNEL * (3 * MEGABYTE // 8), "hold more than 50000 schemas and channels"),
        (lambda: record(Opcode.SCHEMA, bytes(LARGE)), "hold no message"),
        (
            lambda: CHANNEL + message(5, b"") * (3 * MEGABYTE // 8),
            "hold more than 50000 messages of one time",
        ),
        (lambda: CHANNEL + message(5, bytes(LARGE))[:-9], "their last record isn't whole"),
    ],
    ids=["zeros", "zeros after a message", "channels", "no message", "tiny messages", "cut off"],
)
def test_chunk_of_a_large_size_without_messages_for_it_is_left_out(
    make: Callable[[], bytes],
    reason: str,
    compression: str,
    has_summary: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(mcap_implausible, "MAX_OTHERS", 50_000)
    monkeypatch.setattr(mcap_implausible, "MAX_MESSAGES", 50_000)
    # Made here: as values of the parameters, each worker would hold all of them from its start to its end.
    content = make()
    data, of_chunk = chunk(content, compression)
    path = write(tmp_path / "a.mcap", data, [of_chunk] if has_summary else [])
    found, said, most = watched(path)
    assert found == []
    assert len(said) == 1
    assert said[0].startswith(f"{path}: byte ")
    assert re.search(f"bytes stand for {len(content)}, and .*{reason}", said[0])
    assert most < LARGE * 3 // 4


@pytest.mark.parametrize("compression", ["zstd", "lz4"])
def test_large_message_that_compresses_well_is_read(compression: str, tmp_path: Path) -> None:
    """As of an empty map."""
    data, of_chunk = chunk(CHANNEL + message(5, bytes(LARGE)), compression)
    assert max(MIN_SIZE, len(data) * MIN_RATIO) < LARGE
    for indexes in ([of_chunk], []):
        found, said, _ = watched(write(tmp_path / "a.mcap", data, indexes))
        assert ([len(payload) for payload in found], said) == ([LARGE], [])


@pytest.mark.parametrize("size", [None, 0, MEGABYTE])
def test_chunk_that_is_indexed_again_and_again_is_read_once(size: int | None, tmp_path: Path) -> None:
    data, of_chunk = chunk(CHANNEL + message(5, b"a"))
    if size is not None:
        of_chunk = index(len(HEAD), len(data), "zstd", 0, size)
    found, said, most = watched(write(tmp_path / "a.mcap", data, [of_chunk] * 5_000))
    assert found == [b"a"]
    assert len(said) == 1
    assert "more than fit before it" in said[0]
    assert most < 10 * MEGABYTE


def test_two_indexes_of_one_place_overlap(tmp_path: Path) -> None:
    data, _ = chunk(CHANNEL + message(5, b"a"))
    empty = index(len(HEAD), len(data), "zstd", 0, MEGABYTE)
    found, said, _ = watched(write(tmp_path / "a.mcap", data, [empty, empty]))
    assert found == [b"a"]
    assert len(said) == 1
    assert " overlap" in said[0]


def test_many_empty_chunks_are_legal_and_take_no_memory(tmp_path: Path) -> None:
    data, of_chunk = chunk(CHANNEL + message(5, b"a"))
    empty, of_empty = chunk(b"")
    count = 4_000
    path = write(tmp_path / "a.mcap", data + empty * count, [of_chunk, *[of_empty] * count])
    found, said, most = watched(path)
    assert (found, said) == ([b"a"], [])
    assert most < 4 * (len(of_empty) * count)
    found, said, most = watched(write(path, data + empty * count, []))
    assert (found, said) == ([b"a"], [])
    assert most < MEGABYTE


def test_messages_outside_their_chunks_times_are_counted(tmp_path: Path) -> None:
    stamps = [1, 5, 6, 9, (1 << 63) + 1]
    content = CHANNEL + b"".join(message(stamp, str(stamp).encode()) for stamp in stamps)
    data, of_chunk = chunk(content, times=(5, 6))
    found, said, _ = watched(write(tmp_path / "a.mcap", data, [of_chunk], (5, 6)))
    assert found == [b"1", b"5", b"6", b"9"]
    assert len(said) == 1
    assert "a chunk of messages is damaged: 3 of its messages have log times outside those that it" in said[0]


def message_index(stamps: Sequence[int]) -> bytes:
    entries = b"".join(struct.pack("<QQ", stamp, 0) for stamp in stamps)
    return record(Opcode.MESSAGE_INDEX, struct.pack("<HI", 1, len(entries)) + entries)


@pytest.mark.parametrize("compression", ["", "zstd", "lz4"])
@pytest.mark.parametrize("has_index", [True, False])
def test_chunk_of_other_times_than_declared_is_not_left_out(
    has_index: bool, compression: str, tmp_path: Path
) -> None:
    stamps = [1, 5, 6, 900]
    content = CHANNEL + b"".join(message(stamp, str(stamp).encode()) for stamp in stamps)
    data, of_chunk = chunk(content, compression, times=(5, 6))
    if has_index:
        of_messages = message_index(stamps)
        place = len(HEAD) + len(data), len(of_messages)
        stored = _stored_size(data, compression)
        of_chunk = index(len(HEAD), len(data), compression, stored, len(content), (5, 6), place)
        data += of_messages
    path = write(tmp_path / "a.mcap", data, [of_chunk], (5, 6))
    assert watched(path, 800, 1000)[:2] == ([b"900"], [])
    assert watched(path, 0, 4)[:2] == ([b"1"], [])
    assert watched(path, 0, 5)[:2] == ([b"1", b"5"], [])


def test_message_index_that_chunks_share_is_not_used(tmp_path: Path) -> None:
    """Else ten bytes of a chunk's index would let the whole of it be read once more."""
    count = 200
    data, _ = chunk(CHANNEL + message(5, b"a") + message(5, bytes(1 << 16)))
    of_messages = message_index([5] * 10_000)
    place = len(HEAD) + count * len(data), len(of_messages)
    size = _stored_size(data)
    indexes = [
        index(len(HEAD) + number * len(data), len(data), "", size, size, (5, 5), place)
        for number in range(count)
    ]
    path = write(tmp_path / "a.mcap", data * count + of_messages, indexes)
    found, said, _ = watched(path)
    assert len(found) == 2 * count
    assert len(said) == 1
    assert f"the message indexes of the chunk at byte {len(HEAD) + 49} aren't behind it" in said[0]


def _stored_size(data: bytes, compression: str = "") -> int:
    return len(data) - RECORD_HEADER.size - 40 - len(compression)


@pytest.mark.slow
@pytest.mark.parametrize("compression", ["zstd", "lz4"])
def test_chunk_of_500_megabytes_is_read(compression: str, tmp_path: Path) -> None:
    data, of_chunk = chunk(CHANNEL + message(5, bytes(250 * MEGABYTE)) * 2, compression)
    found, said, _ = watched(write(tmp_path / "a.mcap", data, [of_chunk]))
    assert ([len(payload) for payload in found], said) == ([250 * MEGABYTE] * 2, [])
