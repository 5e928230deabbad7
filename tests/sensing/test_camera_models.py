"""Camera models: the geometry, what lenses do, and each name of the package."""

from __future__ import annotations

import math
import re
from typing import Any

import cv2
import image_geometry
import image_geometry.cameramodels
import numpy as np
import pytest

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, RegionOfInterest
from tfloom.interfaces.std_msgs.msg import Header
from tfloom_sensing.pinhole_camera_model import PinholeCameraModel, mkmat
from tfloom_sensing.stereo_camera_model import StereoCameraModel


def camera_info(**changes: Any) -> CameraInfo:
    """Return the parameters of a camera of 640 by 480 pixels."""
    fields: dict[str, Any] = {
        "header": Header(frame_id="left_optical", stamp=Time(sec=3)),
        "width": 640,
        "height": 480,
        "distortion_model": "plumb_bob",
        "d": [-0.363528858080088, 0.16117037733986861, -8.1109585007538829e-05, -0.00044776712298447841, 0.0],
        "k": [430.15433020105519, 0, 311.71339830549732, 0, 430.60920415473657, 221.06824942698509, 0, 0, 1],
        "r": np.eye(3).ravel(),
        "p": [
            295.53402059708782,
            0,
            285.55760765075684,
            0,
            0,
            295.53402059708782,
            223.29617881774902,
            0,
            0,
            0,
            1,
            0,
        ],
    }
    return CameraInfo(**fields | changes)


def right_info() -> CameraInfo:
    """Return a camera like `camera_info`, 0.1 m to the right."""
    info = camera_info()
    p = np.array(info.p)
    p[3] = -0.1 * p[0]
    info.p = p
    return info


def pinhole(**changes: Any) -> PinholeCameraModel:
    camera = PinholeCameraModel()
    camera.from_camera_info(camera_info(**changes))
    return camera


def stereo() -> StereoCameraModel:
    cameras = StereoCameraModel()
    cameras.from_camera_info(camera_info(), right_info())
    return cameras


D = {
    "none": [],
    "four": [-0.3, 0.1, 0.001, -0.002],
    "plumb_bob": [-0.3, 0.1, 0.001, -0.002, 0.01],
    "rational_polynomial": [0.3, 0.1, 0.001, -0.002, 0.01, 0.6, 0.2, 0.05],
    "thin_prism": [-0.3, 0.1, 0.001, -0.002, 0.01, 0.1, 0.02, 0.003, 0.001, 0.002, -0.001, 0.0005],
    "tilted": [-0.3, 0.1, 0.001, -0.002, 0.01, 0.1, 0.02, 0.003, 0.001, 0.002, -0.001, 0.0005, 0.02, -0.03],
    "equidistant": [-0.02, 0.01, -0.003, 0.001],
}
"""Coefficients of each distortion model."""


def through_lens(model: str, ray: tuple[float, float, float]) -> tuple[float, float]:
    """Return the raw pixel of a ray of the camera, by the projection of OpenCV that rectification doesn't use."""
    k, still = np.reshape(camera_info().k, (3, 3)), np.zeros(3)
    if model == "equidistant":
        pixel, _ = cv2.fisheye.projectPoints(np.array([[ray]]), still, still, k, np.array(D[model]))
    else:
        pixel, _ = cv2.projectPoints(np.array([ray]), still, still, k, np.array(D[model] or [0.0] * 4))
    return float(pixel[0, 0, 0]), float(pixel[0, 0, 1])


@pytest.mark.parametrize("model", D)
def test_a_point_through_the_lens_is_rectified(model: str) -> None:
    camera = pinhole(d=D[model], distortion_model=model)
    ray = (0.12, -0.08, 1.0)
    pixel = through_lens(model, ray)
    assert camera.rectify_point(pixel) == pytest.approx(camera.project_3d_to_pixel(ray), abs=0.01)
    is_bent = camera.project_3d_to_pixel(ray) != pytest.approx(pinhole(d=[]).rectify_point(pixel), abs=0.01)
    assert is_bent == (model != "none")


@pytest.mark.parametrize("model", D)
@pytest.mark.parametrize("channels", [(), (1,), (3,)])
def test_a_spot_seen_through_the_lens_is_rectified(model: str, channels: tuple[int, ...]) -> None:
    """A bright spot of the raw image is where the ray through the lens is on the rectified image."""
    camera = pinhole(d=D[model], distortion_model=model)
    ray = (0.3, -0.2, 1.0)
    u, v = through_lens(model, ray)
    rows, columns = np.mgrid[:480, :640]
    spot = 250 * np.exp(-((columns - u) ** 2 + (rows - v) ** 2) / 50)
    raw = np.zeros((480, 640, *channels), np.uint8)
    raw[...] = spot.reshape(480, 640, *(1 for _ in channels))
    for _ in range(2):  # the second time with the maps of the first
        rectified = np.zeros_like(raw)
        camera.rectify_image(raw, rectified)
        row, column = np.unravel_index(rectified.reshape(480, 640, -1)[..., 0].argmax(), (480, 640))
        assert (column, row) == pytest.approx(camera.project_3d_to_pixel(ray), abs=1.5)
    assert camera.mapx is not None
    camera.from_camera_info(camera_info())
    assert camera.mapx is None


def test_a_part_of_an_image_that_is_no_block_is_rectified() -> None:
    camera = pinhole()
    raw = np.random.default_rng(1).integers(0, 256, (480, 1280, 3)).astype(np.uint8)
    of_part, of_copy = np.zeros((2, 480, 640, 3), np.uint8)
    camera.rectify_image(raw[:, ::-2], of_part)
    camera.rectify_image(raw[:, ::-2].copy(), of_copy)
    np.testing.assert_array_equal(of_part, of_copy)


@pytest.mark.parametrize(
    ("model", "number", "text"),
    [
        ("plumb_bob", 3, "a distortion has 4, 5, 8, 12 or 14 coefficients, or none, not 3"),
        ("equidistant", 5, "an equidistant lens has 4 coefficients, not 5"),
    ],
)
def test_a_wrong_number_of_coefficients(model: str, number: int, text: str) -> None:
    camera = pinhole(d=[0.0] * number, distortion_model=model)
    image = np.zeros((480, 640), np.uint8)
    for call in (lambda: camera.rectify_point((1, 2)), lambda: camera.rectify_image(image, image.copy())):
        with pytest.raises(ValueError, match=text):
            call()


def test_an_equidistant_lens_without_coefficients() -> None:
    camera = pinhole(d=[], distortion_model="equidistant")
    angle = math.atan(0.5)
    k = camera.intrinsic_matrix()
    assert k is not None
    raw = (k[0, 2] + k[0, 0] * angle, k[1, 2])
    assert camera.rectify_point(raw) == pytest.approx(camera.project_3d_to_pixel((0.5, 0, 1)), abs=0.01)


def test_pixels_and_points() -> None:
    camera = pinhole()
    assert camera.project_3d_to_pixel((0, 0, 2)) == (camera.cx(), camera.cy())
    u, v = camera.project_3d_to_pixel((0.2, -0.1, 1.5))
    x, y, z = camera.project_pixel_to_3d_ray((u, v))
    assert math.hypot(x, y, z) == pytest.approx(1)
    assert (x / z * 1.5, y / z * 1.5) == pytest.approx((0.2, -0.1))
    assert all(math.isnan(coordinate) for coordinate in camera.project_3d_to_pixel((1, 1, 0)))
    assert camera.get_delta_x(camera.get_delta_u(0.3, 2.0), 2.0) == pytest.approx(0.3)
    assert camera.get_delta_y(camera.get_delta_v(0.3, 2.0), 2.0) == pytest.approx(0.3)
    assert camera.get_delta_u(1.0, 0) == camera.get_delta_v(1.0, 0) == math.inf


def test_what_a_camera_says() -> None:
    camera = pinhole()
    info = camera_info()
    assert camera.full_resolution() == (640, 480)
    assert (camera.fx(), camera.fy(), camera.cx(), camera.cy()) == (
        info.p[0],
        info.p[5],
        info.p[2],
        info.p[6],
    )
    assert (camera.tx(), camera.ty()) == (0, 0)
    assert camera.fov_x() == pytest.approx(2 * math.atan(640 / 2 / info.p[0]))
    assert camera.fov_y() == pytest.approx(2 * math.atan(480 / 2 / info.p[5]))
    assert camera.get_tf_frame() == "left_optical"
    np.testing.assert_array_equal(camera.intrinsic_matrix(), np.reshape(info.k, (3, 3)))
    np.testing.assert_array_equal(camera.full_intrinsic_matrix(), np.reshape(info.k, (3, 3)))
    np.testing.assert_array_equal(camera.projection_matrix(), np.reshape(info.p, (3, 4)))
    np.testing.assert_array_equal(camera.full_projection_matrix(), np.reshape(info.p, (3, 4)))
    np.testing.assert_array_equal(camera.rotation_matrix(), np.eye(3))
    np.testing.assert_array_equal(camera.distortion_coeffs(), np.reshape(info.d, (5, 1)))
    assert pinhole(d=[]).distortion_coeffs() is None


def test_binning_and_a_region_of_interest() -> None:
    roi = RegionOfInterest(x_offset=100, y_offset=50, width=200, height=100)
    camera, whole = pinhole(binning_x=2, binning_y=4, roi=roi), pinhole()
    assert (camera.fx(), camera.fy()) == (whole.fx() / 2, whole.fy() / 4)
    assert (camera.cx(), camera.cy()) == ((whole.cx() - 100) / 2, (whole.cy() - 50) / 4)
    assert camera.intrinsic_matrix()[0, 2] == (whole.intrinsic_matrix()[0, 2] - 100) / 2
    np.testing.assert_array_equal(camera.full_projection_matrix(), whole.projection_matrix())


def test_before_the_first_message() -> None:
    camera = PinholeCameraModel()
    assert camera.intrinsic_matrix() is camera.full_resolution() is camera.get_tf_frame() is None
    for call in (camera.fx, lambda: camera.rectify_point((1, 2)), camera.fov_x):
        with pytest.raises(ValueError, match="there is no camera yet; call from_camera_info first"):
            call()
    with pytest.raises(ValueError, match="there are no cameras yet; call from_camera_info first"):
        StereoCameraModel().project_pixel_to_3d((1, 2), 3)


def test_an_image_of_another_shape() -> None:
    with pytest.raises(ValueError, match=r"is uint8 \(480, 640, 3\), not uint8 \(480, 640\)"):
        pinhole().rectify_image(np.zeros((480, 640, 3), np.uint8), np.zeros((480, 640), np.uint8))


def test_two_cameras() -> None:
    cameras = stereo()
    left, right = cameras.project_3d_to_pixel((0.2, -0.1, 1.5))
    assert left[1] == right[1]
    disparity = left[0] - right[0]
    assert cameras.project_pixel_to_3d(left, disparity) == pytest.approx((0.2, -0.1, 1.5))
    assert cameras.project_pixel_to_3d(left, 0) == (0.0, 0.0, 0.0)
    assert cameras.get_z(disparity) == pytest.approx(1.5)
    assert cameras.get_disparity(1.5) == pytest.approx(disparity)
    assert cameras.get_z(0) == cameras.get_disparity(0) == math.inf
    assert cameras.get_tf_frame() == "left_optical"
    assert cameras.get_left_camera().tx() == 0
    assert cameras.get_right_camera().tx() == pytest.approx(-0.1 * cameras.get_right_camera().fx())


def test_two_left_cameras() -> None:
    with pytest.raises(ValueError, match=r"no baseline: P\[0, 3\] is 0"):
        StereoCameraModel().from_camera_info(camera_info(), camera_info())


OLD_CALLS: dict[str, tuple[str, tuple[Any, ...]]] = {
    "fovX": ("fov_x", ()),
    "fovY": ("fov_y", ()),
    "fullResolution": ("full_resolution", ()),
    "getDeltaU": ("get_delta_u", (1.0, 2.0)),
    "getDeltaV": ("get_delta_v", (1.0, 2.0)),
    "getDeltaX": ("get_delta_x", (1.0, 2.0)),
    "getDeltaY": ("get_delta_y", (1.0, 2.0)),
    "project3dToPixel": ("project_3d_to_pixel", ((1, 2, 3),)),
    "projectPixelTo3dRay": ("project_pixel_to_3d_ray", ((1, 2),)),
    "tfFrame": ("get_tf_frame", ()),
    "Tx": ("tx", ()),
    "Ty": ("ty", ()),
}
OLD_MATRICES = {
    "distortionCoeffs": "distortion_coeffs",
    "fullIntrinsicMatrix": "full_intrinsic_matrix",
    "fullProjectionMatrix": "full_projection_matrix",
    "intrinsicMatrix": "intrinsic_matrix",
    "projectionMatrix": "projection_matrix",
    "rotationMatrix": "rotation_matrix",
}
OLD_PROPERTIES = {
    "D": "distortion_coeffs",
    "full_K": "full_intrinsic_matrix",
    "full_P": "full_projection_matrix",
    "K": "intrinsic_matrix",
    "P": "projection_matrix",
    "R": "rotation_matrix",
}
OLD_VALUES = {
    "binning_x": 1,
    "binning_y": 1,
    "height": 480,
    "width": 640,
    "tf_frame": "left_optical",
    "stamp": Time(sec=3),
}


@pytest.mark.parametrize("old", OLD_CALLS)
def test_old_methods(old: str) -> None:
    camera = pinhole()
    new, arguments = OLD_CALLS[old]
    reason = (
        f"The {old}() method is deprecated as of J-turtle, and will be removed in K-turtle. "
        f"Please use the {new}() method instead."
    )
    with pytest.warns(DeprecationWarning, match=re.escape(reason)) as warned:
        value = getattr(camera, old)(*arguments)
    assert [str(warning.message) for warning in warned] == [
        f"Call to deprecated method {old}. ({reason}) -- Deprecated since version J-turtle."
    ]
    assert warned[0].filename == __file__
    assert value == getattr(camera, new)(*arguments)


@pytest.mark.filterwarnings("ignore::PendingDeprecationWarning")
@pytest.mark.parametrize("old", [*OLD_MATRICES, *OLD_PROPERTIES])
def test_old_matrices(old: str) -> None:
    camera = pinhole()
    new = (OLD_MATRICES | OLD_PROPERTIES)[old]
    what = f"{old}()->numpy.matrix method" if old in OLD_MATRICES else f"{old}->numpy.matrix property"
    text = (
        f"Call to deprecated method {old}. (The {what} is deprecated as of J-turtle, and will be removed in K-turtle. "
        f"Please use the {new}()->numpy.ndarray method instead.) -- Deprecated since version J-turtle."
    )
    with pytest.warns(DeprecationWarning, match=f"^{re.escape(text)}$"):
        value = getattr(camera, old)() if old in OLD_MATRICES else getattr(camera, old)
    assert type(value) is np.matrix
    np.testing.assert_array_equal(value, getattr(camera, new)())


@pytest.mark.parametrize("old", OLD_VALUES)
def test_old_values(old: str) -> None:
    with pytest.warns(DeprecationWarning, match=f"The {old} property is deprecated as of J-turtle"):
        assert getattr(pinhole(), old) == OLD_VALUES[old]


def test_other_old_names() -> None:
    camera, cameras = PinholeCameraModel(), StereoCameraModel()
    with pytest.warns(DeprecationWarning, match=r"use the from_camera_info\(\) method"):
        camera.fromCameraInfo(camera_info())
    with pytest.warns(DeprecationWarning, match="It is not meant to be an exposed member"):
        assert (camera.raw_roi.width, camera.raw_roi.height) == (640, 480)
    with pytest.warns(DeprecationWarning, match=r"use the rectify_point\(\) method"):
        np.testing.assert_array_equal(camera.rectifyPoint((9, 8)), camera.rectify_point((9, 8)))
    rectified = np.zeros((480, 640), np.uint8)
    with pytest.warns(DeprecationWarning, match=r"use the rectify_image\(\) method"):
        camera.rectifyImage(np.full((480, 640), 9, np.uint8), rectified)
    assert rectified[240, 320] == 9
    with pytest.warns(DeprecationWarning, match=r"use the from_camera_info\(\) method"):
        cameras.fromCameraInfo(camera_info(), right_info())
    with pytest.warns(DeprecationWarning, match=r"use the get_left_camera\(\) method"):
        assert cameras.left is cameras.get_left_camera()
    with pytest.warns(DeprecationWarning, match=r"use the get_right_camera\(\) method"):
        assert cameras.right is cameras.get_right_camera()
    with pytest.warns(DeprecationWarning, match="The Q property"):
        assert cameras.Q[3, 2] == pytest.approx(10)
    for old, new, arguments in (
        ("getDisparity", "get_disparity", (2.0,)),
        ("getZ", "get_z", (2.0,)),
        ("project3dToPixel", "project_3d_to_pixel", ((1, 2, 3),)),
        ("projectPixelTo3d", "project_pixel_to_3d", ((1, 2), 3)),
        ("tfFrame", "get_tf_frame", ()),
    ):
        with pytest.warns(DeprecationWarning, match=rf"use the {new}\(\) method"):
            assert getattr(cameras, old)(*arguments) == getattr(cameras, new)(*arguments)


def test_the_package_hands_on() -> None:
    models = image_geometry.cameramodels
    assert image_geometry.PinholeCameraModel is models.PinholeCameraModel is PinholeCameraModel
    assert image_geometry.StereoCameraModel is models.StereoCameraModel is StereoCameraModel
    assert models.mkmat(2, 3, [1, 2]).tolist() == mkmat(2, 3, [1, 2]).tolist() == [[1, 2, 0], [0, 0, 0]]
