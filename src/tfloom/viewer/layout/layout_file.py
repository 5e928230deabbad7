"""Our own files of layouts, in YAML."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tfloom.viewer.displays.kinds import LABELS
from tfloom.viewer.displays.settings import (
    FRAME_SETTINGS,
    Setting,
    SettingError,
    Value,
    taken_anywhere,
    to_file,
)
from tfloom.viewer.layout.layout import (
    AXES,
    CAMERA_KINDS,
    DEFAULT_AXES_M,
    MAX_PLOT,
    DisplayLayout,
    Layout,
    PlotLayout,
    SavedView,
    ViewPoint,
)
from tfloom.viewer.layout.placed_yaml import PlacedYaml
from tfloom.viewer.layout.rviz_file import RVIZ_SECTION, rviz_layout

__all__ = ["layout_text", "read_layout"]

KEYS = (
    *("fixed_frame", "names", "axes", "frames", "trails", "displays", "plots", "camera", "views"),
    "start_offset",
)
CAMERA_KEYS = ("position", "look_at", "kind", "frame", "turns")
DISPLAY_KEYS = frozenset(("topic", "choice", "settings", "kind"))


def read_layout(path: Path) -> tuple[Layout, list[str]]:
    """Return the layout of a file, ours or RViz's, and what of it is not known here.

    Raises:
        LayoutError: it can't be read, or is neither.
    """
    file = PlacedYaml(path, RVIZ_SECTION)  # RViz itself writes the key Value twice
    if path.suffix == ".rviz" or RVIZ_SECTION in file.root:
        return rviz_layout(file)
    return _own_layout(file)


def _own_layout(file: PlacedYaml) -> tuple[Layout, list[str]]:
    root = file.root
    unknown = [str(key) for key in root if key not in KEYS]
    axes_m = file.number(root, "axes", DEFAULT_AXES_M)
    if not 0.001 <= axes_m <= 1000.0:
        raise file.error(root, "axes are from 0.001 m to 1000 m long")
    start_offset_s = file.number(root, "start_offset", 0.0)
    if start_offset_s < 0.0:
        raise file.error(root, "start_offset has to be a number of seconds that isn't negative")
    displays = []
    for number, row in enumerate(file.items(root, "displays")):
        entry = _entry(file, root, row, "displays")
        unknown += [f"displays[{number}].{key}" for key in entry if key not in DISPLAY_KEYS]
        kind = file.text(entry, "kind")
        if kind and kind not in LABELS:
            unknown.append(f"displays[{number}].kind {kind}")
            continue
        tables = [LABELS[kind].settings] if kind else [one.settings for one in LABELS.values()]
        values = file.mapping(entry, "settings")
        settings, strange = _settings(file, values, tables)
        unknown += [f"displays[{number}].settings.{key}" for key in strange]
        topic = _named(file, entry, "topic") if not kind or LABELS[kind].has_topic else ""
        displays.append(DisplayLayout(topic, file.text(entry, "choice"), settings, kind))
    plots = []
    for number, row in enumerate(file.items(root, "plots")):
        entry = _entry(file, root, row, "plots")
        unknown += [f"plots[{number}].{key}" for key in entry if key not in PlotLayout._fields]
        plots.append(_plot(file, entry))
    trails = file.items(root, "trails")
    if not all(isinstance(frame, str) for frame in trails):
        raise file.error(trails, "trails has to be a list of frames")
    frames, strange = _settings(file, file.mapping(root, "frames"), [FRAME_SETTINGS])
    unknown += [f"frames.{key}" for key in strange]
    camera = file.mapping(root, "camera")
    unknown += [f"camera.{key}" for key in camera if key not in CAMERA_KEYS]
    views = []
    for number, row in enumerate(file.items(root, "views")):
        entry = _entry(file, root, row, "views")
        unknown += [f"views[{number}].{key}" for key in entry if key not in {"name", *CAMERA_KEYS}]
        views.append(_view(file, entry, _named(file, entry, "name")))
    shown = _view(file, camera, "") if camera else None
    layout = Layout(
        fixed_frame=file.text(root, "fixed_frame"),
        with_names=file.flag(root, "names", default=True),
        axes_m=axes_m,
        frames=frames,
        trails=tuple(trails),
        displays=tuple(displays),
        plots=tuple(plots),
        camera=None if shown is None else shown.camera,
        camera_frame="" if shown is None else shown.frame,
        camera_turns=shown is not None and shown.turns,
        camera_kind="orbit" if shown is None else shown.kind,
        views=tuple(views),
        start_offset_s=start_offset_s if "start_offset" in root else None,
    )
    return layout, unknown


def _entry(file: PlacedYaml, root: dict[Any, Any], row: Any, key: str) -> dict[Any, Any]:
    if isinstance(row, str) and key == "displays":
        return {"topic": row}
    if not isinstance(row, dict):
        raise file.error(root[key], f"{key} has to be a list of mappings, as 'topic: /scan'")
    return row


def _settings(
    file: PlacedYaml, values: dict[Any, Any], tables: list[Mapping[str, Setting]]
) -> tuple[tuple[tuple[str, Value], ...], list[str]]:
    """Return settings of a display that is of one of some kinds, and the names of those that none of them has.

    Raises:
        LayoutError: a value is none of its setting.
    """
    settings, unknown = [], []
    for name, value in values.items():
        if not any(name in table for table in tables):
            unknown.append(str(name))
            continue
        try:
            settings.append((str(name), taken_anywhere(name, value, tables)))
        except SettingError as error:
            raise file.error(values, f"{name} {error}") from None
    return tuple(settings), unknown


def _view(file: PlacedYaml, entry: dict[Any, Any], name: str) -> SavedView:
    kind, frame = file.text(entry, "kind") or "orbit", file.text(entry, "frame")
    if kind not in CAMERA_KINDS:
        raise file.error(entry, f"the kind of a camera is one of {', '.join(CAMERA_KINDS)}")
    if kind == "first_person" and not frame:
        raise file.error(entry, "a camera of the kind first_person needs a frame")
    camera = ViewPoint(file.point(entry, "position"), file.point(entry, "look_at"))
    return SavedView(name, camera, kind, frame, file.flag(entry, "turns", default=False))


def _plot(file: PlacedYaml, entry: dict[Any, Any]) -> PlotLayout:
    plot = entry.get("plot", 0)
    if not isinstance(plot, int) or isinstance(plot, bool) or not 0 <= plot <= MAX_PLOT:
        raise file.error(entry, f"plot has to be a whole number from 0 to {MAX_PLOT}")
    axis = file.text(entry, "axis") or "left"
    if axis not in AXES:
        raise file.error(entry, f"axis has to be {' or '.join(AXES)}")
    topic, field = _named(file, entry, "topic"), _named(file, entry, "field")
    return PlotLayout(topic, field, plot, axis, file.flag(entry, "unroll", default=False))


def _named(file: PlacedYaml, entry: dict[Any, Any], key: str) -> str:
    value = file.text(entry, key)
    if not value:
        raise file.error(entry, f"{key} is missing")
    return value


def layout_text(layout: Layout) -> str:
    """Return a layout as the text of a file."""
    import yaml

    values: dict[str, Any] = {"fixed_frame": layout.fixed_frame} if layout.fixed_frame else {}
    values |= {"names": layout.with_names, "axes": layout.axes_m}
    if layout.frames:
        values["frames"] = {name: to_file(value) for name, value in layout.frames}
    if layout.trails:
        values["trails"] = list(layout.trails)
    values["displays"] = [_display_values(display) for display in layout.displays]
    if layout.plots:
        values["plots"] = [_plot_values(plot) for plot in layout.plots]
    if layout.camera is not None:
        values["camera"] = _view_values(
            SavedView("", layout.camera, layout.camera_kind, layout.camera_frame, layout.camera_turns)
        )
    if layout.views:
        values["views"] = [{"name": view.name, **_view_values(view)} for view in layout.views]
    if layout.start_offset_s is not None:
        values["start_offset"] = layout.start_offset_s
    return str(yaml.safe_dump(values, sort_keys=False, allow_unicode=True))


def _view_values(view: SavedView) -> dict[str, Any]:
    values: dict[str, Any] = {
        name: [round(part, 4) for part in point] for name, point in view.camera._asdict().items()
    }
    if view.kind != "orbit":
        values["kind"] = view.kind
    if view.frame:
        values["frame"] = view.frame
    if view.turns:
        values["turns"] = True
    return values


def _plot_values(plot: PlotLayout) -> dict[str, Any]:
    usual = PlotLayout(plot.topic, plot.field)._asdict()
    return {
        name: value
        for name, value in plot._asdict().items()
        if name in {"topic", "field"} or value != usual[name]
    }


def _display_values(display: DisplayLayout) -> dict[str, Any]:
    values: dict[str, Any] = {"topic": display.topic} if display.topic else {}
    if display.kind:
        values["kind"] = display.kind
    if display.choice:
        values["choice"] = display.choice
    if display.settings:
        values["settings"] = {name: to_file(value) for name, value in display.settings}
    return values
