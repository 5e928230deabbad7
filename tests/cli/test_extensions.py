"""Commands and verbs that installed packages add to the command."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.cli.extensions import install, run_cli, run_here
from tests.conftest import run_to_end

ENTRY_POINTS = {
    "ros2topic.verb": {"first": "my_extensions:FirstVerb", "echo": "my_extensions:FirstVerb"},
    "ros2cli.command": {"tree": "my_extensions:TreeCommand"},
    "ros2tree.verb": {"grow": "my_extensions:GrowVerb"},
    "ros2cli.extension_point": {"ros2tree.verb": "ros2cli.verb:VerbExtension"},
}


def test_verb_and_command_are_in_the_help(tmp_path: Path) -> None:
    install(tmp_path, ENTRY_POINTS)
    topic = run_here(tmp_path, "topic", "-h")
    (line,) = (line for line in topic.stdout.splitlines() if line.split()[:1] == ["first"])
    assert (line.split(maxsplit=1)[1], topic.stderr) == ("Print the first topics", "")
    assert topic.stdout.count("\n    echo ") == 1
    assert "    tree                Show trees\n" in run_here(tmp_path, "-h").stdout
    assert "first" not in run_here(tmp_path, "node", "-h").stdout


def test_command_runs_its_verb(tmp_path: Path) -> None:
    install(tmp_path, ENTRY_POINTS)
    grown = run_here(tmp_path, "tree", "grow", "7")
    assert (grown.returncode, grown.stdout, grown.stderr) == (3, "grow to 7\n", "")
    shown = run_here(tmp_path, "tree")
    assert shown.returncode == 0
    assert "    grow                Let a tree grow\n" in shown.stdout
    assert run_here(tmp_path, "tree", "fell").returncode == 2
    assert "usage: ros2 tree grow" in run_here(tmp_path, "tree", "grow", "-h").stdout


@pytest.mark.wire
def test_verb_asks_the_graph_and_ends_on_its_own_errors(
    tmp_path: Path, domain_id: int, start_program: Callable[..., Any]
) -> None:
    install(tmp_path, ENTRY_POINTS)
    start_program(sys.executable, "-m", "tfloom", "topic", "pub", "/a_topic", "std_msgs/msg/String").wait_for(
        "publishing #1"
    )
    first = run_cli(tmp_path, "topic", "first")
    assert (first.returncode, first.stdout, first.stderr) == (0, "/a_topic ['std_msgs/msg/String']\n", "")
    failed = run_here(tmp_path, "topic", "first", "--fail")
    assert (failed.returncode, failed.stdout, failed.stderr) == (1, "", "no topics today\n")


def test_broken_extension_is_a_line_and_the_others_run(tmp_path: Path) -> None:
    broken = {
        **ENTRY_POINTS["ros2topic.verb"],
        "gone": "no_such_module:Verb",
        "new": "my_extensions:TooNewVerb",
    }
    install(tmp_path, {**ENTRY_POINTS, "ros2topic.verb": broken})
    topic = run_here(tmp_path, "topic", "-h")
    assert "    first " in topic.stdout
    assert "    gone " not in topic.stdout
    assert topic.stderr.splitlines() == [
        (
            "WARNING: the extension 'gone' of ros2topic.verb (no_such_module:Verb) can't be loaded: "
            "ModuleNotFoundError: No module named 'no_such_module'"
        ),
        (
            "WARNING: the extension 'new' of ros2topic.verb (my_extensions:TooNewVerb) can't be loaded: "
            "PluginException: Extension point version '0.1' is too small for '^0.2'"
        ),
    ]
    gone = run_here(tmp_path, "topic", "gone")
    assert (gone.returncode, gone.stdout) == (1, "")
    assert gone.stderr.startswith("the extension 'gone' of ros2topic.verb ")


def test_there_are_none_beside_another_rclpy(tmp_path: Path) -> None:
    install(tmp_path, ENTRY_POINTS)
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").touch()
    topic = run_cli(tmp_path, "topic", "-h")
    assert "first" not in topic.stdout
    assert topic.stderr == ""


def test_known_verb_looks_for_no_extensions(tmp_path: Path) -> None:
    install(tmp_path, {"ros2pkg.verb": {"gone": "no_such_module:Verb"}})
    code = (
        "import sys; from tfloom.cli.main import main; main(['pkg', 'prefix', 'turtlesim']); "
        "print('importlib.metadata' in sys.modules)"
    )
    done = run_to_end([sys.executable, "-c", code], env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert done.stdout.endswith("False\n"), done.stderr


def test_loaded_entry_points_leave_out_broken_ones(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    from ros2cli.entry_points import get_all_entry_points, load_entry_points
    from ros2cli.plugin_system import instantiate_extensions
    from ros2cli.verb import get_verb_extensions

    install(
        tmp_path,
        {**ENTRY_POINTS, "ros2tree.verb": {**ENTRY_POINTS["ros2tree.verb"], "gone": "no_such_module:V"}},
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    assert list(load_entry_points("ros2tree.verb")) == ["grow"]
    assert "Failed to load entry point 'gone' of ros2tree.verb: ModuleNotFoundError" in caplog.text
    assert set(get_all_entry_points()["ros2tree.verb"]) == {"grow", "gone"}
    (grow,) = get_verb_extensions("ros2tree.verb").values()
    assert (grow.NAME, instantiate_extensions("ros2tree.verb")["grow"] is grow) == ("grow", True)
    assert instantiate_extensions("ros2tree.verb", exclude_names=["grow"]) == {}


@pytest.mark.parametrize(
    ("version", "is_in"), [("0.1", True), ("0.1.9", True), ("0.2", False), ("0.0.9", False)]
)
def test_versions_in_a_carets_range(version: str, is_in: bool) -> None:
    from ros2cli.plugin_system import PluginException, satisfies_version

    if is_in:
        satisfies_version(version, "^0.1")
    else:
        with pytest.raises(PluginException, match=f"'{version}' is too"):
            satisfies_version(version, "^0.1")
