"""Recordings of which every write fails once in turn: what was acknowledged is readable, and the failure is told."""

from __future__ import annotations

import errno
import io
import os
import re
import resource
import signal
import sqlite3
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.bag.recordings import found_in
from tests.bag.written_bags import STEP_NS, Row, begin_bag, push, row

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError, BagWarning
from tfloom.bag.reading.compression import COMPRESSED_SUFFIX
from tfloom.bag.reindexing import reindex
from tfloom.bag.writing import bag_writer, mcap_file, sqlite_file
from tfloom.bag.writing.bag_writer import WriterSettings
from tfloom.bag.writing.storage import StorageSettings
from tfloom.bag.writing.storage_config import PRESETS

SMALL = StorageSettings(chunk_size=150)
SETTINGS = {
    "mcap": WriterSettings(storage=SMALL),
    "mcap, several files": WriterSettings(storage=SMALL, max_file_size=700),
    "mcap, without chunks": WriterSettings(storage=PRESETS["mcap"]["fastwrite"]._replace(chunk_size=150)),
    "mcap, split by time": WriterSettings(storage=SMALL, max_file_duration_ns=7 * STEP_NS),
    "mcap, compressed messages": WriterSettings(storage=SMALL, compression_mode="MESSAGE"),
    "mcap, compressed chunks": WriterSettings(storage=PRESETS["mcap"]["zstd_fast"]._replace(chunk_size=150)),
    "mcap, compressed files": WriterSettings(storage=SMALL, max_file_size=700, compression_mode="FILE"),
    "sqlite3": WriterSettings("sqlite3", SMALL),
    "sqlite3, several files": WriterSettings("sqlite3", SMALL, max_file_size=700),
    "sqlite3, compressed files": WriterSettings("sqlite3", SMALL, max_file_size=700, compression_mode="FILE"),
}
FAULTS = {"ENOSPC": errno.ENOSPC, "EINTR": errno.EINTR, "short": 0}
CASES = [
    *((name, "ENOSPC") for name in SETTINGS),
    *(("mcap, compressed files", fault) for fault in ("EINTR", "short")),
    ("mcap, without chunks", "short"),
]
"""Only a file goes on after a short write, and only its buffer after EINTR; a database does neither."""
MESSAGES = 12
MAX_SIZE = 60_000
"""Of files on a disk that is full [bytes]."""


class Faults:
    """Lets the write of one number fail, counted over all files of a recording."""

    def __init__(self, fails_at: int, code: int) -> None:
        self.fails_at = fails_at
        self.code = code
        self.count = 0
        self.is_repeated = False
        """Whether the write that failed is repeated at once, as by a buffered file after EINTR."""

    @property
    def is_due(self) -> bool:
        """Whether this write fails."""
        self.count += 1
        return self.count == self.fails_at

    def error(self) -> OSError:
        """Return what the failing write raises."""
        return OSError(self.code, os.strerror(self.code))


def faulty_file(faults: Faults, *, is_buffered: bool = False) -> type[io.FileIO]:
    """Return a file of which half of a failing write arrives.

    A buffer before it repeats a write after EINTR, and goes on after a short one.
    """

    class FaultyFile(io.FileIO):
        def write(self, data: Any) -> int:
            if not faults.is_due:
                return super().write(data)
            if is_buffered and faults.code == errno.EINTR:
                faults.is_repeated = True
                raise faults.error()
            half = super().write(bytes(data)[: (len(data) + 1) // 2])
            if faults.code:
                raise faults.error()
            return half

    return FaultyFile


def faulty_database(faults: Faults) -> type[sqlite3.Connection]:
    """Return a connection whose statements fail; of many rows, half are inserted."""

    class FaultyDatabase(sqlite3.Connection):
        def _fail(self) -> None:
            if faults.code:
                is_full = faults.code == errno.ENOSPC
                raise sqlite3.OperationalError("database or disk is full" if is_full else "disk I/O error")

        def execute(self, *args: Any) -> sqlite3.Cursor:
            if faults.is_due:
                self._fail()
            return super().execute(*args)

        def executemany(self, sql: str, rows: Any) -> sqlite3.Cursor:
            if faults.is_due and faults.code:
                super().executemany(sql, rows[: len(rows) // 2])
                self._fail()
            return super().executemany(sql, rows)

    return FaultyDatabase


@contextmanager
def full_at(size: int) -> Iterator[None]:
    """Let no file of this process grow beyond a size [bytes]."""
    before, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


def plant(faults: Faults, patched: pytest.MonkeyPatch) -> None:
    write_file = bag_writer.write_file

    def write_metadata(*args: Any) -> None:
        if faults.is_due and faults.code:
            raise faults.error()
        write_file(*args)

    open_path = Path.open

    def open_file(path: Path, mode: str = "r", *args: Any, **options: Any) -> Any:
        if mode == "xb" and path.suffix == COMPRESSED_SUFFIX:
            return io.BufferedWriter(faulty_file(faults, is_buffered=True)(path, "x"))
        return open_path(path, mode, *args, **options)

    patched.setattr(Path, "open", open_file)
    connect = partial(sqlite3.connect, factory=faulty_database(faults))
    patched.setattr(mcap_file, "io", SimpleNamespace(FileIO=faulty_file(faults)))
    patched.setattr(sqlite_file, "sqlite3", SimpleNamespace(connect=connect, Error=sqlite3.Error))
    patched.setattr(bag_writer, "write_file", write_metadata)


def record(
    folder: Path, settings: WriterSettings, messages: int = MESSAGES
) -> tuple[list[Row], list[BagError]]:
    """Record until a failure; return what was acknowledged, and the failures."""
    acknowledged: list[Row] = []
    told: list[BagError] = []
    try:
        writer, channel = begin_bag(folder, settings)
    except BagError as error:
        return [], [error]
    try:
        for number in range(messages):
            push(writer, channel, number)
            acknowledged.append(row(number))
    except BagError as error:
        told.append(error)
    try:
        writer.close()
    except BagError as error:
        told.append(error)
    return acknowledged, told


def read(folder: Path) -> list[Row]:
    """Return what is in a bag, after what its errors advise."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", BagWarning)
        if not (folder / "metadata.yaml").exists():
            reindex(folder)
        with open_bag(folder) as bag:
            rows = found_in(bag)
            assert bag.message_count == len(rows)
            return rows


@pytest.mark.parametrize(("name", "fault"), CASES)
def test_every_write_fails_once(
    name: str, fault: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    faults = Faults(0, FAULTS[fault])
    while faults.count >= faults.fails_at:
        faults = Faults(faults.fails_at + 1, FAULTS[fault])
        folder = tmp_path / f"bag{faults.fails_at}"
        with monkeypatch.context() as patched:
            plant(faults, patched)
            acknowledged, told = record(folder, SETTINGS[name])
        place = f"write {faults.fails_at}"
        has_failed = faults.code and faults.count >= faults.fails_at and not faults.is_repeated
        assert bool(told) == bool(has_failed), place
        if not folder.exists():  # not begun
            assert not acknowledged
            continue
        found = read(folder)
        assert found[: len(acknowledged)] == acknowledged, place
        assert found[len(acknowledged) :] in ([], [row(len(acknowledged))]), place  # the push that told it
    assert faults.fails_at > 8  # else the writes are not those of the files


@pytest.mark.parametrize(
    ("storage_id", "reason"),
    [("mcap", "File too large"), ("sqlite3", "(disk I/O error|database or disk is full)")],
)
def test_full_disk_is_used_up_and_keeps_what_was_committed(
    storage_id: str, reason: str, tmp_path: Path
) -> None:
    folder = tmp_path / "bag"
    with full_at(MAX_SIZE):
        acknowledged, told = record(
            folder, WriterSettings(storage_id, StorageSettings(chunk_size=1000)), 10_000
        )
    assert len(told) == 2
    for error in told:
        assert re.search(
            rf"bag_0\.\w+: it can't be written: {reason}\. What was recorded .* bag reindex", str(error)
        )
    found = read(folder)
    assert found == [row(number) for number in range(len(found))]
    assert len(acknowledged) - len(found) < 20  # those of the chunk that did not fit, which was told
    assert len(found) > 300  # of 100 bytes each, or 60


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EIO])
def test_failed_write_leaves_no_part_of_it(
    code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    faults = Faults(0, code)
    plant(faults, monkeypatch)
    writer, channel = begin_bag(tmp_path / "bag", WriterSettings(storage=SMALL))
    size = writer.file_path.stat().st_size
    faults.fails_at = faults.count + 3  # of the chunk's parts: head, definitions, messages
    push(writer.queue, channel, 0)
    with pytest.raises(BagError, match=os.strerror(code)):
        writer.write_present()
    assert faults.count == faults.fails_at
    assert writer.file_path.stat().st_size == size
    writer.close()
    assert read(tmp_path / "bag") == [row(0)]
