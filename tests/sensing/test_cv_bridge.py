"""CvBridge: each encoding there and back, padding, byte order, files; and each name of the package."""

from __future__ import annotations

import array
import sys

import cv2
import cv_bridge
import cv_bridge.boost.cv_bridge_boost
import cv_bridge.core
import numpy as np
import pytest
from numpy.typing import NDArray

from tfloom.interfaces.sensor_msgs.msg import CompressedImage, Image
from tfloom.interfaces.std_msgs.msg import Header
from tfloom_sensing.cv_bridge import CvBridge, CvBridgeError
from tfloom_sensing.image_encodings import find_encoding
from tfloom_sensing.image_files import encode_picture

COLORS = [f"{order}{bits}" for order in ("mono", "rgb", "bgr", "rgba", "bgra") for bits in (8, 16)]
BAYER = [f"bayer_{mosaic}{bits}" for mosaic in ("rggb", "bggr", "gbrg", "grbg") for bits in (8, 16)]
YUV = ["yuv422", "uyvy", "yuv422_yuy2", "yuyv", "nv12", "nv21", "nv24"]
NUMBERS = [
    f"{depth}C{channels}"
    for depth in ("8U", "8S", "16U", "16S", "32S", "32F", "64F")
    for channels in (1, 2, 3, 4, 5, 40)
]


def image_of(encoding: str, height: int = 4, width: int = 6) -> NDArray[np.generic]:
    """Return an image of random bytes."""
    found = find_encoding(encoding)
    rows = found.rows(height)
    content = np.random.default_rng(3).integers(0, 255, rows * width * found.channels * found.dtype.itemsize)
    image = content.astype(np.uint8).view(found.dtype).reshape(rows, width, found.channels)
    return image[..., 0] if found.channels == 1 else image


@pytest.mark.parametrize("encoding", COLORS + BAYER + YUV + NUMBERS)
def test_there_and_back(encoding: str) -> None:
    bridge = CvBridge()
    image = image_of(encoding)
    message = bridge.cv2_to_imgmsg(image, encoding, Header(frame_id="camera"))
    assert (message.height, message.width, message.encoding) == (4, 6, encoding)
    assert message.step * len(image) == len(message.data)
    assert message.header.frame_id == "camera"
    assert message.is_bigendian == (sys.byteorder == "big")
    back = bridge.imgmsg_to_cv2(message)
    assert (back.dtype, back.shape) == (image.dtype, image.shape)
    assert back.tobytes() == image.tobytes()
    assert bridge.imgmsg_to_cv2(message, encoding).tobytes() == image.tobytes()


@pytest.mark.parametrize("encoding", [*COLORS, *BAYER, *YUV, "32FC1", "16SC3", "64FC2"])
@pytest.mark.parametrize("order", ["little", "big"])
def test_padding_and_byte_order(encoding: str, order: str) -> None:
    found = find_encoding(encoding)
    image = image_of(encoding)
    swapped = image.astype(found.dtype.newbyteorder("<" if order == "little" else ">"))
    planes = [swapped[:4], swapped[4:].reshape(-1, 12)] if encoding == "nv24" else [swapped]
    data = array.array("B")
    for plane, padding in zip(planes, (3, 6), strict=False):
        for row in plane:
            data.frombytes(row.tobytes() + b"\xff" * padding)
    row_bytes = 6 * found.channels * found.dtype.itemsize
    message = Image(
        height=4, width=6, encoding=encoding, step=row_bytes + 3, is_bigendian=int(order == "big"), data=data
    )
    back = CvBridge().imgmsg_to_cv2(message)
    assert back.dtype.isnative
    np.testing.assert_array_equal(
        back.view(f"u{found.dtype.itemsize}"), image.view(f"u{found.dtype.itemsize}")
    )


def test_a_big_endian_array_stays_so() -> None:
    image = np.arange(12, dtype=">i4").reshape(3, 4)
    message = CvBridge().cv2_to_imgmsg(image)
    assert (message.encoding, message.is_bigendian, bytes(message.data[:4])) == ("32SC1", 1, b"\0\0\0\0")
    assert bytes(message.data[4:8]) == b"\0\0\0\1"
    assert (CvBridge().imgmsg_to_cv2(message) == image).all()


def test_an_image_without_padding_is_a_view() -> None:
    message = CvBridge().cv2_to_imgmsg(np.zeros((2, 3, 3), np.uint8), "bgr8")
    CvBridge().imgmsg_to_cv2(message)[0, 0, 0] = 7
    assert message.data[0] == 7


def test_a_part_of_an_array_is_written_row_by_row() -> None:
    whole = np.arange(40, dtype=np.uint8).reshape(5, 8)
    message = CvBridge().cv2_to_imgmsg(whole[1:3, 2:5], "mono8")
    assert (message.height, message.width, message.step) == (2, 3, 3)
    assert list(message.data) == [10, 11, 12, 18, 19, 20]


def test_an_empty_image() -> None:
    message = CvBridge().cv2_to_imgmsg(np.zeros((0, 0), np.uint8))
    assert (message.height, message.width, message.step, len(message.data)) == (0, 0, 0, 0)
    assert CvBridge().imgmsg_to_cv2(message).shape == (0, 0)


def test_one_channel_of_three_dimensions() -> None:
    message = CvBridge().cv2_to_imgmsg(np.zeros((2, 3, 1), np.uint8))
    assert message.encoding == "8UC1"
    assert CvBridge().imgmsg_to_cv2(message).shape == (2, 3)


def test_conversions_of_messages() -> None:
    bridge = CvBridge()
    message = bridge.cv2_to_imgmsg(np.array([[[1, 2, 3]]], np.uint8), "rgb8")
    assert bridge.imgmsg_to_cv2(message, "bgr8").tolist() == [[[3, 2, 1]]]
    assert bridge.imgmsg_to_cv2(message, "mono16").tolist() == [[2 * 257]]
    with pytest.raises(CvBridgeError, match="is not a color format"):
        bridge.imgmsg_to_cv2(bridge.cv2_to_imgmsg(np.zeros((2, 2), np.uint16)), "bgr8")


def test_data_as_a_list_of_numbers() -> None:
    class Loose:
        height, width, step, is_bigendian, encoding, data = 1, 2, 2, 0, "mono8", [5, 6]

    assert CvBridge().imgmsg_to_cv2(Loose()).tolist() == [[5, 6]]


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        (
            {"step": 5},
            "Image is wrongly formed: step < width * byte_depth * num_channels  or  5 != 2 * 1 * 3",
        ),
        ({"height": 3}, "Image is wrongly formed: height * step != size  or  3 * 6 != 12"),
        ({"encoding": "purple"}, "Unrecognized image encoding [purple]"),
        ({"width": 2**32 - 1, "step": 2**32 - 1}, "Image is wrongly formed: step"),
        ({"height": 2**32 - 1, "step": 2**32 - 1}, "Image is wrongly formed: height"),
        ({"encoding": f"8UC{10**12}"}, "Image is wrongly formed: step"),
    ],
)
def test_messages_that_contradict_themselves(changes: dict[str, object], text: str) -> None:
    fields = {"height": 2, "width": 2, "step": 6, "encoding": "bgr8", "data": array.array("B", bytes(12))}
    with pytest.raises(CvBridgeError) as caught:
        CvBridge().imgmsg_to_cv2(Image(**fields | changes))
    assert str(caught.value).startswith(text)


@pytest.mark.parametrize(
    ("image", "encoding", "error", "text"),
    [
        ("text", "passthrough", TypeError, "Your input type is not a numpy array"),
        (
            np.zeros((2, 2), np.uint8),
            "bgr8",
            CvBridgeError,
            "encoding specified as bgr8, but image has incompatible type 8UC1",
        ),
        (np.zeros((2, 2), np.int64), "passthrough", CvBridgeError, "no encoding has pixels of int64"),
        (np.zeros(2, np.uint8), "passthrough", CvBridgeError, "an image has two or three dimensions"),
        (np.zeros((4, 4), np.uint8), "nv21", CvBridgeError, "multiple of 3 rows, not 4"),
        (np.zeros((2, 2), np.uint8), "purple", CvBridgeError, r"Unrecognized image encoding \[purple\]"),
    ],
)
def test_what_is_no_image_of_an_encoding(
    image: object, encoding: str, error: type[Exception], text: str
) -> None:
    with pytest.raises(error, match=text):
        CvBridge().cv2_to_imgmsg(image, encoding)


def test_types_and_their_names() -> None:
    bridge = CvBridge()
    for depth, name in (
        ("8U", "uint8"),
        ("8S", "int8"),
        ("16U", "uint16"),
        ("32S", "int32"),
        ("64F", "float64"),
    ):
        for channels in range(1, 5):
            encoding = f"{depth}C{channels}"
            number = getattr(cv2, f"CV_{encoding}")
            assert bridge.encoding_to_cvtype2(encoding) == number
            assert bridge.cvtype_to_name[number] == encoding
            assert bridge.cvtype2_to_dtype_with_channels(number) == (name, channels)
    assert bridge.encoding_to_cvtype2("bgr8") == cv2.CV_8UC3
    assert bridge.encoding_to_dtype_with_channels("32FC7") == ("float32", 7)
    assert bridge.dtype_with_channels_to_cvtype2(np.dtype(np.int16), 2) == "16SC2"
    assert bridge.cvdepth_to_numpy_depth[5] == "float32"
    assert (bridge.numpy_type_to_cvtype["uint8"], bridge.numpy_type_to_cvtype["8U"]) == ("8U", "uint8")
    for call in (bridge.encoding_to_cvtype2, bridge.encoding_to_dtype_with_channels):
        with pytest.raises(CvBridgeError, match=r"Unrecognized image encoding \[purple\]"):
            call("purple")


@pytest.mark.parametrize("ending", ["jpg", "jpeg", "jpe", "png", "bmp", "dib", "jp2", "tif", "tiff", "webp"])
@pytest.mark.parametrize("shape", [(60, 90), (60, 90, 1), (60, 90, 3)])
def test_each_format(ending: str, shape: tuple[int, ...]) -> None:
    bridge = CvBridge()
    picture = np.full(shape, 100, np.uint8)
    if len(shape) == 3 and shape[2] == 3:
        picture[..., 0] = 160  # blue
    message = bridge.cv2_to_compressed_imgmsg(picture, ending)
    assert message.format == ending
    image = bridge.compressed_imgmsg_to_cv2(message, "bgr8")
    assert image.shape == (60, 90, 3)
    assert np.abs(image.astype(int) - picture.reshape(60, 90, -1)).max() <= 3


def test_files_of_16_bits_of_floats_and_of_four_channels() -> None:
    bridge = CvBridge()
    deep = np.arange(30, dtype=np.uint16).reshape(5, 6) * 2000
    images = {
        "png": deep,
        "tif": deep,
        "pgm": deep,
        "tiff": deep.astype(np.float32) / 7,
        "PNG": np.full((2, 3, 4), (1, 2, 3, 128), np.uint8),
    }
    for ending, image in images.items():
        back = bridge.compressed_imgmsg_to_cv2(bridge.cv2_to_compressed_imgmsg(image, ending.lower()))
        assert back.dtype == image.dtype
        np.testing.assert_array_equal(back, image, ending)


@pytest.mark.parametrize(
    ("image", "ending", "text"),
    [
        (np.zeros((2, 2), np.uint8), "doc", r"OpenCV cannot write uint8 \(2, 2\) as 'doc'"),
        (np.zeros((2, 2, 3), np.uint8), "pgm", r"OpenCV cannot write uint8 \(2, 2, 3\) as 'pgm'"),
        (np.zeros((2, 2, 2), np.uint8), "jpg", "it can store 1, 3 or 4 channels"),
        (np.zeros((0, 2), np.uint8), "jpg", "no file format stores an image of shape"),
    ],
)
def test_what_no_file_holds(image: NDArray[np.generic], ending: str, text: str) -> None:
    with pytest.raises(CvBridgeError, match=text):
        CvBridge().cv2_to_compressed_imgmsg(image, ending)


def test_broken_files_are_refused() -> None:
    """Each cut, and each of many changes of a byte, gives an image or a CvBridgeError."""
    rng = np.random.default_rng(9)
    picture = rng.integers(0, 255, (9, 9, 3)).astype(np.uint8)
    bridge = CvBridge()
    refused = 0
    for ending in ("png", "jpg", "bmp", "tif"):
        content = encode_picture(picture, ending)
        broken = [content[:end] for end in range(0, len(content), 37)]
        for _ in range(60):
            at = int(rng.integers(0, len(content)))
            broken.append(content[:at] + bytes([int(rng.integers(0, 255))]) + content[at + 1 :])
        for data in broken:
            message = CompressedImage(format=ending, data=array.array("B", data))
            try:
                assert bridge.compressed_imgmsg_to_cv2(message).size
            except CvBridgeError as error:
                assert "are not an image that OpenCV can read" in str(error)  # noqa: PT017  # either is right
                refused += 1
    assert refused > 10


def test_conversions_of_files() -> None:
    bridge = CvBridge()
    gray = bridge.cv2_to_compressed_imgmsg(np.full((2, 2), 9, np.uint8), "png")
    assert bridge.compressed_imgmsg_to_cv2(gray, "bgr8").tolist() == [[[9, 9, 9]] * 2] * 2
    deep = bridge.cv2_to_compressed_imgmsg(np.full((2, 2), 257, np.uint16), "png")
    assert bridge.compressed_imgmsg_to_cv2(deep, "mono8").tolist() == [[1, 1]] * 2
    color = bridge.cv2_to_compressed_imgmsg(np.full((1, 1, 3), (1, 2, 3), np.uint8), "png")
    assert bridge.compressed_imgmsg_to_cv2(color, "rgba8").tolist() == [[[3, 2, 1, 255]]]
    with pytest.raises(CvBridgeError, match="Unsupported conversion"):
        bridge.compressed_imgmsg_to_cv2(color, "yuv422")


def test_the_package_hands_on() -> None:
    assert cv_bridge.CvBridge is cv_bridge.core.CvBridge is CvBridge
    assert cv_bridge.CvBridgeError is cv_bridge.core.CvBridgeError is CvBridgeError
    assert issubclass(CvBridgeError, TypeError)
    compiled = cv_bridge.boost.cv_bridge_boost
    assert compiled.getCvType is cv_bridge.getCvType
    assert compiled.cvtColorForDisplay is cv_bridge.cvtColorForDisplay
    assert compiled.CV_MAT_CNWrap(0) == 1
    assert compiled.CV_MAT_DEPTHWrap(6) == 6
    assert compiled.cvtColor2(np.zeros((1, 1), np.uint8), "mono8", "bgr8").shape == (1, 1, 3)
