"""Parsing of a buffer's list of frames, and its graph."""

from __future__ import annotations

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from tests.recorded_outputs import recorded_output

from tfloom.tf2_tools.tree_pictures.records import FrameRecord, parse_frames_yaml, write_gv
from tfloom.tf2_tools.view_frames import generate_dot

CAMERA_YAML = (
    "camera: \n  parent: 'world'\n  broadcaster: 'default_authority'\n  rate: 10000.000\n"
    "  most_recent_transform: 0.000000\n  oldest_transform: 0.000000\n  buffer_length: 0.000\n"
)
CAMERA = FrameRecord("camera", "world", "default_authority", 10000.0, 0.0, 0.0, 0.0)


def test_text_of_the_reference_is_parsed() -> None:
    assert parse_frames_yaml(CAMERA_YAML) == [CAMERA]
    assert CAMERA.is_static


@pytest.mark.parametrize("text", ["", "[]", "[]\n"])
def test_empty_text_has_no_frames(text: str) -> None:
    assert parse_frames_yaml(text) == []


@pytest.mark.parametrize("text", ["nonsense", CAMERA_YAML + "tail", CAMERA_YAML.replace("10000.000", "fast")])
def test_other_text_raises(text: str) -> None:
    with pytest.raises(ValueError):
        parse_frames_yaml(text)


FRAME_IDS = st.text(st.characters(exclude_characters="\n'", exclude_categories=["Cs"]), min_size=1)


@given(st.lists(st.tuples(FRAME_IDS, FRAME_IDS), min_size=1))
def test_any_frame_id_is_parsed(names: list[tuple[str, str]]) -> None:
    rest = CAMERA_YAML.partition("'world'")[2]
    text = "".join(f"{child}: \n  parent: '{parent}'{rest}" for child, parent in names)
    assert [(record.child, record.parent) for record in parse_frames_yaml(text)] == names


def test_graph_equals_that_of_the_reference() -> None:
    golden = recorded_output("view_frames_out").removesuffix("\n")
    assert write_gv([CAMERA], 1795257550.7853734) == golden


def test_graph_without_frames_has_a_note() -> None:
    assert write_gv([], 1.0) == 'digraph G { "No tf data received" }'


def test_quotes_in_frame_ids_are_escaped() -> None:
    text = write_gv([CAMERA._replace(child='a"b\\')], 1.0)
    assert '"world" -> "a\\"b\\\\"[' in text


def test_a_cycle_has_a_legend_too() -> None:
    text = write_gv([CAMERA, CAMERA._replace(child="world", parent="camera")], 1.0)
    assert '}->"camera";' in text


def test_the_graph_of_what_a_yaml_parser_read_is_the_same() -> None:
    assert generate_dot(yaml.safe_load(CAMERA_YAML), (12, 500_000_000)) == write_gv([CAMERA], 12.5)
    assert generate_dot({}, (0, 0)) == 'digraph G { "No tf data received" }'
