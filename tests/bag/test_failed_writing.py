"""Bags whose writing fails, or whose topics change meanwhile: nothing is lost or mislabelled in silence."""

from __future__ import annotations

import errno
import os
import sqlite3
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from mcap.stream_reader import StreamReader
from tests.bag.recordings import rows_of
from tests.bag.written_bags import (
    CHATTER,
    START_NS,
    STEP_NS,
    begin_bag,
    push,
    raising,
    row,
    text,
    topic,
)

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import read_metadata
from tfloom.bag.reindexing import reindex
from tfloom.bag.rosbag2_names.storage import ConverterOptions, StorageOptions, TopicMetadata
from tfloom.bag.rosbag2_names.writers import SequentialWriter
from tfloom.bag.writing import bag_writer, compression, mcap_records, sqlite_file, storage
from tfloom.bag.writing.bag_writer import BagWriter, State, WriterSettings, open_storage_file
from tfloom.bag.writing.sqlite_file import SqliteFile
from tfloom.bag.writing.storage import StorageSettings

STORAGES = ("mcap", "sqlite3")


full_disk = raising(OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)))


@pytest.mark.parametrize("storage_id", STORAGES)
def test_topics_are_added_while_a_file_is_completed(
    storage_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings(storage_id))
    added = []

    def meanwhile(function: Callable[..., Any]) -> Callable[..., Any]:
        def run(*args: Any) -> Any:
            name = f"/late{len(added)}"
            added.append(name)
            writer.add_topic(topic(name, "std_msgs/msg/String"))
            return function(*args)

        return run

    push(writer, channel, 0)
    monkeypatch.setattr(mcap_records, "channel", meanwhile(mcap_records.channel))
    monkeypatch.setattr(SqliteFile, "_add_topics", meanwhile(SqliteFile._add_topics))
    writer.write_present()
    writer.split()
    push(writer, channel, 1)
    writer.close()
    assert len(added) > 2
    assert rows_of(tmp_path / "bag") == [row(0), row(1)]


@pytest.mark.parametrize("storage_id", STORAGES)
def test_numbers_of_removed_topics_are_not_given_again(storage_id: str, tmp_path: Path) -> None:
    def created(name: str) -> TopicMetadata:
        return TopicMetadata(0, name, "std_msgs/msg/String", "cdr")

    writer = SequentialWriter()
    writer.open(StorageOptions(uri=str(tmp_path / "bag"), storage_id=storage_id), ConverterOptions("", ""))
    for name in ("/a", "/b", "/c", "/queued", "/gone"):
        writer.create_topic(created(name))
    writer.write("/queued", text(0), START_NS)
    writer.write("/gone", text(5), START_NS + 5)
    for name in ("/a", "/queued", "/gone"):
        writer.remove_topic(created(name))
        with pytest.raises(BagError, match="has not been created yet"):
            writer.write(name, text(0), START_NS)
    writer.create_topic(created("/d"))
    for number, name in enumerate(("/c", "/d", "/b"), 1):
        writer.write(name, text(number), START_NS + number)
    writer.create_topic(created("/queued"))
    writer.write("/queued", text(4), START_NS + 4)
    writer.close()
    names = ("/queued", "/c", "/d", "/b", "/queued", "/gone")
    assert rows_of(tmp_path / "bag") == [
        (name, START_NS + number, text(number)) for number, name in enumerate(names)
    ]
    found = read_metadata(tmp_path / "bag").topics
    counts = {topic.name: topic.message_count for topic in found}
    assert counts == {"/b": 1, "/c": 1, "/d": 1, "/queued": 2, "/gone": 1}


@pytest.mark.parametrize("storage_id", STORAGES)
def test_removed_topic_with_messages_stays(storage_id: str, tmp_path: Path) -> None:
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings(storage_id))
    push(writer, channel, 0)
    writer.write_present()
    writer.remove_topic("/chatter")
    writer.close()
    assert rows_of(tmp_path / "bag") == [row(0)]
    (found,) = read_metadata(tmp_path / "bag").topics
    assert (found.name, found.message_count) == ("/chatter", 1)


def test_more_topics_than_numbers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(storage, "MAX_TOPICS", 1)
    writer, channel = begin_bag(tmp_path / "bag")
    with pytest.raises(BagError, match=r"'/chatter' can't be added: a bag has at most 1 topics"):
        writer.add_topic(CHATTER)
    push(writer, channel, 0)
    writer.close()
    assert rows_of(tmp_path / "bag") == [row(0)]


@pytest.mark.parametrize("is_full_at_close", [True, False])
@pytest.mark.parametrize("storage_id", STORAGES)
def test_split_whose_next_file_cannot_be_opened(
    storage_id: str, is_full_at_close: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "bag"
    writer, channel = begin_bag(folder, WriterSettings(storage_id, max_file_size=200))
    first = writer.file_path
    with monkeypatch.context() as patched:
        patched.setattr(bag_writer, "open_storage_file", full_disk)
        with pytest.raises(BagError, match=r"bag_1\.\w+: it can't be written: No space left .* bag reindex"):
            push(writer, channel, *range(1, 20))
        pushed = writer.queue.message_count
        assert pushed < 10
        assert writer.state is State.FAILED
        assert writer.file_path == first
        with pytest.raises(BagError, match="a write has failed, and nothing more is written; close it"):
            push(writer, channel, 99)
        push(writer.queue, channel, pushed + 1)  # as readers do meanwhile
        if is_full_at_close:
            with pytest.raises(BagError, match=r"bag_1\.\w+: it can't be written: No space left"):
                writer.close()
    writer.close()
    assert writer.state is State.CLOSED
    writer.close()
    found = [row(number) for number in range(1, pushed + (1 if is_full_at_close else 2))]
    assert rows_of(folder) == found
    names = sorted(path.name for path in folder.iterdir())
    assert names == sorted([*read_metadata(folder).relative_file_paths, "metadata.yaml"])
    (folder / "metadata.yaml").unlink()
    reindex(folder)
    assert rows_of(folder) == found


@pytest.mark.parametrize("storage_id", STORAGES)
def test_first_file_that_cannot_be_begun_leaves_nothing(
    storage_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patched:
        patched.setattr(mcap_records, "header", full_disk)
        patched.setattr(sqlite_file.SqliteFile, "_insert_metadata", full_disk)
        with pytest.raises(BagError, match="No space left on device"):
            BagWriter(tmp_path / "bag", WriterSettings(storage_id))
    assert not list(tmp_path.iterdir())
    BagWriter(tmp_path / "bag", WriterSettings(storage_id)).close()


def test_duration_of_a_file_of_several_chunks(tmp_path: Path) -> None:
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings(storage=StorageSettings(chunk_size=1)))
    # A chunk each; neither the first nor the last one has the first or last time.
    push(writer, channel, 5, 9, 2, 7)
    writer.close()
    info = read_metadata(tmp_path / "bag")
    (file,) = info.files
    assert (file.start_ns, file.duration_ns) == (START_NS + 2 * STEP_NS, 7 * STEP_NS)
    assert (info.start_ns, info.duration_ns) == (START_NS + 2 * STEP_NS, 7 * STEP_NS)
    with open_bag(tmp_path / "bag") as bag:
        assert len(bag.files[0].storage.layout.spans) == 4
        assert (bag.start_ns, bag.end_ns) == (START_NS + 2 * STEP_NS, START_NS + 9 * STEP_NS)


def test_duration_of_a_file_is_counted_from_its_beginning_by_size(tmp_path: Path) -> None:
    writer, channel = begin_bag(
        tmp_path / "bag", WriterSettings(max_file_size=200, max_file_duration_ns=6 * STEP_NS)
    )
    push(writer, channel, *range(12))
    writer.close()
    counts = [file.message_count for file in read_metadata(tmp_path / "bag").files]
    assert counts == [5, 5, 2, 0]  # without a new beginning, the second file would end after 2


def test_split_leaves_no_empty_file_before_one_that_is_due(tmp_path: Path) -> None:
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings(max_file_duration_ns=10 * STEP_NS))
    push(writer, channel, 0, 20)  # the second one begins the next file
    assert writer.message_count == 1
    writer.split()
    writer.close()
    assert [file.message_count for file in read_metadata(tmp_path / "bag").files] == [1, 1]


def test_snapshot_is_not_written_before_it_is_asked_for(tmp_path: Path) -> None:
    settings = WriterSettings(storage=StorageSettings(chunk_size=200), cache_size=4000, is_snapshot=True)
    writer, channel = begin_bag(tmp_path / "bag", settings)
    push(writer, channel, *range(500))
    assert writer.message_count == 0
    writer.write_present()
    writer.close()
    rows = rows_of(tmp_path / "bag")
    assert 0 < len(rows) < 500
    assert rows == [row(number) for number in range(500 - len(rows), 500)]


def test_ctrl_c_in_the_middle_of_a_write_loses_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer, channel = begin_bag(tmp_path / "bag")
    push(writer, channel, 0)
    with monkeypatch.context() as patched:
        patched.setattr(writer._file, "write", raising(KeyboardInterrupt()))
        with pytest.raises(KeyboardInterrupt):
            writer.write_present()
    with pytest.raises(BagError, match="a write has failed"):
        push(writer, channel, 1)  # else it would be written before the one that waits
    writer.close()
    assert rows_of(tmp_path / "bag") == [row(0)]


def test_file_of_just_the_size_limit_is_complete(tmp_path: Path) -> None:
    def record(name: str, max_size: int) -> tuple[int, list[int]]:
        """Return the size after one message, and the messages of each file."""
        writer, channel = begin_bag(tmp_path / name, WriterSettings(max_file_size=max_size))
        push(writer, channel, 0)
        writer.write_present()
        size = (tmp_path / name / f"{name}_0.mcap").stat().st_size
        push(writer, channel, 1)
        writer.close()
        return size, [file.message_count for file in read_metadata(tmp_path / name).files]

    size, counts = record("bag1", 1 << 20)
    assert counts == [2]
    assert record("bag2", size + 1)[1][0] == 2
    assert record("bag3", size)[1][0] == 1


def test_topic_of_a_refused_chunk_is_in_the_next_chunk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer = BagWriter(tmp_path / "bag")
    channels = [writer.add_topic(topic(name, "std_msgs/msg/String")) for name in ("/chatter", "/other")]
    for number, channel in enumerate(channels):
        push(writer, channel, number)
    with monkeypatch.context() as patched:
        patched.setattr(writer._file, "_append", full_disk)
        with pytest.raises(BagError, match="No space left"):
            writer.write_present()
    path = writer.file_path
    writer.close()
    with path.open("rb") as file:
        kinds = [type(record).__name__ for record in StreamReader(file).records]
    # The topics and their type are where a reader of a file that was cut off looks for them, and once.
    assert kinds[kinds.index("Schema") :][:5] == ["Schema", "Channel", "Channel", "Message", "Message"]
    assert (kinds.count("Schema"), kinds.count("Channel")) == (2, 4)  # once more in the summary


def test_cache_holds_twice_its_size() -> None:
    queue = bag_writer.make_queue(WriterSettings(cache_size=10_000))
    size = 0
    while queue.push(1, bytes(100), 1, 1):
        size += 100
    assert 10_000 < size <= 20_000


@pytest.mark.parametrize("is_log_left", [False, True])
def test_failed_beginning_of_a_database_leaves_nothing(
    is_log_left: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    databases: list[sqlite3.Connection] = []
    begin = SqliteFile._begin

    def begin_and_fail(self: SqliteFile, database: sqlite3.Connection, metadata: str) -> None:
        databases.append(database)
        if is_log_left:  # as where the disk is too full for sqlite to end its log
            for suffix in ("-wal", "-shm"):
                (tmp_path / f"file.db3{suffix}").touch()
        else:
            begin(self, database, metadata)
        full_disk()

    monkeypatch.setattr(SqliteFile, "_begin", begin_and_fail)
    arguments = (tmp_path / "file.db3", storage.TopicTable(), StorageSettings(), "")
    with pytest.raises(OSError, match="No space left"):
        open_storage_file("sqlite3", *arguments)
    with pytest.raises(sqlite3.ProgrammingError, match="closed database"):
        databases[0].execute("SELECT 1")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("fails", [False, True])
def test_database_is_closed_even_if_it_cannot_be_completed(
    fails: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = SqliteFile(tmp_path / "file.db3", storage.TopicTable(), StorageSettings(), "")
    database = file._database
    assert database is not None
    if fails:
        monkeypatch.setattr(file, "_insert_metadata", full_disk)
        with pytest.raises(OSError, match="No space left"):
            file.close("")
    file.close("")
    with pytest.raises(sqlite3.ProgrammingError, match="closed database"):
        database.execute("SELECT 1")


@pytest.mark.parametrize("storage_id", STORAGES)
def test_file_of_somebody_else_is_left(storage_id: str, tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"mine")
    with pytest.raises(FileExistsError):
        open_storage_file(storage_id, path, storage.TopicTable(), StorageSettings(), "")
    assert path.read_bytes() == b"mine"


def test_file_that_cannot_be_compressed_is_left_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compressor = SimpleNamespace(compress=full_disk)
    zstd = SimpleNamespace(ZstdCompressor=lambda **_: SimpleNamespace(compressobj=lambda **_: compressor))
    monkeypatch.setattr(compression, "zstd", lambda: zstd)
    path = tmp_path / "file.mcap"
    path.write_bytes(b"whole")
    with pytest.raises(OSError, match="No space left"):
        compression.compress_file(path)
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == {"file.mcap": b"whole"}


def test_topic_that_is_replaced_after_its_removal_is_there(tmp_path: Path) -> None:
    writer, channel = begin_bag(tmp_path / "bag")
    writer.remove_topic("/chatter")
    writer.set_topic(channel, CHATTER)
    writer.close()
    assert [topic.name for topic in read_metadata(tmp_path / "bag").topics] == ["/chatter"]


@pytest.mark.parametrize("storage_id", STORAGES)
def test_write_that_fails_at_the_end_is_tried_once_more(
    storage_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings(storage_id))
    push(writer, channel, *range(3))
    file = writer._file
    assert file is not None
    write, tries = file.write, list[object]()

    def fail_at_first(chunk: Any) -> None:
        tries.append(chunk)
        if len(tries) == 1:
            full_disk()
        write(chunk)

    monkeypatch.setattr(file, "write", fail_at_first)
    with pytest.raises(BagError, match="No space left"):
        writer.close()
    assert rows_of(tmp_path / "bag") == [row(number) for number in range(3)]
