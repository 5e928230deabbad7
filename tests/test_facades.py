"""The façades with ROS's names: re-exports only, typed, last on the path, and never mixed with a real ROS.

Each rule is a function over a folder of façades that yields the violations.
"""

from __future__ import annotations

import ast
import importlib
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tools.facades import rooms
from tools.facades.generate import Generator
from tools.facades.table import Facade, Package, TableError, read_table

from tfloom.rosidl.class_modules import DefinitionModule

ROS_NAMES = Path(__file__).parents[1] / "src" / "tfloom" / "ros_names"
Rule = Callable[[Path], Iterator[str]]


def dotted(path: Path, folder: Path) -> str:
    return ".".join(path.relative_to(folder).with_suffix("").parts).removesuffix(".__init__")


def modules(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.py"))


def python(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return run_to_end([sys.executable, "-c", code], env=os.environ | environment)


def not_typed_packages(folder: Path) -> Iterator[str]:
    """A façade is a package with type information."""
    for package in sorted(folder.iterdir()):
        if package.is_dir() and package.name != "__pycache__":
            for name in ("__init__.py", "py.typed"):
                if not (package / name).is_file():
                    yield f"{package.name} has no {name}"


def files_beside_the_facades(folder: Path) -> Iterator[str]:
    """The folder holds packages only."""
    yield from (f"{path.name} stands beside the façades" for path in folder.iterdir() if path.is_file())


def more_than_handing_on(folder: Path) -> Iterator[str]:
    """A façade's statements are a docstring, imports from the house, `__all__`, its claim, and what it defers."""
    for path in modules(folder):
        for node in ast.parse(path.read_text("utf-8")).body:
            if not hands_on(node):
                yield f"{path.relative_to(folder)}:{node.lineno}: {ast.unparse(node).splitlines()[0]}"


def hands_on(node: ast.stmt) -> bool:
    if ast.unparse(node) in {"from typing import TYPE_CHECKING", "TYPE_CHECKING = False"}:
        return True
    if isinstance(node, ast.If):
        return defers(node) or chooses(node)
    if isinstance(node, ast.ImportFrom):
        return (node.module or "").split(".")[0] in {"tfloom", "tfloom_sensing", "__future__"}
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        return ast.unparse(node.value.func) == "claim"
    if isinstance(node, (ast.Assign, ast.AnnAssign)):
        target = node.targets[0] if isinstance(node, ast.Assign) else node.target
        return ast.unparse(target) == "__all__"
    return isinstance(node, (ast.Expr, ast.Import))


def chooses(node: ast.If) -> bool:
    """Return whether a statement imports turtlesim's classes from the package of the distribution that is followed."""
    return ast.unparse(node.test) == "TYPE_CHECKING or _TURTLESIM_PACKAGE == 'turtlesim'" and all(
        isinstance(statement, ast.ImportFrom) and hands_on(statement)
        for statement in [*node.body, *node.orelse]
    )


def defers(node: ast.If) -> bool:
    """Return whether a statement imports for type checkers alone, and has a `__getattr__` for all others."""
    # Python 3.10 writes the targets of an assignment in parentheses.
    otherwise = [
        ast.unparse(statement).replace("(__getattr__, __dir__)", "__getattr__, __dir__").split("(")[0]
        for statement in node.orelse
    ]
    return (
        ast.unparse(node.test) == "TYPE_CHECKING"
        and all(isinstance(statement, ast.ImportFrom) for statement in node.body)
        and otherwise
        in (
            ["from tfloom.ros_imports.modules import deferred", "__getattr__, __dir__ = deferred"],
            ["from tfloom.ros_imports.modules import submodules", "__getattr__ = submodules"],
        )
    )


def deferred_otherwise_than_typed(folder: Path) -> Iterator[str]:
    """What loads when it is named is what type checkers are shown: the same names, of the same homes."""
    for path in modules(folder):
        for node in ast.parse(path.read_text("utf-8")).body:
            if not isinstance(node, ast.If) or not defers(node):
                continue
            imports = [statement for statement in node.body if isinstance(statement, ast.ImportFrom)]
            typed = {
                (alias.asname or alias.name, statement.module)
                for statement in imports
                for alias in statement.names
            }
            call = node.orelse[-1].value
            if call.func.id == "deferred":
                loaded = {(keyword.arg, keyword.value.value) for keyword in call.keywords}
            else:
                loaded = {(name, dotted(path, folder)) for name in submodules_of(path.parent)}
            yield from (
                f"{path.relative_to(folder)}: {name} of {home}" for name, home in sorted(typed ^ loaded)
            )


def submodules_of(package: Path) -> Iterator[str]:
    for path in package.iterdir():
        is_module = path.suffix == ".py" or (path / "__init__.py").is_file()
        if is_module and not path.name.startswith("__"):
            yield path.stem


def names_that_are_missing(folder: Path) -> Iterator[str]:
    """A façade can be imported, from this folder, and has what its `__all__` names."""
    for path in modules(folder):
        name = dotted(path, folder)
        try:
            module = importlib.import_module(name)
        except ImportError as error:
            yield f"{name}: {error}"
            continue
        # The module of a definition is there before its file, whose names it has.
        if Path(module.__file__) != path and not isinstance(module, DefinitionModule):
            yield f"{name} comes from {module.__file__}"
        yield from (
            f"{name} has no {exported_name}"
            for exported_name in getattr(module, "__all__", [])
            if not hasattr(module, exported_name)
        )


RULES: list[Rule] = [
    not_typed_packages,
    files_beside_the_facades,
    more_than_handing_on,
    deferred_otherwise_than_typed,
    names_that_are_missing,
]


def planted_generator(folder: Path, modules: dict[str, Facade], *, keeps_imports: bool = True) -> Generator:
    """Return the generator of a package `planted`, whose names are looked for in the modules of a folder."""
    table = {"planted": Package(("house.room",), keeps_imports, modules, folder="names")}
    return Generator(table, rooms.index_names(folder / "house"))


@pytest.fixture
def room(tmp_path: Path) -> Path:
    """Return a room of a house that has two functions, in a module of each."""
    folder = tmp_path / "house" / "room"
    folder.mkdir(parents=True)
    (folder / "left.py").write_text("__all__ = ['walk']\ndef walk(): ...\n")
    (folder / "right.py").write_text("__all__ = ['run']\ndef run(): ...\nTWICE = 1\n")
    return folder


def test_names_are_found_in_the_modules_that_define_them(room: Path, tmp_path: Path) -> None:
    modules = {"planted": Facade("All."), "planted.legs": Facade("Legs.", also=("TWICE", "run", "walk"))}
    files = planted_generator(tmp_path, modules).files()
    assert files["names/planted/legs.py"].splitlines()[3:] == [
        "from house.room.left import walk as walk",
        "from house.room.right import TWICE as TWICE",
        "from house.room.right import run as run",
    ]
    assert 'deferred(\n        __name__,\n        legs="planted",\n' in files["names/planted/__init__.py"]
    assert set(files) == {f"names/planted/{name}" for name in ("__init__.py", "legs.py", "py.typed")}


def test_a_name_that_two_modules_define_is_an_error_until_the_table_says_which(
    room: Path, tmp_path: Path
) -> None:
    (room / "third.py").write_text("__all__ = ['walk']\ndef walk(): ...\n")
    with pytest.raises(
        TableError, match=r"planted\.walk may be that of house\.room\.left, house\.room\.third: "
    ):
        planted_generator(tmp_path, {"planted": Facade("All.", also=("walk",))}).files()
    told = {"planted": Facade("All.", names={"walk": "house.room.third.walk"})}
    assert 'walk="house.room.third"' in planted_generator(tmp_path, told).files()["names/planted/__init__.py"]


def test_a_name_that_no_module_has_is_an_error(room: Path, tmp_path: Path) -> None:
    with pytest.raises(TableError, match=r"planted\.fly is nowhere in house\.room: "):
        planted_generator(tmp_path, {"planted": Facade("All.", also=("fly",))}).files()


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("planted:\n  modules:\n    planted: {doc: All., nams: {}}\n", "the row of planted .*'nams'"),
        ("planted:\n  modules:\n    other.legs: Legs.\n", "other.legs stands under planted"),
    ],
)
def test_wrong_rows_of_the_table_are_errors(text: str, error: str, tmp_path: Path) -> None:
    path = tmp_path / "names.yaml"
    path.write_text(text)
    with pytest.raises(TableError, match=error):
        read_table(path)


def test_star_import_has_the_deferred_names_and_no_submodule() -> None:
    code = "from {} import *; print(sorted(name for name in dir() if name[0] != '_'))"
    names = python(code.format("rclpy.clock")).stdout
    assert "'Clock', 'ClockChange', 'ClockType', 'Context'" in names
    assert "deferred" not in names
    assert "TYPE_CHECKING" not in names
    names = python(code.format("launch_ros.actions")).stdout
    assert "'Node'" in names
    assert "'node'" not in names


@pytest.mark.filterwarnings("ignore:importing 'qos_event'")
@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_each_facade_keeps_the_rule(rule: Rule) -> None:
    assert modules(ROS_NAMES)
    broken = list(rule(ROS_NAMES))
    assert not broken, "\n".join(broken)


GOOD = '''"""Hand on."""

from __future__ import annotations

from tfloom.ros_imports.guard import claim

__all__ = ["claim"]
'''


DEFERRED = """\
if TYPE_CHECKING:
    from a import X as X
    from b import Y as Y
else:
    from tfloom.ros_imports.modules import deferred

    __getattr__, __dir__ = deferred(__name__, X="a", Y="b")
"""
SUBMODULES = """\
if TYPE_CHECKING:
    from planted import gone as gone
    from planted import more as more
else:
    from tfloom.ros_imports.modules import submodules

    __getattr__ = submodules("planted")
"""


@pytest.mark.parametrize(
    ("rule", "changes", "found"),
    [
        (not_typed_packages, {"planted/py.typed": None}, "planted has no py.typed"),
        (not_typed_packages, {"planted/__init__.py": None}, "planted has no __init__.py"),
        (files_beside_the_facades, {"stray.py": ""}, "stray.py stands beside the façades"),
        (more_than_handing_on, {"planted/more.py": "X = 1"}, "planted/more.py:1: X = 1"),
        (more_than_handing_on, {"planted/more.py": "X: int = 1"}, "planted/more.py:1: X: int = 1"),
        (more_than_handing_on, {"planted/more.py": "print()"}, "planted/more.py:1: print()"),
        (more_than_handing_on, {"planted/more.py": "def f(): ..."}, "planted/more.py:1: def f():"),
        (
            more_than_handing_on,
            {"planted/more.py": "from os import sep"},
            "planted/more.py:1: from os import sep",
        ),
        (more_than_handing_on, {"planted/more.py": "from . import x"}, "planted/more.py:1: from . import x"),
        (names_that_are_missing, {"planted/more.py": "__all__ = ['x']"}, "planted.more has no x"),
        (
            more_than_handing_on,
            {"planted/more.py": "if TYPE_CHECKING:\n    import json\nelse:\n    json = None"},
            "planted/more.py:1: if TYPE_CHECKING:",
        ),
        (
            deferred_otherwise_than_typed,
            {"planted/more.py": DEFERRED.replace('Y="b"', 'Y="b", Z="c"')},
            "planted/more.py: Z of c",
        ),
        (
            deferred_otherwise_than_typed,
            {"planted/more.py": DEFERRED.replace("from b import Y as Y", "from b import Z as Y, Y as Z")},
            "planted/more.py: Z of b",
        ),
        (
            deferred_otherwise_than_typed,
            {"planted/__init__.py": SUBMODULES, "planted/more.py": ""},
            "planted/__init__.py: gone of planted",
        ),
        (
            names_that_are_missing,
            {"planted/more.py": "import no_such"},
            "planted.more: No module named 'no_such'",
        ),
        (names_that_are_missing, {"json/__init__.py": ""}, f"json comes from {json.__file__}"),
    ],
)
def test_each_facade_rule_finds_a_violation(
    rule: Rule, changes: dict[str, str | None], found: str, planted: Path
) -> None:
    folder = planted.parent
    (planted / "__init__.py").write_text(GOOD)
    (planted / "py.typed").touch()
    assert not list(rule(folder))
    for name, text in changes.items():
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        if text is None:
            path.unlink()
        else:
            path.write_text(text)
    importlib.invalidate_caches()
    assert list(rule(folder)) == [found]


@pytest.fixture
def real_rclpy(tmp_path: Path) -> Path:
    """Return a folder with an `rclpy` that is not tfloom's."""
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("REAL = True\ndef init(): ...\n")
    return tmp_path


def test_real_ros_takes_precedence(real_rclpy: Path) -> None:
    result = python("import rclpy; print(rclpy.REAL)", PYTHONPATH=str(real_rclpy))
    assert result.stdout == "True\n", result.stderr


@pytest.mark.parametrize("before", ["", "import sys; sys.frozen = True; "], ids=["plain", "frozen"])
def test_mixture_with_a_real_ros_raises_with_the_origins(before: str, real_rclpy: Path) -> None:
    result = python(f"{before}import tf2_ros", PYTHONPATH=str(real_rclpy))
    assert result.returncode == 1
    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError"), result.stderr
    assert f"'rclpy' comes from {real_rclpy}" in last, result.stderr


def test_frozen_program_imports_the_facades_from_any_folder(tmp_path: Path) -> None:
    """A frozen program has all modules in one folder, here that of a copied façade."""
    shutil.copytree(ROS_NAMES / "rclpy", tmp_path / "rclpy")
    code = "import sys; sys.frozen = True; import tf2_ros; print(sys.modules['rclpy'].__file__)"
    result = python(code, PYTHONPATH=str(tmp_path))
    assert result.stdout.startswith(str(tmp_path)), result.stderr
    claim = "from tfloom.ros_imports.guard import claim; claim('tf2_ros')"
    without = f"import sys; sys.frozen = True; sys.path.pop(); {claim}"
    assert python(without).returncode == 0


def test_use_ros_names_works_without_the_pth_file() -> None:
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
    result = run_to_end([sys.executable, "-S", "-c", code])
    assert result.stdout == "True 1\n", result.stderr


def test_deferred_names_and_submodules_load_on_first_use(planted: Path) -> None:
    (planted / "__init__.py").write_text(
        "from tfloom.ros_imports.modules import deferred\n"
        '__getattr__, __dir__ = deferred(__name__, inner="planted", sep="os")\n',
        "utf-8",
    )
    (planted / "inner.py").write_text("X = 1\n", "utf-8")
    package = importlib.import_module("planted")
    assert "planted.inner" not in sys.modules
    assert {"inner", "sep"} <= set(dir(package))
    assert package.inner.X == 1
    assert package.sep == os.sep
    with pytest.raises(AttributeError, match="module 'planted' has no attribute 'other'"):
        _ = package.other
