"""The parsers of all XML that is read. No text stands for more than itself, and nothing is loaded from outside."""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable
from pathlib import Path
from typing import IO, TYPE_CHECKING
from xml.parsers import expat

if TYPE_CHECKING:
    from xml.etree import ElementTree as ET

__all__ = ["declared_encoding", "guard_minidom", "make_parser", "read_tree", "readable"]

_ENCODING = re.compile(
    rb"""(?:\xef\xbb\xbf)?\s*<\?xml\s[^>]*?encoding\s*=\s*["']([A-Za-z][A-Za-z0-9._-]*)["']"""
)
_MAX_DECLARATION = 1000
"""Length of the first line in which an encoding is looked for."""
MAX_TREE = 4_000_000
"""Length of the longest text of which a tree is made [characters or bytes]."""


def make_parser(refuse: Callable[[str], None], namespace_separator: str | None = None) -> expat.XMLParserType:
    """Return a parser.

    Args:
        refuse: Called with the name of an entity that the text declares, or uses and does not declare; it raises an
            error, because a few entities of entities can stand for gigabytes.
        namespace_separator: As for `ParserCreate`.
    """
    parser = expat.ParserCreate(None, namespace_separator)
    parser.EntityDeclHandler = lambda name, *_: refuse(name)
    parser.SkippedEntityHandler = lambda name, _: refuse(name)
    parser.specified_attributes = True  # a declared default may be long, for each element anew
    return parser


def declared_encoding(data: bytes) -> str | None:
    """Return the encoding that the first line of a file names, or None."""
    match = _ENCODING.match(data[:_MAX_DECLARATION])
    return match[1].decode() if match else None


def readable(text: str | bytes) -> str | bytes:
    """Return a text that expat can read: one whose encoding has characters of several bytes is decoded.

    Raises:
        UnicodeError: the text is not in the encoding that it names.
    """
    if isinstance(text, str):  # expat ignores the encoding that a text names
        return text
    name = declared_encoding(text)
    try:
        if name is None or codecs.lookup(name).name in {"utf-8", "utf-16"} or _has_single_bytes(name):
            return text
    except LookupError:  # expat names it
        return text
    return text.decode(name)


def _has_single_bytes(encoding: str) -> bool:
    return len(bytes(range(256)).decode(encoding, "replace")) == 256


def read_tree(text: str | bytes) -> ET.Element:
    """Return the root of an XML text.

    Raises:
        ElementTree.ParseError: it isn't well-formed, is too long, or has entities; it has the position.
    """
    from xml.etree import ElementTree as ET

    def error_at(line: int, column: int, problem: str) -> ET.ParseError:
        error = ET.ParseError(f"{problem}: line {line}, column {column}")
        error.code, error.position = 0, (line, column)
        return error

    def refuse(name: str) -> None:
        problem = f"the entity '{name}' is used or declared, but entities are not supported"
        raise error_at(parser.CurrentLineNumber, parser.CurrentColumnNumber, problem)

    if len(text) > MAX_TREE:
        raise error_at(1, 0, f"a text of {len(text)} characters is longer than {MAX_TREE}")
    builder = ET.TreeBuilder()
    parser = make_parser(refuse, "}")
    parser.buffer_text = True
    parser.StartElementHandler = lambda tag, attributes: builder.start(
        _name(tag), {_name(name): value for name, value in attributes.items()}
    )
    parser.EndElementHandler = lambda tag: builder.end(_name(tag))
    parser.CharacterDataHandler = builder.data
    try:
        parser.Parse(readable(text), True)  # expat takes no keyword: this is all of the text
    except expat.ExpatError as error:
        raise error_at(error.lineno, error.offset, expat.ErrorString(error.code)) from None
    except (LookupError, UnicodeError) as error:  # an encoding that is not known; a lone surrogate
        raise error_at(1, 0, f"the text can't be decoded, {error}") from None
    return builder.close()


def guard_minidom() -> None:
    """Let `xml.dom.minidom` of this process read XML by `make_parser`, for a library that uses it.

    Its functions `parse` and `parseString` raise ExpatError for entities, as for what isn't well-formed.
    """
    from xml.dom import expatbuilder, minidom

    class Builder(expatbuilder.ExpatBuilderNS):
        def createParser(self) -> expat.XMLParserType:  # noqa: N802  # its name there
            self.own_parser = make_parser(self.refuse, " ")
            self.own_parser.namespace_prefixes = True
            return self.own_parser

        def refuse(self, name: str) -> None:
            place = f"line {self.own_parser.CurrentLineNumber}, column {self.own_parser.CurrentColumnNumber}"
            raise expat.ExpatError(
                f"the entity '{name}' is used or declared, but entities are not supported: {place}"
            )

        def entity_decl_handler(self, name: str, *_: object) -> None:
            self.refuse(name)

    def parse_string(text: str | bytes, *_: object) -> minidom.Document:
        builder = Builder()
        builder.reset()
        document: minidom.Document = builder.parseString(readable(text))
        return document

    def parse(file: str | IO[str] | IO[bytes], *_: object) -> minidom.Document:
        return parse_string(Path(file).read_bytes() if isinstance(file, str) else file.read())

    vars(minidom).update(parse=parse, parseString=parse_string)


def _name(expanded: str) -> str:
    """Return the name of an element or attribute as ElementTree has it, `{namespace}name`."""
    return f"{{{expanded}" if "}" in expanded else expanded
