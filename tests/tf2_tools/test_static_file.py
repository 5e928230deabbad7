"""Files of static transforms: what is written is read again, and each error names the file and the line."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2_tools.static_file import (
    StaticFileError,
    encoded,
    file_text,
    read_statics,
)
from tfloom.tf2_tools.static_transform import StaticTransform

LASER = StaticTransform("base", "laser", (0.1, -2e-7, 1.0 / 3.0), (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))
ODD = StaticTransform("yes", "1.0: #ü 雷射", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def written(tmp_path: Path, text: str) -> Path:
    """Write a file and return its path."""
    path = tmp_path / "statics.yaml"
    path.write_text(text, "utf-8")
    return path


def items(*lines: str) -> str:
    """Return the text of a file with these items in flow style, from line 2 on."""
    return "static_transforms:\n" + "".join(f"- {{{line}}}\n" for line in lines)


def test_what_is_written_is_read_again_to_the_last_bit(tmp_path: Path) -> None:
    assert read_statics(written(tmp_path, file_text([LASER, ODD]))) == [ODD, LASER]


def test_the_text_can_be_ascii(tmp_path: Path) -> None:
    text = file_text([ODD], ascii_only=True)
    assert text.isascii()
    assert read_statics(written(tmp_path, text)) == [ODD]


def test_parts_may_be_left_out_and_angles_given(tmp_path: Path) -> None:
    (read,) = read_statics(
        written(tmp_path, items("frame_id: a, child_frame_id: b, translation: {z: 2}, rotation: {yaw: 1.0}"))
    )
    assert read.translation == (0.0, 0.0, 2.0)
    assert read.rotation_xyzw == pytest.approx((0.0, 0.0, math.sin(0.5), math.cos(0.5)))
    (plain,) = read_statics(written(tmp_path, items("frame_id: a, child_frame_id: b")))
    assert (plain.translation, plain.rotation_xyzw) == ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def test_a_rounded_quaternion_is_normalised(tmp_path: Path) -> None:
    (read,) = read_statics(
        written(
            tmp_path, items("frame_id: a, child_frame_id: b, rotation: {x: 0, y: 0, z: 0.7071, w: 0.7071}")
        )
    )
    assert math.hypot(*read.rotation_xyzw) == pytest.approx(1.0, abs=1e-15)


def test_the_message_has_all_transforms_and_one_stamp() -> None:
    message = cdr.decode(TFMessage, encoded([LASER, ODD], 5_000_000_007))
    assert [transform.child_frame_id for transform in message.transforms] == ["laser", "1.0: #ü 雷射"]
    assert {
        (transform.header.stamp.sec, transform.header.stamp.nanosec) for transform in message.transforms
    } == {(5, 7)}
    assert message.transforms[0].transform.rotation.z == LASER.rotation_xyzw[2]


PAIR = "frame_id: a, child_frame_id: b"
ERRORS = {
    "transforms: []": ":1: a file of static transforms has one key, static_transforms, with a list of transforms",
    "[": ":1: ",
    "static_transforms:\n- 5\n": ": an item of static_transforms is a mapping with frame_id, child_frame_id",
    items("frame_id: a, child: b"): ":2: unknown key 'child': the keys are frame_id, child_frame_id",
    items("frame_id: a"): ":2: child_frame_id must be the name of a frame",
    items(
        "frame_id: yes, child_frame_id: b"
    ): ":2: frame_id must be the name of a frame, not True: put it in quotes",
    items(
        "frame_id: /a, child_frame_id: b"
    ): ":2: frame_id '/a' starts with a slash, which tf2 rejects: write 'a'",
    items(PAIR, "frame_id: a, child_frame_id: c, translation: {x: one}"): (
        ":3: translation.x must be a finite number, not 'one'"
    ),
    items(PAIR + ", translation: [1, 2, 3]"): ":2: translation is a mapping with x, y, z, not [1, 2, 3]",
    items(PAIR + ", translation: {x: .nan}"): ":2: translation.x must be a finite number, not nan",
    items(
        PAIR + f", translation: {{x: 1{'0' * 400}}}"
    ): ":2: translation.x must be a finite number, not one beyond",
    items(PAIR + ", rotation: {x: 0, y: 0, z: 0}"): ":2: rotation lacks w",
    items(
        PAIR + ", rotation: {x: 0, y: 0, z: 0, w: 0}"
    ): ":2: the rotation's quaternion has the length 0, not 1",
    items(PAIR + ", rotation: {yaw: 1, w: 1}"): ":2: rotation is a mapping with roll, pitch, yaw, not ",
    items(
        PAIR, "frame_id: c, child_frame_id: b"
    ): ":3: the child frame 'b' is there twice, with the parent 'a'",
    items(PAIR, "frame_id: b, child_frame_id: a"): ":3: 'b' -> 'a' closes a loop",
    items("frame_id: a, child_frame_id: a"): ":2: 'a' -> 'a' closes a loop",
}


def test_each_error_names_the_file_and_the_line(tmp_path: Path) -> None:
    wrong = {}
    for text, expected in ERRORS.items():
        path = written(tmp_path, text)
        try:
            wrong[text] = str(read_statics(path))
        except StaticFileError as error:
            if not str(error).startswith(f"{path}{expected}"):
                wrong[text] = str(error)
    assert wrong == {}


def test_bytes_that_are_no_text(tmp_path: Path) -> None:
    path = tmp_path / "statics.yaml"
    path.write_bytes(b"static_transforms: \xff")
    with pytest.raises(StaticFileError, match="octet 19 isn't UTF-8 text"):
        read_statics(path)
