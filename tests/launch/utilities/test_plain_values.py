"""Texts whose value is found without YAML have the value that YAML gives them."""

from __future__ import annotations

import sys

import pytest
from tests.conftest import run_to_end

from tfloom.common.yaml import load
from tfloom.launch.utilities.texts import plain_value
from tfloom.launch.utilities.type_utils import get_typed_value

PLAIN = [
    *(
        "a",
        "abc/d.e-f",
        "/a_b",
        "_x",
        "true",
        "True",
        "TRUE",
        "tRUE",
        "yes",
        "No",
        "OFF",
        "on",
        "y",
        "n",
        "nULL.",
    ),
    *(
        "0",
        "1",
        "-1",
        "+12",
        "123456789012345678",
        "1.0",
        "-0.5",
        "+2.25",
        "00.5",
        "007.25",
        "e1",
        "inf",
        "nan",
    ),
]
YAML = [
    *(
        "",
        " ",
        "null",
        "Null",
        "NULL",
        "~",
        "007",
        "0x1F",
        "1_000",
        "1e3",
        "1.5e3",
        "1.",
        ".5",
        ".inf",
        ".nan",
        "1:30",
    ),
    *(
        "2020-01-01",
        "[1, 2]",
        "{a: b}",
        "a: b",
        "a b",
        "'1'",
        "!!int 1",
        "a#b",
        "1 #x",
        "=",
        "<<",
        "1" * 19,
        "ä",
    ),
]


@pytest.mark.parametrize("text", PLAIN)
def test_plain_text(text: str) -> None:
    value = plain_value(text)
    assert value == load(text)
    assert type(value) is type(load(text))


@pytest.mark.parametrize("text", YAML)
def test_text_for_yaml(text: str) -> None:
    assert plain_value(text) is None


@pytest.mark.parametrize(
    "text", [text for text in PLAIN + YAML if text not in {"null", "Null", "NULL", "~", ""}]
)
def test_typed_value_is_that_of_yaml(text: str) -> None:
    value = get_typed_value(text, None, can_be_str=True)
    try:
        expected = load(text)
    except ValueError:
        expected = text
    is_typed = isinstance(expected, (int, float, str, bool, list))
    assert repr(value) == repr(expected if is_typed else text)


def test_yaml_is_not_loaded_for_plain_values() -> None:
    code = (
        "import sys\n"
        "from tfloom.launch.utilities.type_utils import get_typed_value\n"
        "print(get_typed_value('2.0', None), get_typed_value('true', bool), 'yaml' in sys.modules)\n"
    )
    result = run_to_end([sys.executable, "-c", code])
    assert result.stdout == "2.0 True False\n", result.stderr
