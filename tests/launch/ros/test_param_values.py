"""The values and types that parameters in XML and YAML have, with quotes, escapes, separators and substitutions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.files.sources import AnyLaunchDescriptionSource
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters

XML: list[tuple[str, Any]] = [
    ('value="ads"', "ads"),
    ('value="2"', 2),
    ('value="2, 5" value-sep=", "', [2, 5]),
    ('value="$(var a_list)"', [2, 5]),
    ('value="$(var a_string)"', "[2, 5]"),
    ('value="2., 5." value-sep=", "', [2.0, 5.0]),
    ("value=\"'2', '5'\" value-sep=\", \"", ["2", "5"]),
    ("value=\"&quot;'2'&quot;, &quot;'5'&quot;\" value-sep=\", \"", ["'2'", "'5'"]),
    (r"""value="\'2\', \'5\'" value-sep=", \"""", ["'2'", "'5'"]),
    (r"""value="'\asd', '\bsd'" value-sep=", \"""", ["asd", "bsd"]),
    ("value=\"''\"", ""),
    ('value="$(var a_number)" type="str"', "100"),
    ('value="\'2\', \'5\'" value-sep=", " type="list_of_str"', ["'2'", "'5'"]),
    ('value="2, 5" value-sep=", " type="list_of_str"', ["2", "5"]),
    ('value="$(var a_number)" type="float"', 100.0),
    ('value="$(var a_number)"', 100),
]
YAML: list[tuple[str, Any]] = [
    ("value: ads", "ads"),
    ("value: 2", 2),
    ("value: [2, 5]", [2, 5]),
    ("value: $(var a_list)", [2, 5]),
    ("value: $(var a_string)", "[2, 5]"),
    ("value: [2., 5.]", [2.0, 5.0]),
    ("value: ['2', '5']", ["2", "5"]),
    ("""value: ["'2'", "'5'"]""", ["'2'", "'5'"]),
    (r"""value: ["\\'2\\'", "\\'5\\'"]""", ["'2'", "'5'"]),
    (r"value: ['\asd', '\bsd']", ["asd", "bsd"]),
    ("value: ''", ""),
    # By YAML 1.1 these are 750, 3, 1000, 90.5 and a date; in a file of parameters they are texts.
    ("value: 12:30", "12:30"),
    ("value: 0b11", "0b11"),
    ("value: 1_000", "1_000"),
    ("value: 1:30.5", "1:30.5"),
    ("value: 2026-01-31", "2026-01-31"),
    ("value: [08:15, 12:30]", ["08:15", "12:30"]),
    ("value: 017", 15),
    ("value: !!int 0b11", 3),
    ("value: off", False),
    ("{value: $(var a_number), type: str}", "100"),
    ("""{value: ["'2'", "'5'"], type: list_of_str}""", ["'2'", "'5'"]),
    ("{value: ['2', '5'], type: list_of_str}", ["2", "5"]),
]


def evaluated(path: Path, text: str) -> Any:
    path.write_text(text, "utf-8")
    context = LaunchContext()
    variables = {"a_list": "[2, 5]", "a_string": "'[2, 5]'", "a_number": "100"}
    context.launch_configurations.update(variables)
    (node,) = AnyLaunchDescriptionSource(str(path)).get_launch_description(context).entities
    ((_, value),) = evaluate_parameters(context, node._parameters)[0].items()
    return value


@pytest.mark.parametrize(("attributes", "expected"), XML)
def test_xml(tmp_path: Path, attributes: str, expected: Any) -> None:
    attributes = attributes.replace(r"\"", '"')
    text = f'<launch><node exec="x"><param name="a" {attributes}/></node></launch>'
    value = evaluated(tmp_path / "a.launch.xml", text)
    assert (value, type(value)) == (expected, type(expected))


@pytest.mark.parametrize(("values", "expected"), YAML)
def test_yaml(tmp_path: Path, values: str, expected: Any) -> None:
    inner = values.strip("{}") if values.startswith("{") else values
    lines = inner.replace(", type:", "\n        type:")
    text = f"launch:\n- node:\n    exec: x\n    param:\n      - name: a\n        {lines}\n"
    value = evaluated(tmp_path / "a.launch.yaml", text)
    assert (value, type(value)) == (expected, type(expected))
