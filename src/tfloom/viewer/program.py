"""The viewer: a loop that draws while a page is open, and rests while none is."""

from __future__ import annotations

import math
import queue
import threading
import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.common.files import write_file
from tfloom.viewer.camera import floor_point
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.displays.kinds import described_settings
from tfloom.viewer.extents import view_of
from tfloom.viewer.forms.sending import FORM_COMMANDS
from tfloom.viewer.interactive.markers_feed import Station
from tfloom.viewer.joints import joint_command, joint_rows
from tfloom.viewer.layout.layout import Layout
from tfloom.viewer.layout.layout_file import layout_text
from tfloom.viewer.layout.rviz_text import rviz_text
from tfloom.viewer.live_only import empty_text
from tfloom.viewer.log_lines import MAX_LINES
from tfloom.viewer.node_graph import node_graph
from tfloom.viewer.page_command import PageError, fault_text, number, text
from tfloom.viewer.page_scenes import PageScenes
from tfloom.viewer.page_server import CLOSED, PageServer
from tfloom.viewer.pictures import picture_of
from tfloom.viewer.scene import Scene
from tfloom.viewer.scene_server import SceneServer
from tfloom.viewer.shared_state import MAX_TRAILS, SharedView
from tfloom.viewer.topics import TypeNotYetKnownError

if TYPE_CHECKING:
    from pathlib import Path

    from typing_extensions import Self

    from tfloom.tf2_tools.watch.sources import Source
    from tfloom.viewer.joints import Joints
    from tfloom.viewer.layout.layout import ViewPoint
    from tfloom.viewer.live_only import LiveOnly
    from tfloom.viewer.topic_log import Entry
    from tfloom.viewer.topics import Topics

__all__ = ["Viewer"]

DRAW_HZ = 30.0
STATE_S = 0.25
"""Period at which pages get what is beside the scene [s]; at once after a command."""
MAX_COMMANDS = 1000
"""Number of commands that wait; of more, the newest are dropped."""
MAX_NOTES = 100
"""Number of different faults that pages are told while some are open."""
MAX_NOTE = 2000
"""Length of a line that the viewer itself adds to the log [characters]."""
WARN = 30
"""The level of such a line."""
MOVED_CAMERA = 0.01
"""A camera that has moved by this part of its distance was moved by its user."""
FIT_S = 3.0
"""How long a new page is fitted to what comes [s], since there was something: frames and displays come one by one."""
SETTLE_S = 60.0
"""How long after that a page may look from where it began [s]: one that draws slowly takes what it is told, and then
places its first camera."""
TICK_S = 0.5
"""Longest wait for a command while no page is open [s]: so long takes an end."""

HERE_S = 2.0
"""How long after a page has said that it is there it may hold an interactive marker [s]: one that draws slowly says it
late."""

LIVE_COMMANDS = FORM_COMMANDS | {"floor", "drive", "graph", "parameters", "set_parameter"}
"""Commands that a recording has nobody for."""
LISTS = frozenset(("settings", "plot_topics", "plot_csv", "plot_fields"))
"""Commands that are answered with a list."""
AT_ONCE = FORM_COMMANDS | {"drive"}
"""Commands that other threads do, for which nobody waits until a picture is drawn."""


def _are_near(first: ViewPoint, second: ViewPoint) -> bool:
    """Return whether two view points are the same, but for what is lost on the way to a page."""
    apart_m = max(math.dist(first.position, second.position), math.dist(first.look_at, second.look_at))
    return apart_m < MOVED_CAMERA * math.dist(first.position, first.look_at)


def _graph_of(live: LiveOnly, command: Mapping[str, Any]) -> dict[str, Any]:
    graph = live.participant.graph
    with_services, with_actions = (command.get(name) is True for name in ("services", "actions"))
    service_ends = graph.service_ends() if with_services or with_actions else ()
    return node_graph(graph.endpoints(), service_ends, with_services=with_services, with_actions=with_actions)


class _Fitting(NamedTuple):
    """How a new page is fitted to what comes."""

    view_point: ViewPoint | None = None
    """From where it was told to look; None: not yet."""
    end_s: float = math.inf
    """Until when that is done, on the monotonic clock [s]."""
    start: ViewPoint | None = None
    """From where it looked before."""


class _InterruptedError(BaseException):
    """What is drawn is ended. No part's failure, which `except Exception` is for."""


class Viewer:
    """Shows transforms and topics to pages; a context manager that closes its ports on exit.

    Args:
        source: The transforms, with a buffer.
        topics: The topics.
        live: What else a graph has; None for a recording or a description.
        joints: The joints that pages move; None without a robot whose joints are to be moved.
        is_simulated: Whether the time is that of /clock.
        history_ns: How long the numbers of plots are kept [ns], if they are of a graph.
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.
    """

    def __init__(
        self,
        source: Source,
        topics: Topics,
        live: LiveOnly | None = None,
        *,
        joints: Joints | None = None,
        is_simulated: bool = False,
        history_ns: int = 60_000_000_000,
        fixed_frame: str = "",
    ) -> None:
        self._live = live
        self._joints = joints
        self._is_of_file = live is None and joints is not None
        self._topics = topics
        self._noted: set[str] = set()
        """What pages were told since one was opened, so that it isn't told with each picture."""
        self._commands: queue.SimpleQueue[tuple[str, dict[str, Any]]] = queue.SimpleQueue()
        self._server = SceneServer()
        scene = Scene(
            self._server.scene, lambda frame: self._queue_command("", {"op": "select", "frame": frame})
        )
        self.view = SharedView(
            source,
            topics,
            scene,
            is_live=live is not None,
            is_simulated=is_simulated,
            history_ns=history_ns,
            fixed_frame=fixed_frame,
            report=self._note_once,
        )
        self._heard_s: dict[str, float] = {}
        """When pages that may hold an interactive marker said last that they are there, on the monotonic clock [s]."""
        if live is not None:
            self.view.station = Station(
                live.participant, live.node, self._server.scene, self._is_holding, self._answer_client
            )
        if joints is not None:
            self.view.about = joints.about
        self.pages = PageServer(self._server, self._queue_command, self._image_of)
        self._scenes = PageScenes(self._server, self.view, scene, self.pages.answer, self._note_once)
        self._image_lock = threading.Lock()
        self._images: dict[str, tuple[Any, tuple[str, bytes] | None]] = {}
        """The last picture of each topic, with what it was made of."""
        self._entries: dict[str, Entry] = {}
        """What each topic of images shows now, exchanged by the loop."""
        self._image_faults: dict[str, str] = {}
        """Why the last picture of a topic could not be made."""
        self._asked_fields: dict[str, str] = {}
        """By page, the topic whose fields it asked for last, while the type of this topic is searched for."""
        self._is_open = False
        self._is_over: Callable[[], bool] = lambda: False
        self._is_at_work = False
        """Whether `interrupt` may end what is done."""
        self._layout = Layout()
        """What is shown from the start."""
        self._unfitted: dict[str, _Fitting] = {}
        """New pages whose camera is to see all there is."""
        self._settling: dict[str, _Fitting] = {}
        """Pages whose camera does, as they were told."""
        self.pages.view_point = self._view_point
        if live is not None:
            live.driving.on_refusal = self._note_refusal
        self.layout_path: Path | None = None
        """Where pages save the layout; None: each browser saves it as it saves files."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.pages.stop()
        self._server.stop()

    def _queue_command(self, page: str, command: dict[str, Any]) -> None:
        """Let the loop take a command; on any thread."""
        # The end of a page is taken in any case, because what the page has begun would go on for ever. It is compared
        # as an object: a page that sends the same words gets no place by that.
        if command is CLOSED and self._live is not None:
            self._live.driving.forget(page)
            self._live.forms.forget(page)
        if command is CLOSED:
            self._heard_s.pop(page, None)
        operation = command.get("op")  # of any type, because nothing of the command was checked yet
        if operation == "here":
            self._heard_s[page] = time.monotonic()
        elif isinstance(operation, str) and operation in AT_ONCE:
            self._do(page, command)
        elif command is CLOSED or self._commands.qsize() < MAX_COMMANDS:
            self._commands.put((page, command))

    def run(self, is_over: Callable[[], bool]) -> None:
        """Draw for the open pages until it is over; from then on, no page drives."""
        self._is_over = is_over
        try:
            self._is_at_work = True
            self._draw_until(is_over)
            self._is_at_work = False
        except _InterruptedError:
            pass
        finally:
            self._is_at_work = False
            if self._live is not None:
                self._live.driving.close()
            self._close()

    def interrupt(self) -> None:
        """End what `run` does, however long that takes; in a handler of a signal, on the thread that runs."""
        if self._is_at_work:  # until `run` has it: a library may catch any exception
            raise _InterruptedError

    def _draw_until(self, is_over: Callable[[], bool]) -> None:
        next_draw_s = next_state_s = 0.0
        while not is_over():
            now_s = time.monotonic()
            has_pages = self.pages.page_count > 0
            if has_pages != self._is_open:
                self._open() if has_pages else self._close()
            wait_s = max(0.0, next_draw_s - now_s) if has_pages else TICK_S
            if self._take_commands(wait_s):
                next_state_s = 0.0
            self._try("the clock can't be read", self.view.look_at_clock)
            now_s = time.monotonic()
            if not self._is_open or now_s < next_draw_s:
                continue
            # After a picture that took longer than its time, the next one isn't hurried: others share this machine.
            next_draw_s = max(next_draw_s + 1.0 / DRAW_HZ, now_s + 0.5 / DRAW_HZ)
            with self._server.atomic():
                self.view.draw()
            self._try("the scenes of pages can't be drawn", self._scenes.draw)
            self._try("images can't be shown", self._note_images)
            if now_s >= next_state_s:
                next_state_s = now_s + STATE_S
                self._try("cameras can't see all that is shown", self._fit_new_pages)
                asked, self._asked_fields = self._asked_fields, {}
                for page, topic in asked.items():
                    self._do(page, {"op": "plot_fields", "topic": topic})
                self._try("the state can't be sent", self._publish)

    def _open(self) -> None:
        self._is_open = True
        self._noted.clear()
        self._try("the topics of the displays are not read", self.view.resume)
        if self._live is not None:
            self._try("the log of the graph is not read", self._live.log.open)
            self._try("the topics of the tools are not open", self._live.tools.open)
            self._try("no robot can be driven", self._live.driving.open)

    def _try(self, failure: str, do: Callable[[], object]) -> None:
        """Do a part; where that fails, tell the pages, which get the others."""
        try:
            do()
        except Exception as error:  # whatever a message, a page or the wire makes it raise
            self._note_once(f"{failure}: {fault_text(error)}")

    def _note_once(self, said: str) -> None:
        """Tell the pages something that may be so with each picture."""
        if said not in self._noted and len(self._noted) < MAX_NOTES:
            self._noted.add(said)
            self._note(said)

    def _note(self, said: str) -> None:
        """Tell the pages something by a line of their log, also those that open later."""
        line = {
            "stamp_ns": str(time.time_ns()),
            "level": WARN,
            "name": "tfloom_view",
            "text": shown_text(said, MAX_NOTE),
        }
        self.pages.add_lines([line], MAX_LINES)

    def _close(self) -> None:
        self._is_open = False
        self._try("the topics of the displays are not closed", self.view.suspend)
        if self._live is not None:
            self._try("the log of the graph is not closed", self._live.log.close)
            self._try("the topics of the tools are not closed", self._live.tools.close)
            self._try("the topics of the forms are not closed", self._live.forms.leave_topics)

    def _publish(self) -> None:
        state = self.view.snapshot()
        state["is_recording"] = self._live is None and not self._is_of_file
        state["joints"] = None if self._joints is None else joint_rows(self._joints)
        state["empty"] = self._empty_text()
        if self._live is not None:
            state["drive_topics"] = [shown_text(topic) for topic in self._live.driving.topics()]
            self.pages.add_lines(self._live.log.take(), MAX_LINES)
        self.pages.publish(state)

    def _empty_text(self) -> str:
        """Return what the scene says as long as there is nothing in it; else an empty text."""
        if not self.view.is_empty:
            return ""
        if self._live is not None:
            return empty_text(self._live)
        return "There are no frames at this time." if self.view.buffer.parents() else "There are no frames."

    def _take_commands(self, wait_s: float) -> bool:
        """Do what pages ask for, and wait for the first command; return whether there was one."""
        try:
            page, command = self._commands.get(timeout=wait_s) if wait_s else self._commands.get_nowait()
        except queue.Empty:
            return False
        while True:
            self._do(page, command)
            try:
                page, command = self._commands.get_nowait()
            except queue.Empty:
                return True

    def _do(self, page: str, command: Mapping[str, Any]) -> None:
        try:
            self._run_command(page, command)
        except Exception as error:  # whatever a page asks for ends nothing but this command
            if page:
                self.pages.answer(page, {"error": shown_text(fault_text(error), 500)})

    def _run_command(self, page: str, command: Mapping[str, Any]) -> None:
        operation = text(command, "op")
        if operation in {"opened", "fit_start", "closed"}:
            self._follow_page(page, operation)
        elif operation == "layout":
            self._save_layout(page, for_rviz=command.get("form") == "rviz")
        elif operation in {"fit", "joint", "pose"}:
            self._show_robot(page, operation, command)
        elif operation in PageScenes.COMMANDS:
            self._scenes.command(page, operation, command)
        elif operation == "marker_menu":
            self.view.choose_entry(self._server.client_of(page), command)
        elif operation in LISTS:
            self._list(page, operation, command)
        elif operation not in LIVE_COMMANDS:
            self.view.command(command)
        elif self._live is None:
            what = "file" if self._is_of_file else "recording"
            raise PageError(f"this is a {what}: there is nobody to ask")
        else:
            self._run_live_command(self._live, page, operation, command)

    def _list(self, page: str, operation: str, command: Mapping[str, Any]) -> None:
        """Give a page what it lists."""
        if operation == "settings":
            self.pages.answer(page, {"settings": described_settings()})
        elif operation == "plot_topics":
            self.pages.answer(page, {"plot_topics": self.view.plots.topics()})
        elif operation == "plot_csv":
            self.pages.answer(page, {"plot_csv": self.view.plot_csv(command)})
        else:
            self._list_fields(page, text(command, "topic"))

    def _is_holding(self, client: int) -> bool:
        """Return whether the scene of viser's client is there, and its page was heard of lately."""
        page = self._server.page_of(client)
        return page is not None and time.monotonic() - self._heard_s.get(page, -math.inf) < HERE_S

    def _answer_client(self, client: int, answer: dict[str, Any]) -> None:
        if (page := self._server.page_of(client)) is not None:
            self.pages.answer(page, answer)

    def _follow_page(self, page: str, operation: str) -> None:
        """Note what a page is to be given as soon as it is known, or that the page was closed."""
        if operation == "opened":
            self._scenes.open(page, self._layout)
        elif operation == "fit_start":
            self._unfitted.setdefault(page, _Fitting())
        elif operation == "closed":
            self._asked_fields.pop(page, None)
            self._unfitted.pop(page, None)
            self._settling.pop(page, None)
            self._scenes.forget(page)

    def _show_robot(self, page: str, operation: str, command: Mapping[str, Any]) -> None:
        """Let a page see all there is, or move joints.

        Raises:
            PageError: it can't be done.
        """
        if operation == "fit":
            self._fit(page)
        elif self._joints is None:
            raise PageError("there is no robot here whose joints can be moved")
        else:
            joint_command(self._joints, command)

    def _list_fields(self, page: str, topic: str) -> None:
        """Give a page the numeric fields of a topic, as soon as its type is known."""
        try:
            fields = self.view.plots.fields(topic)
        except TypeNotYetKnownError:
            self._asked_fields[page] = topic
            return
        self.pages.answer(page, {"plot_fields": {"topic": topic, "fields": fields}})

    def apply(self, layout: Layout) -> None:
        """Show what a layout says, and let new pages look from where it says."""
        self.view.apply(layout)
        if missing := layout.trails[MAX_TRAILS:]:
            said = f"there are at most {MAX_TRAILS} trails; those of these frames are not shown: {', '.join(missing)}"
            self._note(said)
        self._layout = layout

    def _view_point(self, page: str) -> ViewPoint | None:
        """Return from where a new page looks; None: from where the page itself says. On a thread of the server."""
        return self.view.placed(self._layout) or self._layout.camera

    def _fit_new_pages(self) -> None:
        """Let new pages see all that comes at their start, until their user has moved the camera."""
        now_s = time.monotonic()
        for page, fitting in list(self._settling.items()):
            if now_s > fitting.end_s + SETTLE_S or not self._stays(page, fitting):
                del self._settling[page]
        for page, (before, end_s, start) in list(self._unfitted.items()):
            now = self._server.view_point(page)
            if before is not None and not self._stays(page, self._unfitted[page]):
                del self._unfitted[page]
            elif (fitted := self._fitted(page)) is not None:
                if before is None or not _are_near(before, fitted):
                    if not self._server.look(page, fitted):
                        continue
                    is_first = before is None
                    self._unfitted[page] = _Fitting(
                        fitted, now_s + FIT_S if is_first else end_s, now if is_first else start
                    )
                # A file is there as a whole as soon as it is read.
                if self.view.is_whole and (now_s >= end_s or self._is_of_file):
                    self._settling[page] = self._unfitted.pop(page)

    def _stays(self, page: str, fitting: _Fitting) -> bool:
        """Return whether a page looks from where it was told; it is told again where it has begun anew.

        Otherwise its user has moved the camera, or it is closed.
        """
        now, told = self._server.view_point(page), fitting.view_point
        if now is None or told is None:
            return True
        if _are_near(told, now):
            return True
        return fitting.start is not None and _are_near(fitting.start, now) and self._server.look(page, told)

    def _fit(self, page: str) -> None:
        """Let a page see all that is shown, from the side from which it looks.

        Raises:
            PageError: nothing is shown, or the page has no camera yet.
        """
        fitted = self._fitted(page)
        if fitted is None or not self._scenes.look(page, fitted):
            raise PageError("nothing is shown yet")

    def _fitted(self, page: str) -> ViewPoint | None:
        """Return from where a page sees all that is shown; None where nothing is, or it has not told its camera."""
        camera, now = self._server.camera(page), self._server.view_point(page)
        if camera is None or now is None or (extent := self.view.extent()) is None:
            return None
        x, y, z = (there - here for there, here in zip(now.position, now.look_at, strict=True))
        return view_of(extent, camera.fov_rad, camera.aspect, (x, y, z))

    def _save_layout(self, page: str, *, for_rviz: bool) -> None:
        """Give a page its layout as a file, ours or RViz's, or write it where the program was told to."""
        layout, path = self.view.layout(None), self.layout_path
        if (shown := self._scenes.saved_view(page)) is not None:
            layout = layout._replace(
                camera=shown.camera,
                camera_kind=shown.kind,
                camera_frame=shown.frame,
                camera_turns=shown.turns,
            )
        is_rviz = for_rviz if path is None else path.suffix == ".rviz"
        content, unknown = rviz_text(layout) if is_rviz else (layout_text(layout), [])
        without = f", without what RViz has no counterpart for: {'; '.join(unknown)}" if unknown else ""
        if path is None:
            name = "view.rviz" if is_rviz else "view.yaml"
            done = shown_text(f"the layout is saved as {name}{without}", MAX_NOTE)
            self.pages.answer(page, {"layout": content, "name": name, "said": done})
            return
        try:
            write_file(path, content)
        except OSError as error:
            raise PageError(f"can't write {path}: {error.strerror or error}") from None
        self.pages.answer(page, {"done": shown_text(f"the layout is saved in {path}{without}", MAX_NOTE)})

    def _run_live_command(
        self, live: LiveOnly, page: str, operation: str, command: Mapping[str, Any]
    ) -> None:
        if operation == "floor":
            self._use_tool(live, page, command)
        elif operation == "drive":
            self._drive(live, page, command)
        elif operation == "graph":
            self.pages.answer(page, {"graph": _graph_of(live, command)})
        elif operation in FORM_COMMANDS:
            live.forms.ask(page, command, lambda answer: self.pages.answer(page, answer))
        else:
            live.parameters.ask(command, lambda answer: self.pages.answer(page, answer))

    def _drive(self, live: LiveOnly, page: str, command: Mapping[str, Any]) -> None:
        """Drive a robot; as all of `AT_ONCE`, on the thread of the server."""
        topic, ahead, left = text(command, "topic"), number(command, "ahead"), number(command, "left")
        if self._is_over():
            raise PageError("the viewer ends")
        if "at" in command:
            live.driving.drive(page, topic, ahead, left, (number(command, "clock"), number(command, "at")))
        elif not (ahead or left) or not self.pages.is_late():
            live.driving.drive(page, topic, ahead, left)

    def _note_refusal(self, page: str, reason: str) -> None:
        """Tell a page why it can't drive; or all, where it is not a page's own affair."""
        if page:
            self.pages.answer(page, {"error": shown_text(reason, 500)})
        else:
            self._note(reason)

    def _use_tool(self, live: LiveOnly, page: str, command: Mapping[str, Any]) -> None:
        camera = self._server.camera(page)
        if camera is None:
            raise PageError("the scene has not told its camera yet")
        spots = []
        for end in ("from", "to"):
            place = command.get(end)
            if not isinstance(place, list) or len(place) != 2:
                raise PageError(f"{end} has to be two numbers")
            across, down = (number({"at": part}, "at") for part in place)
            spot = floor_point(camera, across, down)
            if spot is None:
                raise PageError("there is no floor at this place")
            spots.append(spot)
        done = live.tools.use(text(command, "tool"), self.view.fixed_frame, spots[0], spots[1])
        self.pages.answer(page, {"done": shown_text(done)})

    # Images, which pages ask for when they have shown the one before.

    def _note_images(self) -> None:
        self._entries = self.view.image_entries()
        for topic in self._entries:
            if (feed := self.view.feed(topic)) is not None:
                feed.status = self._image_faults.get(topic, "") or feed.status

    def _image_of(self, topic: str) -> tuple[str, bytes] | None:
        """Return the picture of a topic at the time that is shown; on a thread of the server."""
        entry = self._entries.get(topic)
        if entry is None:
            return None
        with self._image_lock:  # one page makes the picture, the others take it
            made = self._images.get(topic)
            if made is None or made[0] is not entry:
                try:
                    made = entry, picture_of(entry.message())
                    self._image_faults.pop(topic, None)
                except Exception as error:  # of one image: the next one may be good
                    made = entry, None
                    self._image_faults[topic] = shown_text(fault_text(error))
                self._images = {name: kept for name, kept in self._images.items() if name in self._entries}
                self._images[topic] = made
        return made[1]
