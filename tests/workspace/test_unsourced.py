"""Packages that a workspace holds, and that aren't found."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.workspace.conftest import write_files

from tfloom.cli import main as cli
from tfloom.workspace import ament, index
from tfloom.workspace.unsourced import how_to_find

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the commands are a POSIX shell's")


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a workspace that isn't sourced; the working directory is a folder in it."""
    monkeypatch.delenv(index.PREFIX_PATH_VARIABLE, raising=False)
    monkeypatch.setenv("SHELL", "/usr/bin/bash")
    inner = tmp_path / "src" / "repository"
    inner.mkdir(parents=True)
    monkeypatch.chdir(inner)
    return tmp_path


def install(workspace: Path, *, merged: bool) -> None:
    prefix = workspace / "install" if merged else workspace / "install" / "my_pkg"
    write_files(prefix / index.RESOURCE_INDEX, {"packages/my_pkg": ""})


@pytest.mark.parametrize("merged", [False, True])
@pytest.mark.parametrize(
    ("shell", "file"),
    [("/bin/bash", "setup.bash"), ("/bin/zsh", "setup.zsh"), ("/usr/bin/fish", "setup.bash")],
)
def test_a_built_package_wants_sourcing(
    shell: str, file: str, merged: bool, workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SHELL", shell)
    install(workspace, merged=merged)
    hint = how_to_find("my_pkg")
    assert hint == f"it is built, but not sourced in this terminal: source {workspace}/install/{file}"


@pytest.mark.parametrize("folder", ["my_pkg", "repository/my_pkg"])
def test_a_source_wants_building(folder: str, workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_files(workspace / "src" / folder, {"package.xml": ""})
    build = f"colcon build && source {workspace}/install/setup.bash"
    text = f"its source is in {workspace / 'src'}, but it isn't built: "
    assert how_to_find("my_pkg") == f"{text}cd {workspace} && {build}"
    monkeypatch.chdir(workspace)
    assert how_to_find("my_pkg") == f"{text}{build}"


@pytest.mark.parametrize("name", ["other", "", "/", "..", "*", "my_pkg/", "/tmp", "a\0b", "x" * 5000])
def test_what_no_workspace_holds_has_no_hint(name: str, workspace: Path) -> None:
    install(workspace, merged=True)
    assert how_to_find(name) == ""


@pytest.mark.parametrize(
    ("words", "first"),
    [
        (("run", "my_pkg", "x"), "Package 'my_pkg' not found\n"),
        (("pkg", "prefix", "my_pkg"), "Package not found\n"),
        (("pkg", "executables", "my_pkg"), "Package not found\n"),
    ],
)
def test_verbs_say_so(
    words: tuple[str, ...], first: str, workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    install(workspace, merged=False)
    assert cli.main([*words]) == 1
    assert capsys.readouterr().err == f"{first}{how_to_find('my_pkg')}\n"


@pytest.mark.parametrize(
    "look_up", [ament.get_package_prefix, ament.get_package_share_directory, ament.get_package_share_path]
)
def test_a_program_gets_a_note(look_up: Callable[[str], object], workspace: Path) -> None:
    with pytest.raises(ament.PackageNotFoundError) as raised:
        look_up("my_pkg")
    assert not hasattr(raised.value, "__notes__")
    install(workspace, merged=False)
    with pytest.raises(ament.PackageNotFoundError) as raised:
        look_up("my_pkg")
    assert str(raised.value) == (
        "package 'my_pkg' not found, no workspace is sourced in this terminal (AMENT_PREFIX_PATH is not set)"
    )
    assert raised.value.__notes__ == [how_to_find("my_pkg")]


def test_a_prefix_that_is_gone_is_no_sourced_workspace(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "gone"))
    with pytest.raises(ament.PackageNotFoundError, match="not found, no folder of AMENT_PREFIX_PATH exists"):
        ament.get_package_share_directory("nope")
