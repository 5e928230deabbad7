"""Larger images beside the OpenCV that is installed, of any version; its wheel is too large for each set-up."""

from __future__ import annotations

from itertools import permutations
from typing import Any

import numpy as np
import pytest
from tests.sensing.opencv_golden import (
    CAMERA,
    CONVERSIONS,
    DISTORTIONS,
    PROJECTION,
    ROTATION_VECTOR,
    random_image,
)

from tfloom.interfaces.sensor_msgs.msg import CameraInfo
from tfloom.sensing import cv_types
from tfloom.sensing.cv_bridge import CvBridge, CvBridgeError
from tfloom.sensing.image_conversion import cvtColor2, saturate
from tfloom.sensing.image_display import cvtColorForDisplay
from tfloom.sensing.image_files import decode_picture, encode_picture
from tfloom.sensing.lens import Distortion, rectification_maps
from tfloom.sensing.opencv import find_opencv
from tfloom.sensing.pinhole_camera_model import PinholeCameraModel
from tfloom.sensing.resampling import remap_cubic

pytestmark = pytest.mark.slow

DEPTHS = {"8U": "u1", "8S": "i1", "16U": "u2", "16S": "i2", "32S": "i4", "32F": "f4", "64F": "f8"}


@pytest.fixture(autouse=True)
def _opencv_is_found(cv2: Any) -> None:
    assert find_opencv() is cv2


def test_colors(cv2: Any) -> None:
    rng = np.random.default_rng()
    for source, target, code in CONVERSIONS:
        image = random_image(source, rng, (479, 641))
        expected = cv2.cvtColor(image, getattr(cv2, code))
        np.testing.assert_array_equal(cvtColor2(image, source, target), expected, f"{source} to {target}")


def test_small_mosaics(cv2: Any) -> None:
    rng = np.random.default_rng()
    for shape in ((2, 2), (2, 6), (3, 3), (3, 8), (4, 5)):
        image = rng.integers(0, 256, shape).astype(np.uint8)
        for target, name in (("rgb8", "RGB"), ("mono8", "GRAY")):
            expected = cv2.cvtColor(image, getattr(cv2, f"COLOR_BayerGB2{name}"))
            np.testing.assert_array_equal(cvtColor2(image, "bayer_grbg8", target), expected, str(shape))


def test_changes_of_type(cv2: Any) -> None:
    """`normalize` by a scale of one is how Python reaches OpenCV's change of type."""
    rng = np.random.default_rng()
    for source, target in permutations(DEPTHS, 2):
        numbers = np.concatenate([rng.normal(0, 3e4, 400), rng.normal(0, 100, 400), np.arange(-40, 40) / 2])
        image = saturate(numbers, np.dtype(DEPTHS[source])).reshape(1, -1)
        largest = float(np.abs(image.astype(float)).max())
        expected = cv2.normalize(image, None, largest, 0, cv2.NORM_INF, getattr(cv2, f"CV_{target}"))
        np.testing.assert_array_equal(
            saturate(image, np.dtype(DEPTHS[target])), expected, f"{source} to {target}"
        )


def test_numbers_of_types(cv2: Any) -> None:
    bridge = CvBridge()
    for depth in DEPTHS:
        for channels in range(1, 5):
            name = f"{depth}C{channels}"
            number = getattr(cv2, f"CV_{name}")
            assert cv_types.getCvType(name) == number
            assert bridge.cvtype_to_name[number] == name
            assert bridge.cvtype2_to_dtype_with_channels(number) == bridge.encoding_to_dtype_with_channels(
                name
            )


def test_files(cv2: Any) -> None:
    picture = np.random.default_rng().integers(0, 255, (40, 60, 3)).astype(np.uint8)
    for ending in ("jpg", "png", "tif"):
        octets = cv2.imencode(f".{ending}", picture)[1].tobytes()
        assert encode_picture(picture, ending) == octets
        np.testing.assert_array_equal(
            decode_picture(octets), cv2.imdecode(np.frombuffer(octets, np.uint8), cv2.IMREAD_UNCHANGED)
        )
    deep = (picture.astype(np.uint16) * 257)[..., ::-1]
    np.testing.assert_array_equal(decode_picture(encode_picture(deep, "png")), deep)
    bridge = CvBridge()
    for ending in ("doc", "pgm"):
        with pytest.raises(CvBridgeError, match=f"OpenCV cannot write uint8.*as '{ending}'"):
            bridge.cv2_to_compressed_imgmsg(picture, ending)
    message = bridge.cv2_to_compressed_imgmsg(picture)
    for data in (b"", bytes(100)):
        message.data = data
        with pytest.raises(CvBridgeError, match="not an image that OpenCV can read"):
            bridge.compressed_imgmsg_to_cv2(message)


def test_colormaps(cv2: Any) -> None:
    image = np.array([[0.0, 0.5, 1.0, np.nan]], np.float32)
    colored = cvtColorForDisplay(image, "32FC1", "bgr8", False, 0.0, 1.0, cv2.COLORMAP_JET)
    expected = cv2.applyColorMap(np.array([[0, 128, 255]], np.uint8), cv2.COLORMAP_JET)
    np.testing.assert_array_equal(colored[:, :3], expected)
    assert not colored[0, 3].any()


@pytest.mark.parametrize("model", DISTORTIONS)
def test_maps(cv2: Any, model: str) -> None:
    k, p = CAMERA * 20, PROJECTION * 20
    k[2, 2] = p[2, 2] = 1
    rotation = cv2.Rodrigues(np.array(ROTATION_VECTOR))[0]
    d = np.array(DISTORTIONS[model]) if DISTORTIONS[model] else None
    expected = cv2.initUndistortRectifyMap(k, d, rotation, p, (640, 480), cv2.CV_32FC1)
    maps = rectification_maps(k, Distortion(d), rotation, p, (640, 480))
    np.testing.assert_allclose(maps, expected, atol=1e-4, rtol=0)


@pytest.mark.parametrize("channels", [(), (1,), (3,), (4,)])
def test_resampling(cv2: Any, channels: tuple[int, ...]) -> None:
    if not cv2.__version__.startswith("4."):
        pytest.skip(
            f"OpenCV {cv2.__version__} resamples by other arithmetic than that of ROS 2 Jazzy, OpenCV 4"
        )
    rng = np.random.default_rng()
    image = rng.integers(0, 256, (480, 640, *channels)).astype(np.uint8)
    places = rng.uniform(-20, 660, (2, 300, 400)).astype(np.float32)
    expected = cv2.remap(image, *places, cv2.INTER_CUBIC).reshape(300, 400, *channels)
    np.testing.assert_array_equal(remap_cubic(image, *places), expected)


def test_a_rectified_image_is_that_of_opencv(cv2: Any) -> None:
    info = CameraInfo(width=32, height=24, k=CAMERA.ravel(), r=np.eye(3).ravel(), p=PROJECTION.ravel())
    info.d = DISTORTIONS["plumb_bob"]
    camera = PinholeCameraModel()
    camera.from_camera_info(info)
    for shape in ((24, 32), (24, 32, 1), (24, 32, 3)):
        raw = np.random.default_rng().integers(0, 256, shape).astype(np.uint8)
        rectified = np.zeros_like(raw)
        camera.rectify_image(raw, rectified)
        expected = cv2.remap(raw, camera.mapx, camera.mapy, cv2.INTER_CUBIC)
        np.testing.assert_array_equal(rectified, expected.reshape(shape))
