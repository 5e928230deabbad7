"""The doors with ROS's names on them: thin, typed, last on the path, and never half of a mixture."""

from __future__ import annotations

import ast
import importlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROS_NAMES = Path(__file__).parents[1] / "src" / "tfloom" / "ros_names"
PACKAGES = sorted(path for path in ROS_NAMES.iterdir() if path.is_dir() and path.name != "__pycache__")
MODULES = sorted(ROS_NAMES.rglob("*.py"))


def dotted(path: Path) -> str:
    return ".".join(path.relative_to(ROS_NAMES).with_suffix("").parts).removesuffix(".__init__")


def python(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        env=os.environ | environment,
    )


@pytest.mark.parametrize("package", PACKAGES, ids=lambda path: path.name)
def test_a_facade_is_a_typed_package(package: Path) -> None:
    assert (package / "__init__.py").is_file()
    assert (package / "py.typed").is_file()


def test_nothing_stands_beside_the_facades() -> None:
    assert not [path.name for path in ROS_NAMES.iterdir() if path.is_file()]


@pytest.mark.parametrize("path", MODULES, ids=dotted)
def test_a_facade_only_hands_on(path: Path) -> None:
    """Its statements are a docstring, imports from the house, `__all__`, and the claim of its name."""
    for node in ast.parse(path.read_text("utf-8")).body:
        where = f"{path.relative_to(ROS_NAMES)}:{node.lineno}"
        if isinstance(node, ast.ImportFrom):
            assert node.module, where
            assert node.module.split(".")[0] in {"tfloom", "__future__"}, where
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            assert ast.unparse(node.value.func) == "claim", where
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            target = node.targets[0] if isinstance(node, ast.Assign) else node.target
            assert ast.unparse(target) == "__all__", where
        else:
            assert isinstance(node, (ast.Expr, ast.Import)), where


@pytest.mark.parametrize("path", MODULES, ids=dotted)
def test_a_facade_imports_and_exports_what_it_names(path: Path) -> None:
    module = importlib.import_module(dotted(path))
    assert Path(module.__file__) == path
    missing = [name for name in getattr(module, "__all__", []) if not hasattr(module, name)]
    assert not missing


def test_a_real_ros_comes_first(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("REAL = True\n")
    result = python("import rclpy; print(rclpy.REAL)", PYTHONPATH=str(tmp_path))
    assert result.stdout == "True\n", result.stderr


def test_a_mixture_with_a_real_ros_fails_and_says_from_where(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("")
    result = python("import tf2_ros", PYTHONPATH=str(tmp_path))
    assert result.returncode == 1
    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError"), result.stderr
    assert str(tmp_path) in last, result.stderr


def test_use_ros_names_serves_where_no_pth_is_read() -> None:
    source = str(ROS_NAMES.parents[1])
    native = importlib.import_module("tfloom._native").__file__
    code = (
        "import importlib.util, sys\n"
        f"sys.path[:0] = [{source!r}] + {[p for p in sys.path if p.endswith('site-packages')]!r}\n"
        f"spec = importlib.util.spec_from_file_location('tfloom._native', {native!r})\n"
        "import tfloom\n"
        "module = sys.modules['tfloom._native'] = importlib.util.module_from_spec(spec)\n"
        "spec.loader.exec_module(module)\n"
        "tfloom.use_ros_names(); tfloom.use_ros_names()\n"
        "import geometry_msgs.msg, rclpy\n"
        "print(sys.path[-1].endswith('ros_names'), sys.path.count(sys.path[-1]))\n"
    )
    result = subprocess.run(
        [sys.executable, "-S", "-c", code], capture_output=True, text=True, timeout=60, check=False
    )
    assert result.stdout == "True 1\n", result.stderr
