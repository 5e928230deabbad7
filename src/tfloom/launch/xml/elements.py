"""The elements of an XML text, each with its line. Entities cannot be declared, and nothing is loaded from outside."""

from __future__ import annotations

from collections.abc import Iterator
from xml.parsers import expat

from tfloom.common.xml import make_parser, readable

__all__ = ["Element", "XmlError", "read_elements"]

_DEEPEST = 100


class XmlError(ValueError):
    """A text isn't well-formed XML, or declares entities.

    Args:
        problem: What is wrong.
        line: Line of the text, from 1.
    """

    def __init__(self, problem: str, line: int) -> None:
        super().__init__(problem)
        self.line = line


class Element:
    """An element with its place, and with the attributes that entities need of those of `xml.etree`.

    Args:
        tag: Its tag.
        attrib: Its attributes.
        place: File and line, as `file.launch.xml:3`.
    """

    def __init__(self, tag: str, attrib: dict[str, str], place: str) -> None:
        self.tag = tag
        self.attrib = attrib
        self.place = place
        self.children: list[Element] = []

    def __iter__(self) -> Iterator[Element]:
        return iter(self.children)


class _Builder:
    """Builds the tree from expat's events."""

    def __init__(self, file: str) -> None:
        self._file = file
        self.parser = make_parser(self._refuse_entity_declaration)
        self._open: list[Element] = []
        self.root: Element | None = None
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._close_element
        self.parser.SkippedEntityHandler = self._refuse_undefined_entity

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        line = self.parser.CurrentLineNumber
        if len(self._open) >= _DEEPEST:
            raise XmlError(f"it is nested deeper than {_DEEPEST} levels", line)
        element = Element(tag, attributes, f"{self._file}:{line}")
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _close_element(self, _tag: str) -> None:
        self._open.pop()

    def _refuse_entity_declaration(self, name: str) -> None:
        line = self.parser.CurrentLineNumber
        raise XmlError(f"it declares the entity '{name}', which launch files cannot do", line)

    def _refuse_undefined_entity(self, name: str, _is_parameter: object) -> None:
        raise XmlError(f"undefined entity '&{name};'", self.parser.CurrentLineNumber)


def read_elements(text: bytes, file: str) -> Element:
    """Return the root of an XML text.

    Args:
        text: The text, in the encoding that it declares, or UTF-8.
        file: Its path, for the elements' places.

    Raises:
        XmlError: it isn't well-formed, declares entities, or is nested too deep.
    """
    builder = _Builder(file)
    try:
        builder.parser.Parse(readable(text), True)
    except expat.ExpatError as error:
        where = f"line {error.lineno}, column {error.offset}"
        problem = f"it is not well-formed XML: {expat.ErrorString(error.code)}: {where}"
        raise XmlError(problem, error.lineno) from None
    except (
        LookupError,
        UnicodeError,
    ) as error:  # of an encoding that Python doesn't know, or not in the declared one
        raise XmlError(str(error), 1) from None
    if builder.root is None:
        raise XmlError("it is empty", 1)
    return builder.root
