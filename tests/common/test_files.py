"""Files that appear complete or not at all, on a disk that is really full, too; and files that are no regular ones."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import psutil
import pytest
from tests.conftest import run_to_end

from tfloom.common.files import Replacement, open_regular, read_at_most, write_file

IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


IN_A_NAMESPACE = (
    "unshare",
    "-Urm",
    "sh",
    "-c",
    'mount -t tmpfs -o size=64k tmpfs "$1" && shift && exec "$@"',
    "sh",
)


def run_on_a_small_disk(folder: Path, program: str) -> list[str]:
    """Run a program in `folder`, a disk of 64 KiB of its own; return its lines. Skip the test where that can't be."""
    try:
        trial = run_to_end([*IN_A_NAMESPACE, folder, "true"])
    except FileNotFoundError:
        pytest.skip("its own disk needs the program unshare")
    if trial.returncode:
        pytest.skip(f"its own disk needs user namespaces: {trial.stderr.strip()}")
    command = [
        *IN_A_NAMESPACE,
        folder,
        sys.executable,
        "-c",
        f"import os\nos.chdir({str(folder)!r})\n{program}",
    ]
    done = run_to_end(command)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_a_full_disk_leaves_the_previous_file(tmp_path: Path) -> None:
    lines = run_on_a_small_disk(
        tmp_path,
        """
from tfloom.common.files import write_file
write_file("a", "old")
try:
    write_file("a", b"x" * 1_000_000)
except OSError as error:
    print(error.strerror, error.filename, open("a").read(), os.listdir())
""",
    )
    assert lines == ["No space left on device a old ['a']"]


def test_view_frames_on_a_full_disk_leaves_the_previous_files(tmp_path: Path) -> None:
    lines = run_on_a_small_disk(
        tmp_path,
        """
from argparse import Namespace
os.environ["RMW_IMPLEMENTATION"] = "tfloom_local"
from tfloom.node.client_library import init
from tfloom.node.node import Node
from tfloom.tf2_tools import view_frames
for name in ("out.gv", "out.pdf"):
    open(name, "w").write("old")
blocks = open("filler", "wb", buffering=0)
try:
    while blocks.write(bytes(1024)):
        pass
except OSError:
    pass
init()
options = Namespace(wait_time=0.0, output="out", formats=None, bag=None)
code = view_frames.run(Node("view_frames", enable_rosout=False), options)
print(code, open("out.gv").read(), open("out.pdf").read(), sorted(os.listdir()))
import sys
sys.stdout.flush()
""",
    )
    assert lines == ["1 old old ['filler', 'out.gv', 'out.pdf']"]


def test_a_package_that_does_not_fit_is_removed(tmp_path: Path) -> None:
    lines = run_on_a_small_disk(
        tmp_path,
        """
from pathlib import Path
from tfloom.cli.main import main
import sys
open("filler", "wb").write(bytes(60 * 1024))
sys.stderr = sys.stdout
print(main(["pkg", "create", "pack", "--description", "x" * 9000]), os.listdir())
""",
    )
    assert lines == ["can't write pack/package.xml: No space left on device", "1 ['filler']"]


def test_a_new_file_has_the_permissions_of_the_umask(tmp_path: Path) -> None:
    previous = os.umask(0o027)
    try:
        write_file(tmp_path / "a", "text")
    finally:
        os.umask(previous)
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o640
    assert (tmp_path / "a").read_text() == "text"


def test_a_replaced_file_keeps_its_permissions(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("old")
    (tmp_path / "a").chmod(0o604)
    write_file(tmp_path / "a", b"new")
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o604
    assert (tmp_path / "a").read_text() == "new"


def test_a_symbolic_link_stays(tmp_path: Path) -> None:
    (tmp_path / "there").mkdir()
    (tmp_path / "link").symlink_to("there/a")
    for text in ("new", "newer"):  # The link leads to no file, then to one.
        write_file(tmp_path / "link", text)
        assert (tmp_path / "link").is_symlink()
        assert (tmp_path / "there" / "a").read_text() == text
    assert [path.name for path in (tmp_path / "there").iterdir()] == ["a"]


def test_a_named_pipe_is_written_directly(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    read: list[str] = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    write_file(pipe, "text")
    reader.join()
    assert read == ["text"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_standard_output_is_written_directly(tmp_path: Path) -> None:
    program = "from tfloom.common.files import write_file\nwrite_file('/dev/stdout', 'text')\nprint('more')"
    with (tmp_path / "out").open("a") as out:
        subprocess.run([sys.executable, "-c", program], stdout=out, check=True)
    assert "more" in (tmp_path / "out").read_text()
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize(
    ("path", "reason"), [("missing/a", "No such file or directory"), (".", "Is a directory")]
)
def test_an_error_names_the_path_and_the_reason(path: str, reason: str, tmp_path: Path) -> None:
    with pytest.raises(OSError, match=reason) as caught:
        write_file(tmp_path / path, "text")
    assert caught.value.filename == str(tmp_path / path)
    assert list(tmp_path.iterdir()) == []


def test_a_full_device_is_named() -> None:
    with pytest.raises(OSError, match="No space left") as caught:
        write_file("/dev/full", "text")
    assert caught.value.filename == "/dev/full"


@pytest.mark.skipif(IS_ROOT, reason="root may write every file")
def test_a_file_that_may_not_be_written_stays(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("old")
    (tmp_path / "a").chmod(0o444)
    with pytest.raises(PermissionError):
        write_file(tmp_path / "a", "new")
    assert (tmp_path / "a").read_text() == "old"


@pytest.mark.skipif(IS_ROOT, reason="root may write every folder")
def test_a_file_in_a_folder_that_may_not_be_written_is_written_directly(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("old")
    tmp_path.chmod(0o555)
    try:
        write_file(tmp_path / "a", "new")
    finally:
        tmp_path.chmod(0o755)
    assert (tmp_path / "a").read_text() == "new"


def test_a_discarded_replacement_leaves_nothing(tmp_path: Path) -> None:
    replacement = Replacement(tmp_path / "a.mp4")
    assert replacement.partial.suffix == ".mp4"
    replacement.partial.write_text("half")
    replacement.discard()
    assert list(tmp_path.iterdir()) == []


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
