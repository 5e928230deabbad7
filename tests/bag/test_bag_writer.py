"""Bags that we write, as other readers and we read them."""

from __future__ import annotations

import errno
import os
import shutil
import sqlite3
import sys
import warnings
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import pytest
from mcap.reader import NonSeekingReader, make_reader
from mcap.records import Schema
from mcap.stream_reader import StreamReader
from tests.bag.recordings import rows_of
from tests.bag.written_bags import (
    CHATTER,
    QOS,
    START_NS,
    STEP_NS,
    begin_bag,
    push,
    raising,
    read_by_rosbags,
    row,
    write_bag,
)

from tfloom.bag import frames, open_bag
from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.metadata import parse_metadata, read_metadata
from tfloom.bag.reindexing import reindex
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.bag.writing.definition_text import find_definition
from tfloom.bag.writing.metadata_text import metadata_file_text
from tfloom.bag.writing.storage import StorageSettings
from tfloom.bag.writing.storage_config import PRESETS, storage_settings

GOLDEN = Path(__file__).parents[1] / "golden" / "bags"
SETTINGS = {
    "mcap": WriterSettings(),
    "sqlite3": WriterSettings("sqlite3"),
    "zstd chunks": WriterSettings(storage=StorageSettings("zstd")),
    "lz4 chunks": WriterSettings(storage=StorageSettings("lz4", chunk_size=1000, has_chunk_crc=True)),
    "no chunks": WriterSettings(storage=PRESETS["mcap"]["fastwrite"]),
    "no summary": WriterSettings(storage=StorageSettings(has_summary=False)),
    "zstd file": WriterSettings(compression_mode="FILE", max_file_size=2000),
    "zstd messages": WriterSettings(compression_mode="MESSAGE"),
    "zstd sqlite3 messages": WriterSettings("sqlite3", compression_mode="MESSAGE"),
    "split by size": WriterSettings(max_file_size=1500),
    "split by time": WriterSettings("sqlite3", max_file_duration_ns=20 * STEP_NS),
    "no cache": WriterSettings(cache_size=0),
}


@pytest.mark.parametrize("name", SETTINGS)
def test_rosbags_and_we_read_each_byte(name: str, tmp_path: Path) -> None:
    rows = write_bag(tmp_path / "bag", SETTINGS[name])
    if name != "no summary":  # rosbags needs it
        assert read_by_rosbags(tmp_path / "bag") == rows
    assert rows_of(tmp_path / "bag") == rows
    with open_bag(tmp_path / "bag") as bag:
        assert bag.message_count == len(rows)
        assert {topic.name: topic.message_count for topic in bag.topics.values()} == {
            "/chatter": 50,
            "/silent": 0,
            "/tf": 50,
        }
        assert {topic.offered_qos for topic in bag.topics.values()} == {QOS}
    assert {edge.child_frame_id for edge in frames(tmp_path / "bag").edges()} == {"base"}


def test_mcaps_own_readers_find_all(tmp_path: Path) -> None:
    rows = write_bag(
        tmp_path / "bag", WriterSettings(storage=StorageSettings("zstd", chunk_size=2000, has_chunk_crc=True))
    )
    with (tmp_path / "bag" / "bag_0.mcap").open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        found = list(reader.iter_messages())
        summary = reader.get_summary()
    assert [(channel.topic, message.log_time, message.data) for _, channel, message in found] == rows
    assert all(message.publish_time == message.log_time - 1 for _, _, message in found)
    assert summary is not None
    assert summary.statistics is not None
    assert summary.statistics.message_count == len(rows)
    assert summary.statistics.chunk_count == len(summary.chunk_indexes) > 3
    with (tmp_path / "bag" / "bag_0.mcap").open("rb") as file:
        assert len(list(NonSeekingReader(file, validate_crcs=True).iter_messages())) == len(rows)


def kinds_of_records(path: Path) -> list[str]:
    with path.open("rb") as file:
        return [type(record).__name__ for record in StreamReader(file, emit_chunks=True).records]


def test_records_are_those_of_rosbag2(tmp_path: Path) -> None:
    golden = kinds_of_records(GOLDEN / "mcap" / "b1_0.mcap")
    write_bag(tmp_path / "bag")
    assert kinds_of_records(tmp_path / "bag" / "bag_0.mcap") == [
        kind for at, kind in enumerate(golden) if kind != "MessageIndex" or golden[at - 1] != "Chunk"
    ]


def test_schema_has_the_definitions_that_rosbag2_has(tmp_path: Path) -> None:
    def sections(path: Path) -> dict[str, list[list[str]]]:
        with path.open("rb") as file:
            schemas = [schema for schema in StreamReader(file).records if isinstance(schema, Schema)]
        return {
            schema.name: [
                [
                    line.partition("#")[0].strip()
                    for line in part.splitlines()
                    if line.partition("#")[0].strip()
                ]
                for part in schema.data.decode().split("=" * 80)
            ]
            for schema in schemas
        }

    write_bag(tmp_path / "bag")
    ours, theirs = sections(tmp_path / "bag" / "bag_0.mcap"), sections(GOLDEN / "mcap" / "b1_0.mcap")
    for name in ("tf2_msgs/msg/TFMessage", "std_msgs/msg/String"):
        assert ours[name] == theirs[name]


@pytest.mark.parametrize("name", ["mcap", "sqlite3", "split", "zstd_file"])
def test_metadata_is_written_as_rosbag2_does(name: str) -> None:
    path = GOLDEN / name / "metadata.yaml"
    assert metadata_file_text(parse_metadata(path.read_text("utf-8"), path)) == path.read_text("utf-8")


def test_tables_of_sqlite3_are_those_of_rosbag2(tmp_path: Path) -> None:
    def tables(path: Path) -> list[Any]:
        with sqlite3.connect(path) as database:
            return database.execute("SELECT type, name, sql FROM sqlite_master ORDER BY name").fetchall()

    write_bag(tmp_path / "bag", WriterSettings("sqlite3"))
    assert tables(tmp_path / "bag" / "bag_0.db3") == tables(GOLDEN / "sqlite3" / "b6_0.db3")
    assert sorted(path.name for path in (tmp_path / "bag").iterdir()) == ["bag_0.db3", "metadata.yaml"]


@pytest.mark.parametrize("is_written_at_once", [False, True])
def test_files_are_split_where_they_must_be(is_written_at_once: bool, tmp_path: Path) -> None:
    splits: list[tuple[str, str]] = []
    writer = BagWriter(
        tmp_path / "bag",
        WriterSettings(max_file_duration_ns=10 * STEP_NS),
        lambda closed, opened: splits.append((closed.name, opened.name)),
    )
    channel = writer.add_topic(CHATTER)
    for number in range(25):
        push(writer, channel, number)
        if is_written_at_once:  # as by a recorder's flush: no chunk is left to bear the mark of a split
            writer.write_present()
    writer.close()
    found = read_metadata(tmp_path / "bag")
    assert (found.start_ns, found.duration_ns) == (START_NS, 24 * STEP_NS)
    assert [(file.start_ns - START_NS, file.message_count) for file in found.files] == [
        (0, 11),
        (11 * STEP_NS, 11),
        (22 * STEP_NS, 3),
    ]
    assert splits == [("bag_0.mcap", "bag_1.mcap"), ("bag_1.mcap", "bag_2.mcap")]


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_only_the_newest_files_are_kept(
    storage_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    suffix = "mcap" if storage_id == "mcap" else "db3"
    settings = WriterSettings(storage_id, max_file_duration_ns=10 * STEP_NS, max_files=2)
    writer = BagWriter(tmp_path / "bag", settings)
    channel = writer.add_topic(CHATTER)
    for number in range(36):
        push(writer, channel, number)
        writer.write_present()
    assert sorted(path.name for path in (tmp_path / "bag").glob(f"*.{suffix}")) == [
        f"bag_2.{suffix}",
        f"bag_3.{suffix}",
    ]
    # A file that can't be deleted stays in the bag, and goes with the next one.
    with monkeypatch.context() as broken:
        broken.setattr(Path, "unlink", raising(PermissionError(errno.EACCES, "Permission denied")))
        writer.split()
    assert "bag_2" in capfd.readouterr().err
    assert writer.info().files[0].path == f"bag_2.{suffix}"
    writer.split()
    push(writer, channel, 36)
    writer.close()
    found = read_metadata(tmp_path / "bag")
    assert [file.path for file in found.files] == [f"bag_4.{suffix}", f"bag_5.{suffix}"]
    assert found.message_count == sum(topic.message_count for topic in found.topics) == 1
    with open_bag(tmp_path / "bag") as bag:
        assert bag.message_count == 1


def test_custom_data_and_odd_names_are_kept(tmp_path: Path) -> None:
    custom = {"robot": "Ä: 1", "empty": "", "number": "012", "line": "a\nb", "hash": "a # b", "No": "null"}
    custom |= {
        f"{word} like {word}": word for word in ("true", "False", "YES", "on", "off", "1e5", "/a", "~")
    }
    folder = tmp_path / "a bag: with 'odd' name"
    write_bag(folder, WriterSettings(custom_data=custom))
    assert read_metadata(folder).custom_data == custom
    with open_bag(folder) as bag:
        assert bag.message_count == 100


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_bag_that_is_not_closed_keeps_all_chunks_but_the_last(storage_id: str, tmp_path: Path) -> None:
    settings = WriterSettings(storage_id, StorageSettings(chunk_size=400))
    writer, channel = begin_bag(tmp_path / "bag", settings)
    push(writer, channel, *range(100))
    told = pytest.warns(match="the file has no end") if storage_id == "mcap" else nullcontext()
    with told, open_bag(writer.file_path) as bag:
        assert 90 <= bag.message_count < 100
    writer.close()


def test_folder_that_cannot_be_made_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "there").mkdir()
    with pytest.raises(BagError, match="exists already"):
        BagWriter(tmp_path / "there")
    (tmp_path / "file").touch()
    with pytest.raises(BagError, match="it can't be created: Not a directory"):
        BagWriter(tmp_path / "file" / "bag")


def test_read_only_folder_is_an_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Path, "mkdir", raising(PermissionError(errno.EACCES, os.strerror(errno.EACCES))))
    with pytest.raises(BagError, match="bag: it can't be created: Permission denied"):
        BagWriter(tmp_path / "bag")


def test_configurations_of_storages(tmp_path: Path) -> None:
    path = tmp_path / "config.yaml"
    path.write_text(
        "noChunkCRC: false\nchunkSize: 5\ncompression: Lz4\ncompressionLevel: Fast\nnoStatistics: true"
    )
    assert storage_settings("mcap", "", str(path)) == StorageSettings("lz4", "Fast", 5, has_chunk_crc=True)
    path.write_text('write:\n  pragmas: ["page_size=8192"]')
    assert storage_settings("sqlite3", "resilient", str(path)).pragmas == (
        "synchronous=NORMAL",
        "page_size=8192",
    )
    for text_, reason in (
        ("chunkSize: -1", "a positive number of bytes"),
        ("chunksize: 1", "unknown option chunksize"),
        ("noChunking: 3", "true or false"),
        ("compression: bz2", "None, Lz4 or Zstd"),
        ("[1]", "must be a map"),
        ("a: [", "isn't YAML"),
    ):
        path.write_text(text_)
        with pytest.raises(BagError, match=reason):
            storage_settings("mcap", "", str(path))
    with pytest.raises(BagError, match="'fastwrite' is not a preset of sqlite3: none, resilient"):
        storage_settings("sqlite3", "fastwrite")


def test_topic_of_a_refused_chunk_is_written_with_its_definition_later(tmp_path: Path) -> None:
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings("sqlite3"))
    with sqlite3.connect(writer.file_path) as database:
        database.execute(
            "CREATE TRIGGER refused BEFORE INSERT ON messages BEGIN SELECT RAISE(FAIL, 'refused'); END"
        )
        push(writer, channel, 0)
        with pytest.raises(BagError, match="refused"):
            writer.write_present()
        database.execute("DROP TRIGGER refused")
    database.close()
    writer.close()
    with open_bag(tmp_path / "bag") as bag:
        assert bag.topic("/chatter").definition == find_definition("std_msgs/msg/String")


def test_limits_of_any_size(tmp_path: Path) -> None:
    huge = 10**30
    for number, settings in enumerate(
        (
            WriterSettings(max_file_size=huge, max_file_duration_ns=huge, cache_size=huge),
            WriterSettings(cache_size=huge, is_snapshot=True),
            WriterSettings(cache_size=0, is_snapshot=True),
        )
    ):
        writer, channel = begin_bag(tmp_path / str(number), settings)
        push(writer, channel, *range(10))
        writer.write_present()
        assert writer.message_count == 10
        writer.close()
    for name in ("max_file_size", "max_file_duration_ns", "max_files", "cache_size"):
        with pytest.raises(BagError, match=r"bag: the sizes, the duration .* can't be negative"):
            BagWriter(tmp_path / "bag", WriterSettings()._replace(**{name: -1}))
    assert not (tmp_path / "bag").exists()


def test_large_chunk_of_small_messages(tmp_path: Path) -> None:
    rows = write_bag(tmp_path / "bag", WriterSettings(storage=StorageSettings(chunk_size=64 << 20)), 30_000)
    with open_bag(tmp_path / "bag") as bag:
        assert len(bag.files[0].storage.layout.spans) == 1
    assert rows_of(tmp_path / "bag") == rows


@pytest.mark.parametrize("storage_id", ["mcap", "sqlite3"])
def test_messages_that_are_compressed_one_by_one_are_read_without_metadata(
    storage_id: str, tmp_path: Path
) -> None:
    folder = tmp_path / "bag"
    writer, number = begin_bag(folder, WriterSettings(storage_id, compression_mode="MESSAGE"))
    rows = [row(i) for i in range(20)]
    for _, stamp_ns, data in rows:
        writer.push(number, data, stamp_ns, stamp_ns - 1)
    writer.write_rest()
    copy = shutil.copytree(folder, tmp_path / "copy")  # as it is if the recorder is killed
    writer.close()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", BagWarning)
        for path in (copy / writer.file_path.name, copy):
            if path == copy:
                reindex(copy)
            with open_bag(path) as bag:
                messages = list(bag.messages())
                assert [(message.topic, message.log_time_ns, message.data) for message in messages] == rows
                before_ns = 1 if storage_id == "mcap" else 0  # sqlite3 has no time of publishing
                assert {message.log_time_ns - message.publish_time_ns for message in messages} == {before_ns}
    found = read_metadata(copy)
    assert (found.compression_format, found.compression_mode) == ("zstd", "MESSAGE")


@pytest.mark.parametrize(
    ("settings", "module"),
    [
        (WriterSettings(compression_mode="MESSAGE"), "zstandard"),
        (WriterSettings(compression_mode="FILE"), "zstandard"),
        (WriterSettings(storage=StorageSettings(compression="zstd")), "zstandard"),
        (WriterSettings(storage=StorageSettings(compression="lz4")), "lz4.frame"),
    ],
)
def test_missing_library_is_named_before_anything_is_written(
    settings: WriterSettings, module: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(BagError, match=r"pip install 'tfloom\[bag\]'"):
        BagWriter(tmp_path / "bag", settings)
    assert not (tmp_path / "bag").exists()
