"""CMake's regular expressions: the answers of CMake 4.4, its refusals, and those that make other engines wait."""

from __future__ import annotations

import random
import shutil
from pathlib import Path

import pytest
from tests.conftest import run_to_end

from tfloom.workspace.cmake_regex import MAX_PATTERN, Expression, RegexError

TEXTS = [
    "",
    "a",
    "aa",
    "d",
    "]",
    "\\",
    "a{2}",
    "-",
    "ab",
    "b",
    ".",
    "^",
    "$",
    "abc",
    "x.py/y.py",
    "src/x.py",
    "a.x",
]
TEXTS += ["a\nb", "\n", "c", "e", "z", "(a)", "*a", "+", "é", "ü", "aab", "aéb"]
ANSWERS = {
    "a{2}": "00000010000000000000000000000",
    "\\d": "00010000000000000000000000000",
    "[\\]]": "00000000000000000000000000000",
    "[]a]": "01101010100001001100001100011",
    "[^]a]": "00010111111111111111111111111",
    "()": "11111111111111111111111111111",
    "a|": "11111111111111111111111111111",
    "(a|b*)?": "11111111111111111111111111111",
    "a^b": "00000000000000000000000000000",
    "^^a": "01100010100001001100000000011",
    "a$$": "01100000000000000000000100000",
    "$a": "00000000000000000000000000000",
    "": "11111111111111111111111111111",
    "(^a)": "01100010100001001100000000011",
    "[a-]": "01100011100001001100001100011",
    "[-a]": "01100011100001001100001100011",
    "\\.": "00000000001000111000000000000",
    "[a-c-e]": "01110010110001011101101100011",
    "[a-c]+$": "01100000110001000101000100011",
    "^[^/]+/[^.]+[.]py$": "00000000000000110000000000000",
    "(ab|a)(bc|c)?$": "01100000100001000000000100010",
    "a.b": "00000000000000000100000000010",
    "[.]x$": "00000000000000001000000000000",
    "(a+)+$": "01100000000000000000000100000",
    "[a\\-z]": "01111110110101111101111100011",
    "[[:alpha:]]": "00000000000000000000000000000",
    "\\(a\\)": "00000000000000000000001000000",
    "^(a|b)*$": "11100000110000000000000000010",
    "a\\nb": "00000000000000000000000000000",
    "é": "00000000000000000000000001001",
    "[é-ü]": "00000000000000000000000001101",
    "^.$": "01011101011110000011110010000",
}
REFUSED = [
    "a**",
    "*",
    "(a*)*",
    "(a*)+",
    "(a?)+",
    "^*",
    "[a-",
    "(a",
    "a)",
    "[b-a]",
    "a\\",
    "[]",
    "[^]",
    "a++",
    "a?*",
    "(a|)*",
    "(^)*",
    "$*",
    "+a",
    "?",
    "a|*",
    "(*a)",
    "^(a|b|)+c?$",
]


def answers(pattern: str, texts: list[str]) -> str:
    """Return a 1 for each text in which a pattern is found, and a 0 for each other."""
    expression = Expression(pattern, lambda _: None)
    return "".join(str(int(expression.is_found_in(text))) for text in texts)


def quoted(text: str) -> str:
    """Return an argument of CMake in brackets."""
    line = "\n" if text.startswith("\n") else ""
    return f"[======[{line}{text}]======]"


def answers_of_cmake(pattern: str, texts: list[str], path: Path) -> str:
    """Return what CMake answers; an empty text if it refuses the pattern."""
    lines = [
        f"if({quoted(text)} MATCHES {quoted(pattern)})\nmessage(1)\nelse()\nmessage(0)\nendif()"
        for text in texts
    ]
    path.write_text("\n".join(["cmake_policy(VERSION 3.10)", *lines]), "utf-8")
    done = run_to_end(["cmake", "-P", path])
    return "" if done.returncode else "".join(done.stderr.split())


@pytest.mark.parametrize("pattern", ANSWERS)
def test_answers_are_those_of_cmake(pattern: str) -> None:
    assert answers(pattern, TEXTS) == ANSWERS[pattern]


@pytest.mark.parametrize("pattern", REFUSED)
def test_what_cmake_refuses_is_refused(pattern: str) -> None:
    with pytest.raises(RegexError) as error:
        Expression(pattern, lambda _: None)
    assert str(error.value).startswith(f"'{pattern}' isn't a regular expression: ")


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("cmake") is None, reason="CMake is not installed")
def test_random_expressions_are_read_as_by_cmake(tmp_path: Path) -> None:
    chance = random.Random(28)
    found = 0
    for pattern in [*ANSWERS, *REFUSED]:
        assert answers_of_cmake(pattern, TEXTS, tmp_path / "a.cmake") == ANSWERS.get(pattern, ""), pattern
    for _ in range(100):
        pattern = "".join(chance.choice("aabbc()[]^$*+?|.-\\") for _ in range(chance.randint(1, 9)))
        texts = ["".join(chance.choice("abc-]^.\\(") for _ in range(chance.randint(0, 6))) for _ in range(12)]
        try:
            own = answers(pattern, texts)
        except RegexError:
            own = ""
        assert own == answers_of_cmake(pattern, texts, tmp_path / "a.cmake"), (pattern, texts)
        found += bool(own)
    assert found > 20


@pytest.mark.parametrize(
    ("pattern", "text"),
    [
        ("(a+)+$", "a" * 10_000 + "b"),
        ("((a+)+)+((a|aa)+)+$", "a" * 10_000 + "b"),
        ("(a|b|ab)+c$", "ab" * 10_000),
        ("([^/]+/)+([^/]+/)+x$", "ab/" * 5_000),
    ],
)
def test_steps_do_not_grow_with_the_text(pattern: str, text: str) -> None:
    steps: list[int] = []
    assert not Expression(pattern, steps.append).is_found_in(text)
    assert sum(steps) < 1000


def test_long_and_deep_expressions_are_refused() -> None:
    with pytest.raises(RegexError, match=rf"it has 10001 bytes, more than {MAX_PATTERN}"):
        Expression("a" * 10_001, lambda _: None)
    with pytest.raises(RegexError, match="more than 100 parentheses are nested"):
        Expression("(" * 101 + ")" * 101, lambda _: None)
