"""tools/platforms.py: what it reports; its parts take chroots and many minutes, so they run by `make platforms`."""

from __future__ import annotations

import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from tools import platforms
from tools.platforms import Chroot, Row, measured, total_counts
from tools.set_up import SetUpError


def test_counts_of_both_parts_of_a_tier_are_added() -> None:
    lines = [
        "3 passed in 1.00s",
        "SKIPPED [1] a.py:2: 7 passed over",
        "=== 1 failed, 40 passed, 2 skipped in 61.00s ===",
    ]
    assert total_counts(lines) == "43 passed, 1 failed, 2 skipped"
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
    missing = [path for paths in chosen for path in paths.split() if not (platforms.ROOT / path).exists()]
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


def test_short_run_leaves_out_what_takes_long() -> None:
    checks = [
        platforms.Check("short", lambda: (True, "ran")),
        platforms.Check("long", lambda: (True, "ran"), is_short=False),
    ]
    assert [row.what for row in platforms.run_all("Debian", checks, is_short=True)] == ["short"]
    assert [row.what for row in platforms.run_all("Debian", checks, is_short=False)] == ["short", "long"]


@pytest.mark.slow
@pytest.mark.skipif(
    not os.environ.get("TFLOOM_PLATFORMS"), reason="TFLOOM_PLATFORMS isn't set: it makes chroots"
)
@pytest.mark.skipif(bool(reason := platforms.missing_tools()), reason=reason)
@pytest.mark.parametrize("part", ["testing", "arm64"])
def test_short_checks_of_a_system(part: str) -> None:
    """The demonstration on Debian's newest Python, and on arm64 also a talk and the paths for its processor."""
    command = [sys.executable, "-m", "tools.platforms", "--short", part]
    done = subprocess.run(command, cwd=platforms.ROOT, capture_output=True, text=True, check=False)
    if ": installed: mmdebstrap failed" in done.stdout:
        pytest.skip(f"Debian can't be installed here: {done.stdout}")
    assert done.returncode == 0, done.stdout + done.stderr
