"""What objects show in a notebook: readable in light and dark, bounded for large data, and text stays text."""

from __future__ import annotations

import io
import re
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from tests.bag.recordings import drive, write_mcap

from tfloom.bag import open_bag
from tfloom.bag.bag import Bag
from tfloom.bag.reading.bag_file import BagFile
from tfloom.bag.values import Topic, Topics
from tfloom.common.notebook import MAX_POINTS, drawing
from tfloom.interfaces.geometry_msgs.msg import Point
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.interfaces.std_msgs.msg import Header, String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_ros.buffer import Buffer as RosBuffer
from tfloom.turtlesim.canvas import Canvas
from tfloom.turtlesim.world import Stroke

SECOND = 1_000_000_000
ORIGIN, IDENTITY = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
EVIL = "<script>alert(1)</script>\"'&"
LARGE = 100_000
"""Length of what is shown of anything, at most [characters]."""


@pytest.fixture
def buffer() -> Buffer:
    made = Buffer(None)
    for i in range(21):
        made.set(
            "map", "odom", 100 * SECOND + i * SECOND // 10, (i / 10, 0.0, 0.0), IDENTITY, authority="slam"
        )
    made.set("odom", "lidar", 0, ORIGIN, IDENTITY, static=True)
    return made


def scan(ranges: Any, frame_id: str = "lidar") -> LaserScan:
    count = max(1, len(ranges))
    return LaserScan(
        header=Header(frame_id=frame_id),
        angle_min=-np.pi,
        angle_increment=2 * np.pi / count,
        range_min=0.1,
        range_max=10.0,
        ranges=ranges,
    )


def dots(svg: str) -> np.ndarray:
    """Return the places of a drawing's dots (N, 2) [pixels]."""
    return np.array(re.findall(r"M([\d.-]+) ([\d.-]+)h0", svg), float)


def assert_shown(shown: str) -> None:
    """Check that HTML is whole, has its layout inline, and keeps the colours of the page."""
    # An XML parser wants each tag to be closed, and each text to be escaped.
    tree = ET.fromstring(f"<div>{shown.replace('<details open>', '<details>')}</div>")
    tags = [element.tag for element in tree.iter()]
    assert not {"script", "img", "style", "iframe"} & set(tags)
    for element in tree.iter():
        style = element.get("style", "")
        if element.tag in {"table", "th", "td"}:
            assert "text-align:left" in style or "border-collapse" in style
        for declaration in style.split(";"):
            name, _, value = declaration.partition(":")
            if name == "color":
                assert value == "inherit"
            if name == "background":
                assert value == "transparent"
    assert len(shown) < LARGE


def test_buffer_prints_its_frames_and_its_span(buffer: Buffer) -> None:
    text = "3 frames, 22 transforms, from 100.000 to 102.000 (2.000 s)"
    assert str(buffer) == f"Buffer: {text}"
    assert repr(buffer) == f"<Buffer: {text}>"
    assert str(Buffer()) == "Buffer: 0 frames, 0 transforms"
    static = RosBuffer()
    static.set("a", "b", 0, ORIGIN, IDENTITY, static=True)
    assert str(static) == "Buffer: 2 frames, 1 transform"


def test_buffer_shows_its_tree(buffer: Buffer) -> None:
    buffer.set("map", EVIL, 0, ORIGIN, IDENTITY, static=True)
    buffer.set("map", "n" * 1000, 0, ORIGIN, IDENTITY, static=True)
    buffer.set("map", "seen_once", 10 * 10**9, ORIGIN, IDENTITY)
    shown = buffer._repr_html_()
    assert_shown(shown)
    assert "21 samples, 10.0 Hz, 100.000 to 102.000" in shown
    assert "1 sample, at 10.000" in shown
    assert "&lt;script&gt;" in shown
    assert "n" * 501 not in shown
    assert_shown(RosBuffer()._repr_html_())


def test_edge_and_explanation_show_tables(buffer: Buffer) -> None:
    buffer.set("lidar", EVIL, 0, ORIGIN, IDENTITY, static=True)
    for edge in buffer.edges():
        assert_shown(edge._repr_html_())
    explanation = buffer.explain("map", EVIL, 200 * SECOND)
    shown = explanation._repr_html_()
    assert_shown(shown)
    assert shown.count("<tr") == 4
    (row,) = (row for row in shown.split("<tr") if "here" in row)
    assert ">odom</code>" in row
    assert "slam" in row
    known = buffer.explain("map", "lidar")._repr_html_()
    assert "known" in known
    assert "here" not in known
    assert_shown(buffer.explain("map", "nowhere")._repr_html_())


def test_long_explanation_keeps_the_failing_link() -> None:
    long = Buffer(None)
    for i in range(900):
        long.set(f"f{i}", f"f{i + 1}", 0, ORIGIN, IDENTITY, static=True)
    for i in range(2):
        long.set("root", "f0", (1 + i) * SECOND, ORIGIN, IDENTITY)
    shown = long.explain("root", "f900", 5 * SECOND)._repr_html_()
    assert_shown(shown)
    assert "800 more links" in shown
    assert "here" in shown
    for i in range(900, 2000):
        long.set(f"f{i}", f"f{i + 1}", 0, ORIGIN, IDENTITY, static=True)
    assert_shown(long.explain("root", "f2000", 5 * SECOND)._repr_html_())


def test_trajectory_shows_a_table_and_its_way(buffer: Buffer) -> None:
    trajectory = buffer.trajectory("map", "lidar")
    assert repr(trajectory) == "<Trajectory of lidar in map: 21 poses, 2.000 s, 2.000 m>"
    shown = trajectory._repr_html_()
    assert_shown(shown)
    assert "2.000 m" in shown
    assert "<polyline" in shown
    empty = trajectory._replace(
        stamps_ns=np.empty(0, np.int64), positions=np.empty((0, 3)), rotations_xyzw=np.empty((0, 4))
    )
    assert_shown(empty._repr_html_())
    assert "0 poses" in repr(empty)


def test_recording_shows_its_topics_and_times(tmp_path: Path) -> None:
    write_mcap(tmp_path / "a.mcap", drive())
    bag = open_bag(tmp_path / "a.mcap")
    assert_shown(bag._repr_html_())
    rows = re.findall(r"<tr.*?</tr>", bag.topics._repr_html_())
    assert len(rows) == 1 + len(bag.topics)
    assert any("/tf_static" in row and f">{bag.topics['/tf_static'].message_count}<" in row for row in rows)
    assert f"{bag.message_count} messages in " in bag._repr_html_()
    assert "2023-11-14 22:13:20 UTC" in bag._repr_html_()
    late = open_bag(tmp_path / "a.mcap")
    late.end_ns = 1 << 70  # as a damaged metadata.yaml may say
    assert f" to {(1 << 70) // 1_000_000_000} s<" in late._repr_html_()


def test_recording_that_cannot_be_read_shows_its_error() -> None:
    gone = Bag(Path(EVIL), [BagFile(Path(EVIL))], None)
    assert_shown(gone._repr_html_())
    assert "there is no such file" in gone._repr_html_()


def test_many_topics_show_their_beginning() -> None:
    topics = Topics({f"/{number}": Topic(f"/{number}", EVIL) for number in range(1000)})
    assert_shown(topics._repr_html_())
    assert "900 more topics" in topics._repr_html_()
    assert_shown(Topics({EVIL: Topic(EVIL * 1000, EVIL * 1000)})._repr_html_())
    assert len(Topics({EVIL: Topic("n" * LARGE, "t" * LARGE)})._repr_html_()) < LARGE
    assert Topics()._repr_html_() == "no topics"
    assert_shown(Bag(Path(EVIL), [], None)._repr_html_())


def test_scan_shows_its_points() -> None:
    shown = scan([2.0, 1.0, 4.0, 3.0, np.nan, np.inf, 0.01, 11.0], EVIL)._repr_html_()
    assert_shown(shown)
    assert len(dots(shown)) == 4
    # Straight back, to the right, ahead, to the left.
    back, right, ahead, left = dots(scan([2.0, 1.0, 4.0, 3.0])._repr_html_())
    assert back[0] < ahead[0]
    assert left[1] < right[1]
    assert back[1] == ahead[1]
    assert left[0] == right[0]
    assert (ahead - back)[0] / (right - left)[1] == pytest.approx(6 / 4, rel=0.01)


def test_hostile_and_empty_scans_show_no_points() -> None:
    for ranges in ([], [1.0], [np.nan] * 5, [-np.inf, np.inf]):
        shown = scan(ranges)._repr_html_()
        assert_shown(shown)
        assert "<svg" not in shown
    odd = scan([1.0, 2.0, 3.0])
    odd.angle_increment = np.inf
    assert_shown(odd._repr_html_())
    odd.angle_increment, odd.angle_min, odd.range_max = 3e38, 3e38, np.inf
    odd.ranges = [3e38, 3e38, 3e38]
    assert_shown(odd._repr_html_())


def test_large_messages_show_their_beginning() -> None:
    big = scan(np.linspace(1, 9, 200_000))
    assert_shown(big._repr_html_())
    assert len(dots(big._repr_html_())) == MAX_POINTS
    assert_shown(String(data=EVIL * 100_000)._repr_html_())
    markers = MarkerArray(markers=[Marker(points=[Point()] * 1000) for _ in range(100)])
    assert "90 more" in markers._repr_html_()
    assert len(markers._repr_html_()) < 1_000_000
    assert_shown(TFMessage()._repr_html_())


def test_drawing_takes_any_numbers() -> None:
    for extent in (0.0, 1e-300, 1.0, 1.7e308):
        svg = drawing(np.array([(-extent, 0.0), (extent, extent), (np.nan, 1.0)]), EVIL, as_line=True)
        assert_shown(svg)
        assert "nan" not in svg.partition("</title>")[2]
        assert "inf" not in svg
    assert not drawing(np.empty((0, 2)), "nothing", as_line=False)


def test_canvas_shows_its_strokes() -> None:
    canvas = Canvas()
    blank = canvas._repr_png_()
    canvas.paint(Stroke((5.5, 5.5), (8.0, 5.5), (255, 0, 0), 3))
    with Image.open(io.BytesIO(canvas._repr_png_())) as picture:
        assert picture.size == (500, 500)
        colours = {colour for _, colour in picture.convert("RGB").getcolors(1 << 20)}
    assert (255, 0, 0) in colours
    with Image.open(io.BytesIO(blank)) as picture:
        assert picture.convert("RGB").getcolors() == [(250_000, canvas.background)]
