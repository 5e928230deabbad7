"""The generator of message classes: names, comments and constants that are not plain."""

from __future__ import annotations

from typing import Any

from tfloom.rosidl import cdr, generate, sources, spec
from tfloom.rosidl.parse import parse_interface


def test_class_with_the_name_of_a_referenced_one() -> None:
    theirs = spec.Message("other_msgs/msg/Shape", ())
    ours = parse_interface("other_msgs/Shape shape\nShape[2] pair", "my_msgs/msg/Holder")
    own = spec.Message("my_msgs/msg/Shape", (spec.Field("x", spec.Type("float64")),))
    specs = {
        interface.name: interface for interface in (theirs, ours, own) if isinstance(interface, spec.Message)
    }
    source = generate.generate([ours, own], specs.__getitem__)
    assert "from other_msgs.msg import Shape as other_msgs_Shape" in source
    assert "shape: other_msgs_Shape" in source
    assert "pair: list[Shape]" in source
    compile(source, "my_msgs", "exec")


def test_service_with_the_name_of_a_referenced_message() -> None:
    message = spec.Message("my_msgs/msg/Shape", ())
    service = parse_interface("Shape shape\n---\n", "my_msgs/srv/Shape")
    known = {part.name: part for part in (message, *spec.messages_of(service))}
    source = generate.generate([service], lambda name: known.get(name) or sources.find_message(name))
    assert "from my_msgs.msg import Shape as my_msgs_Shape" in source
    assert "shape: my_msgs_Shape" in source


def test_text_in_comments_and_constants_is_escaped() -> None:
    text = '# Says """hello""" and \\\nstring A=\'it\\\'s "x" \\\\\'\nfloat64 x 1.5 # ends with "\nbyte B=7'
    message = parse_interface(text, "my_msgs/msg/Quotes")
    assert isinstance(message, spec.Message)
    namespace: dict[str, Any] = {}
    exec(generate.generate([message], {message.name: message}.__getitem__), namespace)
    quotes = namespace["Quotes"]
    assert (quotes.A, quotes.B, quotes().x) == ('it\'s "x" \\', b"\x07", 1.5)


def test_fields_with_reserved_names() -> None:
    message = parse_interface("int32 from\nint32 self\nint32 class 5\nint32[] lambda", "my_msgs/msg/Keywords")
    assert isinstance(message, spec.Message)
    namespace: dict[str, Any] = {}
    exec(generate.generate([message], {message.name: message}.__getitem__), namespace)
    keywords = namespace["Keywords"](**{"from": 1, "self": 2})
    assert [getattr(keywords, name) for name in ("from", "self", "class")] == [1, 2, 5]
    assert cdr.decode(type(keywords), cdr.encode(keywords)) == keywords
