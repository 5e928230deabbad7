"""What of the scene is each page's own: the names of frames that it shows, and what its pointer is at."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from tfloom.viewer.camera import Camera, floor_point, projected
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.extents import Extent, extent_of, view_of
from tfloom.viewer.labels import Chosen, chosen_labels, width_em
from tfloom.viewer.layout.layout import CAMERA_KINDS, SavedView, ViewPoint
from tfloom.viewer.measuring import Measure, Place
from tfloom.viewer.page_camera import (
    Following,
    eye,
    place_of,
    relative,
    rescaled,
    set_lens,
    stepped_back,
    view_in,
)
from tfloom.viewer.page_command import PageError, fault_text, flag, number, text
from tfloom.viewer.picking import Met, frame_at, nearest_shape
from tfloom.viewer.shared_state import MAX_VIEWS, SharedView

if TYPE_CHECKING:
    from viser import ClientHandle

    from tfloom.viewer.layout.layout import Layout
    from tfloom.viewer.scene import NamedFrames, Scene
    from tfloom.viewer.scene_server import SceneServer

__all__ = ["PageScenes"]

LABELS_S = 0.15
"""Period at which it is chosen anew which names are shown [s]."""
USUAL_PX = (800.0, 480.0)
"""Size of the picture of a page that has not told it [pixels]."""
MAX_PX = 100_000.0
MIN_FOCUS_M = 1e-3
"""A camera that is nearer to a place can't look at it [m]."""
MAX_NAME = 64
"""Length of a view's name."""
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
        self.following = Following()
        self.standing: ViewPoint | None = None
        """Where the camera stands in the place that it follows; None: where it is when it begins."""
        self.is_held = False
        """Whether the page's user moves the camera."""
        self.measure: Measure | None = None
        self.told: dict[str, Any] = {}
        """What the page knows of its camera."""
        self.pointer: _Spot | None = None
        self.size_px = USUAL_PX


class PageScenes:
    """Shows to each page what is its own. One thread may use it.

    Args:
        server: The server of the scene.
        view: What all pages share.
        scene: The scene that they share.
        answer: Called with a page and an answer for it.
        report: Called with a sentence about what of a page can't be shown, which doesn't end the others.
    """

    def __init__(
        self,
        server: SceneServer,
        view: SharedView,
        scene: Scene,
        answer: Callable[[str, dict[str, Any]], None],
        report: Callable[[str], None],
    ) -> None:
        self._server = server
        self._view = view
        self._scene = scene
        self._answer = answer
        self._report = report
        self._pages: dict[str, _PageScene] = {}
        self._next_labels_s = 0.0

    def command(self, page: str, operation: str, command: Mapping[str, Any]) -> None:
        """Do what a page asks of its own scene.

        Raises:
            PageError: it can't be done.
        """
        self.COMMANDS[operation](self, page, command)

    def open(self, page: str, layout: Layout) -> None:
        """Let a new page look as a layout says."""
        own = self._pages.setdefault(page, _PageScene())
        if layout.camera is not None:
            own.following = Following(layout.camera_kind, layout.camera_frame, layout.camera_turns)
            own.standing = layout.camera

    def look(self, page: str, view_point: ViewPoint) -> bool:
        """Let a page look from a point to another one, as its camera can; return whether it was there to be told."""
        own = self._pages.setdefault(page, _PageScene())
        camera = self._server.camera(page)
        if camera is not None and not own.following.is_free:
            if own.following.kind == "first_person":  # which is where its frame is
                own.following = Following()
            place = place_of(own.following, self._view.poses)
            if place is not None:
                own.standing = relative(own.following, place, view_point, camera)
                view_point = view_in(place, own.standing)
        return self._server.look(page, view_point)

    def saved_view(self, page: str, name: str = "") -> SavedView | None:
        """Return how a page looks now; None until it has told its camera."""
        own = self._pages.get(page) or _PageScene()
        now = self._server.view_point(page)
        camera = now if own.following.is_free else own.standing or now
        return None if camera is None else SavedView(name, camera, *own.following)

    def forget(self, page: str) -> None:
        """Forget a page that was closed."""
        self._pages.pop(page, None)

    def draw(self) -> None:
        """Move the cameras that follow; choose anew, where it is due, which names each page shows."""
        for page, own in self._pages.items():
            if not own.following.is_free or own.told.get("is_gone"):
                self._try("a camera can't be moved", partial(self._move_camera, page, own))
        now_s = time.monotonic()
        if now_s < self._next_labels_s:
            return
        self._next_labels_s = now_s + LABELS_S
        shown = {page: client for page in self._server.pages() if (client := self._server.client(page))}
        for page, client in shown.items():
            own = self._pages.setdefault(page, _PageScene())
            if own.client is not client:  # a scene that was loaded anew has none of them
                own.client, own.labels, own.chosen, own.asked = client, {}, {}, None
            if own.measure is not None and own.measure.scene is not client.scene:
                own.measure = None
            if own.measure is not None and own.measure.frame != self._view.fixed_frame:
                self._end_measure(page, {}, "the fixed frame is another one: nothing is measured")
            self._try("names of frames can't be shown", partial(self._choose, page, own))
        of_pages = [self._pages[page] for page in shown]
        places = self._scene.places({name for own in of_pages for name in own.chosen})
        for own in of_pages:
            self._try("names of frames can't be shown", partial(_show_labels, own, places))

    def _move_camera(self, page: str, own: _PageScene) -> None:
        """Let a camera stand where its place is now. While its user moves it, it stays, and then goes on from there."""
        place = place_of(own.following, self._view.poses)
        self._tell(page, own, is_gone=place is None)
        client, now = self._server.client(page), self._server.view_point(page)
        camera = self._server.camera(page)
        if place is None or client is None or now is None or camera is None:
            return
        if own.standing is None or own.is_held:
            own.standing = relative(own.following, place, now, camera)
        if not own.is_held:
            set_lens(client, own.following.kind, math.dist(*own.standing))
            self._server.look(page, view_in(place, own.standing))

    def _tell(self, page: str, own: _PageScene, *, is_gone: bool = False) -> None:
        """Tell a page how its camera moves, when that has changed."""
        told = {**own.following._asdict(), "is_gone": is_gone}
        if told != own.told:
            own.told = told
            self._answer(page, {"own_camera": {**told, "frame": shown_text(own.following.frame)}})

    def _hold(self, page: str, command: Mapping[str, Any]) -> None:
        own, is_held = self._pages.setdefault(page, _PageScene()), flag(command, "on")
        if own.is_held and not is_held:
            self._move_camera(page, own)  # where it was left, also where no picture was drawn meanwhile
        own.is_held = is_held

    def _set_camera(self, page: str, command: Mapping[str, Any]) -> None:
        kind, frame = text(command, "kind"), text(command, "frame")
        following = Following(kind, frame, turns=flag(command, "turns") and bool(frame))
        if following.kind not in CAMERA_KINDS:
            raise PageError(f"the kind of a camera is one of {', '.join(CAMERA_KINDS)}")
        if following.kind == "first_person" and not following.frame:
            raise PageError("select the frame out of which the camera is to look")
        if following.frame and not self._view.buffer.has_frame(following.frame):
            raise PageError(f"there is no frame {following.frame!r}")
        camera, now = self._camera(page)
        before = self._pages.setdefault(page, _PageScene()).following
        if before.kind == "first_person" and following.kind != "first_person":
            now = stepped_back(now)
        standing = eye() if following.kind == "first_person" else None
        self._begin(page, following, standing, rescaled(now, camera.fov_rad, following.kind))

    def _begin(self, page: str, following: Following, standing: ViewPoint | None, now: ViewPoint) -> None:
        """Let a camera move in another way, from where it stands in its place; None: from where it is now."""
        own = self._pages.setdefault(page, _PageScene())
        camera, client = self._server.camera(page), self._server.client(page)
        if camera is None or client is None:
            raise PageError("the scene has not told its camera yet")
        place = place_of(following, self._view.poses)
        if standing is None and place is not None:
            standing = relative(following, place, now, camera)
        own.following, own.standing, own.is_held = following, standing, False
        set_lens(client, following.kind, math.dist(*now))
        if place is not None and standing is not None:
            self._server.look(page, view_in(place, standing))
        self._tell(page, own, is_gone=place is None)

    def _save_view(self, page: str, command: Mapping[str, Any]) -> None:
        name = text(command, "name").strip()
        view = self.saved_view(page, name)
        if not name or len(name) > MAX_NAME:
            raise PageError(f"the name of a view has from 1 to {MAX_NAME} characters")
        if view is None:
            raise PageError("the scene has not told its camera yet")
        if name not in self._view.views and len(self._view.views) >= MAX_VIEWS:
            raise PageError(f"there are {MAX_VIEWS} views already")
        self._view.views[name] = view

    def _show_view(self, page: str, command: Mapping[str, Any]) -> None:
        view = self._view.views.get(text(command, "name"))
        if view is None:
            raise PageError("there is no view of this name")
        self._begin(page, Following(view.kind, view.frame, view.turns), view.camera, view.camera)

    def _forget_view(self, _: str, command: Mapping[str, Any]) -> None:
        if self._view.views.pop(text(command, "name"), None) is None:
            raise PageError("there is no view of this name")

    def _try(self, failure: str, do: Callable[[], None]) -> None:
        try:
            do()
        except Exception as error:  # of one page: the others have theirs
            self._report(f"{failure}: {fault_text(error)}")

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

    def _look(self, page: str, command: Mapping[str, Any]) -> None:
        """Let a page see the whole of what is at a place of its picture, from the side from which it looks."""
        spot = _spot(command)
        camera, view_point = self._camera(page)
        met = self._met(page, camera, spot)
        if met is None:
            raise PageError("there is nothing at this place")
        toward = [there - here for there, here in zip(view_point.position, view_point.look_at, strict=True)]
        fitted = view_of(self._extent_of(met), camera.fov_rad, camera.aspect, toward)
        if not self.look(page, fitted):
            raise PageError("the scene is gone")

    def _place_at(self, page: str, spot: _Spot) -> Place:
        """Return the place that a place of a page's picture shows.

        Raises:
            PageError: there is nothing.
        """
        camera, _ = self._camera(page)
        met = self._met(page, camera, spot)
        if isinstance(met, str):
            x, y, z = self._view.poses.positions[self._view.poses.index_of(met)].tolist()
            return Place((x, y, z), met)
        if met is not None:
            return Place(met.point, met.display)
        floor = floor_point(camera, spot.across, spot.down)
        if floor is None:
            raise PageError("there is nothing at this place")
        return Place((*floor, 0.0), "the floor")

    def _add_to_measure(self, page: str, command: Mapping[str, Any]) -> None:
        place, client = self._place_at(page, _spot(command)), self._server.client(page)
        own = self._pages.setdefault(page, _PageScene())
        if client is None:
            raise PageError("the scene is gone")
        if own.measure is None or own.measure.scene is not client.scene:
            own.measure = Measure(client.scene, self._view.fixed_frame)
        said = own.measure.add(place)
        told = {
            "places": [list(kept.point) for kept in own.measure.places],
            "distance_m": own.measure.distance_m,
        }
        self._answer(page, {"measured": told, "done": said})

    def _end_measure(self, page: str, _: Mapping[str, Any], said: str = "") -> None:
        own = self._pages.get(page)
        if own is not None and own.measure is not None:
            own.measure.clear()
            own.measure = None
            self._answer(page, {"measured": {"places": [], "distance_m": 0.0}, "done": said})

    def _focus(self, page: str, command: Mapping[str, Any]) -> None:
        """Let a page's camera turn about what is at a place of its picture."""
        place, (_, now) = self._place_at(page, _spot(command)), self._camera(page)
        if math.dist(now.position, place.point) < MIN_FOCUS_M:
            raise PageError("the camera is there")
        if not self.look(page, ViewPoint(now.position, place.point)):
            raise PageError("the scene is gone")
        self._answer(page, {"done": f"the camera turns about {shown_text(place.name)}"})

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

    COMMANDS: ClassVar[dict[str, Callable[[PageScenes, str, Mapping[str, Any]], None]]] = {
        "pointer": _point,
        "look": _look,
        "held": _hold,
        "camera": _set_camera,
        "save_view": _save_view,
        "show_view": _show_view,
        "forget_view": _forget_view,
        "measure": _add_to_measure,
        "end_measure": _end_measure,
        "focus": _focus,
    }
    """What a page asks of its own scene."""


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
