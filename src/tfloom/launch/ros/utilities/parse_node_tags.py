"""The tags `param` and `remap` in a node's element of a launch file."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, List  # the type that `Entity.get_attr` takes for children

from tfloom.common.text import QuotedText
from tfloom.launch.core.entity import Entity, Pair, ParsesActions, parse_pairs
from tfloom.launch.frontend.type_utils import get_data_type_from_identifier
from tfloom.launch.ros.parameter_descriptions import ParameterFile, ParameterValue
from tfloom.launch.ros.utilities.parameter_text import untyped_items, untyped_value

__all__ = ["parse_nested_parameters", "parse_parameters", "parse_remappings"]

_Elements = List[Entity]


def parse_remappings(entity: Entity, parser: ParsesActions) -> list[Pair] | None:
    """Return the pairs of the tags `remap` in an element; None if there are none."""
    elements = entity.get_attr("remap", data_type=_Elements, optional=True)
    return None if elements is None else parse_pairs(elements, parser, "from", "to")


def parse_parameters(entity: Entity, parser: ParsesActions, tag: str = "param") -> list[Any] | None:
    """Return the files and mappings of the tags `param` in an element; None if there are none."""
    elements = entity.get_attr(tag, data_type=_Elements, optional=True)
    return None if elements is None else parse_nested_parameters(elements, parser)


def parse_nested_parameters(params: list[Entity], parser: ParsesActions) -> list[Any]:
    """Return a ParameterFile or a mapping of each tag `param`.

    Raises:
        RuntimeError: a tag has attributes that exclude each other, or lacks a value.
        ValueError: a tag has neither a name nor a file.
    """
    parameters: list[Any] = []
    for param in params:
        path = param.get_attr("from", optional=True)
        name = param.get_attr("name", optional=True)
        if path is not None and name is not None:
            raise RuntimeError("name and from attributes are mutually exclusive")
        if path is not None:
            parameters.append(_parse_file(path, param, parser))
        elif name is not None:
            parameters.append(_parse_values([param], parser))
        else:
            raise ValueError("param Entity should have name or from attribute")
    return parameters


def _parse_file(path: str, element: Entity, parser: ParsesActions) -> ParameterFile:
    allow_substs = element.get_attr("allow_substs", data_type=bool, optional=True)
    element.assert_entity_completely_parsed()
    if allow_substs is None:
        return ParameterFile(parser.parse_substitution(path))
    return ParameterFile(
        parser.parse_substitution(path), allow_substs=parser.parse_if_substitutions(allow_substs)
    )


def _parse_values(elements: list[Entity], parser: ParsesActions) -> dict[Any, Any]:
    values: dict[Any, Any] = {}
    for element in elements:
        name = tuple(parser.parse_substitution(element.get_attr("name")))
        identifier = element.get_attr("type", optional=True)
        data_type = None if identifier is None else get_data_type_from_identifier(identifier)
        value = _value(element, data_type)
        nested = element.get_attr("param", data_type=_Elements, optional=True)
        if value is not None and nested:
            raise RuntimeError("param and value attributes are mutually exclusive")
        if data_type is not None and nested:
            raise RuntimeError("nested parameters and type attributes are mutually exclusive")
        if value is not None:
            given = _untyped(value) if data_type is None else value
            values[name] = ParameterValue(parser.parse_if_substitutions(given), value_type=data_type)
        elif nested:
            values[name] = _parse_values(nested, parser)
        else:
            raise RuntimeError("either a value attribute or nested params are needed")
        element.assert_entity_completely_parsed()
    return values


def _value(element: Entity, data_type: Any) -> Any:
    """Return the attribute `value`; without a type, its text, or the texts that `value-sep` separates."""
    for kind in (str, List[str]) if data_type is None else ():
        with suppress(TypeError):  # it is of YAML, and a number or a list of them
            return element.get_attr("value", data_type=kind, optional=True)
    return element.get_attr("value", data_type=data_type, optional=True)


def _untyped(value: Any) -> Any:
    """Return a value with its texts read by rcl's rules; those in quotes in YAML are texts by their type.

    Of a text with substitutions, the performed text tells the type.
    """
    if isinstance(value, list):
        plain = [item for item in value if _is_plain(item)]
        read = iter(_read_each(plain))
        items = [next(read) if _is_plain(item) else _without_mark(item) for item in value]
        return [float(item) for item in items] if {type(item) for item in items} == {int, float} else items
    return _read_each([value])[0] if _is_plain(value) else _without_mark(value)


def _is_plain(value: Any) -> bool:
    return isinstance(value, str) and not isinstance(value, QuotedText)


def _without_mark(value: Any) -> Any:
    return str(value) if isinstance(value, QuotedText) else value


def _read_each(texts: list[str]) -> list[Any]:
    """Return the values of texts; one that is not YAML, or a mapping, stays as it is."""
    try:
        values = [untyped_value(texts[0])] if len(texts) == 1 else untyped_items(texts)
    except ValueError:
        return list(texts)
    return [text if isinstance(value, dict) else value for text, value in zip(texts, values, strict=True)]
