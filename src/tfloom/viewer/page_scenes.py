"""What of the scene is each page's own: the names of frames that it shows, and what its pointer is at."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.viewer.camera import Camera, projected
from tfloom.viewer.extents import Extent, extent_of, view_of
from tfloom.viewer.labels import Chosen, chosen_labels, width_em
from tfloom.viewer.page_command import PageError, fault_text, number
from tfloom.viewer.picking import Met, frame_at, nearest_shape

if TYPE_CHECKING:
    from viser import ClientHandle

    from tfloom.viewer.layout.layout import ViewPoint
    from tfloom.viewer.scene import NamedFrames, Scene
    from tfloom.viewer.scene_server import SceneServer
    from tfloom.viewer.shared_state import SharedView

__all__ = ["SCENE_COMMANDS", "PageScenes"]

SCENE_COMMANDS = frozenset(("pointer", "look"))
"""What a page asks of its own scene."""
LABELS_S = 0.15
"""Period at which it is chosen anew which names are shown [s]."""
USUAL_PX = (800.0, 480.0)
"""Size of the picture of a page that has not told it [pixels]."""
MAX_PX = 100_000.0
FRAME_AXES = 2.0
"""How far a frame reaches to which a camera is fitted, by the length of its axes."""
BEHIND_AXES = 3.0
"""How far a frame's origin may be behind a shape to be taken in its place, by the length of its axes."""


class _Spot(NamedTuple):
    """A place on a page's picture."""

    across: float
    """From 0 at the left edge to 1 at the right edge."""
    down: float
    """From 0 at the upper edge to 1 at the lower edge."""


class _PageScene:
    """What one page shows."""

    def __init__(self) -> None:
        self.client: ClientHandle | None = None
        self.labels: dict[str, tuple[Any, str, str, float]] = {}
        """By frame: the label, the node at which it is, its text and its size."""
        self.chosen: dict[str, tuple[str, float]] = {}
        """By frame: the text and the size of its label as they are to be."""
        self.asked: Any = None
        """What the choice was made of."""
        self.pointer: _Spot | None = None
        self.size_px = USUAL_PX


class PageScenes:
    """Shows to each page what is its own. One thread may use it.

    Args:
        server: The server of the scene.
        view: What all pages share.
        scene: The scene that they share.
        report: Called with a sentence about what of a page can't be shown, which doesn't end the others.
    """

    def __init__(
        self, server: SceneServer, view: SharedView, scene: Scene, report: Callable[[str], None]
    ) -> None:
        self._server = server
        self._view = view
        self._scene = scene
        self._report = report
        self._pages: dict[str, _PageScene] = {}
        self._next_labels_s = 0.0

    def command(self, page: str, operation: str, command: Mapping[str, Any]) -> None:
        """Do what a page asks of its own scene.

        Raises:
            PageError: it can't be done.
        """
        if operation == "pointer":
            self._point(page, command)
        else:
            self._look(page, _spot(command))

    def forget(self, page: str) -> None:
        """Forget a page that was closed."""
        self._pages.pop(page, None)

    def draw(self) -> None:
        """Choose anew, where it is due, which names each page shows, and show them."""
        now_s = time.monotonic()
        if now_s < self._next_labels_s:
            return
        self._next_labels_s = now_s + LABELS_S
        shown = {page: client for page in self._server.pages() if (client := self._server.client(page))}
        for page, client in shown.items():
            own = self._pages.setdefault(page, _PageScene())
            if own.client is not client:  # a scene that was loaded anew has none of them
                own.client, own.labels, own.chosen, own.asked = client, {}, {}, None
            self._try(partial(self._choose, page, own))
        of_pages = [self._pages[page] for page in shown]
        places = self._scene.places({name for own in of_pages for name in own.chosen})
        for own in of_pages:
            self._try(partial(_show_labels, own, places))

    def _try(self, do: Callable[[], None]) -> None:
        try:
            do()
        except Exception as error:  # of one page: the others have their names
            self._report(f"names of frames can't be shown: {fault_text(error)}")

    def _choose(self, page: str, own: _PageScene) -> None:
        camera, view_point = self._server.camera(page), self._server.view_point(page)
        if camera is None or view_point is None:
            return
        named, selected = self._scene.named, self._view.selected
        asked = (camera, view_point, own.pointer, own.size_px, selected, named.behind)
        if own.asked is not None and own.asked[0] == asked and _are_same(own.asked[1], named):
            return
        own.asked = asked, named
        own.chosen = _chosen(own, camera, view_point, named, selected) if named.poses.names else {}

    def _point(self, page: str, command: Mapping[str, Any]) -> None:
        spot = None if command.get("at") is None else _spot(command)
        width_px, height_px = number(command, "width"), number(command, "height")
        if not (1.0 <= width_px <= MAX_PX and 1.0 <= height_px <= MAX_PX):
            raise PageError(f"a picture is from 1 to {MAX_PX:g} pixels wide and high")
        own = self._pages.setdefault(page, _PageScene())
        own.pointer, own.size_px = spot, (width_px, height_px)

    def _look(self, page: str, spot: _Spot) -> None:
        """Let a page see the whole of what is at a place of its picture, from the side from which it looks."""
        camera, view_point = self._camera(page)
        met = self._met(page, camera, spot)
        if met is None:
            raise PageError("there is nothing at this place")
        toward = [there - here for there, here in zip(view_point.position, view_point.look_at, strict=True)]
        fitted = view_of(self._extent_of(met), camera.fov_rad, camera.aspect, toward)
        if not self._server.look(page, fitted):
            raise PageError("the scene is gone")

    def _camera(self, page: str) -> tuple[Camera, ViewPoint]:
        camera, view_point = self._server.camera(page), self._server.view_point(page)
        if camera is None or view_point is None:
            raise PageError("the scene has not told its camera yet")
        return camera, view_point

    def _met(self, page: str, camera: Camera, spot: _Spot) -> Met | str | None:
        """Return what is at a place of a picture: a shape, or the name of a frame; None: nothing."""
        own = self._pages.get(page)
        height_px = (own.size_px if own is not None else USUAL_PX)[1]
        poses = self._view.poses
        frame = frame_at(camera, spot.across, spot.down, poses, height_px)
        shape = nearest_shape(camera, spot.across, spot.down, self._view.drawn, height_px)
        if frame is None or shape is None:
            return frame or shape
        origin = poses.positions[poses.index_of(frame)]
        away_m = float(np.linalg.norm(origin - np.array(camera.position)))
        # An origin is often within the shape of its link.
        return shape if shape.distance_m < away_m - BEHIND_AXES * self._view.axes_m else frame

    def _extent_of(self, met: Met | str) -> Extent:
        if isinstance(met, str):
            origin = self._view.poses.positions[self._view.poses.index_of(met)]
            reach = FRAME_AXES * self._view.axes_m
            return Extent(origin - reach, origin + reach)
        extent = extent_of(np.empty((0, 3)), self._view.parts_of(met.display, met.number))
        if extent is None:
            raise PageError("what is at this place is too far away to be looked at")
        return extent


def _spot(command: Mapping[str, Any]) -> _Spot:
    place = command.get("at")
    if not isinstance(place, list) or len(place) != 2:
        raise PageError("at has to be two numbers")
    return _Spot(*(number({"at": part}, "at") for part in place))


def _are_same(before: NamedFrames, now: NamedFrames) -> bool:
    return before.poses.names == now.poses.names and np.array_equal(
        before.poses.positions, now.poses.positions
    )


def _chosen(
    own: _PageScene, camera: Camera, view_point: ViewPoint, named: NamedFrames, selected: list[str]
) -> dict[str, tuple[str, float]]:
    """Return the text and the size of each name that a page shows now."""
    poses = named.poses
    index = {name: number for number, name in enumerate(poses.names)}
    hovered = None if own.pointer is None else frame_at(camera, *own.pointer, poses, own.size_px[1])
    texts = [named.text_of(name) for name in poses.names]
    chosen: list[Chosen] = chosen_labels(
        projected(camera, poses.positions),
        np.array([width_em(text) for text in texts]),
        own.size_px,
        float(np.linalg.norm(np.subtract(view_point.position, view_point.look_at))),
        first=[index[name] for name in (hovered, *selected) if name in index],
        before=[index[name] for name in own.chosen if name in index],
    )
    return {poses.names[label.number]: (texts[label.number], label.size) for label in chosen}


def _show_labels(own: _PageScene, places: Mapping[str, str]) -> None:
    """Show the names that were chosen, and no others; each is a node of this page alone below one that all have."""
    if own.client is None:
        return
    with own.client.atomic():
        for name in [name for name in own.labels if name not in own.chosen]:
            own.labels.pop(name)[0].remove()
        for name, (text, size) in own.chosen.items():
            place = places[name]
            label, at_place, text_before, size_before = own.labels.get(name, (None, "", "", 0.0))
            if at_place != place:
                if label is not None:
                    label.remove()
                label = own.client.scene.add_label(
                    f"{place}/text", text, font_screen_scale=size, anchor="bottom-left"
                )
            elif (text_before, size_before) == (text, size):
                continue
            else:
                label.text, label.font_screen_scale = text, size
            own.labels[name] = label, place, text, size
