"""Messages and transforms of a sqlite3 file, of schema versions 1 to 4."""

from __future__ import annotations

import shutil
import sqlite3
import tempfile
import warnings
from collections.abc import Collection, Iterator, Mapping
from contextlib import closing, contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.metadata import is_message_compression
from tfloom.bag.reading.file_bytes import check_is_file
from tfloom.bag.reading.stored_messages import StoredMessages
from tfloom.bag.values import EARLIEST, LATEST, MAY_BE_EMPTY, Definition, RawMessage, Topic

__all__ = ["SqliteFile"]

SIGNATURE = b"SQLite format 3\0"
_TOPIC_COLUMNS = {"id", "name", "type", "serialization_format"}
"""Of all schema versions."""
_LEAST = -(1 << 63)
"""The least integer of a database."""
_READ_TABLES = {"topics", "messages", "metadata", "message_definitions"}
_BESIDE = ("-wal", "-shm", "-journal")


class SqliteFile(StoredMessages):
    """A file of a recording. It is open while it is read only.

    Args:
        path: The file.
        is_message_compressed: Whether each message is compressed by itself, by zstd; None: as the file's metadata says.

    Raises:
        BagError: it is not a recording of sqlite3, or damaged.
        OSError: it can't be read.
    """

    def __init__(self, path: Path, is_message_compressed: bool | None = None) -> None:
        self.path = path
        _check_signature(path)
        with self._open() as database:
            tables = _tables(database)
            if not {"topics", "messages"} <= tables:
                raise BagError(path, "the database has no tables of a recording: topics, messages")
            if generated := _generated(database, tables):
                raise BagError(path, f"the database generates the column {generated}, which no recorder does")
            rows = database.execute(
                "SELECT topic_id, COUNT(*), MIN(timestamp), MAX(timestamp), "
                "SUM(typeof(topic_id) != 'integer' OR typeof(timestamp) != 'integer'), SUM(timestamp < 0) "
                "FROM messages GROUP BY topic_id"
            ).fetchall()
            if any(row[4] for row in rows):
                raise BagError(
                    path, "the database is damaged: a message has a time or topic that is not an integer"
                )
            self._counts = {row[0]: row[1] for row in rows}
            indexed = _count_indexed(database)
            if missing := sorted(_TOPIC_COLUMNS - set(_columns(database, "topics"))):
                raise BagError(path, f"the database's table of topics has no column {', '.join(missing)}")
            self._topics = _topics(database, self._counts)
            if not all(isinstance(topic_id, int) for topic_id in self._topics):
                raise BagError(path, "the database is damaged: a topic has an id that is not an integer")
            says_compressed = "metadata" in tables and _says_compressed(database)
            definitions = _definitions(database) if "message_definitions" in tables else {}
        self._definitions = definitions
        self.is_message_compressed = (
            says_compressed if is_message_compressed is None else is_message_compressed
        )
        self.message_count = sum(self._counts.values())
        self._has_whole_index = indexed is None or indexed == self.message_count
        if not self._has_whole_index:
            reason = f"its index of times has {indexed} messages, and its table {self.message_count}"
            self._warn(f"{reason}; they are read without the index")
        if unknown := sum(count for key, count in self._counts.items() if key not in self._topics):
            self._warn(f"{unknown} messages are of topics that it doesn't name, and are left out")
        self._early = {row[0]: row[5] for row in rows}
        if early := sum(self._early.values()):
            self._warn(f"{early} messages have times before 1970, and are left out")
        self.start_ns = min((row[2] for row in rows), default=0)
        self.end_ns = max((row[3] for row in rows), default=0)

    @cached_property
    def topics(self) -> list[Topic]:
        """The topics, one for each name."""
        return [
            topic._replace(definition=self._definitions.get(topic.type)) for topic in self._topics.values()
        ]

    @contextmanager
    def _open(self) -> Iterator[sqlite3.Connection]:
        """Open the database for the block; raise BagError for errors of sqlite3."""
        try:
            with _connected(self.path) as database:
                yield database
        except sqlite3.Error as error:
            raise BagError(self.path, f"the database can't be read: {error}") from None
        except UnicodeDecodeError:  # of a column's name
            raise BagError(self.path, "the database is damaged: a name in it isn't UTF-8") from None

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: the file is damaged.
        """
        names = {
            key: topic.name for key, topic in self._topics.items() if topics is None or topic.name in topics
        }
        # A damaged index may lack rows or have them in another order, and sqlite3 answers from it without a word. So
        # the order is watched as the rows come, and where all messages are read, their number is compared at the end.
        with self._open() as database:
            latest = start_ns
            is_told = False
            count = 0
            for topic, stamp, data in _rows(
                database, names, start_ns, end_ns, uses_index=self._has_whole_index
            ):
                if stamp < latest and not is_told:
                    is_told = True
                    self._warn("its index of times isn't in order, so messages come in another order")
                latest = stamp
                count += 1
                yield RawMessage(names[topic], stamp, stamp, self._message(data))
        if (start_ns, end_ns) == (EARLIEST, LATEST):
            missing = sum(self._counts.get(key, 0) for key in names) - self._early_count(names) - count
            if missing:
                self._warn(f"{missing} messages aren't found by its index of times")

    def _early_count(self, topics: Collection[int]) -> int:
        """Return how many messages of topics are left out because of their times; a warning has reported them."""
        return sum(count for key, count in self._early.items() if key in topics)

    def _warn(self, reason: str) -> None:
        text = f"{self.path}: the database is damaged: {reason}"
        warnings.warn(BagWarning(text), stacklevel=2)

    def _message(self, data: Any) -> bytes:
        if not isinstance(data, bytes):
            raise BagError(self.path, f"a message is not a blob but {type(data).__name__}")
        return super()._message(data)


def _check_signature(path: Path) -> None:
    for suffix in _BESIDE:  # sqlite3 opens them too
        if (beside := path.with_name(f"{path.name}{suffix}")).exists():
            check_is_file(beside)
    with path.open("rb") as file:
        start = file.read(len(SIGNATURE))
    if not start:
        raise BagError(path, "the file is empty: its recorder ended before it wrote anything")
    if start != SIGNATURE:
        raise BagError(path, f"this is not a sqlite3 file: it begins with {start!r}", 0)


@contextmanager
def _connected(path: Path) -> Iterator[sqlite3.Connection]:
    """Open a database for the block, in a folder that needn't be writable.

    Messages that a recorder has not yet moved into the file are in `…-wal` beside it. To read them, sqlite3 writes
    another file beside both, so both are copied where it can't.
    """
    # Three ways, from the best to the one that always works. The first reads the log where it is, but in a folder that
    # isn't writable, sqlite3 can't make its file beside a log.
    with _opened(path, "mode=ro") as database:
        try:
            database.execute("SELECT name FROM sqlite_master").fetchone()
        except sqlite3.OperationalError:
            pass
        else:
            yield database
            return
    log = path.with_name(f"{path.name}-wal")
    # Without a log, the file has all messages, and is opened as one that nobody changes: no other file is needed.
    if not log.exists() or not log.stat().st_size:
        with _opened(path, "immutable=1") as database:
            yield database
        return
    # With a log, the copies are opened for writing, in a folder that is writable.
    with tempfile.TemporaryDirectory(prefix="tfloom-bag-") as folder:
        for file in (path, log):
            shutil.copy(file, folder)
        with _opened(Path(folder) / path.name, "mode=rw") as database:
            yield database


@contextmanager
def _opened(path: Path, mode: str) -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(f"{path.absolute().as_uri()}?{mode}", uri=True)) as database:
        yield database


def _tables(database: sqlite3.Connection) -> set[str]:
    """Return the tables that have their own rows.

    Views and virtual tables have none, and their evaluation may take any time and memory.
    """
    rows = database.execute("SELECT name FROM sqlite_master WHERE type = 'table' AND rootpage > 0")
    return {name for (name,) in rows}


def _generated(database: sqlite3.Connection, tables: set[str]) -> str:
    """Return a column that is computed as it is read, which may take any time and memory; empty if there is none."""
    for table in sorted(_READ_TABLES & tables):
        for _, name, *_, hidden in database.execute(f"PRAGMA table_xinfo({table})"):
            if hidden:
                return f"{table}.{name}"
    return ""


def _columns(database: sqlite3.Connection, table: str) -> list[str]:
    return [row[1] for row in database.execute(f"PRAGMA table_info({table})")]


def _count_indexed(database: sqlite3.Connection) -> int | None:
    """Return how many messages the index has by which they are read in the order of time; None if there is none.

    Reading by an index that lacks a part of the table would lose that part in silence.
    """
    columns = {
        name: [row[2] for row in database.execute(f"PRAGMA index_info({_quoted(name)})")]
        for _, name, *_ in database.execute("PRAGMA index_list(messages)")
    }
    name = next((name for name, names in columns.items() if names == ["timestamp"]), None)
    if name is None:
        return None
    (count,) = database.execute(
        f"SELECT COUNT(timestamp) FROM messages INDEXED BY {_quoted(name)} WHERE timestamp >= ?",  # noqa: S608
        (_LEAST,),
    ).fetchone()
    return int(count)


def _quoted(name: str) -> str:
    return '"' + name.replace('"', '""') + '"'


def _topics(database: sqlite3.Connection, counts: Mapping[int, int]) -> dict[int, Topic]:
    """Return the topics by their ids; early versions lack some columns."""
    topics = {}
    columns = _columns(database, "topics")
    for row in database.execute("SELECT * FROM topics"):
        values = dict(zip(columns, row, strict=False))
        topics[values["id"]] = Topic(
            str(values["name"]),
            str(values["type"]),
            str(values["serialization_format"]),
            str(values.get("type_description_hash") or ""),
            str(values.get("offered_qos_profiles") or ""),
            message_count=counts.get(values["id"], 0),
        )
    return topics


def _definitions(database: sqlite3.Connection) -> dict[str, Definition]:
    rows = database.execute(
        "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions"
    )
    return {
        str(name): Definition(str(encoding), str(text))
        for name, encoding, text in rows
        if text or encoding == MAY_BE_EMPTY
    }


def _says_compressed(database: sqlite3.Connection) -> bool:
    row = database.execute("SELECT metadata FROM metadata ORDER BY id DESC LIMIT 1").fetchone()
    return row is not None and is_message_compression(str(row[0]))


def _rows(
    database: sqlite3.Connection, topics: Collection[int], start_ns: int, end_ns: int, *, uses_index: bool
) -> Iterator[tuple[int, int, Any]]:
    ids = ",".join(str(int(topic_id)) for topic_id in topics)
    cursor = database.execute(
        f"SELECT topic_id, timestamp, data FROM messages {'' if uses_index else 'NOT INDEXED '}"  # noqa: S608
        f"WHERE topic_id IN ({ids}) "  # integers
        "AND timestamp BETWEEN ? AND ? ORDER BY timestamp, id",
        (start_ns, end_ns),
    )
    yield from cursor  # one by one, because messages may be large
