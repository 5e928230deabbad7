"""The syntax of CMakeLists.txt: commands, each with its arguments and the line it begins in."""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum
from pathlib import Path
from typing import NamedTuple

MAX_CHARACTERS = 1_000_000
"""Length of the longest file."""
MAX_ARGUMENTS = 50_000
"""Arguments that the commands of one file may have."""
MAX_NESTED = 100
"""Levels of parentheses in parentheses, and of blocks in blocks."""


class Form(Enum):
    """How an argument is written, which decides what is replaced in it and whether it is a list."""

    UNQUOTED = "unquoted"
    QUOTED = "quoted"
    BRACKET = "bracket"


class Argument(NamedTuple):
    """An argument as written, without its quotes or brackets; parentheses inside a command are arguments too."""

    text: str
    form: Form
    line: int


class Command(NamedTuple):
    """A command. CMake ignores the case of its name, which is lower case here."""

    name: str
    arguments: tuple[Argument, ...]
    line: int


class CMakeSyntaxError(ValueError):
    """A CMakeLists.txt can't be read; the text names file and line."""

    def __init__(self, path: Path, line: int, reason: str) -> None:
        super().__init__(f"{path}:{line}: {reason}")


_SPACE = re.compile(r"(?:[ \t\r\n]+|#\[(=*)\[.*?\]\1\]|#(?!\[=*\[)[^\n]*)+", re.DOTALL)
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_BRACKET_BEGIN = re.compile(r"\[=*\[")
_BRACKET = re.compile(r"\[(=*)\[\n?(.*?)\]\1\]", re.DOTALL)
_QUOTED = re.compile(r'"((?:[^"\\]|\\.)*)"', re.DOTALL)
_UNQUOTED = re.compile(r'(?:[^\s()#"\\]|\\.|(?<=[^\s()#"\\])"[^"\n]*")+', re.DOTALL)


def read_commands(path: Path) -> list[Command]:
    """Return the commands of a file in their order; nothing is run or replaced.

    Raises:
        CMakeSyntaxError: it isn't UTF-8 text, or not CMake's language.
        OSError: it can't be read.
    """
    data = path.read_bytes()
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise CMakeSyntaxError(path, line, f"octet {data[error.start]:#04x} isn't UTF-8 text") from None
    if len(text) > MAX_CHARACTERS:
        raise CMakeSyntaxError(path, 1, f"it has {len(text)} characters, more than {MAX_CHARACTERS}")
    return list(_Reader(path, text).commands())


class _Reader:
    """A position in the text of a file."""

    def __init__(self, path: Path, text: str) -> None:
        self._path = path
        self._text = text
        self._at = 0
        self._counted = 0
        self._lines = 1
        self._count = 0

    def commands(self) -> Iterator[Command]:
        while self._skip_space():
            line = self._line()
            name = self._match(_NAME)
            if name is None:
                raise self._error(f"a command's name is expected, not {self._text[self._at]!r}")
            self._skip_space()
            if not self._take("("):
                raise self._error(f"'(' is expected after '{name[0]}'")
            yield Command(name[0].lower(), tuple(self._arguments(name[0], line)), line)

    def _arguments(self, command: str, begin: int) -> Iterator[Argument]:
        """Yield the arguments up to the parenthesis that closes the command."""
        depth = 1
        while self._skip_space():
            line = self._line()
            self._count += 1
            if self._count > MAX_ARGUMENTS:
                raise self._error(f"the commands have more than {MAX_ARGUMENTS} arguments")
            if self._take("("):
                depth += 1
                if depth > MAX_NESTED:
                    raise self._error(f"more than {MAX_NESTED} parentheses are nested")
                yield Argument("(", Form.UNQUOTED, line)
            elif self._take(")"):
                depth -= 1
                if not depth:
                    return
                yield Argument(")", Form.UNQUOTED, line)
            else:
                yield self._argument(command, line)
        raise CMakeSyntaxError(self._path, begin, f"the parenthesis of '{command}(' isn't closed")

    def _argument(self, command: str, line: int) -> Argument:
        if (bracket := self._match(_BRACKET)) is not None:
            return Argument(bracket[2], Form.BRACKET, line)
        # An opening bracket without its end is an error, as in CMake. Read as a word instead, many of them would each
        # be looked for up to the end of the file.
        if _BRACKET_BEGIN.match(self._text, self._at):
            raise self._error(f"the bracket of an argument of '{command}' isn't closed")
        if (quoted := self._match(_QUOTED)) is not None:
            return Argument(quoted[1].replace("\\\n", ""), Form.QUOTED, line)
        if self._text[self._at] == '"':
            raise self._error(f"the quote of an argument of '{command}' isn't closed")
        if (word := self._match(_UNQUOTED)) is not None:
            return Argument(word[0], Form.UNQUOTED, line)
        raise self._error(f"{self._text[self._at]!r} isn't expected in the arguments of '{command}'")

    def _skip_space(self) -> bool:
        """Skip white space and comments; return whether there is more."""
        self._match(_SPACE)
        return self._at < len(self._text)

    def _take(self, letter: str) -> bool:
        is_next = self._text.startswith(letter, self._at)
        self._at += is_next
        return is_next

    def _match(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        match = pattern.match(self._text, self._at)
        if match is not None:
            self._at = match.end()
        return match

    def _line(self) -> int:
        # Only what was read since the last call is counted, so that all lines together are counted once.
        self._lines += self._text.count("\n", self._counted, self._at)
        self._counted = self._at
        return self._lines

    def _error(self, reason: str) -> CMakeSyntaxError:
        return CMakeSyntaxError(self._path, self._line(), reason)
