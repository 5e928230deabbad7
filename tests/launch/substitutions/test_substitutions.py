"""Each substitution of launch.substitutions."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

import pytest

from tfloom.launch.core.base_classes import Substitution, SubstitutionFailure, TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.logs.logging import launch_config
from tfloom.launch.substitutions.anon_name import AnonName
from tfloom.launch.substitutions.command import Command
from tfloom.launch.substitutions.comparisons import (
    AllSubstitution,
    AndSubstitution,
    AnySubstitution,
    EqualsSubstitution,
    IfElseSubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
)
from tfloom.launch.substitutions.file_content import FileContent
from tfloom.launch.substitutions.find_executable import FindExecutable
from tfloom.launch.substitutions.joins import PathJoinSubstitution, PathSubstitution, StringJoinSubstitution
from tfloom.launch.substitutions.launch_files import LaunchLogDir, ThisLaunchFile, ThisLaunchFileDir
from tfloom.launch.substitutions.python_expression import PythonExpression
from tfloom.launch.substitutions.variables import (
    EnvironmentVariable,
    ForEachVar,
    ForLoopIndex,
    LaunchConfiguration,
    LocalSubstitution,
)


@pytest.fixture
def context() -> LaunchContext:
    context = LaunchContext()
    context.launch_configurations.update(who="world", number="3", empty="", yes="true", no="false")
    return context


WHO = LaunchConfiguration("who")
YES = LaunchConfiguration("yes")


@pytest.mark.parametrize(
    ("substitution", "text", "description"),
    [
        (TextSubstitution(text="a b"), "a b", "'a b'"),
        (WHO, "world", "LaunchConfig('who')"),
        (LaunchConfiguration(["w", TextSubstitution(text="ho")]), "world", "LaunchConfig('w' + 'ho')"),
        (LaunchConfiguration("none", default=["a", WHO, 1]), "aworld1", "LaunchConfig('none')"),
        (LaunchConfiguration("none", default=2.5), "2.5", "LaunchConfig('none')"),
        (EnvironmentVariable("NO_SUCH", default_value=["x", WHO]), "xworld", "EnvVar('NO_SUCH')"),
        (EnvironmentVariable("NO_SUCH", default_value=""), "", "EnvVar('NO_SUCH')"),
        (PathJoinSubstitution(["/a", WHO, "b.yaml"]), "/a/world/b.yaml", None),
        (PathJoinSubstitution(["/a", ["c_", WHO, ".yaml"]]), "/a/c_world.yaml", None),
        (PathJoinSubstitution([WHO, ""]), "world/", "PathJoinSubstitution('LaunchConfig('who'), ''')"),
        (PathSubstitution("/a") / WHO / ["b", ".x"], "/a/world/b.x", None),
        (
            StringJoinSubstitution([["https://", WHO], "ros", "org"], delimiter="."),
            "https://world.ros.org",
            None,
        ),
        (StringJoinSubstitution(["a", "b"]), "ab", "StringJoinSubstitution(['a', 'b'], delimiter='')"),
        (PythonExpression(["1+", "2"]), "3", "PythonExpr('1+' + '2', ['math'])"),
        (PythonExpression(["ceil(", LaunchConfiguration("number"), " / 2)"]), "2", None),
        (PythonExpression("math.floor(2.5) + sys.maxsize * 0", ["math", "sys"]), "2", None),
        (PythonExpression("[x for x in 'ab']"), "['a', 'b']", None),
        (EqualsSubstitution(WHO, "world"), "true", "EqualsSubstitution(LaunchConfig('who') 'world')"),
        (EqualsSubstitution(["w", WHO], "wworld"), "true", None),
        (EqualsSubstitution("a", "A"), "false", None),
        (EqualsSubstitution(True, "1"), "true", None),
        (EqualsSubstitution(False, "FALSE"), "true", None),
        (EqualsSubstitution(True, "yes"), "false", None),
        (EqualsSubstitution(None, ""), "true", None),
        (EqualsSubstitution(1, "1.0"), "true", None),
        (EqualsSubstitution(0.1 + 0.2, "0.3"), "true", None),
        (EqualsSubstitution("nan", "nan"), "false", None),
        (NotEqualsSubstitution(WHO, "moon"), "true", "NotEqualsSubstitution(LaunchConfig('who') 'moon')"),
        (NotEqualsSubstitution("3.0", 3), "false", None),
        (NotSubstitution("true"), "false", "NotSubstitution('true')"),
        (NotSubstitution("0"), "true", None),
        (AndSubstitution("true", YES), "true", "AndSubstitution('true' LaunchConfig('yes'))"),
        (AndSubstitution("true", "false"), "false", None),
        (OrSubstitution("false", YES), "true", "OrSubstitution('false' LaunchConfig('yes'))"),
        (OrSubstitution("off", "False"), "false", None),
        (AnySubstitution("0", "on", "false"), "true", "AnySubstitution('0' 'on' 'false')"),
        (AnySubstitution(), "false", None),
        (AllSubstitution("1", "true", YES), "true", "AllSubstitution('1' 'true' LaunchConfig('yes'))"),
        (AllSubstitution("1", "false"), "false", None),
        (AllSubstitution(), "true", None),
        (IfElseSubstitution(YES, "a", "b"), "a", "IfElseSubstitution(LaunchConfig('yes'), 'a', 'b')"),
        (IfElseSubstitution("false", "a"), "", None),
        (IfElseSubstitution("0", LaunchConfiguration("not performed"), ["c", WHO]), "cworld", None),
        (ForEachVar("n", default_value="d"), "d", "ForEachVar(name='n', default_value='d')"),
    ],
)
def test_text_and_description(
    substitution: Substitution, text: str, description: str | None, context: LaunchContext
) -> None:
    assert substitution.perform(context) == text
    assert isinstance(substitution.describe(), str)
    if description is not None:
        assert substitution.describe() == description


@pytest.mark.parametrize(
    ("substitution", "error"),
    [
        (LaunchConfiguration("wo"), "launch configuration 'wo' does not exist; did you mean 'who'?"),
        (LaunchConfiguration("zzz"), "launch configuration 'zzz' does not exist"),
        (EnvironmentVariable("NO_SUCH"), "environment variable 'NO_SUCH' does not exist"),
        (FindExecutable(name="no-such-program"), "executable 'no-such-program' not found on the PATH"),
        (FileContent("/no/such/file"), "File not found: /no/such/file"),
        (FileContent("/"), "File cannot be read: /: "),
        (NotSubstitution("maybe"), "'maybe' is neither true nor false: "),
        (AndSubstitution("true", WHO), "LaunchConfig('who') is neither true nor false: "),
        (AllSubstitution("false", "2"), "'2' is neither true nor false: "),
        (IfElseSubstitution("?", "a"), "'?' is neither true nor false: "),
        (ThisLaunchFile(), "ThisLaunchFile used outside of a launch file (in a script)"),
        (ThisLaunchFileDir(), "ThisLaunchFileDir used outside of a launch file (in a script)"),
        (LocalSubstitution("nothing"), "LocalSubstitution 'nothing': "),
        (Command("no-such-program x"), "file not found: "),
        (Command("'"), 'the command "\'" cannot be run: No closing quotation'),
        (Command(""), "the command '' cannot be run: "),
        (Command("true", on_stderr="shout"), "expected 'on_stderr' to be one of: "),
    ],
)
def test_failure(substitution: Substitution, error: str, context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure) as raised:
        substitution.perform(context)
    assert str(raised.value).startswith(error)


def test_error_of_a_python_expression_keeps_its_type_and_names_the_expression(context: LaunchContext) -> None:
    with pytest.raises(NameError, match=r"^name 'x' is not defined, in the Python expression 'x \+ 1'$"):
        PythonExpression("x + 1").perform(context)
    with pytest.raises(SyntaxError, match="in the Python expression '1 \\+'"):
        PythonExpression("1 +").perform(context)
    with pytest.raises(NameError, match="ceil"):
        PythonExpression("ceil(1.5)", []).perform(context)


def test_if_else_needs_a_text() -> None:
    with pytest.raises(RuntimeError, match="One of if_value and else_value must be specified"):
        IfElseSubstitution("true")


def test_anonymous_name_is_the_same_in_a_launch_and_another_in_the_next(context: LaunchContext) -> None:
    name = AnonName("node").perform(context)
    assert name.startswith("node_")
    assert str(os.getpid()) in name
    assert name.replace("_", "").isalnum()
    assert AnonName(["no", "de"]).perform(context) == name
    assert AnonName("other").perform(context) != name
    assert AnonName("node").perform(LaunchContext()) != name
    assert AnonName("node").describe() == "AnonName('node')"


def python_command(code: str) -> str:
    return shlex.join([sys.executable, "-c", code])


def test_command_returns_the_output(context: LaunchContext) -> None:
    assert Command(python_command("print('a b')")).perform(context) == "a b\n"
    assert Command([python_command("import sys; print(sys.argv[1])"), " 'x y'"]).perform(context) == "x y\n"
    assert Command("ls").describe() == "Command('ls')"


def test_command_has_the_environment_of_the_context(context: LaunchContext) -> None:
    context.environment["TFLOOM_TEST"] = "here"
    shown = Command(python_command("import os; print(os.environ['TFLOOM_TEST'])")).perform(context)
    assert shown == "here\n"


LOUD = python_command("import sys; print('out', flush=True); print('err', file=sys.stderr)")


def test_command_that_writes_to_stderr(caplog: pytest.LogCaptureFixture, context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match="executed command showed stderr output") as raised:
        Command(LOUD).perform(context)
    assert "err" in str(raised.value)
    assert Command(LOUD, on_stderr="ignore").perform(context) == "out\n"
    assert Command(LOUD, on_stderr="capture").perform(context) == "out\nerr\n"
    assert Command(LOUD, on_stderr="warn").perform(context) == "out\n"


def test_command_that_fails() -> None:
    command = python_command("import sys; sys.exit('broken')")
    with pytest.raises(SubstitutionFailure, match="executed command failed") as raised:
        Command(command).perform(LaunchContext())
    assert "Captured stderr output: broken" in str(raised.value)


def test_file_content(tmp_path: Path, context: LaunchContext) -> None:
    (tmp_path / "world").write_text("größer\n", "utf-8")
    assert FileContent([str(tmp_path), "/", WHO]).perform(context) == "größer\n"
    (tmp_path / "latin").write_bytes(b"\xff")
    with pytest.raises(SubstitutionFailure, match="File cannot be read"):
        FileContent(str(tmp_path / "latin")).perform(context)


def test_find_executable_uses_the_path_of_the_context(tmp_path: Path, context: LaunchContext) -> None:
    program = tmp_path / "my-program"
    program.touch(0o755)
    context.environment["PATH"] = str(tmp_path)
    assert FindExecutable(name=["my-", "program"]).perform(context) == str(program)
    assert FindExecutable(name="x").describe() == "FindExec('x')"


def test_environment_variable_of_the_context(context: LaunchContext) -> None:
    context.environment["TFLOOM_TEST"] = "here"
    assert EnvironmentVariable("TFLOOM_TEST", default_value="x").perform(context) == "here"
    with pytest.raises(SubstitutionFailure, match="'TFLOM_TEST' does not exist; did you mean 'TFLOOM_TEST'"):
        EnvironmentVariable("TFLOM_TEST").perform(context)


def test_loop_variables(context: LaunchContext) -> None:
    with pytest.raises(RuntimeError, match="No value available for ForEachVar 'n' and no default value"):
        ForEachVar("n").perform(context)
    context.extend_locals({ForEachVar.get_local_arg_name("n"): "v", ForLoopIndex.get_local_arg_name("i"): 0})
    assert ForEachVar(["n"]).perform(context) == "v"
    assert ForLoopIndex("i").perform(context) == "0"


def test_local_substitution(context: LaunchContext) -> None:
    context.extend_locals({"event": Path("/a/b")})
    assert LocalSubstitution("event.name").perform(context) == "b"
    assert LocalSubstitution("event.name").describe() == "LocalVar('event.name')"
    assert LocalSubstitution("event", "an event").describe() == "LocalVar('an event')"
    with pytest.raises(TypeError, match="expression"):
        LocalSubstitution(1)  # type: ignore[arg-type]


def test_launch_file_and_folder(context: LaunchContext) -> None:
    context.extend_locals({"current_launch_file_path": "/a/b.py", "current_launch_file_directory": "/a"})
    assert ThisLaunchFile().perform(context) == "/a/b.py"
    assert ThisLaunchFileDir().perform(context) == "/a"
    assert [ThisLaunchFile().describe(), ThisLaunchFileDir().describe()] == [
        "ThisLaunchFile()",
        "ThisLaunchFileDir()",
    ]


def test_log_dir(context: LaunchContext, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(launch_config, "_log_dir", str(tmp_path))
    assert LaunchLogDir().perform(context) == str(tmp_path)
    assert LaunchLogDir().describe() == "LaunchLogDir()"


@pytest.mark.parametrize(
    ("substitution", "least", "most", "error"),
    [
        (AllSubstitution, 0, 9, TypeError()),
        (AndSubstitution, 2, 2, TypeError("and substitution expects 2 arguments")),
        (AnonName, 1, 1, TypeError("anon substitution expects 1 argument")),
        (AnySubstitution, 0, 9, TypeError()),
        (Command, 1, 2, ValueError("command substitution expects 1 or 2 arguments")),
        (EnvironmentVariable, 1, 2, TypeError("env substitution expects 1 or 2 arguments")),
        (EqualsSubstitution, 2, 2, TypeError("equals substitution expects 2 arguments")),
        (FileContent, 1, 1, AttributeError("file content substitutions expect 1 argument")),
        (FindExecutable, 1, 1, AttributeError("find-exec substitution expects 1 argument")),
        (ForEachVar, 1, 2, ValueError("ForEachVar substitution expects 1 or 2 arguments")),
        (ForLoopIndex, 1, 2, ValueError("ForLoopIndex substitution expects 1 or 2 arguments")),
        (IfElseSubstitution, 2, 3, TypeError("if substitution expects from 2 or 3 arguments")),
        (LaunchConfiguration, 1, 2, TypeError("var substitution expects 1 or 2 arguments")),
        (LaunchLogDir, 0, 0, TypeError("launch_log_dir/log_dir substitution doesn't expect arguments")),
        (NotEqualsSubstitution, 2, 2, TypeError("equals substitution expects 2 arguments")),
        (NotSubstitution, 1, 1, TypeError("not substitution expects 1 argument")),
        (OrSubstitution, 2, 2, TypeError("or substitution expects 2 arguments")),
        (PathJoinSubstitution, 1, 9, TypeError("path-join substitution expects at least 1 argument")),
        (PythonExpression, 1, 2, TypeError("eval substitution expects 1 or 2 arguments")),
        (
            StringJoinSubstitution,
            2,
            9,
            TypeError(
                "string-join substitution expects at least 2 arguments: 1 delimiter + at least 1 component"
            ),
        ),
        (ThisLaunchFile, 0, 0, TypeError("filename substitution doesn't expect arguments")),
        (ThisLaunchFileDir, 0, 0, TypeError("dirname substitution doesn't expect arguments")),
    ],
)
def test_number_of_arguments_in_launch_files(
    substitution: type, least: int, most: int, error: Exception
) -> None:
    arguments = [[TextSubstitution(text="1")] for _ in range(10)]
    for number in range(10):
        if least <= number <= most:
            assert substitution.parse(arguments[:number])[0] in {substitution, PathJoinSubstitution}
        else:
            with pytest.raises(type(error)) as raised:
                substitution.parse(arguments[:number])
            assert str(raised.value) == str(error)


def test_properties_give_what_was_constructed() -> None:
    assert [part.describe() for part in IfElseSubstitution("1", "a", "b").else_value] == ["'b'"]
    assert [part.describe() for part in PathJoinSubstitution(["a", "b"]).substitutions] == ["'a'", "'b'"]
    nested = PathJoinSubstitution(["a", ["b", "c"]]).substitutions
    assert [part.describe() for part in nested[1]] == ["'b'", "'c'"]
    assert [part.describe() for part in PythonExpression("1", ["sys"]).python_modules] == ["'sys'"]
    assert [part.describe() for part in Command("ls", on_stderr="warn").on_stderr] == ["'warn'"]
    assert EnvironmentVariable("A").default_value is None
