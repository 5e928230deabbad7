"""The codec beyond the goldens: errors, their texts, and hostile bytes."""

from __future__ import annotations

import json
import os
import random
from array import array
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.each import for_each

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.example_interfaces.msg import WString
from tfloom.interfaces.geometry_msgs.msg import PoseWithCovariance, TransformStamped, Twist, Vector3
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue
from tfloom.interfaces.sensor_msgs.msg import Image, JointState, PointCloud2, PointField
from tfloom.interfaces.shape_msgs.msg import SolidPrimitive
from tfloom.interfaces.std_msgs.msg import Bool, Byte, ColorRGBA, Empty, Header, Int8, String, UInt64
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.type_description_interfaces.msg import FieldType, TypeSource
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_message_class
from tfloom.tf2.buffer import Buffer

LE = bytes.fromhex("00010000")
BE = bytes.fromhex("00000000")


class Number:
    """An object with the methods of a number."""

    def __index__(self) -> int:
        return 7

    def __float__(self) -> float:
        return 7.5


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (Vector3(x="abc"), "Vector3.x must be a float, got 'abc' (str)"),
        (Vector3(x=None), "Vector3.x must be a float, got None (NoneType)"),
        (Twist(linear=3), "Twist.linear must be a geometry_msgs/msg/Vector3, got 3 (int)"),
        (Int8(data=300), "Int8.data must be an int in [-128, 127], got 300 (int)"),
        (Int8(data=1.5), "Int8.data must be an int, got 1.5 (float)"),
        (UInt64(data=-1), "UInt64.data must be an int in [0, 18446744073709551615], got -1 (int)"),
        (
            UInt64(data=2**64),
            "UInt64.data must be an int in [0, 18446744073709551615], got 18446744073709551616 (int)",
        ),
        (Bool(data=1), "Bool.data must be a bool, got 1 (int)"),
        (Byte(data=3), "Byte.data must be bytes of length 1, got 3 (int)"),
        (
            Byte(data=bytearray(b"ab")),
            "Byte.data must be bytes of length 1, got bytearray(b'ab') (bytearray)",
        ),
        (Int8(data=np.array([1])), "Int8.data must be an int, got array([1]) (numpy.ndarray)"),
        (Int8(data=np.array(1.0)), "Int8.data must be an int, got array(1.) (numpy.ndarray)"),
        (Byte(data=b"ab"), "Byte.data must be bytes of length 1, got b'ab' (bytes)"),
        (String(data=5), "String.data must be a str, got 5 (int)"),
        (String(data="\ud800"), r"String.data must be text without lone surrogates, got '\ud800' (str)"),
        (String(data=b"x" * 99), "String.data must be a str, got b'" + "x" * 58 + "... (bytes)"),
        (WString(data=5), "WString.data must be a str, got 5 (int)"),
        (ColorRGBA(r=1e39), "ColorRGBA.r must be a float within the range of float32, got 1e+39 (float)"),
        (JointState(name="abc"), "JointState.name must be a sequence, got 'abc' (str)"),
        (JointState(name=["a", 5]), "JointState.name[1] must be a str, got 5 (int)"),
        (JointState(name=7), "JointState.name must be a sequence, got 7 (int)"),
        (
            TFMessage(transforms=[TransformStamped(), 3]),
            "TFMessage.transforms[1] must be a geometry_msgs/msg/TransformStamped, got 3 (int)",
        ),
        (
            PoseWithCovariance(covariance=[0.0] * 35),
            "PoseWithCovariance.covariance must have 36 elements, got 35",
        ),
        (
            SolidPrimitive(dimensions=[1.0] * 4),
            "SolidPrimitive.dimensions: 4 elements are more than the bound of 3",
        ),
        (
            FieldType(nested_type_name="é" * 256),
            "FieldType.nested_type_name: 256 characters are more than the bound of 255",
        ),
    ],
)
def test_encode_errors_have_the_path(message: Message, text: str) -> None:
    with pytest.raises(cdr.EncodeError) as raised:
        cdr.encode(message)
    assert str(raised.value) == text
    assert text.startswith(raised.value.path)


@pytest.mark.parametrize("written", ["\udc80", None])
def test_error_of_a_value_whose_repr_cannot_be_shown_says_its_class(written: str | None) -> None:
    value = type("Odd", (), {"__repr__": lambda _: written})()
    with pytest.raises(cdr.EncodeError, match=r"^String.data must be a str, got <no repr> \(Odd\)$"):
        cdr.encode(String(data=value))
    with pytest.raises(TypeError, match=r"must be a str, not <no repr> of class Odd$"):
        Buffer().can(value, "a")


def test_unset_slot_raises() -> None:
    with pytest.raises(cdr.EncodeError, match=r"^Vector3.x is not set$"):
        cdr.encode(Vector3.__new__(Vector3))


def test_error_paths_of_nested_fields() -> None:
    message = TFMessage(transforms=[TransformStamped()])
    message.transforms[0].transform.translation.x = "abc"  # type: ignore[assignment]
    with pytest.raises(cdr.EncodeError) as raised:
        cdr.encode(message)
    assert raised.value.path == "TFMessage.transforms[0].transform.translation.x"


def test_non_messages_raise() -> None:
    for wrong in (5, "abc", object(), Message):
        with pytest.raises(TypeError, match="is not a message class"):
            cdr.encode(wrong)  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        cdr.decode(int, b"")  # type: ignore[type-var]
    with pytest.raises(TypeError):
        cdr.decode(Vector3, 5)  # type: ignore[arg-type]


def test_numbers_of_other_types_are_accepted() -> None:
    assert cdr.decode(Vector3, cdr.encode(Vector3(x=1, y=np.float32(0.5), z=Number()))) == Vector3(
        x=1.0, y=0.5, z=7.5
    )
    assert cdr.decode(Int8, cdr.encode(Int8(data=Number()))).data == 7
    assert cdr.decode(Int8, cdr.encode(Int8(data=np.int64(-3)))).data == -3
    assert cdr.decode(Int8, cdr.encode(Int8(data=np.array(3)))).data == 3
    assert cdr.decode(Byte, cdr.encode(Byte(data=bytearray(b"7")))).data == b"7"
    assert cdr.decode(Bool, cdr.encode(Bool(data=np.bool_(True)))).data is True


def test_exception_of_a_value_is_propagated() -> None:
    class Broken:
        def __float__(self) -> float:
            raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        cdr.encode(Vector3(x=Broken()))


def test_list_that_shrinks_during_encoding_raises() -> None:
    message = ParameterValue()

    class Shrinking:
        def __index__(self) -> int:
            names.clear()
            return 1

    names: list[Any] = ["a", "b"]
    message.string_array_value = names
    message.type = Shrinking()  # is first
    assert cdr.decode(ParameterValue, cdr.encode(message)).string_array_value == []
    transforms: list[Any] = [TransformStamped() for _ in range(9)]

    class Cleared:
        def __float__(self) -> float:
            transforms.clear()
            return 1.0

    transforms[0].transform.translation.x = Cleared()
    with pytest.raises(cdr.EncodeError, match=r"transforms\[1\] is gone"):
        cdr.encode(TFMessage(transforms=transforms))


@pytest.mark.parametrize(
    ("cls", "data", "text"),
    [
        (Vector3, b"", "Vector3: byte 0: a sample has a header of 4 bytes, this one ends after 0"),
        (Vector3, b"\0\1\0", "Vector3: byte 0: a sample has a header of 4 bytes, this one ends after 3"),
        (Vector3, b"\0\7\0\0", "Vector3: byte 0: representation 7 is neither CDR_BE (0) nor CDR_LE (1)"),
        (Vector3, LE + bytes(15), "Vector3.y: byte 12: 8 bytes are needed, 7 are left"),
        (Vector3, LE + bytes(32), "Vector3: byte 28: 8 bytes are left over"),
        (String, LE + b"\2\0\0\0ab", "String.data: byte 9: the string does not end with a zero byte"),
        (String, LE + b"\3\0\0\0\xff\xfe\0", "String.data: byte 8: the text is not UTF-8"),
        (
            String,
            LE + b"\xff\xff\xff\xff",
            "String.data: byte 4: the length 4294967295 is more than the 0 bytes left can hold",
        ),
        (
            Image,
            LE + bytes(32) + b"\0\0\0\x80",
            "Image.data: byte 36: the length 2147483648 is more than the 0 bytes left can hold",
        ),
        (
            TFMessage,
            LE + b"\xff\xff\xff\x00" + bytes(100),
            "TFMessage.transforms: byte 4: the length 16777215 is more than the 100 bytes left can hold",
        ),
        (
            TFMessage,
            LE + b"\1\0\0\0" + bytes(8) + b"\1\0\0\0X" + bytes(99),
            "TFMessage.transforms[0].header.frame_id: byte 20: the string does not end with a zero byte",
        ),
        (
            SolidPrimitive,
            LE + b"\1\0\0\0\4\0\0\0" + bytes(32),
            "SolidPrimitive.dimensions: byte 12: 4 elements are more than the bound of 3",
        ),
        (WString, LE + b"\1\0\0\0\0\xd8\0\0", "WString.data: byte 12: the text is not UTF-16"),
        (WString, LE + b"\1\0\0\0\0\xdc\0\0", "WString.data: byte 8: the text is not UTF-16"),
        (WString, LE + b"\1\0\0\0\0\0\x11\0", "WString.data: byte 8: the text is not UTF-16"),
        (
            FieldType,
            LE + bytes(24) + b"\1\1\0\0" + b"x" * 256 + b"\0",
            "FieldType.nested_type_name: byte 289: 256 characters are more than the bound of 255",
        ),
    ],
)
def test_decode_errors_have_path_and_offset(cls: type[Message], data: bytes, text: str) -> None:
    with pytest.raises(cdr.DecodeError) as raised:
        cdr.decode(cls, data)
    assert str(raised.value) == text
    assert text == f"{raised.value.path}: byte {raised.value.offset}: {raised.value.reason}"


def test_padding_and_empty_strings_without_nul_are_decoded() -> None:
    assert cdr.decode(Vector3, LE + bytes(24 + 7)) == Vector3()
    assert cdr.decode(Header, LE + bytes(12)).frame_id == ""
    assert cdr.decode(Empty, LE + bytes(4)) == Empty()


def test_any_buffer_is_decoded() -> None:
    data = cdr.encode(Time(sec=5))
    for form in (bytearray(data), memoryview(data), array("B", data), np.frombuffer(data, np.uint8)):
        assert cdr.decode(Time, form) == Time(sec=5)


def test_big_endian_is_decoded() -> None:
    assert cdr.decode(Time, BE + bytes.fromhex("00000001 00000002")) == Time(sec=1, nanosec=2)
    joints = BE + bytes(8) + bytes.fromhex("00000001 00000000 00000000 00000001 3ff8000000000000")
    assert cdr.decode(String, BE + bytes.fromhex("00000003") + b"hi\0").data == "hi"
    decoded = cdr.decode(JointState, joints + bytes(8))
    assert (decoded.position, decoded.velocity) == (array("d", [1.5]), array("d"))
    covariance = b"".join(np.array([i + 0.5], ">f8").tobytes() for i in range(36))
    pose = cdr.decode(PoseWithCovariance, BE + bytes(56) + covariance)
    assert pose.covariance.tolist() == [i + 0.5 for i in range(36)]


def test_wide_strings_beyond_the_first_plane() -> None:
    data = cdr.encode(WString(data="a\U0001f422"))
    assert data.hex() == "00010000" + "03000000" + "61000000" + "3dd80000" + "22dc0000"
    assert cdr.decode(WString, data).data == "a\U0001f422"
    assert cdr.decode(WString, LE + b"\1\0\0\0" + b"\x22\xf4\x01\0").data == "\U0001f422"


def test_subclass_is_decoded_and_encoded() -> None:
    class Point(Vector3):
        """A user's subclass."""

    point = cdr.decode(Point, cdr.encode(Vector3(x=2.0)))
    assert type(point) is Point
    assert point.x == 2.0
    assert cdr.encode(Twist(linear=point)) == cdr.encode(Twist(linear=Vector3(x=2.0)))


def test_large_arrays_survive_the_codec() -> None:
    pixels = os.urandom(1_000_001)
    data = cdr.encode(Image(data=pixels, encoding="mono8"))
    assert data.endswith(bytes.fromhex("41420f00") + pixels)
    assert cdr.decode(Image, data).data.tobytes() == pixels
    cloud = PointCloud2(data=array("B", pixels), fields=[PointField(name="x")])
    assert cdr.decode(PointCloud2, cdr.encode(cloud)) == cloud


def test_failed_decoding_releases_all_objects() -> None:
    """A message truncated at any byte leaves neither references nor incomplete objects."""
    import gc

    def messages() -> list[Message]:
        return [instance for instance in gc.get_objects() if isinstance(instance, Message)]

    data = cdr.encode(TFMessage(transforms=[TransformStamped() for _ in range(3)]))
    # Those of other tests, held so that none is released meanwhile and gives its id to another.
    others = {id(message): message for message in messages()}
    before = None
    for turn in range(2):
        for end in range(len(data)):
            with pytest.raises(cdr.DecodeError):
                cdr.decode(TFMessage, data[:end])
        gc.collect()
        count = sum(id(message) not in others for message in messages())
        assert turn == 0 or count == before
        before = count


GOLDEN = Path(__file__).parents[1] / "golden" / "jazzy_types.jsonl"
SAMPLES = {
    golden["type"]: [bytes.fromhex(sample["cdr"]) for sample in golden["samples"]]
    for golden in map(json.loads, GOLDEN.read_text("utf-8").splitlines())
    if golden["samples"]
}


@for_each(SAMPLES)
def test_damaged_bytes_are_decoded_or_rejected(name: str) -> None:
    cls, generator = get_message_class(name), random.Random(name)
    for _ in range(60):
        data = bytearray(generator.choice(SAMPLES[name]))
        for _ in range(generator.randrange(1, 4)):
            data[generator.randrange(4, len(data))] = generator.choice([0, 1, 2, 0x7F, 0x80, 0xFF])
        data = data[: generator.choice([len(data), generator.randrange(len(data) + 1)])]
        try:
            message = cdr.decode(cls, data)
        except cdr.DecodeError as error:
            if error.offset > len(data):
                pytest.fail(f"{error} of {len(data)}")
            continue
        again = cdr.encode(message)
        assert cdr.encode(cdr.decode(cls, again)) == again


finite = st.floats(allow_nan=False)
text = st.text(st.characters(blacklist_categories=["Cs"], blacklist_characters="\0"))


@settings(deadline=None, max_examples=60)
@given(
    st.lists(st.tuples(text, st.integers(-(2**31), 2**31 - 1), st.integers(0, 2**32 - 1), finite, finite)),
)
def test_decode_undoes_encode(rows: list[tuple[str, int, int, float, float]]) -> None:
    message = TFMessage()
    for name, sec, nanosec, x, w in rows:
        transform = TransformStamped(header=Header(stamp=Time(sec=sec, nanosec=nanosec), frame_id=name))
        transform.child_frame_id = name[::-1]
        transform.transform.translation.x = x
        transform.transform.rotation.w = w
        message.transforms.append(transform)
    assert cdr.decode(TFMessage, cdr.encode(message)) == message


@pytest.mark.parametrize(
    ("octets", "text"),
    [
        (b"\4\0\0\0a\0b\0", "a"),
        (b"\3\0\0\0a\0\0", "a"),
        (b"\2\0\0\0\0\0", ""),
        (b"\5\0\0\0\xc3\xa9\0\xff\0", "é"),
    ],
)
def test_a_text_ends_before_its_first_nul(octets: bytes, text: str) -> None:
    """As in rclpy: the contents of files in a real node's GetTypeDescription have one behind them."""
    assert cdr.decode(String, LE + octets).data == text
    empty = b"\1\0\0\0\0\0\0\0"
    source = cdr.decode(TypeSource, LE + empty + empty + octets)
    assert source.raw_file_contents == text


@pytest.mark.parametrize(
    "empty",
    [b"", np.bytes_(b""), bytearray(), memoryview(b""), (), range(0)],
    ids=lambda empty: type(empty).__name__,
)
def test_every_empty_sequence_is_the_empty_one_of_each_type(empty: Any) -> None:
    message = ParameterValue()
    names = [name for name in ParameterValue.get_fields_and_field_types() if name.endswith("array_value")]
    for name in names:
        setattr(message, name, empty)
    assert cdr.encode(message) == cdr.encode(ParameterValue())
    with pytest.raises(cdr.EncodeError, match="must be a sequence"):
        cdr.encode(ParameterValue(byte_array_value=b"ab"))
