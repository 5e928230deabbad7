"""Installing the files of a plan: what is chosen, where it goes, and what is refused."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tests.workspace.conftest import write_files, write_manifest

from tfloom.workspace.cmake_plan import Install, Pattern, Plan, PythonPackage, Remark, Resource
from tfloom.workspace.installing import Installer, InstallError
from tfloom.workspace.interface_package import install_interfaces
from tfloom.workspace.leftovers import RECORD, remove_dangling_links, remove_former_files
from tfloom.workspace.program_scripts import read_console_scripts

FILES = {
    "package.xml": "<package/>",
    "a/x.dae": "",
    "a/x.stl": "",
    "a/deep/y.dae": "",
    "a/deep/old/z.dae": "",
    "a/__pycache__/x.pyc": "",
}


def install(folder: Path, *installs: Install, **rest: list[object]) -> list[str]:
    """Install FILES by a plan, and return the paths below share/pkg."""
    write_files(folder, FILES)
    prefix = folder / "install"
    Installer(folder, "pkg", prefix).install(Plan("pkg", installs=list(installs), **rest))
    share = prefix / "share" / "pkg"
    return sorted(path.relative_to(share).as_posix() for path in share.rglob("*") if path.is_file())


@pytest.mark.parametrize(
    ("source", "patterns", "only", "expected"),
    [
        ("a", (), False, ["a/deep/old/z.dae", "a/deep/y.dae", "a/x.dae", "a/x.stl"]),
        ("a/", (), False, ["deep/old/z.dae", "deep/y.dae", "x.dae", "x.stl"]),
        ("a/", (Pattern("*.dae", False, False),), True, ["deep/old/z.dae", "deep/y.dae", "x.dae"]),
        ("a/", (Pattern("*.dae", False, False),), False, ["deep/old/z.dae", "deep/y.dae", "x.dae", "x.stl"]),
        ("a/", (Pattern("deep", False, True),), False, ["x.dae", "x.stl"]),
        ("a/", (Pattern("deep/old", False, True),), False, ["deep/y.dae", "x.dae", "x.stl"]),
        ("a/", (Pattern("/x[.]d", True, True),), False, ["deep/old/z.dae", "deep/y.dae", "x.stl"]),
    ],
)
def test_folder_is_installed_by_its_patterns(
    source: str, patterns: tuple[Pattern, ...], only: bool, expected: list[str], tmp_path: Path
) -> None:
    command = Install("DIRECTORY", (source,), "share/pkg", 1, None, False, patterns, only)
    assert install(tmp_path, command) == sorted([*expected, "package.xml"])


def test_marker_resource_and_python_are_installed(tmp_path: Path) -> None:
    (tmp_path / "py").mkdir()
    (tmp_path / "py" / "__init__.py").touch()
    install(
        tmp_path,
        resources=[Resource("plugins", "a;b", 1)],
        python_packages=[PythonPackage("tools", "py", "lib/python", 2)],
    )
    index = tmp_path / "install" / "share" / "ament_index" / "resource_index"
    assert (index / "packages" / "pkg").is_file()
    assert (index / "plugins" / "pkg").read_text() == "a;b"
    assert (tmp_path / "install" / "lib" / "python" / "tools" / "__init__.py").is_file()


SETUP_CFG = """
[options.entry_points]
console_scripts =
    say = tools.say:main
    say-more=tools.deep.more : run [extra]
"""


def test_programs_of_setup_cfg_are_installed(tmp_path: Path) -> None:
    write_files(
        tmp_path, {"py/__init__.py": "", "py/say.py": "def main():\n    return 3\n", "setup.cfg": SETUP_CFG}
    )
    install(tmp_path, python_packages=[PythonPackage("tools", "py", "lib/python", 2, "lib/pkg")])
    folder = tmp_path / "install" / "lib"
    assert "from tools.deep.more import run\n" in (folder / "pkg" / "say-more").read_text()
    run = subprocess.run(
        [folder / "pkg" / "say"], env={"PYTHONPATH": str(folder / "python")}, check=False, timeout=30
    )
    assert run.returncode == 3


def test_programs_of_setup_cfg_run_by_a_python_whose_path_has_a_space(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    python = tmp_path / "a python" / "python"
    python.parent.mkdir()
    python.symlink_to(sys.executable)
    monkeypatch.setattr(sys, "executable", str(python))
    (tmp_path / "setup.cfg").write_text(SETUP_CFG)
    script = tmp_path / "say"
    script.write_text(read_console_scripts(tmp_path / "setup.cfg")["say"])
    script.chmod(0o755)
    write_files(tmp_path / "tools", {"__init__.py": "", "say.py": "def main():\n    return 3\n"})
    run = subprocess.run([script], env={"PYTHONPATH": str(tmp_path)}, check=False, timeout=30)
    assert run.returncode == 3


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (None, "SCRIPTS_DESTINATION needs a setup.cfg, and there is no {path}"),
        (
            "[options.entry_points]\nconsole_scripts = say = tools\n",
            "{path}: 'say = tools' of console_scripts isn't: ",
        ),
        ("say", "{path}: File contains no section headers"),
    ],
)
def test_setup_cfg_without_usable_programs_is_named(text: str | None, reason: str, tmp_path: Path) -> None:
    path = tmp_path / "setup.cfg"
    write_files(tmp_path, {"py/__init__.py": ""} | ({} if text is None else {"setup.cfg": text}))
    with pytest.raises(InstallError) as error:
        install(tmp_path, python_packages=[PythonPackage("tools", "py", "lib/python", 2, "lib/pkg")])
    assert str(error.value).startswith(f"{tmp_path}/CMakeLists.txt:2: {reason.format(path=path)}")


GENERATED = {"a.yaml": b"1", "d/b.yaml": b"2", "d/e/c": b"3"}


@pytest.mark.parametrize(
    ("command", "expected"),
    [
        (Install("FILES", ("<build>/a.yaml",), "share/pkg", 1), {"a.yaml": b"1"}),
        (Install("PROGRAMS", ("<build>/d/b.yaml",), "share/pkg", 1, "go"), {"go": b"2"}),
        (Install("DIRECTORY", ("<build>/d",), "share/pkg", 1), {"d/b.yaml": b"2", "d/e/c": b"3"}),
        (Install("DIRECTORY", ("<build>/d/",), "share/pkg", 1), {"b.yaml": b"2", "e/c": b"3"}),
    ],
)
@pytest.mark.parametrize("symlink", [False, True])
def test_configured_files_are_installed(
    command: Install, expected: dict[str, bytes], symlink: bool, tmp_path: Path
) -> None:
    write_files(tmp_path, {"package.xml": ""})
    plan = Plan("pkg", installs=[command], generated=GENERATED)
    for _ in range(2):  # a new build replaces them
        Installer(tmp_path, "pkg", tmp_path / "install", symlink=symlink).install(plan)
    share = tmp_path / "install" / "share" / "pkg"
    files = {path.relative_to(share).as_posix(): path for path in share.rglob("*") if path.is_file()}
    del files["package.xml"]
    assert {name: path.read_bytes() for name, path in files.items()} == expected
    assert all(os.access(path, os.X_OK) == (command.kind == "PROGRAMS") for path in files.values())


def test_package_with_cpp_installs_what_is_there(tmp_path: Path) -> None:
    write_files(tmp_path, FILES)
    installs = [
        Install("DIRECTORY", ("a", "none"), "share/pkg", 3),
        Install("FILES", ("none.so",), "lib", 4),
        Install("DIRECTORY", ("include/",), "include", 5),
    ]
    plan = Plan("pkg", installs=installs, compiled=[Remark(2, "add_library(a …)")], programs=["go", "stop"])
    installer = Installer(tmp_path, "pkg", tmp_path / "install")
    installer.install(plan)
    where = f"{tmp_path}/CMakeLists.txt"
    assert installer.warnings == [
        f"{where}:3: install(DIRECTORY …): there is no folder none, so it is left out",
        f"{where}:4: install(FILES …): there is no file none.so, so it is left out",
    ]
    share = tmp_path / "install" / "share"
    assert (share / "pkg" / "a" / "x.dae").is_file()
    note = share / "ament_index" / "resource_index" / "tfloom_left_out" / "pkg"
    assert note.read_text() == f"{where}:2 has add_library(a …)\ngo\nstop\n"


def test_folder_outside_of_the_package_is_left_out(tmp_path: Path) -> None:
    # `${X}/lib` without X would copy the system's libraries.
    source = tmp_path / "source"
    write_files(tmp_path, {"lib/a": "", "source/package.xml": ""})
    installer = Installer(source, "pkg", tmp_path / "install")
    installer.install(Plan("pkg", installs=[Install("DIRECTORY", (f"{tmp_path}/lib",), "share", 1)]))
    reason = f"install(DIRECTORY …): {tmp_path}/lib is outside of the package, so it is left out"
    assert installer.warnings == [f"{source}/CMakeLists.txt:1: {reason}"]
    assert not (tmp_path / "install" / "share" / "lib").exists()


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        (Install("FILES", ("none",), "share", 7), "install(FILES …): there is no file none"),
        (Install("DIRECTORY", ("none",), "share", 7), "install(DIRECTORY …): there is no folder none"),
        (Install("FILES", ("a/x.dae",), "../out", 7), "DESTINATION ../out is outside the prefix {prefix}"),
        (Install("FILES", ("a/x.dae",), "/etc", 7), "DESTINATION /etc is outside the prefix {prefix}"),
    ],
)
def test_impossible_install_is_refused_with_its_line(command: Install, reason: str, tmp_path: Path) -> None:
    with pytest.raises(InstallError) as error:
        install(tmp_path, command)
    prefix = tmp_path / "install"
    assert str(error.value) == f"{tmp_path}/CMakeLists.txt:7: {reason.format(prefix=prefix)}"


def test_optional_sources_may_be_missing(tmp_path: Path) -> None:
    optional = [Install(kind, ("none",), "share/pkg", 1, None, True) for kind in ("FILES", "DIRECTORY")]
    assert install(tmp_path, *optional) == ["package.xml"]


def test_copy_replaces_a_link_without_changing_its_target(tmp_path: Path) -> None:
    command = Install("FILES", ("a/x.dae",), "share/pkg", 1)
    install(tmp_path, command)
    target = tmp_path / "install" / "share" / "pkg" / "x.dae"
    target.unlink()
    victim = tmp_path / "victim"
    victim.write_text("safe")
    target.symlink_to(victim)
    (tmp_path / "a" / "x.dae").write_text("new")
    Installer(tmp_path, "pkg", tmp_path / "install").install(Plan("pkg", installs=[command]))
    assert (target.read_text(), target.is_symlink(), victim.read_text()) == ("new", False, "safe")


@pytest.mark.parametrize("symlink", [True, False])
def test_rebuild_leaves_the_sources_of_python_beside_interfaces(symlink: bool, tmp_path: Path) -> None:
    own = '"""Mine."""\n'
    write_manifest(tmp_path, "ament_cmake", name="pkg")
    write_files(tmp_path, {"msg/One.msg": "bool one\n", "pkg/__init__.py": own, "resource/pkg": own})
    prefix = tmp_path / "install"
    plan = Plan("pkg", python_packages=[PythonPackage("pkg", "pkg", "python", 1)])
    plan.installs.append(Install("FILES", ("resource/pkg",), "share/ament_index/resource_index/packages", 2))
    for link in (True, symlink):
        folder = install_interfaces(tmp_path, "pkg", ["msg/One.msg"], prefix, symlink=link).python_folder
        plan.python_packages[0] = plan.python_packages[0]._replace(
            destination=folder.relative_to(prefix).as_posix()
        )
        Installer(tmp_path, "pkg", prefix, symlink=link).install(plan)
    assert (tmp_path / "pkg" / "__init__.py").read_text() == own
    assert (tmp_path / "resource" / "pkg").read_text() == own
    assert (folder / "pkg" / "__init__.py").read_text() == own
    assert sorted(path.name for path in (folder / "pkg").iterdir()) == [
        "__init__.py",
        "msg",
        "py.typed",
    ]


def test_dangling_links_are_removed_and_others_stay(tmp_path: Path) -> None:
    write_files(tmp_path, {"there": "", "links/file": "", "links/deep/file": ""})
    for name, target in (("good", "there"), ("bad", "gone"), ("deep/bad", "gone"), ("folder", "links/deep")):
        (tmp_path / "links" / name).symlink_to(tmp_path / target)
    remove_dangling_links([tmp_path / "links", tmp_path / "none"])
    assert not (tmp_path / "links" / "bad").is_symlink()
    assert not (tmp_path / "links" / "deep" / "bad").is_symlink()
    assert all((tmp_path / "links" / name).exists() for name in ("file", "good", "folder", "deep/file"))


def test_files_that_are_no_longer_installed_are_removed(tmp_path: Path) -> None:
    prefix, build = tmp_path / "install", tmp_path / "build"
    write_files(tmp_path, {"install/a/old": "", "install/b/old": "", "install/b/new": "", "other/old": ""})
    old = [prefix / "a" / "old", prefix / "b" / "old", tmp_path / "other" / "old"]
    remove_former_files(build, prefix, old)
    assert all(path.exists() for path in old)
    remove_former_files(build, prefix, [prefix / "b" / "new"])
    assert [path.exists() for path in old] == [False, False, True]
    assert not (prefix / "a").exists()
    assert (prefix / "b" / "new").exists()
    assert (build / RECORD).read_text() == f"{prefix}/b/new\n"
