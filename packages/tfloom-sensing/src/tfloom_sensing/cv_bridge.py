"""Between image messages and arrays: cv_bridge's CvBridge."""

from __future__ import annotations

import sys
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom.interfaces.sensor_msgs.msg import CompressedImage, Image
from tfloom.interfaces.std_msgs.msg import Header
from tfloom_sensing.image_conversion import cvtColor2
from tfloom_sensing.image_encodings import Encoding, ImageError, find_encoding
from tfloom_sensing.image_files import decode_picture, encode_picture
from tfloom_sensing.opencv import DEPTHS, CV_MAT_CNWrap, CV_MAT_DEPTHWrap, cv_type, getCvType

__all__ = ["CvBridge", "CvBridgeError"]

Array = NDArray[Any]

_PASSTHROUGH = "passthrough"
_SHORT_NAMES = {
    "uint8": "8U",
    "int8": "8S",
    "uint16": "16U",
    "int16": "16S",
    "int32": "32S",
    "float32": "32F",
    "float64": "64F",
}


class CvBridgeError(TypeError):
    """An image cannot be converted."""


class CvBridge:
    """Converter between image messages and arrays, as OpenCV's functions take them.

    Colours and files are converted by OpenCV; an image in the message's own encoding is had without it.

    An array is (rows, columns), or (rows, columns, channels) for several channels. In planar formats the planes are
    below each other, as OpenCV takes them: an array of an `nv12` or `nv21` image has 3/2 of the image's rows, of an
    `nv24` image 3 times as many.
    """

    @cached_property
    def cvtype_to_name(self) -> dict[int, str]:
        """Names of OpenCV's types with one to four channels, as `8UC3`, by number."""
        return {
            cv_type(DEPTHS[depth], channels): f"{short}C{channels}"
            for depth, short in _SHORT_NAMES.items()
            for channels in range(1, 5)
        }

    @cached_property
    def cvdepth_to_numpy_depth(self) -> dict[int, str]:
        """Names in numpy of OpenCV's depths, as `uint8`, by number."""
        return {number: name for name, number in DEPTHS.items()}

    @cached_property
    def numpy_type_to_cvtype(self) -> dict[str, str]:
        """OpenCV's short names, as `8U`, by numpy's, as `uint8`, and vice versa."""
        return _SHORT_NAMES | {short: name for name, short in _SHORT_NAMES.items()}

    def dtype_with_channels_to_cvtype2(self, dtype: np.dtype[Any], n_channels: int) -> str:
        """Return the name of a pixel type: `8UC3` for three uint8.

        Raises:
            CvBridgeError: OpenCV does not have the type.
        """
        if dtype.name not in _SHORT_NAMES:
            raise CvBridgeError(
                f"no encoding has pixels of {dtype.name}, but only of {', '.join(_SHORT_NAMES)}"
            )
        return f"{_SHORT_NAMES[dtype.name]}C{n_channels}"

    def cvtype2_to_dtype_with_channels(self, cvtype: int) -> tuple[str, int]:
        """Return numpy's name of the values' type, and the number of channels, of an OpenCV type."""
        return self.cvdepth_to_numpy_depth[CV_MAT_DEPTHWrap(cvtype)], CV_MAT_CNWrap(cvtype)

    def encoding_to_cvtype2(self, encoding: str) -> int:
        """Return OpenCV's number for the pixels of an encoding: `cv2.CV_8UC3` for `bgr8`.

        Raises:
            CvBridgeError: there is no such encoding.
        """
        try:
            return getCvType(encoding)
        except ImageError as error:
            raise CvBridgeError(error) from None

    def encoding_to_dtype_with_channels(self, encoding: str) -> tuple[str, int]:
        """Return numpy's name of the values' type, and the number of channels, of an encoding: `uint8`, 3 for `bgr8`.

        Raises:
            CvBridgeError: there is no such encoding.
        """
        image_format = _find(encoding)
        return image_format.dtype.name, image_format.channels

    def imgmsg_to_cv2(self, img_msg: Image, desired_encoding: str = _PASSTHROUGH) -> Array:
        """Return the image of a message.

        Args:
            img_msg: The message. If it has no padding and this machine's byte order, the array with `passthrough` is a
                view of its data.
            desired_encoding: Encoding of the result; `passthrough`: the message's.

        Raises:
            CvBridgeError: the encoding is unknown, the message's sizes contradict each other, or the conversion is not
                supported.
            ImportError: OpenCV is not installed, and colours are to be converted.
        """
        encoding = _find(img_msg.encoding)
        image = _array_of(img_msg, encoding)
        if desired_encoding == _PASSTHROUGH:
            return image
        return _convert(image, img_msg.encoding, desired_encoding)

    def cv2_to_imgmsg(self, cvim: Array, encoding: str = _PASSTHROUGH, header: Header | None = None) -> Image:
        """Return an image as a message; the pixels are copied.

        Args:
            cvim: Image (rows, columns) or (rows, columns, channels).
            encoding: The array's encoding; nothing is converted. `passthrough`: a type without colours, as `8UC3`.
            header: Header of the message.

        Raises:
            TypeError: `cvim` is not an array.
            CvBridgeError: the encoding is unknown, or the array does not match it.
        """
        _check_array(cvim)
        cv_name = self.dtype_with_channels_to_cvtype2(cvim.dtype, cvim.shape[2] if cvim.ndim == 3 else 1)
        image_format = _find(cv_name if encoding == _PASSTHROUGH else encoding)
        if self.dtype_with_channels_to_cvtype2(image_format.dtype, image_format.channels) != cv_name:
            raise CvBridgeError(
                f"encoding specified as {encoding}, but image has incompatible type {cv_name}"
            )
        rows, width = cvim.shape[:2]
        try:
            height = image_format.height(rows)
        except ImageError as error:
            raise CvBridgeError(error) from None
        message = Image(height=height, width=width, encoding=image_format.name)
        if header is not None:
            message.header = header
        byte_order = cvim.dtype.byteorder
        message.is_bigendian = int(byte_order == ">" or (byte_order == "=" and sys.byteorder == "big"))
        message.data.frombytes(np.ascontiguousarray(cvim).data.cast("B") if cvim.size else b"")
        message.step = len(message.data) // rows if rows else 0
        return message

    def compressed_imgmsg_to_cv2(
        self, cmprs_img_msg: CompressedImage, desired_encoding: str = _PASSTHROUGH
    ) -> Array:
        """Return the image of a compressed message: grey, or with blue first, of uint8 or uint16.

        Args:
            cmprs_img_msg: The message; the data determines the file format.
            desired_encoding: Encoding of the result; `passthrough`: the image's.

        Raises:
            CvBridgeError: the data is not a readable image, or the conversion is not supported.
            ImportError: OpenCV is not installed.
        """
        try:
            image = decode_picture(bytes(cmprs_img_msg.data))
        except ImageError as error:
            raise CvBridgeError(error) from None
        if desired_encoding == _PASSTHROUGH:
            return image
        return _convert(image, self._encoding_of_picture(image), desired_encoding)

    def _encoding_of_picture(self, image: Array) -> str:
        """Return the encoding of a decoded image: `mono8`, `bgr8`, `bgra16` …, or a type without colours."""
        channels = image.shape[2] if image.ndim == 3 else 1
        color = {1: "mono", 3: "bgr", 4: "bgra"}.get(channels)
        if color is None or image.dtype not in (np.uint8, np.uint16):
            return self.dtype_with_channels_to_cvtype2(image.dtype, channels)
        return f"{color}{image.dtype.itemsize * 8}"

    def cv2_to_compressed_imgmsg(self, cvim: Array, dst_format: str = "jpg") -> CompressedImage:
        """Return an image as a compressed message.

        Args:
            cvim: Image (rows, columns), or (rows, columns, 1, 3 or 4) with blue first.
            dst_format: File name extension of the format: `jpg`, `png`, `tiff`, `bmp` …

        Raises:
            TypeError: `cvim` is not an array.
            CvBridgeError: the format is unknown, or cannot store the image.
            ImportError: OpenCV is not installed.
        """
        _check_array(cvim)
        message = CompressedImage(format=dst_format)
        try:
            message.data.frombytes(encode_picture(cvim, dst_format))
        except ImageError as error:
            raise CvBridgeError(error) from None
        return message


def _find(name: str) -> Encoding:
    try:
        return find_encoding(name)
    except ImageError as error:
        raise CvBridgeError(error) from None


def _convert(image: Array, encoding: str, wanted: str) -> Array:
    try:
        return cvtColor2(image, encoding, wanted)
    except ImageError as error:
        raise CvBridgeError(error) from None


def _check_array(image: Any) -> None:
    if not isinstance(image, np.ndarray):
        raise TypeError("Your input type is not a numpy array")
    if image.ndim not in {2, 3}:
        raise CvBridgeError(f"an image has two or three dimensions, not the shape {image.shape}")


def _array_of(message: Image, encoding: Encoding) -> Array:
    dtype = encoding.dtype.newbyteorder(">" if message.is_bigendian else "<")
    rows = encoding.rows(message.height)
    pixel = dtype.itemsize * encoding.channels
    if message.step < message.width * pixel:
        raise CvBridgeError(
            "Image is wrongly formed: step < width * byte_depth * num_channels  or  "
            f"{message.step} != {message.width} * {dtype.itemsize} * {encoding.channels}"
        )
    content = memoryview(bytes(message.data) if isinstance(message.data, list) else message.data).cast("B")
    if len(content) < rows * message.step:
        raise CvBridgeError(
            f"Image is wrongly formed: height * step != size  or  {rows} * {message.step} != {len(content)}"
        )
    image: Array = np.ndarray(
        (rows, message.width, encoding.channels),
        dtype,
        buffer=content,
        strides=(message.step, pixel, dtype.itemsize),
    )
    if encoding.channels == 1:
        image = image[..., 0]
    if encoding.name == "nv24" and message.step > message.width:
        # A row of chroma has two values for each pixel, and twice the padding.
        chroma: Array = np.ndarray(
            (message.height, 2 * message.width),
            dtype,
            buffer=content[message.height * message.step :],
            strides=(2 * message.step, 1),
        )
        image = np.concatenate([image[: message.height], chroma.reshape(-1, message.width)])
    return np.ascontiguousarray(image.astype(dtype.newbyteorder("="), copy=False))
