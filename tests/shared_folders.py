"""Folders of one run of the tests that the processes which run them in parallel share."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest


@contextmanager
def shared_folder(factory: pytest.TempPathFactory, name: str) -> Iterator[Path]:
    """Yield the folder of this name of the run, and keep other processes out of it for the block.

    On Windows, where files can't be locked by `flock`, each process has its own folder.
    """
    root = factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ and sys.platform != "win32":
        root = root.parent
    folder = root / name
    folder.mkdir(exist_ok=True)
    if sys.platform == "win32":
        yield folder
        return
    import fcntl

    with (root / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # until it is closed
        yield folder
