"""`install_interfaces`: an interface package, built without CMake."""

from __future__ import annotations

import importlib
import json
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.workspace.conftest import write_files

from tfloom import use_ros_names
from tfloom.rosidl import cdr, registry
from tfloom.workspace import interface_package
from tfloom.workspace.ament import get_resource
from tfloom.workspace.interface_package import (
    Installed,
    InterfacePackageError,
    install_interfaces,
    python_folder,
)

PACKAGE_XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <depend>geometry_msgs</depend>
  {depend}
  <exec_depend>rosidl_default_runtime</exec_depend>
  <test_depend>ament_lint_auto</test_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
"""
FILES = {
    "msg/Sphere.msg": "# A ball.\ngeometry_msgs/Point center\nfloat64 radius 1.0  # [m]\nuint8 BIG=3\n",
    "msg/Pile.idl": (
        "module my_interfaces { module msg { struct Pile { sequence<my_interfaces::msg::Sphere> spheres; }; }; };\n"
    ),
    "srv/Weigh.srv": "Sphere sphere\n---\nfloat64 mass\n",
    "action/Roll.action": "float64 distance\n---\nfloat64 rolled\n---\nfloat64 now\n",
}
USER = """\
import my_interfaces
from my_interfaces.action import Roll
from my_interfaces.msg import Pile, Sphere
from my_interfaces.srv import Weigh


def weigh(request: Weigh.Request, response: Weigh.Response) -> Weigh.Response:
    response.mass = request.sphere.radius + request.sphere.center.x
    return response


print(Pile(spheres=[Sphere(radius=2.0)]), my_interfaces.msg.Sphere.BIG, Roll.Goal(distance=1.0))
print(Sphere(radios=2.0))  # mistake
"""


def package(folder: Path, files: dict[str, str], name: str = "my_interfaces", depend: str = "") -> Path:
    """Write a package's sources, and return its folder."""
    write_files(folder, {"package.xml": PACKAGE_XML.format(name=name, depend=depend), **files})
    return folder


@pytest.fixture
def source(tmp_path: Path) -> Path:
    """Return the sources of a package."""
    return package(tmp_path / "src", FILES)


@pytest.fixture
def prefix(tmp_path: Path) -> Path:
    """Return a folder to install into."""
    return tmp_path / "install" / "my_interfaces"


def install(source: Path, prefix: Path, files: Sequence[str] = tuple(FILES), **options: object) -> Installed:
    return install_interfaces(source, "my_interfaces", files, prefix, **options)  # type: ignore[arg-type]


def errors_of(source: Path, prefix: Path, files: Sequence[str] = tuple(FILES)) -> list[str]:
    """Return the errors of a build, which must install nothing."""
    with pytest.raises(InterfacePackageError) as error:
        install(source, prefix, files)
    assert not prefix.exists()
    assert str(error.value) == "\n".join(error.value.errors)
    return [line.replace(f"{source}{os.sep}", "") for line in error.value.errors]


def run(
    code: str, installed: Installed, prefix: Path | str, *options: str
) -> subprocess.CompletedProcess[str]:
    """Run code, or tfloom's command with its words after a -m, with a built package on the path."""
    return run_to_end(
        [sys.executable, *(options or ("-c", code))],
        env=os.environ | {"PYTHONPATH": str(installed.python_folder), "AMENT_PREFIX_PATH": str(prefix)},
    )


def test_what_is_installed(source: Path, prefix: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    installed = install(source, prefix)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    assert installed.names == [
        *("my_interfaces/action/Roll", "my_interfaces/msg/Pile", "my_interfaces/msg/Sphere"),
        "my_interfaces/srv/Weigh",
    ]
    assert installed.warnings == []
    assert installed.python_folder == python_folder(prefix)
    folders = ("", "msg/", "srv/", "action/")
    modules = [f"{folder}__init__{suffix}" for folder in folders for suffix in (".py", ".pyi")]
    modules += ["msg/_pile.py", "msg/_sphere.py", "srv/_weigh.py", "action/_roll.py"]
    markers = ("packages", "package_run_dependencies", "rosidl_interfaces")
    assert installed.files == sorted(path for path in prefix.rglob("*") if path.is_file())
    assert set(installed.files) == {
        *(prefix / "share" / "my_interfaces" / name for name in (*FILES, "package.xml")),
        *(prefix / "share" / "ament_index" / "resource_index" / name / "my_interfaces" for name in markers),
        *(installed.python_folder / "my_interfaces" / name for name in (*modules, "py.typed")),
    }
    for name, text in FILES.items():
        assert (prefix / "share" / "my_interfaces" / name).read_text("utf-8") == text
    assert get_resource("rosidl_interfaces", "my_interfaces")[0].split("\n") == sorted(FILES)
    run_dependencies = get_resource("package_run_dependencies", "my_interfaces")[0]
    assert run_dependencies == "geometry_msgs;rosidl_default_runtime;ament_lint_auto"


@pytest.mark.usefixtures("forget_interfaces")
@pytest.mark.parametrize("is_sourced", [True, False])
def test_modules_have_the_classes_that_the_index_has(
    source: Path, prefix: Path, monkeypatch: pytest.MonkeyPatch, is_sourced: bool
) -> None:
    use_ros_names()
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix) if is_sourced else "")
    monkeypatch.syspath_prepend(install(source, prefix).python_folder)
    module = importlib.import_module("my_interfaces.msg")
    assert module.__file__ == str(python_folder(prefix) / "my_interfaces" / "msg" / "__init__.py")
    assert module.__all__ == ["Pile", "Sphere"]
    assert registry.get_message_class("my_interfaces/msg/Sphere") is module.Sphere
    pile = module.Pile(spheres=[module.Sphere(radius=2.0)])
    assert type(cdr.decode(module.Pile, cdr.encode(pile)).spheres[0]) is module.Sphere
    top = importlib.import_module("my_interfaces")
    assert top.srv.Weigh.Request().sphere.radius == 1.0
    assert registry.get_action_class("my_interfaces/action/Roll") is top.action.Roll
    with pytest.raises(AttributeError, match=r"share/my_interfaces has no msg/Cube\.msg"):
        _ = module.Cube


def test_an_edit_of_a_linked_definition_needs_no_build(source: Path, prefix: Path) -> None:
    installed = install(source, prefix, symlink=True)
    definition = source / "msg" / "Sphere.msg"
    assert (prefix / "share" / "my_interfaces" / "msg" / "Sphere.msg").resolve() == definition
    definition.write_text("float64 diameter 7.0\n")
    code = "from my_interfaces.msg import Sphere; print(Sphere())"
    done = run(code, installed, "")
    assert (done.stdout, done.stderr) == ("my_interfaces.msg.Sphere(diameter=7.0)\n", "")

    install(source, prefix, symlink=True)
    install(source, prefix)  # copies take the place of the links, whose targets stay
    assert not [path for path in prefix.rglob("*") if path.is_symlink()]
    definition.write_text("float64 radius\n")
    assert run(code, installed, "").stdout == "my_interfaces.msg.Sphere(diameter=7.0)\n"


def test_a_new_build_removes_what_is_no_longer_listed(source: Path, prefix: Path) -> None:
    install(source, prefix)
    files = {str(path) for path in install(source, prefix, ["msg/Sphere.msg"]).files}
    assert files == {str(path) for path in prefix.rglob("*") if path.is_file()}
    assert not [path for path in files if "srv" in path or "Pile" in path]
    assert json.dumps(sorted(files)).count("Sphere.msg") == 1
    assert install(source, prefix, []).names == []
    assert not list(prefix.rglob("*.py"))


def test_what_a_former_build_installed_is_no_definition(source: Path, prefix: Path) -> None:
    install(source, prefix)
    with pytest.raises(InterfacePackageError, match="there is no definition of 'my_interfaces/msg/Sphere'"):
        install(source, prefix, ["srv/Weigh.srv"])


def test_a_file_relative_to_another_folder(tmp_path: Path, source: Path, prefix: Path) -> None:
    elsewhere = package(tmp_path / "elsewhere", {"msg/Far.msg": "float64 x\n"})
    installed = install(source, prefix, ["msg/Sphere.msg", f"{elsewhere}:msg/Far.msg"])
    assert installed.names == ["my_interfaces/msg/Far", "my_interfaces/msg/Sphere"]


def test_messages_of_a_package_in_another_prefix(
    tmp_path: Path, source: Path, prefix: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    install(source, prefix)
    user = package(tmp_path / "user", {"msg/Holder.msg": "my_interfaces/Pile pile\n"}, "user_msgs")
    other = tmp_path / "install" / "user_msgs"
    arguments = (user, "user_msgs", ["msg/Holder.msg"], other)
    installed = install_interfaces(*arguments, dependencies=[prefix])
    assert installed.warnings == [
        f"{user / 'package.xml'}: the definitions use my_interfaces: add <depend>my_interfaces</depend>"
    ]
    assert "from my_interfaces.msg import Pile" in (other / python_stub(installed, other)).read_text("utf-8")
    package(user, {}, "user_msgs", "<depend>my_interfaces</depend>")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    assert install_interfaces(*arguments).warnings == []
    monkeypatch.delenv("AMENT_PREFIX_PATH")
    with pytest.raises(
        InterfacePackageError, match=r"Holder\.msg:1:1: there is no definition of 'my_interf"
    ) as error:
        install_interfaces(*arguments)
    assert error.value.errors[0].endswith(
        "; package.xml depends on it, so build or install it first, and source its setup file"
    )


def python_stub(installed: Installed, prefix: Path) -> Path:
    return installed.python_folder.relative_to(prefix) / "user_msgs" / "msg" / "__init__.pyi"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("int32 a\nint33 b\n", "msg/Bad.msg:2:1: 'int33' is neither a primitive type nor a message's name"),
        (
            "Spere sphere\n",
            (
                "msg/Bad.msg:1:1: there is no definition of 'my_interfaces/msg/Spere'"
                "; add its file to rosidl_generate_interfaces; did you mean 'my_interfaces/msg/Sphere'?"
            ),
        ),
        (
            "geometry_msgs/Pointt point\n",
            (
                "msg/Bad.msg:1:1: there is no definition of 'geometry_msgs/msg/Pointt'"
                "; did you mean 'geometry_msgs/msg/Point'?"
            ),
        ),
        (
            "int32 a\nnowhere_msgs/Thing thing\n",
            (
                "msg/Bad.msg:2:1: there is no definition of 'nowhere_msgs/msg/Thing': the package 'nowhere_msgs' is "
                "neither on AMENT_PREFIX_PATH nor one of tfloom's own; package.xml doesn't depend on it: add "
                "<depend>nowhere_msgs</depend>"
            ),
        ),
        (
            "Bad bad\n",
            "msg/Bad.msg:1:1: a message contains itself: my_interfaces/msg/Bad -> my_interfaces/msg/Bad",
        ),
    ],
)
def test_mistakes_in_definitions(source: Path, prefix: Path, text: str, expected: str) -> None:
    package(source, {"msg/Bad.msg": text})
    assert errors_of(source, prefix, [*FILES, "msg/Bad.msg"]) == [expected]


def test_each_mistake_is_named(source: Path, prefix: Path) -> None:
    package(source, {"msg/Bad.msg": "int33 a\n", "msg/bad_name.msg": "", "srv/Bad.srv": "int32 a\n"})
    (source / "msg" / "Latin.msg").write_bytes(b"# \xe9\n")
    assert errors_of(source, prefix, ["msg/Bad.msg", "msg/bad_name.msg", "srv/Bad.srv", "msg/Latin.msg"]) == [
        "msg/Bad.msg:1:1: 'int33' is neither a primitive type nor a message's name",
        "msg/Latin.msg:1:3: octet 0xe9 isn't UTF-8 text",
        "msg/bad_name.msg: 'bad_name' is not an interface name: letters and digits, the first a capital",
        "srv/Bad.srv:2:1: the definition has 1 of its 2 parts, divided by '---'",
    ]


@pytest.mark.parametrize(
    "entry", ["srvs/Halt.srv", "interfaces/services/Halt.srv", "msg/Halt.srv", "Halt.srv"]
)
def test_suffix_decides_the_kind_of_a_definition(source: Path, prefix: Path, entry: str) -> None:
    package(source, {entry: "---\n"})
    installed = install(source, prefix, [*FILES, entry])
    assert "my_interfaces/srv/Halt" in installed.names
    assert (prefix / "share" / "my_interfaces" / "srv" / "Halt.srv").is_file()
    done = run("from my_interfaces.srv import Halt; print(Halt.Request())", installed, prefix)
    assert done.stdout == "my_interfaces.srv.Halt_Request()\n"


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        ("msg/Spher.msg", "there is no file msg/Spher.msg; did you mean 'msg/Sphere.msg'?"),
        ("msgs/Sphere.idl", "the folder of an .idl file must be msg, srv or action"),
        ("msg/Sphere.txt", "a definition ends in .msg, .srv, .action or .idl"),
        ("msgs/Spher.msg", "there is no file msgs/Spher.msg; did you mean 'msg/Sphere.msg'?"),
        ("msg/Pile.msg", "it defines the same interface as msg/Pile.idl"),
        (
            "/msg/Sphere.msg",
            "an absolute path is written 'folder:msg/Name.msg', because its last two parts are installed",
        ),
    ],
)  # fmt: skip
def test_mistakes_in_the_list(source: Path, prefix: Path, entry: str, expected: str) -> None:
    (source / "msg" / "Pile.msg").write_text("int32 a\n")
    assert errors_of(source, prefix, [*FILES, entry]) == [
        f"rosidl_generate_interfaces lists '{entry}': {expected}"
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (None, "package.xml: a package needs this file"),
        ("<package>\n<name>a</package>", "package.xml:2:9: it isn't XML: mismatched tag: line 2, column 9"),
        ("<package/>", "package.xml: the package has no <name>"),
        (
            "<package><name>other</name></package>",
            "package.xml: the package is called 'other' here, not 'my_interfaces'",
        ),
    ],
)  # fmt: skip
def test_mistakes_in_package_xml(source: Path, prefix: Path, text: str | None, expected: str) -> None:
    path = source / "package.xml"
    path.unlink()
    if text is not None:
        path.write_text(text)
    assert [line.replace(":2:10:", ":2:9:") for line in errors_of(source, prefix)] == [expected]


def test_beside_another_rclpy_the_error_names_both(source: Path, prefix: Path, tmp_path: Path) -> None:
    installed = install(source, prefix)
    (tmp_path / "ros").mkdir()
    (tmp_path / "ros" / "rclpy.py").touch()
    both = os.pathsep.join([str(tmp_path / "ros"), str(installed.python_folder)])
    done = run("import my_interfaces.msg", installed._replace(python_folder=Path(both)), prefix)
    assert "'my_interfaces' would come from tfloom, but 'rclpy' comes from" in done.stderr.splitlines()[-1]


def test_commands_know_the_package(source: Path, prefix: Path) -> None:
    installed = install(source, prefix)

    def tfloom(*words: str) -> str:
        done = run("", installed, prefix, "-m", "tfloom", *words)
        assert done.stderr == ""
        return done.stdout

    assert tfloom("interface", "package", "my_interfaces").split() == [
        *("my_interfaces/msg/Pile", "my_interfaces/msg/Sphere"),
        *("my_interfaces/srv/Weigh", "my_interfaces/action/Roll"),
    ]
    assert "my_interfaces/action/Roll" in tfloom("interface", "list")
    assert (
        tfloom("interface", "show", "my_interfaces/msg/Sphere").splitlines()[1]
        == "geometry_msgs/Point center"
    )
    assert tfloom("pkg", "prefix", "my_interfaces").strip() == str(prefix)


@pytest.mark.slow  # mypy and pyright take seconds
@pytest.mark.parametrize("checker", ["mypy", "pyright"])
def test_type_checkers_read_the_installed_modules(
    checker: str, source: Path, prefix: Path, tmp_path: Path
) -> None:
    installed = install(source, prefix)
    project = package(
        tmp_path / "project", {"user.py": USER, "pyrightconfig.json": '{"typeCheckingMode": "standard"}'}
    )
    command = (
        ["-m", "mypy", "--strict", "--config-file=", "user.py"]
        if checker == "mypy"
        else ["-m", "basedpyright", f"--pythonpath={sys.executable}", "user.py"]
    )
    done = run_to_end(
        [sys.executable, *command],
        cwd=project,
        env=os.environ | {"PYTHONPATH": str(installed.python_folder)},
        timeout_s=300,
    )
    errors = [line for line in done.stdout.splitlines() if " error: " in line]
    mistakes = [number for number, line in enumerate(USER.splitlines(), 1) if line.endswith("  # mistake")]
    assert [int(line.split(":")[1]) for line in errors] == mistakes, done.stdout + done.stderr


def test_the_folder_of_debians_python(prefix: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        interface_package.sysconfig, "get_scheme_names", lambda: ("deb_system", "posix_prefix", "nt")
    )
    asked: list[str] = []
    real = interface_package.sysconfig.get_path

    def get_path(name: str, scheme: str, variables: dict[str, str]) -> str:
        asked.append(scheme)
        return real(name, "posix_prefix", variables)

    monkeypatch.setattr(interface_package.sysconfig, "get_path", get_path)
    python_folder(prefix)
    assert asked == (["nt"] if os.name == "nt" else ["deb_system"])
