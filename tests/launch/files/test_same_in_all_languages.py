"""The same description in Python, XML and YAML gives the same entities."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.files.sources import get_launch_description_from_any_launch_file

HEAD = """
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import *


def generate_launch_description():
    return LaunchDescription([
"""

PYTHON = """
DeclareLaunchArgument("who", default_value="world", description="whom to greet", choices=["world", "moon"]),
DeclareLaunchArgument("need"),
SetLaunchConfiguration("x", [LaunchConfiguration("who"), "!"]),
SetEnvironmentVariable("A", [EnvironmentVariable("HOME"), "/a"]),
AppendEnvironmentVariable("B", "b", prepend=True, separator=";"),
UnsetEnvironmentVariable("C"),
LogInfo(msg=["hello ", LaunchConfiguration("x", default="d")], condition=IfCondition("true")),
GroupAction(
    [
        ExecuteProcess(
            cmd=["echo", "late", LaunchConfiguration("x")],
            name="e", cwd=ThisLaunchFileDir(), output="both", shell=True,
            additional_env={"E": "1"}, condition=UnlessCondition(LaunchConfiguration("no", default="false")),
        ),
        TimerAction(period=4.0, actions=[LogInfo(msg="late")]),
    ],
    scoped=False,
),
PushRosNamespace("robot"),
SetParameter("frame", "map"),
SetRemap("a", "b"),
Node(
    package="demo_nodes_py", executable="talker", name=["t_", LaunchConfiguration("x")], namespace="ns",
    output="screen", respawn=True, arguments=["-v", LaunchConfiguration("x")],
    parameters=[
        {"rate": ParameterValue(2.0)},
        {"names": ParameterValue(["a", "b"])},
        PathJoinSubstitution([FindPackageShare("turtlesim"), "a.yaml"]),
    ],
    remappings=[("chatter", "said"), ("/x", LaunchConfiguration("x"))],
),
"""

XML = """
<arg name="who" default="world" description="whom to greet"><choice value="world"/><choice value="moon"/></arg>
<arg name="need"/>
<let name="x" value="$(var who)!"/>
<set_env name="A" value="$(env HOME)/a"/>
<append_env name="B" value="b" prepend="true" separator=";"/>
<unset_env name="C"/>
<log message="hello $(var x d)" if="true"/>
<group scoped="false">
  <executable cmd="echo late $(var x)" name="e" cwd="$(dirname)" output="both" shell="true"
              unless="$(var no false)"><env name="E" value="1"/></executable>
  <timer period="4.0"><log message="late"/></timer>
</group>
<push_ros_namespace namespace="robot"/>
<set_parameter name="frame" value="map"/>
<set_remap from="a" to="b"/>
<node pkg="demo_nodes_py" exec="talker" name="t_$(var x)" namespace="ns" output="screen" respawn="true"
      args="-v $(var x)">
  <param name="rate" value="2.0"/>
  <param name="names" value="a,b" value-sep=","/>
  <param from="$(path-join $(find-pkg-share turtlesim) a.yaml)"/>
  <remap from="chatter" to="said"/><remap from="/x" to="$(var x)"/>
</node>
"""

YAML = """
- arg: {name: who, default: world, description: whom to greet, choice: [{value: world}, {value: moon}]}
- arg: {name: need}
- let: {name: x, value: $(var who)!}
- set_env: {name: A, value: $(env HOME)/a}
- append_env: {name: B, value: b, prepend: true, separator: ";"}
- unset_env: {name: C}
- log: {message: hello $(var x d), if: true}
- group:
    scoped: false
    children:
    - executable:
        cmd: echo late $(var x)
        name: e
        cwd: $(dirname)
        output: both
        shell: true
        env: [{name: E, value: "1"}]
        unless: $(var no false)
    - timer: {period: 4.0, children: [{log: {message: late}}]}
- push_ros_namespace: {namespace: robot}
- set_parameter: {name: frame, value: map}
- set_remap: {from: a, to: b}
- node:
    pkg: demo_nodes_py
    exec: talker
    name: t_$(var x)
    namespace: ns
    output: screen
    respawn: true
    args: -v $(var x)
    param:
    - {name: rate, value: 2.0}
    - {name: names, value: [a, b]}
    - {from: $(path-join $(find-pkg-share turtlesim) a.yaml)}
    remap: [{from: chatter, to: said}, {from: /x, to: $(var x)}]
"""


def described(value: Any) -> Any:
    """Return all that an entity holds, as texts, lists and mappings. A list of one item is shown as the item."""
    if isinstance(value, TextSubstitution):
        return value.text
    if type(value).__module__.startswith("tfloom.launch"):
        held = [(name, member) for name, member in vars(value).items() if name != "launch_place"]
        return type(value).__name__, {
            name: described(member) for name, member in sorted(held) if "log" not in name
        }
    if isinstance(value, Mapping):
        return [[described(key), described(item)] for key, item in value.items()]
    if isinstance(value, (list, tuple)):
        items = [described(item) for item in value]
        return items[0] if len(items) == 1 else items
    return value if value is None or isinstance(value, (str, bool, int, float)) else type(value).__name__


@pytest.mark.parametrize("other", ["a.launch.xml", "a.launch.yaml"])
def test_entities_are_the_same(other: str, tmp_path: Path) -> None:
    (tmp_path / "a.launch.py").write_text(f"{HEAD}{PYTHON}])")
    (tmp_path / "a.launch.xml").write_text(f"<launch>{XML}</launch>")
    (tmp_path / "a.launch.yaml").write_text(f"launch:{YAML}")
    python, same = (
        get_launch_description_from_any_launch_file(str(tmp_path / name)) for name in ("a.launch.py", other)
    )
    for one, two in zip(python.entities, same.entities, strict=True):
        assert described(one) == described(two)
