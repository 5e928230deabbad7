"""tools/platforms.py: what it reports; its parts take chroots and many minutes, so they run by `make platforms`."""

from __future__ import annotations

import os
import sys
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


def test_mounts_are_of_the_command_alone(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Or /dev of this machine would stay in a folder that the next run removes."""
    monkeypatch.setattr(platforms, "FOLDER", tmp_path)
    command = Chroot("arm64", "arm64").command("true")
    assert command[:2] == ["unshare", "--mount"]
    assert str(tmp_path / "arm64") in command
