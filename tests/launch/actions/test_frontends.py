"""The tags of actions: the same in XML and in YAML."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.core.base_classes import SubstitutionFailure
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.files.sources import get_launch_description_from_any_launch_file
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError
from tfloom.launch.utilities.visits import visit_all_entities_and_collect_futures

NAME = "TFLOOM_LAUNCH_TEST"
Visit = Callable[[str], dict[str, str]]


@pytest.fixture
def visit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Visit:
    """Return a function that launches a text in XML or YAML, and returns the launch configurations at its end."""
    monkeypatch.setenv(NAME, "start")

    def launch(text: str) -> dict[str, str]:
        path = tmp_path / f"a.launch.{'xml' if text.startswith('<') else 'yaml'}"
        path.write_text(text)
        context = LaunchContext()
        visit_all_entities_and_collect_futures(IncludeLaunchDescription(str(path)), context)
        return context.launch_configurations

    return launch


def in_both(xml: str, yaml: str) -> pytest.MarkDecorator:
    return pytest.mark.parametrize(
        "text", [f"<launch>{xml}</launch>", f"launch:\n{yaml}"], ids=["xml", "yaml"]
    )


@in_both(
    '<arg name="a" default="1"/><let name="b" value="$(var a)2"/><let name="c" value="3" if="false"/>',
    "- arg: {name: a, default: '1'}\n- let: {name: b, value: $(var a)2}\n- let: {name: c, value: '3', if: 'false'}",
)
def test_arg_and_let(text: str, visit: Visit) -> None:
    assert visit(text) == {"a": "1", "b": "12"}


@in_both(
    '<arg name="mode" default="a" description="d"><choice value="a"/><choice value="b"/></arg>',
    "- arg: {name: mode, default: a, description: d, choice: [{value: a}, {value: b}]}",
)
def test_choices(text: str, visit: Visit, tmp_path: Path) -> None:
    assert visit(text) == {"mode": "a"}
    (path,) = tmp_path.iterdir()
    (argument,) = get_launch_description_from_any_launch_file(str(path)).get_launch_arguments()
    assert argument.choices == ["a", "b"]
    assert argument.description == "d. Valid choices are: ['a', 'b']"
    with pytest.raises(RuntimeError, match="Valid options are"):
        visit(
            text.replace("a</", "</")
            .replace('default="a"', 'default="$(env HOME)"')
            .replace("t: a", "t: $(env HOME)")
        )


@in_both(
    '<group><let name="inner" value="1"/></group><group scoped="false"><let name="outer" value="1"/></group>'
    '<let name="a" value="of outside"/>'
    '<group forwarding="false"><keep name="kept" value="$(var a)"/>'
    '<log message="$(var kept)"/><log message="$(var a none)"/></group>',
    "- group:\n  - let: {name: inner, value: '1'}\n"
    "- group: {scoped: false, children: [{let: {name: outer, value: '1'}}]}\n"
    "- let: {name: a, value: of outside}\n"
    "- group: {forwarding: false, keep: [{name: kept, value: $(var a)}], children: [\n"
    "    {log: {message: $(var kept)}}, {log: {message: $(var a none)}}]}\n",
)
def test_group(text: str, visit: Visit, capsys: pytest.CaptureFixture[str]) -> None:
    assert visit(text) == {"outer": "1", "a": "of outside"}
    assert capsys.readouterr().out.splitlines() == [
        "[INFO] [launch.user]: of outside",
        "[INFO] [launch.user]: none",
    ]


@in_both(
    '<log message="a"/><log level="error" message="b"/><log_warning message="c"/><log_info message="$(env HOME)"/>'
    '<log_error message="d"/><log_debug message="e"/>',
    "- log: {message: a}\n- log: {level: error, message: b}\n- log_warning: {message: c}\n"
    "- log_info: {message: $(env HOME)}\n- log_error: {message: d}\n- log_debug: {message: e}",
)
def test_log(text: str, visit: Visit, capsys: pytest.CaptureFixture[str]) -> None:
    visit(text)
    logged = [("INFO", "a"), ("ERROR", "b"), ("WARNING", "c"), ("INFO", os.environ["HOME"]), ("ERROR", "d")]
    assert capsys.readouterr().out.splitlines() == [
        f"[{level}] [launch.user]: {what}" for level, what in logged
    ]


@in_both(
    f'<group><append_env name="{NAME}" value="1"/>'
    f'<append_env name="{NAME}" value="2" separator=" " prepend="$(env P true)"/>'
    f'<log message="$(env {NAME})"/><reset_env/><log message="$(env {NAME})"/><set_env name="{NAME}" value="3"/>'
    f'<log message="$(env {NAME})"/><unset_env name="{NAME}"/><log message="$(env {NAME} none)"/></group>'
    f'<log message="$(env {NAME})"/>',
    f"- group:\n  - append_env: {{name: {NAME}, value: '1'}}\n"
    f"  - append_env: {{name: {NAME}, value: '2', separator: ' ', prepend: true}}\n"
    f"  - log: {{message: $(env {NAME})}}\n  - reset_env: {{}}\n  - log: {{message: $(env {NAME})}}\n"
    f"  - set_env: {{name: {NAME}, value: '3'}}\n  - log: {{message: $(env {NAME})}}\n"
    f"  - unset_env: {{name: {NAME}}}\n  - log: {{message: $(env {NAME} none)}}\n- log: {{message: $(env {NAME})}}",
)
def test_environment(text: str, visit: Visit, capsys: pytest.CaptureFixture[str]) -> None:
    visit(text)
    logged = ["2 start" + os.pathsep + "1", "start", "3", "none", "start"]
    assert capsys.readouterr().out.splitlines() == [f"[INFO] [launch.user]: {value}" for value in logged]


@in_both(
    '<bool_arg name="gui" default="true" description="d"/>',
    "- bool_arg: {name: gui, default: 'true', description: d}",
)
def test_boolean_argument(text: str, visit: Visit) -> None:
    assert visit(text) == {"gui": "true"}
    with pytest.raises(RuntimeError, match=r"provided value|provided default_value"):
        visit(text.replace("true", "maybe"))
    with pytest.raises(InvalidFrontendLaunchFileError, match="Cannot specify choices for bool_arg"):
        visit(
            text.replace('"d"/>', '"d"><choice value="true"/></bool_arg>').replace(
                ": d}", ": d, choice: [{value: 'true'}]}"
            )
        )


@in_both(
    f'<group><rep_env><env name="A" value="$(env {NAME})"/><env name="B" value="2"/></rep_env>'
    f'<log message="$(env A)$(env B)$(env {NAME} none)"/></group><log message="$(env {NAME})$(env A none)"/>',
    f"- group:\n  - rep_env: {{env: [{{name: A, value: $(env {NAME})}}, {{name: B, value: '2'}}]}}\n"
    f"  - log: {{message: $(env A)$(env B)$(env {NAME} none)}}\n- log: {{message: $(env {NAME})$(env A none)}}",
)
def test_replaced_environment(text: str, visit: Visit, capsys: pytest.CaptureFixture[str]) -> None:
    visit(text)
    assert capsys.readouterr().out.splitlines() == [
        "[INFO] [launch.user]: start2none",
        "[INFO] [launch.user]: startnone",
    ]


@in_both(
    '<let name="a" value="1"/><reset><keep name="b" value="$(var a)"/></reset>',
    "- let: {name: a, value: '1'}\n- reset: {keep: [{name: b, value: $(var a)}]}",
)
def test_reset(text: str, visit: Visit) -> None:
    assert visit(text) == {"b": "1"}
    assert (
        visit(
            text.replace("<keep", "<!--").replace("</reset>", "--></reset>").replace("keep: [", "keep: []} #")
        )
        == {}
    )


@in_both(
    '<for len="2" name="i"><for len="$(eval \'1 + 1\')" name="j">'
    '<let name="at_$(index i)$(index j)" value="1"/></for></for>',
    "- for: {len: 2, name: i, children: [{for: {len: $(eval '1 + 1'), name: j, children: [\n"
    "    {let: {name: at_$(index i)$(index j), value: '1'}}]}}]}",
)
def test_for(text: str, visit: Visit) -> None:
    assert visit(text) == {f"at_{i}{j}": "1" for i in range(2) for j in range(2)}


def test_a_process_in_a_loop_is_started_in_each_iteration(launch: Callable[..., Any], tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text(
        '<launch><for len="2" name="i"><executable cmd="echo $(index i)" output="screen"/></for></launch>'
    )
    lines = launch(IncludeLaunchDescription(str(path))).lines
    assert {"[echo-1] 0", "[echo-2] 1"} <= set(lines)


@in_both(
    '<arg name="robots" default="{name: a, id: 1};{name: b}"/>'
    '<for_each values="$(var robots)"><let name="$(for-var name)" value="$(for-var id none)"/></for_each>',
    "- arg: {name: robots, default: '{name: a, id: 1};{name: b}'}\n"
    "- for_each: {values: $(var robots), children: [{let: {name: $(for-var name), value: $(for-var id none)}}]}",
)
def test_for_each(text: str, visit: Visit) -> None:
    configurations = visit(text)
    assert configurations.pop("robots")
    assert configurations == {"a": "1", "b": "none"}


@in_both(
    '<include file="$(dirname)/inner.launch.xml"><arg name="a" value="1"/></include>',
    "- include: {file: $(dirname)/inner.launch.xml, arg: [{name: a, value: '1'}]}",
)
def test_include(text: str, visit: Visit, tmp_path: Path) -> None:
    (tmp_path / "inner.launch.xml").write_text(
        '<launch><arg name="a"/><let name="b" value="$(var a)"/></launch>'
    )
    assert visit(text) == {"a": "1", "b": "1"}


@in_both('<let name="a" valu="1"/>', "- let: {name: a, valu: '1'}")
def test_missing_attribute_is_an_error_with_its_place(text: str, visit: Visit) -> None:
    with pytest.raises(Exception, match=r"a\.launch\.(xml:1|yaml:2): .*value"):
        visit(text)


def test_deprecated_description_logs_its_reason(capsys: pytest.CaptureFixture[str]) -> None:
    visit_all_entities_and_collect_futures(LaunchDescription(deprecated_reason="old"), LaunchContext())
    assert capsys.readouterr().out == "[WARNING] [launch]: deprecated launch description: old\n"


def test_configurations_that_double_one_another_end_the_launch(visit: Visit) -> None:
    lines = ['<let name="a" value="xx"/>', *['<let name="a" value="$(var a)$(var a)"/>'] * 40]
    with pytest.raises(SubstitutionFailure, match="is longer than 10000000 characters"):
        visit("<launch>\n" + "\n".join(lines) + "\n</launch>")
