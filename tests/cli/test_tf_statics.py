"""`tf save`, `tf publish` and `tf diff`, over DDS."""

from __future__ import annotations

import json
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.tf2_tools.static_file import file_text, read_statics
from tfloom.tf2_tools.static_transform import StaticTransform

Run = Callable[..., tuple[int, str]]

ROBOT = [
    StaticTransform("base", "laser", (0.1, 0.0, 0.3), (0.0, 0.0, 0.6, 0.8)),
    StaticTransform("base", "雷射 1", (1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0)),
]
MOVED = [ROBOT[0]._replace(translation=(0.1, 0.05, 0.3)), StaticTransform("mast", "camera", *ROBOT[1][2:])]


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """Return the path of a file with two transforms."""
    path = tmp_path / "robot 1.yaml"
    path.write_text(file_text(ROBOT), "utf-8")
    return path


def test_published_statics_are_saved_and_compared(
    domain_id: int,
    start_program: Callable[..., Any],
    run_tf: Run,
    robot: Path,
    tmp_path: Path,
) -> None:
    publisher = start_program("tfloom", "tf", "publish", robot)
    publisher.wait_for("/static_transforms_robot_1: 2 static transforms on /tf_static, until Ctrl-C")
    saved = tmp_path / "saved.yaml"
    assert run_tf("save", saved) == (0, f"{saved}: 2 static transforms")
    assert read_statics(saved) == ROBOT
    assert run_tf("diff", robot, "live") == (0, "")
    moved = tmp_path / "moved.yaml"
    moved.write_text(file_text(MOVED), "utf-8")
    code, text = run_tf("diff", "live", moved)
    assert (code, text.splitlines()) == (
        1,
        [
            "--- live",
            f"+++ {moved}",
            "+ mast -> camera (static)",
            "! base -> laser: moved by 0.05 m and 0 deg",
            "- base -> 雷射 1 (static)",
        ],
    )
    publisher.signal(signal.SIGINT)
    assert publisher.wait() == 0


def test_statics_of_two_nodes_that_differ_are_saved_with_a_warning(
    domain_id: int,
    start_program: Callable[..., Any],
    run_tf: Run,
    robot: Path,
    tmp_path: Path,
) -> None:
    other = tmp_path / "other.yaml"
    other.write_text(file_text(MOVED[:1]), "utf-8")
    for path in (robot, other):
        start_program("tfloom", "tf", "publish", path).wait_for("until Ctrl-C")
    code, text = run_tf("save", "-")
    assert code == 0
    (warning,) = [line for line in text.splitlines() if line.startswith("WARNING")]
    assert "'laser' has different static transforms" in warning
    assert "/static_transforms_robot_1" in warning
    assert "/static_transforms_other" in warning


def test_a_graph_without_statics(domain_id: int, run_tf: Run, tmp_path: Path) -> None:
    path = tmp_path / "none.yaml"
    assert run_tf("save", path, "--wait", "0.1") == (1, "no static transform on /tf_static: waited 0.1 s")
    assert not path.exists()


def test_diff_of_files(run_tf: Run, robot: Path, tmp_path: Path) -> None:
    moved = tmp_path / "moved.yaml"
    moved.write_text(file_text([MOVED[0], ROBOT[1]]), "utf-8")
    assert run_tf("diff", robot, moved, "--translation", "0.06")[0] == 0
    code, text = run_tf("diff", robot, moved, "--json")
    (difference,) = json.loads(text)
    assert (code, difference["kind"], difference["child"]) == (1, "moved", "laser")
    assert difference["distance"] == pytest.approx(0.05)


def test_diff_of_what_cannot_be_read_is_trouble(run_tf: Run, robot: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.yaml"
    broken.write_text("static_transforms: 5", "utf-8")
    key = "a file of static transforms has one key, static_transforms, with a list of transforms"
    assert run_tf("diff", robot, broken) == (2, f"{broken}:1: {key}")
    missing = tmp_path / "missing.yaml"
    assert run_tf("diff", missing, robot) == (2, f"{missing}: No such file or directory")
    assert run_tf("diff", "live", "live")[0] == 2
    assert run_tf("publish", broken) == (1, f"{broken}:1: {key}")
