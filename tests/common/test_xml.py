"""The XML that tfloom reads: no text stands for more than itself."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from xml.dom import minidom
from xml.etree import ElementTree as ET
from xml.parsers import expat

import pytest

import tfloom
from tfloom.common.xml import MAX_TREE, guard_minidom, read_tree
from tfloom.launch.files.xml_file import XmlError, read_elements
from tfloom.robot.urdf_faults import UrdfError
from tfloom.robot.xml_elements import read_xml

READERS: list[Callable[[bytes], object]] = [read_tree, read_xml, lambda data: read_elements(data, "a.xml")]


@pytest.fixture
def guarded(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let minidom read by our parser, for a test."""
    for name in ("parse", "parseString"):
        monkeypatch.setattr(minidom, name, getattr(minidom, name))
    guard_minidom()


@pytest.mark.parametrize(
    "text",
    [
        '<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>',
        '<!DOCTYPE a SYSTEM "no.dtd"><a>&b;</a>',
        "<a>&b;</a>",
        "<a>",
    ],
)
def test_minidom_refuses_entities(guarded: None, text: str) -> None:
    for read in (minidom.parseString, lambda text: minidom.parse(io.StringIO(text))):
        with pytest.raises(expat.ExpatError, match=r"entity.*line 1, column|no element found: line 1"):
            read(text)


@pytest.mark.parametrize(
    "text",
    [
        '<!DOCTYPE a [<!ATTLIST b c CDATA "long">]><a><b/></a>',
        '<a xmlns:x="urn:x" x:b="1">t<x:c d="e"/><!-- f --><![CDATA[g]]>&amp;ü</a>',
    ],
)
def test_minidom_reads_all_else_as_before(
    text: str, request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = minidom.parseString(text).toxml()
    request.getfixturevalue("guarded")
    assert minidom.parseString(text).toxml() == before == minidom.parse(io.StringIO(text)).toxml()
    assert minidom.parseString(text.encode()).toxml() == before


@pytest.mark.parametrize("read", READERS)
def test_a_declared_default_is_in_no_element(read: Callable[[bytes], object]) -> None:
    root = read(b'<!DOCTYPE a [<!ATTLIST b c CDATA "long">]><a><b/><b c="own"/></a>')
    children = getattr(root, "children", root)
    found = [getattr(child, "attributes", None) or getattr(child, "attrib", {}) for child in children]
    assert found == [{}, {"c": "own"}]


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize(
    "text", ['<!DOCTYPE a [<!ENTITY b "c">]><a/>', '<!DOCTYPE a SYSTEM "no.dtd"><a>&b;</a>', "<a>&b;</a>"]
)
def test_entities_are_refused(read: Callable[[bytes], object], text: str) -> None:
    if read is read_xml and "DOCTYPE" not in text:
        assert read_xml(text.encode()).tag == "a"  # TinyXML takes it for text, so a description may have it
        return
    with pytest.raises((ET.ParseError, UrdfError, XmlError), match="entity"):
        read(text.encode())


@pytest.mark.parametrize(
    "text",
    [
        '<a b="1">t<c/>u<!-- v --><d xml:lang="e">&amp;</d>\n</a>',
        '<a xmlns="urn:n" xmlns:p="urn:p" p:b="1"><p:c/></a>',
    ],
)
def test_a_tree_is_that_of_the_library(text: str) -> None:
    assert ET.tostring(read_tree(text)) == ET.tostring(ET.fromstring(text))


@pytest.mark.parametrize("text", ["<a>\n<b></a>", "", "<a>&</a>", "<a/>b"])
def test_a_fault_is_that_of_the_library(text: str) -> None:
    with pytest.raises(ET.ParseError) as expected:
        ET.fromstring(text)
    with pytest.raises(ET.ParseError) as found:
        read_tree(text)
    assert (str(found.value), found.value.position) == (str(expected.value), expected.value.position)


@pytest.mark.parametrize(
    "text", ["<a>" + " " * MAX_TREE + "</a>", b'<?xml version="1.0" encoding="no-such"?><a/>']
)
def test_a_text_that_cannot_be_read_is_named(text: str | bytes) -> None:
    with pytest.raises(ET.ParseError, match=r"longer than|encoding"):
        read_tree(text)


ENCODINGS = [
    "gb2312",
    "gbk",
    "gb18030",
    "big5",
    "shift_jis",
    "euc-jp",
    "euc-kr",
    "iso-8859-1",
    "cp1251",
    "utf-8",
    "utf-16",
]


def minidom_tree(data: bytes) -> object:
    return minidom.parseString(data).documentElement


@pytest.mark.parametrize("read", [*READERS, minidom_tree])
@pytest.mark.parametrize("encoding", ENCODINGS)
def test_encodings_are_read(read: Callable[[bytes], object], encoding: str, guarded: None) -> None:
    letter = {"iso-8859-1": "\u00e9", "cp1251": "\u0416", "euc-kr": "\uac00"}.get(encoding, "\u4e2d")
    data = f'<?xml version="1.0" encoding="{encoding}"?>\n<a b="{letter}"/>'.encode(encoding)
    root = read(data)
    attributes = getattr(root, "attributes", None) or getattr(root, "attrib", {})
    assert dict(getattr(attributes, "items", dict)()) == {"b": letter}


@pytest.mark.parametrize("read", [read_tree, lambda data: read_elements(data, "a.xml"), minidom_tree])
def test_octets_that_are_not_of_their_encoding_are_an_error(
    read: Callable[[bytes], object], guarded: None
) -> None:
    with pytest.raises((ET.ParseError, XmlError, UnicodeDecodeError), match="gb2312"):
        read(b'<?xml version="1.0" encoding="gb2312"?><a b="\xff\xff"/>')


def test_no_other_module_makes_a_parser() -> None:
    house = Path(tfloom.__file__).parent
    marks = ("ParserCreate", "ET.fromstring", "ET.parse(", "ET.XML", "minidom.", "iterparse", "sax.parse")
    found = {
        path.relative_to(house).as_posix()
        for path in house.rglob("*.py")
        if any(mark in path.read_text("utf-8") for mark in marks)
    }
    assert found == {"common/xml.py"}
