"""Encodings and conversions: the arithmetic is OpenCV's, and what makes no sense is refused as the reference does."""

from __future__ import annotations

import numpy as np
import pytest
from tests.sensing.opencv_golden import CONVERSIONS, Conversion, Recorded

from tfloom.sensing.cv_types import CV_MAT_CNWrap, CV_MAT_DEPTHWrap, getCvType
from tfloom.sensing.image_conversion import cvtColor2, saturate
from tfloom.sensing.image_encodings import ImageError, find_encoding


@pytest.mark.parametrize("conversion", CONVERSIONS, ids=lambda each: f"{each.source}-{each.target}")
def test_colors_as_opencv_has_them(conversion: Conversion, recorded: Recorded) -> None:
    source, target, _ = conversion
    image = recorded[f"image {source}"]
    before = image.copy()
    changed = cvtColor2(image, source, target)
    expected = recorded[f"{source} to {target}"]
    assert changed.dtype == expected.dtype
    np.testing.assert_array_equal(changed, expected)
    np.testing.assert_array_equal(image, before)


def test_a_mosaic_too_small_to_have_neighbours_is_black() -> None:
    assert not cvtColor2(np.full((2, 6), 9, np.uint8), "bayer_rggb8", "rgb8").any()


def test_nv24_has_chroma_for_each_pixel(recorded: Recorded) -> None:
    """As NV12 where two by two pixels have the same chroma."""
    nv12 = recorded["image nv12"]
    height, width = len(nv12) * 2 // 3, nv12.shape[1]
    pairs = nv12[height:].reshape(height // 2, width // 2, 2)
    chroma = pairs.repeat(2, 0).repeat(2, 1).reshape(2 * height, width)
    nv24 = np.concatenate([nv12[:height], chroma])
    for target in ("rgb8", "bgr8", "mono8", "bgra8"):
        np.testing.assert_array_equal(cvtColor2(nv24, "nv24", target), recorded[f"nv12 to {target}"])


@pytest.mark.parametrize(
    ("source", "target", "numbers", "expected"),
    [
        ("mono8", "mono16", [0, 1, 255], [0, 257, 65535]),
        ("mono16", "mono8", [0, 128, 129, 65535], [0, 0, 1, 255]),
        ("8UC1", "16UC1", [255], [65535]),
        ("8SC1", "16SC1", [-128, 127], [-32768, 32639]),
        ("32FC1", "16UC1", [-1.0, 0.5, 1.5, 70000.0, np.nan], [0, 0, 2, 65535, 0]),
        ("64FC1", "32SC1", [1e10, -1e10, 2.5], [-(2**31), -(2**31), 2]),
        ("16UC1", "32FC1", [65535], [65535.0]),
        ("32SC1", "8SC1", [-300, 300], [-128, 127]),
        ("mono8", "8UC1", [7], [7]),
    ],
)
def test_depths(source: str, target: str, numbers: list[float], expected: list[float]) -> None:
    changed = cvtColor2(np.array([numbers], find_encoding(source).dtype), source, target)
    assert changed.dtype == find_encoding(target).dtype
    assert changed.tolist() == [expected]


def test_depth_and_colors_together() -> None:
    image = np.array([[[1, 2, 3]]], np.uint8)
    assert cvtColor2(image, "rgb8", "bgra16").tolist() == [[[771, 514, 257, 65535]]]


@pytest.mark.parametrize(
    ("source", "target", "text"),
    [
        (
            "16UC1",
            "mono8",
            "[16UC1] is not a color format. but [mono8] is. The conversion does not make sense",
        ),
        ("8UC3", "8UC1", "[8UC3] and [8UC1] do not have the same number of channel"),
        (
            "bgr8",
            "8UC1",
            "[bgr8] is a color format but [8UC1] is not so they must have the same OpenCV type, CV_8UC3, CV16UC1 ....",
        ),
        ("bgr8", "yuv422", "Unsupported conversion from [bgr8] to [yuv422]"),
        ("bayer_rggb8", "bgra8", "Unsupported conversion from [bayer_rggb8] to [bgra8]"),
        ("bayer_rggb8", "bayer_rggb16", "Unsupported conversion from [bayer_rggb8] to [bayer_rggb16]"),
        ("bgr8", "purple", "Unknown encoding purple"),
        ("mono16", "16UC", "Unknown encoding 16UC"),
    ],
)
def test_what_makes_no_sense_is_refused(source: str, target: str, text: str) -> None:
    encoding = find_encoding(source)
    shape = (2, 2, encoding.channels) if encoding.channels > 1 else (2, 2)
    with pytest.raises(RuntimeError) as caught:
        cvtColor2(np.zeros(shape, encoding.dtype), source, target)
    assert str(caught.value) == text


def test_sizes_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ImageError, match="even width"):
        cvtColor2(np.zeros((2, 3, 2), np.uint8), "yuv422", "bgr8")
    with pytest.raises(ImageError, match="multiple of 3 rows, not 4"):
        cvtColor2(np.zeros((4, 4), np.uint8), "nv21", "bgr8")
    with pytest.raises(ImageError, match=r"has 3 channel\(s\) of uint8, not the shape \(2, 2\) of uint8"):
        cvtColor2(np.zeros((2, 2), np.uint8), "bgr8", "rgb8")


def test_the_same_encoding_is_a_copy() -> None:
    image = np.zeros((2, 2), np.uint8)
    for target in ("mono8", ""):
        copy = cvtColor2(image, "mono8", target)
        assert copy is not image
        assert (copy == image).all()


def test_saturate_leaves_large_doubles_infinite() -> None:
    assert saturate(np.array([1e300]), np.dtype(np.float32)).tolist() == [np.inf]


@pytest.mark.parametrize(
    ("name", "number"),
    [
        ("mono8", 0),
        ("bgr8", 16),
        ("rgba16", 26),
        ("yuv422_yuy2", 8),
        ("bayer_gbrg16", 2),
        ("nv21", 0),
        ("8U", 0),
        ("32FC1", 5),
        ("64FC4", 30),
        ("32SC40", 4 + 39 * 8),
    ],
)
@pytest.mark.usefixtures("without_opencv")
def test_numbers_of_types(name: str, number: int) -> None:
    assert getCvType(name) == number
    encoding = find_encoding(name)
    assert CV_MAT_CNWrap(number) == encoding.channels
    assert CV_MAT_DEPTHWrap(number) == number % 8


@pytest.mark.parametrize("name", ["", "8UC", "8UC0", "8UCx", "16FC1", "RGB8", "bgr8 "])
def test_an_unknown_encoding(name: str) -> None:
    with pytest.raises(RuntimeError) as caught:
        getCvType(name)
    assert str(caught.value) == f"Unrecognized image encoding [{name}]"
