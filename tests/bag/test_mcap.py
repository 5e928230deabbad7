"""MCAP files: of mcap's own writer, of rosbags, unfinished, damaged and hostile ones."""

from __future__ import annotations

import random
import struct
import tracemalloc
import warnings
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from mcap.reader import make_reader
from tests.bag.recordings import START, drive, error_of, found_in, write_mcap, write_sqlite

from tfloom.bag import BagError, BagWarning, frames, open_bag
from tfloom.bag.reading import compression as decompression
from tfloom.bag.reading import file_bytes, mcap_scan
from tfloom.bag.reading.mcap_records import FOOTER_SIZE, MAGIC, RECORD_HEADER, Opcode

DRIVE = drive()


@pytest.mark.parametrize("compression", ["", "lz4", "zstd"])
def test_messages_of_mcaps_own_writer(compression: str, tmp_path: Path) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE, compression)
    with open_bag(path) as bag:
        assert found_in(bag) == DRIVE
        assert bag.message_count == len(DRIVE)
        assert bag.topics["/tf"].type == "tf2_msgs/msg/TFMessage"
    assert_drive(path)


def assert_drive(path: Path, count: int = 50) -> None:
    buffer = frames(path)
    edges = {edge.child_frame_id: edge for edge in buffer.edges()}
    assert edges["lidar"].is_static
    assert [edges[name].sample_count for name in ("odom", "base_link")] == [count, count]
    found = buffer.lookup("map", "base_link", START + 250_000_000)
    assert found.translation == pytest.approx((3.5, 0, 0))


@pytest.mark.parametrize(
    "options",
    [
        {"use_chunking": False},
        {"use_chunking": False, "use_statistics": False, "use_summary_offsets": False},
        {"use_statistics": False},
        {"repeat_channels": False, "repeat_schemas": False},
        {"use_chunking": True, "chunk_size": 1 << 20},
    ],
    ids=["no chunks", "no chunks, no statistics", "no statistics", "no channels in the summary", "one chunk"],
)
def test_files_with_less_than_a_whole_summary(options: dict[str, object], tmp_path: Path) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE, "lz4", **options)
    with open_bag(path) as bag:
        assert found_in(bag) == DRIVE
        assert (bag.start_ns, bag.end_ns) == (START, DRIVE[-1][1])
    assert_drive(path)


def test_messages_out_of_order_are_sorted_by_log_time(tmp_path: Path) -> None:
    shuffled = DRIVE.copy()
    random.Random(1).shuffle(shuffled)
    path = write_mcap(tmp_path / "a.mcap", shuffled)
    with open_bag(path) as bag:
        found = found_in(bag)
    assert [message[1] for message in found] == sorted(message[1] for message in DRIVE)
    assert sorted(found) == sorted(DRIVE)
    assert_drive(path)


@pytest.mark.parametrize("compression", ["", "lz4", "zstd"])
def test_file_cut_off_anywhere_is_read_to_its_last_whole_record(compression: str, tmp_path: Path) -> None:
    whole = write_mcap(tmp_path / "whole.mcap", DRIVE, compression).read_bytes()
    cut = tmp_path / "cut.mcap"
    most = 0
    for size in range(len(MAGIC) + 30, len(whole) - 1, 397):
        cut.write_bytes(whole[:size])
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            found = found_in(open_bag(cut))
        texts = [str(warning.message) for warning in caught]
        assert len(found) == len(DRIVE) or any(
            "still being written or its recorder" in text for text in texts
        )
        assert found == DRIVE[: len(found)], size
        assert len(found) >= most, size
        most = len(found)
    assert most == len(DRIVE)


def test_chunk_that_is_cut_off_is_read_to_its_last_whole_record(tmp_path: Path) -> None:
    whole = write_mcap(tmp_path / "whole.mcap", DRIVE, "", chunk_size=1 << 20).read_bytes()
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(whole[: len(whole) // 3])
    with pytest.warns(BagWarning):
        bag = open_bag(cut)
    found = found_in(bag)
    assert 10 < len(found) < len(DRIVE)
    assert found == DRIVE[: len(found)]
    with pytest.warns(BagWarning):
        buffer = frames(cut)
    assert buffer.has_frame("base_link")


def test_bag_that_is_still_being_written_is_read_again_as_it_grows(tmp_path: Path) -> None:
    whole = write_mcap(tmp_path / "whole.mcap", DRIVE).read_bytes()
    growing = tmp_path / "growing.mcap"
    counts = []
    for part in (2, 1.3, 1):
        growing.write_bytes(whole[: int(len(whole) / part)])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", BagWarning)
            counts.append(len(found_in(open_bag(growing))))
    assert counts == sorted(set(counts))


def test_errors_name_the_file_the_place_and_what_to_do(tmp_path: Path) -> None:
    whole = write_mcap(tmp_path / "whole.mcap", DRIVE, "zstd").read_bytes()
    cases = {
        "empty.mcap": (b"", "the file is empty: its recorder ended before it wrote anything"),
        "short.mcap": (whole[:5], "the file ends after 5 bytes, within the first bytes of an MCAP file"),
        "other.mcap": (
            b"SQLite format 3\0" * 9,
            "byte 0: this is not an MCAP file: it begins with b'SQLite f'",
        ),
        "header.mcap": (whole[:20], "byte 8: the header is damaged or cut off"),
        "name.txt": (whole, "a file of a recording ends in .mcap, .db3, .bag"),
    }
    for name, (data, text) in cases.items():
        path = tmp_path / name
        path.write_bytes(data)
        with error_of(path, text):
            open_bag(path)
    with pytest.raises(BagError, match="there is no such file or folder"):
        open_bag(tmp_path / "nothing")


def test_unknown_compression_is_named(tmp_path: Path) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE, "zstd")
    path.write_bytes(path.read_bytes().replace(b"\4\0\0\0zstd", b"\4\0\0\0lzma"))
    bag = open_bag(path)
    with pytest.raises(
        BagError, match=r"a\.mcap: byte \d+: the compression is 'lzma', which is none of lz4 and zstd"
    ):
        found_in(bag)


def test_damaged_chunk_is_left_out_with_a_warning(tmp_path: Path) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE, "zstd")
    data = bytearray(path.read_bytes())
    at = data.index(b"\x28\xb5\x2f\xfd", 3000)
    data[at + 20 : at + 60] = bytes(40)
    path.write_bytes(data)
    bag = open_bag(path)
    with pytest.warns(
        BagWarning, match=r"a\.mcap: byte \d+: a chunk of messages is damaged: .*it is left out"
    ):
        found = found_in(bag)
    assert 0 < len(found) < len(DRIVE)
    assert set(found) < set(DRIVE)


def test_chunk_that_declares_a_huge_size_is_not_decompressed(tmp_path: Path) -> None:
    path = write_mcap(tmp_path / "a.mcap", DRIVE, "lz4")
    data = path.read_bytes()
    huge = _with_chunk_sizes(data, 1 << 40)
    path.write_bytes(huge)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert found_in(open_bag(path)) == []
    assert any("more than the 1073741824 that are accepted" in str(warning.message) for warning in caught)


def _with_chunk_sizes(data: bytes, size: int) -> bytes:
    """Return a file whose chunks, and no index, declare a size."""
    changed = bytearray(data[: -len(MAGIC)])
    at = len(MAGIC)
    while at + RECORD_HEADER.size < len(changed):
        opcode, length = RECORD_HEADER.unpack_from(changed, at)
        if opcode == Opcode.CHUNK:
            struct.pack_into("<Q", changed, at + RECORD_HEADER.size + 16, size)
        at += RECORD_HEADER.size + length
    return bytes(changed)


def test_random_damage_gives_errors_and_warnings_only(tmp_path: Path) -> None:
    whole = write_mcap(tmp_path / "whole.mcap", DRIVE, "lz4").read_bytes()
    path = tmp_path / "damaged.mcap"
    chance = random.Random(7)
    for _ in range(80):
        data = bytearray(whole)
        for _ in range(chance.randint(1, 6)):
            data[chance.randrange(len(data))] = chance.choice([0, 1, 127, 255, chance.randrange(256)])
        path.write_bytes(data)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", BagWarning)
            try:
                bag = open_bag(path)
                found_in(bag)
                frames(path)
            except BagError:
                pass


def test_chunks_that_overlap_in_time_are_merged(tmp_path: Path) -> None:
    """Each chunk has messages of the whole time; equal times are in the order of the file."""
    messages = [("/chatter", START + 10 * (i % 50) + i // 500, f"{i:04}".encode() * 9) for i in range(2000)]
    path = write_mcap(tmp_path / "a.mcap", messages, "zstd", chunk_size=2000)
    expected = sorted(messages, key=lambda message: message[1])
    with open_bag(path) as bag:
        assert found_in(bag) == expected
        assert [message.log_time_ns for message in bag.messages(start_ns=START + 7, end_ns=START + 33)] == [
            message[1] for message in expected if START + 7 <= message[1] <= START + 33
        ]


def test_summary_with_chunks_that_overlap_in_the_file_is_not_used(tmp_path: Path) -> None:
    whole = write_mcap(tmp_path / "a.mcap", DRIVE, "zstd", chunk_size=3000).read_bytes()
    chunks = [record for record in summary_records(whole) if record[0] == Opcode.CHUNK_INDEX]
    assert len(chunks) > 2
    data = bytearray(whole)
    (first, second) = (at + RECORD_HEADER.size + 16 for _, at in chunks[:2])
    data[second : second + 8] = data[first : first + 8]
    path = tmp_path / "twice.mcap"
    path.write_bytes(data)
    with pytest.warns(
        BagWarning, match=r"the summary is damaged, and isn't used: the chunks at bytes \d+ and \d+ ov"
    ):
        assert found_in(open_bag(path)) == DRIVE


def summary_records(whole: bytes) -> list[tuple[int, int]]:
    """Return opcode and offset of the records of a file's summary."""
    (at,) = struct.unpack_from("<Q", whole, len(whole) - len(MAGIC) - 20)
    found = []
    while at < len(whole) - len(MAGIC):
        opcode, length = RECORD_HEADER.unpack_from(whole, at)
        found.append((opcode, at))
        at += RECORD_HEADER.size + length
    return found


@pytest.mark.parametrize("where", ["summary", "chunk", "message", "metadata"])
def test_sizes_beyond_the_limit_are_not_allocated(
    where: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    limit = 1 << 20
    for module in (decompression, file_bytes, mcap_scan):
        monkeypatch.setattr(module, "MOST", limit)
    whole = write_mcap(tmp_path / "a.mcap", DRIVE, "", use_chunking=where != "message").read_bytes()
    size = 64 * limit
    end = whole[-FOOTER_SIZE:]
    path = tmp_path / "huge.mcap"
    with path.open("wb") as file:
        if where == "summary":
            file.write(whole[:-FOOTER_SIZE])
            end = end[:9] + struct.pack("<Q", 8) + end[17:]
        else:
            file.write(MAGIC + RECORD_HEADER.pack(Opcode.HEADER, 8) + bytes(8))
            opcode = {"chunk": Opcode.CHUNK, "message": Opcode.MESSAGE, "metadata": Opcode.METADATA}[where]
            content = size - file.tell() - RECORD_HEADER.size - len(end)
            file.write(RECORD_HEADER.pack(opcode, content))
            if where == "chunk":
                file.write(struct.pack("<QQQIIQ", 0, 0, content - 40, 0, 0, content - 40))
            end = end[:9] + bytes(8) + end[17:]
        file.seek(size - len(end))
        file.write(end)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", BagWarning)
        tracemalloc.start()
        try:
            with suppress(BagError):
                found_in(open_bag(path))
        finally:
            _, allocated = tracemalloc.get_traced_memory()
            tracemalloc.stop()
    assert allocated < 8 * limit


def test_records_between_loose_messages_do_not_multiply_what_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = write_mcap(tmp_path / "a.mcap", DRIVE, "", use_chunking=False).read_bytes()
    unknown = RECORD_HEADER.pack(0x80, 0)
    at = len(MAGIC)
    parts = [whole[:at]]
    while (opcode := whole[at]) not in {Opcode.DATA_END, Opcode.FOOTER}:
        length = RECORD_HEADER.size + RECORD_HEADER.unpack_from(whole, at)[1]
        parts += [whole[at : at + length], unknown * (opcode == Opcode.MESSAGE)]
        at += length
    path = tmp_path / "mixed.mcap"
    path.write_bytes(b"".join(parts))
    read = 0
    real = mcap_scan.read_at

    def counting(file: Any, offset: int, size: int) -> bytes:
        nonlocal read
        data = real(file, offset, size)
        read += len(data)
        return data

    monkeypatch.setattr(mcap_scan, "read_at", counting)
    with pytest.warns(BagWarning, match="has no end"):
        assert found_in(open_bag(path)) == DRIVE
    assert read < 3 * path.stat().st_size


@pytest.mark.parametrize("bound", [-(2**70), -1, 2**63, 2**64, 2**70])
def test_bounds_may_be_any_numbers(bound: int, tmp_path: Path) -> None:
    for path in (write_mcap(tmp_path / "a.mcap", DRIVE), write_sqlite(tmp_path / "a.db3", DRIVE)):
        with open_bag(path) as bag:
            assert len(list(bag.messages(start_ns=bound))) == (len(DRIVE) if bound < 0 else 0)
            assert len(list(bag.messages(end_ns=bound))) == (0 if bound < 0 else len(DRIVE))
        assert frames(path, end_ns=bound).has_frame("odom") == (bound > 0)
        assert frames(path, start_ns=bound).has_frame("odom") == (bound < 0)


def test_only_chunks_with_transforms_are_decompressed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = [message for message in DRIVE if message[0] == "/chatter"] * 40
    others = [(topic, START + 5_000_000_000 + i, data) for i, (topic, _, data) in enumerate(texts)]
    path = write_mcap(tmp_path / "a.mcap", DRIVE + others, "zstd", chunk_size=4000)
    read = 0
    real = file_bytes.read_at

    def counting(file: object, offset: int, size: int) -> bytes:
        nonlocal read
        data = real(file, offset, size)  # type: ignore[arg-type]
        read += len(data)
        return data

    for module in ("mcap_layout", "mcap_sparse"):
        monkeypatch.setattr(f"tfloom.bag.reading.{module}.read_at", counting)
    assert_drive(path)
    with path.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    channel = next(candidate.id for candidate in summary.channels.values() if candidate.topic == "/tf")
    needed = sum(
        index.chunk_length for index in summary.chunk_indexes if channel in index.message_index_offsets
    )
    everything = sum(index.chunk_length for index in summary.chunk_indexes)
    assert needed * 0.9 <= read < needed + everything // 4


def test_transforms_between_large_messages_are_read_by_the_index(tmp_path: Path) -> None:
    """The chunks are not compressed, so only the transforms' own bytes are read."""
    messages = []
    for message in DRIVE:
        messages.append(message)
        if message[0] == "/tf":
            messages.append(
                ("/chatter", message[1], b"\0\1\0\0" + struct.pack("<I", 200_000) + b"x" * 199_999 + b"\0")
            )
    for compression in ("", "lz4", "zstd"):
        path = write_mcap(tmp_path / f"a{compression}.mcap", messages, compression, chunk_size=600_000)
        assert_drive(path)
        assert_drive_in(path)


def assert_drive_in(path: Path) -> None:
    start, end = START + 100_000_000, START + 199_999_999
    edges = {edge.child_frame_id: edge for edge in frames(path, start_ns=start, end_ns=end).edges()}
    assert edges["odom"].sample_count == 10
    assert edges["lidar"].is_static


def test_offsets_and_lengths_beyond_the_file(tmp_path: Path) -> None:
    """Numbers of 8 bytes in the summary are made huge, one after the other."""
    whole = write_mcap(tmp_path / "whole.mcap", DRIVE[:20], "zstd").read_bytes()
    path = tmp_path / "huge.mcap"
    (start,) = struct.unpack_from("<Q", whole, len(whole) - len(MAGIC) - 20)
    chance = random.Random(3)
    for at in chance.sample(range(start, len(whole) - len(MAGIC) - 8), 150):
        data = bytearray(whole)
        struct.pack_into("<Q", data, at, chance.choice([2**64 - 1, 2**63, 2**62, 2**33]))
        path.write_bytes(data)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", BagWarning)
            try:
                found_in(open_bag(path))
                frames(path)
            except BagError:
                pass


def test_metadata_record_of_rosbag2() -> None:
    from tfloom.bag.reading.mcap_reader import McapFile

    golden = Path(__file__).parents[1] / "golden" / "bags" / "mcap" / "b1_0.mcap"
    found = McapFile(golden).metadata("rosbag2")
    assert found is not None
    assert "message_count: 876" in found["serialized_metadata"]
    assert McapFile(golden).metadata("another") is None


@pytest.mark.parametrize("compression", ["", "lz4"])
def test_message_index_without_messages(compression: str, tmp_path: Path) -> None:
    """Some writers index in each chunk all channels of the chunks before."""
    filler = [("/chatter", START, b"\0\1\0\0" + bytes(200_000))]
    path = write_mcap(tmp_path / "a.mcap", [*DRIVE[:1], *filler], compression, chunk_size=1 << 20)
    data = bytearray(path.read_bytes())
    index = RECORD_HEADER.pack(Opcode.MESSAGE_INDEX, 22) + struct.pack("<HI", 1, 16)
    at = data.index(index)
    data[at : at + len(index)] = RECORD_HEADER.pack(Opcode.MESSAGE_INDEX, 22) + struct.pack("<HI", 1, 0)
    path.write_bytes(data)
    assert not frames(path).has_frame("lidar")
