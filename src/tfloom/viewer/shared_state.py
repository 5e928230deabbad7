"""The view that all pages share: fixed frame, time, selected frames, trails and displays; and what follows of it."""

from __future__ import annotations

import itertools
import math
import time
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tfloom.common.terminal import report
from tfloom.tf2.buffer import LATEST
from tfloom.tf2.errors import TransformException
from tfloom.tf2.transform import Transform
from tfloom.tf2_tools.diagnosis.report import diagnose
from tfloom.tf2_tools.diagnosis.subject import Subject
from tfloom.tf2_tools.text import matrix_from_quaternion, rpy_from_matrix, transform_text
from tfloom.tf2_tools.top.rows import Health, Rates, Row, rows_of
from tfloom.tf2_tools.watch.model import stored_name
from tfloom.viewer.displays.camera_info import CameraDisplay, images_of
from tfloom.viewer.displays.display import MAX_COORDINATE_M, shown_text
from tfloom.viewer.displays.kinds import INTERACTIVE, LABELS, PAIRED, Kind, kind_of, kinds_of
from tfloom.viewer.displays.robot_model import RobotDisplay
from tfloom.viewer.displays.settings import FRAME_SETTINGS, SettingError, to_file, usual_values
from tfloom.viewer.extents import Extent, extent_of
from tfloom.viewer.feed import Feed
from tfloom.viewer.frames import (
    FramePoses,
    Span,
    connected_from,
    default_fixed_frame,
    frames_at,
    frames_behind,
    span_of,
    trail_of,
)
from tfloom.viewer.layout.layout import DEFAULT_AXES_M, MAX_PLOT, DisplayLayout, Layout, SavedView, ViewPoint
from tfloom.viewer.obstacles import MAX_STATUS
from tfloom.viewer.page_command import (
    MAX_TEXTS,
    PageError,
    fault_text,
    flag,
    number,
    stamp,
    text,
    texts,
    whole,
)
from tfloom.viewer.playback import Playback
from tfloom.viewer.plots.plots import Plots
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topics import RESET_NS

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from tfloom.tf2.buffer import Buffer
    from tfloom.tf2_tools.diagnosis.finding import Finding
    from tfloom.tf2_tools.watch.sources import Source
    from tfloom.viewer.displays.settings import Setting, Value
    from tfloom.viewer.drawing import Pose
    from tfloom.viewer.interactive.markers_feed import Station
    from tfloom.viewer.scene import Scene
    from tfloom.viewer.shapes import Shape
    from tfloom.viewer.topic_log import Cursor, Entry
    from tfloom.viewer.topics import Topics

__all__ = ["MAX_TRAILS", "MAX_VIEWS", "SharedView"]

LOOK_S = 0.5
"""Period at which rates, ages and publishers are observed [s]."""
DIAGNOSE_S = 2.0
"""Period at which the transforms are checked [s]."""
TRAIL_S = 0.2
"""Period at which trails are drawn anew [s]."""
MAX_TRAILS = 20
"""Number of trails; of a layout with more, the first ones are shown."""
MAX_DISPLAYS = 100
MAX_VIEWS = 100
"""Number of saved views; of a layout with more, the first ones are kept."""
MAX_ROWS = 1000
"""Number of rows of the tree that a page gets."""
MAX_FINDINGS = 100
MAX_PARTS = 200
"""Number of a display's parts, as namespaces, that a page gets."""
FAR_NOTE = f"further than {MAX_COORDINATE_M:g} m: not drawn"
NO_KIND = Kind("", "", "")
"""Of a row whose topic has no display."""
PLOT_POINTS = 300
"""Number of points of the plot of the selected frames."""


class SharedView:
    """What is shown. One thread may use it.

    Args:
        source: The transforms, with a buffer.
        topics: The topics.
        scene: The scene to draw in.
        is_live: Whether they are of a graph, whose newest time is shown until the user holds one; a recording is
            played.
        is_simulated: Whether the time is that of /clock, which goes back where a simulation is reset.
        history_ns: How long the numbers of plots are kept [ns], if they are of a graph.
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.
        report: Called with a sentence about a part of the view that can't be shown, which doesn't end the others.
    """

    recorded_span: Span | None = None
    """The time of a recording, which counts where no frame moves; None without one."""

    def __init__(
        self,
        source: Source,
        topics: Topics,
        scene: Scene,
        *,
        is_live: bool,
        is_simulated: bool = False,
        history_ns: int = 60_000_000_000,
        fixed_frame: str = "",
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        if source.buffer is None:
            raise ValueError("a view is of a source with a buffer")
        self.buffer: Buffer = source.buffer
        self.topics = topics
        self._source = source
        self._scene = scene
        self._is_live = is_live
        self._is_simulated = is_simulated
        self._report = report
        self._chosen_frame = _sendable(fixed_frame)
        self._now_ns = 0
        """The graph's time when it was read last [ns since epoch]."""
        self._is_suspended = False
        self._held_ns: int | None = None
        self._playback = None if is_live else Playback()
        self._start_offset_s: float | None = None
        """Where a recording begins, as the command line or a layout says, which is saved again; None: neither does."""
        self._selected: list[str] = []
        self._marked: list[str] = []
        """The frames of the finding that was clicked, as long as there is such a finding."""
        self._trails: list[str] = []
        self._feeds: dict[str, Feed] = {}
        """By the display's name: its topic, and of further displays of a topic a number behind it."""
        self._drawn: dict[str, list[tuple[Shape, Pose | None]]] = {}
        """What each display showed last."""
        self.near: Path | None = None
        """The folder of the robot's description, around which meshes are looked for; None where it is not known."""
        self.station: Station | None = None
        """What displays of interactive markers have of a live graph; None without one."""
        self.about: Callable[[str], str] = lambda _: ""
        """Returns a line about a selected frame, or an empty text."""
        self._wanted: dict[str, DisplayLayout] = {}
        """What to show as soon as its topic is there, by the display's name."""
        self._refusals: dict[str, tuple[str, str]] = {}
        """The topic, and why it could not be shown when that was asked for, by the display's name."""
        self.plots = Plots(topics, history_ns if is_live else None)
        self.views: dict[str, SavedView] = {}
        """The saved views by their names."""
        self._with_names = True
        self._axes_m = DEFAULT_AXES_M
        self._frame_settings: dict[str, Any] = usual_values(FRAME_SETTINGS)
        self._started_ns = time.time_ns()
        self._rates = Rates()
        self._rows: list[Row] = []
        self._parents: dict[str, str | None] = {}
        self._findings: list[Finding] = []
        self._next_look_s = self._next_trail_s = 0.0
        # A live graph is listened to before it is judged.
        self._next_diagnosis_s = time.monotonic() + DIAGNOSE_S if is_live else 0.0
        self._poses = FramePoses([], np.empty((0, 3)), np.empty((0, 4)), np.empty(0, np.int64))

    # What a page asks for.

    def command(self, command: Mapping[str, Any]) -> None:
        """Do what a page asks for.

        Raises:
            PageError: it can't be done.
        """
        do = {
            "fixed_frame": self._choose_fixed_frame,
            "hold": self._hold,
            "play": self._play,
            "select": lambda command: self.select(text(command, "frame")),
            "unselect": self._unselect,
            "mark": self._mark,
            "trail": self._set_trail,
            "display": lambda command: self.set_display(text(command, "topic"), on=flag(command, "on")),
            "another": lambda command: self._show_another(
                DisplayLayout(text(command, "topic"), kind=text(command, "kind"))
            ),
            "choose": self._choose,
            "set": self._set,
            "set_frames": self._set_frames,
            "names": self._show_names,
            "axes": self._set_axes,
            "plot": self._set_plot,
            "plot_choice": self._choose_plot,
            "plot_time": self._set_plot_time,
        }.get(text(command, "op"))
        if do is None:
            raise PageError("there is no such command")
        do(command)

    def _choose_fixed_frame(self, command: Mapping[str, Any]) -> None:
        self._chosen_frame = text(command, "frame")

    def _unselect(self, _: Mapping[str, Any]) -> None:
        self._selected.clear()

    def _mark(self, command: Mapping[str, Any]) -> None:
        frames = texts(command, "frames")
        self._marked = [] if frames == self._marked else frames

    def _choose(self, command: Mapping[str, Any]) -> None:
        topic = text(command, "topic")
        if (feed := self._feeds.get(topic)) is None:
            raise PageError(f"{topic} is not shown")
        feed.choose(text(command, "choice"))

    def _set(self, command: Mapping[str, Any]) -> None:
        name, setting = text(command, "topic"), text(command, "setting")
        if (feed := self._feeds.get(name)) is None:
            raise PageError(f"{name} is not shown")
        feed.set(setting, _setting_of(feed.kind.settings, feed.kind.label, setting, command.get("value")))

    def _set_frames(self, command: Mapping[str, Any]) -> None:
        name = text(command, "setting")
        value = _setting_of(FRAME_SETTINGS, "TF", name, command.get("value"))
        self._frame_settings[name] = FRAME_SETTINGS[name].usual if value is None else value

    def _show_another(self, display: DisplayLayout) -> None:
        """Show a topic once more, to set the second display in another way, or a display without a topic."""
        name = self._free_name(display.topic or display.kind)
        self._wanted[name] = display
        try:
            self.set_display(name, on=True)
        except PageError:
            self._wanted.pop(name, None)
            raise

    def _free_name(self, first: str) -> str:
        """Return the name of a further display of a topic, or of a kind."""
        numbered = (f"{first} #{number}" for number in itertools.count(2))
        return next(
            name for name in itertools.chain([first], numbered) if name not in {*self._feeds, *self._wanted}
        )

    def _show_names(self, command: Mapping[str, Any]) -> None:
        self._with_names = flag(command, "on")

    def _set_axes(self, command: Mapping[str, Any]) -> None:
        length = number(command, "length")
        if not 0.001 <= length <= 1000.0:
            raise PageError("axes are from 0.001 m to 1000 m long")
        self._axes_m = length

    def _set_plot(self, command: Mapping[str, Any]) -> None:
        topic, field = text(command, "topic"), text(command, "field").strip()
        if flag(command, "on"):
            place = whole(command, "plot") if command.get("plot") is not None else 0
            if not 0 <= place <= MAX_PLOT:
                raise PageError(f"the number of a plot is from 1 to {MAX_PLOT}")
            # The page that asked may have gone.
            self.plots.add(topic, field, number=place, is_there=not self._is_suspended)
        else:
            self.plots.remove(topic, field)

    def _choose_plot(self, command: Mapping[str, Any]) -> None:
        self.plots.choose(
            text(command, "topic"),
            text(command, "field"),
            number=whole(command, "plot"),
            axis=text(command, "axis"),
            unroll=flag(command, "unroll"),
        )

    def _set_plot_time(self, command: Mapping[str, Any]) -> None:
        length_s = None if command.get("length_s") is None else number(command, "length_s")
        self.plots.show_time(self._span(), length_s, stamp(command, "end_ns"))

    def plot_csv(self, command: Mapping[str, Any]) -> dict[str, Any]:
        """Return the number of a plot, and the numbers that it shows as the text of a file.

        Raises:
            PageError: there is no such plot, or it shows too many.
        """
        plot = whole(command, "plot")
        return {"plot": plot, "text": self.plots.csv(plot, self._span())}

    def _hold(self, command: Mapping[str, Any]) -> None:
        stamp_ns = stamp(command, "stamp_ns")
        span = self._span()
        if self._playback is not None:
            if span is not None:
                self._begun(self._playback, span).pause(span, stamp_ns)
        else:
            self._held_ns = stamp_ns if stamp_ns is None or span is None else span.clamped(stamp_ns)

    def _play(self, command: Mapping[str, Any]) -> None:
        on = flag(command, "on")
        span = self._span()
        if self._playback is None or span is None:
            raise PageError("there is nothing to play")
        playback = self._begun(self._playback, span)
        if on:
            playback.play(span)
        else:
            playback.pause(span)

    def select(self, frame: str) -> None:
        """Select a frame, in place of the first of two; a selected one is no longer selected."""
        if frame in self._selected:
            self._selected.remove(frame)
        elif self.buffer.has_frame(frame):
            self._selected = [*self._selected[-1:], frame]
        else:
            raise PageError(f"there is no frame {frame!r}")

    def _set_trail(self, command: Mapping[str, Any]) -> None:
        frame, on = text(command, "frame"), flag(command, "on")
        if frame in self._trails:
            self._trails.remove(frame)
        if on:
            if len(self._trails) >= MAX_TRAILS:
                raise PageError(f"there are {MAX_TRAILS} trails already")
            self._trails.append(frame)
        self._next_trail_s = 0.0

    def set_display(self, name: str, *, on: bool) -> None:
        """Show a topic, or no longer show it.

        Args:
            name: The topic, or the name of a further display of a topic.
            on: Whether to show it.

        Raises:
            PageError: there is no such topic, or nothing shows messages of its type.
        """
        self._refusals.pop(name, None)
        if not on:
            self._wanted.pop(name, None)
            if (feed := self._feeds.pop(name, None)) is not None:
                feed.close()
            self._drawn.pop(name, None)
            self._scene.draw_display(name, [])
            return
        if name in self._feeds:
            return
        wanted = self._wanted.get(name, DisplayLayout(name))
        if self._is_suspended:  # the page that asked has gone
            self._wanted[name] = wanted
            return
        try:
            feed = self._feeds[name] = self._opened_feed(wanted)
        except PageError as error:
            if wanted.topic in self.topics.types():
                self._refusals[name] = wanted.topic, str(error)
            raise
        self._wanted.pop(name, None)
        if wanted.choice and feed.display is not None:
            feed.display.choice = wanted.choice  # what there is to choose from is known by the first message
        for setting, value in wanted.settings:
            try:
                feed.set(setting, _setting_of(feed.kind.settings, feed.kind.label, setting, to_file(value)))
            except PageError as error:
                _print_missing(f"{setting} of {name}", error)

    def _opened_feed(self, wanted: DisplayLayout) -> Feed:
        kind, topic = self._kind_of(wanted), wanted.topic
        if len(self._feeds) >= MAX_DISPLAYS:
            raise PageError(f"there are {MAX_DISPLAYS} displays already")
        if not kind.has_topic:
            return Feed("", kind)
        try:
            settings: dict[str, Any] = dict(wanted.settings)
            cursor = self.topics.open(topic, settings.get("depth", 0) if "depth" in kind.settings else 0)
        except DisplayError as error:
            raise PageError(str(error)) from None
        try:
            feed = self._feed_of(kind, topic, cursor)
        except BaseException:
            cursor.close()
            raise
        feed.type_name = self.topics.types().get(topic, "")
        if isinstance(feed.display, RobotDisplay):
            feed.display.near = self.near
        return feed

    def _feed_of(self, kind: Kind, topic: str, cursor: Cursor) -> Feed:
        if kind.label in PAIRED:
            from tfloom.viewer.paired_feed import PairedFeed

            return PairedFeed(topic, kind, cursor, self.topics)
        if kind.label != INTERACTIVE:
            return Feed(topic, kind, cursor)
        if self.station is None:
            raise PageError("interactive markers are of a live graph: here is no server of them to be asked")
        from tfloom.viewer.interactive.markers_feed import MarkersFeed

        return MarkersFeed(topic, kind, cursor, self.station)

    def choose_entry(self, client: int, command: Mapping[str, Any]) -> None:
        """Choose an entry of the menu of an interactive marker.

        Args:
            client: Viser's number of the page's scene.
            command: What the page asks for.

        Raises:
            PageError: it can't be chosen.
        """
        topic = text(command, "topic")
        if (feed := next((feed for feed in self._feeds.values() if feed.topic == topic), None)) is None:
            raise PageError(f"{shown_text(topic)} is not shown")
        feed.choose_entry(client, command)

    def _kind_of(self, wanted: DisplayLayout) -> Kind:
        """Return the kind of a display that is wanted.

        Raises:
            PageError: there is no such topic, or nothing shows messages of its type, or not in this way.
        """
        asked = LABELS.get(wanted.kind)
        if asked is not None and not asked.has_topic:
            return asked
        type_name = self.topics.types().get(wanted.topic)
        if type_name is None:
            raise PageError(f"there is no topic {wanted.topic!r}")
        kinds = kinds_of(wanted.topic, type_name)
        if not kinds:
            raise PageError(f"no display shows {type_name}")
        return next((kind for kind in kinds if kind.label == wanted.kind), kinds[0])

    def feed(self, topic: str) -> Feed | None:
        """Return what a display shows; None if the topic isn't shown."""
        return self._feeds.get(topic)

    def image_entries(self) -> dict[str, Entry]:
        """Return the message of each image at the time that is shown."""
        held_ns = self.shown_ns(self._span())
        images = [
            (topic, feed.newest(held_ns)) for topic, feed in self._feeds.items() if feed.display is None
        ]
        return {topic: entry for topic, entry in images if entry is not None}

    def want(self, topic: str, choice: str = "", settings: tuple[tuple[str, Value], ...] = ()) -> None:
        """Show a topic as soon as it is there, with what is chosen and set for it."""
        self._wanted.setdefault(topic, DisplayLayout(topic, choice, settings))

    def _want_another(self, display: DisplayLayout) -> None:
        """Show a topic as soon as it is there, besides what is shown of it; not twice in the same way."""
        shown = [*map(_layout_of, self._feeds.values()), *self._wanted.values()]
        if display not in shown:
            # A topic that is shown without settings of its own is shown as the layout says.
            first = display.topic or display.kind
            if first in self._feeds and self._feeds[first].is_plain:
                self.set_display(first, on=False)
            self._wanted[self._free_name(first)] = display

    def apply(self, layout: Layout) -> None:
        """Show what a layout says, each topic as soon as it is there."""
        self._chosen_frame = _sendable(layout.fixed_frame)
        self._with_names = layout.with_names
        self._axes_m = layout.axes_m
        self._trails = list(dict.fromkeys(map(_sendable, layout.trails[:MAX_TRAILS])))
        self.views |= {view.name: view for view in layout.views[:MAX_VIEWS]}
        self._start_offset_s = layout.start_offset_s
        if layout.start_offset_s is not None and not self._is_live:
            try:
                self.start_after(layout.start_offset_s)
            except ValueError as error:
                report(
                    f"tfloom: the layout's start_offset, {layout.start_offset_s:g} s, is not used: {error}"
                )
        self._frame_settings |= dict(layout.frames)
        for display in layout.displays[:MAX_DISPLAYS]:
            self._want_another(display)
        free = itertools.count(1 + max((plot.plot for plot in layout.plots), default=0))
        for plot in layout.plots:
            try:
                place = plot.plot or min(next(free), MAX_PLOT)
                self.plots.add(plot.topic, plot.field, number=place, is_there=False)
                self.plots.choose(plot.topic, plot.field, number=place, axis=plot.axis, unroll=plot.unroll)
            except PageError as error:  # the others are plotted
                _print_missing(f"{plot.field} of {plot.topic}", error)

    def placed(self, layout: Layout) -> ViewPoint | None:
        """Return from where a layout looks, in the fixed frame; None where it doesn't say, or its frame is not known.

        Any thread may call it.
        """
        if layout.camera is None or not layout.camera_frame:
            return layout.camera
        try:
            pose = self.buffer.lookup(self.fixed_frame, _sendable(layout.camera_frame))
        except TransformException:
            return None
        yaw_rad = pose.transform.rpy_rad[2] if layout.camera_turns else 0.0
        place = Transform.from_rpy(0.0, 0.0, yaw_rad, pose.translation)
        return ViewPoint(place.apply(layout.camera.position), place.apply(layout.camera.look_at))

    def layout(self, camera: ViewPoint | None) -> Layout:
        """Return what is shown now, with a page's camera."""
        displays = [*map(_layout_of, self._feeds.values()), *self._wanted.values()]
        return Layout(
            fixed_frame=self.fixed_frame,
            with_names=self._with_names,
            axes_m=self._axes_m,
            frames=tuple(
                (name, value)
                for name, value in self._frame_settings.items()
                if value != FRAME_SETTINGS[name].usual
            ),
            trails=tuple(self._trails),
            displays=tuple(displays),
            plots=self.plots.layout(),
            camera=camera,
            views=tuple(self.views.values()),
            start_offset_s=self._start_offset_s,
        )

    def suspend(self) -> None:
        """End reading topics, because nobody looks."""
        self._is_suspended = True
        self.plots.suspend()
        for feed in self._feeds.values():
            feed.close()

    def resume(self) -> None:
        """Read the topics of the displays again, and show what they have from now on."""
        self._is_suspended = False
        for name, feed in list(self._feeds.items()):
            try:
                if feed.kind.has_topic:
                    if self.topics.types().get(feed.topic) != feed.type_name:
                        raise DisplayError("it has another type now, or none")  # noqa: TRY301  # as if refused
                    feed.read(self.topics.open(feed.topic, feed.depth))
            except Exception:  # of one topic, which is tried again: the others are read
                self.set_display(name, on=False)
                self._wanted[name] = _layout_of(feed)

    def look_at_clock(self) -> None:
        """Begin anew where the time on /clock has gone back, as that of a simulation does that is reset.

        What is shown belongs to the run before, and would stay, as newer than all that comes. Publishers that keep
        messages for late subscriptions send them again. Called also while nobody looks.
        """
        before_ns, self._now_ns = self._now_ns, self._source.now_ns()
        if not self._is_simulated or self._now_ns > before_ns - RESET_NS:
            return
        self._report("the time on /clock has gone back: what is shown begins anew")
        self._held_ns = None
        self.buffer.clear()
        self.plots.clear()
        self.topics.begin_anew()
        for feed in self._feeds.values():
            feed.forget()
        if not self._is_suspended:
            self.resume()

    def _show_wanted(self) -> None:
        types = self.topics.types()
        for name in [name for name, wanted in self._wanted.items() if wanted.topic in {*types, ""}]:
            try:
                self.set_display(name, on=True)
            except PageError as error:
                _print_missing(name, error)
            self._wanted.pop(name, None)

    def _look_at_topics(self) -> None:
        """Let the displays know why no messages come."""
        types = self.topics.types()
        self._refusals = {name: kept for name, kept in self._refusals.items() if kept[0] in types}
        for feed in self._feeds.values():
            if feed.kind.has_topic:
                feed.is_published = feed.topic in types
                feed.silence = self.topics.silence(feed.topic, feed.type_name)

    # What follows of it.

    @property
    def fixed_frame(self) -> str:
        """The fixed frame: without transforms that of what is shown; empty while there is nothing."""
        found = self._chosen_frame or default_fixed_frame(self.buffer.parents())
        return found or next(filter(None, (feed.frame_id for feed in list(self._feeds.values()))), "")

    def _span(self) -> Span | None:
        """Return the time through which the slider goes; None where nothing moves."""
        return span_of(self.buffer) or self.recorded_span

    def shown_ns(self, span: Span | None) -> int | None:
        """Return the time that is shown [ns since epoch]; None: the newest."""
        if self._playback is not None and span is not None:
            return self._begun(self._playback, span).now_ns(span)
        if self._held_ns is None or span is None:
            return None
        return span.clamped(self._held_ns)

    def start_after(self, offset_s: float) -> None:
        """Let a recording begin so long after its first transform [s], not where its frames connect.

        Raises:
            ValueError: it ends before.
        """
        span = self._span()
        length_s = 0.0 if span is None else (span.end_ns - span.start_ns) / 1e9
        if self._playback is None or span is None or not offset_s < length_s:
            raise ValueError(f"the transforms of the recording are of {length_s:.3f} s")
        self._playback.start_ns = span.start_ns + int(offset_s * 1e9)
        self._start_offset_s = offset_s

    def _begun(self, playback: Playback, span: Span) -> Playback:
        """Return what plays, which begins where the frames connect, as soon as it is known which one is fixed."""
        if playback.start_ns is None:
            playback.start_ns = connected_from(self.buffer, self.fixed_frame, span)
        return playback

    def draw(self) -> None:
        """Draw everything anew, and observe what is due."""
        now_s = time.monotonic()
        self._try("messages can't be taken", self.topics.poll)
        self._try("plots can't be drawn", self.plots.poll)
        if now_s >= self._next_look_s:
            self._next_look_s = now_s + LOOK_S
            self._try("transforms can't be checked", lambda: self._look(now_s))
            self._try("displays can't be opened", self._show_wanted)
            self._try("topics can't be checked", self._look_at_topics)
            self._try("plots can't be opened", self.plots.look)
        fixed, held_ns = self.fixed_frame, self.shown_ns(self._span())
        self._try("frames can't be drawn", lambda: self._draw_frames(fixed, held_ns))
        if now_s >= self._next_trail_s:
            self._next_trail_s = now_s + TRAIL_S
            self._try("trails can't be drawn", lambda: self._draw_trails(fixed, held_ns))
        self._try("the selected frames can't be drawn", self._draw_selection)
        self._try("the frames of a finding can't be drawn", self._draw_marks)
        self._try("images of cameras can't be drawn", lambda: self._give_images(held_ns))
        is_gridless = all(feed.kind.label != "Grid" for feed in self._feeds.values())
        self._try("the floor can't be drawn", lambda: self._scene.show_floor(is_shown=is_gridless))
        now_ns = self._source.now_ns() if held_ns is None else held_ns
        for topic, feed in self._feeds.items():
            try:
                drawn = self._drawn[topic] = feed.draw(self.buffer, fixed, held_ns, now_ns)
                fault = self._scene.draw_display(topic, drawn, feed.frames(), feed.on_click, feed.on_drag)
                feed.status = feed.status or shown_text(fault)
            except Exception as error:  # of one display: the others are drawn
                feed.fail(error)
                self._try(f"{topic} can't be taken away", partial(self._scene.draw_display, topic, []))

    @property
    def selected(self) -> list[str]:
        """The selected frames."""
        return list(self._selected)

    @property
    def poses(self) -> FramePoses:
        """The frames, in the fixed one."""
        return self._poses

    @property
    def axes_m(self) -> float:
        """Length of a frame's axes [m]."""
        return self._axes_m

    @property
    def drawn(self) -> Mapping[str, list[tuple[Shape, Pose | None]]]:
        """What each display shows, with the poses of its shapes in the fixed frame."""
        return self._drawn

    def parts_of(self, display: str, index: int) -> list[tuple[Shape, Pose | None]]:
        """Return the shapes of what one of a display's is a part of: those of its link, or itself."""
        shapes, feed = self._drawn[display], self._feeds.get(display)
        frames = feed.frames() if feed is not None else ()
        if index >= len(frames):
            return [shapes[index]]
        return [shape for shape, frame in zip(shapes, frames, strict=False) if frame == frames[index]]

    def extent(self) -> Extent | None:
        """Return the box around all that is shown, in the fixed frame; None where nothing is."""
        drawn = itertools.chain.from_iterable(
            drawn for name, drawn in self._drawn.items() if self._feeds[name].kind.label != "Grid"
        )
        frames = self._poses.positions
        return extent_of(np.concatenate([frames - self._axes_m, frames + self._axes_m]), drawn)

    @property
    def is_empty(self) -> bool:
        """Whether nothing is shown: no frame, no display."""
        return (
            not self._poses.names
            and not any(self._drawn.values())
            and not any(feed.display is None for feed in self._feeds.values())
        )

    @property
    def is_whole(self) -> bool:
        """Whether all that was asked for is shown: nothing is still read."""
        displays = [feed.display for feed in self._feeds.values()]
        topics = {wanted.topic for wanted in self._wanted.values()}
        return topics.isdisjoint(self.topics.types()) and all(
            display.is_whole for display in displays if isinstance(display, RobotDisplay)
        )

    def _try(self, failure: str, do: Callable[[], object]) -> None:
        """Do a part. What it raises is reported, and ends no other part."""
        try:
            do()
        except Exception as error:  # whatever a message, a page or a file makes it raise
            self._report(f"{failure}: {fault_text(error)}")

    def _draw_frames(self, fixed: str, held_ns: int | None) -> None:
        self._poses = frames_at(self.buffer, fixed, LATEST if held_ns is None else held_ns)
        stale = {row.child for row in self._rows if row.health is Health.STALE} if held_ns is None else set()
        behind = frames_behind(self._parents, stale, fixed, self._poses.names)
        settings = self._frame_settings
        hidden = {*settings["hidden_frames"], *self._timed_out(held_ns)}
        self._scene.draw_frames(
            self._poses.without(hidden),
            behind,
            with_names=self._with_names,
            axes_m=self._axes_m,
            with_axes=settings["show_axes"],
            with_arrows=settings["show_arrows"],
        )

    def _timed_out(self, held_ns: int | None) -> Iterable[str]:
        """Return the frames of which nothing has come for the timeout; none at a time that is held."""
        timeout_s = self._frame_settings["timeout_s"]
        if held_ns is not None or not timeout_s:
            return ()
        return (
            stored_name(row.child)
            for row in self._rows
            if row.health is not Health.STATIC and row.age_s is not None and row.age_s > timeout_s
        )

    def _draw_trails(self, fixed: str, held_ns: int | None) -> None:
        self._scene.draw_trails(
            {frame: trail_of(self.buffer, fixed, frame, held_ns) for frame in self._trails}
        )

    def _draw_selection(self) -> None:
        places = [self._poses.index_of(frame) for frame in self._selected]
        self._scene.draw_selection([self._poses.positions[place] for place in places if place >= 0])

    def _draw_marks(self) -> None:
        marked = [place for frame in self._marked if (place := self._poses.index_of(frame)) >= 0]
        self._scene.draw_marks(self._poses.positions[marked])

    def _give_images(self, held_ns: int | None) -> None:
        """Let the pyramids of cameras have the images that are shown."""
        images = [feed.topic for feed in self._feeds.values() if feed.display is None]
        for feed in self._feeds.values():
            if isinstance(feed.display, CameraDisplay):
                chosen = feed.display.offer(images_of(feed.topic, images))
                image = self._feeds.get(chosen)
                feed.display.set_image(None if image is None else image.newest(held_ns))

    def _look(self, now_s: float) -> None:
        seen = self._source.observation()
        self._rates.add(seen, now_s)
        self._rows = rows_of(seen, self._source.now_ns(), self._rates)
        self._parents = self.buffer.parents()
        if now_s >= self._next_diagnosis_s:
            self._next_diagnosis_s = now_s + DIAGNOSE_S
            started_ns = self._started_ns if self._is_live else seen.started_ns
            self._findings = diagnose(Subject(seen, (started_ns, seen.taken_ns)))
            if self._marked not in map(_frames_of, self._findings):
                self._marked = []

    def snapshot(self) -> dict[str, Any]:
        """Return what pages show beside the scene, as values for JSON."""
        span = self._span()
        held_ns = self.shown_ns(span)
        return {
            "is_live": self._is_live,
            "is_playing": self._playback is not None and self._playback.is_playing,
            "span": None if span is None else [str(span.start_ns), str(span.end_ns)],
            "held_ns": None if held_ns is None else str(held_ns),
            "fixed_frame": shown_text(self.fixed_frame),
            "frames": sorted(map(_sendable, self._parents))[:MAX_ROWS],
            "rows": self._listed("frames", lambda: map(self._row, self._rows[:MAX_ROWS])),
            "with_names": self._with_names,
            "views": list(map(_sendable, self.views)),
            "axes_m": self._axes_m,
            "frame_settings": self._frame_settings,
            "trails": list(map(_sendable, self._trails)),
            "selection": self._selection(held_ns),
            "marked": list(map(_sendable, self._marked)),
            "findings": self._listed("findings", lambda: map(self._finding, self._findings[:MAX_FINDINGS])),
            "displays": self._listed("displays", self._displays),
            "plots": self._listed("plots", lambda: self.plots.snapshot(span, held_ns)),
            "plot_time": self.plots.time(span),
        }

    def _listed(self, what: str, values: Callable[[], Iterable[dict[str, Any]]]) -> list[dict[str, Any]]:
        """Return what a panel lists; nothing where that raises, which is reported: pages get the other panels."""
        listed: list[dict[str, Any]] = []
        self._try(f"the list of {what} can't be shown", lambda: listed.extend(values()))
        return listed

    def _row(self, row: Row) -> dict[str, Any]:
        return {
            "frame": _sendable(stored_name(row.child)),
            "name": shown_text(row.child),
            "prefix": row.prefix,
            "parent": shown_text(row.parent),
            "rate_hz": _finite(row.rate_hz),
            "age_s": _finite(row.age_s),
            "publisher": shown_text(row.publisher),
            "health": row.health.name.lower(),
            "note": shown_text(row.note or (FAR_NOTE if stored_name(row.child) in self._poses.far else "")),
        }

    def _finding(self, finding: Finding) -> dict[str, Any]:
        return {
            "code": finding.code,
            "severity": finding.kind.severity.value,
            "summary": shown_text(finding.summary, 1000),
            "mend": finding.kind.mend,
            "frames": _frames_of(finding),
        }

    def _displays(self) -> list[dict[str, Any]]:
        types = self.topics.types()
        rows = []
        for name in sorted({*types, *self._feeds, *self._refusals, *self._wanted}):
            feed, wanted = self._feeds.get(name), self._wanted.get(name)
            kind = feed.kind if feed is not None else kind_of(name, types.get(name, ""))
            _, refusal = self._refusals.get(name, ("", ""))
            status = refusal if feed is None else feed.status
            if wanted is not None and wanted.topic not in types:
                status = "nobody publishes it yet"
            if kind is None and not status:
                continue
            if kind is None:
                kind = LABELS.get(wanted.kind if wanted is not None else "", NO_KIND)
            again = [] if feed is None else kinds_of(feed.topic, types.get(feed.topic, ""))
            display = None if feed is None else feed.display
            rows.append(
                {
                    "topic": _sendable(name),
                    "of_topic": _sendable(
                        feed.topic if feed is not None else wanted.topic if wanted else name
                    ),
                    "kinds": [one.label for one in again],
                    "values": {} if feed is None else feed.values,
                    "parts": [] if feed is None else list(map(_sendable, feed.parts()[:MAX_PARTS])),
                    "kind": kind.label,
                    "on": feed is not None or wanted is not None,
                    "is_image": feed is not None and not kind.module,
                    "status": shown_text(status, MAX_STATUS),
                    "choices": [] if display is None else [shown_text(choice) for choice in display.choices],
                    "choice": "" if display is None else display.choice,
                }
            )
        return rows

    def _selection(self, held_ns: int | None) -> dict[str, Any] | None:
        if not self._selected:
            return None
        frames = list(map(_sendable, self._selected))
        first, second = self._selected if len(frames) == 2 else (self.fixed_frame, self._selected[0])
        about = [line for line in map(self.about, self._selected) if line]
        if first == second:
            return {"frames": frames, "text": "\n".join([*about, "It is the fixed frame."]), "plot": None}
        try:
            transform = self.buffer.lookup(first, second, LATEST if held_ns is None else held_ns)
            echo = transform_text(transform.stamp_ns, transform.translation, transform.rotation_xyzw)
            return {"frames": frames, "text": "\n".join([*about, echo]), "plot": self._plot(first, second)}
        except Exception as error:  # of these frames: pages get the other panels
            return {"frames": frames, "text": shown_text(fault_text(error), 1000), "plot": None}

    def _plot(self, first: str, second: str) -> dict[str, Any] | None:
        """Return the transform between two frames over the whole history; None where nothing moves."""
        try:
            way = self.buffer.trajectory(first, second, strict=False)
        except TransformException:
            return None
        count = len(way.stamps_ns)
        if count < 2:
            return None
        chosen = np.unique(np.linspace(0, count - 1, min(count, PLOT_POINTS)).astype(int))
        yaws = [
            rpy_from_matrix(matrix_from_quaternion(rotation))[2]
            for rotation in way.rotations_xyzw[chosen].tolist()
        ]
        return {
            "seconds": ((way.stamps_ns[chosen] - way.stamps_ns[-1]) / 1e9).round(4).tolist(),
            "end_ns": str(int(way.stamps_ns[-1])),
            **{axis: _rounded(way.positions[chosen, column]) for column, axis in enumerate("xyz")},
            "yaw_deg": np.degrees(np.unwrap(yaws)).round(3).tolist(),
        }


def _layout_of(feed: Feed) -> DisplayLayout:
    choice = "" if feed.display is None else feed.display.choice
    return DisplayLayout(feed.topic, choice, tuple(feed.settings.items()), feed.kind.label)


def _setting_of(settings: Mapping[str, Setting], label: str, name: str, value: Any) -> Value | None:
    """Return a value that a page sets; None stands for the usual one.

    Raises:
        PageError: there is no such setting, or it can't have this value.
    """
    if name not in settings:
        raise PageError(f"{label} has no setting {name!r}")
    try:
        return None if value is None else settings[name].taken(value)
    except SettingError as error:
        raise PageError(f"{name} {error}") from None


def _print_missing(what: str, error: PageError) -> None:
    """Print why something that was asked for at the start is not shown: there may be no page to get it."""
    report(f"tfloom: {shown_text(what)} is not shown: {shown_text(str(error), 500)}")


def _frames_of(finding: Finding) -> list[str]:
    """Return the frames that a finding concerns, as many as a page may ask to mark."""
    return [_sendable(frame) for frame in finding.frames[:MAX_TEXTS]]


def _sendable(name: str) -> str:
    """Return a name as JSON and a page can take it: the same one, but for halves of surrogate pairs."""
    return name.encode("utf-8", "replace").decode()


def _rounded(values: NDArray[np.float64]) -> list[float]:
    """Return numbers with few digits; one that is too large to be rounded stays as it is."""
    with np.errstate(over="ignore"):
        rounded = values.round(5)
    kept: list[float] = np.where(np.isfinite(rounded), rounded, values).tolist()
    return kept


def _finite(value: float | None) -> float | None:
    return round(value, 4) if value is not None and math.isfinite(value) else None
