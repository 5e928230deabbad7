"""sqlite3 files: of each schema version, with messages in the log beside them, damaged ones."""

from __future__ import annotations

import shutil
import sqlite3
import struct
import sys
import tracemalloc
import warnings
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
import zstandard
from tests.bag.recordings import (
    SECOND,
    START,
    change_database,
    drive,
    error_of,
    found_in,
    rows_of,
    write_sqlite,
)

from tfloom.bag import BagError, BagWarning, frames, open_bag
from tfloom.bag.reading import sqlite_reader

DRIVE = drive()


@pytest.mark.parametrize("version", [1, 2, 4])
def test_each_schema_version_is_read(version: int, tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a b ü#?.db3", DRIVE, version)
    with open_bag(path) as bag:
        assert found_in(bag) == DRIVE
        assert bag.topics["/tf"].message_count == 50
    buffer = frames(path)
    assert buffer.lookup("map", "lidar", START + 250_000_000).stamp_ns == START + 250_000_000
    part = frames(path, start_ns=START + SECOND // 10, end_ns=START + SECOND // 5 - 1)
    assert {edge.child_frame_id: edge.sample_count for edge in part.edges()} == {
        "odom": 10,
        "base_link": 10,
        "lidar": 1,
    }


def test_messages_in_the_write_ahead_log_are_read(tmp_path: Path) -> None:
    """As of a recorder that is still writing, or was killed."""
    path = write_sqlite(tmp_path / "a.db3", DRIVE[:20])
    writer = sqlite3.connect(path, isolation_level=None)
    writer.execute("PRAGMA journal_mode=WAL")
    writer.execute("PRAGMA wal_autocheckpoint=0")
    topics = dict(writer.execute("SELECT name, id FROM topics").fetchall())
    for topic, stamp, data in DRIVE[20:]:
        writer.execute(
            "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", (topics[topic], stamp, data)
        )
    killed = tmp_path / "killed"
    killed.mkdir()
    for file in tmp_path.glob("a.db3*"):
        if not file.name.endswith("-shm"):
            shutil.copy(file, killed)
    assert found_in(open_bag(path)) == DRIVE
    writer.close()
    assert found_in(open_bag(killed / "a.db3")) == DRIVE


def test_read_only_folder_with_a_write_ahead_log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where sqlite3 can't write the file that it needs beside the log, both are copied."""
    path = write_sqlite(tmp_path / "a.db3", DRIVE)
    database = sqlite3.connect(path)
    database.execute("PRAGMA journal_mode=WAL")
    database.execute("UPDATE topics SET type = 'std_msgs/String' WHERE name = '/chatter'")
    database.commit()
    folder = tmp_path / "read only"
    folder.mkdir()
    for name in ("a.db3", "a.db3-wal"):
        shutil.copy(tmp_path / name, folder)
    database.close()
    before = sorted(file.name for file in folder.iterdir())
    real = sqlite_reader._opened
    modes = []

    class Refused:
        def execute(self, text: str) -> None:
            raise sqlite3.OperationalError("unable to open database file")

    @contextmanager
    def refusing(path: Path, mode: str) -> Iterator[object]:
        modes.append(mode)
        if path.parent == folder:
            yield Refused()
            return
        with real(path, mode) as opened:
            yield opened

    monkeypatch.setattr(sqlite_reader, "_opened", refusing)
    assert found_in(open_bag(folder / "a.db3")) == DRIVE
    assert modes[:2] == ["mode=ro", "mode=rw"]
    assert sorted(file.name for file in folder.iterdir()) == before


def test_errors_name_the_file_and_the_reason(tmp_path: Path) -> None:
    whole = write_sqlite(tmp_path / "whole.db3", DRIVE).read_bytes()
    other = tmp_path / "other.db3"
    change_database(other, "CREATE TABLE something(id INTEGER)")
    cases = {
        "empty.db3": (b"", "the file is empty"),
        "mcap.db3": (b"\x89MCAP0\r\n" + bytes(40), "byte 0: this is not a sqlite3 file: it begins with"),
        "other.db3": (other.read_bytes(), "the database has no tables of a recording: topics, messages"),
        "cut.db3": (whole[:5000], "the database can't be read: "),
        "damaged.db3": (whole[:4096] + bytes(8192) + whole[12288:], "the database can't be read: "),
    }
    for name, (data, text) in cases.items():
        path = tmp_path / name
        path.write_bytes(data)
        with error_of(path, text):
            rows_of(path)


def test_message_that_is_no_blob_is_an_error(tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE[:3])
    change_database(path, "UPDATE messages SET data = 'text' WHERE id = 2")
    with pytest.raises(BagError, match="a message is not a blob but str"):
        found_in(open_bag(path))


ENDLESS = (
    "DROP TABLE messages; CREATE VIEW messages(id, topic_id, timestamp, data) AS "
    "WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n) SELECT i, 1, i, x'00' FROM n"
)
GENERATED = (
    "DROP TABLE messages; CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, "
    "data BLOB AS (zeroblob(900000000))); INSERT INTO messages(topic_id, timestamp) VALUES (1, 1), (1, 2)"
)
VIRTUAL = "DROP TABLE messages; CREATE VIRTUAL TABLE messages USING rtree(id, topic_id, timestamp)"
TIME_INDEX = "CREATE INDEX timestamp_idx ON messages (timestamp ASC)"
TOPICS_ANEW = "CREATE TABLE new AS SELECT {} FROM topics; DROP TABLE topics; ALTER TABLE new RENAME TO topics"


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (
            "UPDATE messages SET timestamp = 'x' WHERE id = 3",
            "a message has a time or topic that is not an int",
        ),
        (
            "UPDATE messages SET timestamp = 1.5 WHERE id = 3",
            "a message has a time or topic that is not an int",
        ),
        (TOPICS_ANEW.format("id, type"), "table of topics has no column name, serialization_format"),
        (
            TOPICS_ANEW.format("'a' || id AS id, name, type, serialization_format"),
            "a topic has an id that is not an integer",
        ),
        ("CREATE TABLE message_definitions(a)", "the database can't be read: no such column"),
        (ENDLESS, "the database has no tables of a recording"),
        (VIRTUAL, "the database has no tables of a recording"),
        (GENERATED, "the database generates the column messages.data, which no recorder does"),
        (
            "ALTER TABLE topics ADD COLUMN type_description_hash2 AS (hex(zeroblob(400000000)))",
            "the database generates the column topics.type_description_hash2",
        ),
    ],
)
def test_database_of_another_form_is_an_error(change: str, text: str, tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE[:9])
    change_database(path, change)
    with pytest.raises(BagError, match=text):
        open_bag(path)


def test_names_that_are_not_utf_8_are_an_error(tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE[:9])
    change_database(path, "ALTER TABLE topics ADD COLUMN hallo TEXT; CREATE TABLE welten(a)")
    whole = path.read_bytes()
    for name in (b"hallo", b"welten", b"/chatter"):
        path.write_bytes(whole.replace(name, b"\xff\xfe" + name[2:]))
        with pytest.raises(BagError, match=r"a\.db3: the database (can't be read|is damaged): .*UTF-8"):
            open_bag(path)


def test_few_messages_are_in_memory_at_once(tmp_path: Path) -> None:
    size = 1 << 20
    path = write_sqlite(tmp_path / "a.db3", [("/chatter", START + i, bytes(size)) for i in range(40)])
    bag = open_bag(path)
    tracemalloc.start()
    try:
        assert sum(1 for _ in bag.messages()) == 40
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 8 * size


def test_messages_that_are_compressed_one_by_one(tmp_path: Path) -> None:
    folder = tmp_path / "bag"
    folder.mkdir()
    compress = zstandard.ZstdCompressor().compress
    write_sqlite(folder / "bag_0.db3", [(topic, stamp, compress(data)) for topic, stamp, data in DRIVE])
    golden = Path(__file__).parents[1] / "golden" / "bags" / "sqlite3" / "metadata.yaml"
    text = golden.read_text("utf-8").replace("b6_0.db3", "bag_0.db3")
    text = text.replace('compression_format: ""', "compression_format: zstd")
    text = text.replace('compression_mode: ""', "compression_mode: MESSAGE")
    (folder / "metadata.yaml").write_text(text, "utf-8")
    assert found_in(open_bag(folder)) == DRIVE
    assert frames(folder).has_frame("lidar")
    for damaged in ("0102030405", "", "28b52ffd"):
        change_database(folder / "bag_0.db3", f"UPDATE messages SET data = x'{damaged}' WHERE id = 4")
        with pytest.raises(BagError, match="the message isn't compressed by zstd"):
            found_in(open_bag(folder))


if sys.platform == "win32":  # pragma: no cover
    pytestmark = pytest.mark.skip(reason="Windows holds files that are open")


def without_index(path: Path, change: Callable[[sqlite3.Connection], object]) -> None:
    """Give a database an index of times, and change it while that is away and doesn't follow."""
    with closing(sqlite3.connect(path)) as database, database:
        database.execute(TIME_INDEX)
        database.execute("PRAGMA writable_schema = ON")
        row = database.execute("SELECT * FROM sqlite_master WHERE name = 'timestamp_idx'").fetchone()
        database.execute("DELETE FROM sqlite_master WHERE name = 'timestamp_idx'")
    with closing(sqlite3.connect(path)) as database, database:
        change(database)
        database.execute("PRAGMA writable_schema = ON")
        database.execute("INSERT INTO sqlite_master VALUES (?, ?, ?, ?, ?)", row)


def test_messages_that_the_index_of_times_lacks_are_read(tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE)
    with open_bag(path) as bag:
        expected = [(message.log_time_ns, message.data) for message in bag.messages()]
    copy = "INSERT INTO messages (topic_id, timestamp, data) SELECT topic_id, timestamp, data FROM messages"
    without_index(path, lambda database: database.execute(copy))
    with pytest.warns(
        BagWarning, match=r"a\.db3: the database is damaged: its index of times has \d+ messages"
    ):
        found = [(message.log_time_ns, message.data) for message in open_bag(path).messages()]
    assert sorted(found) == sorted(expected * 2)
    assert [stamp for stamp, _ in found] == sorted(stamp for stamp, _ in found)


def test_index_of_times_that_is_out_of_order_is_told_of(tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE)
    change_database(path, TIME_INDEX)
    stamp = max(stamp for _, stamp, _ in DRIVE)
    data = path.read_bytes()
    place = data.rindex(struct.pack(">q", stamp))  # in the index, whose pages are the last ones
    path.write_bytes(data[:place] + struct.pack(">q", START) + data[place + 8 :])
    with pytest.warns(
        BagWarning, match="its index of times isn't in order, so messages come in another order"
    ):
        assert len(list(open_bag(path).messages())) == len(DRIVE)


def test_messages_that_an_index_of_times_hides_are_counted(tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE)
    change_database(path, TIME_INDEX)
    stamps = sorted({stamp for _, stamp, _ in DRIVE})
    data = path.read_bytes()
    # Those in the middle, by which the first ones are looked for.
    for stamp in stamps[len(stamps) * 2 // 5 : len(stamps) * 3 // 5]:
        place = data.rindex(struct.pack(">q", stamp))
        data = data[:place] + struct.pack(">q", -1) + data[place + 8 :]
    path.write_bytes(data)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = list(open_bag(path).messages())
    assert len(found) < len(DRIVE)
    reason = f"{len(DRIVE) - len(found)} messages aren't found by its index of times"
    assert reason in str(caught[-1].message)


@pytest.mark.parametrize(
    ("change", "count", "reason"),
    [
        ("topic_id = 99 WHERE id IN (4, 5)", 2, "are of topics that it doesn't name"),
        ("timestamp = -1 WHERE id = 4", 1, "have times before 1970"),
    ],
)
def test_messages_that_are_left_out_are_told_of(change: str, count: int, reason: str, tmp_path: Path) -> None:
    path = write_sqlite(tmp_path / "a.db3", DRIVE)
    change_database(path, f"UPDATE messages SET {change}")
    with pytest.warns(BagWarning, match=f"{count} messages {reason}, and are left out"):
        assert len(rows_of(path)) == len(DRIVE) - count
