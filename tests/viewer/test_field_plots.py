"""Numeric fields over time: their paths, the numbers that are kept, and what pages get of them."""

from __future__ import annotations

import csv
import io
import json
import math
import signal
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.conftest import Program, wait_until
from tests.tf2_tools.recordings import START_NS, transform
from tests.viewer.conftest import OWN_TYPES, Page, running

from tfloom.bag import open_bag
from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.geometry_msgs.msg import PointStamped, PoseArray, PoseStamped, PoseWithCovariance
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.interfaces.std_msgs.msg import Float64, String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.node import Node
from tfloom.rosidl import cdr
from tfloom.rosidl.class_search import find_class
from tfloom.rosidl.definition_files import interface_names
from tfloom.viewer.described import DescribedTopics
from tfloom.viewer.layout.layout import PlotLayout
from tfloom.viewer.page_command import PageError
from tfloom.viewer.plots import plots as plots_module
from tfloom.viewer.plots import series as series_module
from tfloom.viewer.plots.field_path import number_at, numeric_paths, parse_path
from tfloom.viewer.plots.series import Series
from tfloom.viewer.program import Viewer
from tfloom.viewer.recorded import RecordedTopics, recorded_viewer

OpenPage = Callable[[Viewer], Page]
S = 1_000_000_000


# Paths.


def test_paths_of_every_type_are_paths_of_numbers() -> None:
    for name in interface_names("msg"):
        message_class = find_class(name)
        for path in numeric_paths(message_class):
            number_at(message_class(), parse_path(message_class, path))


def test_number_is_that_of_the_path() -> None:
    scan = LaserScan(ranges=[1.0, 2.0, 4.5])
    assert number_at(scan, parse_path(LaserScan, "ranges[2]")) == 4.5
    assert math.isnan(number_at(scan, parse_path(LaserScan, "ranges[3]")))
    covariance = PoseWithCovariance(covariance=range(36))
    assert number_at(covariance, parse_path(PoseWithCovariance, " covariance[35] ")) == 35.0
    assert "poses[0].position.x" in numeric_paths(PoseArray)
    level = find_class("diagnostic_msgs/msg/DiagnosticStatus")
    assert number_at(level(level=b"\x02"), parse_path(level, "level")) == 2.0


WRONG_PATHS: list[tuple[type[Any], str, str]] = [
    (LaserScan, "rages[0]", "has no field rages.*ranges"),
    (LaserScan, "ranges", "needs an index, as ranges"),
    (LaserScan, "header", "is a message: choose one of its fields, stamp, frame_id"),
    (LaserScan, "header.frame_id", "is a text"),
    (LaserScan, "scan_time[0]", "is not an array"),
    (LaserScan, "scan_time.x", "scan_time is a value"),
    (LaserScan, "ranges[-1]", "not a path"),
    (LaserScan, "ranges[1][2]", "not a path"),
    (LaserScan, "", "not a path"),
    (LaserScan, "__class__", "not a path"),
    (LaserScan, "_FIELDS", "not a path"),
    (PoseWithCovariance, "covariance[36]", "at most 36 elements"),
]


def test_wrong_paths_are_named() -> None:
    for message_class, path, sentence in WRONG_PATHS:
        with pytest.raises(PageError, match=sentence):
            parse_path(message_class, path)


# Numbers.


def test_old_numbers_are_dropped() -> None:
    series = Series(10 * S)
    for second in range(1000):
        series.add(second * S, float(second))
    assert series.span == (pytest.approx(989 * S, abs=64 * S), 999 * S)
    assert len(series) <= 10 + 64
    assert series.at(998 * S) == 998.0


def test_late_numbers_stand_at_their_time() -> None:
    series = Series(None)
    for second in (1, 4, 2, 3):
        series.add(second * S, float(second))
    assert series.reduced_points(0, 4 * S, 10) == ([-3.0, -2.0, -1.0, 0.0], [1.0, 2.0, 3.0, 4.0])
    assert series.at(2 * S + 1) == 2.0
    assert series.at(0) is None


def test_page_gets_few_numbers_and_every_peak_among_many(monkeypatch: pytest.MonkeyPatch) -> None:
    series = Series(None)
    monkeypatch.setattr(series_module, "MAX_SAMPLES", 4_000)
    values = np.sin(np.arange(14_000) / 500.0)
    values[3_777], values[12_001] = 9.0, -9.0
    for number, value in enumerate(values.tolist()):
        series.add(number * S, value)
    assert len(series) <= 4_000
    seconds, shown = series.reduced_points(0, 13_999 * S, 100)
    assert len(shown) <= 200
    assert (max(shown), min(shown)) == (9.0, -9.0)
    assert seconds == sorted(seconds)
    assert seconds[shown.index(9.0)] == pytest.approx(3_777 - 13_999)
    assert seconds[-1] <= 0.0


def test_what_is_not_finite_is_a_gap() -> None:
    series = Series(None)
    for second, value in enumerate((1.0, math.inf, math.nan, -1e308, 2.0)):
        series.add(second * S, value)
    _, shown = series.reduced_points(0, 4 * S, 10)
    assert shown == [1.0, None, None, None, 2.0]
    json.dumps(shown, allow_nan=False)
    gaps = Series(None)
    for second in range(100):
        gaps.add(second * S, math.nan)
    assert set(gaps.reduced_points(0, 100 * S, 5)[1]) == {None}


def test_angles_are_unrolled_if_asked_also_after_the_first_ones_are_dropped() -> None:
    series = Series(100 * S)
    turned = np.arange(0.0, 300.0, 0.5)
    for second, angle in enumerate(turned.tolist()):
        series.add(second * S, math.nan if second == 200 else math.remainder(angle, math.tau))
    assert series.span[0] > 400 * S
    assert max(series.reduced_points(0, 600 * S, 1000)[1]) <= math.pi
    seconds, shown = series.reduced_points(0, 600 * S, 1000, unrolls=True)
    assert shown == pytest.approx([(600 + second) / 2 for second in seconds], abs=1e-3)
    assert series.at(599 * S, unrolls=True) == pytest.approx(299.5)
    assert abs(series.at(599 * S)) <= math.pi
    series.clear()
    series.add(0, 1.0)
    assert series.at(None, unrolls=True) == 1.0


def test_angles_are_unrolled_also_where_a_gap_is_the_first_that_is_left() -> None:
    series = Series(100 * S)
    angles = np.arange(0.0, 640.0, 0.5)  # dropped 64 at a time: each drop is followed by a gap
    for second, angle in enumerate(angles.tolist()):
        is_gap = second % 64 in range(8, 11)
        series.add(second * S, math.nan if is_gap else math.remainder(angle, math.tau))
    assert series.span is not None
    assert math.isnan(series.between(series.span[0], series.span[0])[1][0])
    assert series.at(None, unrolls=True) == pytest.approx(angles[-1])


def test_gap_does_not_end_what_is_unrolled() -> None:
    series = Series(None)
    for second, angle in enumerate((3.0, math.nan, -3.0)):
        series.add(second * S, angle)
    assert series.reduced_points(0, 3 * S, 10, unrolls=True)[1] == [3.0, None, pytest.approx(math.tau - 3.0)]


def test_numbers_beside_the_time_that_is_shown_are_there_for_the_lines_to_its_edges() -> None:
    series = Series(None)
    for second in range(1000):
        series.add(second * S, float(second))
    assert series.reduced_points(10 * S, 12 * S, 100) == (
        [-3.0, -2.0, -1.0, 0.0, 1.0],
        [9.0, 10.0, 11.0, 12.0, 13.0],
    )
    seconds, shown = series.reduced_points(S, 998 * S, 10)
    assert (shown[0], shown[-1]) == (0.0, 999.0)
    assert seconds == sorted(seconds)


def test_stamps_within_microseconds_differ_on_the_page() -> None:
    series = Series(None)
    for number in range(5):
        series.add(S + 200 * number, float(number))
    assert len(set(series.reduced_points(S, S + 1000, 100)[0])) == 5


def test_old_numbers_are_kept_while_they_are_looked_at() -> None:
    series = Series(10 * S)
    series.kept_from_ns = 5 * S
    for second in range(1000):
        series.add(second * S, float(second))
    assert series.span == (pytest.approx(5 * S, abs=5 * S), 999 * S)
    series.kept_from_ns = None
    for second in range(1000, 1064):
        series.add(second * S, float(second))
    assert series.span[0] > 900 * S


# On a graph.


def plot_of(page: Page, field: str) -> dict[str, Any] | None:
    return next((plot for plot in page.state["plots"] if plot["field"] == field), None)


def test_page_plots_fields_and_ends_them(node: Node, viewer: Viewer, open_page: OpenPage) -> None:
    publisher = node.create_publisher(LaserScan, "/scan", 10)
    page = open_page(viewer)
    wait_until(lambda: "/scan" in viewer.view.topics.types(), what="the topic")
    assert ["/scan", "sensor_msgs/msg/LaserScan"] in page.ask("plot_topics", op="plot_topics")
    assert page.ask("plot_fields", op="plot_fields", topic="/scan")["fields"][:3] == [
        "header.stamp.sec",
        "header.stamp.nanosec",
        "angle_min",
    ]
    for field in ("range_max", "ranges[1]", "intensities[0]"):
        page.send(op="plot", topic="/scan", field=field, on=True)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="one reader for all")
    for second in range(5):
        scan = LaserScan(range_max=float(second), ranges=[0.0, second * 2.0])
        scan.header.stamp.sec = 100 + second
        publisher.publish(scan)
    page.wait_for(lambda: (plot_of(page, "ranges[1]") or {}).get("shown") == 8.0)
    plot = plot_of(page, "range_max")
    assert plot["values"] == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert plot["seconds"] == [-4.0, -3.0, -2.0, -1.0, 0.0]
    assert (plot["end_ns"], plot["length_s"], plot["status"]) == (str(104 * S), 4.0, "")
    assert "an array is shorter" in plot_of(page, "intensities[0]")["status"]
    page.socket.close()
    wait_until(lambda: publisher.get_subscription_count() == 0, what="the reader's end with the page")
    again = open_page(viewer)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader of the next page")
    again.wait_for(lambda: plot_of(again, "range_max") and plot_of(again, "range_max")["shown"] == 4.0)
    for field in ("range_max", "ranges[1]", "intensities[0]"):
        again.send(op="plot", topic="/scan", field=field, on=False)
    wait_until(lambda: publisher.get_subscription_count() == 0, what="the reader's end")


def test_fields_share_a_plot_with_two_axes_and_zoom_pause_and_layout_are_theirs(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    publisher = node.create_publisher(LaserScan, "/scan", 10)
    page = open_page(viewer)
    wait_until(lambda: "/scan" in viewer.view.topics.types(), what="the topic")
    for field in ("range_max", "range_min"):
        page.send(op="plot", topic="/scan", field=field, on=True)
    page.wait_for(lambda: [plot["plot"] for plot in page.state["plots"]] == [1, 2])
    choice = {"topic": "/scan", "field": "range_min", "plot": 1, "axis": "right", "unroll": True}
    page.send(op="plot_choice", **choice)
    page.wait_for(lambda: plot_of(page, "range_min")["axis"] == "right")
    assert plot_of(page, "range_min").items() >= choice.items()
    page.send(op="plot", topic="/scan", field="scan_time", plot=2, on=True)
    page.wait_for(lambda: plot_of(page, "scan_time") and plot_of(page, "scan_time")["plot"] == 2)
    for wrong, sentence in (
        ({"plot": 0}, "from 1 to"),
        ({"plot": 1.5}, "a whole number"),
        ({"axis": "top"}, "left or right"),
        ({"field": "none"}, "none of /scan is not plotted"),
        ({"unroll": 1}, "true or false"),
    ):
        assert sentence in page.ask("error", op="plot_choice", **(choice | wrong)), wrong
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader")
    for second in range(11):
        scan = LaserScan(range_max=float(second))
        scan.header.stamp.sec = 100 + second
        publisher.publish(scan)
    page.wait_for(lambda: (plot_of(page, "range_max") or {}).get("shown") == 10.0)
    assert page.state["plot_time"] == {
        "zero_ns": str(110 * S),
        "start_s": -10.0,
        "end_s": 0.0,
        "whole_s": 10.0,
        "is_paused": False,
        "is_zoomed": False,
    }
    page.send(op="plot_time", length_s=2.0, end_ns=None)
    page.wait_for(lambda: plot_of(page, "range_max")["values"] == [7.0, 8.0, 9.0, 10.0])
    page.send(op="plot_time", length_s=2.0, end_ns=str(105 * S))
    page.wait_for(lambda: plot_of(page, "range_max")["values"] == [2.0, 3.0, 4.0, 5.0, 6.0])
    assert page.state["plot_time"]["is_paused"]
    assert page.state["plot_time"]["start_s"] == -7.0
    for length in (0.0, 1e10, -1.0):
        assert "plots show from" in page.ask("error", op="plot_time", length_s=length, end_ns=None)
    page.send(op="plot_time", length_s=1e9, end_ns="9" * 19)  # as far as stamps go
    page.wait_for(lambda: plot_of(page, "range_max")["values"] == [10.0])
    layout = viewer.view.layout(None)
    assert layout.plots == (
        PlotLayout("/scan", "range_max", 1),
        PlotLayout("/scan", "range_min", 1, "right", unroll=True),
        PlotLayout("/scan", "scan_time", 2),
    )
    for plot in layout.plots:
        viewer.view.plots.remove(plot.topic, plot.field)
    viewer.view.apply(layout._replace(plots=(PlotLayout("/scan", "range_max"), *layout.plots[1:])))
    assert viewer.view.layout(None).plots == (PlotLayout("/scan", "range_max", 3), *layout.plots[1:])


def test_paused_plot_keeps_its_numbers_and_goes_on_when_it_follows(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    publisher = node.create_publisher(PointStamped, "/place", 1000)
    page = open_page(viewer)
    wait_until(lambda: "/place" in viewer.view.topics.types(), what="the topic")
    page.send(op="plot", topic="/place", field="point.x", on=True)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader")

    def publish(seconds: range) -> None:
        for second in seconds:
            place = PointStamped()
            place.header.stamp.sec, place.point.x = second, float(second)
            publisher.publish(place)
        page.wait_for(lambda: (plot_of(page, "point.x") or {}).get("shown") == float(seconds[-1]))

    publish(range(100, 131))
    page.send(op="plot_time", length_s=None, end_ns=str(130 * S))
    page.wait_for(lambda: page.state["plot_time"]["is_paused"])
    publish(range(131, 400))  # more than the viewer keeps
    assert plot_of(page, "point.x")["values"][:31] == [float(second) for second in range(100, 131)]
    assert (page.state["plot_time"]["start_s"], page.state["plot_time"]["end_s"]) == (-30.0, 0.0)
    page.send(op="plot_time", length_s=None, end_ns=None)
    page.wait_for(lambda: not page.state["plot_time"]["is_paused"])
    publish(range(400, 500))
    assert plot_of(page, "point.x")["values"][-31:] == [float(second) for second in range(469, 500)]
    assert plot_of(page, "point.x")["values"][0] >= 468.0


def test_numbers_that_are_shown_are_saved_with_their_times(
    node: Node, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    publisher = node.create_publisher(PointStamped, "/place", 1000)
    page = open_page(viewer)
    wait_until(lambda: "/place" in viewer.view.topics.types(), what="the topic")
    for axis in "xyz":
        page.send(op="plot", topic="/place", field=f"point.{axis}", plot=1 if axis != "z" else 2, on=True)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader")
    for number in range(4):
        place = PointStamped()
        place.header.stamp.sec, place.header.stamp.nanosec = 1_700_000_000 + number, 5
        place.point.x, place.point.y = number / 3.0, math.nan if number == 2 else 1e-9
        publisher.publish(place)
    page.wait_for(lambda: (plot_of(page, "point.x") or {}).get("shown") == 1.0)
    page.send(op="plot_time", length_s=2.0, end_ns=None)
    page.wait_for(lambda: page.state["plot_time"]["is_zoomed"])
    saved = page.ask("plot_csv", op="plot_csv", plot=1)
    assert saved["plot"] == 1
    rows = list(csv.reader(io.StringIO(saved["text"])))
    assert rows == [
        ["time [s since epoch]", "from the first row [s]", "/place point.x", "/place point.y"],
        ["1700000001.000000005", "0.000000000", repr(1 / 3.0), "1e-09"],
        ["1700000002.000000005", "1.000000000", repr(2 / 3.0), ""],
        ["1700000003.000000005", "2.000000000", "1.0", "1e-09"],
    ]
    assert "there is no plot 7" in page.ask("error", op="plot_csv", plot=7)
    monkeypatch.setattr(plots_module, "MAX_CSV_ROWS", 2)
    assert "3 rows, more than 2: zoom in" in page.ask("error", op="plot_csv", plot=1)


def test_names_in_a_file_of_numbers_are_quoted() -> None:
    plots = plots_module.Plots(DescribedTopics("<robot/>"), 60 * S)
    plots.add('/a,"b"', "data", is_there=False)
    assert plots.csv(1, None).splitlines()[0].endswith(',"/a,""b"" data"')
    assert next(csv.reader(io.StringIO(plots.csv(1, None))))[2] == '/a,"b" data'


def test_plot_waits_for_its_topic(node: Node, viewer: Viewer, open_page: OpenPage) -> None:
    viewer.view.plots.add("/late", "data", is_there=False)
    viewer.view.plots.add("/text", "data", is_there=False)
    page = open_page(viewer)
    page.wait_for(lambda: plot_of(page, "data"))
    assert page.state["plots"][0]["status"] == "nobody publishes /late yet"
    publisher = node.create_publisher(Float64, "/late", 10)
    node.create_publisher(String, "/text", 10)
    wait_until(publisher.get_subscription_count, what="the reader")
    publisher.publish(Float64(data=2.5))
    page.wait_for(lambda: page.state["plots"][0]["shown"] == 2.5)
    page.wait_for(lambda: "data is a text" in page.state["plots"][1]["status"])


def pathless(page: Page) -> dict[str, str]:
    """Return the status of each plot without a field, by topic."""
    return {plot["topic"]: plot["status"] for plot in page.state["plots"] if not plot["field"]}


def test_path_waits_for_its_topic_and_stands_for_its_fields(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    for path in (
        "/a/b/pose/position/x:z",
        "/a/b/pose/orientation",
        "/a/b/data/0",
        "/text",
        "/a/b/data",
        "/scan",
    ):
        viewer.view.plots.seek(path)
    page = open_page(viewer)
    page.wait_for(lambda: len(page.state["plots"]) == 6)
    assert page.state["plots"][0]["status"] == "nobody publishes /a/b/pose/position/x:z yet"
    assert viewer.view.plots.layout() == ()  # none is written into a layout
    # The topic is the longest name that a path begins with.
    node.create_publisher(Float64, "/a", 1)
    page.wait_for(lambda: "has no field b.pose" in page.state["plots"][0]["status"])
    node.create_publisher(PoseStamped, "/a/b", 1)
    node.create_publisher(String, "/text", 1)
    node.create_publisher(LaserScan, "/scan", 1)
    page.wait_for(lambda: len(viewer.view.plots.layout()) == 9)
    plots = viewer.view.plots.layout()
    # The fields of a path share its plot.
    assert [plot.plot for plot in plots if plot.topic == "/a/b"] == [1, 1, 2, 2, 2, 2]
    names = [(plot.topic, plot.field) for plot in plots]
    assert [field for topic, field in names if topic == "/a/b"] == [
        "pose.position.x",
        "pose.position.z",
        *(f"pose.orientation.{axis}" for axis in "xyzw"),
    ]
    # Of a message with more numbers than there is room for, the first; none within an array.
    assert [field for topic, field in names if topic == "/scan"] == [
        "header.stamp.sec",
        "header.stamp.nanosec",
        "angle_min",
    ]
    page.wait_for(lambda: "no numbers" in pathless(page)["/text"])
    left = pathless(page)
    assert left["/text"] == "/text has no numbers outside of arrays: name a field"
    assert "has no field data.0" in left["/a/b/data/0"]
    page.send(op="plot", topic="/text", field="", on=False)
    page.wait_for(lambda: all(plot["topic"] != "/text" for plot in page.state["plots"]))


def test_wrong_plots_get_a_sentence(
    node: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    node.create_publisher(Float64, "/number", 10)
    wait_until(lambda: "/number" in viewer.view.topics.types(), what="the topic")
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"op": "plot", "topic": "/number", "field": "date", "on": True}, "has no field date"),
        ({"op": "plot", "topic": "/none", "field": "data", "on": True}, "nobody publishes /none"),
        ({"op": "plot", "topic": "/number", "field": 3, "on": True}, "field has to be a text"),
        ({"op": "plot_fields", "topic": "/none"}, "nobody publishes /none"),
    ]
    for command, sentence in wrong:
        assert sentence in page.ask("error", **command), command
    assert viewer.view.plots.layout() == ()
    monkeypatch.setattr(plots_module, "MAX_PLOTS", 0)
    assert "there are 0 plots already" in page.ask("error", op="plot", topic="/number", field="data", on=True)


def test_damaged_message_is_a_sentence_and_the_next_one_counts(
    node: Node, viewer: Viewer, page: Page
) -> None:
    publisher = node.create_publisher(Float64, "/number", 10)
    wait_until(lambda: "/number" in viewer.view.topics.types(), what="the topic")
    page.send(op="plot", topic="/number", field="data", on=True)
    wait_until(publisher.get_subscription_count, what="the reader")
    publisher.publish(b"\x00\x01\x00\x00\x01\x02")
    page.wait_for(lambda: "Float64.data" in (plot_of(page, "data") or {}).get("status", ""))
    publisher.publish(Float64(data=1.5))
    page.wait_for(lambda: plot_of(page, "data")["shown"] == 1.5 and not plot_of(page, "data")["status"])


def test_fields_of_a_type_that_another_process_alone_has_and_a_wrong_description_is_a_sentence(
    viewer: Viewer, open_page: OpenPage, start_program: Callable[..., Program]
) -> None:
    viewer.view.plots.add("/samples", "at[2]", is_there=False)
    page = open_page(viewer)
    lab = start_program("python", OWN_TYPES, "lie")
    lab.wait_for("ready")
    wait_until(lambda: "/samples" in viewer.view.topics.types(), what="the topic")
    assert "; the description from /lab can't be used: " in page.ask(
        "error", op="plot_fields", topic="/samples"
    )
    lab.signal(signal.SIGINT)
    lab.wait()
    wait_until(lambda: "/samples" not in viewer.view.topics.types(), what="the end of the topic")
    start_program("python", OWN_TYPES).wait_for("ready")
    page.wait_for(lambda: (plot_of(page, "at[2]") or {}).get("shown") == 3.0)
    assert page.ask("plot_fields", op="plot_fields", topic="/samples")["fields"][-1] == "at[0]"


# Of a recording.


@pytest.fixture
def recorded(tmp_path: Path) -> Iterator[Viewer]:
    """A viewer of 100 s of a number that grows, and of its transforms."""
    folder = tmp_path / "recording"
    with closing(BagWriter(folder)) as writer:
        tf = writer.add_topic(Topic("/tf", "tf2_msgs/msg/TFMessage"))
        numbers = writer.add_topic(Topic("/number", "std_msgs/msg/Float64"))
        for second in range(101):
            stamp_ns = START_NS + second * S
            moved = TFMessage(transforms=[transform("map", "base", stamp_ns, (float(second), 0.0, 0.0))])
            writer.push(tf, cdr.encode(moved), stamp_ns, stamp_ns)
            writer.push(numbers, cdr.encode(Float64(data=second * 0.5)), stamp_ns, stamp_ns)
    with recorded_viewer(folder, topics=("/tf", "/tf_static")) as made, running(made):
        yield made


def test_recording_is_plotted_whole_and_the_slider_shows_a_value(
    recorded: Viewer, open_page: OpenPage
) -> None:
    page = open_page(recorded)
    page.send(op="plot", topic="/number", field="data", on=True)
    page.wait_for(lambda: plot_of(page, "data") and len(plot_of(page, "data")["values"]) == 101)
    assert plot_of(page, "data")["values"] == [second * 0.5 for second in range(101)]
    assert plot_of(page, "data")["shown"] == 0.0  # the time stands at the start
    page.send(op="hold", stamp_ns=str(START_NS + 20 * S + S // 2))
    page.wait_for(lambda: plot_of(page, "data")["shown"] == 10.0)
    # A page that comes again adds nothing twice.
    page.socket.close()
    wait_until(lambda: not recorded._is_open, what="the page's end")
    again = open_page(recorded)
    again.wait_for(lambda: plot_of(again, "data"))
    assert len(plot_of(again, "data")["values"]) == 101
    for number, axis in enumerate("xy"):  # the second one needs what was read for the first one already
        again.send(op="plot", topic="/tf", field=f"transforms[0].transform.translation.{axis}", on=True)
        again.wait_for(lambda number=number: len(again.state["plots"]) == 2 + number)
        again.wait_for(lambda: all(len(plot["values"]) == 101 for plot in again.state["plots"]))
    assert again.state["plots"][1]["values"] == [float(second) for second in range(101)]
    assert set(again.state["plots"][2]["values"]) == {0.0}


@pytest.fixture
def record(tmp_path: Path) -> Callable[[range], Path]:
    """Record a number at each time of a range [ns since the start]."""

    def write(times: range) -> Path:
        folder = tmp_path / "recording"
        with closing(BagWriter(folder)) as writer:
            numbers = writer.add_topic(Topic("/number", "std_msgs/msg/Float64"))
            for number, time_ns in enumerate(times):
                stamp_ns = START_NS + time_ns
                writer.push(numbers, cdr.encode(Float64(data=float(number))), stamp_ns, stamp_ns)
        return folder

    return write


@pytest.mark.parametrize("count", [400, 399])  # the last message is within a part, or begins one
@pytest.mark.parametrize("step_ns", [1, 20 * S])  # at each end of a part; or with parts that have none
def test_each_message_of_a_recording_is_read_once(
    record: Callable[[range], Path], count: int, step_ns: int
) -> None:
    with open_bag(record(range(0, count * step_ns, step_ns))) as bag:
        cursor = RecordedTopics(bag).open("/number")
        read = []
        while not read or cursor.is_behind:
            taken = [entry.message().data for entry in cursor.read(limit_s=-1.0)]
            assert len(taken) <= 1
            read += taken
        assert list(cursor.read()) == []
    assert read == [float(number) for number in range(count)]


def test_recording_is_read_in_one_go_if_that_is_quick(record: Callable[[range], Path]) -> None:
    with open_bag(record(range(0, 1000 * S, S))) as bag:
        cursor = RecordedTopics(bag).open("/number")
        assert len(list(cursor.read(limit_s=1000.0))) == 1000
        assert not cursor.is_behind


def test_part_without_messages_is_read_once_for_one_picture(record: Callable[[range], Path]) -> None:
    with open_bag(record(range(0, 3000 * S, 1000 * S))) as bag:
        cursor = RecordedTopics(bag).open("/number")
        reads = 0
        while not reads or cursor.is_behind:
            list(cursor.read(limit_s=-1.0))
            reads += 1
            assert reads < 1000
        assert reads > 100
