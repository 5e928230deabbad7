"""Layouts of RViz's files: the common displays, the fixed frame and the camera."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from tfloom.viewer.displays.kinds import INTERACTIVE, LABELS, UPDATE_SUFFIX
from tfloom.viewer.displays.settings import FRAME_SETTINGS, Setting, SettingError, Value
from tfloom.viewer.layout.layout import (
    DEFAULT_AXES_M,
    TOP_FOV_RAD,
    DisplayLayout,
    Layout,
    LayoutError,
    Point,
    SavedView,
    ViewPoint,
)
from tfloom.viewer.layout.placed_yaml import PlacedYaml
from tfloom.viewer.tools import GOAL_TOPIC, INITIAL_TOPIC, POINT_TOPIC

__all__ = ["RVIZ_SECTION", "rviz_layout"]

RVIZ_SECTION = "Visualization Manager"
"""The section of a file that tells RViz's from ours."""
MAX_DEPTH = 20
"""How deep displays may be in groups."""
OURS = frozenset(("Turtle",))
"""Displays that RViz has not."""
OLD_NAMES = {"WrenchStamped": "Wrench"}
"""Names that displays had in ROS 1."""
OWN_KEYS = frozenset(
    (
        *("Class", "Name", "Enabled", "Value", "Selectable", "Description Source", "Description File"),
        *("Topic", "Image Topic", "Marker Topic", "Description Topic", "Depth Map Topic", "Channel Name"),
        *("Show Names", "Marker Scale", "Tree"),
    )
)
"""Properties of a display that are read apart from its settings, or need no counterpart."""
QUALITY_KEYS = frozenset(("Queue Size", "Unreliable", "Update Topic", "Use Timestamp", "Update Interval"))
"""… that say how messages are received: here each topic is read once, for all displays."""
IDLE: Mapping[str, Any] = {
    "Enable Transparency": True,
    "Show Visual Aids": False,
    "Position Transformer": "XYZ",
    "TF Prefix": "",
    "Draw Behind": False,
    "Show Trail": False,
    "Hide Small Values": True,
    "Accept NaN Values": False,
    "Mass Properties": {"Inertia": False, "Mass": False},
    "Offset": {"X": 0, "Y": 0, "Z": 0},
    "Arrow Length": 0.3,
    "Normal Cell Count": 0,
    "Color Image Topic": "",
    "Color Transport Hint": "raw",
    "Depth Map Transport Hint": "raw",
    "Occlusion Compensation": {"Occlusion Time-Out": 30, "Value": False},
    "Topic Filter": True,
}
"""… that have no counterpart, and change nothing with these values."""
NAMESPACE_KEY = "Interactive Markers Namespace"
OLD_UPDATE_KEY = "Update Topic"
"""The topic of the updates of interactive markers, in files of ROS 1."""
TOPIC_KEYS = ("Topic", "Image Topic", "Marker Topic", "Description Topic", "Depth Map Topic")
"""Where a display's topic is; the second and the third in files of ROS 1."""
TOOL_TOPICS = {"SetGoal": GOAL_TOPIC, "SetInitialPose": INITIAL_TOPIC, "PublishPoint": POINT_TOPIC}
ORBITS = frozenset(("Orbit", "XYOrbit", "ThirdPersonFollower"))
"""Cameras that look at a focal point."""
TURNING = "ThirdPersonFollower"
"""The one of them that turns with its target frame, about the vertical."""
FIRST_PERSON = "FPS"
FROM_ABOVE = "TopDownOrtho"
FIRST_PERSON_M = 5.0
"""How far before a first person's camera the point is to which it looks [m]."""
NEAR_M = 0.01
"""A camera that is nearer to the origin of its frame is in this frame [m]."""
MAX_PITCH_RAD = 1.56
"""Straight from above or from below has no direction upwards."""
WINDOW_PX = 600.0
"""Height of the window for which the scale of a view from above is taken."""
NO_TARGET = "<Fixed Frame>"


def rviz_layout(file: PlacedYaml) -> tuple[Layout, list[str]]:
    """Return the layout of a file of RViz, and what of it is not known here.

    Raises:
        LayoutError: it is not a file of RViz.
    """
    manager = file.root.get(RVIZ_SECTION)
    if not isinstance(manager, dict):
        raise file.error(file.root, f"it has no section '{RVIZ_SECTION}', as files of RViz have")
    reader = _Reader(file)
    reader.take_displays(manager, 0)
    reader.take_tools(manager)
    fixed_frame = file.text(file.mapping(manager, "Global Options"), "Fixed Frame")
    views = file.mapping(manager, "Views")
    current = reader.view(file.mapping(views, "Current"), fixed_frame)
    saved = [reader.view(row, fixed_frame) for row in file.items(views, "Saved") if isinstance(row, dict)]
    layout = Layout(
        fixed_frame=fixed_frame,
        with_names=reader.with_names,
        axes_m=reader.axes_m,
        frames=reader.frames,
        displays=tuple(dict.fromkeys(reader.displays)),
        camera=None if current is None else current.camera,
        camera_frame="" if current is None else current.frame,
        camera_turns=current is not None and current.turns,
        camera_kind="orbit" if current is None else current.kind,
        views=tuple(view for view in saved if view is not None),
    )
    return layout, reader.unknown


class _Reader:
    """Collects what is known of a file, and names what is not."""

    def __init__(self, file: PlacedYaml) -> None:
        self._file = file
        self.displays: list[DisplayLayout] = []
        self.unknown: list[str] = []
        self.with_names = False  # without a display of frames, RViz draws none
        self.axes_m = DEFAULT_AXES_M
        self.frames: tuple[tuple[str, Value], ...] = ()

    def take_displays(self, holder: dict[Any, Any], depth: int) -> None:
        """Take the displays of the manager, or of a group in it."""
        for display in self._file.items(holder, "Displays"):
            if not isinstance(display, dict):
                raise self._file.error(holder, "Displays has to be a list of mappings")
            if not self._file.flag(display, "Enabled", default=True):
                continue
            kind = str(display.get("Class", "")).rpartition("/")[2]
            kind = OLD_NAMES.get(kind, kind)
            name = str(display.get("Name", kind))
            try:
                is_known = self._take(kind, name, display, depth)
            except LayoutError as error:
                self.unknown.append(f"the display {name} ({error})")
                continue
            if not is_known:
                self.unknown.append(f"the display {name} of the class {display.get('Class', 'none')}")

    def _take(self, kind: str, name: str, display: dict[Any, Any], depth: int) -> bool:
        """Take a display; return whether it is known.

        Raises:
            LayoutError: a part of it is not as it should be.
        """
        file = self._file
        if kind == "Group" and depth < MAX_DEPTH:
            self.take_displays(display, depth + 1)
        elif kind == "TF":
            self._take_frames(name, display)
        elif kind == "RobotModel" and file.text(display, "Description Source", "Topic") != "Topic":
            self.unknown.append("a robot model of a file: publish it by robot_state_publisher")
        elif kind == "Camera":
            topic = self._topic(display, TOPIC_KEYS)
            if topic:
                self._add(topic, "Image", settings=self._settings(name, display, LABELS["Image"].settings))
                self._add(f"{topic.rpartition('/')[0]}/camera_info", "Camera")
        elif kind == INTERACTIVE:
            self._take_interactive(name, display)
        elif kind in LABELS and kind not in OURS:
            settings = self._settings(name, display, LABELS[kind].settings)
            topic = self._topic(display, TOPIC_KEYS) or ("/robot_description" if kind == "RobotModel" else "")
            if topic or not LABELS[kind].has_topic:
                self._add(topic, kind, self._color_field(display, settings), settings)
            self._name_others(name, display, LABELS[kind].settings)
        else:
            return False
        return True

    def _take_interactive(self, name: str, display: dict[Any, Any]) -> None:
        namespace = self._file.text(display, NAMESPACE_KEY) or self._file.text(display, OLD_UPDATE_KEY)
        if namespace:
            topic = namespace.removesuffix(UPDATE_SUFFIX).removesuffix("/") + UPDATE_SUFFIX
            settings = self._settings(name, display, LABELS[INTERACTIVE].settings)
            self._add(topic, INTERACTIVE, settings=settings)
        self._name_others(name, display, LABELS[INTERACTIVE].settings)

    def _take_frames(self, name: str, display: dict[Any, Any]) -> None:
        self.with_names = self._file.flag(display, "Show Names", default=True)
        scale = self._file.number(display, "Marker Scale", 1.0)
        self.axes_m = min(max(DEFAULT_AXES_M * scale, 0.001), 1000.0)
        self.frames = self._settings(name, display, FRAME_SETTINGS)
        self._name_others(name, display, FRAME_SETTINGS)

    def _add(
        self, topic: str, kind: str, choice: str = "", settings: tuple[tuple[str, Value], ...] = ()
    ) -> None:
        full = topic if topic.startswith("/") or not topic else f"/{topic}"
        self.displays.append(DisplayLayout(full, choice, settings, kind))

    def _settings(
        self, name: str, display: dict[Any, Any], table: Mapping[str, Setting]
    ) -> tuple[tuple[str, Value], ...]:
        """Return the settings of a display that are not as they usually are; those that can't be taken are named."""
        settings = []
        for key, setting in table.items():
            try:
                is_there, given = property_of(display, setting.rviz)
                value = setting.from_rviz(given) if is_there else setting.usual
            except SettingError as error:
                self.unknown.append(f"{setting.rviz} of the display {name}, which {error}")
                continue
            if value != setting.usual:
                settings.append((key, value))
        return tuple(settings)

    def _name_others(self, name: str, display: dict[Any, Any], table: Mapping[str, Setting]) -> None:
        """Name the properties of a display that have no counterpart, unless they are as they usually are."""
        known = {setting.rviz.partition("/")[0] for setting in table.values()} | OWN_KEYS | QUALITY_KEYS
        known.add(NAMESPACE_KEY)
        others = [
            str(key)
            for key, value in display.items()
            if key not in known and not (key in IDLE and value == IDLE[key])
        ]
        if others:
            self.unknown.append(f"{', '.join(others)} of the display {name}")

    def _topic(self, display: dict[Any, Any], keys: tuple[str, ...]) -> str:
        for key in keys:
            value = display.get(key)
            if isinstance(value, dict):
                return self._file.text(value, "Value")
            if value is not None:
                return self._file.text(display, key)
        return ""

    def _color_field(self, display: dict[Any, Any], settings: tuple[tuple[str, Value], ...]) -> str:
        """Return the field that colours a cloud; empty where that is not by a field."""
        if "color_by" in dict(settings):
            return ""
        transformer = self._file.text(display, "Color Transformer")
        if transformer == "Intensity":
            return self._file.text(display, "Channel Name", "intensity")
        return "rgb" if transformer.startswith("RGB") else ""

    def take_tools(self, manager: dict[Any, Any]) -> None:
        """Name the tools that publish elsewhere than here."""
        for tool in self._file.items(manager, "Tools"):
            if not isinstance(tool, dict):
                continue
            kind = str(tool.get("Class", "")).rpartition("/")[2]
            topic = self._topic(tool, ("Topic",)) if kind in TOOL_TOPICS else ""
            full = topic if topic.startswith("/") or not topic else f"/{topic}"
            if full and full != TOOL_TOPICS[kind]:
                self.unknown.append(f"{kind} on {full}, which publishes on {TOOL_TOPICS[kind]} here")

    def view(self, view: dict[Any, Any], fixed_frame: str) -> SavedView | None:
        """Return a camera, in its target frame; None where there is none that is known."""
        if not view:
            return None
        file = self._file
        kind = str(view.get("Class", "")).rpartition("/")[2]
        name = file.text(view, "Name") or kind
        target = file.text(view, "Target Frame", NO_TARGET)
        frame = "" if target in {NO_TARGET, fixed_frame, ""} else target
        if file.flag(view, "Invert Z Axis", default=False):
            self.unknown.append("a view with the z axis downwards, which is upwards here")
        if kind in ORBITS:
            return SavedView(name, self._orbit(view), "orbit", frame, bool(frame) and kind == TURNING)
        if kind == FROM_ABOVE:
            return SavedView(name, self._from_above(view), "top", frame)
        if kind == FIRST_PERSON:
            camera = self._first_person(view)
            if not frame or math.dist(camera.position, (0.0, 0.0, 0.0)) > NEAR_M:
                return SavedView(name, camera, "orbit", frame)
            self.unknown.append(f"a first person's camera in {frame} that turns with it here")
            return SavedView(name, camera, "first_person", frame)
        self.unknown.append(f"a camera of the class {view.get('Class', 'none')}")
        return None

    def _direction(self, view: dict[Any, Any]) -> tuple[float, float, float]:
        """Return the direction of a view's pitch and yaw, upwards where the pitch is above zero."""
        pitch, yaw = self._file.number(view, "Pitch", 0.785), self._file.number(view, "Yaw", 0.785)
        pitch = min(max(pitch, -MAX_PITCH_RAD), MAX_PITCH_RAD)
        return math.cos(pitch) * math.cos(yaw), math.cos(pitch) * math.sin(yaw), math.sin(pitch)

    def _orbit(self, view: dict[Any, Any]) -> ViewPoint:
        focus = self._point(view, "Focal Point")
        distance = max(self._file.number(view, "Distance", 10.0), 0.01)
        return ViewPoint(_along(focus, self._direction(view), distance), focus)

    def _first_person(self, view: dict[Any, Any]) -> ViewPoint:
        # A camera here turns about the point to which it looks, which RViz's has none of.
        position = self._point(view, "Position")
        ahead, left, down = self._direction(view)  # it looks downwards where the pitch is above zero
        if self._file.number(view, "Roll", 0.0):
            self.unknown.append("a camera that is tilted, which is upright here")
        return ViewPoint(position, _along(position, (ahead, left, -down), FIRST_PERSON_M))

    def _from_above(self, view: dict[Any, Any]) -> ViewPoint:
        file = self._file
        x, y = file.number(view, "X", 0.0), file.number(view, "Y", 0.0)
        angle = file.number(view, "Angle", 0.0)
        height = WINDOW_PX / max(file.number(view, "Scale", 10.0), 1e-3) / 2.0 / math.tan(TOP_FOV_RAD / 2.0)
        # A little aside, because straight from above has no direction upwards.
        aside = 0.001 * height
        return ViewPoint(
            (x - aside * math.cos(angle + math.pi / 2), y - aside * math.sin(angle + math.pi / 2), height),
            (x, y, 0.0),
        )

    def _point(self, view: dict[Any, Any], key: str) -> Point:
        values = self._file.mapping(view, key)
        x, y, z = (self._file.number(values, axis, 0.0) for axis in "XYZ")
        return x, y, z


def _along(start: Point, direction: Point, distance: float) -> Point:
    x, y, z = (at + distance * part for at, part in zip(start, direction, strict=True))
    return x, y, z


def property_of(display: Mapping[Any, Any], path: str) -> tuple[bool, Any]:
    """Return whether a display of a file has a property, which may be within another, and its value."""
    if not path:
        return False, None
    holder: Any = display
    for key in path.split("/"):
        if not isinstance(holder, dict) or key not in holder:
            return False, None
        holder = holder[key]
    return True, holder
