"""Layouts as files of RViz."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from tfloom.viewer.displays.camera_info import images_of
from tfloom.viewer.displays.kinds import INTERACTIVE, LABELS, UPDATE_SUFFIX
from tfloom.viewer.displays.settings import FRAME_SETTINGS, Setting, usual_values
from tfloom.viewer.layout.layout import (
    DEFAULT_AXES_M,
    TOP_FOV_RAD,
    DisplayLayout,
    Layout,
    SavedView,
    ViewPoint,
)
from tfloom.viewer.layout.rviz_file import (
    NAMESPACE_KEY,
    NO_TARGET,
    OURS,
    RVIZ_SECTION,
    TOOL_TOPICS,
    TURNING,
    WINDOW_PX,
)

__all__ = ["rviz_text"]

PLUGINS = "rviz_default_plugins"
TOPIC_PROPERTIES = {
    "RobotModel": "Description Topic",
    "DepthCloud": "Depth Map Topic",
    INTERACTIVE: NAMESPACE_KEY,
}
"""Where a display's topic is, if not in the property Topic."""
PLAIN_TOPICS = frozenset(("DepthCloud", INTERACTIVE))
"""Displays whose topic, or the namespace of it, is a text, without its quality of service."""


def rviz_text(layout: Layout) -> tuple[str, list[str]]:
    """Return a layout as the text of a file of RViz, and what of it has no counterpart there."""
    import yaml

    writer = _Writer(layout)
    root = {
        "Panels": [
            {"Class": "rviz_common/Displays", "Name": "Displays"},
            {"Class": "rviz_common/Views", "Name": "Views"},
        ],
        RVIZ_SECTION: {
            "Class": "",
            "Displays": writer.displays(),
            "Enabled": True,
            "Global Options": {"Background Color": "48; 48; 48", "Fixed Frame": layout.fixed_frame or "map"},
            "Name": "root",
            "Tools": [
                {"Class": f"{PLUGINS}/MoveCamera"},
                *(
                    {"Class": f"{PLUGINS}/{name}", "Topic": {"Value": topic}}
                    for name, topic in TOOL_TOPICS.items()
                ),
            ],
            "Value": True,
            "Views": writer.views(),
        },
    }
    return str(yaml.safe_dump(root, sort_keys=True, allow_unicode=True)), writer.unknown


class _Writer:
    """Makes the parts of a file, and notes what has no counterpart."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self.unknown: list[str] = []
        if layout.trails:
            self.unknown.append(f"the ways of {', '.join(layout.trails)}")
        self.unknown += [f"the plot of {plot.field} of {plot.topic}" for plot in layout.plots]

    def displays(self) -> list[dict[str, Any]]:
        """Return the displays, that of the frames first."""
        layout = self._layout
        scale = round(layout.axes_m / DEFAULT_AXES_M, 6)
        frames = {**usual_values(FRAME_SETTINGS), **dict(layout.frames)}
        if not frames["timeout_s"]:
            del frames["timeout_s"]  # RViz has no frames that stay for ever
        tf = self._of_class("TF", "TF", FRAME_SETTINGS, frames)
        tf |= {"Show Names": layout.with_names, "Marker Scale": scale}
        tf["Frames"] = {"All Enabled": True, **tf["Frames"]}
        shown = [self._display(display) for display in layout.displays]
        return [tf, *(display for display in shown if display is not None)]

    def _display(self, display: DisplayLayout) -> dict[str, Any] | None:
        kind = LABELS.get(display.kind)
        if kind is None or display.kind in OURS:
            what = f", a {display.kind}" if display.kind else ", whose type is not known"
            self.unknown.append(f"the display of {display.topic}{what}")
            return None
        images = [other.topic for other in self._layout.displays if other.kind == "Image"]
        cameras = [other.topic for other in self._layout.displays if other.kind == "Camera"]
        topic = display.topic
        if display.kind == "Image" and any(topic in images_of(camera, images) for camera in cameras):
            return None  # it is that of a camera, which has both
        table = kind.settings
        if display.kind == "Camera":
            topic = next(iter(images_of(topic, images)), "")
            if not topic:
                self.unknown.append(f"the display of {display.topic}, a camera without an image")
                return None
            shown = next(one for one in self._layout.displays if (one.topic, one.kind) == (topic, "Image"))
            display, table = display._replace(settings=shown.settings), LABELS["Image"].settings
        values = {**usual_values(table), **dict(display.settings)}
        if not values.get("depth"):
            values.pop("depth", None)  # RViz's own is as usual there
        name = f"{kind.label} {display.topic}".strip()
        made = self._of_class(kind.label, name, table, values)
        if kind.has_topic:
            property_name = TOPIC_PROPERTIES.get(kind.label, "Topic")
            if kind.label == INTERACTIVE:
                topic = topic.removesuffix(UPDATE_SUFFIX)
            is_plain = kind.label in PLAIN_TOPICS
            made[property_name] = topic if is_plain else {**made.get(property_name, {}), "Value": topic}
        if "color_by" in values:
            _color_by_choice(made, values["color_by"], display.choice)
        elif display.choice:
            self.unknown.append(f"the choice {display.choice} of {display.topic}")
        return made

    def _of_class(
        self, label: str, name: str, table: Mapping[str, Setting], values: Mapping[str, Any]
    ) -> dict[str, Any]:
        """Return a display with all of its settings."""
        made: dict[str, Any] = {
            "Class": f"{PLUGINS}/{label}",
            "Enabled": True,
            "Name": name,
            "Value": True,
        }
        for key, value in values.items():
            setting = table.get(key)
            if setting is None or not setting.rviz:
                if setting is None or value != setting.usual:
                    self.unknown.append(f"{key} of the display {name}")
                continue
            *outer, last = setting.rviz.split("/")
            holder = made
            for part in outer:
                holder = holder.setdefault(part, {})
            holder[last] = setting.to_rviz(value)
        return made

    def views(self) -> dict[str, Any]:
        """Return the camera and the saved views."""
        layout = self._layout
        views: dict[str, Any] = {"Saved": [self._view(view) for view in layout.views] or None}
        if layout.camera is not None:
            kind, frame, turns = layout.camera_kind, layout.camera_frame, layout.camera_turns
            views["Current"] = self._view(SavedView("Current View", layout.camera, kind, frame, turns))
        return views if layout.camera is not None or layout.views else {}

    def _view(self, view: SavedView) -> dict[str, Any]:
        if view.kind == "top":
            made = _from_above(view.camera)
        elif view.kind == "first_person":
            made = _first_person(view.camera)
            self.unknown.append(f"that the first person's camera {view.name} turns with {view.frame}")
        else:
            made = _orbit(view.camera)
            made["Class"] = f"{PLUGINS}/{TURNING if view.turns else 'Orbit'}"
        if view.kind == "top" and view.turns:
            self.unknown.append(f"that the view {view.name} turns with {view.frame}")
        return {**made, "Name": view.name, "Target Frame": view.frame or NO_TARGET}


def _color_by_choice(made: dict[str, Any], color_by: str, choice: str) -> None:
    """Write which field colours points; without one, RViz takes what fits best, too."""
    if color_by != "field":
        return
    if choice in {"rgb", "rgba"}:
        made["Color Transformer"] = "RGB8"
    elif choice:
        made["Channel Name"] = choice
    else:
        del made["Color Transformer"]


def _orbit(camera: ViewPoint) -> dict[str, Any]:
    x, y, z = (there - at for there, at in zip(camera.position, camera.look_at, strict=True))
    distance = math.dist(camera.position, camera.look_at)
    return {
        "Distance": round(distance, 6),
        "Focal Point": dict(zip("XYZ", camera.look_at, strict=True)),
        "Pitch": round(math.asin(z / distance) if distance else 0.0, 6),
        "Yaw": round(math.atan2(y, x), 6),
    }


def _first_person(camera: ViewPoint) -> dict[str, Any]:
    x, y, z = (there - at for there, at in zip(camera.look_at, camera.position, strict=True))
    return {
        "Class": f"{PLUGINS}/FPS",
        "Position": dict(zip("XYZ", camera.position, strict=True)),
        "Pitch": round(-math.atan2(z, math.hypot(x, y)), 6),
        "Yaw": round(math.atan2(y, x), 6),
    }


def _from_above(camera: ViewPoint) -> dict[str, Any]:
    """Return a view from above that shows as much in a window of the height for which it is read."""
    x, y, height = (there - at for there, at in zip(camera.position, camera.look_at, strict=True))
    return {
        "Class": f"{PLUGINS}/TopDownOrtho",
        "X": camera.look_at[0],
        "Y": camera.look_at[1],
        "Scale": round(WINDOW_PX / max(2.0 * height * math.tan(TOP_FOV_RAD / 2.0), 1e-6), 6),
        "Angle": round(math.atan2(-y, -x) - math.pi / 2.0, 6),
    }
