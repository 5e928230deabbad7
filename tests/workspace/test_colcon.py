"""`colcon build` without CMake and without ROS: interfaces, files, Python, and what can't be built."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest
from tests.workspace.conftest import (
    SETUP_PY,
    Built,
    colcon,
    in_shell,
    write_cmake_package,
    write_files,
    write_manifest,
    write_python_package,
)

from tfloom.ros_imports.ros_distro import ROS_ENVIRONMENT

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs bash")

INTERFACES = """\
project(ball_msgs)
rosidl_generate_interfaces(${PROJECT_NAME} msg/Ball.msg srv/Throw.srv DEPENDENCIES geometry_msgs)
"""
DESCRIPTION = """\
project(ball_description)
install(DIRECTORY urdf config/ DESTINATION share/${PROJECT_NAME})
install(PROGRAMS scripts/bounce DESTINATION lib/${PROJECT_NAME})
install(FILES scripts/stuck DESTINATION lib/${PROJECT_NAME})
ament_python_install_package(ball_tools)
mystery(x)
"""
SAY = """\
def main():
    from ament_index_python.packages import get_package_share_directory
    from ball_msgs.msg import Ball
    print("said", Ball(radius=2.0).radius, get_package_share_directory("ball_description"))
"""
CURLY = SETUP_PY.replace('"say =', "\N{LEFT DOUBLE QUOTATION MARK}say =")


def write_sound_packages(source: Path) -> None:
    write_cmake_package(
        source / "ball_msgs",
        INTERFACES,
        "geometry_msgs",
        msg__Ball_DOT_msg="geometry_msgs/Point center\nfloat64 radius\n",
        srv__Throw_DOT_srv="Ball ball\n---\nbool caught\n",
    )
    write_cmake_package(
        source / "ball_description",
        DESCRIPTION,
        urdf__ball_DOT_urdf="<robot/>",
        config__sizes_DOT_yaml="radius: 1.0\n",
        scripts__bounce="#!/bin/sh\necho boing\n",
        scripts__stuck="#!/bin/sh\n",
        ball_tools____init___DOT_py="",
        ball_tools__size_DOT_py="RADIUS = 3\n",
    )
    write_files(source / "ball_description", {"ball_tools/__init__.py": ""})
    write_python_package(
        source / "ball_node",
        SAY,
        "nav_to_mars",
        "nav_home",
        "ball_msgs",
        "ball_description",
        "ball_cpp",
        "ball_bad",
        "python3-no-such-thing",
    )


HOOKED = """\
project(ball_worlds)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/made.dsv "x")
configure_file(hooks/plugins.dsv.in plugins.dsv)
ament_environment_hooks("${CMAKE_CURRENT_SOURCE_DIR}/hooks/${PROJECT_NAME}.dsv.in" hooks/${PROJECT_NAME}.sh.in)
ament_environment_hooks(hooks/only.sh.in ${CMAKE_CURRENT_BINARY_DIR}/plugins.dsv)
ament_environment_hooks(hooks/none.sh hooks/odd.fish)
ament_package()
"""


def write_package_with_hooks(source: Path) -> None:
    """Write one with hooks: as lines and as a script, as a script alone, made by configure_file, and bad ones."""
    script = (
        'ament_prepend_unique_value WORLDS "$AMENT_CURRENT_PREFIX/share/@PROJECT_NAME@/worlds"\n'
        "ament_append_unique_value WORLDS /last\n"
    )
    write_cmake_package(source / "ball_worlds", HOOKED)
    write_files(
        source / "ball_worlds",
        {
            "hooks/ball_worlds.dsv.in": "prepend-non-duplicate;MODELS;share/@PROJECT_NAME@/models\n",
            "hooks/ball_worlds.sh.in": script.replace("WORLDS", "MODELS").replace('worlds"', 'models"'),
            "hooks/only.sh.in": script,
            "hooks/plugins.dsv.in": "set;BALL_PLUGINS;lib/${PROJECT_NAME}\n",
            "hooks/odd.fish": "",
        },
    )


def write_faulty_packages(source: Path) -> None:
    write_cmake_package(source / "ball_cpp", "project(ball_cpp)\nadd_executable(ball ball.cpp)\n", "rclcpp")
    mixed = (
        'project(ball_mixed)\nadd_library(x x.cpp)\nrosidl_generate_interfaces(ball_mixed "msg/One.msg")\n'
    )
    write_cmake_package(source / "ball_mixed", mixed, msg__One_DOT_msg="bool one\n")
    bad = (
        'project(ball_bad)\nrosidl_generate_interfaces(ball_bad "msg/Bad.msg")\n'
        "install(DIRECTORY none DESTINATION share/ball_bad)\ninstall(DIRECTORY launch DESTINATION share/ball_bad)\n"
    )
    write_cmake_package(
        source / "ball_bad",
        bad,
        "nav_to_mars",
        msg__Bad_DOT_msg="float64 x\nflot64 y\n",
        launch__ball_DOT_launch_DOT_xml="<launch/>",
    )
    write_python_package(source / "ball_curly", SAY, setup=CURLY)
    write_manifest(source / "ball_xml", "ament_cmake")
    text = (source / "ball_xml" / "package.xml").read_text().replace("</description>", "")
    write_files(source / "ball_xml", {"package.xml": text, "CMakeLists.txt": "project(ball_xml)\n"})
    write_python_package(source / "ball_typeless", SAY)
    text = (source / "ball_typeless" / "package.xml").read_text()
    write_files(source / "ball_typeless", {"package.xml": text.replace("build_type", "other")})
    write_manifest(source / "ball_empty", "ament_cmake")
    for folder in ("one", "two"):
        write_manifest(source / folder / "twin", "ament_cmake")
        write_files(source / folder / "twin", {"CMakeLists.txt": "project(twin)\n"})


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    """Build a workspace of sound and of faulty packages."""
    folder = tmp_path_factory.mktemp("workspace")
    write_sound_packages(folder / "src")
    write_faulty_packages(folder / "src")
    write_package_with_hooks(folder / "src")
    return colcon(folder, "build")


def test_what_can_be_built_is_built_and_the_rest_fails(built: Built) -> None:
    assert built.code == 1
    assert "6 packages finished" in built.output
    assert "6 packages failed: ball_bad ball_curly ball_empty ball_typeless ball_xml twin" in built.output
    assert "Traceback" not in built.output


def test_each_fault_is_a_sentence_with_its_place(built: Built) -> None:
    source = built.folder / "src"
    assert f"{source}/ball_bad/msg/Bad.msg:2:1: " in built.output
    assert (
        "src/ball_curly/setup.py:12:39: curly quotes \N{LEFT DOUBLE QUOTATION MARK} from a web page"
        in built.output
    )
    assert (
        'type this line as\n    entry_points={"console_scripts": ["say = ball_curly.say:main"]},'
        in built.output
    )
    assert "src/ball_xml/package.xml:11:3: not XML: mismatched tag" in built.output
    assert (
        "src/ball_typeless/package.xml: a build type is missing: add <export><build_type>ament_python"
        in built.output
    )
    assert f"{source}/ball_empty: a package of build type ament_cmake needs a CMakeLists.txt" in built.output
    assert "2 packages are named 'twin', so none of them is built" in built.output
    assert "\n    src/one/twin\n    src/two/twin\n" in built.output
    assert f"{source}/ball_description/CMakeLists.txt:6: mystery() isn't understood" in built.output
    assert "install(FILES …) puts stuck into lib/ball_description without the permission" in built.output


def test_files_of_a_package_are_installed_though_a_part_of_it_fails(built: Built) -> None:
    assert (
        f"{built.folder}/src/ball_bad/CMakeLists.txt:3: install(DIRECTORY …): there is no folder none"
        in built.output
    )
    share = built.folder / "install" / "ball_bad" / "share"
    assert (share / "ball_bad" / "launch" / "ball.launch.xml").read_text() == "<launch/>"
    assert (share / "ament_index" / "resource_index" / "packages" / "ball_bad").is_file()
    assert not (share / "ball_bad" / "msg").exists()


def test_compiled_package_is_left_out_and_its_users_are_warned(built: Built) -> None:
    path = f"{built.folder}/src/ball_cpp/CMakeLists.txt"
    left_out = f"ball_cpp is left out: {path}:2 has add_executable(ball …), which needs C++ and a ROS install"
    assert left_out in built.output
    warning = "ball_node depends on ball_bad, which failed and ball_cpp, which is left out"
    assert warning in built.output
    asks = "ball_node asks for nav_home, nav_to_mars in package.xml: neither in this workspace, nor sourced"
    assert asks in built.output
    assert (
        "ball_node asks for python3-no-such-thing in package.xml: which is not installed: pip in"
        in built.output
    )
    assert "asks for rclcpp" not in built.output
    *packages, refusal = in_shell(built.folder, "tfloom pkg list; tfloom run ball_cpp ball").splitlines()
    assert "ball_cpp" in packages
    assert refusal == (
        f"No executable found: ball is a program in C++, which is left out of the build: {path}:2 has "
        "add_executable(ball …), which needs a ROS install"
    )


def test_package_with_interfaces_and_cpp_is_built_without_the_latter(built: Built) -> None:
    path = f"{built.folder}/src/ball_mixed/CMakeLists.txt"
    assert f"ball_mixed is built without its C++: {path}:2 has add_library(x …)" in built.output
    assert in_shell(built.folder, "tfloom interface show ball_mixed/msg/One") == "bool one"


def test_files_and_programs_are_installed(built: Built) -> None:
    prefix = built.folder / "install" / "ball_description"
    share = prefix / "share" / "ball_description"
    assert (share / "urdf" / "ball.urdf").read_text() == "<robot/>"
    assert (share / "sizes.yaml").is_file()
    assert (share / "package.xml").is_file()
    radius = "python -c 'from ball_tools.size import RADIUS; print(RADIUS)'"
    assert in_shell(built.folder, f"tfloom run ball_description bounce; {radius}") == "boing\n3"


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_program_runs_in_the_sourced_workspace(shell: str, built: Built) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    share = built.folder / "install" / "ball_description" / "share" / "ball_description"
    shown = in_shell(built.folder, "tfloom run ball_node say; tfloom interface package ball_msgs", shell)
    assert shown.splitlines() == [f"said 2.0 {share}", "ball_msgs/msg/Ball", "ball_msgs/srv/Throw"]


@pytest.mark.parametrize("shell", ["bash", "sh"])
def test_workspace_is_sourced_where_the_path_of_python_has_a_space(
    shell: str, built: Built, tmp_path: Path
) -> None:
    python = tmp_path / "my robots" / "python"
    python.parent.mkdir()
    python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    python.chmod(0o755)
    python_of_scripts = {"COLCON_PYTHON_EXECUTABLE": str(python)}
    assert in_shell(built.folder, "tfloom run ball_description bounce", shell, **python_of_scripts) == "boing"


@pytest.mark.parametrize("shell", ["bash", "zsh", "sh"])
def test_scripts_set_the_variables_of_a_sourced_ros(
    shell: str, built: Built, monkeypatch: pytest.MonkeyPatch
) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    for name in ROS_ENVIRONMENT:
        monkeypatch.delenv(name, raising=False)
    show = "echo $ROS_DISTRO $ROS_VERSION $ROS_PYTHON_VERSION"
    kept = f"export ROS_DISTRO=rolling; . install/setup.{shell}; {show}"
    package = f"unset ROS_DISTRO; . install/ball_node/share/ball_node/package.sh; {show}"
    shown = in_shell(built.folder, f"cd '{built.folder}'; {show}; {kept}; {package}", shell)
    assert shown.splitlines() == ["jazzy 2 3", "rolling 2 3", "jazzy 2 3"]


@pytest.mark.parametrize("shell", ["bash", "zsh", "sh"])
@pytest.mark.parametrize("script", ["install/setup.{}", "install/ball_worlds/share/ball_worlds/package.{}"])
def test_hooks_of_packages_set_variables(shell: str, script: str, built: Built) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    prefix = built.folder / "install" / "ball_worlds"
    source = f". ./{script.format(shell)}"
    show = 'echo "$MODELS"; echo "$WORLDS"; echo "${AMENT_CURRENT_PREFIX-none}"; echo "${BALL_PLUGINS-none}"'
    once = f"unset MODELS WORLDS BALL_PLUGINS; {source}; set -u; {show}; set +u"
    again = f"{source}; echo $WORLDS; export WORLDS=/mine; {source}; echo $WORLDS"
    shown = in_shell(built.folder, f"cd '{built.folder}'; {once}; {again}", shell)
    models, worlds, left, plugins, twice, added = shown.split()
    assert models.split(":")[0] == f"{prefix}/share/ball_worlds/models"
    assert worlds == twice == f"{prefix}/share/ball_worlds/worlds:/last"
    assert left == "none"
    assert plugins == ("lib/ball_worlds" if "setup" in script else "none")
    assert added == worlds.replace(":", ":/mine:")


def test_hooks_that_can_not_be_used_are_named(built: Built) -> None:
    assert (
        "CMakeLists.txt:6: ament_environment_hooks(): hooks/none.sh is left out, because it can't be read"
        in (built.output)
    )
    assert "hooks/odd.fish is left out: its name ends in none of dsv, sh, bash, zsh, ps1, bat" in built.output
    environment = built.folder / "install" / "ball_worlds" / "share" / "ball_worlds" / "environment"
    assert sorted(path.name for path in environment.iterdir()) == [
        "ball_worlds.dsv",
        "ball_worlds.sh",
        "only.sh",
        "plugins.dsv",
    ]


def test_scripts_of_powershell_set_the_same_paths(built: Built) -> None:
    share = built.folder / "install" / "ball_msgs" / "share" / "ball_msgs"
    assert (built.folder / "install" / "setup.ps1").is_file()
    hooks = (share / "package.ps1").read_text()
    assert "ament_prefix_path.ps1" in hooks
    assert "AMENT_PREFIX_PATH" in (share / "hook" / "ament_prefix_path.ps1").read_text()
    assert "ros_environment.ps1" in hooks
    assert '$Env:ROS_DISTRO = "jazzy"' in (share / "hook" / "ros_environment.ps1").read_text()


def test_workspace_is_an_underlay_of_another(built: Built, tmp_path: Path) -> None:
    upper = (
        'project(upper_msgs)\nrosidl_generate_interfaces(upper_msgs "msg/Two.msg" DEPENDENCIES ball_msgs)\n'
    )
    write_cmake_package(
        tmp_path / "src" / "upper_msgs", upper, "ball_msgs", msg__Two_DOT_msg="ball_msgs/Ball[2] balls\n"
    )
    in_shell(built.folder, f"cd '{tmp_path}' && colcon build")
    code = "from upper_msgs.msg import Two; print(Two().balls[1].radius)"
    assert in_shell(tmp_path, f"python -c '{code}'", AMENT_PREFIX_PATH="") == "0.0"


def test_links_follow_edits_and_copies_do_not(tmp_path: Path) -> None:
    write_sound_packages(tmp_path / "src")
    shutil.rmtree(tmp_path / "src" / "ball_node")
    source = tmp_path / "src" / "ball_description" / "config" / "sizes.yaml"
    installed = tmp_path / "install" / "ball_description" / "share" / "ball_description" / "sizes.yaml"
    linked = colcon(tmp_path, "build", "--symlink-install")
    assert linked.code == 0, linked.output
    assert (
        "scripts/bounce is not marked as executable, so it is copied, not linked: chmod +x" in linked.output
    )
    source.write_text("radius: 2.0\n")
    assert installed.read_text() == "radius: 2.0\n"
    ball = tmp_path / "src" / "ball_msgs" / "msg" / "Ball.msg"
    ball.write_text("float64 weight\n")
    assert in_shell(tmp_path, "tfloom interface show ball_msgs/msg/Ball") == "float64 weight"
    copied = colcon(tmp_path, "build")
    assert copied.code == 0, copied.output
    source.write_text("radius: 3.0\n")
    assert installed.read_text() == "radius: 2.0\n"
    assert source.read_text() == "radius: 3.0\n"


@pytest.mark.slow
def test_renamed_files_are_renamed_where_they_are_installed(tmp_path: Path) -> None:
    setup = SETUP_PY.replace(
        '["package.xml"]),', '["package.xml"]),\n        ("share/{name}", glob("launch/*"))'
    ).replace("from setuptools", "from glob import glob\n\nfrom setuptools")
    write_python_package(tmp_path / "src" / "roll", "def main(): pass\n", setup=setup)
    cmake = "project(fall)\ninstall(DIRECTORY launch/ DESTINATION share/${PROJECT_NAME})\n"
    write_cmake_package(tmp_path / "src" / "fall", cmake)
    names = ["a.launch.py", "b.launch.py", "c.launch.py", "d.launch.py"]
    for package in ("roll", "fall"):
        write_files(tmp_path / "src" / package, {f"launch/{names[0]}": ""})
    for number, options in enumerate(
        (["--symlink-install"], ["--symlink-install"], [], ["--symlink-install"])
    ):
        result = colcon(tmp_path, "build", *options)
        assert result.code == 0, result.output
        for package in ("roll", "fall"):
            share = tmp_path / "install" / package / "share" / package
            found = sorted(path.name for path in share.glob("*.launch.py"))
            assert found == names[number : number + 1]
            launch = tmp_path / "src" / package / "launch"
            if number < 3:
                (launch / names[number]).rename(launch / names[number + 1])
