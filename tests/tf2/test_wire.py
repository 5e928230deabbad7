"""Decoding of TFMessage bytes into a buffer, hostile bytes included."""

from __future__ import annotations

import random
import struct
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer

GID = bytes(16)
names = st.text(st.characters(exclude_categories=("Cs",), exclude_characters="\0"), max_size=20)
numbers = st.floats(-1e6, 1e6)


def message(count: int) -> bytes:
    """Return `count` links of a chain, f0 to f`count`, at 5 s."""
    links = [transform_stamped(f"f{i}", f"f{i + 1}", 5 * SECOND, (1.0, 2.0, float(i))) for i in range(count)]
    return cdr.encode(TFMessage(transforms=links))


def big_endian(data: bytes) -> bytes:
    """Return the message of one transform with one-letter names, as a big-endian writer writes it."""
    sec, nanosec = struct.unpack_from("<iI", data, 8)
    doubles = struct.unpack_from("<7d", data, len(data) - 56)
    body = struct.pack(">IiI", 1, sec, nanosec)
    for name in (b"a\0", b"b\0"):
        body += bytes(-len(body) % 4) + struct.pack(">I", len(name)) + name
    body += bytes(-len(body) % 8) + struct.pack(">7d", *doubles)
    return b"\0\0\0\0" + body


@pytest.mark.parametrize("count", [0, 1, 2, 100])
def test_transforms_of_a_message_are_stored(count: int) -> None:
    buffer = Buffer()
    assert buffer.insert_cdr(message(count), "me") == count
    if count:
        transform = buffer.lookup("f0", f"f{count}")
        assert transform.stamp_ns == 5 * SECOND
        assert transform.translation == pytest.approx((count, 2 * count, count * (count - 1) / 2))
        assert "broadcaster: 'me'" in buffer.all_frames_as_yaml()


@settings(max_examples=100, deadline=None)
@given(
    st.lists(
        st.tuples(
            names,
            names,
            st.integers(-(2**31), 2**31 - 1),
            st.tuples(*[numbers] * 3),
            st.tuples(*[numbers] * 4),
        ),
        max_size=5,
    ),
    st.booleans(),
)
def test_result_equals_setting_the_decoded_message(rows: list, static: bool) -> None:
    from_bytes, from_message = Buffer(None), Buffer(None)
    for buffer in (from_bytes, from_message):
        buffer.set_log_callback(None)
    calls = [(frame, child, s * SECOND + 7, xyz, q) for frame, child, s, xyz, q in rows]
    encoded = cdr.encode(TFMessage(transforms=[transform_stamped(*call) for call in calls]))
    assert from_bytes.insert_cdr(encoded, "me", static=static) == sum(
        from_message.set(*call, "me", static=static) for call in calls
    )
    assert from_bytes.all_frames_as_yaml() == from_message.all_frames_as_yaml()
    assert from_bytes.frame_names() == from_message.frame_names()


def test_other_byte_order_is_decoded() -> None:
    sent = transform_stamped("a", "b", -SECOND - 1, xyzw=(0.0, 0.0, 0.6, 0.8))
    buffer = Buffer()
    assert buffer.insert_cdr(big_endian(cdr.encode(TFMessage(transforms=[sent])))) == 1
    found = buffer.lookup("a", "b")
    assert found.stamp_ns == -SECOND - 1
    assert found.translation == (1.0, 2.0, 3.0)
    assert found.rotation_xyzw == pytest.approx((0, 0, 0.6, 0.8))


def test_truncated_message_is_dropped_completely() -> None:
    data = message(3)
    for size in range(len(data)):
        buffer = Buffer()
        with pytest.raises(ValueError, match="TFMessage"):
            buffer.insert_cdr(data[:size])
        assert buffer.frame_names() == []


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (
            lambda data: data[:4] + struct.pack("<I", 2**32 - 1) + data[8:],
            "TFMessage: byte 4: the length 4294967295",
        ),
        (
            lambda data: data[:16] + struct.pack("<I", 2**31) + data[20:],
            r"TFMessage\.transforms\[0\]\.header\.frame_id: byte 16: the length 2147483648",
        ),
        (lambda data: data[:20] + b"\xff" + data[21:], r"transforms\[0\]\.header\.frame_id: .*UTF-8"),
        (lambda data: b"\0\2" + data[2:], "representation 2"),
        (lambda data: data + bytes(8), "8 bytes are left over"),
        (lambda data: b"", "header"),
    ],
)
def test_malformed_message_error_has_the_offset(spoil: Callable[[bytes], bytes], reason: str) -> None:
    buffer = Buffer()
    with pytest.raises(ValueError, match=reason):
        buffer.insert_cdr(spoil(message(2)))
    assert buffer.frame_names() == []


def test_padded_message_is_decoded() -> None:
    assert Buffer().insert_cdr(message(1) + bytes(4)) == 1


def test_sink_stores_counts_and_warns_once_a_second() -> None:
    lines: list[tuple[int, str]] = []
    buffer = Buffer()
    buffer.set_log_callback(lambda *line: lines.append(line))
    sink = buffer.tf_sink("me", static=False)
    for _ in range(500):
        sink.push(b"\0\1\0\0\1", 0, 0, GID)
    sink.push(message(1), 0, 0, GID)
    assert (sink.message_count, sink.dropped_count) == (501, 500)
    assert buffer.can("f0", "f1")
    assert 1 <= len(lines) <= 3
    assert lines[0][0] == 30
    assert lines[0][1].startswith("dropped a message of 5 bytes on /tf that is no tf2_msgs/msg/TFMessage")


def test_a_sink_outlives_its_buffer_object() -> None:
    sink = Buffer().tf_sink("me", static=True)
    sink.push(message(2), 0, 0, GID)
    assert sink.dropped_count == 0


def test_hostile_bytes_never_harm() -> None:
    random_source = random.Random(7)
    sound = message(4)
    buffer = Buffer()
    buffer.set_log_callback(None)
    sink = buffer.tf_sink("me", static=False)
    for _ in range(20_000):
        data = bytearray(sound[: random_source.randint(0, len(sound))])
        for _ in range(random_source.randint(0, 4)):
            if data:
                data[random_source.randrange(len(data))] = random_source.randrange(256)
        sink.push(bytes(data), 0, 0, GID)
    for _ in range(5_000):
        sink.push(random_source.randbytes(random_source.randint(0, 300)), 0, 0, GID)
    assert buffer.set("a", "b", SECOND, (0, 0, 0), (0, 0, 0, 1))
    assert buffer.can("a", "b")
    buffer.all_frames_as_yaml()
    buffer.frame_names()


@settings(max_examples=150, deadline=None)
@given(st.binary(max_size=40))
def test_names_are_stored_exactly_when_they_are_utf8(name: bytes) -> None:
    body = struct.pack("<IiI", 1, 0, 0) + struct.pack("<I", len(name) + 1) + name + b"\0"
    body += bytes(-len(body) % 4) + struct.pack("<I", 2) + b"b\0"
    body += bytes(-len(body) % 8) + struct.pack("<7d", 0, 0, 0, 0, 0, 0, 1)
    buffer = Buffer()
    buffer.set_log_callback(None)
    try:
        text = name.decode()
    except UnicodeDecodeError:
        with pytest.raises(ValueError, match="UTF-8"):
            buffer.insert_cdr(b"\0\1\0\0" + body)
        return
    is_valid = text.removeprefix("/") not in ("", "b")
    assert buffer.insert_cdr(b"\0\1\0\0" + body) == is_valid
    assert buffer.frame_names() == (["b", text.removeprefix("/")] if is_valid else [])
