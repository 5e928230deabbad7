"""The checked-in files equal the generator's output."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

from tests.each import for_each

import tfloom.rosidl
from tfloom.rosidl import cdr, generate, sources, spec
from tfloom.rosidl.parse import parse_interface

HOME = Path(tfloom.rosidl.__file__).parents[1]
files = functools.cache(generate.generate_all)


@for_each(files)
def test_regenerated_files_are_identical(path: str) -> None:
    assert (HOME / path).read_text("utf-8") == files()[path], "run python -m tfloom.rosidl.generate"


def test_no_file_of_a_removed_definition_remains() -> None:
    on_disk = {path.relative_to(HOME).as_posix() for path in HOME.glob("interfaces/*/*.py")}
    assert on_disk == {path for path in files() if path.startswith("interfaces/")}
    kinds = {path.rpartition("/")[0] for path in files() if path.startswith("ros_names/")}
    modules = {path.relative_to(HOME).as_posix() for kind in kinds for path in (HOME / kind).glob("*.py*")}
    assert modules == {path for path in files() if path.endswith(".py") and path.startswith("ros_names/")}


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
