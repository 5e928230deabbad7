"""The scene of all pages: frames with their names, arrows to their parents, trails, and what displays show."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.viewer.drawing import Drawn, Pose, shown_name
from tfloom.viewer.frame_models import Spikes, add_axes, add_spikes, spikes_between
from tfloom.viewer.frames import FramePoses
from tfloom.viewer.layout.layout import DEFAULT_AXES_M
from tfloom.viewer.page_command import fault_text
from tfloom.viewer.shapes import Shape

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from viser import SceneApi

__all__ = ["NamedFrames", "Scene"]

MOVED_M = 1e-6
"""The place of a name that has moved less stays where it is [m]."""
MAX_ARROWS = 500
"""Number of arrows to parents; more are spikes, because without a graphics card arrows take long to draw."""
YELLOW = (255, 205, 60)
GREY = (120, 120, 125)
CYAN = np.array((80, 230, 255), np.uint8)
ORANGE = np.array((255, 140, 0), np.uint8)
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float64)
BOX_EDGES = np.array(
    [(a, b) for a in _CORNERS for b in _CORNERS if tuple(a) < tuple(b) and np.count_nonzero(a != b) == 1]
)
"""Start and end of the edges of a cube from -1 to 1: (12, 2, 3)."""
TRAIL_COLORS = ((255, 90, 200), (90, 220, 255), (255, 160, 60), (140, 255, 110), (190, 150, 255))


class NamedFrames(NamedTuple):
    """Frames whose names may be shown."""

    poses: FramePoses = FramePoses([], np.empty((0, 3)), np.empty((0, 4)), np.empty(0, np.int64))
    behind: Collection[str] = frozenset()
    """The names of those whose pose is out of date."""

    def text_of(self, name: str) -> str:
        """Return the text of a label."""
        return shown_name(name) + (" (stale)" if name in self.behind else "")


class Scene:
    """Draws in viser's scene. One thread may use it.

    Args:
        scene: Viser's scene, which all pages share.
        on_frame: Called with a frame's name when it is clicked, on a thread of viser.
    """

    def __init__(self, scene: SceneApi, on_frame: Callable[[str], None]) -> None:
        self._scene = scene
        self._on_frame = on_frame
        self._axes_m = DEFAULT_AXES_M
        self._axes: Any = None
        self._axes_names: list[str] = []
        self._grey: Any = None
        self._arrows: Any = None
        self._spikes: Any = None
        self.named = NamedFrames()
        """The frames whose names pages may show."""
        self._places: dict[str, Any] = {}
        """The node at each frame at which a page shows its name."""
        self._free_places: list[Any] = []
        self._trails: dict[str, Any] = {}
        self._trail_numbers: dict[str, int] = {}
        """The number in the name of each trail's node, by the frame's name."""
        self._selection: Any = None
        self._marks: Any = None
        self._displays: dict[str, list[Drawn | _Undrawable]] = {}
        self._display_numbers: dict[str, int] = {}
        self._display_frames: dict[str, Sequence[str]] = {}
        """The frame of each shape of a display whose shapes can be clicked."""
        scene.set_up_direction("+z")
        self._floor = scene.add_grid(
            "/floor",
            infinite_grid=True,
            cell_size=1.0,
            section_size=5.0,
            cell_color=(70, 74, 82),
            section_color=(95, 100, 110),
            fade_distance=60.0,
            shadow_opacity=0.0,
        )

    def show_floor(self, *, is_shown: bool) -> None:
        """Show the floor, or hide it."""
        if self._floor.visible != is_shown:
            self._floor.visible = is_shown

    def draw_frames(
        self,
        poses: FramePoses,
        behind: Collection[str],
        *,
        with_names: bool,
        axes_m: float = DEFAULT_AXES_M,
        with_axes: bool = True,
        with_arrows: bool = True,
    ) -> None:
        """Draw frames; those of which the pose is out of date are grey.

        Args:
            poses: The frames.
            behind: The names of those that are out of date.
            with_names: Whether pages may show their names.
            axes_m: Length of their axes [m].
            with_axes: Whether to draw their axes.
            with_arrows: Whether to draw arrows to their parents.
        """
        if axes_m != self._axes_m:  # arrows of other sizes are another node
            self._axes_m = axes_m
            arrows, self._arrows = self._arrows, None
            if arrows is not None:
                arrows.remove()
        is_behind = np.array([name in behind for name in poses.names], bool)
        self._draw_axes(poses, ~is_behind & with_axes, axes_m)
        self._draw_grey_axes(poses, is_behind & with_axes, axes_m)
        self._draw_arrows(poses, is_behind, axes_m, is_shown=with_arrows)
        self.named = NamedFrames(poses, behind) if with_names else NamedFrames()
        self._move_places()

    def _draw_axes(self, poses: FramePoses, is_fresh: NDArray[np.bool_], axes_m: float) -> None:
        names = [name for name, fresh in zip(poses.names, is_fresh, strict=True) if fresh]
        wxyzs = poses.rotations_xyzw[is_fresh][:, [3, 0, 1, 2]].astype(np.float32)
        positions = poses.positions[is_fresh].astype(np.float32)
        # A click is told by its number among the axes, so the names are exchanged before the node is.
        self._axes_names = names
        if not names:
            axes, self._axes = self._axes, None
            if axes is not None:
                axes.remove()
            return
        if self._axes is None or len(names) != len(self._axes.batched_positions):
            # Another node, because a page that looks for what is clicked among these sorts them when it gets the node.
            self._axes = add_axes(self._scene, "/frames/axes", wxyzs, positions, axes_m, axes_m / 25.0)
            self._axes.on_click(self._clicked)
            return
        self._axes.batched_positions = positions
        self._axes.batched_wxyzs = wxyzs
        self._axes.batched_scales = np.full(len(names), axes_m, np.float32)

    def _clicked(self, event: Any) -> None:
        number, names = event.instance_index, self._axes_names
        if isinstance(number, int) and 0 <= number < len(names):
            self._on_frame(names[number])

    def _draw_grey_axes(self, poses: FramePoses, is_behind: NDArray[np.bool_], axes_m: float) -> None:
        x, y, z, w = poses.rotations_xyzw[is_behind].T
        columns = np.stack(
            [
                np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)], axis=1),
                np.stack([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], axis=1),
                np.stack([2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)], axis=1),
            ],
            axis=1,
        )
        starts = np.repeat(poses.positions[is_behind][:, np.newaxis], 3, axis=1)
        ends = np.stack([starts, starts + axes_m * columns], axis=2).reshape(-1, 2, 3).astype(np.float32)
        self._grey = self._set_lines("/frames/stale", self._grey, ends, np.array(GREY, np.uint8), 3.0)

    def _set_lines(
        self, name: str, handle: Any, ends: NDArray[np.float32], colors: NDArray[np.uint8], width_px: float
    ) -> Any:
        add = partial(self._scene.add_line_segments, thickness=width_px, thickness_units="screen")
        return _set_ends(handle, ends, partial(add, name, ends, colors))

    def _draw_arrows(
        self, poses: FramePoses, is_behind: NDArray[np.bool_], axes_m: float, *, is_shown: bool
    ) -> None:
        children = poses.links() if is_shown else np.empty(0, np.intp)
        pairs = np.stack([poses.positions[children], poses.positions[poses.parents[children]]], axis=1)
        ends = pairs.astype(np.float32)
        is_grey = is_behind[children, np.newaxis]
        colors = np.where(is_grey, np.array(GREY), np.array(YELLOW)).astype(np.uint8)
        are_spikes = len(children) > MAX_ARROWS
        self._draw_spikes(spikes_between(pairs, colors, axes_m / 30.0) if are_spikes else None)
        if are_spikes:
            ends, colors = ends[:0], colors[:0]
        sizes = {"shaft_radius": axes_m / 50.0, "head_radius": axes_m / 15.0, "head_length": axes_m / 5.0}
        add = partial(self._scene.add_arrows, "/frames/arrows", ends, colors, **sizes)
        self._arrows = _set_ends(self._arrows, ends, add)
        if self._arrows is not None and not np.array_equal(self._arrows.colors, colors):
            self._arrows.colors = colors

    def _draw_spikes(self, spikes: Spikes | None) -> None:
        """Draw spikes in place of arrows; None: none."""
        if spikes is None:
            before, self._spikes = self._spikes, None
            if before is not None:
                before.remove()
        elif self._spikes is None:
            self._spikes = add_spikes(self._scene, "/frames/spikes", spikes)
        else:
            for name, values in spikes._asdict().items():
                setattr(self._spikes, name, values)

    def places(self, names: Collection[str]) -> dict[str, str]:
        """Have a node at each of some frames, to which pages attach names; return the nodes' names.

        A name that is a node below one of these moves in the same picture as the axes do, on all pages.
        """
        for name in [name for name in self._places if name not in names]:
            self._free_places.append(self._places.pop(name))
        for name in names:
            if name not in self._places:
                # Nodes are used again: the scene keeps a note of each that was ever removed.
                number = len(self._places) + len(self._free_places)
                self._places[name] = (
                    self._free_places.pop()
                    if self._free_places
                    else self._scene.add_frame(f"/frames/names/{number}", show_axes=False)
                )
        self._move_places()
        return {name: place.name for name, place in self._places.items()}

    def _move_places(self) -> None:
        if not self._places:
            return
        positions = dict(zip(self.named.poses.names, self.named.poses.positions, strict=True))
        for name, place in self._places.items():
            position = positions.get(name)
            if position is not None and np.abs(position - place.position).max() > MOVED_M:
                place.position = position

    def draw_trails(self, trails: Mapping[str, NDArray[np.float64]]) -> None:
        """Draw the ways of frames: points (N, 3) [m] by the frame's name."""
        for name in [name for name in self._trail_numbers if name not in trails]:
            del self._trail_numbers[name]
            if name in self._trails:
                self._trails.pop(name).remove()
        for name, points in trails.items():
            # A trail keeps its node and its colour, whichever other ones come and go.
            free = next(number for number in count() if number not in self._trail_numbers.values())
            number = self._trail_numbers.setdefault(name, free)
            ends = np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)
            color = np.array(TRAIL_COLORS[number % len(TRAIL_COLORS)], np.uint8)
            handle = self._set_lines(f"/trails/{number}", self._trails.get(name), ends, color, 3.0)
            if handle is None:
                self._trails.pop(name, None)
            else:
                self._trails[name] = handle

    def draw_selection(self, points: Sequence[NDArray[np.float64]]) -> None:
        """Draw a line between the two selected frames; none with fewer points."""
        ends = np.array([points], np.float32) if len(points) == 2 else np.empty((0, 2, 3), np.float32)
        self._selection = self._set_lines("/selection", self._selection, ends, CYAN, 3.0)

    def draw_marks(self, points: NDArray[np.float64]) -> None:
        """Draw a box around the axes of each of some frames: their positions, (N, 3) [m]."""
        ends = (points[:, np.newaxis, np.newaxis] + 1.1 * self._axes_m * BOX_EDGES).reshape(-1, 2, 3)
        self._marks = self._set_lines("/marks", self._marks, ends.astype(np.float32), ORANGE, 3.0)

    def draw_display(
        self,
        topic: str,
        placed: Sequence[tuple[Shape, Pose | None]],
        frames: Sequence[str] = (),
        clicked: Callable[[int, Any], None] | None = None,
        dragged: Callable[[int], Callable[[Any], object] | None] | None = None,
    ) -> str:
        """Draw what a display shows, in place of what it showed before; shapes without a pose are hidden.

        Args:
            topic: The display's topic.
            placed: The shapes, each with its pose in the fixed frame.
            frames: The frame of each shape, which a click on it selects; empty: clicks do nothing.
            clicked: Called in place of that with the number of a shape and viser's event, on a thread of viser; the
                same as long as the display is there.
            dragged: Returns what takes viser's events of a drag of the shape of a number, the same for each shape
                there; or None, for one that isn't dragged.

        Returns:
            Why one of the shapes can't be drawn, which doesn't hide the others; empty if all are.
        """
        drawn = self._displays.setdefault(topic, [])
        number = self._display_numbers.setdefault(topic, len(self._display_numbers))
        while len(drawn) > len(placed):
            drawn.pop().remove()
        fault = ""
        self._display_frames[topic] = frames
        for index, (shape, pose) in enumerate(placed):
            now = drawn[index] if index < len(drawn) else None
            try:
                on_click = partial(self._shape_clicked, topic, index) if frames else None
                on_click = on_click if clicked is None else partial(clicked, index)
                now = self._drawn(f"/displays/{number}/{index}", now, shape, on_click)
                if dragged is not None and isinstance(now, Drawn):
                    now.set_on_drag(dragged(index))
                now.place(pose)
            except Exception as error:  # of one shape: the others are drawn
                if now is not None:
                    now.remove()
                now = _Undrawable(shape, fault_text(error))
            drawn[index : index + 1] = [now]
            fault = fault or now.fault
        return fault

    def _shape_clicked(self, topic: str, index: int, _: object) -> None:
        frames = self._display_frames.get(topic, ())
        if index < len(frames):
            self._on_frame(frames[index])

    def _drawn(
        self,
        name: str,
        before: Drawn | _Undrawable | None,
        shape: Shape,
        on_click: Callable[[object], None] | None,
    ) -> Drawn | _Undrawable:
        if isinstance(before, Drawn):
            before.change(shape)
            return before
        if before is not None and before.shape is shape:
            return before
        return Drawn(self._scene, name, shape, on_click)


class _Undrawable(NamedTuple):
    """A shape that can't be drawn, in the place of the one that would be."""

    shape: Shape
    fault: str

    def place(self, pose: Pose | None) -> None:
        pass

    def remove(self) -> None:
        pass


def _set_ends(handle: Any, ends: NDArray[np.float32], add: Callable[[], Any]) -> Any:
    """Exchange the ends of a node's lines or arrows; a changed count needs a new node; zero removes it."""
    if len(ends):
        if handle is None or handle.points.shape != ends.shape:
            return add()  # a node takes the place of another one of its name
        handle.points = ends
        return handle
    if handle is not None:
        handle.remove()
    return None
