"""`launch`: what the reference printed of sound and broken launch files, and what helps with a mistyped command."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
import transcript
from transcript import launch_here as launch

LAUNCH_FILES = Path(__file__).parents[1] / "golden" / "launch"

_MASKS = (
    (r"(?<=found below ).*", "FOLDER"),
    (r"0x[0-9a-f]+", "0xADDRESS"),
    (r"<tfloom\.launch", "<launch"),
    (r"\[\d+\.\d+\]", "[TIME]"),
    (r"(?<=searching: )\[.*?\]", "PATHS"),
    (r"(?<=which is at )'.*?'", "'FOLDER'"),
    # The module of a class in an object's own text: several files of the reference's are one here.
    (r"<[\w.]+\.(\w+) object at ", r"<\1 object at "),
)


def masked(text: str) -> str:
    for pattern, mask in _MASKS:
        text = re.sub(pattern, mask, text)
    return text


@pytest.fixture(autouse=True)
def in_the_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(LAUNCH_FILES)


@pytest.mark.parametrize(
    "name",
    [
        "launch_bad_need_launch_py",
        "launch_debug",
        "launch_need_given",
        "launch_py_args",
        "launch_py_print",
        "launch_xml_args",
        "launch_yaml_print",
    ],
)
def test_output_equals_the_reference(name: str) -> None:
    recorded = transcript.golden(name)
    ours = launch(*recorded.command[1:])
    assert masked(ours.text) == masked(recorded.text)
    assert ours.exit_code == recorded.exit_code


PARSE_ERRORS = {
    "badattr_launch_xml": "badattr.launch.xml:1: Unexpected attribute(s) found in `node`: {'colour'}",
    "badname_launch_py": "badname.launch.py:3: NameError: name 'x' is not defined",
    "badtag_launch_xml": "badtag.launch.xml:1: Unrecognized entity of the type: nod; did you mean 'node'?",
    "badtag_launch_yaml": "badtag.launch.yaml:2: Unrecognized entity of the type: nod; did you mean 'node'?",
    "broken_launch_xml": "broken.launch.xml:1: it is not well-formed XML: unclosed token: line 1, column 8",
    "nogen_launch_py": "launch file at 'nogen.launch.py' does not contain the required function",
    "badinclude_launch_py": "badinclude.launch.py:5: [Errno 2] No such file or directory: 'nowhere.launch.py'",
    "badexec_launch_yaml": "badexec.launch.yaml:4: executable 'nope' not found",
    "badpkg_launch_yaml": "badpkg.launch.yaml:4: package 'no_such_package' not found",
}
"""What the error of each broken file begins with."""


@pytest.mark.parametrize("name", PARSE_ERRORS)
def test_error_of_a_broken_file_has_the_place_and_the_reason(
    name: str, deviations: dict[str, dict[str, str]]
) -> None:
    assert "launch-file-errors" in deviations
    recorded = transcript.golden(f"launch_bad_{name}")
    ours = launch(*recorded.command[1:])
    intro = "Caught exception in launch (see debug for traceback): "
    before, _, error = ours.text.partition(intro)
    assert masked(before) == masked(recorded.text.partition(intro)[0])
    assert error.lstrip("\"'").startswith(PARSE_ERRORS[name])
    assert "Traceback" not in error
    assert ours.exit_code == recorded.exit_code == 1


def test_choice_that_does_not_exist_has_the_place_of_the_argument() -> None:
    recorded = transcript.golden("launch_py_choice_bad")
    ours = launch(*recorded.command[1:])
    assert masked(ours.text) == masked(recorded.text).replace("traceback): ", "traceback): ok.launch.py:12: ")
    assert ours.exit_code == recorded.exit_code


@pytest.mark.parametrize(
    ("lines", "error"),
    [
        (
            ["def visit(context):", "    return {}['nope']", "entity = OpaqueFunction(function=visit)"],
            "3: KeyError: 'nope'",
        ),
        (
            ["entity = LogInfo(msg=LaunchConfiguration('nope'))"],
            "2: launch configuration 'nope' does not exist",
        ),
        (
            ["entity = LogInfo(msg='', condition=IfCondition('perhaps'))"],
            "2: ",
        ),
    ],
)
def test_error_of_an_action_has_the_place_in_the_file(lines: list[str], error: str, tmp_path: Path) -> None:
    path = tmp_path / "a.launch.py"
    imports = (
        "from launch import LaunchDescription; from launch.actions import LogInfo, OpaqueFunction; "
        "from launch.conditions import IfCondition; from launch.substitutions import LaunchConfiguration"
    )
    end = ["def generate_launch_description():", "    return LaunchDescription([entity])", ""]
    path.write_text("\n".join([imports, *lines, *end]))
    ours = launch(str(path))
    assert f"traceback): {path}:{error}" in ours.text
    assert ours.exit_code == 1


def test_error_of_a_tag_has_its_line(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text('<launch>\n<group>\n<log message="$(var nope)"/></group></launch>')
    assert f"traceback): {path}:3: launch configuration 'nope' does not exist" in launch(str(path)).text


@pytest.mark.parametrize("name", ["file_in_package", "package"])
def test_first_line_of_an_unknown_name_equals_the_reference(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))  # a workspace is sourced there
    recorded = transcript.golden(f"launch_bad_{name}")
    ours = launch(*recorded.command[1:])
    assert masked(ours.text.splitlines()[0]) == masked(recorded.text)
    assert ours.exit_code == recorded.exit_code


def test_usage_equals_the_reference() -> None:
    recorded = transcript.golden("launch_help")
    ours = launch("--help")
    usage = ours.text.split("\n\n")[0]
    assert usage.replace(" [--skip-missing]", "") == recorded.text.split("\n\n")[0]
    flags = re.compile(r"^  (-.*?)(?:  |$)", re.MULTILINE)
    assert [flag for flag in flags.findall(ours.text) if flag != "--skip-missing"] == flags.findall(
        recorded.text
    )


def test_an_argument_that_is_not_declared_is_named(deviations: dict[str, dict[str, str]]) -> None:
    assert "launch-undeclared" in deviations
    recorded = transcript.golden("launch_undeclared")
    ours = launch(*recorded.command[1:])
    *lines, warning = ours.text.splitlines()
    assert masked("\n".join(lines)) == masked(recorded.text)
    assert warning == (
        "[WARNING] [launch]: argument 'other' is not declared by need.launch.py, which declares need"
    )
    near = launch("need.launch.py", "need:=1", "neet:=2")
    assert near.text.endswith("argument 'neet' is not declared by need.launch.py: did you mean need?")
    assert near.exit_code == 0


def test_the_last_of_two_values_counts() -> None:
    assert "[launch.user]: 2=:=\n" in launch("need.launch.py", "need:=1", "need:=2=:=").text + "\n"


@pytest.mark.parametrize("word", ["need", ":=1", "need:=", "need=1"])
def test_malformed_argument(word: str) -> None:
    ours = launch("need.launch.py", word)
    assert ours.text == f"malformed launch argument '{word}', expected format '<name>:=<value>'"
    assert ours.exit_code == 1


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["ned.launch.py"], "launch file 'ned.launch.py' was not found\ndid you mean need.launch.py"),
        (
            ["ned.launch.py", "need:=1"],
            "launch file 'ned.launch.py' was not found\ndid you mean need.launch.py",
        ),
        (["no/such/x.launch.py"], "launch file 'no/such/x.launch.py' was not found"),
        (["turtlesm"], "no package and no launch file is named 'turtlesm'\ndid you mean turtlesim"),
        (
            ["turtlesm", "x.launch.py"],
            "Package 'turtlesm' not found: \"package 'turtlesm' not found, no workspace is sourced in this terminal",
        ),
        (["turtlesim"], "name a launch file of the package turtlesim\nturtlesim has: "),
        (["."], ". is a folder, not a launch file\nlaunch files in it: badattr.launch.xml, "),
    ],
)
def test_unknown_names_give_the_nearest(
    words: list[str], text: str, deviations: dict[str, dict[str, str]]
) -> None:
    assert "launch-no-file" in deviations
    ours = launch(*words)
    assert ours.text.startswith(text)
    assert ours.exit_code == 1


@pytest.mark.parametrize("flag", ["--show-args", "--print"])
def test_a_broken_file_is_shown_without_a_traceback(flag: str) -> None:
    ours = launch(flag, "badname.launch.py")
    assert ours.text == "badname.launch.py:3: NameError: name 'x' is not defined"
    assert ours.exit_code == 1
    ours = launch(flag, "nogen.launch.py")
    assert ours.text.startswith("launch file at 'nogen.launch.py' does not contain the required function")


@pytest.fixture
def package(prefix: Path) -> Callable[[str, str], Path]:
    """Return a function that adds a file to the share folder of the package `my_pkg`, from its path and its text."""

    def add(name: str, text: str) -> Path:
        path = prefix / "share" / "my_pkg" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    return add


def test_files_of_a_package(package: Callable[[str, str], Path]) -> None:
    package("launch/hello.launch.xml", '<launch><log message="hello $(dirname)"/></launch>')
    package("deeper/below/other_launch.py", "")
    assert "[launch.user]: hello " in launch("my_pkg", "hello.launch.xml").text
    mistyped = launch("my_pkg", "helo.launch.xml").text
    assert mistyped.splitlines()[1].startswith("did you mean hello.launch.xml")
    assert launch("my_pkg").text.endswith("\nmy_pkg has: hello.launch.xml, other_launch.py")
    again = package("more/hello.launch.xml", "<launch/>")
    twice = launch("my_pkg", "hello.launch.xml")
    assert "file 'hello.launch.xml' was found more than once" in twice.text
    assert str(again) in twice.text
    assert twice.exit_code == 1


def test_arguments_of_inclusions_and_conditions_are_shown(tmp_path: Path) -> None:
    (tmp_path / "inner.launch.xml").write_text('<launch><arg name="inner" default="$(env HOME)/x"/></launch>')
    outer = tmp_path / "outer.launch.yaml"
    outer.write_text(
        f"launch:\n- include: {{file: {tmp_path}/inner.launch.xml}}\n"
        "- arg: {name: sometimes, if: $(env SOMETIMES false)}\n"
    )
    assert launch(str(outer), "-s").text == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n    'inner':\n        no description given\n"
        "        (default: EnvVar('HOME') + '/x')\n\n    'sometimes':*\n        no description given\n\n"
        "* argument(s) which are only used if specific conditions occur"
    )
    empty = tmp_path / "empty.launch.xml"
    empty.write_text("<launch/>")
    assert launch(str(empty), "-s").text == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n  No arguments."
    )


def test_functions_under_ros_names(
    package: Callable[[str, str], Path], capsys: pytest.CaptureFixture[str]
) -> None:
    from ros2launch import api

    path = package(
        "launch/a.launch.xml", '<launch><arg name="x" default="1"/><log message="$(var x)"/></launch>'
    )
    assert api.get_share_file_path_from_package(package_name="my_pkg", file_name="a.launch.xml") == str(path)
    assert api.is_launch_file(str(path))
    assert not api.is_launch_file(str(path.parent))
    assert api.LaunchFileNameCompleter()("a", SimpleNamespace(package_name="my_pkg")) == ["a.launch.xml"]
    api.print_arguments_of_launch_file(launch_file_path=str(path))
    assert "'x':" in capsys.readouterr().out
    api.print_a_launch_file(launch_file_path=str(path))
    assert "LogInfo(LaunchConfig('x'))" in capsys.readouterr().out
    assert api.launch_a_launch_file(launch_file_path=str(path), launch_file_arguments=["x:=2"]) == 0
    assert "[INFO] [launch.user]: 2" in capsys.readouterr().out
