"""Shapes as nodes of viser's scene."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from tfloom._native import move_points_float32
from tfloom.tf2.transform import Transform
from tfloom.viewer import shapes
from tfloom.viewer.displays.display import MAX_COORDINATE_M
from tfloom.viewer.frame_models import add_axes
from tfloom.viewer.viser_private import HAS_PIXEL_POINTS, pixel_size

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from viser import SceneApi

__all__ = ["Drawn", "Pose", "shown_name"]

Pose = tuple[tuple[float, float, float], tuple[float, float, float, float]]
"""Position [m], and quaternion (x, y, z, w)."""
MAX_NAME = 64
"""Number of characters of a frame's name that are drawn."""
MAX_POINTS_SENT_AGAIN = 2000
"""Number of points up to which they are sent again when their pose alone has changed; the node of more is moved."""
ORIGIN_STEP_M = 1000.0
"""Distance of the places from which points are counted [m]."""
MIN_SIZE_M = 1e-4
"""A thinner box is as thin as this, because a page can't draw one of no thickness."""


def shown_name(name: str) -> str:
    """Return a frame's name as it is drawn: of limited length, and without halves of surrogate pairs."""
    cut = name if len(name) <= MAX_NAME else name[: MAX_NAME - 1] + "…"
    return cut.encode("utf-8", "replace").decode()


class Drawn:
    """A shape in the scene. What raises leaves it as it was, or half changed: it is removed then.

    A page draws the pose of a node and the points of a cloud at different times, up to a whole picture apart: so a scan
    of a robot that turns would be at its new place for a moment with its old points. That is why points are sent as
    they are in the fixed frame, and the pose of their node is left as it is.

    Args:
        scene: The scene.
        name: The node's name; a node of this name is replaced.
        shape: The shape.
        on_click: Called when it is clicked, on a thread of viser, with viser's event; None: it can't be clicked.
    """

    fault = ""

    def __init__(
        self,
        scene: SceneApi,
        name: str,
        shape: shapes.Shape,
        on_click: Callable[[object], None] | None = None,
    ) -> None:
        self._scene = scene
        self._on_click = on_click
        self._on_drag: Callable[[Any], object] | None = None
        self._name = name
        self._shape = shape
        self._offset = np.zeros(3)
        self._pose: Pose | None = None
        self._sent: _Sent | None = None
        """How points were sent last; None before the first ones."""
        self._are_points_new = True
        self._handle = self._add(shape)
        self._is_visible = True

    def _add(self, shape: shapes.Shape) -> Any:
        _refuse_undrawable(shape)
        if isinstance(shape, shapes.Picture):
            # Pictures begin at their corner, viser's are around their middle.
            self._offset = np.array((shape.size[0] / 2.0, shape.size[1] / 2.0, 0.0))
        handle = _ADDERS[type(shape)](self._scene, self._name, shape)
        if self._on_click is not None and hasattr(handle, "on_click"):
            handle.on_click(self._on_click)
            handle.on_click(modifier="shift")(self._on_click)
        if self._on_drag is not None and hasattr(handle, "on_drag"):
            handle.on_drag("left")(self._on_drag)
        return handle

    def set_on_drag(self, on_drag: Callable[[Any], object] | None) -> None:
        """Have it dragged, or no longer: `on_drag` takes viser's events. One that takes them already is kept."""
        if (on_drag is None) == (self._on_drag is None) or not hasattr(self._handle, "on_drag"):
            return
        self._on_drag = on_drag
        if on_drag is None:
            self._handle.remove_drag_callback()
        else:
            self._handle.on_drag("left")(on_drag)

    def change(self, shape: shapes.Shape) -> None:
        """Draw another shape at the same place."""
        if shape is self._shape:
            return
        _refuse_undrawable(shape)
        before, self._shape = self._shape, shape
        if isinstance(shape, shapes.Points) and isinstance(before, shapes.Points):
            # A cloud is changed, not replaced: the page keeps its buffers on the graphics card. Its points are sent
            # with its pose.
            self._are_points_new = True
            if (shape.size_m, shape.size_px, shape.form) != (before.size_m, before.size_px, before.form):
                self._handle.point_size, self._handle.point_shape = _size_and_form(shape)
            return
        if (
            isinstance(shape, shapes.Picture)
            and isinstance(before, shapes.Picture)
            and shape.size == before.size
            and shape.pixels.shape == before.pixels.shape
        ):
            # A video's frames are exchanged: a page takes longer to replace a node, and would fall behind.
            self._handle.image = _flipped(shape)
            return
        self._handle = self._add(shape)
        self._are_points_new = True
        pose, is_visible = self._pose, self._is_visible
        self._pose, self._is_visible = None, True
        self.place(pose if is_visible else None)

    def place(self, pose: Pose | None) -> None:
        """Move it to a pose in the fixed frame; None hides it."""
        if (pose is not None) != self._is_visible:
            self._is_visible = pose is not None
            self._handle.visible = self._is_visible
        if isinstance(self._shape, shapes.Points):
            self._place_points(self._shape, pose)
            return
        if pose is None or pose == self._pose:
            return
        self._pose = pose
        if isinstance(self._shape, shapes.Copies) and self._shape.by_axis is not None:
            self._handle.batched_colors = self._shape.by_axis.of(self._shape.positions, pose)
        (position, (x, y, z, w)) = pose
        self._handle.position = np.array(position) + _turned((x, y, z, w), self._offset)
        self._handle.wxyz = (w, x, y, z)

    def _place_points(self, shape: shapes.Points, pose: Pose | None) -> None:
        if pose is None or (pose == self._pose and not self._are_points_new):
            return
        self._pose = pose
        if shape.by_axis is not None:
            self._handle.colors = shape.by_axis.of(shape.positions, pose)
        elif self._sent is None or self._are_points_new:
            self._handle.colors = shape.colors
        fixed_from_shape = Transform(*pose)
        if self._sent is not None and not self._are_points_new:
            if len(shape.positions) > MAX_POINTS_SENT_AGAIN:
                node = fixed_from_shape @ self._sent.fixed_from_shape.inverse() @ Transform(self._sent.origin)
                self._move_node(node.translation, node.rotation_xyzw)
                return
        else:
            self._are_points_new = False
        self._sent = _Sent.of(fixed_from_shape, self._sent)
        self._handle.points = self._sent.points(shape.positions)
        self._move_node(self._sent.origin, (0.0, 0.0, 0.0, 1.0))

    def _move_node(
        self, position: tuple[float, float, float], rotation_xyzw: tuple[float, float, float, float]
    ) -> None:
        x, y, z, w = rotation_xyzw
        if tuple(self._handle.position) != position:
            self._handle.position = position
        if tuple(self._handle.wxyz) != (w, x, y, z):
            self._handle.wxyz = (w, x, y, z)

    def remove(self) -> None:
        """Remove it from the scene."""
        self._handle.remove()


class _Sent(NamedTuple):
    """How points were sent to pages."""

    fixed_from_shape: Transform
    """The pose that is in them."""
    origin: tuple[float, float, float]
    """Where they are counted from, in the fixed frame: pages have single precision, too little for far places [m]."""

    @classmethod
    def of(cls, fixed_from_shape: Transform, before: _Sent | None) -> _Sent:
        """Return how to send points at a pose; the origin stays as it was before, as long as it is near."""
        place = fixed_from_shape.translation
        if before is not None and math.dist(before.origin, place) < 2.0 * ORIGIN_STEP_M:
            return cls(fixed_from_shape, before.origin)
        x, y, z = (ORIGIN_STEP_M * round(part / ORIGIN_STEP_M) for part in place)
        return cls(fixed_from_shape, (x, y, z))

    def points(self, positions: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the points (N, 3) to send [m]."""
        moved = Transform(self.origin).inverse() @ self.fixed_from_shape
        out = np.empty(positions.shape, np.float32)
        # Not by numpy's product of matrices, whose threads are busy long after it.
        move_points_float32(
            np.array([*moved.translation, *moved.rotation_xyzw]),
            np.ascontiguousarray(positions, np.float32),
            out,
        )
        return out


def _refuse_undrawable(shape: shapes.Shape) -> None:
    """Refuse numbers with which pages can't compute.

    Raises:
        DisplayError: there is one.
    """
    for value in vars(shape).values():
        numbers = np.asarray(value if type(value) in {float, tuple, np.ndarray} else 0.0)
        if numbers.dtype.kind == "f" and not (np.abs(numbers) < MAX_COORDINATE_M).all():
            raise shapes.DisplayError(f"a number of it is not finite, or beyond {MAX_COORDINATE_M:g}")


def _turned(
    rotation_xyzw: tuple[float, float, float, float], vector: NDArray[np.float64]
) -> NDArray[np.float64]:
    if not vector.any():
        return vector
    axis, w = np.array(rotation_xyzw[:3]), rotation_xyzw[3]
    cross = 2.0 * np.cross(axis, vector)
    return vector + w * cross + np.cross(axis, cross)


_SHADOWLESS: dict[str, Any] = {"cast_shadow": False, "receive_shadow": False}


def _size_and_form(shape: shapes.Points) -> tuple[float, Literal["circle", "square"]]:
    """Return the size and the form of points as viser takes them."""
    if shape.size_px is not None and HAS_PIXEL_POINTS:
        return pixel_size(shape.size_px), "square"  # of few pixels, a circle has too few
    return shape.size_m, shape.form


def _add_points(scene: SceneApi, name: str, shape: shapes.Points) -> Any:
    size, form = _size_and_form(shape)
    return scene.add_point_cloud(
        name,
        shape.positions,
        shape.colors,
        point_size=size,
        precision="float32",
        point_shape=form,
        point_shading="flat",
    )


def _add_lines(scene: SceneApi, name: str, shape: shapes.Lines) -> Any:
    width: dict[str, Any] = {"thickness": shape.width_px, "thickness_units": "screen"}
    if shape.width_m is not None:
        width = {"thickness": max(shape.width_m, MIN_SIZE_M), "thickness_units": "world"}
    return scene.add_line_segments(name, shape.ends, shape.colors, **width)


def _add_arrows(scene: SceneApi, name: str, shape: shapes.Arrows) -> Any:
    radius = shape.shaft_radius_m
    return scene.add_arrows(
        name, shape.ends, shape.color, shaft_radius=radius, head_radius=2.5 * radius, head_length=5.0 * radius
    )


def _add_axes(scene: SceneApi, name: str, shape: shapes.Axes) -> Any:
    return add_axes(
        scene,
        name,
        shape.rotations_xyzw[:, [3, 0, 1, 2]],
        shape.positions,
        max(shape.length_m, MIN_SIZE_M),
        max(shape.radius_m, MIN_SIZE_M),
    )


def _add_mesh(scene: SceneApi, name: str, shape: shapes.Mesh) -> Any:
    return scene.add_mesh_simple(
        name,
        shape.vertices,
        shape.faces,
        color=shape.color,
        opacity=_opacity(shape.opacity),
        side="double",
        flat_shading=True,
        **_SHADOWLESS,
    )


def _add_box(scene: SceneApi, name: str, shape: shapes.Box) -> Any:
    x, y, z = (max(part, MIN_SIZE_M) for part in shape.size)
    return scene.add_box(
        name,
        color=shape.color,
        dimensions=(x, y, z),
        opacity=_opacity(shape.opacity),
        **_SHADOWLESS,
    )


def _add_ball(scene: SceneApi, name: str, shape: shapes.Ball) -> Any:
    x, y, z = (max(part, MIN_SIZE_M) for part in shape.radii)
    return scene.add_icosphere(
        name,
        radius=1.0,
        color=shape.color,
        opacity=_opacity(shape.opacity),
        scale=(x, y, z),
        **_SHADOWLESS,
    )


def _add_cylinder(scene: SceneApi, name: str, shape: shapes.Cylinder) -> Any:
    return scene.add_cylinder(
        name,
        radius=max(shape.radius_m, MIN_SIZE_M),
        height=max(shape.height_m, MIN_SIZE_M),
        color=shape.color,
        opacity=_opacity(shape.opacity),
        **_SHADOWLESS,
    )


def _add_copies(scene: SceneApi, name: str, shape: shapes.Copies) -> Any:
    import trimesh

    size = [max(part, MIN_SIZE_M) for part in shape.size]
    if shape.kind == "box":
        mesh = trimesh.creation.box(size)
    else:
        mesh = trimesh.creation.icosphere(subdivisions=1, radius=0.5)
        mesh.apply_scale(size)
    return scene.add_batched_meshes_simple(
        name,
        np.asarray(mesh.vertices, np.float32),
        np.asarray(mesh.faces, np.uint32),
        batched_wxyzs=np.tile(np.array((1.0, 0.0, 0.0, 0.0), np.float32), (len(shape.positions), 1)),
        batched_positions=shape.positions,
        batched_colors=shape.colors,
        opacity=_opacity(shape.opacity),
        flat_shading=shape.kind == "box",
        **_SHADOWLESS,
    )


def _add_text(scene: SceneApi, name: str, shape: shapes.Text) -> Any:
    return scene.add_label(
        name, shape.text, font_size_mode="scene", font_scene_height=shape.height_m, anchor="center-center"
    )


def _flipped(shape: shapes.Picture) -> NDArray[np.uint8]:
    """Return a picture's pixels as viser hangs them: upside down, as those of cameras whose y axis is down."""
    return np.ascontiguousarray(shape.pixels[::-1])


def _add_picture(scene: SceneApi, name: str, shape: shapes.Picture) -> Any:
    return scene.add_image(name, _flipped(shape), *shape.size, **_SHADOWLESS)


def _add_model(scene: SceneApi, name: str, shape: shapes.Model) -> Any:
    return scene.add_glb(name, shape.glb, scale=shape.scale, **_SHADOWLESS)


def _opacity(opacity: float) -> float | None:
    return None if opacity >= 1.0 else max(opacity, 0.0)


_ADDERS: dict[type[shapes.Shape], Callable[[SceneApi, str, Any], Any]] = {
    shapes.Points: _add_points,
    shapes.Lines: _add_lines,
    shapes.Arrows: _add_arrows,
    shapes.Axes: _add_axes,
    shapes.Mesh: _add_mesh,
    shapes.Box: _add_box,
    shapes.Ball: _add_ball,
    shapes.Cylinder: _add_cylinder,
    shapes.Copies: _add_copies,
    shapes.Text: _add_text,
    shapes.Picture: _add_picture,
    shapes.Model: _add_model,
}
