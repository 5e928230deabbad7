"""Parameters: their normal form, their values, and the errors of wrong ones."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, List  # noqa: UP035  # as programs write it

import pytest

from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters, to_parameters_list
from tfloom.launch.ros.utilities.names import normalize_remap_rule, normalize_remap_rules
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters
from tfloom.launch.substitutions.variables import LaunchConfiguration


def text(content: str) -> TextSubstitution:
    return TextSubstitution(text=content)


def evaluated(*parameters: Any) -> Any:
    context = LaunchContext()
    context.launch_configurations["x"] = "1"
    return evaluate_parameters(context, normalize_parameters(parameters))


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"a": "1"}, {"a": "1"}),
        ({"a": ""}, {"a": ""}),
        ({"a": text("1")}, {"a": 1}),
        ({"a": text("")}, {"a": ""}),
        ({"a": text("text: x")}, TypeError),
        ({"a": [text("1"), "2"]}, {"a": 12}),
        ({"a": [text("x"), "_", LaunchConfiguration("x")]}, {"a": "x_1"}),
        ({"a": [["1"], [text("2")]]}, {"a": (1, 2)}),
        ({"a": ["1", "x"]}, {"a": ("1", "x")}),
        ({"a": text("[1, 2]")}, {"a": (1, 2)}),
        ({"a": text("[1, 2.5]")}, {"a": (1.0, 2.5)}),
        ({"a": [["1"], ["2.5"]]}, {"a": (1.0, 2.5)}),
        ({"a": text("[]")}, TypeError),
        ({"a": text("[1, x]")}, TypeError),
        ({"a": text("[[1]]")}, TypeError),
        ({"a": text("2020-01-01")}, {"a": "2020-01-01"}),
        ({"a": []}, TypeError),
        ({"a": [True, False]}, {"a": (True, False)}),
        ({"a": [1, 2.0]}, {"a": (1.0, 2.0)}),
        ({"a": [True, 1]}, TypeError),
        ({"a": [1, text("2")]}, TypeError),
        ({"a": [None]}, TypeError),
        ({"a": None}, TypeError),
        ({"a": b"x"}, {"a": b"x"}),
        ({"a": {"b": {"c": 1}, "d": 2}}, {"a.b.c": 1, "a.d": 2}),
        ({text("a"): 1}, {"a": 1}),
        ({("a", text("b")): 1}, {"ab": 1}),
        ({1: 1}, TypeError),
        ({"a": ParameterValue(text("1"))}, {"a": 1}),
        ({"a": ParameterValue(text("1"), value_type=str)}, {"a": "1"}),
        ({"a": ParameterValue(text("1"), value_type=float)}, {"a": 1.0}),
        ({"a": ParameterValue(text("[a, b]"), value_type=List[str])}, {"a": ["a", "b"]}),  # noqa: UP006
        ({"a": ParameterValue(text("x"), value_type=int)}, ValueError),
    ],
    ids=lambda value: re.sub(r"<\S*\.(\w+) object at \w+>", r"\1", str(value)),  # workers compare the ids
)
def test_mapping_has_these_values(given: dict[Any, Any], expected: Any) -> None:
    if isinstance(expected, type):
        with pytest.raises(expected):
            evaluated(given)
        return
    (values,) = evaluated(given)
    assert values == expected
    assert [type(value) for value in values.values()] == [type(value) for value in expected.values()]


def test_error_names_the_parameter_and_the_remedy() -> None:
    with pytest.raises(
        TypeError, match=r"Got <class 'dict'> for parameter a, .*ParameterValue\(value, value_type=str\)"
    ):
        evaluated({"a": text("{b: c}")})
    with pytest.raises(TypeError, match=r"Expecting list of parameters, got file\.yaml"):
        normalize_parameters("file.yaml")
    with pytest.raises(TypeError, match=r"got 1 of type 'int'"):
        normalize_parameters([1])
    with pytest.raises(ValueError, match="parameter a: "):
        evaluated({"a": ParameterValue(text("x"), value_type=int)})


def test_paths_are_files_in_every_form(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    files = evaluated(str(path), path, text(str(path)), [str(tmp_path), text("/p.yaml")], ParameterFile(path))
    assert files == (path,) * 5


def test_parameter_is_shown_before_and_after_its_evaluation(context: LaunchContext) -> None:
    parameter = Parameter([text("a"), "b"], text("1"), value_type=int)
    assert str(parameter).startswith("launch_ros.parameter_descriptions.Parameter(name=[")
    assert parameter.evaluate(context) == ("ab", 1)
    assert (parameter.name, parameter.value, parameter.value_type) == ("ab", 1, int)
    assert str(parameter) == (
        "launch_ros.parameter_descriptions.Parameter(name=ab, value=1, value_type=<class 'int'>)"
    )


def test_file_with_substitutions_is_removed_by_cleanup(tmp_path: Path, context: LaunchContext) -> None:
    context.launch_configurations["x"] = "1"
    path = tmp_path / "p.yaml"
    path.write_text("/**: {ros__parameters: {a: $(var x)}}", "utf-8")
    file = ParameterFile(path, allow_substs=LaunchConfiguration("substitute", default="true"))
    made = file.evaluate(context)
    assert made != path
    assert made.read_text("utf-8") == "/**: {ros__parameters: {a: 1}}"
    assert (file.evaluate(context), file.param_file, file.allow_substs) == (made, made, True)
    file.cleanup()
    assert not made.exists()
    assert path.exists()


def test_values_for_a_node_are_parameters(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("ns: {t: {ros__parameters: {a: 1, b: [1, 2]}}}\nu: {ros__parameters: {a: 9}}", "utf-8")
    context = LaunchContext()
    given = evaluate_parameters(
        context, normalize_parameters([path, {"a": 2, "c": ["x"]}, Parameter("d", 2.5)])
    )
    parameters = to_parameters_list(context, "t", "/ns", given)
    assert {parameter.name: parameter.value for parameter in parameters} == {
        "a": 2,
        "b": [1, 2],
        "c": ["x"],
        "d": 2.5,
    }
    with pytest.warns(UserWarning, match="No parameters for /ns/v in"):
        assert to_parameters_list(context, "v", "/ns", [path]) == []


def test_remap_rule_is_a_pair() -> None:
    ((name, replacement),) = normalize_remap_rules([("a", ["b", text("c")])])
    assert [part.describe() for part in name] == ["'a'"]
    assert [part.describe() for part in replacement] == ["'b'", "'c'"]
    with pytest.raises(TypeError, match="remap_rule must be a tuple of length 2, got length 1"):
        normalize_remap_rule(("a",))
    with pytest.raises(TypeError, match="remap_rule"):
        normalize_remap_rule(["a", "b"])
