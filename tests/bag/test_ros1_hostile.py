"""Bags of ROS 1 whose chunks, indexes and times aren't what they say, and large ones that are legal."""

from __future__ import annotations

import bz2
import re
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import lz4.frame
import pytest
from tests.bag.recordings import watched

from tfloom.bag import BagError
from tfloom.bag.reading import ros1_implausible
from tfloom.bag.reading.compression import MIN_RATIO, MIN_SIZE
from tfloom.bag.reading.ros1_records import BAG_HEADER, CHUNK, CHUNK_INFO, CONNECTION, INDEX, MAGIC, MESSAGE

MEGABYTE = 1 << 20
COMPRESS = {"none": bytes, "bz2": bz2.compress, "lz4": lz4.frame.compress}


def number(value: int) -> bytes:
    return struct.pack("<I", value)


def time(stamp: int) -> bytes:
    return struct.pack("<II", stamp, 0)


def record(kind: int, fields: dict[str, bytes], data: bytes, declared: int | None = None) -> bytes:
    named = {"op": bytes([kind]), **fields}
    header = b"".join(
        number(len(name) + 1 + len(value)) + name.encode() + b"=" + value for name, value in named.items()
    )
    return number(len(header)) + header + number(len(data) if declared is None else declared) + data


def message(stamp: int, data: bytes, connection: int = 0) -> bytes:
    return record(MESSAGE, {"conn": number(connection), "time": time(stamp)}, data)


def connection(number_: int = 0) -> bytes:
    about = b"".join(
        number(len(field)) + field for field in (b"type=std_msgs/String", b"message_definition=string data")
    )
    return record(CONNECTION, {"conn": number(number_), "topic": f"/c{number_}".encode()}, about)


class Chunk(NamedTuple):
    """A chunk, and what its index says."""

    content: bytes
    stamps: Sequence[int]
    """Of its index."""
    compression: str = "none"
    declared: tuple[int, int] = (5, 5)
    """The times that the information of the chunk says [s]."""
    connection: int = 0

    def stored(self) -> bytes:
        fields = {"compression": self.compression.encode(), "size": number(len(self.content))}
        return record(CHUNK, fields, COMPRESS[self.compression](self.content))

    def entries(self) -> bytes:
        fields = {"ver": number(1), "conn": number(self.connection), "count": number(len(self.stamps))}
        return record(INDEX, fields, b"".join(time(stamp) + bytes(4) for stamp in self.stamps))

    def info(self, place: int) -> bytes:
        start, end = self.declared
        fields = {"ver": number(1), "chunk_pos": struct.pack("<Q", place), "count": number(1)}
        fields |= {"start_time": time(start), "end_time": time(end)}
        return record(CHUNK_INFO, fields, number(self.connection) + number(len(self.stamps)))


def header(place: int, chunks: int) -> bytes:
    fields = {"index_pos": struct.pack("<Q", place), "conn_count": number(1), "chunk_count": number(chunks)}
    return MAGIC + record(BAG_HEADER, fields, b"")


def write(
    path: Path, chunks: Sequence[Chunk], *, is_indexed: bool = True, index: bytes | None = None
) -> Path:
    """Write a bag, with an index at its end or with other bytes in its place."""
    body = b""
    end = connection()
    for chunk in chunks:
        end += chunk.info(len(header(0, 0)) + len(body))
        body += chunk.stored() + (chunk.entries() if is_indexed else b"")
    place = len(header(0, 0)) + len(body) if is_indexed else 0
    path.write_bytes(
        header(place, len(chunks)) + body + ((end if index is None else index) if is_indexed else b"")
    )
    return path


def read(path: Path, *times: int) -> tuple[list[bytes], list[str], int]:
    """Return what `watched` does, for times in seconds."""
    return watched(path, *(stamp * 1_000_000_000 for stamp in times))


LARGE = bytes(4 * MEGABYTE)
HOSTILE = {
    "zeros": (LARGE, "damaged at byte 0: the field 'op' of a record has 0 bytes"),
    "zeros after a message": (
        connection() + message(5, b"a") + LARGE,
        "the field 'op' of a record has 0 bytes",
    ),
    "connections": (connection() * 10_000, "hold more than 100 connections"),
    "no message": (
        record(CONNECTION, {"conn": bytes(4), "topic": b"/c"}, LARGE),
        "hold no message",
    ),
    "tiny messages": (connection() + message(5, b"") * 20_000, "hold more than 1000 messages of one time"),
    "cut off": (connection() + message(5, LARGE)[:-9], "their last record isn't whole"),
}


@pytest.mark.parametrize("is_indexed", [True, False], ids=["indexed", "without an index"])
@pytest.mark.parametrize("compression", ["bz2", "lz4"])
@pytest.mark.parametrize("name", HOSTILE)
def test_chunk_of_a_large_size_without_messages_for_it_is_left_out(
    name: str, compression: str, is_indexed: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ros1_implausible, "MAX_CONNECTIONS", 100)
    monkeypatch.setattr(ros1_implausible, "MAX_MESSAGES", 1000)
    content, reason = HOSTILE[name]
    read(write(tmp_path / "small.bag", [Chunk(message(5, b""), [5], compression)]))  # imports take memory
    path = write(tmp_path / "a.bag", [Chunk(content, [5], compression)], is_indexed=is_indexed)
    found, said, most = read(path)
    assert found == []
    text = f"a chunk of messages is damaged: \\d+ bytes stand for {len(content)}, and .*{reason}"
    assert len([warning for warning in said if re.search(text, warning)]) == 1
    assert most < 4 * MEGABYTE


@pytest.mark.parametrize("compression", ["bz2", "lz4"])
def test_large_message_that_compresses_well_is_read(compression: str, tmp_path: Path) -> None:
    chunk = Chunk(connection() + message(5, bytes(8 * MEGABYTE)), [5], compression)
    stored = len(chunk.stored())
    assert len(chunk.content) > max(MIN_SIZE, MIN_RATIO * stored)
    for is_indexed in (True, False):
        found, said, _ = read(write(tmp_path / "a.bag", [chunk], is_indexed=is_indexed))
        assert ([len(payload) for payload in found], len(said)) == ([8 * MEGABYTE], not is_indexed)


@pytest.mark.slow
def test_chunk_of_500_megabytes_is_read(tmp_path: Path) -> None:
    chunk = Chunk(connection() + message(5, bytes(28 * MEGABYTE)) * 2, [5, 5], "lz4")
    found, said, _ = read(write(tmp_path / "a.bag", [chunk]))
    assert ([len(payload) for payload in found], said) == ([28 * MEGABYTE] * 2, [])


def test_chunk_with_other_times_than_declared_is_read(tmp_path: Path) -> None:
    content = connection() + message(5, b"a") + message(9, b"b") + message(2, b"c")
    path = write(tmp_path / "a.bag", [Chunk(content, [5, 9, 2])])
    assert read(path)[:2] == ([b"c", b"a", b"b"], [])
    assert read(path, 8, 10)[:2] == ([b"b"], [])
    assert read(path, 1, 3)[:2] == ([b"c"], [])


@pytest.mark.parametrize("stamps", [[5], [5, 9, 2, 5]], ids=["too few", "too many"])
def test_messages_beside_the_index_are_read(stamps: list[int], tmp_path: Path) -> None:
    content = connection() + message(5, b"a") + message(9, b"b")
    path = write(tmp_path / "a.bag", [Chunk(content, stamps)])
    found, said, _ = read(path)
    assert found == [b"a", b"b"]
    assert f"its index has {len(stamps)} messages, and 2 are there; these are read" in said[0]
    assert all("outside those of its index" in warning for warning in said[1:])


def test_chunk_with_fewer_messages_than_indexed_is_told_of(tmp_path: Path) -> None:
    content = connection() + message(5, b"a") + message(6, b"b")[:-1]
    found, said, _ = read(write(tmp_path / "a.bag", [Chunk(content, [5, 6])]))
    assert found == [b"a"]
    assert len(said) == 1
    assert "its index has 2 messages, and 1 are there; these are read" in said[0]


def test_messages_outside_the_times_of_their_index_are_counted(tmp_path: Path) -> None:
    content = connection() + message(5, b"a") + message(9, b"b") + message(1, b"c")
    found, said, _ = read(write(tmp_path / "a.bag", [Chunk(content, [5, 5, 5])]))
    assert found == [b"c", b"a", b"b"]
    assert len(said) == 1
    assert "2 of its messages have log times outside those of its index" in said[0]


def test_index_of_other_messages_is_not_believed(tmp_path: Path) -> None:
    """The information of the chunk has another count than its index."""
    chunk = Chunk(connection() + message(5, b"a") + message(9, b"b"), [5, 9])
    place = len(header(0, 0))
    info = chunk._replace(stamps=[5]).info(place)
    path = write(tmp_path / "a.bag", [chunk], index=connection() + info)
    assert read(path, 8, 10)[:2] == ([b"b"], [])


def test_damaged_chunk_of_an_index_leaves_the_others(tmp_path: Path) -> None:
    chunks = [Chunk(connection() + message(stamp, b"a"), [stamp]) for stamp in (3, 4, 5)]
    path = write(tmp_path / "a.bag", chunks)
    data = path.read_bytes()
    place = data.index(b"compression=none", data.index(b"compression=none") + 1)
    path.write_bytes(data[: place - 8] + b"\xff" * 24 + data[place + 16 :])
    found, said, _ = read(path)
    assert len(found) == 2
    assert len(said) == 1
    assert "its 1 messages are left out" in said[0]


def test_messages_of_connections_without_a_record_are_counted(tmp_path: Path) -> None:
    content = connection() + message(5, b"a") + message(5, b"b", 7)
    for is_indexed in (True, False):
        found, said, _ = read(write(tmp_path / "a.bag", [Chunk(content, [5])], is_indexed=is_indexed))
        assert found == [b"a"]
        assert "1 messages are left out, because no record describes their connections" in said[-1]


@pytest.mark.parametrize(
    ("index", "reason"),
    [
        (number(0xFFFFFFF0) + bytes(200), "a record's header has 4294967280 bytes"),
        (connection() + record(MESSAGE, {}, b""), "it has a record of kind 2"),
        (connection(), "it has 0 chunks, and the bag's header 1"),
        (connection() + Chunk(b"", [5]).info(9) * 2_000, "it has 2000 chunks, and the bag's header 1"),
        (record(CONNECTION, {}, b"", 0xFFFFFFFF), r"the record at byte \d+ isn't whole"),
    ],
    ids=["length", "kind", "none", "many", "large"],
)
def test_bag_with_a_damaged_index_is_read_by_its_records(index: bytes, reason: str, tmp_path: Path) -> None:
    path = write(tmp_path / "a.bag", [Chunk(connection() + message(5, b"a"), [5])], index=index)
    found, said, most = read(path)
    assert found == [b"a"]
    assert len(said) == 1
    assert re.search(f"the index is damaged, and isn't used: {reason}", said[0])
    assert most < 20 * MEGABYTE


def test_chunk_that_is_indexed_again_and_again_is_read_once(tmp_path: Path) -> None:
    chunk = Chunk(connection() + message(5, b"a") * 1000, [5] * 1000)
    count = 1000
    path = tmp_path / "a.bag"
    place = len(header(0, 0))
    body = chunk.stored() + chunk.entries()
    path.write_bytes(header(place + len(body), count) + body + connection() + chunk.info(place) * count)
    found, said, most = read(path)
    assert found == [b"a"] * 1000
    assert len(said) == 1
    assert f"it names the chunk at byte {place} twice" in said[0]
    assert most < 20 * MEGABYTE


def test_unknown_compression_is_named(tmp_path: Path) -> None:
    path = write(tmp_path / "a.bag", [Chunk(connection() + message(5, b"a"), [5])])
    path.write_bytes(path.read_bytes().replace(b"compression=none", b"compression=zst9"))
    with pytest.raises(BagError, match="the compression is 'zst9', which is none of bz2 and lz4"):
        read(path)
