"""Random definitions and values, compared with rosbags byte for byte."""

from __future__ import annotations

import array
from typing import Any

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

from tfloom.rosidl import cdr, registry
from tfloom.rosidl.dynamic import define
from tfloom.rosidl.message import Message
from tfloom.rosidl.spec import INTEGER_RANGES
from tfloom.rosidl.type_text import split_type

INNER = "random_msgs/msg/Inner"
OUTER = "random_msgs/msg/Outer"
LETTERS = st.characters(blacklist_categories=["Cs"], blacklist_characters="\0")


def primitives(*, wide: bool) -> st.SearchStrategy[str]:
    strings = ["string", "string<=7", *(["wstring", "wstring<=5"] if wide else [])]
    return st.sampled_from([*INTEGER_RANGES, "float32", "float64", "bool", *strings])


@st.composite
def definitions(draw: st.DrawFn, bases: st.SearchStrategy[str]) -> str:
    shapes = st.sampled_from(["", "", "[3]", "[1]", "[<=4]", "[]"])
    count = draw(st.integers(1, 8))
    return "".join(f"{draw(bases)}{draw(shapes)} f{i}\n" for i in range(count))


def elements(base: str, bound: int) -> st.SearchStrategy[Any]:
    if base in {"string", "wstring"}:
        return st.text(LETTERS, max_size=bound or 9)
    if base == "bool":
        return st.booleans()
    if base in {"float32", "float64"}:
        return st.floats(width=32 if base == "float32" else 64, allow_nan=False)
    if base == "byte":
        return st.binary(min_size=1, max_size=1)
    if base in INTEGER_RANGES:
        return st.integers(*INTEGER_RANGES[base])
    return messages(registry.get_message_class(base))


@st.composite
def messages(draw: st.DrawFn, cls: type[Message]) -> Message:
    values = {}
    for name, text in cls._FIELDS.items():
        base, bound, shape, length = split_type(text)
        values[name] = draw(elements(base, bound))
        if shape:
            limits = {"array": (length, length), "bounded": (0, length), "unbounded": (0, 6)}[shape]
            values[name] = draw(st.lists(elements(base, bound), min_size=limits[0], max_size=limits[1]))
    return cls(**values)


def plain(value: Any) -> Any:
    """Return a value in a form that both sides can be compared in."""
    if isinstance(value, (np.ndarray, array.array)):
        return value.tolist()
    if isinstance(value, bytes):
        return int.from_bytes(value, "little", signed=True)  # rosbags takes a byte for an int8
    if isinstance(value, list):
        return [plain(item) for item in value]
    fields = getattr(value, "_FIELDS", None) or getattr(value, "__dataclass_fields__", None)
    return [plain(getattr(value, name)) for name in fields if not name.startswith("__")] if fields else value


def store_of(*texts: tuple[str, str]) -> Typestore:
    store = get_typestore(Stores.EMPTY)
    for name, text in texts:
        store.register(get_types_from_msg(text, name))
    return store


@settings(deadline=None, max_examples=50, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_bytes_equal_those_of_rosbags(data: st.DataObject) -> None:
    inner_text = data.draw(definitions(primitives(wide=False)))
    outer_text = data.draw(definitions(primitives(wide=False) | st.just("Inner")))
    define(INNER, inner_text)
    outer = define(OUTER, outer_text)
    message = data.draw(messages(outer))
    encoded = cdr.encode(message)
    store = store_of((INNER, inner_text), (OUTER, outer_text))
    theirs = store.deserialize_cdr(encoded, OUTER)
    assert plain(theirs) == plain(message)
    assert bytes(store.serialize_cdr(theirs, OUTER)) == encoded
    assert cdr.decode(outer, store.serialize_cdr(theirs, OUTER, little_endian=False)) == message
    if "char" not in inner_text + outer_text:  # rosbags hashes it as IDL's char, which in ROS is a uint8
        assert store.hash_rihs01(OUTER) == outer._TYPE_HASH


@settings(deadline=None, max_examples=50, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_decode_undoes_encode_for_any_type(data: st.DataObject) -> None:
    define(INNER, data.draw(definitions(primitives(wide=True))))
    outer = define(OUTER, data.draw(definitions(primitives(wide=True) | st.just("Inner"))))
    message = data.draw(messages(outer))
    decoded = cdr.decode(outer, cdr.encode(message))
    assert decoded == message
    assert repr(decoded) == repr(message)
    assert cdr.encode(decoded) == cdr.encode(message)
