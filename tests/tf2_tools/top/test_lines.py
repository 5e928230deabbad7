"""The table: rows of a recording, the screen that was looked at, and what keys do."""

from __future__ import annotations

import io
import math
import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text
from tests.tf2_tools.kept_pictures import WRITES
from tests.tf2_tools.recordings import MS, START_NS, recorded, transform

from tfloom._native import TfObserver
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.top.lines import Line, Summary, follow_lines, screen, table
from tfloom.tf2_tools.top.rows import Health, Rates, Row, rows_of
from tfloom.tf2_tools.top.view import View
from tfloom.tf2_tools.watch.model import observation_of
from tfloom.tf2_tools.watch.recorded import RecordedMessage, observe_recorded

REFERENCE = Path(__file__).parent / "screen.txt"
SCREENSHOT = Path(__file__).parents[3] / "docs" / "pictures" / "tf_top.svg"
SUMMARY = Summary(9, 2, 123.4, "domain 7")


def messages() -> list[RecordedMessage]:
    """Return ten seconds of a robot with faults."""
    found = [
        recorded(
            START_NS,
            transform("base", "laser", START_NS),
            transform("base", "激光", START_NS),
            topic="/tf_static",
        )
    ]
    for i in range(200):
        now_ns = START_NS + i * 50 * MS
        moving = [
            transform("map", "odom", now_ns - 700 * MS),
            transform("odom", "base", now_ns - 2 * MS, (math.sin(i / 50), 0.0, 0.0), i / 100),
        ]
        if i < 100:
            moving.append(transform("base", "arm", now_ns))
        if i == 199:
            moving.append(transform("base", "\x1b[2Jbad", 0, (math.nan, 0.0, 0.0)))
        found.append(recorded(now_ns, *moving))
    return found


@pytest.fixture(scope="module")
def buffer() -> Buffer:
    buffer = Buffer()
    buffer.set_log_callback(lambda _, __: None)
    return buffer


@pytest.fixture(scope="module")
def rows(buffer: Buffer) -> list[Row]:
    seen = observe_recorded(messages(), "robot.mcap", buffer=buffer)
    rates = Rates()
    rates.add(seen)
    return rows_of(seen, seen.taken_ns, rates)


def texts(lines: list[Line]) -> list[str]:
    return [line.text for line in lines]


def test_rows_have_the_figures_of_the_recording(rows: list[Row]) -> None:
    by_child = {row.child: row for row in rows}
    assert by_child["odom"][3:6] == pytest.approx((20.0, 0.7, 0.7), rel=0.01)
    assert by_child["base"][3:6] == pytest.approx((20.0, 0.002, 0.002), rel=0.01)
    assert {child: row.health.name for child, row in by_child.items()} == {
        "map": "ROOT",
        "odom": "LATE",
        "base": "OK",
        "arm": "STALE",
        "laser": "STATIC",
        "激光": "STATIC",
        "\x1b[2Jbad": "BAD",
    }
    assert by_child["\x1b[2Jbad"].note == "1 with NaN, stamp 0, late"


def test_the_screen_is_the_one_that_was_looked_at(rows: list[Row], buffer: Buffer) -> None:
    pair = "map", "laser"
    panel = follow_lines(buffer, pair, START_NS + 9950 * MS)
    lines = screen(rows, SUMMARY, View(pair=pair), panel, (100, 16))
    assert len(lines) == 16
    assert {cell_len(line.text) for line in lines} == {100}
    text = "".join(f"{line.style:12}|{line.text.rstrip()}\n" for line in lines)
    if WRITES:
        REFERENCE.write_text(text, "utf-8")
    assert text == REFERENCE.read_text("utf-8")


NODES = {"odom": "/localization", "base": "/wheels", "arm": "/arm_driver", "\x1b[2Jbad": "/gripper_driver"}
NAMES = {"\x1b[2Jbad": "gripper", "激光": "camera"}


def test_the_screenshot_of_the_docs_has_these_lines(rows: list[Row], buffer: Buffer) -> None:
    panel = follow_lines(buffer, ("map", "laser"), START_NS + 9950 * MS)
    view = View(pair=("map", "laser"))
    named = [
        row._replace(
            child=NAMES.get(row.child, row.child),
            publisher=NODES.get(row.child, "/robot_state_publisher") if row.parent else "",
        )
        for row in rows
    ]
    view.selected = 2
    lines = screen(named, SUMMARY, view, panel, (96, 14))
    if WRITES:
        console = Console(record=True, width=96, file=io.StringIO(), color_system="truecolor")
        for line in lines:
            console.print(Text(line.text, line.style or ""), no_wrap=True)
        svg = console.export_svg(title="tfloom tf top", unique_id="top")
        SCREENSHOT.write_text(re.sub(r"@font-face \{.*?\}\n", "", svg, flags=re.DOTALL), "utf-8")
    words = "".join(ET.parse(SCREENSHOT).getroot().itertext()).replace("\xa0", " ")
    assert [line.text for line in lines if line.text.strip() not in words] == []
    assert "url(http" not in SCREENSHOT.read_text("utf-8").replace('"', "")


@pytest.mark.parametrize("size", [(1, 1), (20, 4), (79, 24), (300, 80)])
def test_the_screen_fits_any_terminal(rows: list[Row], size: tuple[int, int]) -> None:
    lines = screen(rows, SUMMARY, View(pair=("a", "b")), ["a from b", "", ""], size)
    assert len(lines) == size[1]
    assert {cell_len(line.text) for line in lines} == {size[0]}


def test_a_table_for_a_file_has_all_columns_and_no_control_characters(rows: list[Row]) -> None:
    lines = table(rows, SUMMARY, View())
    assert len(lines) == 2 + len(rows)
    assert "\x1b" not in "".join(lines)
    assert "domain 7: 9 frames, 6 edges, 2 publishers  123 transforms/s  3 faulty" in lines[0]
    assert any(line.startswith("    └ \\x1b[2Jbad") or "\\x1b[2Jbad" in line for line in lines)


def test_a_silent_graph_is_no_graph_without_faults() -> None:
    assert "no transforms yet" in table([], SUMMARY, View())[0]


def test_orders_and_the_filter(rows: list[Row]) -> None:
    def first(sort: str, words: str = "", *, is_reversed: bool = False) -> str:
        view = View(sort, words)
        view.is_reversed = is_reversed
        return view.arrange(rows)[0].child

    assert [first(sort) for sort in ("tree", "name", "rate", "health")] == [
        "map",
        "\x1b[2Jbad",
        "odom",
        "\x1b[2Jbad",
    ]
    assert first("name", is_reversed=True) == "激光"
    assert first("tree", "stale") == "arm"
    assert View("tree", "no such").arrange(rows) == []
    flat = table(rows, SUMMARY, View("rate"))
    assert any("arm (base)" in line for line in flat)


def test_keys_change_what_is_shown(rows: list[Row]) -> None:
    view = View()
    view.arrange(rows)
    for key in ["down", "j", "end", "up"]:
        view.press(key)
    assert view.selected == len(rows) - 2
    for key in ["home", "s", "r", "p"]:
        view.press(key)
    assert (view.selected, view.sort, view.is_reversed, view.is_paused) == (0, "name", True, True)
    for key in ["/", "l", "x", "backspace", "a", "s", "q", "backspace"]:
        view.press(key)
    assert view.prompt == "filter: las▏"
    view.press("enter")
    assert (view.words, view.prompt, view.is_over) == ("las", "", False)
    view.arrange(rows)
    view.press("f")
    assert view.prompt == "follow TARGET SOURCE: base laser▏"
    for key in ["clear", "m", "enter"]:
        view.press(key)
    assert view.prompt == "follow TARGET SOURCE: m▏"
    for key in [" ", "b", "enter"]:
        view.press(key)
    assert view.pair == ("m", "b")
    view.press("escape")
    assert (view.words, view.pair) == ("", None)
    view.press("q")
    assert view.is_over


def test_the_selected_row_is_always_on_the_screen(rows: list[Row]) -> None:
    many = [rows[1]._replace(child=f"f{i}") for i in range(100)]
    view = View()
    for key in ["page down"] * 12 + ["up"] * 3 + ["end", "page up", "home"]:
        view.arrange(many)
        assert view.selected in view.window(10)
        assert len(view.window(10)) == 10
        view.press(key)


def test_rates_are_those_of_the_last_second() -> None:
    rates = Rates()
    for second, count in [(0.0, 10), (1.0, 60), (2.0, 70)]:
        stamps = [transform("map", "odom", START_NS + i * MS) for i in range(count)]
        seen = observe_recorded([recorded(START_NS, *stamps)], "test")
        rates.add(seen, second)
    (edge,) = seen.edges
    assert rates.of(edge) == pytest.approx(10.0)
    assert rates.total() == pytest.approx(10.0)


def test_ages_and_delays_are_by_the_clock_of_the_stamps() -> None:
    observer = TfObserver()
    for i in range(30):
        stamp_ns, received_ns = (5_000 + i * 100) * MS, START_NS + i * 700 * MS
        observer.set_simulated_time(stamp_ns + 200 * MS)
        _, _, data = recorded(received_ns, transform("map", "odom", stamp_ns))
        assert observer.record(data, bytes(16), received_ns)
    seen = observation_of(observer.snapshot(), {}, (START_NS, START_NS + 29 * 700 * MS))
    (_, row) = rows_of(seen, 5_000 * MS + 3_100 * MS, Rates())
    assert (row.age_s, row.delay_s, row.health) == (pytest.approx(0.2), pytest.approx(0.2), Health.OK)


def test_two_parents_and_a_loop_are_named() -> None:
    found = [
        recorded(
            START_NS + i * MS, transform("ab"[i % 2], "c", START_NS + i * MS), transform("c", "a", START_NS)
        )
        for i in range(3)
    ]
    seen = observe_recorded(found, "test")
    notes = {(row.parent, row.child): row.note for row in rows_of(seen, START_NS, Rates())}
    assert notes["b", "c"] == "in a loop, parent b, re-parented 2 times"
    assert notes["a", "c"] == "in a loop, re-parented 2 times"
    assert {row.health for row in rows_of(seen, START_NS, Rates())} == {Health.BAD}


def test_each_publisher_of_a_frame_has_a_row_that_names_the_others() -> None:
    messages = [
        recorded(START_NS, transform("map", "laser", START_NS), topic="/tf_static"),
        recorded(START_NS, transform("map", "laser", START_NS)),
    ]
    rows = rows_of(observe_recorded(messages, "test"), START_NS, Rates())
    assert [(row.child, row.health.name, row.note) for row in rows] == [
        ("map", "ROOT", ""),
        ("laser", "BAD", "2 publishers"),
        ("laser", "BAD", "2 publishers"),
    ]


def test_a_followed_pair_that_is_not_connected_says_why(buffer: Buffer) -> None:
    lines = follow_lines(buffer, ("map", "nowhere\x1b"), START_NS)
    assert lines[0] == "map from nowhere\\x1b"
    assert "nowhere\\x1b" in lines[1]
    assert len(lines) == 3
