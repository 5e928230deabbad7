"""`ament_index_python.cli`: the resources of the ament index, printed."""

from __future__ import annotations

import argparse
from pathlib import Path

import pytest
from ament_index_python.cli import main, resource_name_completer, resource_type_completer
from tests.workspace.conftest import write_files

from tfloom.workspace.index import OWN_PREFIX


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    index = tmp_path / "share" / "ament_index" / "resource_index"
    write_files(index, {"packages/a": "", "packages/b": "", "plugins/a": "one;two"})
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    return tmp_path


def test_types_names_and_content_are_printed(prefix: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) is None
    assert capsys.readouterr().out == "packages\nplugins\nrosidl_interfaces\n"
    assert main(["packages"]) is None
    lines = capsys.readouterr().out.splitlines()
    assert lines == sorted(lines)
    assert {f"a\t{prefix}", f"b\t{prefix}", f"turtlesim\t{OWN_PREFIX}"} <= set(lines)
    assert main(["plugins", "a"]) is None
    assert capsys.readouterr().out == f"{prefix}\none;two\n"
    assert main(["packages", "a"]) is None
    assert capsys.readouterr().out == f"{prefix}\n"


@pytest.mark.parametrize(
    ("argv", "error"),
    [
        (["nope"], "No resources of the type 'nope'"),
        (["packages", "c"], "No resource 'c' of the type 'packages'"),
        (["a/b"], "Resource type 'a/b' is invalid"),
        (["packages", "../a"], "Resource name '../a' is invalid"),
    ],
)
def test_what_is_not_there_is_an_error(prefix: Path, argv: list[str], error: str) -> None:
    assert main(argv) == error


def test_completers(prefix: Path) -> None:
    assert resource_type_completer("pa") == ["packages"]
    assert resource_name_completer("", argparse.Namespace(resource_type="plugins")) == ["a"]
    assert resource_name_completer("turtle", argparse.Namespace(resource_type="packages")) == [
        "turtle_tf2_py",
        "turtlesim",
        "turtlesim_msgs",
    ]
    assert resource_name_completer("", argparse.Namespace()) == []
