"""Installing the files of a plan: what is chosen, where it goes, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import write_files, write_manifest

from tfloom.workspace.cmake_plan import Install, Pattern, Plan, PythonPackage, Resource
from tfloom.workspace.installing import Installer, InstallError
from tfloom.workspace.interface_package import install_interfaces

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
        "msg.py",
        "msg.pyi",
        "py.typed",
    ]
