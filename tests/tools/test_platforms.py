"""tools/platforms.py: what it reports; its parts take chroots and many minutes, so they run by `make platforms`."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import nullcontext, suppress
from pathlib import Path

import pytest
from tests.conftest import Program, has_ended, run_to_end, wait_until
from tools import platforms
from tools.platforms import Chroot, Row, measured, total_counts
from tools.set_up import SetUpError


def test_counts_of_both_parts_of_a_tier_are_added() -> None:
    lines = [
        "3 passed in 1.00s",
        "SKIPPED [1] a.py:2: 7 passed over",
        "=== 1 failed, 40 passed, 2 skipped, 1 rerun in 61.00s ===",
    ]
    assert total_counts(lines) == "43 passed, 1 failed, 2 skipped, 1 rerun"
    assert total_counts(["nothing ran"]) == ""


def test_failing_check_is_a_row_with_its_reason() -> None:
    def fail() -> tuple[bool, str]:
        raise SetUpError("mmdebstrap failed")

    row = measured("Debian", "installed", fail)
    assert row == Row("Debian", "installed", "mmdebstrap failed", row.seconds, is_good=False)


@pytest.mark.skipif(sys.platform != "linux", reason="needs root on Linux")
def test_what_is_missing_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["platforms"])
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    assert platforms.main() == 3
    assert "it must be root on Linux" in capsys.readouterr().err
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr("shutil.which", lambda _: None)
    assert platforms.main() == 3
    expected = "apt-get install mmdebstrap qemu-user-static g++-aarch64-linux-gnu"
    assert expected in capsys.readouterr().err


def test_chosen_tests_exist() -> None:
    """In a chroot, a renamed file would be noticed after a quarter of an hour."""
    chosen = [*platforms.TESTS.values(), *platforms.TESTS_ON_ARM64.values(), platforms.SHORT_TESTS]
    chosen += [*platforms.TESTS_ON_DDS_0_10, *platforms.TESTS_ON_MUSL.values()]
    words = {word for paths in chosen for word in paths.split()} - {"--deselect"}
    missing = [word for word in words if not (platforms.ROOT / word.partition("::")[0]).exists()]
    assert missing == []


def test_mounts_are_of_the_command_alone(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Or /dev of this machine would stay in a folder that the next run removes."""
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)
    command = Chroot("arm64", "arm64").command("true")
    assert command[:2] == ["unshare", "--mount"]
    assert str(tmp_path / "arm64") in command


def test_library_is_back_after_a_demonstration_without_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)
    chroot = Chroot("arm64", "arm64")
    library = chroot.folder / "usr/lib/aarch64-linux-gnu/libddsc.so.0.10.5"
    library.parent.mkdir(parents=True)
    library.touch()
    with suppress(KeyboardInterrupt), platforms.without_library(chroot):
        assert [path.name for path in library.parent.iterdir()] == ["away.libddsc.so.0.10.5"]
        raise KeyboardInterrupt
    assert library.exists()


@pytest.mark.parametrize(("has_library", "said"), [(True, False), (False, True)])
def test_demonstration_must_say_what_it_found(
    has_library: bool, said: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)
    line = "No DDS library (libddsc) can be used, so all programs run within this process: install one"

    def run_in(chroot: Chroot, text: str, log: str) -> tuple[bool, str]:
        platforms.log_path(chroot, log).write_text(f"TF2 with turtles\n{line}\nAt time 0.0\n")
        return True, "ran"

    monkeypatch.setattr(platforms, "run_in", run_in)
    assert platforms.demo_on_arm64(Chroot("arm64", "arm64"), has_library=has_library) == (said, line)


def test_two_runs_at_once_go_one_after_the_other(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The second one would remove the chroots of the first."""
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)
    monkeypatch.setattr(platforms, "missing_tools", lambda: "")
    monkeypatch.setattr(sys, "argv", ["platforms", "arm64"])
    code = f"import sys; sys.path.insert(0, {str(platforms.ROOT)!r}); from pathlib import Path\n"
    code += "from tools.set_up import only_one\nwith only_one(Path(sys.argv[1])): print('in')"
    others: list[str] = []

    def run(*, is_short: bool) -> list[Row]:
        with subprocess.Popen(
            [sys.executable, "-c", code, tmp_path], stdout=subprocess.PIPE, text=True
        ) as other:
            assert other.stdout is not None
            others.append(other.stdout.readline())
            other.kill()
        return []

    monkeypatch.setitem(platforms.PARTS, "arm64", run)
    assert platforms.main() == 0
    assert others[0].startswith("-- Waiting for another set-up")


class FakeBinfmt:
    """The folder of binfmt_misc, as the kernel has it: entries appear and go by what is written."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.is_mounted = False
        self.refusal: OSError | None = None

    def run(self, command: list[str | Path], _: object = None) -> None:
        self.is_mounted = command[0] == "mount"
        for path in self.folder.iterdir():
            path.unlink()
        if self.is_mounted:
            for name in ("register", "status"):
                (self.folder / name).write_text("enabled")

    def tell(self, file: Path, text: str) -> None:
        if file.name != "register":
            assert text == "-1"
            file.unlink()
            return
        if self.refusal:
            raise self.refusal
        _, name, _, _, magic, _, _, flags = text.split(":")
        octets = magic.encode().decode("unicode_escape").encode("latin-1")
        self.add(name, flags, octets.hex())

    def add(self, name: str, flags: str, magic: str, state: str = "enabled") -> None:
        lines = (
            state,
            "interpreter /usr/bin/qemu-aarch64-static",
            f"flags: {flags}",
            "offset 0",
            f"magic {magic}",
        )
        (self.folder / name).write_text("\n".join(lines))

    def entries(self) -> list[str]:
        return sorted(entry.name for entry in self.folder.iterdir())


ARM64 = "7f454c460201010000000000000000000200b700"


@pytest.fixture
def binfmt(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> FakeBinfmt:
    fake = FakeBinfmt(tmp_path)
    monkeypatch.setattr(platforms, "BINFMT", tmp_path)
    monkeypatch.setattr(platforms, "succeed", fake.run)
    monkeypatch.setattr(platforms, "tell_kernel", fake.tell)
    return fake


@pytest.mark.parametrize("error", [None, SetUpError, OSError, KeyboardInterrupt, SystemExit])
def test_binfmt_is_as_it_was(binfmt: FakeBinfmt, error: type[BaseException] | None) -> None:
    with pytest.raises(error) if error else nullcontext(), platforms.arm64_programs():
        assert binfmt.is_mounted
        assert any(map(platforms.runs_arm64, platforms.registrations()))
        if error:
            raise error
    assert not binfmt.is_mounted


def test_refused_registration_is_an_error_and_nothing_stays_mounted(binfmt: FakeBinfmt) -> None:
    binfmt.refusal = PermissionError(1, "Operation not permitted")
    with (
        pytest.raises(SetUpError, match=r"can't be registered in .*not permitted"),
        platforms.arm64_programs(),
    ):
        pass
    assert not binfmt.is_mounted


def test_registration_of_the_machine_is_used_and_kept(binfmt: FakeBinfmt) -> None:
    binfmt.run(["mount"])
    binfmt.add("qemu-aarch64", "POCF", ARM64)
    with platforms.arm64_programs():
        assert binfmt.entries() == ["qemu-aarch64", "register", "status"]
    assert binfmt.is_mounted
    assert binfmt.entries() == ["qemu-aarch64", "register", "status"]


@pytest.mark.parametrize(
    ("flags", "magic", "state"),
    [("OC", ARM64, "enabled"), ("F", ARM64, "disabled"), ("F", ARM64.replace("b7", "f3"), "enabled")],
    ids=["of this root folder alone", "disabled", "of another processor"],
)
def test_registration_that_would_not_do_is_left_alone(
    binfmt: FakeBinfmt, flags: str, magic: str, state: str
) -> None:
    binfmt.run(["mount"])
    binfmt.add("qemu", flags, magic, state)
    with platforms.arm64_programs():
        assert len(platforms.registrations()) == 2
    assert binfmt.is_mounted
    assert binfmt.entries() == ["qemu", "register", "status"]


def test_binfmt_stays_mounted_while_another_program_registers_there(binfmt: FakeBinfmt) -> None:
    with platforms.arm64_programs():
        binfmt.add("another", "F", ARM64)
    assert binfmt.is_mounted
    assert binfmt.entries() == ["another", "register", "status"]


NEEDS_TOOLS = pytest.mark.skipif(bool(reason := platforms.missing_tools()), reason=reason)
INTERRUPTED = """
import subprocess, sys
from pathlib import Path
from tools import platforms

def run(*, is_short):
    with platforms.arm64_programs():
        platforms.completed(["sh", "-c", f"sleep 1000 & echo $! > {folder}/pid; wait"], stdout=subprocess.DEVNULL)

folder = Path(sys.argv.pop())
platforms.PARTS["arm64"], platforms.FOLDER = run, folder
sys.exit(platforms.main())
"""


@NEEDS_TOOLS
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_interrupted_run_leaves_nothing(
    number: signal.Signals, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    """Neither a mount, nor a registration, nor a process."""

    def state() -> tuple[str, list[Path]]:
        is_mounted = (platforms.BINFMT / "register").exists()
        ours = [entry for entry in platforms.registrations() if str(program.process.pid) in entry.name]
        return Path("/proc/self/mounts").read_text(), ours if is_mounted else []

    before = Path("/proc/self/mounts").read_text()
    program = start_program("python", "-c", INTERRUPTED, "arm64", tmp_path, cwd=platforms.ROOT)
    wait_until(lambda: (tmp_path / "pid").exists() and (tmp_path / "pid").read_text() != "")
    sleeper = int((tmp_path / "pid").read_text())
    try:
        assert len(state()[1]) <= 1
        program.signal(number)
        assert program.wait() in {128 + signal.SIGTERM, 130, -signal.SIGINT}, program.output
        assert state() == (before, [])
        wait_until(lambda: has_ended(sleeper))
    finally:
        with suppress(ProcessLookupError):
            os.killpg(os.getpgid(sleeper), signal.SIGKILL)


@NEEDS_TOOLS
def test_programs_left_in_a_chroot_are_ended(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, start_program: Callable[..., Program]
) -> None:
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)
    chroot = Chroot("arm64", "arm64")
    chroot.folder.mkdir()
    inside = 'mount --bind / "$0" && exec chroot "$0" sh -c "echo ready; exec sleep 1000"'
    there = start_program("unshare", "--mount", "sh", "-c", inside, chroot.folder)
    here = start_program("sh", "-c", "echo ready; exec sleep 1000")
    for program in (there, here):
        program.wait_for("ready")
    chroot.end_programs()
    assert there.wait() == -signal.SIGKILL
    assert here.process.poll() is None


def test_part_that_fails_early_is_a_row(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)  # or the programs of a run at work would be ended

    def run(*, is_short: bool) -> list[Row]:
        raise SetUpError("qemu can't be registered")

    monkeypatch.setitem(platforms.PARTS, "arm64", run)
    assert platforms.run_part("arm64", is_short=True) == [
        Row("arm64", "prepared", "qemu can't be registered", 0.0, is_good=False)
    ]


def test_short_run_leaves_out_what_takes_long() -> None:
    checks = [
        platforms.Check("short", lambda: (True, "ran")),
        platforms.Check("long", lambda: (True, "ran"), is_short=False),
    ]
    assert [row.what for row in platforms.run_all("Debian", checks, is_short=True)] == ["short"]
    assert [row.what for row in platforms.run_all("Debian", checks, is_short=False)] == ["short", "long"]


def test_advice_for_a_python_without_a_wheel_is_what_is_run() -> None:
    """The error and two pages say the command that the chroots of newer Pythons run."""
    command = platforms.WHEEL_OF_ANOTHER_PYTHON
    assert command.replace("DIR", "/tmp/cyclonedds") in platforms.other_wheel()
    assert command in (platforms.ROOT / "docs" / "platforms.md").read_text("utf-8")
    source = (platforms.ROOT / "src" / "tfloom" / "rmw" / "cyclone" / "library.py").read_text("utf-8")
    assert command in re.sub(r'"\s+f?"', "", source)


@pytest.mark.slow
@NEEDS_TOOLS
@pytest.mark.skipif(
    "CI" in os.environ and "TFLOOM_PLATFORMS" not in os.environ,
    reason="takes minutes, too long where CI is set; TFLOOM_PLATFORMS=1 runs it",
)
@pytest.mark.parametrize("part", ["testing", "arm64"])
def test_short_checks_of_a_system(part: str) -> None:
    """The demonstration on Debian's newest Python, and on arm64 also a talk with this machine."""
    command = [sys.executable, "-m", "tools.platforms", "--short", part]
    done = run_to_end(command, cwd=platforms.ROOT, timeout_s=2000.0)
    if ": installed: mmdebstrap failed" in done.stdout:
        pytest.skip(f"Debian can't be installed here: {done.stdout}")
    assert done.returncode == 0, done.stdout + done.stderr
