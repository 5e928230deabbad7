"""Classes from a type description that a peer has sent, for types without a definition here.

The description is hostile until its hash equals the one that discovery announced: its size, its depth and its names are
bounded first. A definition that exists here is never replaced.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol

from tfloom.rosidl import spec
from tfloom.rosidl.class_factory import LOCK, load
from tfloom.rosidl.class_table import forget
from tfloom.rosidl.parse import ParseError, parse_interface
from tfloom.rosidl.sources import Source, definition_name, find_interface, find_message, find_source, replace
from tfloom.rosidl.type_hash import (
    BOUNDED_STRINGS,
    NESTED,
    SHAPE_OFFSETS,
    TYPE_IDS,
    describe,
    description_hash,
    type_hash,
)

__all__ = [
    "ANNOUNCED",
    "ANNOUNCED_WITH_SERVICES",
    "DescriptionError",
    "check_size",
    "define_described",
    "definition_text",
    "hash_of",
]

MAX_TYPES = 500
MAX_FIELDS = 10_000
"""Of all types together."""
MAX_DEPTH = 50
"""How deep messages may be nested."""
MAX_VALUES = 1_000_000
"""How many values a new message may hold: the elements of its arrays count, those of sequences do not."""

PARTS = {
    "msg": ("",),
    "srv": ("_Request", "_Response"),
    "action": ("_Goal", "_Result", "_Feedback"),
}
"""What a definition of each kind consists of, by the suffixes of its messages."""
ANNOUNCED = {
    "msg": ("",),
    "srv": ("_Request", "_Response"),
    "action": ("_SendGoal_Request", "_GetResult_Response", "_FeedbackMessage"),
}
"""The parts of each kind whose hashes discovery announces on DDS, which together hold all of the definition."""
ANNOUNCED_WITH_SERVICES = {
    **ANNOUNCED,
    "srv": ("",),
    "action": ("_SendGoal", "_GetResult", "_FeedbackMessage"),
}
"""The same where discovery announces a service by one hash, as on Zenoh."""

_BASES = {number: base for base, number in TYPE_IDS.items() if base != "char"} | {
    number: base for base, number in BOUNDED_STRINGS.items()
}
_SHAPES = {offset // 48: shape for shape, offset in SHAPE_OFFSETS.items()}


class DescriptionError(ValueError):
    """A type description that can't be used; the text has the reason."""


class FieldType(Protocol):
    """A `type_description_interfaces/msg/FieldType`."""

    @property
    def type_id(self) -> int:
        """Number of the base type and the shape."""

    @property
    def capacity(self) -> int:
        """Length of an array, or the bound of a bounded sequence."""

    @property
    def string_capacity(self) -> int:
        """Greatest length of a string; 0 if unbounded."""

    @property
    def nested_type_name(self) -> str:
        """`package/msg/Name` of a message."""


class Field(Protocol):
    """A `type_description_interfaces/msg/Field`. Its default is ignored, because the hash doesn't cover it."""

    @property
    def name(self) -> str:
        """The field's name, as in the definition."""

    @property
    def type(self) -> FieldType:
        """The field's type, by the numbers of `type_description_interfaces`."""


class IndividualTypeDescription(Protocol):
    """A `type_description_interfaces/msg/IndividualTypeDescription`."""

    @property
    def type_name(self) -> str:
        """`package/kind/Name`."""

    @property
    def fields(self) -> Iterable[Field]:
        """The fields, in the order of the definition."""


class TypeDescription(Protocol):
    """A `type_description_interfaces/msg/TypeDescription`."""

    @property
    def type_description(self) -> IndividualTypeDescription:
        """The described type, without those of its fields."""

    @property
    def referenced_type_descriptions(self) -> Iterable[IndividualTypeDescription]:
        """All types in it."""


def define_described(name: str, description: TypeDescription, hashes: Mapping[str, str]) -> None:
    """Make and register the classes of a type, and of the types in it that have no definition here.

    Args:
        name: `package/kind/Name` of the message, service or action.
        description: What the peer has sent.
        hashes: The announced hash of each part in `ANNOUNCED`, or in `ANNOUNCED_WITH_SERVICES`, by the part's name.

    Raises:
        DescriptionError: the description is too large, incomplete or invalid, its hash is not the announced one, or it
            differs from a definition here, or refers to one that can't be used.
    """
    kind = name.split("/")[1] if name.count("/") == 2 else ""
    if kind not in ANNOUNCED:
        raise DescriptionError(f"{name!r} is not a type's name")
    forms = [{name + suffix for suffix in form[kind]} for form in (ANNOUNCED, ANNOUNCED_WITH_SERVICES)]
    if hashes.keys() not in forms:
        raise DescriptionError(f"the hashes of {name} must be those of its parts, not of {', '.join(hashes)}")
    types = _table(description)
    for part, announced in hashes.items():
        check_size(part, types)
        if hash_of(part, types) != announced:
            raise DescriptionError(f"the description of {part} does not have the announced hash {announced}")
    # All checks of the peer's words come before anything is registered. What exists here must agree, and is not
    # replaced.
    try:
        texts = _missing_definitions(name, types, hashes)
    except (
        LookupError,
        ParseError,
        OSError,
    ) as error:  # of a definition here, as in a workspace half sourced
        raise DescriptionError(str(error)) from None
    with LOCK:
        for type_name, text in texts.items():
            replace(type_name, Source(text, f"{type_name} (as described by a peer)"))
        # The hash of what was made is compared once more, because a definition's text can't say everything that a
        # description can. After a failure no definition of the peer stays.
        try:
            load(name)
            _check_hashes(find_interface(name), hashes)
        except BaseException as error:
            for type_name in texts:
                replace(type_name, None)
                forget(type_name)
            if isinstance(error, (LookupError, ParseError, OSError)):
                raise DescriptionError(str(error)) from None
            raise


def _check_hashes(interface: spec.Interface, hashes: Mapping[str, str]) -> None:
    """Check the hashes of a definition's parts.

    Raises:
        DescriptionError: one isn't the announced one.
    """
    parts = {part.name: part for part in _parts(interface)}
    for part, announced in hashes.items():
        if type_hash(parts[part], find_message) != announced:
            raise DescriptionError(f"{part} can't be written as a definition of the same hash")


def _parts(interface: spec.Interface) -> tuple[spec.Interface, ...]:
    """Return an interface, its services and its messages."""
    services = (interface.send_goal, interface.get_result) if isinstance(interface, spec.Action) else ()
    return (interface, *services, *spec.messages_of(interface))


def _table(description: TypeDescription) -> dict[str, dict[str, spec.Type]]:
    """Return the types of the fields of each type, by the names of both.

    Raises:
        DescriptionError: there are too many, or a name is there twice.
    """
    individuals = [description.type_description, *description.referenced_type_descriptions]
    if len(individuals) > MAX_TYPES:
        raise DescriptionError(f"a description of {len(individuals)} types, more than {MAX_TYPES}")
    types: dict[str, dict[str, spec.Type]] = {}
    count = 0
    for individual in individuals:
        fields = {field.name: _type(individual.type_name, field) for field in individual.fields}
        count += len(fields)
        if individual.type_name in types:
            raise DescriptionError(f"{individual.type_name} is described twice")
        if count > MAX_FIELDS:
            raise DescriptionError(f"a description of more than {MAX_FIELDS} fields")
        types[individual.type_name] = fields
    return types


def _type(owner: str, field: Field) -> spec.Type:
    type_ = field.type
    shape = _SHAPES.get((type_.type_id - 1) // 48)
    number = (type_.type_id - 1) % 48 + 1
    base = type_.nested_type_name if number == NESTED else _BASES.get(number)
    if shape is None or base is None:
        raise DescriptionError(
            f"{owner}.{field.name} has the type {type_.type_id}, which no .msg file can have"
        )
    return spec.Type(base, type_.string_capacity, shape, type_.capacity)


def check_size(name: str, types: Mapping[str, Mapping[str, spec.Type]]) -> None:
    """Check that a type is described, does not contain itself, and that a new message of it is of bounded size.

    Raises:
        DescriptionError: it isn't so.
    """
    values: dict[str, int] = {}

    def visit(name: str, depth: int) -> int:
        if depth > MAX_DEPTH:
            raise DescriptionError(
                f"messages are nested in {name} more than {MAX_DEPTH} deep, or in themselves"
            )
        if name not in types:
            raise DescriptionError(f"the description of {name} is missing")
        if name not in values:
            total = 0
            for type_ in types[name].values():
                value_count = 1 if type_.is_primitive else visit(type_.base, depth + 1)
                total += {"": value_count, "array": value_count * type_.length}.get(type_.shape, 0)
            if total > MAX_VALUES:
                raise DescriptionError(f"a new {name} would hold more than {MAX_VALUES} values")
            values[name] = total
        return values[name]

    visit(name, 1)


def hash_of(name: str, types: Mapping[str, Mapping[str, spec.Type]]) -> str:
    """Return the hash of a described type."""
    return description_hash(
        {
            "type_description": _described(name, types),
            "referenced_type_descriptions": [
                _described(reference, types) for reference in sorted(_reachable([name], types) - {name})
            ],
        }
    )


def _reachable(names: Iterable[str], types: Mapping[str, Mapping[str, spec.Type]]) -> set[str]:
    """Return the names and those of all messages in them."""
    reachable_names: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in reachable_names:
            reachable_names.add(name)
            waiting += [type_.base for type_ in types[name].values() if not type_.is_primitive]
    return reachable_names


def _described(name: str, types: Mapping[str, Mapping[str, spec.Type]]) -> dict[str, Any]:
    return describe(name, (spec.Field(field, type_) for field, type_ in types[name].items()))


def _missing_definitions(
    name: str, types: Mapping[str, Mapping[str, spec.Type]], hashes: Mapping[str, str]
) -> dict[str, str]:
    """Return the texts of the definitions that are needed and that don't exist here, by their names.

    Raises:
        DescriptionError: one is invalid, or differs from the definition here.
        LookupError: a definition here refers to one that isn't.
        ParseError: a definition here can't be parsed.
        OSError: a definition here can't be read.
    """
    texts: dict[str, str] = {}
    for type_name in {name, *map(definition_name, _reachable(hashes, types))}:
        if find_source(type_name) is None:
            texts[type_name] = definition_text(type_name, types)
        elif type_name in types and type_hash(find_message(type_name), find_message) != hash_of(
            type_name, types
        ):
            raise DescriptionError(f"{type_name} differs from the definition here")
    return texts


def definition_text(name: str, types: Mapping[str, Mapping[str, spec.Type]]) -> str:
    """Return the text of a described definition.

    Raises:
        DescriptionError: the name is not a type's, a part is missing, or the text isn't a valid definition.
    """
    if name.count("/") != 2:
        raise DescriptionError(f"{name!r} is not a type's name")
    parts = [name + suffix for suffix in PARTS.get(name.split("/")[1], ())]
    if missing := [part for part in parts if part not in types]:
        raise DescriptionError(f"the description of {missing[0]} is missing")
    lines = [
        "\n".join(f"{type_} {field}" for field, type_ in types[part].items() if field != spec.EMPTY_FIELD)
        for part in parts
    ]
    text = "\n---\n".join(lines)
    try:
        parse_interface(text, name)
    except ValueError as error:
        raise DescriptionError(f"the description is not a definition: {error}") from None
    return text
