"""What tests do with the types that they define: a later test in the same process doesn't know them."""

from __future__ import annotations

import pytest
from tests.conftest import forgetting_types

from tfloom.rosidl import sources
from tfloom.rosidl.class_search import find_known_class
from tfloom.rosidl.dynamic import define
from tfloom.rosidl.recorded import recorded_class

PART, WEIGH, NOTE = "leaky_msgs/msg/Part", "leaky_msgs/srv/Weigh", "leaky_msgs/msg/Note"


def test_types_of_a_block_are_forgotten_and_those_before_it_come_back() -> None:
    part = define(PART, "string name")
    weigh = define(WEIGH, "Part part\n---\nfloat32 grams")
    with forgetting_types():
        recorded_class(NOTE, "ros2msg", "string text")
        assert define(PART, "uint8 count") is find_known_class(PART) is not part
        sources.replace(WEIGH, None)
    assert find_known_class(NOTE) is sources.find_source(NOTE) is None
    assert find_known_class(PART) is part
    assert find_known_class(WEIGH) is weigh
    assert find_known_class(f"{WEIGH}_Request") is weigh.Request
    source = sources.find_source(PART)
    assert source is not None
    assert source.text == "string name"


def test_every_test_is_such_a_block(request: pytest.FixtureRequest) -> None:
    assert "_defined_types" in request.fixturenames
