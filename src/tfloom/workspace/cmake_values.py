"""Variables, lists and conditions of CMakeLists.txt."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from tfloom.workspace.cmake_syntax import Argument, Form

_REFERENCE = re.compile(r"\$(ENV)?\{([A-Za-z0-9_./+-]*)\}|\\(.)", re.DOTALL)
_ESCAPES = {"n": "\n", "t": "\t", "r": "\r"}
_FALSE = {"", "0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND"}
_TRUE = {"1", "ON", "YES", "TRUE", "Y"}
_MOST_NESTED = 20
"""How deep `${${NAME}}` may be nested."""


class UnknownConditionError(ValueError):
    """A condition uses a test that isn't known."""


def expand(argument: Argument, variables: Mapping[str, str]) -> list[str]:
    """Return the values of an argument: variables replaced, and an unquoted one split at its semicolons."""
    if argument.form is Form.BRACKET:
        return [argument.text]
    text = expand_text(argument.text, variables)
    return [text] if argument.form is Form.QUOTED else split_list(text)


def expand_all(arguments: Iterable[Argument], variables: Mapping[str, str]) -> list[str]:
    """Return the values of arguments in their order."""
    return [value for argument in arguments for value in expand(argument, variables)]


def expand_text(text: str, variables: Mapping[str, str]) -> str:
    """Return a text with `${NAME}`, `$ENV{NAME}` and escapes replaced; an unset variable is empty."""

    def value(match: re.Match[str]) -> str:
        if match[3] is not None:
            return _ESCAPES.get(match[3], f"\\{match[3]}" if match[3] == ";" else match[3])
        return os.environ.get(match[2], "") if match[1] else variables.get(match[2], "")

    for _ in range(_MOST_NESTED):
        inner = re.sub(
            r"\$\{([^{}]*\$\{[A-Za-z0-9_./+-]*\}[^{}]*)\}", lambda m: _inner(m[0], variables), text
        )
        if inner == text:
            break
        text = inner
    return _REFERENCE.sub(value, text)


def _inner(text: str, variables: Mapping[str, str]) -> str:
    """Replace the references inside another one: `${A_${B}}`."""
    return "${" + re.sub(r"\$\{([A-Za-z0-9_./+-]*)\}", lambda m: variables.get(m[1], ""), text[2:-1]) + "}"


def split_list(text: str) -> list[str]:
    """Return the elements of a list, which semicolons separate; empty ones are omitted, as in arguments."""
    return [part.replace("\\;", ";") for part in re.split(r"(?<!\\);", text) if part]


def is_true(arguments: Iterable[Argument], variables: Mapping[str, str], folder: Path) -> bool:
    """Return the value of the condition of an `if`.

    Args:
        arguments: As written.
        variables: By name.
        folder: The package's, for `EXISTS`.

    Raises:
        UnknownConditionError: it has a test that isn't known, or is incomplete.
    """
    words = [(value, each.form) for each in arguments for value in expand(each, variables) or [""]]
    condition = _Condition(words, variables, folder)
    result = condition.either()
    if condition.words:
        raise UnknownConditionError(f"'{condition.words[0][0]}' isn't understood in a condition")
    return result


class _Condition:
    """The words of a condition that are left to read; OR binds least, then AND, then NOT."""

    def __init__(self, words: list[tuple[str, Form]], variables: Mapping[str, str], folder: Path) -> None:
        self.words = words
        self._variables = variables
        self._folder = folder

    def either(self) -> bool:
        result = self._both()
        while self._take("OR"):
            result = self._both() or result
        return result

    def _both(self) -> bool:
        result = self._negated()
        while self._take("AND"):
            result = self._negated() and result
        return result

    def _negated(self) -> bool:
        return not self._negated() if self._take("NOT") else self._test()

    def _test(self) -> bool:
        if self._take("("):
            result = self.either()
            if not self._take(")"):
                raise UnknownConditionError("a parenthesis of the condition isn't closed")
            return result
        for word, test in _UNARY.items():
            if self._take(word):
                return test(self, self._next())
        left, form = self._next_word()
        for word, compare in _BINARY.items():
            if self._take(word):
                return compare(self._value(left, form), self._value(*self._next_word()))
        return self._truth(left, form)

    def _truth(self, text: str, form: Form) -> bool:
        upper = text.upper()
        if upper in _TRUE:
            return True
        if upper in _FALSE or upper.endswith("-NOTFOUND"):
            return False
        if re.fullmatch(r"-?\d+(\.\d*)?", text):
            return float(text) != 0
        if form is Form.QUOTED:
            return False
        value = self._variables.get(text, "").upper()
        return value not in _FALSE and not value.endswith("-NOTFOUND")

    def _value(self, text: str, form: Form) -> str:
        """Return the value of an operand: of the variable of that name if it is set and not quoted."""
        return text if form is Form.QUOTED else self._variables.get(text, text)

    def exists(self, path: str) -> bool:
        return (self._folder / path).exists()

    def is_folder(self, path: str) -> bool:
        return (self._folder / path).is_dir()

    def is_defined(self, name: str) -> bool:
        environment = re.fullmatch(r"ENV\{(.*)\}", name)
        return environment[1] in os.environ if environment else name in self._variables

    def is_target(self, _name: str) -> bool:
        """Return False: targets are of compiled code."""
        return False

    def _take(self, word: str) -> bool:
        found = bool(self.words) and self.words[0] == (word, Form.UNQUOTED)
        if found:
            del self.words[0]
        return found

    def _next(self) -> str:
        return self._next_word()[0]

    def _next_word(self) -> tuple[str, Form]:
        if not self.words:
            raise UnknownConditionError("the condition is incomplete")
        return self.words.pop(0)


_UNARY = {
    "EXISTS": _Condition.exists,
    "IS_DIRECTORY": _Condition.is_folder,
    "DEFINED": _Condition.is_defined,
    "TARGET": _Condition.is_target,
    "COMMAND": _Condition.is_target,
}


def _version(text: str) -> list[int]:
    return [int(part) for part in re.findall(r"\d+", text)]


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise UnknownConditionError(f"'{text}' isn't a number") from None


def _matches(text: str, pattern: str) -> bool:
    try:
        return re.search(pattern, text) is not None
    except re.error as error:
        raise UnknownConditionError(f"'{pattern}' isn't a regular expression: {error}") from None


_BINARY: dict[str, Callable[[str, str], bool]] = {
    "STREQUAL": lambda a, b: a == b,
    "STRLESS": lambda a, b: a < b,
    "STRGREATER": lambda a, b: a > b,
    "MATCHES": _matches,
    "EQUAL": lambda a, b: _number(a) == _number(b),
    "LESS": lambda a, b: _number(a) < _number(b),
    "GREATER": lambda a, b: _number(a) > _number(b),
    "LESS_EQUAL": lambda a, b: _number(a) <= _number(b),
    "GREATER_EQUAL": lambda a, b: _number(a) >= _number(b),
    "VERSION_EQUAL": lambda a, b: _version(a) == _version(b),
    "VERSION_LESS": lambda a, b: _version(a) < _version(b),
    "VERSION_GREATER": lambda a, b: _version(a) > _version(b),
    "VERSION_LESS_EQUAL": lambda a, b: _version(a) <= _version(b),
    "VERSION_GREATER_EQUAL": lambda a, b: _version(a) >= _version(b),
    "IN_LIST": lambda a, b: a in split_list(b),
}
