"""The ament index: precedence of prefixes, and detection of programs."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from tests.workspace.conftest import write_files

from tfloom.workspace import index


def make_package(prefix: Path, name: str, *programs: str) -> None:
    write_files(prefix, {f"{index.RESOURCE_INDEX}/packages/{name}": ""})
    write_files(prefix / "lib" / name, dict.fromkeys(programs, "#!/bin/sh\nexit 0\n"))
    for program in programs:
        (prefix / "lib" / name / program).chmod(0o755)


@pytest.fixture
def prefixes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    folders = [tmp_path / "overlay", tmp_path / "underlay"]
    for folder in folders:
        folder.mkdir()
    path = os.pathsep.join(map(str, [folders[0], tmp_path / "gone", folders[1], ""]))
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, path)
    return folders


def test_only_folders_that_exist_are_searched(prefixes: list[Path]) -> None:
    assert index.search_paths() == [str(prefix) for prefix in prefixes]


def test_first_prefix_takes_precedence(prefixes: list[Path]) -> None:
    overlay, underlay = prefixes
    make_package(underlay, "a_pkg")
    make_package(underlay, "b_pkg")
    make_package(overlay, "b_pkg")
    assert index.workspace_packages() == {"a_pkg": str(underlay), "b_pkg": str(overlay)}
    assert index.find_package("b_pkg") == str(overlay)
    assert index.find_package("c_pkg") is None


def test_name_with_a_path_separator_is_invalid(prefixes: list[Path]) -> None:
    make_package(prefixes[0], "a_pkg")
    assert index.find_package("../packages/a_pkg") is None
    assert index.find_package("") is None


def test_programs_are_executable_files_at_any_depth(prefixes: list[Path]) -> None:
    make_package(prefixes[0], "a_pkg", "zeta", "deep/alpha")
    (prefixes[0] / "lib" / "a_pkg" / "notes.txt").write_text("no program")
    (prefixes[0] / "lib" / "a_pkg" / "folder").mkdir()
    programs = index.package_programs("a_pkg", str(prefixes[0]))
    assert [index.program_name(path) for path in programs] == ["zeta", "alpha"]


def test_no_workspace_has_no_packages(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(index.PREFIX_PATH_VARIABLE, raising=False)
    assert index.search_paths() == []
    assert index.workspace_packages() == {}
