"""XML as a tree of elements that know their lines. No text stands for more than itself."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.parsers import expat

from tfloom.common.xml import make_parser, readable
from tfloom.robot.mended_xml import mended
from tfloom.robot.urdf_faults import Remarks, UrdfError

__all__ = ["Element", "read_xml"]

LARGEST = 64 * 1024 * 1024
"""Length of the longest text that is read [characters or bytes]."""
MAX_DEPTH = 200
"""Levels of elements in elements."""


class Element:
    """An element, without its text.

    Args:
        tag: Name, with the prefix of its namespace, as `xacro:macro`.
        attributes: Its attributes.
        line: Line of its start tag, from 1.
        source: Its start tag as it stands in the text, if that has tabs or line breaks, else empty.
    """

    def __init__(self, tag: str, attributes: dict[str, str], line: int, source: bytes = b"") -> None:
        self._source = source
        self.tag = tag
        self.attributes = attributes
        self.line = line
        self.children: list[Element] = []

    def written(self, attribute: str) -> str:
        """Return the value of an attribute as it is written: XML turns its tabs and line breaks into spaces."""
        pattern = rb"""\s%s\s*=\s*(["'])(.*?)\1""" % attribute.encode()
        match = re.search(pattern, self._source, re.DOTALL) if self._source else None
        return self.attributes[attribute] if match is None else match[2].decode("utf-8", "replace")

    def all_of(self, tag: str) -> Iterator[Element]:
        """Yield the children of a name, in order."""
        return (child for child in self.children if child.tag == tag)

    def first(self, tag: str) -> Element | None:
        """Return the first child of a name, or None."""
        return next(self.all_of(tag), None)

    def descendants(self) -> Iterator[Element]:
        """Yield the elements below this one, in the order of the text."""
        waiting = self.children[::-1]
        while waiting:
            element = waiting.pop()
            yield element
            waiting += element.children[::-1]

    def first_within(self, tag: str) -> Element | None:
        """Return this element if it has a name, else the first of that name below it in the text, or None."""
        if self.tag == tag:
            return self
        return next(filter(None, (child.first_within(tag) for child in self.children)), None)


class _Builder:
    """Builds the tree from expat's calls."""

    def __init__(self) -> None:
        self.root: Element | None = None
        self._open: list[Element] = []
        self._data = b""
        self.parser = make_parser(self._refuse_entity)
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end

    def read(self, text: str | bytes) -> Element:
        self._data = text.encode() if isinstance(text, str) else text
        self.parser.Parse(text, True)  # expat takes no keyword: this is all of the text
        if self.root is None:  # not reached: expat refuses a text without an element
            raise UrdfError(1, "there is no element")
        return self.root

    def reason(self, error: expat.ExpatError) -> str:
        """Return what is wrong with a text, for its reader."""
        within = f", within <{self._open[-1].tag}> of line {self._open[-1].line}" if self._open else ""
        return f"not well-formed XML: {expat.ErrorString(error.code)} at column {error.offset + 1}{within}"

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        start = self.parser.CurrentByteIndex
        source = self._data[start : self._data.find(b">", start)]
        has_breaks = b"\t" in source or b"\n" in source
        element = Element(tag, attributes, self.parser.CurrentLineNumber, source if has_breaks else b"")
        if len(self._open) >= MAX_DEPTH:
            raise UrdfError(element.line, f"more than {MAX_DEPTH} elements are nested")
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _end(self, _: str) -> None:
        self._open.pop()

    def _refuse_entity(self, name: str) -> None:
        reason = f"the entity '{name}' is declared, but entities are not supported"
        raise UrdfError(self.parser.CurrentLineNumber, reason)


def read_xml(text: str | bytes, remarks: Remarks | None = None) -> Element:
    """Return the root element of a text.

    Args:
        text: A str, or the bytes of a file, whose encoding its first line names.
        remarks: Get what had to be mended before the text could be read.

    Raises:
        UrdfError: the text is not well-formed, too long or nested too deep, or declares entities.
    """
    if len(text) > LARGEST:
        raise UrdfError(1, f"a text of {len(text)} characters is longer than {LARGEST}")
    try:
        return _Builder().read(readable(text))
    except UrdfError:
        raise
    except (expat.ExpatError, LookupError, ValueError):
        pass  # not well-formed, or in an encoding that can't be read
    builder = _Builder()
    try:
        return builder.read(mended(text, remarks or Remarks()))
    except expat.ExpatError as error:
        raise UrdfError(error.lineno, builder.reason(error)) from None
    except UnicodeError as error:  # a lone surrogate
        raise UrdfError(1, f"the text can't be decoded: {error}") from None
