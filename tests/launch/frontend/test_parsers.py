"""Launch files in XML and YAML: attributes, their types, and errors with their places."""

# ruff: noqa: UP006, UP035  # programs write typing.List, and tfloom accepts both
from __future__ import annotations

import io
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any, List

import pytest

from tfloom.launch.actions.log import LogInfo
from tfloom.launch.core.entity import Entity
from tfloom.launch.entities.conditions import IfCondition, UnlessCondition
from tfloom.launch.files.xml_file import Entity as XmlEntity
from tfloom.launch.files.xml_file import Parser as XmlParser
from tfloom.launch.files.yaml_file import Entity as YamlEntity
from tfloom.launch.files.yaml_file import Parser as YamlParser
from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, Parser
from tfloom.launch.frontend.type_utils import check_is_list_entity, get_data_type_from_identifier


def xml(text: str) -> Any:
    """Return the first element of an XML file."""
    return xml_root(f"<launch>\n{text}\n</launch>").children[0]


def xml_root(text: str) -> Any:
    return XmlParser.load(named(text, "a.xml"))[0]


def yaml(text: str) -> Any:
    """Return the first element of a YAML file."""
    return yaml_root(f"launch:\n{text}").children[0]


def yaml_root(text: str) -> Any:
    return YamlParser.load(named(text, "a.yaml"))[0]


def named(text: str, name: str) -> io.StringIO:
    file = io.StringIO(text)
    file.name = name  # type: ignore[misc]
    return file


@pytest.mark.parametrize(
    ("text", "data_type", "value"),
    [
        ("1", str, "1"),
        ("1", int, 1),
        ("1", float, 1.0),
        ("1.5", float, 1.5),
        ("true", bool, True),
        ("1", None, 1),
        ("x: y", None, "x: y"),
        ("$(var x)", int, "$(var x)"),
        ("[1, 2]", List[int], [1, 2]),
        ("[1, 2]", List[float], [1.0, 2.0]),
        ("[a, b]", list[str], ["a", "b"]),
    ],
)
def test_type_of_an_xml_attribute(text: str, data_type: Any, value: Any) -> None:
    assert xml(f'<a b="{text}"/>').get_attr("b", data_type=data_type) == value


def test_xml_list_with_a_separator() -> None:
    entity = xml('<a b="1;2;3" b-sep=";"/>')
    assert entity.get_attr("b", data_type=List[int]) == [1, 2, 3]
    assert entity.get_attr("b", data_type=List[float]) == [1.0, 2.0, 3.0]
    assert entity.get_attr("b", data_type=List[str]) == ["1", "2", "3"]
    assert entity.get_attr("b", data_type=None) == [1, 2, 3]
    entity.assert_entity_completely_parsed()


def test_xml_attributes_that_cannot_be_read() -> None:
    entity = xml('<a b="x" bb="1" c="1" c-sep=""/>')
    assert entity.get_attr("none", optional=True) is None
    assert entity.get_attr("none", data_type=List[Entity], optional=True) is None
    with pytest.raises(
        AttributeError, match=r"^Attribute 'bbb' of type '<class 'str'>' not found in Entity 'a'; did"
    ):
        entity.get_attr("bbb")
    with pytest.raises(
        TypeError, match=r"Attribute 'b' of Entity 'a' expected to be of type '<class 'int'>'. 'x'"
    ):
        entity.get_attr("b", data_type=int, can_be_str=False)
    with pytest.raises(ValueError, match="Attribute 'c-sep' of Entity 'a' is empty"):
        entity.get_attr("c")


def test_xml_elements_and_places() -> None:
    entity = xml('<a x="1">\n<b/>\n<c y="2"/><b/></a>')
    assert (entity.type_name, entity.place, entity.parent.type_name) == ("a", "a.xml:2", "launch")
    children = entity.get_attr("b", data_type=List[Entity])
    assert [(child.type_name, child.place) for child in children] == [("b", "a.xml:3"), ("b", "a.xml:4")]
    assert [child.type_name for child in entity.children] == ["b", "c", "b"]
    assert children[0].parent is entity
    assert XmlEntity(ET.fromstring("<a/>")).place == ""


def test_unread_xml_attributes_and_elements_are_all_named() -> None:
    entity = xml('<node nam="x" colour="red"><parm/></node>')
    entity.get_attr("name", optional=True)
    entity.get_attr("param", data_type=List[Entity], optional=True)
    with pytest.raises(ValueError, match="Unexpected") as raised:
        entity.assert_entity_completely_parsed()
    assert str(raised.value) == (
        "Unexpected nested tag(s) found in `node`: {'parm'}; did you mean 'param'?; "
        "Unexpected attribute(s) found in `node`: {'colour', 'nam'}; did you mean 'name'? (for 'nam')"
    )


@pytest.mark.parametrize(
    ("text", "data_type", "value"),
    [
        ("x", str, "x"),
        ("'1'", str, "1"),
        ("1", int, 1),
        ("1.5", float, 1.5),
        ("yes", bool, True),
        ("1", None, 1),
        ("$(var x)", int, "$(var x)"),
        ("[1, 2]", List[int], [1, 2]),
        ("[a, b]", List[str], ["a", "b"]),
        ("[1, $(var x)]", List[int], [1, "$(var x)"]),
    ],
)
def test_type_of_a_yaml_attribute(text: str, data_type: Any, value: Any) -> None:
    assert yaml(f"- a: {{b: {text}}}").get_attr("b", data_type=data_type) == value


def test_yaml_attributes_that_cannot_be_read() -> None:
    entity = yaml("- a: {b: x, bb: 1, c: [1]}")
    assert entity.get_attr("none", optional=True) is None
    with pytest.raises(
        AttributeError, match=r"^Can not find attribute 'bbb' in Entity 'a'; did you mean 'bb'\?$"
    ):
        entity.get_attr("bbb")
    with pytest.raises(TypeError, match=r"got '<class 'int'>'; a text has quotation marks: '1'$"):
        entity.get_attr("bb")
    with pytest.raises(
        TypeError, match="'b' of Entity 'a' expected to be of type '<class 'int'>', got '<class 'str'>'"
    ):
        entity.get_attr("b", data_type=int, can_be_str=False)
    with pytest.raises(TypeError, match="Attribute 'c' of Entity 'a' expected to be a list of dictionaries"):
        entity.get_attr("c", data_type=List[Entity])


def test_yaml_elements_and_places() -> None:
    entity = yaml("- a:\n    b:\n    - x: 1\n    - x: 2\n    children:\n    - c: {}\n    - d:\n")
    assert (entity.type_name, entity.place, entity.parent.type_name) == ("a", "a.yaml:2", "launch")
    children = entity.get_attr("b", data_type=List[Entity])
    assert [(child.type_name, child.place) for child in children] == [("b", "a.yaml:4"), ("b", "a.yaml:5")]
    assert [(child.type_name, child.place) for child in entity.children] == [
        ("c", "a.yaml:7"),
        ("d", "a.yaml:8"),
    ]
    entity.assert_entity_completely_parsed()
    assert entity.children[1].get_attr("e", optional=True) is None
    entity.children[1].assert_entity_completely_parsed()
    assert YamlEntity({"a": {}}).place == ""


def test_unread_yaml_keys_are_all_named() -> None:
    entity = yaml("- node: {nam: x, colour: red, 1: x}")
    entity.get_attr("name", optional=True)
    with pytest.raises(ValueError, match="Unexpected") as raised:
        entity.assert_entity_completely_parsed()
    assert str(raised.value) == (
        "Unexpected key(s) found in `node`: {'1', 'colour', 'nam'}; did you mean 'name'? (for 'nam')"
    )
    with pytest.raises(ValueError, match="Unexpected nested entity"):
        yaml("- node: [a: 1]").assert_entity_completely_parsed()


def parsed(name: str, text: str) -> str:
    """Return the error of a launch file."""
    root, parser = Parser.load(named(text, name))
    with pytest.raises((AttributeError, RuntimeError, TypeError, ValueError)) as raised:
        parser.parse_description(root)
    return f"{type(raised.value).__name__}: {raised.value}"


@pytest.mark.parametrize(
    ("name", "text", "error"),
    [
        (
            "a.xml",
            "<launch>\n<nod/></launch>",
            "RuntimeError: a.xml:2: Unrecognized entity of the type: nod; did you mean 'node'?",
        ),
        (
            "a.xml",
            '<launch>\n<test test-name="t" pkg="p" type="t.py"/></launch>',
            (
                "RuntimeError: a.xml:2: Unrecognized entity of the type: test; that is of ROS 1: write a Python file "
                "with generate_test_description(), for launch_testing"
            ),
        ),
        (
            "a.xml",
            '<launch>\n<log\nmessage="x" colour="y"/></launch>',
            "ValueError: a.xml:2: Unexpected attribute(s) found in `log`: {'colour'}",
        ),
        (
            "a.xml",
            '<launch>\n<group>\n<log mesage="x"/></group></launch>',
            (
                "AttributeError: a.xml:3: Attribute 'message' of type '<class 'str'>' not found in Entity 'log'; "
                "did you mean 'mesage'?"
            ),
        ),
        (
            "a.xml",
            '<launch>\n\n<log message="$(vra x)"/></launch>',
            "RuntimeError: a.xml:3: Unknown substitution: vra; did you mean 'var'? (in '$(vra x)')",
        ),
        (
            "a.xml",
            '<launch>\n<log message="$(var x"/></launch>',
            (
                "SubstitutionSyntaxError: a.xml:2: the end is where an argument or ')' should be, in '$(var …': "
                "column 8 of '$(var x'"
            ),
        ),
        (
            "a.xml",
            '<launch><log message="x" if="1" unless="0"/></launch>',
            "RuntimeError: a.xml:1: if and unless conditions can't be used simultaneously",
        ),
        ("a.xml", "<lunch/>", "RuntimeError: a.xml:1: Expected 'launch' as root tag, and it is 'lunch'"),
        (
            "a.yaml",
            "launch:\n- log: {message: x}\n- nod: {}",
            "RuntimeError: a.yaml:3: Unrecognized entity of the type: nod; did you mean 'node'?",
        ),
        (
            "a.yaml",
            "launch:\n- log:\n    message: x\n    colour: y",
            "ValueError: a.yaml:2: Unexpected key(s) found in `log`: {'colour'}",
        ),
        (
            "a.yaml",
            "launch:\n- log: {message: 1}",
            (
                "TypeError: a.yaml:2: Attribute 'message' of Entity 'log' expected to be of type '<class 'str'>', "
                "got '<class 'int'>'; a text has quotation marks: '1'"
            ),
        ),
        (
            "a.yaml",
            "launch:\n- log: hello",
            "TypeError: a.yaml:2: Expected entity `log` to have attributes, got <class 'str'>: 'hello'",
        ),
        (
            "a.yaml",
            "launch:\n- log: {message: x}\n  group: []",
            (
                "TypeError: a.yaml:2: in `launch`: Subentities must be a dictionary of length one, of the tag to its "
                "attributes, and not 'log', 'group'"
            ),
        ),
        (
            "a.yaml",
            "launch:\n  log: {message: x}",
            "ValueError: a.yaml:2: Expected entity `launch` to have children entities.",
        ),
        ("a.yaml", "lunch: []", "RuntimeError: a.yaml:1: Expected 'launch' as root tag, and it is 'lunch'"),
    ],
)
def test_error_has_file_line_and_what_is_wrong(name: str, text: str, error: str) -> None:
    assert parsed(name, text) == error


@pytest.mark.parametrize(
    ("name", "text", "error"),
    [
        ("a.xml", "<launch>\n<log", "a.xml:2: it is not well-formed XML: unclosed token: line 2, column 0"),
        ("a.xml", "", "a.xml:1: it is not well-formed XML: no element found: line 1, column 0"),
        (
            "a.xml",
            "<launch>\n<a></b></launch>",
            "a.xml:2: it is not well-formed XML: mismatched tag: line 2, column 5",
        ),
        (
            "a.xml",
            '<!DOCTYPE a [\n<!ENTITY x "y">]>\n<launch/>',
            "a.xml:2: it declares the entity 'x', which launch files cannot do",
        ),
        (
            "a.xml",
            '<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n<launch a="&x;"/>',
            "a.xml:1: it declares the entity 'x', which launch files cannot do",
        ),
        (
            "a.xml",
            '<!DOCTYPE a SYSTEM "file:///etc/passwd">\n<launch>&x;</launch>',
            "a.xml:2: undefined entity '&x;'",
        ),
        ("a.xml", "<a>" * 101, "a.xml:1: it is nested deeper than 100 levels"),
        ("a.xml", '<?xml version="1.0" encoding="x"?><launch/>', "a.xml:1: unknown encoding: x"),
        ("a.yaml", "", "a.yaml:1: it is empty, and should be a dictionary with the key 'launch'"),
        ("a.yaml", "- a", "a.yaml:1: it is a list, and should be a dictionary with the key 'launch'"),
        (
            "a.yaml",
            "launch: []\nx: 1",
            "a.yaml:1: Expected only one root, 'launch', and there are 'launch', 'x'",
        ),
        ("a.yaml", "launch:\n- a: [", "a.yaml:2: it is not valid YAML: "),
        (
            "a.yaml",
            "launch:\n- a: 1\n  a: 2",
            "a.yaml:3: it is not valid YAML: the key 'a' is there twice at line 3, column 3",
        ),
        (
            "a.yaml",
            "launch: !!python/name:os.system x",
            "a.yaml:1: it is not valid YAML: could not determine a constructor",
        ),
        ("a.yaml", "launch: &a [*a]", "a.yaml:1: the alias *a contains itself"),
    ],
)
def test_file_that_cannot_be_read(name: str, text: str, error: str) -> None:
    with pytest.raises(InvalidFrontendLaunchFileError) as raised:
        Parser.load(named(text, name))
    assert str(raised.value).startswith(error)


def test_unknown_language_is_tried_in_every_way() -> None:
    root, parser = Parser.load(named("<launch/>", "a.txt"))
    assert (root.type_name, type(parser)) == ("launch", XmlParser)
    root, parser = Parser.load(named("launch: []", "a"))
    assert (root.type_name, type(parser)) == ("launch", YamlParser)
    with pytest.raises(InvalidFrontendLaunchFileError, match="syntax error, or its format is unknown"):
        Parser.load(named("launch", "a"))


def test_files_and_paths(tmp_path: Path) -> None:
    path = tmp_path / "a.launch.xml"
    path.write_bytes(
        '<?xml version="1.0" encoding="latin-1"?>\n<launch>\n<log message="ä"/></launch>'.encode("latin-1")
    )
    for file in (path, str(path)):
        root, parser = Parser.load(file)
        (entity,) = root.children
        assert entity.get_attr("message") == "ä"
        assert entity.place == f"{path}:3"  # type: ignore[attr-defined]
        assert isinstance(parser, XmlParser)
    with pytest.raises(FileNotFoundError):
        Parser.load(str(tmp_path / "b.xml"))


def test_yaml_file_with_a_version() -> None:
    root, parser = Parser.load(named("%YAML 1.2\n---\nlaunch:\n- log: {message: x}\n", "a.yaml"))
    assert [child.place for child in root.children] == ["a.yaml:4"]  # type: ignore[attr-defined]
    (action,) = parser.parse_description(root).entities
    assert isinstance(action, LogInfo)


@pytest.mark.parametrize(
    ("attribute", "kind", "described"),
    [
        ('if="$(var x)"', IfCondition, "IfCondition(LaunchConfig('x'))"),
        ('unless="true"', UnlessCondition, "UnlessCondition('true')"),
        ("if: true", IfCondition, "IfCondition('true')"),
        ("if: 1", IfCondition, "IfCondition('1')"),
        ("unless: $(var x)", UnlessCondition, "UnlessCondition(LaunchConfig('x'))"),
        ("unless: '0'", UnlessCondition, "UnlessCondition('0')"),
    ],
)
def test_condition(attribute: str, kind: type, described: str) -> None:
    entity = xml(f"<a {attribute}/>") if "=" in attribute else yaml(f"- a: {{{attribute}}}")
    condition = Parser().parse_condition(entity)
    assert type(condition) is kind
    assert condition.describe() == described
    entity.assert_entity_completely_parsed()


def test_no_condition() -> None:
    assert Parser().parse_condition(xml("<a/>")) is None
    with pytest.raises(TypeError, match="Attribute 'if'"):
        Parser().parse_condition(yaml("- a: {if: [1]}"))


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.xml", '<launch deprecated="use b"><log message="x"/></launch>'),
        ("a.yaml", "launch: {deprecated: use b, children: [{log: {message: x}}]}"),
    ],
)
def test_deprecated_file(name: str, text: str) -> None:
    root, parser = Parser.load(named(text, name))
    description = parser.parse_description(root)
    assert (description.deprecated_reason, len(description.entities)) == ("use b", 1)


def test_types_of_attributes() -> None:
    assert check_is_list_entity(List[Entity])
    assert check_is_list_entity(list[XmlEntity])
    assert not any(check_is_list_entity(kind) for kind in (List[int], list, str, None))
    assert get_data_type_from_identifier("list_of_int") == List[int]
    assert get_data_type_from_identifier("yaml") is None
    with pytest.raises(ValueError, match="Got invalid type identifier 'double'; the types are str, bool"):
        get_data_type_from_identifier("double")
