"""PyYAML's scanner, with tabs where libyaml takes them, which is the parser of rcl and of PyYAML's C extension.

A tab may stand wherever a space separates tokens or words. It may not indent: where a block's key or item could begin
it is refused, as are tabs that would indent the lines of a plain text or of a block text.
"""

# PyYAML's stubs have no types for what a scanner calls.
# mypy: disable-error-code="no-untyped-call, method-assign"

from __future__ import annotations

import string
from typing import Any, NoReturn

from yaml.reader import Reader
from yaml.scanner import Scanner, ScannerError
from yaml.tokens import TagToken

__all__ = ["TabScanner"]

_BLANKS = " \t"
_BREAKS = "\r\n\x85\u2028\u2029"
_ENDS = f"\0{_BREAKS}"
_BLANKS_AND_ENDS = f"{_BLANKS}{_ENDS}"
_HANDLE = f"{string.ascii_letters}{string.digits}-_"


class TabScanner(Reader, Scanner):
    """Returns the tokens of a text.

    Args:
        text: The text.
    """

    def __init__(self, text: str) -> None:
        Reader.__init__(self, text)
        Scanner.__init__(self)

    def scan_to_next_token(self) -> None:
        """Skip blanks, comments and line breaks."""
        if self.index == 0 and self.peek() == "\ufeff":
            self.forward()
        while True:
            self._skip(_BLANKS if self.flow_level or not self.allow_simple_key else " ")
            self._skip_comment()
            if not self.scan_line_break():
                return
            if not self.flow_level:
                self.allow_simple_key = True

    def scan_directive(self) -> Any:
        """Return the token of a directive, whose parts a tab separates as a space does."""
        self.peek = self._peek_blank
        try:
            return super().scan_directive()
        finally:
            del self.peek

    def _peek_blank(self, index: int = 0) -> str:
        """Return the character that follows by this many, a space for a tab."""
        found: str = super().peek(index)
        return " " if found == "\t" else found

    def scan_directive_ignored_line(self, start_mark: Any) -> None:
        """Skip the rest of a directive's line."""
        self._skip_line("a directive", start_mark)

    def scan_tag(self) -> TagToken:
        """Return the token of a tag, `!handle!suffix` or `!<suffix>`."""
        start_mark = self.get_mark()
        handle: str | None = "!"
        if self.peek(1) == "<":
            handle = None
            self.forward(2)
            suffix = self.scan_tag_uri("tag", start_mark)
            if self.peek() != ">":
                self._fail("a tag", start_mark, f"expected '>', but found {self.peek()!r}")
            self.forward()
        elif self.peek(1) in _BLANKS_AND_ENDS:
            handle, suffix = None, "!"
            self.forward()
        else:
            length = 1
            while self.peek(length) in _HANDLE:
                length += 1
            if self.peek(length) == "!":
                handle = self.scan_tag_handle("tag", start_mark)
            else:
                self.forward()
            suffix = self.scan_tag_uri("tag", start_mark)
            if any(ch in suffix for ch in ",[]"):
                self._fail(
                    "a tag", start_mark, f"did not find a blank or line break after it, but {suffix!r}"
                )
        if self.peek() not in _BLANKS_AND_ENDS and not (self.flow_level and self.peek() == ","):
            self._fail("a tag", start_mark, f"expected ' ', but found {self.peek()!r}")
        return TagToken((handle, suffix), start_mark, self.get_mark())

    def scan_block_scalar_indicators(self, start_mark: Any) -> tuple[bool | None, int | None]:
        """Return whether a block text keeps its final line breaks, and by how much it is indented; None if not told."""
        chomping: bool | None = None
        increment: int | None = None
        while (ch := self.peek()) in "+-0123456789":
            if ch in "+-" and chomping is None:
                chomping = ch == "+"
            elif ch in "123456789" and increment is None:
                increment = int(ch)
            else:
                break
            self.forward()
        if self.peek() not in f"{_BLANKS_AND_ENDS}#":
            found = f"expected '+', '-' or a number from 1 to 9 once each, but found {self.peek()!r}"
            self._fail("a block scalar", start_mark, found)
        return chomping, increment

    def scan_block_scalar_ignored_line(self, start_mark: Any) -> None:
        """Skip the rest of the line of a block text's indicators."""
        self._skip_line("a block scalar", start_mark)

    def scan_block_scalar_indentation(self) -> tuple[list[str], int, Any]:
        """Skip the empty lines before a block text, and return their breaks, the widest of them and their end."""
        found: tuple[list[str], int, Any] = super().scan_block_scalar_indentation()
        self._refuse_indenting_tab()
        return found

    def scan_block_scalar_breaks(self, indent: int) -> tuple[list[str], Any]:
        """Skip the empty lines and the indentation in a block text, and return their breaks and their end."""
        found: tuple[list[str], Any] = super().scan_block_scalar_breaks(indent)
        if self.column < indent:
            self._refuse_indenting_tab()
        return found

    def scan_plain_spaces(self, indent: int, start_mark: Any) -> list[str]:
        """Skip the blanks and line breaks behind a word of a plain text, and return what they stand for in it."""
        length = 0
        while self.peek(length) in _BLANKS:
            length += 1
        blanks = self.prefix(length)
        self.forward(length)
        if self.peek() not in _BREAKS:
            return [blanks] if blanks else []
        line_break = self.scan_line_break()
        self.allow_simple_key = True
        breaks: list[str] = []
        while not self._is_document_marker():
            if self.peek() in _BREAKS:
                breaks.append(self.scan_line_break())
            elif self.peek() not in _BLANKS:
                return [line_break, *breaks] if line_break != "\n" else breaks or [" "]
            elif self.peek() == "\t" and self.column < indent:
                self._fail("a plain scalar", start_mark, "found a tab character that violates indentation")
            else:
                self.forward()
        return []

    def _is_document_marker(self) -> bool:
        is_marker = self.column == 0 and self.prefix(3) in {"---", "..."}
        return is_marker and self.peek(3) in _BLANKS_AND_ENDS

    def _skip(self, characters: str) -> None:
        while self.peek() in characters:
            self.forward()

    def _skip_comment(self) -> None:
        if self.peek() == "#":
            while self.peek() not in _ENDS:
                self.forward()

    def _skip_line(self, context: str, start_mark: Any) -> None:
        self._skip(_BLANKS)
        self._skip_comment()
        if self.peek() not in _ENDS:
            self._fail(context, start_mark, f"expected a comment or a line break, but found {self.peek()!r}")
        self.scan_line_break()

    def _refuse_indenting_tab(self) -> None:
        if self.peek() == "\t":
            problem = "found a tab character where an indentation space is expected"
            self._fail("a block scalar", self.get_mark(), problem)

    def _fail(self, context: str, start_mark: Any, problem: str) -> NoReturn:
        raise ScannerError(f"while scanning {context}", start_mark, problem, self.get_mark())
