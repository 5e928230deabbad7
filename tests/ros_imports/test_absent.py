"""The import of a module that tfloom has nothing of names what to do instead, unless somebody has such a module."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end

from tfloom import use_ros_names
from tfloom.ros_imports.absent import INSTEAD


def python(code: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return run_to_end([sys.executable, "-c", code], cwd=folder)


@pytest.mark.parametrize(
    ("line", "name"),
    [("from tf.transformations import euler_matrix", "tf"), *((f"import {name}", name) for name in INSTEAD)],
)
def test_import_names_what_to_do_instead(line: str, name: str, tmp_path: Path) -> None:
    run = python(line, tmp_path)
    text = f"ModuleNotFoundError: No module named {name!r}: {INSTEAD[name]}"
    assert run.stderr.splitlines()[-1] == text
    assert run.stderr.count("  File ") == 2  # the program's, and ours


def test_a_program_that_has_a_plan_without_it_goes_on(tmp_path: Path) -> None:
    code = """
try:
    import rospy
except ImportError as error:
    print(error.name)
import sys
assert "rospy" not in sys.modules
try:
    import rosp
except ImportError as error:
    print(error)
"""
    assert python(code, tmp_path).stdout == "rospy\nNo module named 'rosp'\n"


def test_a_search_finds_no_module(tmp_path: Path) -> None:
    (tmp_path / "looks_for_it.py").write_text(
        "from importlib.util import find_spec\nprint(find_spec('tf'), find_spec('rospy'))\n"
    )
    code = """
import importlib, pkgutil
import looks_for_it
print(pkgutil.find_loader("tf") if hasattr(pkgutil, "find_loader") else None)
for name in ("tf", "rospy"):
    try:
        importlib.import_module(name)
    except ModuleNotFoundError as error:
        print("ROS 1" in str(error))
"""
    assert python(code, tmp_path).stdout == "None None\nNone\nTrue\nTrue\n"


def test_a_module_of_the_name_takes_precedence(tmp_path: Path) -> None:
    (tmp_path / "tf.py").write_text("here = True\n")
    run = python("import tf, sys; print(tf.here, 'tfloom.ros_imports.absent' in sys.modules)", tmp_path)
    assert run.stdout == "True False\n"


def test_nothing_is_loaded_before_it_is_needed(tmp_path: Path) -> None:
    assert python("import sys; print('tfloom' in sys.modules)", tmp_path).stdout == "False\n"


def test_use_ros_names_does_so_where_no_pth_file_was_read(monkeypatch: pytest.MonkeyPatch) -> None:
    finders = [finder for finder in sys.meta_path if not getattr(finder, "finds_absent", False)]
    monkeypatch.setattr(sys, "meta_path", finders)
    use_ros_names()
    use_ros_names()
    assert len([finder for finder in sys.meta_path if getattr(finder, "finds_absent", False)]) == 1
    with pytest.raises(ModuleNotFoundError, match="import rclpy"):
        import rospy  # type: ignore[import-not-found]  # noqa: F401
