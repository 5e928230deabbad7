"""Classes from a peer's type description."""

from __future__ import annotations

import json
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.rosidl.workspaces import write_files

from tfloom.rosidl import cdr, registry, sources, spec
from tfloom.rosidl.class_factory import load
from tfloom.rosidl.definition_files import KINDS, interface_names
from tfloom.rosidl.described import (
    ANNOUNCED,
    ANNOUNCED_WITH_SERVICES,
    MAX_DEPTH,
    MAX_FIELDS,
    MAX_TYPES,
    DescriptionError,
    _parts,
    define_described,
)
from tfloom.rosidl.type_hash import description_hash, type_description

FLOAT64, POINTS_OF_10 = 11, 1 + 48
HASH = "RIHS01_" + 64 * "0"
OF_ALL = ("unique_identifier_msgs/", "builtin_interfaces/", "service_msgs/")
"""The packages of what services and actions contain by themselves."""


def sent(description: dict[str, Any]) -> Any:
    """Return a description as the objects of a message."""
    return json.loads(json.dumps(description), object_hook=lambda fields: SimpleNamespace(**fields))


def peers_name(name: str) -> str:
    """Return a type's name with another package, which has no definition here, except for `OF_ALL`."""
    return name if name.startswith(OF_ALL) else f"peer_{name}"


def of_a_peer(description: dict[str, Any]) -> dict[str, Any]:
    """Return the description with packages renamed."""
    renamed: dict[str, Any] = json.loads(
        re.sub(r'"(\w+/\w+/\w+)"', lambda match: f'"{peers_name(match[1])}"', json.dumps(description))
    )
    renamed["referenced_type_descriptions"].sort(key=lambda description: description["type_name"])
    return renamed


def individual(name: str, **fields: tuple[int, int, str]) -> dict[str, Any]:
    """Return the description of one type; a field is its type's id, its capacity and the name of its message."""
    return {
        "type_name": name,
        "fields": [
            {
                "name": field,
                "type": {
                    "type_id": number,
                    "capacity": capacity,
                    "string_capacity": 0,
                    "nested_type_name": nested,
                },
            }
            for field, (number, capacity, nested) in fields.items()
        ],
    }


def described(own: dict[str, Any], *referenced: dict[str, Any]) -> tuple[Any, dict[str, str]]:
    """Return a description as a message, and the hash of it by its name."""
    whole = {
        "type_description": own,
        "referenced_type_descriptions": sorted(referenced, key=lambda description: description["type_name"]),
    }
    return sent(whole), {own["type_name"]: description_hash(whole)}


@pytest.mark.parametrize(
    ("kind", "form", "step"),
    [
        *((kind, ANNOUNCED, 1) for kind in KINDS),
        *((kind, ANNOUNCED_WITH_SERVICES, 10) for kind in ("srv", "action")),
    ],
)
def test_every_type_can_be_made_from_its_description_alone(
    kind: str, form: dict[str, tuple[str, ...]], step: int
) -> None:
    for name in [name for name in interface_names(kind) if peers_name(name) != name][::step]:
        here = registry.find_class(name)
        interface = sources.find_interface(name)
        parts = {part.name: part for part in _parts(interface)}
        description = of_a_peer(type_description(interface, sources.find_message))
        hashes = {
            f"peer_{name}{suffix}": description_hash(
                of_a_peer(type_description(parts[name + suffix], sources.find_message))
            )
            for suffix in form[kind]
        }
        define_described(f"peer_{name}", sent(description), hashes)
        made = registry.find_class(f"peer_{name}")
        pairs = {
            "msg": [(here, made)],
            "srv": [
                (getattr(here, part, None), getattr(made, part, None)) for part in ("Request", "Response")
            ],
            "action": [
                (getattr(here, part, None), getattr(made, part, None))
                for part in ("Goal", "Result", "Feedback")
            ],
        }
        for known, learnt in pairs[kind]:
            assert learnt.get_fields_and_field_types() == {
                field: re.sub(r"\w+/\w+", lambda match: peers_name(match[0]), text)
                for field, text in known.get_fields_and_field_types().items()
            }
            data = cdr.encode(learnt())
            assert cdr.encode(cdr.decode(learnt, data)) == data


def test_definitions_that_exist_here_are_used_and_not_replaced() -> None:
    header = registry.get_message_class("std_msgs/msg/Header")
    whole = type_description(sources.find_interface("std_msgs/msg/Header"), sources.find_message)
    description, hashes = described(
        individual("my_msgs/msg/Stamped", header=(1, 0, "std_msgs/msg/Header")),
        whole["type_description"],
        *whole["referenced_type_descriptions"],
    )
    define_described("my_msgs/msg/Stamped", description, hashes)
    stamped = registry.get_message_class("my_msgs/msg/Stamped")
    assert type(stamped().header) is header  # type: ignore[attr-defined]
    assert registry.get_message_class("std_msgs/msg/Header") is header


def test_a_definition_that_differs_from_the_one_here_is_an_error() -> None:
    description, hashes = described(
        individual("my_msgs/msg/Stamped", header=(1, 0, "std_msgs/msg/Header")),
        individual("std_msgs/msg/Header", x=(FLOAT64, 0, "")),
    )
    with pytest.raises(DescriptionError, match="std_msgs/msg/Header differs from the definition here"):
        define_described("my_msgs/msg/Stamped", description, hashes)
    with pytest.raises(LookupError):
        registry.find_class("my_msgs/msg/Stamped")


@pytest.mark.parametrize("local", [b"gone_msgs/Gone x\n", b"# \xff\n", b"int33 x\n"])
def test_a_definition_here_that_can_not_be_used_is_an_error(
    local: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_files(tmp_path / "share" / "part_msgs" / "msg", {"Part.msg": local})
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    description, hashes = described(
        individual("my_msgs/msg/Whole", part=(1, 0, "part_msgs/msg/Part")),
        individual("part_msgs/msg/Part", x=(FLOAT64, 0, "")),
    )
    with pytest.raises(DescriptionError, match=r"gone_msgs/msg/Gone|Part\.msg"):
        define_described("my_msgs/msg/Whole", description, hashes)
    assert sources.find_source("my_msgs/msg/Whole") is None


@pytest.mark.parametrize("name", ["foo", "a/b", "a/b/c", "a/msg", "a/msg/B/c"])
def test_a_name_that_is_not_a_types_is_an_error(name: str) -> None:
    description, hashes = described(individual(name, x=(FLOAT64, 0, "")))
    with pytest.raises(DescriptionError, match=f"'{name}' is not a type's name"):
        define_described(name, description, hashes)


def test_a_description_without_the_announced_hash_is_an_error_and_leaves_nothing() -> None:
    description, _ = described(individual("my_msgs/msg/Number", x=(FLOAT64, 0, "")))
    with pytest.raises(DescriptionError, match=f"does not have the announced hash {HASH}"):
        define_described("my_msgs/msg/Number", description, {"my_msgs/msg/Number": HASH})
    assert sources.find_source("my_msgs/msg/Number") is None


def test_hashes_that_do_not_cover_a_type_are_an_error() -> None:
    description, hashes = described(individual("my_msgs/srv/Set_Request", x=(FLOAT64, 0, "")))
    with pytest.raises(DescriptionError, match="the hashes of my_msgs/srv/Set must be those of its parts"):
        define_described("my_msgs/srv/Set", description, hashes)


@pytest.mark.parametrize(
    ("types", "reason"),
    [
        (
            [individual("my_msgs/msg/A", a=(1, 0, "my_msgs/msg/A"))],
            f"more than {MAX_DEPTH} deep, or in themselves",
        ),
        (
            [
                individual(f"my_msgs/msg/A{i}", a=(1 + 144, 0, f"my_msgs/msg/A{i + 1}"))
                for i in range(MAX_DEPTH + 1)
            ],
            f"more than {MAX_DEPTH} deep",
        ),
        (
            [
                *(
                    individual(f"my_msgs/msg/A{i}", a=(POINTS_OF_10, 10, f"my_msgs/msg/A{i + 1}"))
                    for i in range(7)
                ),
                individual("my_msgs/msg/A7", x=(FLOAT64, 0, "")),
            ],
            "would hold more than 1000000 values",
        ),
        ([individual("my_msgs/msg/A", a=(FLOAT64 + 48, 2**40, ""))], "would hold more than 1000000 values"),
        (
            [individual("my_msgs/msg/A", a=(1, 0, "my_msgs/msg/B"))],
            "the description of my_msgs/msg/B is missing",
        ),
        (
            [individual("my_msgs/msg/A", a=(12, 0, ""))],
            r"my_msgs/msg/A\.a has the type 12, which no \.msg file",
        ),
        (
            [individual("my_msgs/msg/A", a=(0, 0, ""))],
            r"my_msgs/msg/A\.a has the type 0, which no \.msg file",
        ),
        (
            [individual("my_msgs/msg/A", a=(255, 0, ""))],
            r"my_msgs/msg/A\.a has the type 255, which no \.msg file",
        ),
        (
            [individual("my_msgs/msg/A", **{"a\nfloat64 b": (FLOAT64, 0, "")})],
            "can't be written as a definition",
        ),
        ([individual("my_msgs/msg/A", **{"a=1": (FLOAT64, 0, "")})], "is not a definition"),
        ([individual("my_msgs/msg/A", Upper=(FLOAT64, 0, ""))], "is not a definition"),
        ([individual("my_msgs/msg/A"), individual("my_msgs/msg/A")], "my_msgs/msg/A is described twice"),
        (
            [individual("my_msgs/msg/A", a=(1, 0, "")), individual("", x=(FLOAT64, 0, ""))],
            "is not a type's name|is not a definition",  # whichever of the two is looked at first
        ),
        ([individual(f"my_msgs/msg/A{i}") for i in range(MAX_TYPES + 1)], f"more than {MAX_TYPES}"),
        (
            [individual("my_msgs/msg/A", **{f"a{i}": (FLOAT64, 0, "") for i in range(MAX_FIELDS + 1)})],
            f"more than {MAX_FIELDS} fields",
        ),
    ],
    ids=lambda value: value if isinstance(value, str) else "types",
)
def test_a_hostile_description_is_an_error(types: list[dict[str, Any]], reason: str) -> None:
    description, hashes = described(*types)
    with pytest.raises(DescriptionError, match=reason):
        define_described(types[0]["type_name"], description, hashes)
    assert sources.find_source(types[0]["type_name"]) is None


def test_messages_that_share_parts_at_each_level_are_checked_in_linear_time() -> None:
    levels = MAX_DEPTH - 1
    sequence = 1 + 144
    types = [
        individual(
            f"my_msgs/msg/A{i}",
            a=(sequence, 0, f"my_msgs/msg/A{i + 1}"),
            b=(sequence, 0, f"my_msgs/msg/A{i + 1}"),
        )
        for i in range(levels)
    ]
    description, hashes = described(*types, individual(f"my_msgs/msg/A{levels}", x=(FLOAT64, 0, "")))
    define_described("my_msgs/msg/A0", description, hashes)
    assert cdr.encode(registry.find_class("my_msgs/msg/A0")())


def test_the_text_of_a_learnt_definition_is_shown_as_a_definition() -> None:
    description, hashes = described(individual("my_msgs/msg/Number", x=(FLOAT64 + 96, 3, ""), n=(9, 0, "")))
    define_described("my_msgs/msg/Number", description, hashes)
    source = sources.find_source("my_msgs/msg/Number")
    assert source is not None
    assert source.text == "float64[<=3] x\nuint64 n"
    assert isinstance(sources.find_interface("my_msgs/msg/Number"), spec.Message)
    assert hashes["my_msgs/msg/Number"] == load("my_msgs/msg/Number")._TYPE_HASH
