"""The command line of static_transform_publisher."""

from __future__ import annotations

import math

import pytest

from tfloom.tf2_tools.static_transform import ArgumentsError, parse

FRAMES = ["--frame-id", "world", "--child-frame-id", "camera"]
HALF = math.sqrt(0.5)


def test_flags_are_parsed() -> None:
    words = ["--x", "1", "--y", "-2e0", "--z", "3", "--yaw", str(math.pi / 2), *FRAMES]
    transform, is_old_form = parse(words)
    assert transform.translation == (1.0, -2.0, 3.0)
    assert transform.rotation_xyzw == pytest.approx((0.0, 0.0, HALF, HALF))
    assert (transform.frame_id, transform.child_frame_id) == ("world", "camera")
    assert not is_old_form


def test_omitted_flags_are_the_identity() -> None:
    transform = parse(FRAMES).transform
    assert transform.translation == (0.0, 0.0, 0.0)
    assert transform.rotation_xyzw == (0.0, 0.0, 0.0, 1.0)


def test_roll_pitch_yaw_turn_about_fixed_axes() -> None:
    # A quarter turn about x, then one about z, maps z to -y to x: the axis is (1, 1, 1).
    transform = parse(["--roll", str(math.pi / 2), "--yaw", str(math.pi / 2), *FRAMES]).transform
    assert transform.rotation_xyzw == pytest.approx((0.5, 0.5, 0.5, 0.5))


def test_older_forms_are_parsed() -> None:
    euler = parse(["1", "2", "3", str(math.pi / 2), "0", "0", "a", "b"])
    assert euler.transform.translation == (1.0, 2.0, 3.0)
    assert euler.transform.rotation_xyzw == pytest.approx((0.0, 0.0, HALF, HALF))
    quaternion = parse(["1", "2", "-3", "0", "0", "0.6", "0.8", "a", "b"])
    assert quaternion.transform.rotation_xyzw == (0.0, 0.0, 0.6, 0.8)
    assert euler.is_old_form
    assert quaternion.is_old_form


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ([], "Not enough arguments to parse"),
        (["1", "2", "3"], "Not enough arguments to parse"),
        ([*FRAMES, "--x"], "Not enough arguments for --x"),
        ([*FRAMES, "--x", "far"], "Failed to parse --x argument as float"),
        ([*FRAMES, "--qx", "nan"], "Failed to parse --qx argument as float"),
        ([*FRAMES, "--qx", "1", "--roll", "1"], "Cannot specify both quaternion and Euler rotations"),
        ([*FRAMES, *"12345678"], "Cannot specify both new-style (flags) and old-style (arguments)"),
        ([*FRAMES, "extra"], "Extra unparsed arguments on command-line"),
        ([*"1234567890"], "Extra unparsed arguments on command-line"),
        (["--child-frame-id", "b"], "Frame id must not be empty"),
        (["--frame-id", "a"], "Child frame id must not be empty"),
        (["--frame-id", "", "--child-frame-id", "b"], "Frame id must not be empty"),
        ([*FRAMES, "--qw", "0"], "A quaternion of zeros is not a rotation"),
    ],
)
def test_invalid_command_lines_raise(words: list[str], text: str) -> None:
    with pytest.raises(ArgumentsError) as error:
        parse(words)
    assert str(error.value) == text
