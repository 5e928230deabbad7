"""`Node`: the command line, parameters, remappings, and what is wrong with them."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.group_action import GroupAction
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.actions.composable_nodes import ComposableNodeContainer
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.actions.node_defaults import (
    PushROSNamespace,
    SetParameter,
    SetParametersFromFile,
    SetRemap,
    SetROSLogDir,
)
from tfloom.launch.ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from tfloom.launch.ros.substitutions import ExecutableInPackage

Words = Callable[..., list[str]]


def show(**options: object) -> Node:
    return Node(package="toys", executable="show", output="screen", **options)


def without_paths(words: list[str]) -> list[str]:
    """Return the words, with the paths of temporary files replaced, and without the files' content."""
    folder = str(Path(tempfile.gettempdir(), "launch_"))
    return [
        "<file>" if word.startswith(folder) else word
        for word in (line.removeprefix("word ") for line in words if line.startswith("word "))
    ]


def content(words: list[str]) -> list[str]:
    return [line.removeprefix("file ") for line in words if line.startswith("file ")]


def test_words_are_in_the_reference_order(words: Words) -> None:
    node = show(
        name="t",
        namespace="ns",
        arguments=["--headless", ["a", TextSubstitution(text="b")]],
        ros_arguments=["--log-level", "info"],
        parameters=[{"rate": 2.0}, Parameter("x", 1)],
        remappings=[("chatter", "said"), ("a", ["b", "c"])],
    )
    assert without_paths(words(node)) == [
        *("--headless", "ab", "--ros-args", "--log-level", "info", "-r", "__node:=t", "-r", "__ns:=/ns"),
        *("--params-file", "<file>", "-p", "x:=1", "-r", "chatter:=said", "-r", "a:=bc"),
    ]


def test_node_without_options_has_only_the_flag(words: Words) -> None:
    assert words(show()) == ["word --ros-args"]


def test_program_without_a_package_is_found_on_the_path(launch: Callable[..., object]) -> None:
    ran = launch(Node(executable="echo", name="t", output="screen"))
    assert "[echo-1] --ros-args -r __node:=t" in ran.lines


def test_process_is_named_by_exec_name(launch: Callable[..., object], toys: Path) -> None:
    assert "[hello-1] word --ros-args" in launch(show(exec_name="hello")).lines


def test_parameters_have_the_types_that_they_were_given(words: Words) -> None:
    given = {
        "flag": True,
        "count": 3,
        "rate": 2.0,
        "text": "2.0",
        "yes": "yes",
        "nested": {"deep": {"list": [1, 2]}},
        "names": ["a", "1"],
        "mixed": [1, 2.5],
        "from_text": TextSubstitution(text="7"),
        "joined": ["a", TextSubstitution(text="b")],
        "each": [[TextSubstitution(text="x")], [TextSubstitution(text="y")]],
        "typed": ParameterValue(TextSubstitution(text="7"), value_type=str),
        "quoted": "it's: #1",
    }
    lines = content(words(show(name="t", namespace="/", parameters=[given])))
    from tfloom.common.yaml import load

    assert load("\n".join(lines)) == {
        "/t": {
            "ros__parameters": {
                "flag": True,
                "count": 3,
                "rate": 2.0,
                "text": "2.0",
                "yes": "yes",
                "nested.deep.list": [1, 2],
                "names": ["a", "1"],
                "mixed": [1.0, 2.5],
                "from_text": 7,
                "joined": "ab",
                "each": ["x", "y"],
                "typed": "7",
                "quoted": "it's: #1",
            }
        }
    }


@pytest.mark.parametrize("options", [{}, {"name": "t"}, {"namespace": "ns"}], ids=str)
def test_parameters_of_a_node_without_a_full_name_are_those_of_each_node(
    words: Words, options: dict[str, str]
) -> None:
    assert content(words(show(**options, parameters=[{"a": 1}]))) == [
        "/**:",
        "  ros__parameters:",
        "    a: 1",
    ]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1, "1"),
        (True, "True"),
        ("a", "a"),
        ("1", "'1'"),
        ([1, 2], "[1, 2]"),
        (["1"], "['1']"),
        (1e20, "1e+20"),
    ],
    ids=str,
)
def test_parameter_objects_keep_their_types(words: Words, value: object, text: str) -> None:
    from tfloom.node.values.scalars import parse_value

    *_, word = words(show(parameters=[Parameter("x", value)]))
    assert word.startswith("word x:=")
    assert parse_value(word.removeprefix("word x:=")) == value
    if text != "1e+20":
        assert word == f"word x:={text}"


def test_groups_scope_what_they_set(words: Words, tmp_path: Path) -> None:
    path = tmp_path / "all.yaml"
    path.write_text("/**: {ros__parameters: {b: 2}}\n", "utf-8")
    group = GroupAction(
        [
            PushROSNamespace("out"),
            GroupAction(
                [
                    PushROSNamespace("in"),
                    SetParameter("a", 1),
                    SetParametersFromFile(str(path)),
                    SetRemap("x", "y"),
                    show(namespace="deep", remappings=[("p", "q")]),
                ]
            ),
            show(),
        ]
    )
    inner = ["-r", "__ns:=/out/in/deep", "-p", "a:=1", "--params-file", str(path), "-r", "x:=y", "-r", "p:=q"]
    assert without_paths(words(group, show())) == [
        *("--ros-args", *inner),
        *("--ros-args", "-r", "__ns:=/out"),
        "--ros-args",
    ]


def test_absolute_namespace_replaces_the_pushed_one(words: Words) -> None:
    group = GroupAction([PushROSNamespace("ns"), show(namespace="/other")])
    assert words(group) == ["word --ros-args", "word -r", "word __ns:=/other"]


def test_log_directory_is_that_of_later_processes(
    launch: Callable[..., object], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path))
    printing = ExecuteProcess(cmd=["sh", "-c", "echo $ROS_LOG_DIR"], output="screen", name="echo")
    ran = launch(GroupAction([SetROSLogDir("deeper"), printing]))
    assert f"[echo-1] {tmp_path / 'deeper'}" in ran.lines


def test_parameter_file_with_substitutions(
    words: Words, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TOY_SPEED", "3.5")
    path = tmp_path / "p.yaml"
    path.write_text("t: {ros__parameters: {speed: $(env TOY_SPEED)}}\n", "utf-8")
    shown = words(show(name="t", parameters=[ParameterFile(path, allow_substs=True)]))
    assert content(shown) == ["t: {ros__parameters: {speed: 3.5}}"]
    assert words(show(parameters=[path]))[-1] == "file " + path.read_text("utf-8").rstrip()


def test_substituted_file_that_is_no_yaml_is_named(
    launch: Callable[..., object], toys: Path, tmp_path: Path
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("t: [$(env NO_SUCH_TOY '}')\n", "utf-8")
    ran = launch(show(parameters=[ParameterFile(path, allow_substs=True)]))
    assert ran.code == 1
    assert str(path) in ran.lines[-1]
    assert "The substituted parameter file is not a valid yaml file" in ran.lines[-1]


def test_temporary_files_end_with_the_launch(
    words: Words, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    import gc

    folder = tmp_path / "tmp"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    assert str(folder) in words(show(parameters=[{"a": 1}]))[2]
    gc.collect()
    assert list(folder.iterdir()) == []


def test_second_node_of_a_name_is_warned_of(launch: Callable[..., object], toys: Path) -> None:
    ran = launch(show(name="t"), show(name="t", namespace="/"), show(name="t", namespace="ns"), show())
    warnings = [line for line in ran.lines if line.startswith("[WARNING]")]
    assert warnings == [
        "[WARNING] [show-2]: there are now at least 2 nodes with the name /t created within this launch context"
    ]


@pytest.mark.parametrize(
    ("text", "options", "warned"),
    [
        ("other: {ros__parameters: {a: 1}}", {"name": "t"}, "/t: it has those of /other"),
        ("t: {ros__parameters: {a: 1}}", {"name": "t", "namespace": "ns"}, "/ns/t: it has those of /t"),
        ("t: {ros__parameters: {a: 1}}", {"name": "t"}, ""),
        ("ns: {t: {ros__parameters: {a: 1}}}", {"name": "t", "namespace": "ns"}, ""),
        ("/**: {ros__parameters: {a: 1}}", {"name": "t"}, ""),
        ("/*/t: {ros__parameters: {a: 1}}", {"name": "t", "namespace": "ns"}, ""),
        ("other: {ros__parameters: {a: 1}}", {}, ""),
        ("", {"name": "t"}, ""),
    ],
)
def test_parameter_file_without_values_for_the_node_is_warned_of(
    launch: Callable[..., object], toys: Path, tmp_path: Path, text: str, options: dict[str, str], warned: str
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(text, "utf-8")
    ran = launch(show(**options, parameters=[str(path)]))
    expected = (
        f"[WARNING] [launch_ros.actions.node]: the parameter file {path} has no values for the node {warned}"
    )
    assert [line for line in ran.lines if "WARNING" in line] == ([expected] if warned else [])


def test_missing_parameter_file_is_warned_of(launch: Callable[..., object], toys: Path) -> None:
    ran = launch(show(parameters=["/nowhere/p.yaml"]))
    assert (
        "[WARNING] [launch_ros.actions.node]: Parameter file path is not a file: /nowhere/p.yaml" in ran.lines
    )
    assert "[show-1] word --ros-args" in ran.lines
    assert "[show-1] word --params-file" not in ran.lines


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (
            {"package": "toy", "executable": "show"},
            "package 'toy' not found, searching: ['<prefix>']; did you mean 'toys'?",
        ),
        (
            {"package": "toys", "executable": "shaw"},
            "executable 'shaw' not found on the libexec directory '<prefix>/lib/toys'; did you mean 'show'?",
        ),
        (
            {"package": "toys", "executable": "x"},
            "executable 'x' not found on the libexec directory '<prefix>/lib/toys'; its programs are show",
        ),
        (
            {"package": "empty", "executable": "x"},
            "package 'empty' found at '<prefix>', but libexec directory '<prefix>/lib/empty' does not exist",
        ),
        (
            {"package": "demo_nodes_py", "executable": "talkr"},
            "not found on the libexec directory '<own>/lib/demo_nodes_py'; did you mean 'talker'?",
        ),
        ({"package": "a b", "executable": "x"}, "'a b' is not a valid package name"),
        ({"package": "toys", "executable": "show", "name": "a b"}, "Invalid node name"),
        ({"package": "toys", "executable": "show", "namespace": "a b"}, "Invalid namespace"),
        (
            {"package": "toys", "executable": "show", "parameters": [{"a": TextSubstitution(text="{b: c}")}]},
            "for parameter a, from '{b: c}'. If the parameter is meant to be a string, try wrapping it in",
        ),
        (
            {
                "package": "toys",
                "executable": "show",
                "parameters": [{"a": TextSubstitution(text="a: b: c")}],
            },
            "Unable to parse the value of parameter a as yaml",
        ),
    ],
)
def test_mistake_ends_the_launch_with_a_line(
    launch: Callable[..., object], toys: Path, node: dict[str, object], expected: str
) -> None:
    from tfloom.workspace import index

    (toys / "share" / "ament_index" / "resource_index" / "packages" / "empty").touch()
    ran = launch(Node(**node))
    assert ran.code == 1
    output = "\n".join(ran.lines).replace(str(toys), "<prefix>").replace(str(index.OWN_PREFIX), "<own>")
    assert expected in output
    assert "[ERROR] [launch]: Caught exception in launch (see debug for traceback): " in output
    assert "Traceback" not in output


def test_file_that_is_not_executable_is_named(launch: Callable[..., object], toys: Path) -> None:
    path = toys / "lib" / "toys" / "stuck"
    path.touch()
    ran = launch(Node(package="toys", executable="stuck"))
    assert ran.code == 1
    assert f"{path} is not marked as executable: chmod +x {path}" in "\n".join(ran.lines)


def test_properties_are_those_of_the_execution(words: Words) -> None:
    node = show(name="t", namespace="ns", remappings=[("a", "b")])
    with pytest.raises(RuntimeError, match="cannot access 'node_name' before executing action"):
        _ = node.node_name
    assert node.expanded_node_namespace == Node.UNSPECIFIED_NODE_NAMESPACE
    assert node.expanded_remapping_rules is None
    assert (node.node_package, node.node_executable) == ("toys", "show")
    words(node)
    assert (node.node_name, node.expanded_node_namespace) == ("/ns/t", "/ns")
    assert node.expanded_remapping_rules == [("a", "b")]
    assert node.is_node_name_fully_specified()


def test_arguments_of_parameters_are_known_after_the_execution(words: Words, tmp_path: Path) -> None:
    file = tmp_path / "p.yaml"
    file.write_text("/**: {ros__parameters: {a: 1}}\n")
    single = Parameter("b", 2)
    node = show(name="t", parameters=[str(file), {"c": 3}, single])
    words(SetParameter("d", value=4), node)
    rule, given, written, parameter = node._Node__expanded_parameter_arguments
    assert (rule, given, parameter) == (("d:=4", False), (str(file), True), (single, False))
    assert written[1]


def test_unspecified_names_are_marked(words: Words) -> None:
    node = show()
    words(node)
    assert node.node_name == f"{Node.UNSPECIFIED_NODE_NAMESPACE}/{Node.UNSPECIFIED_NODE_NAME}"
    assert node.expanded_remapping_rules is None
    assert not node.is_node_name_fully_specified()


def test_description_is_that_of_the_reference() -> None:
    executable = ExecutableInPackage("talker", "demo_nodes_py")
    assert executable.describe() == "ExecInPkg(pkg='demo_nodes_py', exec='talker')"
    assert [part.describe() for part in Node(executable="x", name="t").cmd[-1]] == ["LocalVar('node name')"]


def test_a_container_needs_cpp(launch: Callable[..., object]) -> None:
    ran = launch(
        ComposableNodeContainer(
            name="c", namespace="", package="rclcpp_components", executable="component_container"
        )
    )
    assert ran.code == 1
    assert any("ComposableNodeContainer: composable nodes are C++ libraries" in line for line in ran.lines)


def test_own_program_is_started_by_a_script(
    launch: Callable[..., object], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    ran = launch(
        Node(
            package="tf2_ros",
            executable="static_transform_publisher",
            output="screen",
            arguments=["--frame-id", "a", "--child-frame-id", "a"],
        )
    )
    assert any(
        line.startswith("[INFO] [static_transform_publisher-1]: process started") for line in ran.lines
    )
    assert any("cannot publish static transform from 'a' to 'a'" in line for line in ran.lines), ran.lines


def test_script_works_where_pythons_path_has_a_space(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import subprocess
    import sys

    from tfloom.launch.ros.temporary_files import script_for

    folder = tmp_path / "a space"
    folder.mkdir()
    python = folder / "python"
    python.write_text(f"#!/bin/sh\nexec '{sys.executable}' \"$@\"\n", "utf-8")
    python.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(python))
    context = LaunchContext()
    script = script_for(context, "p", "program", "builtins:print")
    done = subprocess.run([script, "x y"], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == "['x y']\n"
