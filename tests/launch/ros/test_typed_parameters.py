"""Values of parameters arrive at a node with the type that they have in a launch file."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, List  # noqa: UP035  # as launch files write types

import numpy as np
import pytest

from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument
from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.files.sources import AnyLaunchDescriptionSource
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.actions.node_defaults import SetParameter
from tfloom.launch.ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters, to_parameters_list
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters
from tfloom.launch.substitutions.variables import LaunchConfiguration
from tfloom.node.values.scalars import parse_documents, parse_value

Words = Callable[..., list[str]]
STRINGS = [
    "y",
    "n",
    "123E5",
    "0888",
    "1e3",
    "inf",
    "0x1p3",
    "on",
    "5",
    "null",
    "",
    "a: b",
    "a\nb",
    "2020-01-01",
]


def read(lines: list[str]) -> dict[str, Any]:
    """Return the parameters in the words and the file that the program `show` has printed, by name."""
    text = "\n".join(line.removeprefix("file ") for line in lines if line.startswith("file "))
    (content,) = parse_value(text, nothing={}).values() if text else [{"ros__parameters": {}}]
    rules = [line.removeprefix("word ").partition(":=") for line in lines if ":=" in line]
    return content["ros__parameters"] | {
        name: parse_value(value) for name, _, value in rules if not name.startswith("__")
    }


def node(**options: Any) -> Node:
    return Node(package="toys", executable="show", output="screen", **options)


def test_texts_stay_texts(words: Words) -> None:
    given = dict(enumerate(STRINGS))
    plain = {f"plain{index}": text for index, text in given.items()}
    typed = {f"typed{index}": ParameterValue(text, value_type=str) for index, text in given.items()}
    lists = {"axes": ["x", "y", "z"], "numbers": ["08", "1e3"], "strings": STRINGS}
    found = read(words(node(parameters=[plain | typed | lists])))
    assert (
        found
        == {f"{kind}{index}": text for kind in ("plain", "typed") for index, text in given.items()} | lists
    )


@pytest.mark.parametrize("text", [text for text in STRINGS if "\n" not in text])
def test_texts_of_single_parameters_stay_texts(words: Words, text: str) -> None:
    entities = (SetParameter("set", text), node(parameters=[Parameter("one", text, value_type=str)]))
    assert read(words(*entities)) == {"set": text, "one": text}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1e3", 1000.0),
        ("0888", 888.0),
        ("inf", math.inf),
        ("y", True),
        ("'y'", "y"),
        ("5", 5),
        ("2020-01-01", "2020-01-01"),
        ("null", "null"),
        ("[x, y, z]", ["x", "y", "z"]),
        ("[y, n]", [True, False]),
        ("[1, 2.5]", [1.0, 2.5]),
        ("[1e3]", [1000.0]),
    ],
)
def test_a_configuration_without_a_type_has_the_one_that_a_parameter_file_gives_it(
    words: Words, text: str, value: Any
) -> None:
    given = LaunchConfiguration("given")
    parameters = [{"bare": given, "each": [[given]], "value": ParameterValue(given)}, Parameter("one", given)]
    if isinstance(value, list):
        del parameters[0]["each"]  # type: ignore[attr-defined]
    found = read(words(DeclareLaunchArgument("given", default_value=text), node(parameters=parameters)))
    expected = {"bare": value, "value": value, "one": value}
    assert found == expected | ({} if isinstance(value, list) else {"each": [value]})


def test_a_configuration_with_a_type_has_it(words: Words) -> None:
    given = LaunchConfiguration("given")
    typed = {
        "text": ParameterValue(given, value_type=str),
        "float": ParameterValue(given, value_type=float),
        "floats": ParameterValue(["[", given, ", 2]"], value_type=List[float]),  # noqa: UP006
        "texts": ParameterValue([[given], "y"], value_type=List[str]),  # noqa: UP006
        "mixed": ParameterValue([1, 2.5]),
    }
    found = read(words(DeclareLaunchArgument("given", default_value="1e3"), node(parameters=[typed])))
    assert found == {
        "text": "1e3",
        "float": 1000.0,
        "floats": [1000.0, 2.0],
        "texts": ["1e3", "y"],
        "mixed": [1.0, 2.5],
    }


XML = """<launch>
  <arg name="axis" default="y"/>
  <node pkg="toys" exec="show" output="screen">
    <param name="a" value="y"/> <param name="b" value="y" type="str"/> <param name="c" value="$(var axis)" type="str"/>
    <param name="d" value="0888" type="str"/> <param name="e" value="x,y,n" value-sep="," type="list_of_str"/>
    <param name="f" value="5"/> <param name="g" value="'5'"/> <param name="h" value="1e5"/>
    <param name="i" value="1e5" type="float"/> <param name="j" value="$(var axis)"/> <param name="k" value="inf"/>
    <param name="l" value="[x, y, z]"/> <param name="m" value="1,2.5" value-sep=","/>
    <param name="n" value="x,y" value-sep=","/> <param name="o"><param name="p" value="1_0"/></param>
  </node>
</launch>
"""
FROM_XML = {
    "a": True,
    "b": "y",
    "c": "y",
    "d": "0888",
    "e": ["x", "y", "n"],
    "f": 5,
    "g": "5",
    "h": 1e5,
    "i": 1e5,
    "j": True,
    "k": math.inf,
    "l": ["x", "y", "z"],
    "m": [1.0, 2.5],
    "n": ["x", "y"],
    "o.p": "1_0",
}
YAML = """
launch:
  - arg: {name: axis, default: "y"}
  - node:
      pkg: toys
      exec: show
      output: screen
      param:
        - {name: a, value: "y"}
        - {name: b, value: y, type: str}
        - {name: c, value: y}
        - {name: d, value: "0888"}
        - {name: e, value: 0888}
        - {name: f, value: ["x", "y"]}
        - {name: g, value: [x, y]}
        - {name: h, value: 1e5}
        - {name: i, value: [1, 2.5]}
        - {name: j, value: "$(var axis)"}
        - {name: k, value: 'inf'}
        - {name: l, value: 5}
"""
FROM_YAML = {
    "a": "y",
    "b": "y",
    "c": True,
    "d": "0888",
    "e": 888.0,
    "f": ["x", "y"],
    "g": ["x", "y"],
    "h": 1e5,
    "i": [1.0, 2.5],
    "j": True,
    "k": "inf",
    "l": 5,
}


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [("a.launch.xml", XML, FROM_XML), ("a.launch.yaml", YAML, FROM_YAML)],
)
def test_files_keep_the_types(
    words: Words, tmp_path: Path, name: str, text: str, expected: dict[str, Any]
) -> None:
    path = tmp_path / name
    path.write_text(text, "utf-8")
    found = read(words(IncludeLaunchDescription(AnyLaunchDescriptionSource(str(path)))))
    assert {key: repr(value) for key, value in found.items()} == {k: repr(v) for k, v in expected.items()}


def test_a_flat_file_is_read_for_a_composable_node(tmp_path: Path) -> None:
    path = tmp_path / "flat.yaml"
    path.write_text("exposure: 42\nlabel: '5'\nb: {c: 2.5, d: {e: [x, z]}}\n", "utf-8")
    context = LaunchContext()
    evaluated = evaluate_parameters(context, normalize_parameters([str(path), {"exposure": 43}]))
    found = to_parameters_list(context, "camera", "/", evaluated)
    assert {parameter.name: parameter.value for parameter in found} == {
        "exposure": 43,
        "label": "5",
        "b.c": 2.5,
        "b.d.e": ["x", "z"],
    }


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("/camera: {x: 1}", "expected 'ros__parameters'"),
        ("a: {ros__parameters: 5}", "must hold names"),
        ("- 1", "mapping"),
    ],
)
def test_a_file_with_a_node_is_not_flat(tmp_path: Path, text: str, problem: str) -> None:
    path = tmp_path / "nodes.yaml"
    path.write_text(text, "utf-8")
    context = LaunchContext()
    evaluated = evaluate_parameters(context, normalize_parameters([str(path)]))
    with pytest.raises(ValueError, match=problem):
        to_parameters_list(context, "camera", "/", evaluated)


NUMPY = {
    "double": (np.deg2rad(30), np.deg2rad(30).item()),
    "single": (np.float32(0.5), 0.5),
    "integer": (np.int32(7), 7),
    "natural": (np.uint8(7), 7),
    "flag": (np.bool_(True), True),
    "text": (np.str_("0888"), "0888"),
    "doubles": (np.array([0.5, 1.0]), [0.5, 1.0]),
    "integers": (np.arange(3), [0, 1, 2]),
    "list": ([np.float64(1.5), np.float64(2.0)], [1.5, 2.0]),
    "mixed": ((np.int64(1), 2.5), [1.0, 2.5]),
    "nested": ({"deep": np.float64(2.5)}, None),
    "described": (ParameterValue(np.float64(0.25), value_type=float), 0.25),
    "untyped": (ParameterValue(np.array([1, 2])), [1, 2]),
}


def test_numbers_of_numpy_arrive_as_those_of_python(words: Words) -> None:
    given = {name: given for name, (given, _) in NUMPY.items()}
    single = Parameter("single_parameter", np.int64(5))
    lines = words(SetParameter("global", np.float64(1.25)), node(parameters=[given, single]))
    expected = {name: value for name, (_, value) in NUMPY.items() if name != "nested"}
    expected |= {"nested.deep": 2.5, "single_parameter": 5, "global": 1.25}
    found = read(lines)
    nested = found.pop("nested", {})
    found |= {f"nested.{name}": value for name, value in nested.items()} if isinstance(nested, dict) else {}
    assert {name: repr(found[name]) for name in expected} == {
        name: repr(value) for name, value in expected.items()
    }


def test_a_file_with_substitutions_may_have_several_documents(words: Words, tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(
        "/**:\n  ros__parameters:\n    a: $(var given)\t# one\n---\n/**:\n  ros__parameters:\n    b: 2\n",
        "utf-8",
    )
    file = ParameterFile(str(path), allow_substs=True)
    lines = words(DeclareLaunchArgument("given", default_value="1e3"), node(parameters=[file]))
    content = "\n".join(line.removeprefix("file ") for line in lines if line.startswith("file "))
    assert [list(document.values()) for document in parse_documents(content)] == [
        [{"ros__parameters": {"a": 1000.0}}],
        [{"ros__parameters": {"b": 2}}],
    ]
