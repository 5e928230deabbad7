"""Values of fields as they are written on the command line, and as `topic echo` prints them."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.cli.shared.interfaces import fill_message, parse_yaml
from tfloom.common.yaml import load
from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue
from tfloom.interfaces.std_msgs.msg import Bool, Byte, ByteMultiArray, Float64, Int64, String
from tfloom.interfaces.turtlesim.srv import SetPen
from tfloom.rosidl.fill import set_message_fields
from tfloom.rosidl.yaml_text import message_to_yaml


def filled(message: Any, text: str) -> Any:
    fill_message(message, parse_yaml(text))
    return message


@pytest.mark.parametrize(
    "text",
    [
        "off",
        "on",
        "yes",
        "true",
        "5",
        "007",
        "1.10",
        "1e3",
        "1:30",
        "2024-01-01",
        "null",
        "~",
        "",
        "0x10",
        ".inf",
        "1_0",
    ],
)
def test_a_text_is_as_written(text: str) -> None:
    assert filled(String(), f"data: {text}") == String(data=text)
    assert filled(String(), f"{{data: {text}}}") == String(data=text)
    status = filled(DiagnosticArray(), f"status: [{{name: {text}, values: [{{key: {text}, value: x}}]}}]")
    assert status.status == [DiagnosticStatus(name=text, values=[KeyValue(key=text, value="x")])]
    assert filled(ParameterValue(), f"string_array_value: [{text or repr('')}, x]").string_array_value == [
        text,
        "x",
    ]


def test_a_bare_name_is_the_field() -> None:
    assert filled(SetPen.Request(), "{r: 255, off: 1}") == SetPen.Request(r=255, off=1)


def test_other_fields_have_yamls_values() -> None:
    assert filled(Bool(), "data: on") == Bool(data=True)
    assert filled(Int64(), "data: 0x10") == Int64(data=16)
    assert filled(Float64(), "data: 1e3") == Float64(data=1000.0)
    assert filled(Byte(), "data: 7") == Byte(data=b"\x07")
    assert filled(ByteMultiArray(), "data: [1, 0xff]") == ByteMultiArray(data=[b"\x01", b"\xff"])
    assert filled(String(), "{}") == filled(String(), "null") == filled(String(), "") == String()


BYTES = [bytes([number]) for number in range(256)]


@pytest.mark.parametrize(
    "message",
    [
        *[Byte(data=byte) for byte in BYTES],
        ByteMultiArray(data=BYTES),
        DiagnosticStatus(level=b"\x02", name="7", values=[KeyValue(key="y", value="1e3")]),
        ParameterValue(type=5, byte_array_value=BYTES),
        *[String(data=f"a{character}b ") for character in "\x85\u2028\u2029\r\n\t\x07\xa0\u00e4"],
        *[
            String(data=text)
            for text in ["off", "~", "", " ", "007", "2024-01-01", "a: b", "- a", "'", "\x85"]
        ],
    ],
    ids=repr,
)
def test_what_is_printed_can_be_published(message: Any) -> None:
    text = message_to_yaml(message)
    assert filled(type(message)(), text) == message
    again = type(message)()
    set_message_fields(again, load(text))
    assert again == message
