"""The loader of users' YAML: its limits, and a sentence for each mistake."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.common import yaml as user_yaml
from tfloom.common.yaml import MAX_DEPTH, YamlError, YamlLimitError, compose_all, load

LAUGHS = "\n".join(
    [
        "a0: &a0 [lol, lol]",
        *(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}, *a{n - 1}, *a{n - 1}]" for n in range(1, 40)),
    ]
)
MERGES = "\n".join(
    ["a0: &a0 {x: 1}", *(f"a{n}: &a{n} {{<<: [*a{n - 1}, *a{n - 1}, *a{n - 1}]}}" for n in range(1, 40))]
)


@pytest.mark.parametrize("read", [load, compose_all])
@pytest.mark.parametrize(
    ("text", "problem", "line"),
    [
        (LAUGHS, "aliases stand for more than", 10),
        (MERGES, "aliases stand for more than", 12),
        (f"- &a {'x' * 1000}\n- [{'*a, ' * 1000}]", "aliases stand for more than", 2),
        ("[" * 5000, "nested deeper than 100 levels", 1),
        ("- " * 5000, "nested deeper than 100 levels", 1),
        ("? " * 5000, "nested deeper than 100 levels", 1),
        ("{a: " * 101 + "1" + "}" * 101, "nested deeper than 100 levels", 1),
        ("\n".join(["- &b [1]", *["- " * 99 + "*b"]]), "nested deeper than 100 levels", 2),
        ("a: 1\nb: &b [1, *b]", "the alias *b contains itself", 2),
        ("b: &b {<<: *b}", "the alias *b contains itself", 1),
        ("- &b 1\n- &b [*b]", "the alias *b contains itself", 2),
    ],
)
def test_a_text_beyond_a_limit_is_refused(read: Any, text: str, problem: str, line: int) -> None:
    with pytest.raises(YamlLimitError) as caught:
        read(text)
    assert problem in str(caught.value)
    assert f" at line {line}, column " in str(caught.value)


def test_text_beside_aliases_has_no_limit_of_length(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(user_yaml, "MAX_EXPANDED_SIZE", 1000)
    assert len(load(f"[{'1, ' * 1001}]")) == 1001
    assert load("[&a 1, *a, " + "x" * 1001 + ", *a]") == [1, 1, "x" * 1001, 1]


def test_aliases_and_levels_within_the_limits_are_read() -> None:
    assert load("a: &a [1, 2]\nb: [*a, *a]\nc: {<<: &m {d: 1}}\ne: *m") == {
        "a": [1, 2],
        "b": [[1, 2], [1, 2]],
        "c": {"d": 1},
        "e": {"d": 1},
    }
    assert load("[&a 1, *a, &a [2], *a]") == [1, 1, [2], [2]]
    value = load("[" * (MAX_DEPTH - 1) + "1" + "]" * (MAX_DEPTH - 1))
    for _ in range(MAX_DEPTH - 1):
        (value,) = value
    assert value == 1


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("!!int x", "'x' is no int"),
        ("a: 2026-13-01", "'2026-13-01' is no timestamp"),
        ("!!bool x", "'x' is no bool"),
        ("!!timestamp x", "'x' is no timestamp"),
        ("9" * 5000, "is no int"),
        ("a: b: c", "mapping values are not allowed here at line 1, column 5"),
        ("a: *b", "found undefined alias 'b' at line 1, column 4"),
        ("--- 1\n--- 2", "but found another document"),
        ("a\0b", "unacceptable character #x0000"),
    ],
)
def test_a_mistake_has_its_sentence(text: str, problem: str) -> None:
    with pytest.raises(YamlError, match=r"^it is not valid YAML: ") as caught:
        load(text)
    assert problem in str(caught.value)


def test_nothing_is_none() -> None:
    assert load("") is None
    assert load("# a comment") is None
