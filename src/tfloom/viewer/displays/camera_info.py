"""What a camera sees: a pyramid, with the camera's image at its far end."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.rosidl.message import DecodeError
from tfloom.viewer.displays.display import stamp_of
from tfloom.viewer.pictures import small_pixels
from tfloom.viewer.shapes import DisplayError, Lines, Picture, Placed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tfloom.viewer.displays.settings import Values
    from tfloom.viewer.topic_log import Entry

__all__ = ["INFO_TYPE", "CameraDisplay", "Pinhole", "images_of", "info_topic_of", "pinhole_of"]

FRUSTUM_M = 0.5
"""Length of a camera's pyramid [m]."""
BLUE = (80, 160, 255)
PICTURE_S = 0.2
"""Least time between two images that are drawn [s]: each is a new texture of all pages."""
MAX_SIDE_PX = 320
"""Longer sides of an image are reduced."""
NO_IMAGE = "no image"
INFO_TYPE = "sensor_msgs/msg/CameraInfo"


def images_of(topic: str, image_topics: Iterable[str]) -> list[str]:
    """Return which topics of images are of the camera that a `camera_info` topic is of: those beside it, in order."""
    beside = topic.rpartition("/")[0]
    return sorted(
        image for image in image_topics if image.removesuffix("/compressed").rpartition("/")[0] == beside
    )


def info_topic_of(image_topic: str) -> str:
    """Return the topic of the camera info of an image: the one beside it."""
    return f"{image_topic.rpartition('/')[0]}/camera_info"


class Pinhole(NamedTuple):
    """How a camera sees, without its distortion."""

    width: int
    height: int
    """[pixels]."""
    fx: float
    fy: float
    """Focal lengths [pixels]."""
    cx: float
    cy: float
    """Where the optical axis is [pixels]."""


def pinhole_of(info: Any) -> Pinhole:
    """Return how the camera of a `sensor_msgs/msg/CameraInfo` sees.

    Raises:
        DisplayError: it is not calibrated.
    """
    width, height = int(info.width), int(info.height)
    fx, _, cx, _, fy, cy = (float(number) for number in info.k[:6])
    is_finite = all(map(math.isfinite, (fx, fy, cx, cy)))
    if not (is_finite and fx > 0.0 and fy > 0.0 and width > 0 and height > 0):
        raise DisplayError("it is not calibrated: its focal lengths and sizes have to be above zero")
    return Pinhole(width, height, fx, fy, cx, cy)


class CameraDisplay:
    """Shows the last `sensor_msgs/msg/CameraInfo`, and an image of the camera that is shown, too."""

    keeps_all = False

    def __init__(self, settings: Values) -> None:
        self.settings = settings
        self.choices: Sequence[str] = ()
        """The camera's images, if some are shown."""
        self.choice = ""
        self._message: Any = None
        self._entry: Entry | None = None
        """The image that was drawn last."""
        self._pixels: NDArray[np.uint8] | None = None
        self._next_picture_s = 0.0
        self._corners = np.zeros((4, 3))
        self._lines: Lines | None = None
        """Kept while the calibration stays the same, because a page takes long to replace lines."""
        self._picture: Picture | None = None
        self._shapes: list[Placed] | None = None

    def take(self, message: Any, stamp_ns: int) -> None:  # the header's stamp counts
        """Take the calibration.

        Raises:
            DisplayError: it is none.
        """
        self._message = None
        corners = _corners(message)
        if self._lines is None or not np.array_equal(corners, self._corners):
            self._corners, self._lines, self._picture = corners, _pyramid(corners), None
        self._message, self._shapes = message, None

    def clear(self) -> None:
        """Forget the calibration."""
        self._message = self._shapes = None

    def offer(self, images: Sequence[str]) -> str:
        """Take which images of the camera are shown; return the one to draw, empty for none."""
        self.choices = (*images, NO_IMAGE) if images else ()
        if self.choice in self.choices:
            return "" if self.choice == NO_IMAGE else self.choice
        return images[0] if images else ""

    def set_image(self, entry: Entry | None) -> None:
        """Draw an image from now on; one that can't be drawn is none: its own display says why."""
        now_s = time.monotonic()
        if entry is self._entry or (entry is not None and now_s < self._next_picture_s):
            return
        self._entry, self._shapes, self._pixels, self._picture = entry, None, None, None
        if entry is None:
            return
        self._next_picture_s = now_s + PICTURE_S
        try:
            self._pixels = small_pixels(entry.message(), MAX_SIDE_PX)
        except (DisplayError, DecodeError):
            return

    def shapes(self, now_ns: int) -> list[Placed]:  # they stay until the next message
        """Return the pyramid, and the image."""
        if self._message is None or self._lines is None:
            return []
        if self._shapes is None:
            frame, stamp_ns = self._message.header.frame_id, stamp_of(self._message.header)
            self._shapes = [Placed(self._lines, frame, stamp_ns)]
            if self._pixels is not None:
                right, low = self._corners[2] - self._corners[0], self._corners[3]
                size = float(right[0]), float(right[1])
                self._picture = self._picture or Picture(self._pixels, size)
                at = float(low[0]), float(low[1]), float(low[2])
                # A picture's y axis is up, and a camera's is down: half a turn around x.
                self._shapes.append(Placed(self._picture, frame, stamp_ns, at, (1.0, 0.0, 0.0, 0.0)))
        return self._shapes


def _corners(message: Any) -> NDArray[np.float64]:
    """Return the corners of what the picture shows at half a metre (4, 3) [m]: its left upper one first, clockwise.

    Raises:
        DisplayError: it is not calibrated.
    """
    width, height, fx, fy, cx, cy = pinhole_of(message)
    corners = [
        ((u - cx) / fx * FRUSTUM_M, (v - cy) / fy * FRUSTUM_M, FRUSTUM_M)
        for u, v in ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height))
    ]
    table: NDArray[np.float64] = np.clip(np.array(corners), -1e6, 1e6)
    return table


def _pyramid(corners: NDArray[np.float64]) -> Lines:
    edges = [(np.zeros(3), corner) for corner in corners]
    edges += [(corners[number], corners[(number + 1) % 4]) for number in range(4)]
    return Lines(np.array(edges).astype(np.float32), np.array(BLUE, np.uint8))
