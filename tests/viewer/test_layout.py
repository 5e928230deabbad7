"""Saved layouts: files of ours and of RViz, what of them is not known, and mistakes in them."""

from __future__ import annotations

import itertools
import math
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from tfloom.cli.view import read_config
from tfloom.common import yaml as user_yaml
from tfloom.viewer.layout.layout import (
    TOP_FOV_RAD,
    DisplayLayout,
    Layout,
    LayoutError,
    PlotLayout,
    SavedView,
    ViewPoint,
)
from tfloom.viewer.layout.layout_file import layout_text, read_layout
from tfloom.viewer.layout.rviz_text import rviz_text

Write = Callable[..., Path]

FULL = Layout(
    fixed_frame="odom",
    with_names=False,
    axes_m=0.5,
    trails=("base_link", "<b>"),
    displays=(
        DisplayLayout("/points", "intensity"),
        DisplayLayout("/scan"),
        DisplayLayout("/wrench", settings=(("force_color", (1, 2, 3)), ("force_scale", 0.5), ("history", 4))),
        DisplayLayout("/points", "", (("color_by", "axis"), ("axis", "x")), "PointCloud2"),
        DisplayLayout("/markers", "", (("hidden_namespaces", ("a", "b")),), "MarkerArray"),
    ),
    frames=(("show_arrows", False), ("hidden_frames", ("laser",)), ("timeout_s", 3.0)),
    plots=(
        PlotLayout("/odom", "twist.twist.linear.x"),
        PlotLayout("/turtle1/pose", "theta", 2, "right", unroll=True),
    ),
    camera=ViewPoint((1.0, 2.0, 3.5), (0.0, 0.5, 0.0)),
    camera_frame="base_link",
    camera_turns=True,
    camera_kind="top",
    views=(
        SavedView("door", ViewPoint((1.0, 2.0, 3.5), (0.0, 0.5, 0.0))),
        SavedView("driver", ViewPoint((0.0, 0.0, 0.0), (0.1, 0.0, 0.0)), "first_person", "base_link"),
        SavedView("behind", ViewPoint((-2.0, 0.0, 1.0), (0.0, 0.0, 0.0)), "orbit", "base_link", turns=True),
    ),
    start_offset_s=2.5,
)

RVIZ = """\
Panels:
  - Class: rviz_common/Displays
    Name: Displays
Visualization Manager:
  Class: ""
  Displays:
    - Class: rviz_default_plugins/Grid
      Enabled: true
      Name: Grid
    - Class: rviz_default_plugins/TF
      Enabled: true
      Name: TF
      Marker Scale: 2
      Show Names: true
    - Class: rviz_default_plugins/RobotModel
      Description Source: Topic
      Description Topic:
        Depth: 5
        Value: /robot_description
      Enabled: true
    - Class: rviz_default_plugins/PointCloud2
      Color Transformer: Intensity
      Channel Name: ring
      Enabled: true
      Topic:
        Value: /points
    - Class: rviz_common/Group
      Enabled: true
      Name: Sensors
      Displays:
        - Class: rviz_default_plugins/LaserScan
          Enabled: true
          Topic:
            Value: scan
        - Class: rviz_default_plugins/Image
          Enabled: false
          Topic:
            Value: /hidden
        - Class: rviz_default_plugins/Camera
          Enabled: true
          Topic:
            Value: /camera/image_raw
    - Class: rviz_default_plugins/FluidPressure
      Enabled: true
      Name: Handles
    - Class: rviz_default_plugins/Map
      Enabled: true
      Name: Broken
      Topic:
        Value: [1]
    - Class: rviz_default_plugins/DepthCloud
      Enabled: false
      Name: Off
  Global Options:
    Background Color: 48; 48; 48
    Fixed Frame: odom
  Tools:
    - Class: rviz_default_plugins/SetGoal
      Topic:
        Value: goal_pose
    - Class: rviz_default_plugins/PublishPoint
      Topic:
        Value: /my_point
  Views:
    Current:
      Class: rviz_default_plugins/Orbit
      Distance: 10
      Focal Point:
        X: 1
        Y: 2
        Z: 3
      Pitch: 0.5
      Target Frame: <Fixed Frame>
      Yaw: 1.5
"""


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def write_one(content: str | bytes, name: str = "view.yaml") -> Path:
        path = tmp_path / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return write_one


def test_saved_layout_is_read_as_it_was(write: Write) -> None:
    assert read_layout(write(layout_text(FULL))) == (FULL, [])
    assert read_layout(write(layout_text(Layout()))) == (Layout(), [])


def test_what_is_not_known_is_named_and_the_rest_is_read(write: Write) -> None:
    points = "{topic: /points, size: 3, settings: {bright: 1}}"
    camera = "{position: [1, 2, 3], look_at: [0, 0, 0], zoom: 2}"
    text = f"fixed_frame: map\ncolour: red\ndisplays:\n- /scan\n- {points}\ncamera: {camera}\n"
    layout, unknown = read_layout(write(text))
    assert unknown == ["colour", "displays[1].size", "displays[1].settings.bright", "camera.zoom"]
    assert layout.displays == (DisplayLayout("/scan"), DisplayLayout("/points"))
    assert layout.camera == ViewPoint((1.0, 2.0, 3.0), (0.0, 0.0, 0.0))


BROKEN: list[tuple[str | bytes, str]] = [
    ("displays: [\n", r"view\.yaml:2: "),
    ("a: 1\na: 2\n", r"view\.yaml:2: the key 'a' is there twice"),
    ("- 1\n", r"view\.yaml:1: it has to be a mapping"),
    ("", r"view\.yaml:1: it has to be a mapping"),
    ("x: 1\naxes: big\n", r"view\.yaml:1: axes has to be a finite number, not 'big'"),
    ("axes: .nan\n", "axes has to be a finite number"),
    ("axes: 2000.0\n", "axes are from"),
    ("start_offset: -1\n", "start_offset has to be a number of seconds"),
    ("start_offset: soon\n", "start_offset has to be a finite number"),
    ("names: 1\n", "names has to be true or false"),
    ("fixed_frame: 3\n", "fixed_frame has to be a text, not 3"),
    ("displays: {}\n", "displays has to be a list"),
    ("displays:\n- topic: /a\n-\n  choice: x\n", r"view\.yaml:4: topic is missing"),
    ("displays:\n- 3\n", r"view\.yaml:2: displays has to be a list of mappings"),
    ("displays:\n- topic: /a\n  settings: 3\n", r"view\.yaml:2: settings has to be a mapping"),
    (
        "displays:\n- topic: /a\n  settings:\n    force_scale: .nan\n",
        r"view\.yaml:4: force_scale has to be a number from 0 to 1e\+06, not nan",
    ),
    ("displays:\n- {topic: /a, settings: {force_color: [1, 2, 256]}}\n", "force_color has to be three"),
    ("plots:\n- topic: /a\n", r"view\.yaml:2: field is missing"),
    ("plots:\n- {topic: /a, field: x, axis: top}\n", r"view\.yaml:2: axis has to be left or right"),
    ("plots:\n- {topic: /a, field: x, plot: -1}\n", "plot has to be a whole number from 0 to"),
    ("plots:\n- {topic: /a, field: x, plot: true}\n", "plot has to be a whole number from 0 to"),
    ("plots:\n- {topic: /a, field: x, unroll: 1}\n", "unroll has to be"),
    ("trails: [1]\n", "list of frames"),
    ("camera:\n  position: [1, 2]\n", r"view\.yaml:2: position has to be three numbers"),
    ("camera: {position: [1, 2, .inf], look_at: [0, 0, 0]}\n", "three numbers"),
    ("camera: {position: [1, 2, true], look_at: [0, 0, 0]}\n", "three numbers"),
    (b"a: \xff\n", r"view\.yaml:1: it is not encoded in UTF-8"),
    ("Visualization Manager: 3\n", "no section 'Visualization Manager'"),
    ("a: &a [" + "*a, " * 3 + "]\n", "contains itself"),
    ("a: " + "[" * 200, "nested"),
]


def test_mistake_has_its_file_its_line_and_the_reason(write: Write) -> None:
    for content, sentence in BROKEN:
        with pytest.raises(LayoutError, match=sentence):
            read_layout(write(content))
    with pytest.raises(LayoutError, match=r"none\.yaml: No such file"):
        read_layout(Path("none.yaml"))
    with pytest.raises(LayoutError, match="no section 'Visualization Manager'"):
        read_layout(write("fixed_frame: map\n", "our.rviz"))


def test_common_displays_of_an_rviz_file_are_read_and_the_others_named(write: Write) -> None:
    layout, unknown = read_layout(write(RVIZ, "robot.rviz"))
    assert layout.fixed_frame == "odom"
    assert layout.displays == (
        DisplayLayout("", kind="Grid"),
        DisplayLayout("/robot_description", settings=(("depth", 5),), kind="RobotModel"),
        DisplayLayout("/points", "ring", kind="PointCloud2"),
        DisplayLayout("/scan", kind="LaserScan"),
        DisplayLayout("/camera/image_raw", kind="Image"),
        DisplayLayout("/camera/camera_info", kind="Camera"),
    )
    assert layout.with_names
    assert layout.axes_m == pytest.approx(0.6)
    assert layout.camera is not None
    assert layout.camera.look_at == (1.0, 2.0, 3.0)
    assert math.dist(*layout.camera) == pytest.approx(10.0)
    assert layout.camera.position[2] == pytest.approx(3.0 + 10.0 * math.sin(0.5))
    assert layout.camera.position[1] - 2.0 == pytest.approx(10.0 * math.cos(0.5) * math.sin(1.5))
    assert len(unknown) == 3
    assert unknown[0] == "the display Handles of the class rviz_default_plugins/FluidPressure"
    assert "robot.rviz" in unknown[1]
    assert "Value has to be a text, not [1]" in unknown[1]
    assert unknown[2] == "PublishPoint on /my_point, which publishes on /clicked_point here"


WRENCH = """\
Visualization Manager:
  Displays:
    - Accept NaN Values: false
      Alpha: 0.5
      Arrow Width: 0.25
      Class: rviz_default_plugins/Wrench
      Enabled: true
      Force Arrow Scale: 0.01
      Force Color: 255; 0; 10
      History Length: 3
      Name: Foot
      Topic:
        Depth: 5
        Value: /foot/wrench
      Torque Arrow Scale: 2
      Torque Color: 204; 204; 51
      Value: true
"""


@pytest.mark.parametrize(
    "of_class", ["rviz_default_plugins/Wrench", "rviz_default_plugins/WrenchStamped", "rviz/WrenchStamped"]
)
def test_wrench_of_rviz_has_its_settings_that_are_not_the_usual_ones(write: Write, of_class: str) -> None:
    text = WRENCH.replace("rviz_default_plugins/Wrench", of_class)
    layout, unknown = read_layout(write(text, "foot.rviz"))
    assert unknown == []
    settings = {"force_color": (255, 0, 10), "opacity": 0.5, "force_scale": 0.01, "width": 0.25, "history": 3}
    settings["depth"] = 5
    assert layout.displays == (
        DisplayLayout("/foot/wrench", settings=tuple(settings.items()), kind="Wrench"),
    )
    assert read_layout(write(layout_text(layout)))[0] == layout


def test_depth_of_a_topic_is_written_where_it_was_read_and_only_if_it_is_set(write: Write) -> None:
    displays = (
        DisplayLayout("/points", settings=(("depth", 7),), kind="PointCloud2"),
        DisplayLayout("/robot_description", settings=(("depth", 2),), kind="RobotModel"),
        DisplayLayout("/cam/depth", settings=(("depth", 3),), kind="DepthCloud"),
        DisplayLayout("/cam/image", settings=(("depth", 4),), kind="Image"),
        DisplayLayout("/cam/camera_info", kind="Camera"),
        DisplayLayout("/scan", kind="LaserScan"),
    )
    text, unknown = rviz_text(Layout(displays=displays))
    assert unknown == []
    shown = {
        row["Class"].rpartition("/")[2]: row
        for row in yaml.safe_load(text)["Visualization Manager"]["Displays"]
    }
    assert shown["PointCloud2"]["Topic"] == {"Depth": 7, "Value": "/points"}
    assert shown["RobotModel"]["Description Topic"] == {"Depth": 2, "Value": "/robot_description"}
    assert (shown["DepthCloud"]["Queue Size"], shown["DepthCloud"]["Depth Map Topic"]) == (3, "/cam/depth")
    assert shown["Camera"]["Topic"] == {"Depth": 4, "Value": "/cam/image"}
    assert shown["LaserScan"]["Topic"] == {"Value": "/scan"}
    again, unknown = read_layout(write(text, "depths.rviz"))
    assert (set(again.displays), unknown) == (set(displays), [])
    assert read_layout(write(layout_text(Layout(displays=displays))))[0].displays == displays
    _, unknown = read_layout(write(text.replace("Depth: 7", "Depth: -7"), "depths.rviz"))
    assert unknown == [
        "Topic/Depth of the display PointCloud2 /points, which has to be a whole number from 0 to 10000, not -7"
    ]


def test_wrench_of_rviz_is_shown_without_the_settings_that_cant_be_taken(write: Write) -> None:
    text = WRENCH.replace("255; 0; 10", "reddish").replace("Length: 3", "Length: 1001")
    a_color = "has to be three whole numbers from 0 to 255, as [204, 51, 51]"
    layout, unknown = read_layout(write(text.replace("Alpha: 0.5", "Alpha: .inf"), "foot.rviz"))
    assert layout.displays == (
        DisplayLayout("/foot/wrench", "", (("force_scale", 0.01), ("width", 0.25), ("depth", 5)), "Wrench"),
    )
    assert unknown == [
        f"Force Color of the display Foot, which {a_color}, not 'reddish'",
        "Alpha of the display Foot, which has to be a number from 0 to 1, not inf",
        "History Length of the display Foot, which has to be a whole number from 1 to 1000, not 1001",
    ]


def test_file_of_rviz_that_repeats_a_key_is_read_by_its_last_value(write: Write) -> None:
    repeated = RVIZ.replace("Fixed Frame: odom", "Fixed Frame: map\n    Fixed Frame: odom").replace(
        "      Pitch: 0.5", "      Pitch: 0.5\n      Value: true\n      Value: true"
    )
    assert repeated.count("Fixed Frame: ") == RVIZ.count("Fixed Frame: ") + 1
    for name in ("robot.rviz", "view.yaml"):
        assert read_layout(write(repeated, name))[0] == read_layout(write(RVIZ))[0]


def test_camera_of_each_class_looks_as_in_rviz(write: Write) -> None:
    above = RVIZ.replace("Orbit", "TopDownOrtho").replace(
        "Distance: 10", "Scale: 100\n      X: 4\n      Y: 5"
    )
    layout, unknown = read_layout(write(above, "above.rviz"))
    assert layout.camera is not None
    assert layout.camera.look_at == (4.0, 5.0, 0.0)
    # RViz's scale is in pixels for 1 m: of a window of 600 pixels it sees 6 m.
    assert layout.camera.position == pytest.approx((4.0, 5.0, 3.0 / math.tan(TOP_FOV_RAD / 2.0)), abs=0.2)
    assert (layout.camera_kind, len(unknown)) == ("top", 3)
    orbit, _ = read_layout(write(RVIZ, "orbit.rviz"))
    for kind in ("XYOrbit", "ThirdPersonFollower"):
        layout, unknown = read_layout(write(RVIZ.replace("/Orbit", f"/{kind}"), "other.rviz"))
        assert layout.camera == orbit.camera
        assert len(unknown) == 3  # displays and tools alone
    first_person = (
        RVIZ.replace("Orbit", "FPS").replace("Focal Point", "Position").replace("Yaw: 1.5", "Yaw: 0")
    )
    layout, unknown = read_layout(write(first_person, "fps.rviz"))
    assert layout.camera is not None
    assert layout.camera.position == (1.0, 2.0, 3.0)
    assert layout.camera.look_at == pytest.approx((1.0 + 5.0 * math.cos(0.5), 2.0, 3.0 - 5.0 * math.sin(0.5)))
    assert len(unknown) == 3
    _, unknown = read_layout(write(first_person.replace("Yaw: 0", "Yaw: 0\n      Roll: 0.3"), "tilted.rviz"))
    assert "a camera that is tilted, which is upright here" in unknown
    layout, unknown = read_layout(write(RVIZ.replace("/Orbit", "/FrameAligned"), "aligned.rviz"))
    assert layout.camera is None
    assert "a camera of the class rviz_default_plugins/FrameAligned" in unknown
    _, unknown = read_layout(
        write(RVIZ.replace("Yaw: 1.5", "Yaw: 1.5\n      Invert Z Axis: true"), "down.rviz")
    )
    assert "a view with the z axis downwards, which is upwards here" in unknown


def test_camera_follows_its_target_frame(write: Write) -> None:
    following = RVIZ.replace("<Fixed Frame>", "base_link")
    layout, unknown = read_layout(write(following, "follow.rviz"))
    assert (layout.camera_frame, layout.camera_turns, len(unknown)) == ("base_link", False, 3)
    layout, _ = read_layout(write(following.replace("/Orbit", "/ThirdPersonFollower"), "third.rviz"))
    assert (layout.camera_frame, layout.camera_turns) == ("base_link", True)
    layout, unknown = read_layout(write(RVIZ.replace("<Fixed Frame>", "odom"), "fixed.rviz"))
    assert (layout.camera_frame, len(unknown)) == ("", 3)


def test_first_person_at_the_origin_of_its_frame_is_in_it(write: Write) -> None:
    text = RVIZ.replace("<Fixed Frame>", "base_link").replace("/Orbit", "/FPS")
    layout, unknown = read_layout(write(text, "eye.rviz"))
    assert (layout.camera_kind, layout.camera_frame) == ("first_person", "base_link")
    assert "a first person's camera in base_link that turns with it here" in unknown
    away = text.replace("Focal Point", "Position")
    layout, unknown = read_layout(write(away, "away.rviz"))
    assert (layout.camera_kind, layout.camera_frame, len(unknown)) == ("orbit", "base_link", 3)


def test_cameras_and_saved_views_come_again_from_a_file_of_rviz(write: Write) -> None:
    high = 50.0 / math.tan(TOP_FOV_RAD / 2.0)
    east = ViewPoint((4.0 - 0.001 * high, 5.0, high), (4.0, 5.0, 0.0))
    views = (
        SavedView("door", ViewPoint((1.0, 2.0, 3.5), (0.0, 0.5, 0.0))),
        SavedView("behind", ViewPoint((-2.0, 0.0, 1.0), (0.0, 0.0, 0.0)), "orbit", "base_link", turns=True),
        SavedView("beside", ViewPoint((-2.0, 0.0, 1.0), (0.0, 0.0, 0.0)), "orbit", "base_link"),
        SavedView("plan", east, "top"),
        SavedView("plan of it", east, "top", "base_link"),
    )
    written = Layout("odom", camera=east, camera_kind="top", camera_frame="laser", views=views)
    text, unknown = rviz_text(written)
    assert unknown == []
    read, unknown = read_layout(write(text, "views.rviz"))
    assert unknown == []
    assert (read.camera_kind, read.camera_frame) == ("top", "laser")
    assert len(read.views) == len(views)
    for before, after in zip(views, read.views, strict=True):
        assert after._replace(camera=before.camera) == before
        assert after.camera.position == pytest.approx(before.camera.position, abs=0.01)
        assert after.camera.look_at == pytest.approx(before.camera.look_at, abs=0.01)
    eye = SavedView("driver", ViewPoint((0.0, 0.0, 0.0), (0.1, 0.0, 0.0)), "first_person", "base_link")
    text, unknown = rviz_text(
        Layout("odom", views=(eye, SavedView("plan", east, "top", "laser", turns=True)))
    )
    assert unknown == [
        "that the first person's camera driver turns with base_link",
        "that the view plan turns with laser",
    ]
    read, _ = read_layout(write(text, "eye.rviz"))
    assert read.views[0].kind == "first_person"
    x, y, z = read.views[0].camera.look_at
    assert (x > 0.0, y, z) == (True, pytest.approx(0.0), pytest.approx(0.0))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("views: [{position: [0, 0, 1], look_at: [0, 0, 0]}]", "name is missing"),
        (
            "views: [{name: a, kind: fish, position: [0, 0, 1], look_at: [0, 0, 0]}]",
            "the kind of a camera is one of",
        ),
        ("camera: {kind: first_person, position: [0, 0, 1], look_at: [0, 0, 0]}", "needs a frame"),
        ("views: [3]", "views has to be a list of mappings"),
        ("views: [{name: a, look_at: [0, 0, 0]}]", "position"),
    ],
)
def test_view_that_is_none(write: Write, text: str, said: str) -> None:
    with pytest.raises(LayoutError, match=said):
        read_layout(write(text, "view.yaml"))


def test_manager_without_anything_is_an_empty_layout(write: Write) -> None:
    layout, unknown = read_layout(write("Visualization Manager: {}\n", "empty.rviz"))
    assert layout == Layout(with_names=False)
    assert unknown == []


ODD = (
    *(None, 3, -1.5, float("nan"), float("inf"), True, "", "text"),
    *([], {}, [1], [{}], {"Value": 3}, {3: 4}, 10**400),
)


def damaged(value: Any, chance: random.Random) -> Any:
    """Return values of YAML of which some are something else."""
    if chance.random() < 0.06:
        return chance.choice(ODD)
    if isinstance(value, dict):
        return {key: damaged(part, chance) for key, part in value.items()}
    if isinstance(value, list):
        return [damaged(part, chance) for part in value]
    return value


def test_odd_values_anywhere_are_a_sentence_or_are_passed_over(write: Write) -> None:
    chance = random.Random(4)
    outcomes = set()
    for text in (RVIZ, WRENCH, layout_text(FULL)):
        values = yaml.safe_load(text)
        for _ in range(40):
            path = write(yaml.safe_dump(damaged(values, chance)))
            outcomes.add(outcome(path))
    assert outcomes == {"error", "named", "read"}


def outcome(path: Path) -> str:
    """Read a layout, check what was read, and return what came of it."""
    try:
        layout, unknown = read_layout(path)
    except LayoutError as error:
        return "error" if str(error).startswith(f"{path}:") else str(error)
    layout_text(layout)
    if layout.camera is not None:
        assert all(map(math.isfinite, (*layout.camera.position, *layout.camera.look_at)))
    return "named" if unknown else "read"


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("displays:\n" + "- {topic: /a}\n" * 100_000, "view.yaml"),
        ("displays: [" + "a," * 1_000_000 + "]", "view.yaml"),
        ("".join(f"k{number}: &a{number} 1\n" for number in range(100_000)), "view.yaml"),
        ("Visualization Manager:\n  Displays:\n" + "  - {Class: rviz_common/Group}\n" * 60_000, "big.rviz"),
    ],
    ids=["displays", "one line", "anchors", "rviz"],
)
def test_layout_with_too_many_values_is_refused_before_all_of_it_is_read(
    write: Write, text: str, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    counted = itertools.count()
    compose = user_yaml._Loader.compose_node

    def count(*arguments: Any) -> Any:
        next(counted)
        return compose(*arguments)

    monkeypatch.setattr(user_yaml._Loader, "compose_node", count)
    path = write(text, name)
    with pytest.raises(LayoutError) as refused:
        read_layout(path)
    assert re.fullmatch(
        rf"{re.escape(str(path))}:\d+: it has more than 20000 keys and values", str(refused.value)
    )
    assert next(counted) < 21_000


def test_layout_of_two_megabytes_with_few_values_is_read(write: Write) -> None:
    layout, unknown = read_layout(write("fixed_frame: odom\nnote: |\n" + "  a line of a text\n" * 110_000))
    assert (layout.fixed_frame, unknown) == ("odom", ["note"])


@pytest.mark.parametrize(
    "text", ["axes: 1" + "0" * 5000, "axes: '" + "x" * 100_000 + "'", "names: [" + "1," * 9000 + "]"]
)
def test_mistake_with_a_long_value_is_a_short_sentence(write: Write, text: str) -> None:
    with pytest.raises(LayoutError) as refused:
        read_layout(write(text))
    assert len(str(refused.value).rpartition("view.yaml")[2]) < 150


def test_of_many_unknown_names_some_are_printed(write: Write, capsys: pytest.CaptureFixture[str]) -> None:
    read_config(write("".join(f'"k\\x1b{number}": 1\n' for number in range(50))))
    printed = capsys.readouterr().err
    assert printed.endswith("; k\\x1b18; k\\x1b19; and 30 more\n")


# Files of RViz that are written.

CLOUD_OF_RVIZ = """\
Visualization Manager:
  Displays:
    - Alpha: 0.4
      Autocompute Intensity Bounds: false
      Autocompute Value Bounds:
        Max Value: 2
        Min Value: -1
        Value: false
      Axis: X
      Channel Name: intensity
      Class: rviz_default_plugins/PointCloud2
      Color: 255; 10; 20
      Color Transformer: AxisColor
      Decay Time: 1.5
      Enabled: true
      Invert Rainbow: true
      Max Color: 1; 2; 3
      Max Intensity: 90
      Min Color: 3; 2; 1
      Min Intensity: -5
      Name: Lidar
      Position Transformer: XYZ
      Selectable: true
      Size (Pixels): 5
      Size (m): 0.1
      Style: Boxes
      Topic: {Depth: 5, Value: /points}
      Use Fixed Frame: false
      Use rainbow: false
      Value: true
    - Class: rviz_default_plugins/PointCloud2
      Color Transformer: Intensity
      Channel Name: ring
      Topic: {Value: /points}
    - {Class: rviz_default_plugins/LaserScan, Color Transformer: FlatColor, Color: 1; 2; 3, Topic: {Value: /scan}}
    - Class: rviz_default_plugins/MarkerArray
      Namespaces: {walls: false, floor: true, doors: false}
      Topic: {Value: /markers}
    - Class: rviz_default_plugins/TF
      Frame Timeout: 15
      Frames: {All Enabled: false, map: {Value: true}, laser: {Value: false}}
      Marker Scale: 0.5
      Show Arrows: false
      Show Axes: false
      Show Names: true
    - Class: rviz_default_plugins/RobotModel
      Alpha: 0.5
      Collision Enabled: true
      Description Topic: {Value: /robot_description}
      Links: {All Links Enabled: true, arm: {Alpha: 1, Value: false}, base: {Alpha: 1, Value: true}}
      TF Prefix: ""
      Visual Enabled: false
    - {Class: rviz_default_plugins/Map, Alpha: 0.7, Color Scheme: costmap, Topic: {Value: /map}}
    - {Class: rviz_default_plugins/Axes, Length: 2, Radius: 0.2, Reference Frame: base}
    - Class: rviz_default_plugins/Grid
      Cell Size: 2
      Offset: {X: 1, Y: 0, Z: 0}
      Plane: XZ
      Reference Frame: <Fixed Frame>
    - Class: rviz_default_plugins/Odometry
      Keep: 100
      Position Tolerance: 0.5
      Shape: {Color: 1; 2; 3, Value: Axes, Axes Length: 0.7}
      Covariance: {Value: false, Position: {Alpha: 0.5}}
      Topic: {Value: /odom}
    - {Class: rviz_default_plugins/Image, Topic: {Value: /camera/image}}
    - {Class: rviz_default_plugins/Camera, Topic: {Depth: 3, Value: /front/image}}
    - {Class: rviz_default_plugins/TwistStamped, Linear Arrow Scale: 3, Topic: {Value: /twist}}
    - Class: rviz_default_plugins/InteractiveMarkers
      Enable Transparency: true
      Interactive Markers Namespace: /arm/goals
      Show Axes: true
      Show Descriptions: false
      Show Visual Aids: false
  Global Options: {Fixed Frame: odom}
"""
SET_IN_RVIZ = {
    "/points": {
        "style": "boxes",
        "size_px": 5.0,
        "size": 0.1,
        "opacity": 0.4,
        "color_by": "axis",
        "color": (255, 10, 20),
        "rainbow": False,
        "invert": True,
        "low_color": (3, 2, 1),
        "high_color": (1, 2, 3),
        "auto_range": False,
        "low": -5.0,
        "high": 90.0,
        "axis": "x",
        "axis_fixed": False,
        "axis_auto_range": False,
        "axis_low": -1.0,
        "axis_high": 2.0,
        "decay_s": 1.5,
        "depth": 5,
    },
    "/scan": {"color_by": "flat", "color": (1, 2, 3)},
    "/markers": {"hidden_namespaces": ("doors", "walls")},
    "/robot_description": {
        "opacity": 0.5,
        "visual": False,
        "collision": True,
        "hidden_links": ("arm",),
    },
    "/map": {"opacity": 0.7, "colors": "costmap"},
    "/odom": {
        "shape": "axes",
        "color": (1, 2, 3),
        "axes_length": 0.7,
        "covariance": False,
        "covariance_opacity": 0.5,
        "history": 100,
        "position_tolerance": 0.5,
    },
    "/twist": {"linear_scale": 3.0},
    "/front/image": {"depth": 3},
    "/arm/goals/update": {"axes": True, "descriptions": False},
}


def test_file_of_rviz_is_written_as_it_was_read(write: Write) -> None:
    layout, unknown = read_layout(write(CLOUD_OF_RVIZ, "all.rviz"))
    assert unknown == []
    for topic, settings in SET_IN_RVIZ.items():
        shown = next(display for display in layout.displays if display.topic == topic)
        assert dict(shown.settings) == settings, topic
    assert [display.choice for display in layout.displays if display.topic == "/points"] == ["", "ring"]
    plain = {display.kind: dict(display.settings) for display in layout.displays if not display.topic}
    assert plain == {
        "Axes": {"frame": "base", "length": 2.0, "radius": 0.2},
        "Grid": {"size": 2.0, "plane": "xz", "x": 1.0},
    }
    assert (layout.with_names, layout.axes_m) == (True, pytest.approx(0.15))
    assert dict(layout.frames) == {
        "show_axes": False,
        "show_arrows": False,
        "timeout_s": 15.0,
        "hidden_frames": ("laser",),
    }
    text, missing = rviz_text(layout)
    assert missing == []
    again = read_layout(write(text, "again.rviz"))
    assert again == (layout, [])
    assert rviz_text(again[0]) == (text, [])
    written = yaml.safe_load(text)["Visualization Manager"]["Displays"]
    given = yaml.safe_load(CLOUD_OF_RVIZ)["Visualization Manager"]["Displays"]
    handles = next(row for row in written if row["Class"].endswith("InteractiveMarkers"))
    assert handles["Interactive Markers Namespace"] == "/arm/goals"
    assert "Topic" not in handles
    cloud = next(row for row in written if row["Class"].endswith("PointCloud2"))
    for key in given[0].keys() - {"Name", "Topic", "Channel Name", "Position Transformer", "Selectable"}:
        assert cloud[key] == given[0][key], key
    own = read_layout(write(layout_text(layout)))
    assert own == (layout, [])


def test_interactive_markers_of_rviz_of_ros_1_have_their_namespace_too(write: Write) -> None:
    text = """\
Visualization Manager:
  Displays:
    - {Class: rviz/InteractiveMarkers, Update Topic: /goals/update}
    - {Class: rviz/InteractiveMarkers, Update Topic: ""}
"""
    layout, unknown = read_layout(write(text, "old.rviz"))
    assert [(display.topic, display.kind) for display in layout.displays] == [
        ("/goals/update", "InteractiveMarkers")
    ]
    assert unknown == []


def test_camera_of_a_layout_is_that_of_the_file_of_rviz(write: Write) -> None:
    camera = ViewPoint((1.0, 2.0, 3.0), (-1.0, 0.5, 0.25))
    text, _ = rviz_text(Layout("map", camera=camera, camera_frame="base"))
    layout, _ = read_layout(write(text, "one.rviz"))
    assert layout.camera is not None
    for point, given in zip(layout.camera, camera, strict=True):
        assert point == pytest.approx(given, abs=1e-5)
    assert layout.camera_frame == "base"


def test_what_rviz_has_no_counterpart_for_is_named() -> None:
    layout = FULL._replace(
        displays=(
            *FULL.displays,
            DisplayLayout("/turtle1/pose", kind="Turtle"),
            DisplayLayout("/odom", settings=(("speed", False),), kind="Odometry"),
            DisplayLayout("/front/camera_info", kind="Camera"),
        ),
        camera_kind="orbit",
        views=(),
    )
    text, missing = rviz_text(layout)
    assert missing == [
        "the ways of base_link, <b>",
        "the plot of twist.twist.linear.x of /odom",
        "the plot of theta of /turtle1/pose",
        "the display of /points, whose type is not known",
        "the display of /scan, whose type is not known",
        "the display of /wrench, whose type is not known",
        "the display of /turtle1/pose, a Turtle",
        "speed of the display Odometry /odom",
        "the display of /front/camera_info, a camera without an image",
    ]
    assert "turtle1" not in text


def test_depth_cloud_of_rviz_is_read_and_written(write: Write) -> None:
    text = """\
Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/DepthCloud
      Auto Size: {Auto Size Factor: 1, Value: true}
      Color: 1; 2; 3
      Color Image Topic: ""
      Color Transformer: FlatColor
      Color Transport Hint: raw
      Depth Map Topic: /cam/depth/image_raw
      Depth Map Transport Hint: raw
      Enabled: true
      Name: Depth
      Occlusion Compensation: {Occlusion Time-Out: 30, Value: false}
      Topic Filter: true
      Value: true
"""
    layout, unknown = read_layout(write(text, "depth.rviz"))
    settings = (("color_by", "flat"), ("color", (1, 2, 3)))
    assert layout.displays == (DisplayLayout("/cam/depth/image_raw", "", settings, "DepthCloud"),)
    assert unknown == ["Auto Size of the display Depth"]
    written, missing = rviz_text(layout)
    assert missing == []
    assert "Depth Map Topic: /cam/depth/image_raw" in written
    again, _ = read_layout(write(written, "again.rviz"))
    assert again.displays == layout.displays
    assert read_layout(write(layout_text(layout))) == (layout, [])


def test_efforts_of_rviz_are_read_and_written(write: Write) -> None:
    text = """\
Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/Effort, Scale: 3, Width: 0.1, Alpha: 0.5, TF Prefix: "",
       Robot Description: arm/robot_description, Topic: {Value: /joint_states}}
"""
    layout, unknown = read_layout(write(text, "effort.rviz"))
    settings = {"description": "arm/robot_description", "opacity": 0.5, "width": 0.1, "scale": 3.0}
    assert layout.displays == (DisplayLayout("/joint_states", "", tuple(settings.items()), "Effort"),)
    assert unknown == []
    written, missing = rviz_text(layout)
    assert missing == []
    assert read_layout(write(written, "again.rviz"))[0].displays == layout.displays


def test_property_of_rviz_without_a_counterpart_is_named_unless_it_changes_nothing(write: Write) -> None:
    text = CLOUD_OF_RVIZ.replace("Position Transformer: XYZ", "Position Transformer: XYZW\n      Glow: 3")
    _, unknown = read_layout(write(text, "all.rviz"))
    assert unknown == ["Position Transformer, Glow of the display Lidar"]


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ("Style: Boxes", "Style of the display Lidar, which has to be one of Points, Spheres, Flat Squares"),
        ("Decay Time: 1.5", "Decay Time of the display Lidar, which has to be a number from 0 to 1e"),
        ("Use rainbow: false", "Use rainbow of the display Lidar, which has to be true or false"),
        (
            "Namespaces: {walls: false, floor: true, doors: false}",
            "Namespaces of the display MarkerArray, which has",
        ),
    ],
)
def test_hostile_value_of_rviz_is_a_sentence(write: Write, given: str, sentence: str) -> None:
    key = given.partition(":")[0]
    assert given in CLOUD_OF_RVIZ
    for value in ("[[]]", "9" * 400, "'" + "x" * 5000 + "'", ".nan"):
        _, unknown = read_layout(write(CLOUD_OF_RVIZ.replace(given, f"{key}: {value}"), "all.rviz"))
        (named,) = unknown
        assert sentence in named
        assert len(named) < 300
