"""`.ci/`: which Pythons of a machine `matrix` runs the core tests on, and that what the scripts name is there."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NEEDED = ("bash", "dirname", "git", "sh")

pytestmark = pytest.mark.skipif(
    any(shutil.which(command) is None for command in NEEDED), reason="the script needs bash and git"
)


def chosen(
    folder: Path, usual: str, there: Sequence[str], *names: str, default: str = "python3"
) -> list[str]:
    """Return what the script prints on a machine with these Pythons, where the program `default` is `usual`."""
    programs = folder / "bin"
    programs.mkdir()
    for command in NEEDED:
        (programs / command).symlink_to(str(shutil.which(command)))
    # A Python of another version is not needed: the script asks them only whether they are free-threaded.
    scripts = {f"python{version}": f'exec {shlex.quote(sys.executable)} "$@"' for version in there}
    scripts[default] = f'case "$1" in --version) echo Python {usual}.1 ;; *) echo {usual} ;; esac'
    for name, text in scripts.items():
        (programs / name).write_text(f"#!/bin/sh\n{text}\n")
        (programs / name).chmod(0o755)
    environment = {"PATH": str(programs), "PYENV_ROOT": str(folder), "NAME_ONLY": "1", "HOME": str(folder)}
    if default != "python3":
        environment["PYTHON"] = str(programs / default)
    # The clone may belong to somebody else.
    environment |= {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "safe.directory", "GIT_CONFIG_VALUE_0": "*"}
    environment |= {name: os.environ[name] for name in ("LD_LIBRARY_PATH",) if name in os.environ}
    done = subprocess.run(
        [ROOT / ".ci" / "matrix", *names], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout.splitlines()


@pytest.mark.parametrize(
    ("usual", "there", "newest", "others"),
    [
        ("3.11", ["3.10", "3.11", "3.13", "3.14"], "3.14", {"3.10", "3.13"}),
        ("3.11", ["3.10", "3.11"], None, {"3.10"}),
        ("3.11", ["3.11", "3.15"], "3.15", set()),
        ("3.11", ["3.11"], None, set()),
        ("3.16", ["3.14", "3.15"], "3.15", {"3.14"}),
    ],
)
def test_newest_and_another(
    usual: str, there: list[str], newest: str | None, others: set[str], tmp_path: Path
) -> None:
    missing = f"on this machine, beside Python {usual}.1"
    lines = chosen(tmp_path, usual, there, "newest", "other")
    assert lines[0] == (f"newest is {newest}" if newest else f"== There is no newest Python {missing}")
    expected = {f"other is {version}" for version in others} or {f"== There is no other Python {missing}"}
    assert lines[1] in expected
    assert len(lines) == 2


def test_default_python_may_have_a_space_in_its_path(tmp_path: Path) -> None:
    lines = chosen(tmp_path, "3.11", ["3.14"], "newest", "other", default="my python")
    assert lines == ["newest is 3.14", "== There is no other Python on this machine, beside Python 3.11.1"]


def test_no_name_is_all_versions(tmp_path: Path) -> None:
    versions = [line.split()[0] for line in chosen(tmp_path, "3.11", [])]
    assert versions == ["3.10", "3.11", "3.12", "3.13", "3.14", "3.15", "3.13t", "3.14t"]


def test_each_path_that_a_script_of_the_ci_names_is_there() -> None:
    """A stage that is seldom run, as that of newer libraries, would fail for want of a folder that was moved."""
    names = {
        name
        for script in (ROOT / ".ci").iterdir()
        for name in re.findall(r"(?<![\w/])(?:tests|tools|docs)/[\w/.]*\w", script.read_text("utf-8"))
    }
    assert {"tests/foxglove", "tests/test_walk.py", "tools/set_up.py"} <= names
    assert [name for name in sorted(names) if not (ROOT / name).exists()] == []
