"""Options of bags that are written from others."""

from __future__ import annotations

from pathlib import Path

import pytest

from tfloom.bag import BagError
from tfloom.bag.converting import parse_outputs


@pytest.mark.parametrize(
    ("option", "reason"),
    [
        ("regex: '('", "missing \\)"),
        ("exclude: '['", "unterminated character set"),
        ("max_bagfile_size: .inf", "cannot convert float infinity"),
        ("storage_id: db", "storage_id is one of mcap, sqlite3"),
        ("colour: red", "unknown option colour"),
    ],
)
def test_option_that_cannot_be_used_is_named(option: str, reason: str) -> None:
    path = Path("outputs.yaml")
    with pytest.raises(BagError, match=rf"{path}: an output can't be used: .*{reason}"):
        parse_outputs(f"output_bags: [{{uri: a, {option}}}]", path)
