"""Any value in any field, and any command: the view draws it or says why not, and nothing of it was unforeseen."""

from __future__ import annotations

import json
import math
import random
import re
import time
import warnings
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.viewer.conftest import Page
from tests.viewer.messages import ARM, header
from tests.viewer.stages import Stage
from tests.viewer.test_hostile import MESSAGES
from tests.viewer.test_interactive_markers import moved, thing, update
from tests.viewer.test_pages import feed

from tfloom.interfaces.sensor_msgs.msg import CompressedImage, Image
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerUpdate, Marker
from tfloom.node.node import Node
from tfloom.rosidl.class_search import find_field_class
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.spec import FLOATS, INTEGER_RANGES, STRINGS
from tfloom.viewer.displays.interactive_markers import InteractiveMarkersDisplay, handle_of, rotation_of
from tfloom.viewer.displays.kinds import KINDS, ROBOT_TYPE
from tfloom.viewer.forms.sending import FORM_COMMANDS
from tfloom.viewer.pictures import picture_of
from tfloom.viewer.program import LIVE_COMMANDS, Viewer
from tfloom.viewer.shapes import DisplayError

MESSAGES_OF_A_KIND = 90
COMMANDS = 400
LONGEST_S = 120.0
UNFORESEEN = re.compile(r"\(\w+\.py, line \d+\)")
"""The place of an unforeseen fault, in its text."""

NUMBERS = (0.0, -0.0, 1.0, -1.0, 0.5, math.pi, 1e-300, 5e-324, 1e12, 1e13, 1e38, 4e38, 1e154, 1e300, -1e300)
WILD = (math.nan, math.inf, -math.inf, 1.7976931348623157e308, -1.7976931348623157e308)
TEXTS = (
    *(
        "",
        "map",
        "a",
        "b",
        "/map",
        "world",
        "nowhere",
        "x" * 300,
        "a\0b",
        "\x1b[31m",
        "é\u202e",
        "\U0001f422",
    ),
    *(
        "mono8",
        "rgb8",
        "32FC1",
        "16UC1",
        "bayer_rggb8",
        "file://[x.stl",
        "file:///dev/zero",
        "package://a/b.stl",
    ),
    *("file:///nothing.dae", "http://x/y.glb", "<robot", "<robot name='r'><link name='a'/></robot>", "jpeg"),
)


def random_number(chance: random.Random, base: str) -> float:
    value = chance.choice(NUMBERS if chance.random() < 0.8 else WILD)
    if base == "float32" and math.isfinite(value) and abs(value) > 3.4e38:
        return math.copysign(3.4e38, value)
    return value


def random_value(chance: random.Random, base: str, size: int) -> Any:
    """Return a value of a primitive type, or a message."""
    if base == "bool":
        return chance.random() < 0.5
    if base in FLOATS:
        return random_number(chance, base)
    if base in INTEGER_RANGES:
        low, high = INTEGER_RANGES[base]
        value = chance.choice((0, 1, 2, 3, 4, 7, 12, 100, low, high, low + 1, high - 1, chance.randrange(20)))
        return bytes([value]) if base == "byte" else min(max(value, low), high)
    if base in STRINGS:
        return chance.choice(TEXTS)
    return random_message(chance, find_field_class(base), size)


def random_message(chance: random.Random, message_class: type[Any], size: int = 40) -> Any:
    """Return a message with any values in any fields; its arrays are short, the deeper the shorter."""
    message = message_class()
    for name, text in message_class._FIELDS.items():
        if chance.random() < 0.25:
            continue
        type_ = parse_type(text)
        inner = size // 3
        if not type_.shape:
            value = random_value(chance, type_.base, inner)
        else:
            count = (
                type_.length
                if type_.shape == "array"
                else chance.choice((0, 1, 2, 3, chance.randrange(size + 1)))
            )
            if type_.shape == "bounded":
                count = min(count, type_.length)
            value = [random_value(chance, type_.base, inner) for _ in range(count)]
            if type_.base == "byte":
                value = b"".join(value)
        setattr(message, name, value)
    return message


def mixed(chance: random.Random, good: Any, wild: Any) -> Any:
    """Return a good message in which some fields are those of a wild one, and others are mixed themselves."""
    message = type(good)()
    for name, text in type(good)._FIELDS.items():
        type_ = parse_type(text)
        mine, other = getattr(good, name), getattr(wild, name)
        if type_.is_primitive or type_.shape:
            setattr(message, name, other if chance.random() < 0.3 else mine)
        else:
            setattr(message, name, mixed(chance, mine, other))
    return message


NODE_NUMBERS = (
    *("points", "batched_positions", "batched_wxyzs", "vertices", "dimensions", "radius", "height", "scale"),
    *("render_width", "render_height", "axes_length", "shaft_radius"),
)
"""What nodes of viser's scene have."""


def check_nodes(stage: Stage, topic: str) -> None:
    """Check that pages get numbers that they can compute with."""
    for node in stage.drawn(topic):
        for name in (
            "points",
            "batched_positions",
            "batched_wxyzs",
            "vertices",
            "dimensions",
            "radius",
            "height",
            "scale",
        ):
            if hasattr(node, name):
                numbers = np.asarray(getattr(node, name), np.float64)
                assert (np.abs(numbers) <= 1e12).all(), (name, numbers)
        assert (np.abs(node.position) <= 2e12).all()
        assert np.linalg.norm(node.wxyz) == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("topic", [*MESSAGES, "/marker"])
def test_any_value_in_any_field_is_drawn_or_is_a_sentence_that_was_foreseen(stage: Stage, topic: str) -> None:
    chance = random.Random(zlib.crc32(topic.encode()) + 1)
    good = MESSAGES.get(topic) or MESSAGES["/markers"].markers[0]
    stage.move("map", "a", 1.0, 2.0)
    stage.move("a", "b", 1e11, 1e308)
    stage.topics.add(topic, good)
    if topic == "/joint_states":
        stage.topics.add("/robot_description", String(data=ARM))
    stage.view.set_display(topic, on=True)
    stage.draw()
    drawn = 0
    start_s = time.monotonic()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for number in range(MESSAGES_OF_A_KIND):
            wild = random_message(chance, type(good))
            message = wild if number % 3 == 0 else mixed(chance, good, wild)
            if type(good) is Marker and number % 2:
                message.type, message.action = chance.randrange(12), 0
            stage.topics.add(topic, message, (2 + number) * 10**9)
            state = stage.draw()
            assert not UNFORESEEN.search(stage.status(topic)), (stage.status(topic), message)
            assert stage.reports == [], message
            check_nodes(stage, topic)
            drawn += len(stage.drawn(topic))
            feed_of = stage.view.feed(topic)
            assert feed_of is not None
            assert not feed_of.has_failed
            assert len(json.dumps(state)) < 10**6
    assert drawn
    assert time.monotonic() < start_s + LONGEST_S
    stage.topics.add(topic, good, 10**4 * 10**9)
    stage.draw()
    assert stage.drawn(topic)


def test_each_kind_has_its_messages() -> None:
    fuzzed = {message._TYPE_NAME for message in MESSAGES.values()} | {
        Marker._TYPE_NAME,
        InteractiveMarkerUpdate._TYPE_NAME,  # by the next test, because its feed takes more than its topic
        "turtlesim_msgs/msg/Pose",
    }
    assert {kind for kind, made in KINDS.items() if made.module} | {ROBOT_TYPE} == fuzzed


def test_any_interactive_marker_has_parts_or_a_sentence() -> None:
    chance = random.Random(11)
    good = update(0, markers=[thing("a"), thing("b")], poses=[moved("a", 1.0)], erases=["b"])
    display = InteractiveMarkersDisplay({"descriptions": True, "axes": True})
    display.initialize(0, [thing("a")])
    parts = faults = requests = 0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for number in range(1, 400):
            message = mixed(chance, good, random_message(chance, InteractiveMarkerUpdate, 8))
            if chance.random() < 0.9:
                message.seq_num, message.type = number, InteractiveMarkerUpdate.UPDATE
            display.take(message, 0)
            if display.needs_all:
                requests += 1
                display.initialize(number, message.markers)
            assert not UNFORESEEN.search(display.status), (display.status, message)
            faults += bool(display.status)
            for known in display.markers.values():
                assert 0.0 < known.size_m < 1e6
                parts += sum(np.isfinite(part.placed.position).all() for part in display.parts_of(known))
                assert is_finite_or_refused(lambda known=known: known.base.position)
                assert is_finite_or_refused(
                    lambda known=known: known.frame_from_marker.apply((1.0, 2.0, 3.0))
                )
                for control in known.message.controls:
                    handle_of(control)
                    assert is_finite_or_refused(
                        lambda turned=control: rotation_of(turned).apply((1.0, 2.0, 3.0))
                    )
    assert parts > 100
    assert faults > 5
    assert requests > 5


def is_finite_or_refused(point: Callable[[], Any]) -> bool:
    try:
        return bool(np.isfinite(point()).all())
    except DisplayError:
        return True


def test_any_image_is_a_picture_or_a_sentence() -> None:
    chance = random.Random(7)
    good = Image(header=header(), width=8, height=6, step=24, encoding="rgb8", data=bytes(144))
    pictures = 0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for number in range(600):
            made: Any = mixed(chance, good, random_message(chance, Image))
            if number % 4 == 0:
                starts = (b"\xff\xd8\xff", b"\x89PNG\r\n\x1a\n", b"RIFF", b"")
                made = CompressedImage(
                    format=chance.choice(TEXTS), data=chance.choice(starts) + chance.randbytes(50)
                )
            elif number % 4 == 1:
                encoding, width = chance.choice((("32FC1", 4), ("16UC1", 2), ("mono16", 2), ("8UC1", 1)))
                made = Image(
                    width=5, height=4, step=5 * width, encoding=encoding, data=chance.randbytes(20 * width)
                )
                made.is_bigendian = chance.randrange(2)
            try:
                assert picture_of(made)[1]
                pictures += 1
            except DisplayError:
                continue
    assert pictures > 100


# Commands.

OPERATIONS = (
    *(
        "fixed_frame",
        "hold",
        "play",
        "select",
        "unselect",
        "mark",
        "trail",
        "display",
        "choose",
        "names",
        "axes",
        "plot",
        "plot_choice",
        "plot_time",
    ),
    *("layout", "plot_topics", "plot_fields", "plot_csv", "place", "opened", "image_fault", "no_such", ""),
    *sorted(LIVE_COMMANDS - {"drive"}),
    *sorted(FORM_COMMANDS),
)
PAGE_VALUES = (
    *(None, True, False, 0, 1, -1, 0.3, 10**400, -(10**400), 2**63, 1e308, 5e-324, -0.0),
    *(
        "",
        "map",
        "base",
        "laser",
        "nowhere",
        "/points",
        "/markers",
        "/rosout",
        "/nothing",
        "\ud800",
        "a\udfffb",
        "a\0b",
    ),
    *(
        "x" * 4096,
        "x" * 4097,
        "\x1b[31m",
        "header.stamp.sec",
        "transforms[0].transform.translation.x",
        "a" * 2000 + "[0]",
    ),
    *(
        "0",
        "105000000000",
        "9" * 19,
        "9" * 20,
        "-1",
        "1e5",
        "²",
        "topic",
        "service",
        "action",
        "goal",
        "point",
        "initial",
    ),
    *(
        "std_msgs/msg/String",
        "geometry_msgs/msg/Twist",
        "std_srvs/srv/Empty",
        "a/b/C",
        "../../x",
        "/feeder",
        "use_sim_time",
    ),
    *([], {}, [[]], [1, 2], [0.5, 0.5], [10**400, 0], ["map"], ["\ud800"], ["a"] * 30, [None], [True, False]),
    *(
        {"data": "x"},
        {"data": "\ud800"},
        {"linear": {"x": "nan"}},
        {"linear": [1]},
        {"no": 1},
        {"data": ["x"] * 100},
    ),
)
KEYS = (
    *(
        "frame",
        "stamp_ns",
        "on",
        "frames",
        "topic",
        "choice",
        "length",
        "field",
        "node",
        "name",
        "value",
        "what",
        "type",
    ),
    *("key", "values", "rate_hz", "tool", "from", "to", "clock"),
    *("plot", "axis", "unroll", "length_s", "end_ns"),
)


def random_command(chance: random.Random) -> dict[str, Any]:
    command: dict[str, Any] = {key: chance.choice(PAGE_VALUES) for key in KEYS if chance.random() < 0.85}
    likely = {
        "frame": ("map", "base", "laser"),
        "on": (True, False),
        "topic": ("/tf", "/rosout"),
        "key": ("k",),
        "stamp_ns": ("105000000000", None),
        "what": ("topic", "service"),
        "from": ([0.5, 0.6],),
        "to": ([0.6, 0.7],),
        "rate_hz": (0, 5),
    }
    for key, values in likely.items():
        if chance.random() < 0.5:
            command[key] = chance.choice(values)
    command["op"] = chance.choice(OPERATIONS) if chance.random() < 0.97 else chance.choice(PAGE_VALUES)
    return command


def test_any_command_ends_in_a_sentence_that_was_foreseen(
    node: Node, viewer: Viewer, open_page: Callable[[Viewer], Page], tmp_path: Path
) -> None:
    page, other = open_page(viewer), open_page(viewer)
    feed(node, viewer)
    chance = random.Random(43)
    start_s = time.monotonic()
    sent = 0
    for number in range(COMMANDS):
        command = random_command(chance)
        text = json.dumps(command)
        if number % 50 == 49:
            text = text[: chance.randrange(len(text))]
        page.socket.send(text)
        sent += 1
        if number % 20 == 19:  # the pages take what there is, and see that the viewer goes on
            length = 0.1 + (number % 7) / 10.0
            other.send(op="axes", length=length)
            other.wait_for(lambda length=length: other.state["axes_m"] == pytest.approx(length))
            page.state = {}
            page.wait_for(lambda: page.state)
    for answer in page.answers:
        assert not UNFORESEEN.search(json.dumps(answer)), answer
    assert not [line for line in [*page.log, *other.log] if UNFORESEEN.search(line["text"])]
    assert len([answer for answer in page.answers if "error" in answer]) > sent / 4
    assert time.monotonic() < start_s + LONGEST_S
    assert other.answers == []
