"""Variables, lists and conditions of CMakeLists.txt."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from pathlib import Path

from tfloom.workspace.cmake_regex import Expression, RegexError
from tfloom.workspace.cmake_syntax import MAX_NESTED, Argument, Form

_REFERENCE = re.compile(r"\$(ENV)?\{([A-Za-z0-9_./+-]*)\}|\\(.)", re.DOTALL)
_ESCAPES = {"n": "\n", "t": "\t", "r": "\r"}
FALSE_VALUES = {"", "0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND"}
_TRUE = {"1", "ON", "YES", "TRUE", "Y"}
_MAX_NESTING = 20
"""How deep `${${NAME}}` may be nested."""


_REFERENCE_COST = 10
"""Characters that take about the time of one reference."""
MAX_EXPANDED = 3_000_000
"""Characters that the commands of one file may have after the replacement of variables."""
MAX_STEPS = 300_000
"""Steps that the regular expressions of one file may take."""
_MAX_EXPRESSIONS = 8
"""Compiled expressions that are kept, because a loop uses them again."""


class TooMuchError(ValueError):
    """A file asks for more than is ever needed; the text says of what."""


class Variables(dict[str, str]):
    """The variables of a file. It counts what is read of them, because a few lines can double a value many times."""

    def __init__(self, values: Mapping[str, str]) -> None:
        super().__init__(values)
        self._expanded = 0
        self._steps = 0
        self._expressions: dict[str, Expression] = {}

    def count(self, length: int) -> None:
        """Add to the characters that the file has used.

        Raises:
            TooMuchError: there are more than MAX_EXPANDED.
        """
        self._expanded += length
        if self._expanded > MAX_EXPANDED:
            raise TooMuchError(f"the values of its variables take more than {MAX_EXPANDED} characters")

    def read(self, name: str, default: str = "") -> str:
        """Return the value of a variable, and count it; `default` if it isn't set."""
        value = self.get(name, default)
        self.count(len(value) + _REFERENCE_COST)
        return value

    def expression(self, pattern: str) -> Expression:
        """Return a regular expression, whose steps are counted.

        Raises:
            RegexError: the pattern isn't one.
            TooMuchError: those of the file take more than MAX_STEPS steps; searching raises it, too.
        """
        if pattern not in self._expressions:
            if len(self._expressions) == _MAX_EXPRESSIONS:
                self._expressions.clear()
            self._expressions[pattern] = Expression(pattern, self._count_steps)
        return self._expressions[pattern]

    def _count_steps(self, steps: int) -> None:
        self._steps += steps
        if self._steps > MAX_STEPS:
            raise TooMuchError(f"its regular expressions take more than {MAX_STEPS} steps")


class UnknownConditionError(ValueError):
    """A condition uses a test that isn't known."""


def expand(argument: Argument, variables: Variables) -> list[str]:
    """Return the values of an argument: variables replaced, and an unquoted one split at its semicolons."""
    if argument.form is Form.BRACKET:
        return [argument.text]
    text = expand_text(argument.text, variables)
    return [text] if argument.form is Form.QUOTED else split_list(text)


def expand_all(arguments: Iterable[Argument], variables: Variables) -> list[str]:
    """Return the values of arguments in their order."""
    return [value for argument in arguments for value in expand(argument, variables)]


def expand_text(text: str, variables: Variables) -> str:
    """Return a text with `${NAME}`, `$ENV{NAME}` and escapes replaced; an unset variable is empty."""

    def value(match: re.Match[str]) -> str:
        if match[3] is not None:
            variables.count(_REFERENCE_COST)
            return _ESCAPES.get(match[3], f"\\{match[3]}" if match[3] == ";" else match[3])
        if match[1]:
            variables.count(len(os.environ.get(match[2], "")))
            return os.environ.get(match[2], "")
        return variables.read(match[2])

    # `${A_${B}}` is read from the inside out, one level of all references in a round, until nothing changes. The last
    # level and the escapes come at the end, in one pass, whose results aren't read again.
    variables.count(len(text))
    if "$" not in text and "\\" not in text:  # as most words of a file
        return text
    for _ in range(_MAX_NESTING):
        inner = re.sub(
            r"\$\{([^{}]*\$\{[A-Za-z0-9_./+-]*\}[^{}]*)\}", lambda m: _inner(m[0], variables), text
        )
        if inner == text:
            break
        text = inner
    return _REFERENCE.sub(value, text)


def _inner(text: str, variables: Variables) -> str:
    """Replace the references inside another one: `${A_${B}}`."""
    return "${" + re.sub(r"\$\{([A-Za-z0-9_./+-]*)\}", lambda m: variables.read(m[1]), text[2:-1]) + "}"


def split_list(text: str) -> list[str]:
    """Return the elements of a list, which semicolons separate; empty ones are omitted, as in arguments."""
    if ";" not in text:
        return [text] if text else []
    return [part.replace("\\;", ";") for part in re.split(r"(?<!\\);", text) if part]


def is_true(arguments: Iterable[Argument], variables: Variables, folder: Path) -> bool:
    """Return the value of the condition of an `if`.

    Args:
        arguments: As written.
        variables: By name.
        folder: The package's, for `EXISTS`.

    Raises:
        UnknownConditionError: it has a test that isn't known, or is incomplete.
    """
    words = [
        (value, argument.form) for argument in arguments for value in expand(argument, variables) or [""]
    ]
    condition = _Condition(words, variables, folder)
    result = condition.disjunction()
    condition.check_end()
    return result


def is_file(path: Path) -> bool:
    """Return whether a path leads to a file, of any kind; False if the system refuses it, as a name of 300 letters."""
    with suppress(OSError):
        return path.exists() and not path.is_dir()
    return False


def is_folder(path: Path) -> bool:
    """Return whether a path leads to a folder; False if the system refuses it."""
    with suppress(OSError):
        return path.is_dir()
    return False


class _Condition:
    """The words of a condition that are left to read; OR binds least, then AND, then NOT."""

    def __init__(self, words: list[tuple[str, Form]], variables: Variables, folder: Path) -> None:
        self._words = words
        self._at = 0
        self._depth = 0
        self._variables = variables
        self._folder = folder

    def disjunction(self) -> bool:
        result = self._conjunction()
        while self._take("OR"):
            result = self._conjunction() or result
        return result

    def _conjunction(self) -> bool:
        result = self._negation()
        while self._take("AND"):
            result = self._negation() and result
        return result

    def _negation(self) -> bool:
        is_negated = False
        while self._take("NOT"):
            is_negated = not is_negated
        return self._test() != is_negated

    def _test(self) -> bool:
        if self._take("("):
            self._depth += 1
            if self._depth > MAX_NESTED:  # by the value of a variable; the syntax has this limit, too
                raise TooMuchError(f"more than {MAX_NESTED} parentheses are nested")
            result = self.disjunction()
            self._depth -= 1
            if not self._take(")"):
                raise UnknownConditionError("a parenthesis of the condition isn't closed")
            return result
        # A word is an operator only if it isn't quoted: `if("TARGET" STREQUAL name)` compares texts. Unary operators
        # come before their operand, binary ones after the first, so both are looked for before the word is taken as a
        # value.
        left, form = self._next_word()
        test = _UNARY.get(left) if form is Form.UNQUOTED else None
        if test is not None:
            return test(self, self._next_word()[0])
        word, how = self._words[self._at] if self._at < len(self._words) else ("", Form.QUOTED)
        compare = _BINARY.get(word) if how is Form.UNQUOTED else None
        if (word, how) == ("MATCHES", Form.UNQUOTED):
            self._at += 1
            return self._matches(self._value(left, form), self._next_word()[0])
        if compare is None:
            return self._truth(left, form)
        self._at += 1
        return compare(self._value(left, form), self._value(*self._next_word()))

    def _truth(self, text: str, form: Form) -> bool:
        upper = text.upper()
        if upper in _TRUE:
            return True
        if upper in FALSE_VALUES or upper.endswith("-NOTFOUND"):
            return False
        if re.fullmatch(r"-?\d+(\.\d*)?", text):
            return float(text) != 0
        if form is Form.QUOTED:
            return False
        value = self._variables.get(text, "").upper()
        return value not in FALSE_VALUES and not value.endswith("-NOTFOUND")

    def _value(self, text: str, form: Form) -> str:
        """Return the value of an operand: of the variable of that name if it is set and not quoted."""
        return text if form is Form.QUOTED else self._variables.read(text, text)

    def _matches(self, text: str, pattern: str) -> bool:
        try:
            return self._variables.expression(pattern).is_found_in(text)
        except RegexError as error:
            raise UnknownConditionError(str(error)) from None

    def exists(self, path: str) -> bool:
        return is_file(self._folder / path) or is_folder(self._folder / path)

    def is_folder(self, path: str) -> bool:
        return is_folder(self._folder / path)

    def is_defined(self, name: str) -> bool:
        environment = re.fullmatch(r"ENV\{(.*)\}", name)
        return environment[1] in os.environ if environment else name in self._variables

    def is_target(self, _name: str) -> bool:
        """Return False: targets are of compiled code."""
        return False

    def _take(self, word: str) -> bool:
        is_next = self._at < len(self._words) and self._words[self._at] == (word, Form.UNQUOTED)
        self._at += is_next
        return is_next

    def _next_word(self) -> tuple[str, Form]:
        if self._at >= len(self._words):
            raise UnknownConditionError("the condition is incomplete")
        self._at += 1
        return self._words[self._at - 1]

    def check_end(self) -> None:
        """Raise an error if there are words after the condition."""
        if self._at < len(self._words):
            raise UnknownConditionError(f"'{self._words[self._at][0]}' isn't understood in a condition")


_UNARY = {
    "EXISTS": _Condition.exists,
    "IS_DIRECTORY": _Condition.is_folder,
    "DEFINED": _Condition.is_defined,
    "TARGET": _Condition.is_target,
    "COMMAND": _Condition.is_target,
}


def _version(text: str) -> list[int]:
    return [int(part) for part in re.findall(r"\d{1,1000}", text)]  # Python reads no longer numbers


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise UnknownConditionError(f"'{text}' isn't a number") from None


_BINARY: dict[str, Callable[[str, str], bool]] = {
    "STREQUAL": lambda a, b: a == b,
    "STRLESS": lambda a, b: a < b,
    "STRGREATER": lambda a, b: a > b,
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
