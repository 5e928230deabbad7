"""Launch descriptions in files: Python, XML, YAML, and what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument
from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.core.circular_includes import CircularIncludeError, refuse_circle
from tfloom.launch.core.invalid_launch_file_error import InvalidLaunchFileError
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.entities.launch_description_source import LaunchDescriptionSource
from tfloom.launch.files.sources import (
    AnyLaunchDescriptionSource,
    FrontendLaunchDescriptionSource,
    InvalidPythonLaunchFileError,
    PythonLaunchDescriptionSource,
    get_launch_description_from_any_launch_file,
    get_launch_description_from_python_launch_file,
    load_python_launch_file_as_module,
)
from tfloom.launch.files.xml_file import Parser as XmlParser
from tfloom.launch.files.xml_file import XMLLaunchDescriptionSource
from tfloom.launch.files.yaml_file import YAMLLaunchDescriptionSource
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError
from tfloom.launch.substitutions.variables import LaunchConfiguration

PYTHON = """
from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument
from tfloom.launch.entities.launch_description import LaunchDescription


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument("who")])
"""
XML = '<launch><arg name="who"/></launch>'
YAML = "launch: [{arg: {name: who}}]"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in {
        "a.launch.py": PYTHON,
        "a.launch.xml": XML,
        "a.launch.yaml": YAML,
        "a.yml": YAML,
    }.items():
        (tmp_path / name).write_text(text)
    for name, text in {"py": PYTHON, "xml": XML, "yaml": YAML}.items():
        (tmp_path / f"{name}_in_a.file").write_text(text)
        (tmp_path / f"{name}_without").write_text(text)
    return tmp_path


@pytest.mark.parametrize(
    ("source", "name", "method"),
    [
        (PythonLaunchDescriptionSource, "a.launch.py", "interpreted python launch file"),
        (FrontendLaunchDescriptionSource, "a.launch.xml", "interpreted frontend launch file"),
        (XMLLaunchDescriptionSource, "a.launch.xml", "interpreted XML launch file"),
        (XMLLaunchDescriptionSource, "xml_in_a.file", "interpreted XML launch file"),
        (YAMLLaunchDescriptionSource, "a.launch.yaml", "interpreted YAML launch file"),
        (YAMLLaunchDescriptionSource, "a.yml", "interpreted YAML launch file"),
        *[
            (AnyLaunchDescriptionSource, name, "interpreted launch file of any language")
            for name in (
                "a.launch.py",
                "a.launch.xml",
                "a.launch.yaml",
                "a.yml",
                "py_in_a.file",
                "xml_in_a.file",
                "yaml_in_a.file",
                "py_without",
                "xml_without",
                "yaml_without",
            )
        ],
    ],
)
def test_source(source: type[LaunchDescriptionSource], name: str, method: str, folder: Path) -> None:
    context = LaunchContext()
    context.launch_configurations["folder"] = str(folder)
    loaded = source([LaunchConfiguration("folder"), "/", name])
    assert loaded.method == method
    assert loaded.location == f"LaunchConfig('folder') + '/' + '{name}'"
    description = loaded.get_launch_description(context)
    (argument,) = description.entities
    assert isinstance(argument, DeclareLaunchArgument)
    assert argument.name == "who"
    assert loaded.location == str(folder / name)
    assert loaded.get_launch_description(context) is description
    known = source(str(folder / name)).try_get_launch_description_without_context()
    assert isinstance(known, LaunchDescription)
    assert source([LaunchConfiguration("x"), name]).try_get_launch_description_without_context() is None


def test_parser_of_a_source(folder: Path) -> None:
    loaded = FrontendLaunchDescriptionSource(str(folder / "a.launch.yaml"), parser=XmlParser)
    with pytest.raises(InvalidFrontendLaunchFileError, match=r"a.launch.yaml:1: it is not well-formed XML"):
        loaded.get_launch_description(LaunchContext())


FUNCTION = "def generate_launch_description():\n"


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("x = 1\n\nx(\n", ":3: SyntaxError: '(' was never closed"),
        ("import no_such_module\n", ":1: ModuleNotFoundError: No module named 'no_such_module'"),
        (f"{FUNCTION}    a = 1\n    return b\n", ":3: NameError: name 'b' is not defined"),
        ("import json\n\n\njson.loads('{')\n", ":4: JSONDecodeError: Expecting property name"),
        (f"import json\n{FUNCTION}    return json.loads('[')\n", ":3: JSONDecodeError: "),
        (f"{FUNCTION}    raise RuntimeError('no robot')\n", ":2: RuntimeError: no robot"),
        ("{}['pkg']\n", ":1: KeyError: 'pkg'"),
        (f"{FUNCTION}    1\n", ":1: generate_launch_description() returns None, and should return"),
        (f"\n{FUNCTION}    return []\n", ":2: generate_launch_description() returns a value of type list"),
        ("import broken_helper\n", ":1: SyntaxError: "),
    ],
)
def test_error_in_a_python_file_has_its_line(
    text: str, error: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "broken_helper.py").write_text("x = (\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    path = tmp_path / "a.launch.py"
    path.write_text(text)
    with pytest.raises(InvalidPythonLaunchFileError) as raised:
        get_launch_description_from_python_launch_file(str(path))
    assert str(raised.value).startswith(f"{path}{error}")
    with pytest.raises(InvalidLaunchFileError) as wrapped:
        get_launch_description_from_any_launch_file(str(path))
    assert str(wrapped.value) == str(raised.value)
    assert isinstance(wrapped.value.__cause__, InvalidPythonLaunchFileError)


def test_python_file_without_the_function(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.py"
    path.write_text("x = 1")
    what = f"launch file at '{path}' does not contain the required function 'generate_launch_description()'"
    with pytest.raises(InvalidPythonLaunchFileError) as raised:
        get_launch_description_from_python_launch_file(str(path))
    assert str(raised.value) == what
    path.write_text("def generate_launch_descripton(): ...")
    with pytest.raises(InvalidPythonLaunchFileError) as raised:
        get_launch_description_from_python_launch_file(str(path))
    assert str(raised.value) == f"{what}; did you mean 'generate_launch_descripton'?"


def test_python_file_as_a_module(folder: Path) -> None:
    module = load_python_launch_file_as_module(str(folder / "a.launch.py"))
    assert module.__file__ == str(folder / "a.launch.py")
    assert isinstance(module.generate_launch_description(), LaunchDescription)


@pytest.mark.parametrize(
    ("name", "near"),
    [
        ("b.launch.py", ""),
        ("aa.launch.xml", "; did you mean 'a.launch.py'?"),
        ("a.launch.yaaml", "; did you mean 'a.launch.py'?"),
    ],
)
def test_missing_file(name: str, near: str, folder: Path) -> None:
    path = folder / name
    for source in (
        AnyLaunchDescriptionSource,
        PythonLaunchDescriptionSource,
        FrontendLaunchDescriptionSource,
    ):
        with pytest.raises(FileNotFoundError) as raised:
            source(str(path)).get_launch_description(LaunchContext())
        assert str(raised.value) == f"[Errno 2] No such file or directory: '{path}'{near}"


def test_missing_folder_and_folder_in_place_of_a_file(folder: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"there is no folder '.*/none'"):
        get_launch_description_from_any_launch_file(str(folder / "none" / "a.py"))
    with pytest.raises(IsADirectoryError):
        get_launch_description_from_any_launch_file(str(folder))


def test_file_of_an_unknown_language(tmp_path: Path) -> None:
    path = tmp_path / "a.lunch"
    path.write_text("<launch>\n<nod/></launch>")
    with pytest.raises(InvalidLaunchFileError) as raised:
        get_launch_description_from_any_launch_file(str(path))
    assert "a.lunch: The launch file may have a syntax error, or its format is unknown" in str(raised.value)
    assert "(its extension '.lunch' is none of .py, .xml, .yaml, .yml)" in str(raised.value)
    assert str(raised.value).endswith("a.lunch:2: Unrecognized entity of the type: nod; did you mean 'node'?")
    path.write_text("x = ")
    with pytest.raises(InvalidLaunchFileError, match=r"a.lunch:1: SyntaxError: invalid syntax$"):
        get_launch_description_from_any_launch_file(str(path))


def test_error_without_a_text_of_its_own() -> None:
    assert (
        str(InvalidLaunchFileError()) == "The launch file may have a syntax error, or its format is unknown"
    )
    errors = [ValueError("a"), KeyError("b")]
    error = InvalidLaunchFileError("xml", likely_errors=errors)
    assert str(error) == (
        "Caught multiple exceptions when trying to load file of format [xml]:\n - ValueError: a\n - KeyError: 'b'"
    )
    assert error.__cause__ is errors[0]
    assert str(InvalidLaunchFileError("xml", likely_errors=errors[:1])) == (
        "Caught exception when trying to load file of format [xml]:\n - ValueError: a"
    )


def include(context: LaunchContext, *paths: str) -> None:
    """Include each file in the one before it."""
    for path in paths:
        refuse_circle(context, path)
        context.extend_locals({"current_launch_file_path": path})


def test_circle_of_includes_is_refused() -> None:
    with pytest.raises(CircularIncludeError) as raised:
        include(LaunchContext(), "/a", "/b", "/c", "/b")
    assert str(raised.value) == "launch files include each other in a circle: /b -> /c -> /b"
    with pytest.raises(CircularIncludeError, match=r"/a -> /a$"):
        include(LaunchContext(), "/a", "/a")


def test_file_included_twice_by_one_file_is_no_circle(context: LaunchContext) -> None:
    include(context, "/a")
    for _ in range(100):
        include(context, "/b", "/c")
        context.extend_locals({"current_launch_file_path": "/a"})


def test_file_may_include_itself_with_other_arguments(context: LaunchContext) -> None:
    for number in range(50):
        context.launch_configurations["n"] = str(number)
        include(context, "/a")
    context.launch_configurations["n"] = "50"
    with pytest.raises(CircularIncludeError, match=r"included 50 levels deep: /a -> /a -> /a -> /a"):
        include(context, "/a")


def test_actions_of_a_timer_know_their_launch_file(tmp_path: Path, launch: Callable[..., Any]) -> None:
    path = tmp_path / "a.launch.yaml"
    path.write_text("launch: [{timer: {period: 0.01, children: [{log: {message: $(dirname) $(filename)}}]}}]")
    ran = launch(IncludeLaunchDescription(str(path)))
    assert (ran.code, ran.lines) == (0, [f"[INFO] [launch.user]: {tmp_path} {path}"])
