"""tools/generated.py: what is generated, when, what is removed, and that sdists and wheels have all of it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tools import generated

ROOT = Path(__file__).parents[2]
PROJECTS = (ROOT, ROOT / "packages" / "tfloom-interfaces", ROOT / "packages" / "tfloom-sensing")
BACKENDS = [ROOT / "tools" / "build_backend.py", *(project / "build_backend.py" for project in PROJECTS[1:])]
BUILD = (
    "import sys, build_backend\n"
    "build_backend.build_sdist(sys.argv[1])\n"
    "build_backend.build_wheel(sys.argv[1], {'wheel.cmake': 'false'})"
)
DEFINITIONS = "src/tfloom/rosidl/definitions"


def write(root: Path, files: Mapping[str, str] | None = None) -> None:
    generated.write(FILES if files is None else files, generated.inputs_digest(root), root)


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """Return a small checkout with a source, a generated façade, and the record of both."""
    for name in ("src/tfloom/__init__.py", "tools/generated.py", "tools/manifests.py", "src/tfloom/room.py"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"# {name}\n")
    write(tmp_path)
    return tmp_path


FILES = {
    "src/tfloom/ros_names/rclpy/__init__.py": '"""ä"""\n',
    "src/tfloom/ros_names/rclpy/py.typed": "",
    "src/tfloom/ros_names/rclpy/srv/__init__.py": "",
    "src/tfloom/interfaces/std_msgs/msg.py": "",
    "src/tfloom/share/rclpy/package.xml": "<package/>\n",
}


def test_what_is_written_is_current(checkout: Path) -> None:
    assert generated.is_checkout(checkout)
    assert generated.is_current(checkout)
    assert generated.files_there(checkout) == sorted(FILES)
    assert (checkout / "src/tfloom/ros_names/rclpy/__init__.py").read_bytes() == b'"""\xc3\xa4"""\n'


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("src/tfloom/room.py", "# changed\n"),
        ("src/tfloom/room.py", None),
        ("src/tfloom/rosidl/definitions/std_msgs/msg/New.msg", ""),
        ("src/tfloom/ros_names/rclpy/__init__.py", "# changed by hand\n"),
        ("src/tfloom/share/rclpy/package.xml", None),
        ("src/tfloom/ros_names/rospy/__init__.py", "# of another branch\n"),
        ("build/generated.json", None),
        ("build/generated.json", "{"),
        ("build/generated.json", "[]"),
    ],
)
def test_a_change_of_sources_or_of_files_is_seen(checkout: Path, name: str, text: str | None) -> None:
    path = checkout / name
    if text is None:
        path.unlink()
    else:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    assert not generated.is_current(checkout)
    write(checkout)
    assert generated.is_current(checkout)
    assert generated.files_there(checkout) == sorted(FILES)


def test_compiled_files_and_others_beside_are_not_seen(checkout: Path) -> None:
    for name in ("src/tfloom/ros_names/rclpy/__pycache__/x.pyc", "src/tfloom/share/rclpy/launch/a.yaml"):
        (checkout / name).parent.mkdir()
        (checkout / name).write_text("")
    assert generated.is_current(checkout)
    write(checkout, {})
    assert generated.files_there(checkout) == []
    assert (checkout / "src/tfloom/share/rclpy/launch/a.yaml").exists()


def test_packages_whose_source_has_gone_leave_no_folder(checkout: Path) -> None:
    """Python would import a folder that is left as a package."""
    package = checkout / "src/tfloom/ros_names/rclpy"
    (package / "srv" / "__pycache__").mkdir()
    (package / "srv" / "__pycache__" / "__init__.pyc").write_text("")
    write(checkout, {name: text for name, text in FILES.items() if "/ros_names/" not in name})
    assert not package.exists()
    assert (checkout / "src/tfloom/interfaces/std_msgs/msg.py").exists()


def test_files_that_do_not_differ_are_left(checkout: Path) -> None:
    path = checkout / "src/tfloom/ros_names/rclpy/__init__.py"
    os.utime(path, (1, 1))
    write(checkout, {**FILES, "src/tfloom/ros_imports/homes.py": "HOMES = {}\n"})
    assert path.stat().st_mtime == 1
    assert generated.files_there(checkout) == sorted([*FILES, "src/tfloom/ros_imports/homes.py"])


def test_a_file_that_cannot_be_written_whole_stays(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(path: Path, _target: Path) -> None:
        assert path.read_bytes() == b"new\n"  # all of it, before it gets its name
        raise OSError("full")

    monkeypatch.setattr(Path, "replace", fail)
    path = checkout / "src/tfloom/ros_names/rclpy/__init__.py"
    with pytest.raises(OSError, match="full"):
        write(checkout, {**FILES, "src/tfloom/ros_names/rclpy/__init__.py": "new\n"})
    assert path.read_text("utf-8") == '"""ä"""\n'
    assert generated.files_there(checkout) == sorted(FILES)


def test_the_files_of_this_checkout_are_current() -> None:
    """Each is also ignored by git, and each folder that git ignores for it is named in one place."""
    assert generated.is_current(ROOT), (
        "tools/run_tests.py generates them: `make test`, or `python tools/generated.py`"
    )
    if (ROOT / ".git").exists():
        done = subprocess.run(
            ["git", "check-ignore", "--stdin", "--no-index"],
            cwd=ROOT,
            input="\n".join(generated.files_there()),
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.stdout.split() == generated.files_there()


def copy_sources(folder: Path) -> Path:
    """Copy what the generators read, and the projects' files; return the folder."""
    for name in ("tools", "src", "packages"):
        shutil.copytree(
            ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "*.so", "*.pyd")
        )
    (folder / "tests" / "golden").mkdir(parents=True)
    for name in (
        "tests/golden/api_jazzy.json.gz",
        "tests/golden/module_names.json",
        "pyproject.toml",
        ".gitignore",
    ):
        shutil.copy(ROOT / name, folder / name)
    for name in ("README.md", "LICENSE"):
        shutil.copy(ROOT / name, folder / name)
    return folder


def digests(root: Path) -> dict[str, str]:
    return json.loads((root / generated.RECORD).read_text("utf-8"))["outputs"]


@pytest.mark.slow
def test_two_processes_generate_the_same_bytes_in_a_copy_and_remove_what_has_no_source(
    tmp_path: Path,
) -> None:
    copy = copy_sources(tmp_path / "a clöne")
    for name in generated.files_there(copy):
        (copy / name).unlink()
    command = [sys.executable, copy / "tools" / "generated.py"]
    processes = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    outputs = [process.communicate(timeout=300)[0] for process in processes]
    assert [process.returncode for process in processes] == [0, 0]
    assert min(map(len, outputs)) == 0  # the second one has waited, and found all done
    assert digests(copy) == digests(ROOT)
    shutil.rmtree(copy / DEFINITIONS / "stereo_msgs")
    done = run_to_end(command, timeout_s=300)
    assert done.returncode == 0, done.stderr
    gone = {name for name in digests(ROOT) if "/stereo_msgs/" in name}
    assert gone
    assert digests(copy).keys() == digests(ROOT).keys() - gone
    assert not (copy / "src/tfloom/ros_names/stereo_msgs").exists()


def test_each_project_has_the_same_backend() -> None:
    assert len({path.read_bytes() for path in BACKENDS}) == 1


def archived(project: Path, folder: Path) -> tuple[set[str], set[str]]:
    """Build a project's sdist, and its wheel without native code; return the names in both, as below `src/`."""
    folder.mkdir(parents=True)
    path = os.pathsep.join([str(project / "tools"), str(project)])
    done = run_to_end(
        [sys.executable, "-c", BUILD, folder],
        cwd=project,
        env=os.environ | {"PYTHONPATH": path},
        timeout_s=120,
    )
    assert done.returncode == 0, done.stderr
    (sdist,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    with tarfile.open(sdist) as archive:
        names = [name.partition("/")[2] for name in archive.getnames()]
    with zipfile.ZipFile(wheel) as content:
        return {name[4:] for name in names if name.startswith("src/")}, set(content.namelist())


def of_project(project: Path, root: Path, names: Iterable[str]) -> set[str]:
    """Return those of the generated files that are a project's, as below its `src/`."""
    prefix = f"{(project / 'src').relative_to(root).as_posix()}/"
    return {name.removeprefix(prefix) for name in names if name.startswith(prefix)}


@pytest.mark.parametrize("project", PROJECTS, ids=lambda project: project.name)
def test_sdist_and_wheel_have_what_is_generated(project: Path, tmp_path: Path) -> None:
    expected = of_project(project, ROOT, generated.files_there())
    assert len(expected) > 20
    sdist, wheel = archived(project, tmp_path / "dist")
    assert (expected - sdist, expected - wheel) == (set(), set())
    compiled = [
        name for name in sdist | wheel if "__pycache__" in name or name.endswith((".partial", ".pyc"))
    ]
    assert compiled == []


@pytest.mark.slow
def test_a_folder_that_sdist_include_does_not_name_is_missed(tmp_path: Path) -> None:
    """So the test above finds it: scikit-build-core leaves out what git ignores, and says nothing."""
    copy = copy_sources(tmp_path / "checkout")
    settings = copy / "pyproject.toml"
    text = settings.read_text("utf-8")
    settings.write_text(text.replace('"/src/tfloom/interfaces/**/*.py", ', ""), "utf-8")
    shutil.copytree(ROOT / "licenses", copy / "licenses")
    shutil.copytree(ROOT / "examples" / "robot_in_a_room", copy / "examples" / "robot_in_a_room")
    shutil.copy(ROOT / "CMakeLists.txt", copy)
    sdist, wheel = archived(copy, tmp_path / "dist")
    expected = of_project(copy, copy, generated.files_there(copy))
    lost = {name for name in expected if name.startswith("tfloom/interfaces/")}
    assert lost
    assert (expected - sdist, expected - wheel) == (lost, lost)


def test_an_sdist_generates_nothing(tmp_path: Path) -> None:
    """Even in the folder of a checkout, where there is a generator to be found."""
    (tmp_path / "tools").mkdir()
    (tmp_path / "tools" / "generated.py").write_text("raise SystemExit('generates')\n")
    project = tmp_path / "packages" / "project"
    project.mkdir(parents=True)
    start = "import build_backend; build_backend._finish(build_backend._start())"
    variables = os.environ | {"PYTHONPATH": str(ROOT / "tools")}

    def run(folder: Path) -> subprocess.CompletedProcess[str]:
        return run_to_end([sys.executable, "-c", start], cwd=folder, env=variables)

    for folder in (project, tmp_path):
        assert "generates" in run(folder).stderr
        (folder / "PKG-INFO").touch()
        assert run(folder).returncode == 0
    (project / "PKG-INFO").unlink()
    (tmp_path / "tools" / "generated.py").unlink()
    assert "project lacks its generated files, and tfloom's sources around it" in run(project).stderr


def test_an_import_of_what_is_missing_says_what_to_do(tmp_path: Path) -> None:
    """With the folders that git leaves of a package, whose compiled files it ignores."""
    names, interfaces = tmp_path / "names", tmp_path / "interfaces"
    (names / "rclpy" / "__pycache__").mkdir(parents=True)
    (interfaces / "std_msgs").mkdir(parents=True)
    (names / "tf2_ros").mkdir()
    (names / "tf2_ros" / "__init__.py").write_text("IS_THERE = True\n")
    code = f"""
import importlib, importlib.util, runpy, sys
sys.path = [path for path in sys.path if not path.endswith("ros_names")] + [{str(names)!r}]
import tfloom.interfaces
tfloom.interfaces.__path__ = [{str(interfaces)!r}]
runpy.run_path({str(ROOT / "tools" / "not_generated.py")!r})
for name in ("rclpy", "geometry_msgs.msg", "nav2_msgs.msg", "tfloom.interfaces.std_msgs.msg", "no_such", "tf2_ros"):
    try:
        print(importlib.import_module(name).IS_THERE)
    except ModuleNotFoundError as error:
        print(error)
print(importlib.util.find_spec("geometry_msgs"))
"""
    lines = run_to_end([sys.executable, "-c", code]).stdout.splitlines()
    said = f": it is generated, and not there yet: run `make setup` in {ROOT}"
    assert lines == [
        *(f"No module named '{name}'{said}" for name in ("rclpy", "geometry_msgs", "nav2_msgs")),
        f"No module named 'tfloom.interfaces.std_msgs'{said}",
        "No module named 'no_such'",
        "True",
        "None",
    ]


def test_generators_import_nothing_that_is_compiled() -> None:
    code = (
        "import sys; sys.path[:0] = ['src', '.']\n"
        "import tfloom.rosidl.generate, tools.facades.generate, tools.manifests\n"
        "print([name for name in sys.modules if name.partition('.')[0] == 'numpy' or '_native' in name])"
    )
    assert run_to_end([sys.executable, "-c", code], cwd=ROOT).stdout == "[]\n"
