"""Extensions of `Node` that installed packages add."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from pathlib import Path

import pytest

from tfloom.launch.ros.actions import node_extensions

MODULE = """
from launch_ros.actions.node import NodeActionExtension


class Traced(NodeActionExtension):
    def prepare_for_execute(self, context, ros_specific_arguments, node_action):
        return ["--trace"], ros_specific_arguments


class TooNew(NodeActionExtension):
    EXTENSION_POINT_VERSION = "0.2"
"""
ENTRY_POINTS = """
[launch_ros.node_action]
traced = my_node_extensions:Traced
too_new = my_node_extensions:TooNew
gone = my_node_extensions:Gone
"""


@pytest.fixture(autouse=True)
def _looked_up_anew() -> Iterator[None]:
    node_extensions._entry_points.cache_clear()
    yield
    node_extensions._entry_points.cache_clear()


def test_extensions_are_those_of_installed_packages_and_others_are_logged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "my_node_extensions.py").write_text(MODULE)
    metadata = tmp_path / "my_node_extensions-1.0.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: my-node-extensions\nVersion: 1.0\n")
    (metadata / "entry_points.txt").write_text(ENTRY_POINTS)
    monkeypatch.syspath_prepend(tmp_path)
    (traced,) = node_extensions.get_extensions(logging.getLogger("test")).values()
    assert (traced.NAME, traced.prepare_for_execute(None, {}, None)) == ("traced", (["--trace"], {}))
    assert "'gone'" in caplog.text
    assert "'too_new'" in caplog.text


def test_without_any_nothing_is_imported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.metadata.entry_points", None)
    assert node_extensions.get_extensions(logging.getLogger("test")) == {}
