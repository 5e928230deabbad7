"""What OpenCV answered, `tests/golden/opencv.npz`: `python -m tests.sensing.opencv_golden` records it anew.

It takes OpenCV 4, which ROS 2 Jazzy has, and no newer: OpenCV 5 resamples by other arithmetic.
"""

from __future__ import annotations

from itertools import permutations
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

GOLDEN = Path(__file__).parents[1] / "golden" / "opencv.npz"

Array = NDArray[Any]
Recorded = dict[str, Array]

_CV_NAMES = {"mono": "GRAY", "rgb": "RGB", "bgr": "BGR", "rgba": "RGBA", "bgra": "BGRA"}
_BAYER = {"rggb": "BG", "bggr": "RG", "gbrg": "GR", "grbg": "GB"}
_YUV = {
    "yuv422": "UYVY",
    "uyvy": "UYVY",
    "yuv422_yuy2": "YUY2",
    "yuyv": "YUY2",
    "nv12": "NV12",
    "nv21": "NV21",
}


class Conversion(NamedTuple):
    """A conversion and OpenCV's code for it."""

    source: str
    target: str
    code: str


def _conversions() -> list[Conversion]:
    found = []
    for bits in (8, 16):
        found += [
            Conversion(f"{a}{bits}", f"{b}{bits}", f"COLOR_{_CV_NAMES[a]}2{_CV_NAMES[b]}")
            for a, b in permutations(_CV_NAMES, 2)
        ]
        found += [
            Conversion(f"bayer_{mosaic}{bits}", f"{name}{bits}", f"COLOR_Bayer{cv_name}2{_CV_NAMES[name]}")
            for mosaic, cv_name in _BAYER.items()
            for name in ("mono", "rgb", "bgr")
        ]
    found += [
        Conversion(
            yuv,
            f"{name}8",
            f"COLOR_YUV2{_CV_NAMES[name]}_{cv_name if name != 'mono' else cv_name.replace('NV12', 'NV21')}",
        )
        for yuv, cv_name in _YUV.items()
        for name in _CV_NAMES
    ]
    return found


CONVERSIONS = _conversions()
SHAPES = {
    "yuv422": (12, 18, 2),
    "uyvy": (12, 18, 2),
    "yuv422_yuy2": (12, 18, 2),
    "yuyv": (12, 18, 2),
    "nv12": (18, 18),
    "nv21": (18, 18),
}

CAMERA = np.array([[21.5, 0, 15.3], [0, 21.6, 11.4], [0, 0, 1]])
PROJECTION = np.array([[19.1, 0, 16.3, 0], [0, 19.1, 12.2, 0], [0, 0, 1, 0.0]])
ROTATION_VECTOR = (0.02, -0.03, 0.01)
SIZE = (32, 24)
DISTORTIONS: dict[str, list[float]] = {
    "none": [],
    "four": [-0.3, 0.1, 0.001, -0.002],
    "plumb_bob": [-0.3, 0.1, 0.001, -0.002, 0.01],
    "rational_polynomial": [0.3, 0.1, 0.001, -0.002, 0.01, 0.6, 0.2, 0.05],
    "thin_prism": [-0.3, 0.1, 0.001, -0.002, 0.01, 0.1, 0.02, 0.003, 0.001, 0.002, -0.001, 0.0005],
    "tilted": [-0.3, 0.1, 0.001, -0.002, 0.01, 0.1, 0.02, 0.003, 0.001, 0.002, -0.001, 0.0005, 0.02, -0.03],
}
FISHEYE = [-0.02, 0.01, -0.003, 0.001]
REMAPPED = ("plumb_bob", "rational_polynomial")
RAW_TYPES = {"u1": (np.uint8, ()), "u1x3": (np.uint8, (3,)), "u2": (np.uint16, ()), "f4": (np.float32, ())}
FILES = ("jpg", "png", "bmp", "tif", "ppm")


def recorded() -> Recorded:
    """Return all that was recorded, by name."""
    with np.load(GOLDEN) as file:
        return dict(file)


def random_image(source: str, rng: np.random.Generator, shape: tuple[int, ...] = (12, 19)) -> Array:
    """Return an image of an encoding."""
    sixteen = source.endswith("16")
    base = source.removesuffix("16").removesuffix("8")
    channels = () if base == "mono" or base.startswith("bayer") else (len(base),)
    shape = SHAPES.get(source, (*shape, *channels))
    return rng.integers(0, 1 << (16 if sixteen else 8), shape).astype(np.uint16 if sixteen else np.uint8)


def record(cv2: Any) -> Recorded:
    """Return inputs, and what OpenCV makes of them."""
    rng = np.random.default_rng(20)
    found: Recorded = {"version": np.array(cv2.__version__)}
    for source, target, code in CONVERSIONS:
        image = found.setdefault(f"image {source}", random_image(source, rng))
        found[f"{source} to {target}"] = cv2.cvtColor(image, getattr(cv2, code))
    rotation = cv2.Rodrigues(np.array(ROTATION_VECTOR))[0]
    found["rotation"] = rotation
    found["points"] = rng.uniform(0, 24, (20, 2))
    for name, (dtype, channels) in RAW_TYPES.items():
        found[f"raw {name}"] = rng.integers(
            0, 255 if dtype is np.uint8 else 30000, (24, 32, *channels)
        ).astype(dtype)
    for model, coefficients in DISTORTIONS.items():
        d = np.array(coefficients) if coefficients else None
        maps = cv2.initUndistortRectifyMap(CAMERA, d, rotation, PROJECTION, SIZE, cv2.CV_32FC1)
        found[f"{model} columns"], found[f"{model} rows"] = maps
        points = cv2.undistortPoints(found["points"][:, None], CAMERA, d, R=rotation, P=PROJECTION)
        found[f"{model} points"] = points[:, 0]
        for name in RAW_TYPES if model in REMAPPED else ():
            found[f"{model} {name}"] = cv2.remap(found[f"raw {name}"], *maps, cv2.INTER_CUBIC)
    fisheye = np.array(FISHEYE)
    maps = cv2.fisheye.initUndistortRectifyMap(CAMERA, fisheye, rotation, PROJECTION, SIZE, cv2.CV_32FC1)
    found["equidistant columns"], found["equidistant rows"] = maps
    points = cv2.fisheye.undistortPoints(found["points"][:, None], CAMERA, fisheye, R=rotation, P=PROJECTION)
    found["equidistant points"] = points[:, 0]
    rows, columns = np.mgrid[:24, :32]
    smooth = np.stack([columns * 7, rows * 9, columns + rows * 3], -1).clip(0, 255).astype(np.uint8)
    for name, picture in (("color", smooth), ("gray", np.ascontiguousarray(smooth[..., 0]))):
        found[f"picture {name}"] = picture
        for ending in FILES:
            if (ending, name) == ("ppm", "gray"):
                continue
            octets = cv2.imencode(f".{ending}", picture)[1]
            found[f"file {name} {ending}"] = octets
            found[f"decoded {name} {ending}"] = cv2.imdecode(octets, cv2.IMREAD_UNCHANGED)
    return found


def main() -> None:
    """Record OpenCV's answers anew."""
    import cv2

    if not cv2.__version__.startswith("4."):
        raise SystemExit(f"record OpenCV 4, not {cv2.__version__}")
    np.savez_compressed(GOLDEN, **record(cv2))


if __name__ == "__main__":
    main()
