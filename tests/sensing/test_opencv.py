"""OpenCV is used where it is installed, and named where it is missing; what needs none works without it."""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
from tests.conftest import run_to_end
from tests.sensing.test_camera_models import pinhole, stereo

import tfloom_sensing
from tfloom.interfaces.sensor_msgs.msg import CompressedImage
from tfloom_sensing.cv_bridge import CvBridge
from tfloom_sensing.image_conversion import cvtColor2
from tfloom_sensing.image_display import cvtColorForDisplay
from tfloom_sensing.opencv import load_opencv

MISSING = (
    "cv_bridge and image_geometry need OpenCV, which is not installed: pip install opencv-python-headless"
)
IMAGE = np.zeros((480, 640, 3), np.uint8)
NEEDS: dict[str, Callable[[], object]] = {
    "a conversion": lambda: cvtColor2(IMAGE, "bgr8", "mono8"),
    "a message": lambda: CvBridge().imgmsg_to_cv2(CvBridge().cv2_to_imgmsg(IMAGE, "bgr8"), "rgb8"),
    "a file that is read": lambda: CvBridge().compressed_imgmsg_to_cv2(CompressedImage()),
    "a file that is written": lambda: CvBridge().cv2_to_compressed_imgmsg(IMAGE),
    "the number of a type": lambda: CvBridge().encoding_to_cvtype2("bgr8"),
    "a colormap": lambda: cvtColorForDisplay(IMAGE[..., 0], "8UC1", "bgr8", False, 0.0, 9.0, 2),
    "a rectified image": lambda: pinhole().rectify_image(IMAGE, IMAGE.copy()),
    "a rectified point": lambda: pinhole().rectify_point((1, 2)),
}


def test_the_installed_opencv_is_used() -> None:
    assert load_opencv() is cv2


@pytest.mark.parametrize("use", NEEDS)
@pytest.mark.usefixtures("without_opencv")
def test_what_needs_opencv_says_so(use: str) -> None:
    with pytest.raises(ModuleNotFoundError) as caught:
        NEEDS[use]()
    assert (str(caught.value), caught.value.name) == (MISSING, "cv2")


@pytest.mark.usefixtures("without_opencv")
def test_what_needs_no_opencv_works_without_it() -> None:
    bridge = CvBridge()
    for wanted in ("passthrough", "bgr8", "8UC3"):
        image = bridge.imgmsg_to_cv2(bridge.cv2_to_imgmsg(IMAGE, "bgr8"), wanted)
        np.testing.assert_array_equal(image, IMAGE)
    assert bridge.imgmsg_to_cv2(bridge.cv2_to_imgmsg(IMAGE[..., 0]), "32FC1").dtype == np.float32
    camera = pinhole()
    assert camera.project_3d_to_pixel((0, 0, 2)) == (camera.cx(), camera.cy())
    assert stereo().get_z(stereo().get_disparity(1.5)) == pytest.approx(1.5)


def test_an_opencv_that_lacks_a_library_is_told(tmp_path: Path) -> None:
    (tmp_path / "cv2.py").write_text("raise ImportError('libGL.so.1: cannot open shared object file')\n")
    code = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n"
        "import cv_bridge\n"
        "cv_bridge.CvBridge().encoding_to_cvtype2('bgr8')"
    )
    result = run_to_end([sys.executable, "-c", code])
    assert result.stderr.endswith(
        "ImportError: the installed OpenCV cannot be imported: libGL.so.1: cannot open shared object file; "
        "opencv-python-headless needs no libraries of a display\n"
    )


def test_libraries_are_imported_by_one_file_each() -> None:
    house = Path(tfloom_sensing.__file__).parent
    found = set()
    for path in house.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            found |= {(name.partition(".")[0], path.name) for name in names}
    known = sys.stdlib_module_names | {"numpy", "tfloom", "tfloom_sensing"}
    assert {(name, file) for name, file in found if name not in known} == {
        ("cv2", "opencv.py"),
        ("PIL", "image_display.py"),
    }
