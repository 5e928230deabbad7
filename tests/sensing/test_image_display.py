"""Images made fit to look at."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from tfloom_sensing.image_display import cvtColorForDisplay

WHERE = "cv_bridge.cvtColorForDisplay()"
NO_COLOR = "[32FC1] is not a color format. but [bgr8] is. The conversion does not make sense"


def test_labels_have_colors() -> None:
    labels = np.array([[0, 1, 7, 146, -1, -5, 110]], np.int32)
    colors = cvtColorForDisplay(labels, "32SC1", "bgr8")
    assert colors.tolist() == [
        [
            [255, 248, 239],  # AliceBlue: 0.941, 0.973, 1, times 255, cut off
            [214, 235, 249],  # AntiqueWhite
            [0, 0, 0],  # Black
            [255, 248, 239],
            [0, 0, 0],
            [0, 0, 0],
            [237, 237, 174],  # PaleVioletRed, as the reference has it
        ]
    ]
    assert colors.dtype == np.uint8


def test_a_range_is_spread() -> None:
    image = np.array([[0.0, 1.0, 2.0, 4.0, 9.0]], np.float32)
    assert cvtColorForDisplay(image, "32FC1", "mono8", False, 1.0, 3.0).tolist() == [[0, 0, 128, 255, 255]]
    assert (
        cvtColorForDisplay(image, "32FC1", "", min_image_value=0, max_image_value=9)[0, 1].tolist()
        == [28] * 3
    )


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int32, np.float64])
def test_the_own_range_is_spread(dtype: type[np.generic]) -> None:
    name = {"uint8": "8UC1", "uint16": "16UC1", "int32": "32SC1", "float64": "64FC1"}[np.dtype(dtype).name]
    image = np.array([[10, 20, 60]], dtype)
    assert cvtColorForDisplay(image, name, "mono8", do_dynamic_scaling=True).tolist() == [[0, 51, 255]]


def test_only_finite_numbers_make_a_range() -> None:
    image = np.array([[1.0, np.inf, 3.0, np.nan, -np.inf]], np.float32)
    gray = cvtColorForDisplay(image, "32FC1", "mono8", do_dynamic_scaling=True)
    assert gray[0, [0, 2]].tolist() == [0, 255]
    with pytest.raises(RuntimeError, match="without a finite number"):
        cvtColorForDisplay(np.full((1, 1), np.nan), "64FC1", "mono8", do_dynamic_scaling=True)


def test_an_image_of_one_number_is_grey() -> None:
    gray = cvtColorForDisplay(np.full((1, 2), 5, np.uint16), "16UC1", "bgr8", do_dynamic_scaling=True)
    assert gray.tolist() == [[[128, 128, 128]] * 2]


def test_colors_stay_colors() -> None:
    image = np.array([[[1, 2, 3]]], np.uint8)
    assert cvtColorForDisplay(image, "rgb8", "").tolist() == [[[3, 2, 1]]]
    assert cvtColorForDisplay(image, "bgr8", "bgr8") is image
    depth = np.array([[257, 65535]], np.uint16)
    assert cvtColorForDisplay(depth, "16UC1", "mono8").tolist() == [[1, 255]]


@pytest.mark.parametrize(
    ("encoding", "target", "text"),
    [
        ("64FC1", "", f"{WHERE} output encoding is empty and cannot be guessed."),
        (
            "mono8",
            "mono16",
            f"{WHERE} does not have an output encoding that is color or mono, and has is bit in depth",
        ),
        (
            "32FC1",
            "bgr8",
            f"{WHERE} while trying to convert image from '32FC1' to 'bgr8' an exception was thrown ({NO_COLOR})",
        ),
    ],
)
def test_what_cannot_be_shown(encoding: str, target: str, text: str) -> None:
    dtype = {"64FC1": np.float64, "32FC1": np.float32}.get(encoding, np.uint8)
    with pytest.raises(RuntimeError) as caught:
        cvtColorForDisplay(np.zeros((2, 2), dtype), encoding, target)
    assert str(caught.value) == text


def test_several_channels_have_no_range() -> None:
    with pytest.raises(RuntimeError, match="more than one channel is unsupported"):
        cvtColorForDisplay(np.zeros((2, 2, 3), np.uint8), "bgr8", "bgr8", False, 0.0, 1.0)


def test_colormaps() -> None:
    image = np.array([[0.0, 0.5, 1.0, np.nan]], np.float32)
    colored = cvtColorForDisplay(image, "32FC1", "bgr8", False, 0.0, 1.0, cv2.COLORMAP_JET)
    expected = cv2.applyColorMap(np.array([[0, 128, 255]], np.uint8), cv2.COLORMAP_JET)
    np.testing.assert_array_equal(colored[:, :3], expected)
    assert not colored[0, 3].any()
