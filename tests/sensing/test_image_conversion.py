"""Encodings and conversions: each has the right colours, and what makes no sense is refused as the reference does."""

from __future__ import annotations

from itertools import permutations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tfloom_sensing.image_conversion import cvtColor2, saturate
from tfloom_sensing.image_encodings import ImageError, find_encoding
from tfloom_sensing.opencv import CV_MAT_CNWrap, CV_MAT_DEPTHWrap, getCvType

RED, GREEN, BLUE = 210, 120, 30
ORDERS = ("mono", "rgb", "bgr", "rgba", "bgra")
MOSAICS = ("rggb", "bggr", "gbrg", "grbg")
CHROMA = {"yuv422": "uyvy", "uyvy": "uyvy", "yuv422_yuy2": "yuyv", "yuyv": "yuyv"}
GRAY = 0.299 * RED + 0.587 * GREEN + 0.114 * BLUE
LUMA_OF_VIDEO = round(16 + 219 * GRAY / 255)
U_OF_VIDEO = round(128 + 224 * (BLUE - GRAY) / (1.772 * 255))
V_OF_VIDEO = round(128 + 224 * (RED - GRAY) / (1.402 * 255))
"""The colour in the range of video, by ITU-R BT.601."""


def in_order(order: str, scale: int = 1) -> list[int]:
    """Return the colour's channels in an order."""
    values = {"r": RED * scale, "g": GREEN * scale, "b": BLUE * scale, "a": 256 * scale - 1}
    if order == "mono":
        return [round(GRAY * scale)]
    return [values[letter] for letter in order]


def plain(channels: list[int], dtype: type[np.generic] = np.uint8) -> NDArray[np.generic]:
    image = np.full((4, 6, len(channels)), channels, dtype)
    return image[..., 0] if len(channels) == 1 else image


@pytest.mark.parametrize(("source", "target"), list(permutations(ORDERS, 2)))
@pytest.mark.parametrize("bits", [8, 16])
def test_orders_of_channels(source: str, target: str, bits: int) -> None:
    dtype, scale = (np.uint8, 1) if bits == 8 else (np.uint16, 256)
    image = plain(in_order(source, scale), dtype)
    before = image.copy()
    changed = cvtColor2(image, f"{source}{bits}", f"{target}{bits}")
    expected = in_order(target, scale)
    if source == "mono":
        gray = in_order("mono", scale)[0]
        expected = [256 * scale - 1 if letter == "a" else gray for letter in target]
    assert changed.dtype == dtype
    np.testing.assert_allclose(changed, plain(expected, dtype), atol=scale)
    np.testing.assert_array_equal(image, before)


@pytest.mark.parametrize("mosaic", MOSAICS)
@pytest.mark.parametrize("target", ["mono", "rgb", "bgr"])
@pytest.mark.parametrize("bits", [8, 16])
def test_a_mosaic_of_one_color_has_that_color(mosaic: str, target: str, bits: int) -> None:
    dtype, scale = (np.uint8, 1) if bits == 8 else (np.uint16, 256)
    tile = np.array(in_order(mosaic, scale), dtype).reshape(2, 2)
    changed = cvtColor2(np.tile(tile, (3, 4)), f"bayer_{mosaic}{bits}", f"{target}{bits}")
    expected = np.broadcast_to(np.squeeze(in_order(target, scale)), changed.shape)
    np.testing.assert_allclose(changed, expected, atol=scale)


def video_image(encoding: str, u: int = U_OF_VIDEO, v: int = V_OF_VIDEO) -> NDArray[np.uint8]:
    """Return an image of one colour in a YUV format: 4 rows of 6 pixels."""
    values = {"u": u, "v": v, "y": LUMA_OF_VIDEO}
    if encoding in CHROMA:
        return np.tile(np.array([values[letter] for letter in CHROMA[encoding]], np.uint8), (4, 3)).reshape(
            4, 6, 2
        )
    luma = np.full((4, 6), LUMA_OF_VIDEO, np.uint8)
    pair = [v, u] if encoding == "nv21" else [u, v]
    return np.concatenate([luma, np.tile(np.array(pair, np.uint8), (8 if encoding == "nv24" else 2, 3))])


@pytest.mark.parametrize("encoding", [*CHROMA, "nv12", "nv21", "nv24"])
@pytest.mark.parametrize("target", ORDERS)
def test_video_has_its_color(encoding: str, target: str) -> None:
    changed = cvtColor2(video_image(encoding), encoding, f"{target}8")
    expected = [LUMA_OF_VIDEO] if target == "mono" else in_order(target)
    np.testing.assert_allclose(changed, plain(expected), atol=2)
    assert changed.flags.c_contiguous


def test_nv24_has_chroma_for_each_pixel() -> None:
    """Unlike NV12, whose 2 by 2 pixels have the same."""
    rng = np.random.default_rng(2)
    nv24 = rng.integers(0, 256, (12, 7)).astype(np.uint8)
    changed = cvtColor2(nv24, "nv24", "rgb8")
    assert changed.shape == (4, 7, 3)
    pairs = nv24[4:].reshape(4, 7, 2)
    for row, column in np.ndindex(4, 7):
        nv12 = np.full((3, 2), nv24[row, column], np.uint8)
        nv12[2] = pairs[row, column]
        (expected, _), _ = cv2.cvtColor(nv12, cv2.COLOR_YUV2RGB_NV12)
        np.testing.assert_array_equal(changed[row, column], expected)
    np.testing.assert_array_equal(cvtColor2(nv24, "nv24", "mono8"), nv24[:4])


def test_a_part_of_an_image_that_is_no_block_is_converted() -> None:
    image = np.random.default_rng(1).integers(0, 256, (9, 9, 3)).astype(np.uint8)
    np.testing.assert_array_equal(cvtColor2(image[::-2, ::2], "bgr8", "rgb8"), image[::-2, ::2, ::-1])


def test_an_empty_image_is_refused() -> None:
    with pytest.raises(ImageError, match=r"OpenCV cannot convert an image of shape \(0, 4, 3\)"):
        cvtColor2(np.zeros((0, 4, 3), np.uint8), "bgr8", "rgb8")


def test_changes_of_type_as_opencv_has_them() -> None:
    """`normalize` by a scale of one is how Python reaches OpenCV's change of type."""
    depths = {"8U": "u1", "8S": "i1", "16U": "u2", "16S": "i2", "32S": "i4", "32F": "f4", "64F": "f8"}
    rng = np.random.default_rng(4)
    for source, target in permutations(depths, 2):
        numbers = np.concatenate([rng.normal(0, 3e4, 400), rng.normal(0, 100, 400), np.arange(-40, 40) / 2])
        image = saturate(numbers, np.dtype(depths[source])).reshape(1, -1)
        largest = float(np.abs(image.astype(float)).max())
        expected = cv2.normalize(image, None, largest, 0, cv2.NORM_INF, getattr(cv2, f"CV_{target}"))
        np.testing.assert_array_equal(
            saturate(image, np.dtype(depths[target])), expected, f"{source} to {target}"
        )


@pytest.mark.parametrize(
    ("name", "number"),
    [
        ("mono8", cv2.CV_8UC1),
        ("bgr8", cv2.CV_8UC3),
        ("rgba16", cv2.CV_16UC4),
        ("yuv422_yuy2", cv2.CV_8UC2),
        ("bayer_gbrg16", cv2.CV_16UC1),
        ("nv21", cv2.CV_8UC1),
        ("8U", cv2.CV_8UC1),
        ("32FC1", cv2.CV_32FC1),
        ("64FC4", cv2.CV_64FC4),
        ("32SC40", cv2.CV_32SC(40)),
    ],
)
def test_numbers_of_types(name: str, number: int) -> None:
    assert getCvType(name) == number
    encoding = find_encoding(name)
    assert CV_MAT_CNWrap(number) == encoding.channels
    assert CV_MAT_DEPTHWrap(number) == number & 7


def test_a_mosaic_too_small_to_have_neighbours_is_black() -> None:
    assert not cvtColor2(np.full((2, 6), 9, np.uint8), "bayer_rggb8", "rgb8").any()


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


@pytest.mark.parametrize("name", ["", "8UC", "8UC0", "8UCx", "16FC1", "RGB8", "bgr8 "])
def test_an_unknown_encoding(name: str) -> None:
    with pytest.raises(RuntimeError) as caught:
        getCvType(name)
    assert str(caught.value) == f"Unrecognized image encoding [{name}]"
