"""Nodes in XML and YAML: the same words as of the actions in Python."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tfloom.launch.actions.group_action import GroupAction
from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.files.sources import AnyLaunchDescriptionSource
from tfloom.launch.ros.actions.composable_nodes import ComposableNodeContainer, LoadComposableNodes
from tfloom.launch.ros.actions.lifecycle_node import LifecycleNode
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.actions.node_defaults import (
    PushROSNamespace,
    SetParameter,
    SetParametersFromFile,
    SetRemap,
    SetROSLogDir,
    SetUseSimTime,
)
from tfloom.launch.ros.actions.ros_timer import ROSTimer

XML = """\
<launch>
  <group>
    <push_ros_namespace namespace="out"/>
    <set_parameter name="a" value="1"/>
    <set_parameters_from_file filename="{file}"/>
    <set_remap from="x" to="y"/>
    <node pkg="toys" exec="show" name="t" namespace="in" output="screen" args="--one 'two three'"
          ros_args="--log-level info">
      <param name="rate" value="2.0"/>
      <param name="text" value="2.0" type="str"/>
      <param name="list" value="1,2" value-sep=","/>
      <param name="deep"><param name="er" value="$(var who)"/></param>
      <param from="{file}"/>
      <param from="{file}" allow_substs="true"/>
      <remap from="chatter" to="said_by_$(var who)"/>
    </node>
  </group>
</launch>
"""
YAML = """\
launch:
- group:
  - push_ros_namespace: {{namespace: out}}
  - set_parameter: {{name: a, value: "1"}}
  - set_parameters_from_file: {{filename: "{file}"}}
  - set_remap: {{from: x, to: y}}
  - node:
      pkg: toys
      exec: show
      name: t
      namespace: in
      output: screen
      args: --one 'two three'
      ros_args: --log-level info
      param:
      - {{name: rate, value: 2.0}}
      - {{name: text, value: "2.0", type: str}}
      - {{name: list, value: [1, 2]}}
      - {{name: deep, param: [{{name: er, value: $(var who)}}]}}
      - {{from: "{file}"}}
      - {{from: "{file}", allow_substs: true}}
      remap:
      - {{from: chatter, to: said_by_$(var who)}}
"""
RATES = ("rate: 2.0", "text: '2.0'", "deep.er: me")


@pytest.mark.parametrize(("suffix", "text"), [("xml", XML), ("yaml", YAML)])
def test_all_of_a_node(words: Callable[..., list[str]], tmp_path: Path, suffix: str, text: str) -> None:
    file = tmp_path / "p.yaml"
    file.write_text("/**: {ros__parameters: {who: $(var who)}}\n", "utf-8")
    path = tmp_path / f"a.launch.{suffix}"
    path.write_text(text.format(file=file), "utf-8")
    source = AnyLaunchDescriptionSource(str(path))
    lines = words(IncludeLaunchDescription(source, launch_arguments=[("who", "me")]))
    given = [line.removeprefix("word ") for line in lines if line.startswith("word ")]
    names = [word for word in given if not word.startswith("/tmp") or word == str(file)]
    files = ["--params-file"] * 4 + ["--params-file", str(file)]
    assert names == [
        *(
            "--one",
            "two three",
            "--ros-args",
            "--log-level",
            "info",
            "-r",
            "__node:=t",
            "-r",
            "__ns:=/out/in",
        ),
        *("-p", "a:=1", "--params-file", str(file), *files, *["--params-file"]),
        *("-r", "x:=y", "-r", "chatter:=said_by_me"),
    ]
    content = [line.removeprefix("file").strip() for line in lines if line.startswith("file ")]
    assert content.count("/**: {ros__parameters: {who: $(var who)}}") == 2
    assert content.count("/**: {ros__parameters: {who: me}}") == 1
    assert content.count("/out/in/t:") == 4
    assert set(RATES) <= set(content)
    assert content[content.index("list:") + 1 :][:2] == ["- 1", "- 2"]


TAGS = {
    '<lifecycle_node pkg="a" exec="b" name="c"/>': LifecycleNode,
    '<node pkg="a" exec="b" exec_name="c" respawn="true" on_exit="shutdown"/>': Node,
    '<push_ros_namespace namespace="a"/>': PushROSNamespace,
    '<push-ros-namespace namespace="a"/>': PushROSNamespace,
    '<ros_timer period="1.0"/>': ROSTimer,
    '<set_parameter name="a" value="b"/>': SetParameter,
    '<set_parameters_from_file filename="a"/>': SetParametersFromFile,
    '<set_remap from="a" to="b"/>': SetRemap,
    '<set_ros_log_dir new_log_dir="a"/>': SetROSLogDir,
    '<set_use_sim_time value="true"/>': SetUseSimTime,
    (
        '<node_container pkg="a" exec="b" name="c" namespace="">'
        '<composable_node pkg="a" plugin="b" name="c" namespace="d"><param name="a" value="1"/>'
        '<remap from="a" to="b"/><extra_arg name="a" value="true"/></composable_node></node_container>'
    ): ComposableNodeContainer,
    (
        '<load_composable_node target="c"><composable_node pkg="a" plugin="b" name="c" if="true"/>'
        "</load_composable_node>"
    ): LoadComposableNodes,
}


@pytest.mark.parametrize("tag", TAGS)
def test_each_tag_has_its_action(tmp_path: Path, tag: str) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text(f"<launch>{tag}</launch>", "utf-8")
    description = AnyLaunchDescriptionSource(str(path)).get_launch_description(LaunchContext())
    assert [type(entity) for entity in description.entities] == [TAGS[tag]]


@pytest.mark.parametrize(
    ("param", "message"),
    [
        ('<param name="a"/>', "either a value attribute or nested params are needed"),
        ('<param name="a" from="b"/>', "name and from attributes are mutually exclusive"),
        ('<param value="1"/>', "param Entity should have name or from attribute"),
        (
            '<param name="a" value="1"><param name="b" value="1"/></param>',
            "param and value attributes are mutually",
        ),
        (
            '<param name="a" type="int"><param name="b" value="1"/></param>',
            "nested parameters and type attributes",
        ),
        ('<param name="a" value="x" type="whole"/>', "whole"),
        ('<param name="a" value="1" colour="red"/>', "colour"),
    ],
)
def test_wrong_param_is_an_error(tmp_path: Path, param: str, message: str) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_text(f'<launch><node pkg="a" exec="b">{param}</node></launch>', "utf-8")
    with pytest.raises(Exception, match=message):
        AnyLaunchDescriptionSource(str(path)).get_launch_description(LaunchContext())


def test_xml_without_a_type_is_read_as_yaml(words: Callable[..., list[str]], tmp_path: Path) -> None:
    values = {"a": "1", "b": "true", "c": "x", "d": "[1, 2]", "e": "1.5", "f": "$(eval 1+1)"}
    params = "".join(f'<param name="{name}" value="{value}"/>' for name, value in values.items())
    path = tmp_path / "a.launch.xml"
    path.write_text(f'<launch><node pkg="toys" exec="show" output="screen">{params}</node></launch>', "utf-8")
    lines = words(IncludeLaunchDescription(AnyLaunchDescriptionSource(str(path))))
    shown = [line.removeprefix("file").strip() for line in lines if line.startswith("file ")]
    parameter_lines = [line for line in shown if line not in {"/**:", "ros__parameters:"}]
    assert parameter_lines == ["a: 1", "b: true", "c: x", "d:", "- 1", "- 2", "e: 1.5", "f: 2"]


def test_groups_in_python_have_the_same_words(words: Callable[..., list[str]]) -> None:
    node = Node(package="toys", executable="show", output="screen", name=[TextSubstitution(text="t")])
    assert words(GroupAction([PushROSNamespace("out"), node])) == [
        *("word --ros-args", "word -r", "word __node:=t", "word -r", "word __ns:=/out"),
    ]
