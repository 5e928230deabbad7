"""The words of an IDL text, each with its line and column."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from typing import NamedTuple

from tfloom.rosidl.parse import ParseError

_TOKEN = re.compile(
    r"""
      (?P<space>   \s+ | //[^\n]* | /\*.*?\*/ )
    | (?P<include> \#[ \t]*include[ \t]*(?:"[^"\n]+"|<[^>\n]+>) )
    | (?P<string>  L?"(?:[^"\\\n]|\\[^\n])*" )
    | (?P<float>   (?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?[dD]? | \d+[eE][+-]?\d+[dD]? | \d+[dD] )
    | (?P<integer> 0[xX][0-9a-fA-F]+ | \d+ )
    | (?P<word>    [A-Za-z][A-Za-z0-9_]* )
    | (?P<mark>    :: | << | /(?!\*) | [{}()\[\]<>;,=@+\-*%|^&~:] )
    | (?P<end>     \Z )
    """,
    re.DOTALL | re.VERBOSE,
)
_STARTS = {
    "#": 'of the preprocessor\'s directives, ROS has only #include "file"',
    '"': "the string has no closing quote on its line",
    "/*": "the comment has no end",
    "'": "ROS has no characters in single quotes; a string is in double quotes",
}


class Token(NamedTuple):
    """A word, a literal or a mark."""

    kind: str
    """include, string, float, integer, word, mark or end."""
    text: str
    position: tuple[int, int]
    """Line and column, from 1."""


def tokens(text: str, path: str) -> Iterator[Token]:
    """Yield the tokens of a text without spaces and comments; the last one is of kind `end`.

    Raises:
        ParseError: at a place there is no token; the text has the line and column.
    """
    lines = [0, *(match.end() for match in re.finditer("\n", text))]
    at = 0
    while True:
        line = bisect_right(lines, at)
        position = (line, at - lines[line - 1] + 1)
        match = _TOKEN.match(text, at)
        if match is None:
            raise ParseError(path, *position, _reason(text[at:]))
        kind = str(match.lastgroup)
        if kind != "space":
            yield Token(kind, match[0], position)
        if kind == "end":
            return
        at = match.end()


def _reason(rest: str) -> str:
    return next(
        (reason for start, reason in _STARTS.items() if rest.startswith(start)),
        f"'{rest[0]}' can't be here",
    )
