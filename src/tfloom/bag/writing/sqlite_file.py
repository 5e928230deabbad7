"""A file in rosbag2's sqlite3 format, schema version 4."""

from __future__ import annotations

import sqlite3
from contextlib import suppress
from pathlib import Path

from tfloom._native import Chunk
from tfloom.bag.writing.metadata_text import METADATA_VERSION
from tfloom.bag.writing.storage import StorageSettings, TopicTable
from tfloom.ros_imports.ros_distro import ROS_DISTRO

__all__ = ["SqliteFile"]

_TABLES = (
    "schema(schema_version INTEGER PRIMARY KEY,ros_distro TEXT NOT NULL)",
    "metadata(id INTEGER PRIMARY KEY,metadata_version INTEGER NOT NULL,metadata TEXT NOT NULL)",
    (
        "topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format TEXT NOT NULL,"
        "offered_qos_profiles TEXT NOT NULL,type_description_hash TEXT NOT NULL)"
    ),
    (
        "message_definitions(id INTEGER PRIMARY KEY,topic_type TEXT NOT NULL,encoding TEXT NOT NULL,"
        "encoded_message_definition TEXT NOT NULL,type_description_hash TEXT NOT NULL)"
    ),
    "messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL, data BLOB NOT NULL)",
)
_INDEX = "CREATE INDEX timestamp_idx ON messages (timestamp ASC)"
_SCHEMA_VERSION = 4
_PRAGMAS = ("synchronous=OFF", "journal_mode=WAL", "wal_autocheckpoint=1")
"""`synchronous` comes first, because `journal_mode` would else wait until the empty database is on the disk.

Each transaction goes on from the log into the database at once, so that the log needs room for one of them only: a full
disk would else hold half of what it could."""


class SqliteFile:
    """A database that is being written; see `StorageFile`.

    It has a log beside it until it is closed (`-wal`), so that a program that is killed leaves it whole.
    """

    def __init__(self, path: Path, topics: TopicTable, settings: StorageSettings, metadata: str) -> None:
        self._path = path
        self._topics = topics
        self._settings = settings
        self._written_channels: set[int] = set()
        self._types: set[str] = set()
        self._size = 0
        path.open("xb").close()
        self._database: sqlite3.Connection | None = None
        with _named(path):
            database = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
            try:
                self._begin(database, metadata)
            except BaseException:
                database.close()
                raise
        self._database = database

    def _begin(self, database: sqlite3.Connection, metadata: str) -> None:
        for pragma in (*_PRAGMAS, *self._settings.pragmas):
            database.execute(f"PRAGMA {pragma}")
        with database:
            for table in _TABLES:
                database.execute(f"CREATE TABLE {table}")
            database.execute(_INDEX)
            database.execute("INSERT INTO schema VALUES (?, ?)", (_SCHEMA_VERSION, ROS_DISTRO))
            self._insert_metadata(database, metadata)

    @property
    def size(self) -> int:
        """Size of what is written [bytes]."""
        return self._size

    def write(self, chunk: Chunk) -> None:
        """Write the messages of a chunk, all or none."""
        database = self._database
        if database is None:
            raise ValueError("the file is closed")
        rows = [(number, log_ns, data) for number, log_ns, _, data in chunk.messages()]
        with _named(self._path):
            # The topics of new channels are rows of the same transaction. A rollback removes them with the messages,
            # so what is noted of them must go back, too, or the next try would leave them out.
            channels, types = self._written_channels.copy(), self._types.copy()
            database.execute("BEGIN")
            try:
                self._add_topics(database, [number for number, _ in chunk.counts()])
                database.executemany("INSERT INTO messages(topic_id,timestamp,data) VALUES (?, ?, ?)", rows)
                database.execute("COMMIT")
            except BaseException:
                # sqlite itself has rolled back after some errors, and refuses to do so again.
                with suppress(sqlite3.Error):
                    database.execute("ROLLBACK")
                self._written_channels, self._types = channels, types
                raise
        self._size += sum(len(data) + 32 for _, _, data in rows)

    def close(self, metadata: str) -> None:
        """Write the metadata and the topics without messages, remove the log, and close the file."""
        database = self._database
        if database is None:
            return
        self._database = None
        with _named(self._path):
            try:
                database.execute("BEGIN")
                self._add_topics(database, list(self._topics.present()))
                self._insert_metadata(database, metadata)
                database.execute("COMMIT")
                # This takes what is left in the log into the database, and removes the log. It must follow the commit:
                # the mode can't be changed within a transaction.
                database.execute("PRAGMA journal_mode=DELETE")
            finally:
                database.close()

    def _add_topics(self, database: sqlite3.Connection, numbers: list[int]) -> None:
        for number in numbers:
            if number in self._written_channels:
                continue
            self._written_channels.add(number)
            topic = self._topics[number]
            database.execute(
                "INSERT INTO topics VALUES (?, ?, ?, ?, ?, ?)",
                (
                    *(number, topic.name, topic.type, topic.serialization_format),
                    *(topic.offered_qos, topic.type_hash),
                ),
            )
            if topic.type not in self._types:
                self._types.add(topic.type)
                encoding, text = topic.definition or ("unknown", "")
                database.execute(
                    "INSERT INTO message_definitions"
                    "(topic_type,encoding,encoded_message_definition,type_description_hash) VALUES (?, ?, ?, ?)",
                    (topic.type, encoding, text, topic.type_hash),
                )

    @staticmethod
    def _insert_metadata(database: sqlite3.Connection, metadata: str) -> None:
        database.execute(
            "INSERT INTO metadata(metadata_version,metadata) VALUES (?, ?)", (METADATA_VERSION, metadata)
        )


class _named:  # noqa: N801 - a context manager that is used as a function
    """Raise sqlite's errors as OSError, with the path."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def __enter__(self) -> None:
        """Do nothing: only what the block raises matters."""

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, sqlite3.Error):
            raise OSError(0, str(error), str(self._path)) from error
