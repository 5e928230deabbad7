"""Print as JSON what `rosidl_parser` finds in .idl files; tfloom and the reference run it unchanged."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from rosidl_parser.definition import IdlLocator, Include, Message, Service
from rosidl_parser.parser import parse_idl_file


def of_type(type_: Any) -> list[Any]:
    names = ("typename", "namespaces", "name", "maximum_size", "size")
    known = {name: getattr(type_, name) for name in names if hasattr(type_, name)}
    inner = [of_type(type_.value_type)] if hasattr(type_, "value_type") else []
    return [type(type_).__name__, known, *inner]


def annotations(element: Any) -> list[Any]:
    return [[annotation.name, annotation.value] for annotation in element.annotations]


def of_message(message: Any) -> dict[str, Any]:
    structure = message.structure
    return {
        "type": of_type(structure.namespaced_type),
        "annotations": annotations(structure),
        "comments": structure.get_comment_lines(),
        "members": [[member.name, of_type(member.type), annotations(member)] for member in structure.members],
        "constants": [
            [constant.name, of_type(constant.type), constant.value, annotations(constant)]
            for constant in message.constants
        ],
    }


def of_service(service: Any) -> list[Any]:
    messages = (service.request_message, service.response_message, service.event_message)
    return [of_type(service.namespaced_type), *map(of_message, messages)]


def of_element(element: Any) -> Any:
    if isinstance(element, Include):
        return ["include", element.locator]
    if isinstance(element, Message):
        return of_message(element)
    if isinstance(element, Service):
        return of_service(element)
    return [
        of_type(element.namespaced_type),
        *map(of_message, (element.goal, element.result, element.feedback, element.feedback_message)),
        *map(of_service, (element.send_goal_service, element.get_result_service)),
        [include.locator for include in element.implicit_includes],
    ]


def contents(path: Path) -> list[Any]:
    """Return the elements of a file as JSON values."""
    file = parse_idl_file(IdlLocator(path.parent, path.name))
    assert file.locator.get_absolute_path() == path
    return [of_element(element) for element in file.content.elements]


def main() -> None:
    print(json.dumps({path: contents(Path(path)) for path in sys.argv[1:]}))


if __name__ == "__main__":
    main()
