"""Files whose names come from outside."""

from __future__ import annotations

import os
from pathlib import Path

import psutil
import pytest

from tfloom.common.regular_files import open_regular, read_at_most


def test_regular_file_is_read_up_to_a_limit(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes(bytes(3 * 2**20))
    for most, expected in (
        (3 * 2**20, 3 * 2**20),
        (3 * 2**20 + 1, 3 * 2**20),
        (3 * 2**20 - 1, None),
        (0, None),
    ):
        with open_regular(path) as file:
            content = read_at_most(file, most)
            assert (None if content is None else len(content)) == expected
    path.write_bytes(b"")
    with open_regular(path) as file:
        assert read_at_most(file, 0) == b""


@pytest.mark.skipif(os.name != "posix", reason="Windows has no such files")
def test_other_files_are_refused_at_once_and_leave_no_descriptor(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "zero").symlink_to("/dev/zero")
    before = psutil.Process().num_fds()
    for name in ("pipe", "zero"):
        with pytest.raises(OSError, match="not a regular file"):
            open_regular(tmp_path / name)
    for name in ("", "none"):
        with pytest.raises(OSError, match=str(tmp_path)):
            open_regular(tmp_path / name)
    assert psutil.Process().num_fds() == before


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="this system has no /proc")
def test_file_that_tells_no_size_has_the_limit_too() -> None:
    with open_regular(Path("/proc/self/status")) as file:
        assert os.fstat(file.fileno()).st_size == 0
        assert read_at_most(file, 100) is None
    with open_regular(Path("/proc/self/status")) as file:
        content = read_at_most(file, 100_000)
        assert content is not None
        assert content.startswith(b"Name:")
