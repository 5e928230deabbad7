"""What is drawn: shapes in frames. Displays make them of messages, and `drawing.py` draws them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tfloom.viewer.color_scale import AxisColors

__all__ = [
    "AT_VIEW",
    "Arrows",
    "Axes",
    "Ball",
    "Box",
    "Color",
    "Copies",
    "Cylinder",
    "DisplayError",
    "Lines",
    "Mesh",
    "Model",
    "Picture",
    "Placed",
    "Points",
    "Shape",
    "Text",
]

Color = tuple[int, int, int]
"""Red, green and blue, each from 0 to 255."""

AT_VIEW = 0
"""Stamp of a shape that is where its frame is at the time that the page shows."""


class DisplayError(Exception):
    """A message can't be shown; the text says why, in one sentence."""


@dataclass(frozen=True)
class Points:
    """Points."""

    positions: NDArray[np.float32]
    """(N, 3) [m]."""
    colors: NDArray[np.uint8]
    """(N, 3), or (3,) for all."""
    size_m: float = 0.03
    size_px: float | None = None
    """In place of that in metres: on the screen, at any distance, as squares; None: none."""
    form: Literal["circle", "square"] = "circle"
    by_axis: AxisColors | None = None
    """By what their colours follow from their pose, in place of `colors`; None: they don't."""


@dataclass(frozen=True)
class Lines:
    """Straight lines."""

    ends: NDArray[np.float32]
    """(N, 2, 3) [m]."""
    colors: NDArray[np.uint8]
    """(N, 2, 3), or (3,) for all."""
    width_px: float = 2.0
    width_m: float | None = None
    """In place of that on the screen; None: none."""


@dataclass(frozen=True)
class Arrows:
    """Arrows of one colour, from the first end of each to the second."""

    ends: NDArray[np.float32]
    """(N, 2, 3) [m]."""
    color: Color
    shaft_radius_m: float = 0.02


@dataclass(frozen=True)
class Axes:
    """Poses, as three axes each."""

    positions: NDArray[np.float32]
    """(N, 3) [m]."""
    rotations_xyzw: NDArray[np.float32]
    """(N, 4)."""
    length_m: float = 0.3
    radius_m: float = 0.012


@dataclass(frozen=True)
class Mesh:
    """Triangles of one colour."""

    vertices: NDArray[np.float32]
    """(N, 3) [m]."""
    faces: NDArray[np.uint32]
    """(M, 3) indices of vertices."""
    color: Color
    opacity: float = 1.0


@dataclass(frozen=True)
class Box:
    """A box around its origin."""

    size: tuple[float, float, float]
    """[m]."""
    color: Color
    opacity: float = 1.0


@dataclass(frozen=True)
class Ball:
    """An ellipsoid around its origin."""

    radii: tuple[float, float, float]
    """[m]."""
    color: Color
    opacity: float = 1.0


@dataclass(frozen=True)
class Cylinder:
    """A cylinder around its origin, along z."""

    radius_m: float
    height_m: float
    color: Color
    opacity: float = 1.0


@dataclass(frozen=True)
class Copies:
    """Boxes or balls of one size around many points."""

    kind: Literal["box", "ball"]
    positions: NDArray[np.float32]
    """(N, 3) [m]."""
    size: tuple[float, float, float]
    """[m]."""
    colors: NDArray[np.uint8]
    """(N, 3)."""
    opacity: float = 1.0
    by_axis: AxisColors | None = None
    """As of `Points`."""


@dataclass(frozen=True)
class Text:
    """A text that faces the camera."""

    text: str
    height_m: float = 0.2


@dataclass(frozen=True)
class Picture:
    """A picture in the x-y plane: its left lower corner is the origin, its right is along x, its upper side along y."""

    pixels: NDArray[np.uint8]
    """(H, W, 3), or (H, W, 4) with the opacity; the upper row first."""
    size: tuple[float, float]
    """Along x and along y [m]."""


@dataclass(frozen=True)
class Model:
    """A binary glTF file."""

    glb: bytes
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    has_texture: bool = False
    """Whether it has the texture that was asked for."""


Shape = Points | Lines | Arrows | Axes | Mesh | Box | Ball | Cylinder | Copies | Text | Picture | Model
"""Any of them."""


class Placed(NamedTuple):
    """A shape in a frame."""

    shape: Shape
    frame_id: str
    stamp_ns: int = AT_VIEW
    """Time at which the frame's pose counts [ns since epoch]; AT_VIEW: the time that the page shows."""
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Of the shape in its frame [m]."""
    rotation_xyzw: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
