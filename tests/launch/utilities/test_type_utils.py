"""Values by their types, and substitutions for them."""

from __future__ import annotations

import re
from typing import Any, List  # noqa: UP035  # as programs write

import pytest

from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.utilities.type_utils import (
    AllowedTypesTuple,
    coerce_list,
    coerce_to_type,
    extract_type,
    get_typed_value,
    is_instance_of,
    is_instance_of_valid_type,
    is_normalized_substitution,
    is_substitution,
    is_typing_list,
    is_valid_scalar_type,
    normalize_typed_substitution,
    perform_typed_substitution,
)

TEXT = TextSubstitution


@pytest.mark.parametrize(
    ("data_type", "extracted"),
    [(int, (int, False)), (str, (str, False)), (List[float], (float, True)), (list[bool], (bool, True))],  # noqa: UP006
)
def test_types_are_known(data_type: Any, extracted: tuple) -> None:
    assert extract_type(data_type) == extracted
    assert is_typing_list(data_type) == extracted[1]
    assert is_valid_scalar_type(data_type) != extracted[1]


@pytest.mark.parametrize("data_type", [dict, list, List, List[dict], None, List[List[int]]])  # noqa: UP006
def test_other_types_are_refused(data_type: Any) -> None:
    with pytest.raises(ValueError, match="Unrecognized data type"):
        extract_type(data_type)


@pytest.mark.parametrize(
    ("text", "data_type", "value"),
    [
        ("1", int, 1),
        ("1", float, 1.0),
        ("1.5", float, 1.5),
        ("1e3", str, "1e3"),
        ("true", bool, True),
        ("off", bool, False),
        ("[1, 2]", list[int], [1, 2]),
        ("1e-3", float, 0.001),
        ("-inf", float, float("-inf")),
        ("1", bool, True),
        (" Off ", bool, False),
        ("[1, 2]", list[float], [1.0, 2.0]),
        ("[1.0, 2.5]", List[float], [1.0, 2.5]),  # noqa: UP006
        ("[a, b]", List[str], ["a", "b"]),  # noqa: UP006
        ("[]", list[int], []),
        ("1", None, 1),
        ("1.5", None, 1.5),
        ("yes", None, True),
        ("", None, ""),
        ("word", None, "word"),
    ],
)
def test_a_text_is_read_as_a_type(text: str, data_type: Any, value: Any) -> None:
    read = coerce_to_type(text, data_type)
    assert read == value
    assert type(read) is type(value)


@pytest.mark.parametrize(
    ("text", "data_type"),
    [
        ("1.5", int),
        ("true", int),
        ("0x10", int),
        ("2", bool),
        ("word", float),
        ("1", list[int]),
        ("[1, 2.5]", list[float]),
        ("!!python/object:os.system {}", int),
        ("!!python/object:os.system {}", None),
        ("{a: 1}", None),
        ("a: b: c", None),
        ("null", None),
    ],
)
def test_a_text_of_another_type_is_refused(text: str, data_type: Any) -> None:
    with pytest.raises(ValueError, match=re.escape(text)):
        coerce_to_type(text, data_type)
    assert coerce_to_type(text, data_type, can_be_str=True) == text


def test_items_of_a_list_may_be_texts() -> None:
    for data_type in (None, list[int]):
        with pytest.raises(ValueError, match=re.escape("'[1, a]'")):
            coerce_to_type("[1, a]", data_type)
        assert coerce_to_type("[1, a]", data_type, can_be_str=True) == [1, "a"]


def test_the_error_of_a_long_text_is_short() -> None:
    with pytest.raises(ValueError, match="Failed to convert") as caught:
        coerce_to_type("a: b" + "c" * 100_000)
    assert len(str(caught.value)) < 1000


def test_lists_of_texts_have_one_type() -> None:
    assert coerce_list(["1", "2"]) == [1, 2]
    assert coerce_list(["1", "a"], can_be_str=True) == [1, "a"]
    with pytest.raises(ValueError, match="cannot convert value to None"):
        coerce_list(["1", "a"])
    assert coerce_list(["1", "$(var x)"], int, can_be_str=True) == [1, "$(var x)"]
    assert get_typed_value(["1", "2"], list[float]) == [1.0, 2.0]
    assert get_typed_value(["1", "2"], None) == [1, 2]
    with pytest.raises(TypeError, match="Cannot convert"):
        get_typed_value(["1"], int)


@pytest.mark.parametrize(
    ("value", "types"),
    [
        (1, {int}),
        (1.0, {float}),
        (True, {bool}),
        ("a", {str}),
        ([1, 2], {List[int]}),  # noqa: UP006
        ([], {List[int], List[float], List[bool], List[str]}),  # noqa: UP006
        ([1, 2.0], set()),
        ({}, set()),
        (None, set()),
    ],
)
def test_a_value_has_its_types(value: Any, types: set) -> None:
    assert {kind for kind in AllowedTypesTuple if is_instance_of(value, kind)} == types
    assert is_instance_of_valid_type(value) == bool(types)


def test_substitutions_are_told_from_texts() -> None:
    assert is_substitution(TEXT(text="a"))
    assert is_substitution(["a", TEXT(text="b")])
    assert not is_substitution(["a", "b"])
    assert not is_substitution("a")
    assert not is_substitution([1, TEXT(text="b")])
    assert is_normalized_substitution([TEXT(text="a")])
    assert not is_normalized_substitution([])
    assert not is_normalized_substitution(["a", TEXT(text="b")])


@pytest.mark.parametrize(
    ("value", "data_type", "performed"),
    [
        (5, int, 5),
        (TEXT(text="5"), int, 5),
        (["1", TEXT(text="5")], int, 15),
        ([TEXT(text="1"), 2], list[int], [1, 2]),
        (["[", TEXT(text="1"), ", 2]"], list[int], [1, 2]),
        ([[TEXT(text="1")], 2], list[int], [1, 2]),
        ((1, 2), list[int], [1, 2]),
        ([["1", TEXT(text="0")], 2], list[int], [10, 2]),
        (TEXT(text="[1, 2]"), list[int], [1, 2]),
        (["tr", TEXT(text="ue")], None, True),
        ("text", str, "text"),
    ],
)
def test_a_value_with_substitutions_is_performed(value: Any, data_type: Any, performed: Any) -> None:
    normalized = normalize_typed_substitution(value, data_type)
    assert perform_typed_substitution(LaunchContext(), normalized, data_type) == performed


@pytest.mark.parametrize(("value", "data_type"), [(5, str), ("5", int), ([1, "a"], list[int]), ({}, None)])
def test_a_value_of_another_type_is_refused(value: Any, data_type: Any) -> None:
    with pytest.raises(TypeError, match="value="):
        normalize_typed_substitution(value, data_type)


def test_the_result_of_substitutions_is_checked() -> None:
    with pytest.raises(ValueError, match="int"):
        perform_typed_substitution(LaunchContext(), [TEXT(text="a")], int)
    mixed = normalize_typed_substitution([TEXT(text="a"), 1], None)
    with pytest.raises(ValueError, match="not all of one type"):
        perform_typed_substitution(LaunchContext(), mixed, None)


@pytest.mark.parametrize("value", [[1, 2.0], [1, "a"], [True, 1]])
def test_a_list_of_several_types_is_refused_when_it_is_given(value: list) -> None:
    with pytest.raises(TypeError, match="are of several types"):
        normalize_typed_substitution(value, None)


@pytest.mark.parametrize("value", ["a", "12", b"a", 1, None, object(), {"a": 1}])
@pytest.mark.parametrize("data_type", [None, int, str])
def test_what_is_no_list_of_texts_is_an_error_of_both_kinds(value: Any, data_type: Any) -> None:
    """Both, because a program may catch the one of a wrong class or the one of a text that can't be read."""
    for kind in (TypeError, ValueError):
        with pytest.raises(kind, match="a list of texts is expected"):
            coerce_list(value, data_type)
        with pytest.raises(kind, match="a text is expected"):
            coerce_list(["1", b"2"], data_type)  # type: ignore[list-item]
        if not isinstance(value, str):
            with pytest.raises(kind, match="a text is expected"):
                coerce_to_type(value, data_type)


@pytest.mark.parametrize(
    ("value", "data_type"),
    [
        (object(), int),
        (object, int),
        ("1", int),
        (1, float),
        ([1, 2], int),
        (["1", 2], List[int]),  # noqa: UP006
        ([1, 2.5], None),
        (None, None),
    ],
)
def test_a_value_of_another_type_is_refused_when_it_is_performed(value: Any, data_type: Any) -> None:
    for kind in (TypeError, ValueError):
        with pytest.raises(kind, match="Expected an output of type"):
            perform_typed_substitution(LaunchContext(), value, data_type)
