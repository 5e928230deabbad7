"""`tfloom.view()`: the page in a cell of a notebook."""

from __future__ import annotations

import re
import socket
import sys
import threading
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.bag.written_bags import START_NS, topic
from tests.conftest import run_to_end, wait_until
from tests.viewer.conftest import Page

import tfloom
from tfloom.bag.errors import BagError
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.viewer import extra, inline
from tfloom.viewer.inline_page import InlinePage
from tfloom.viewer.page_server import ServerError


@pytest.fixture
def bag(tmp_path: Path) -> Path:
    path = tmp_path / "bag"
    writer = BagWriter(path, WriterSettings())
    channel = writer.add_topic(topic("/tf_static", "tf2_msgs/msg/TFMessage"))
    transform = TransformStamped(header=Header(frame_id="map"), child_frame_id="lidar")
    writer.push(channel, cdr.encode(TFMessage(transforms=[transform])), START_NS, START_NS)
    writer.close()
    return path


@pytest.fixture(autouse=True)
def _no_page_is_left() -> Iterator[None]:
    yield
    inline._close_all()
    assert not any(thread.name.startswith("tfloom_view") for thread in threading.enumerate())


@contextmanager
def opened(page: InlinePage) -> Iterator[Page]:
    """Open the page's socket, as a browser does."""
    from websockets.sync.client import connect

    address = page.address.replace("http://", "ws://") + "api"
    with connect(address, max_size=None, proxy=None, ping_interval=None) as connection:
        made = Page(connection)
        made.wait_for(lambda: made.state)
        yield made


def test_page_of_a_recording_is_shown_in_a_frame(bag: Path) -> None:
    page = tfloom.view(bag, height_px=300)
    assert repr(page) == f"<tfloom view at {page.address}>"
    shown = page._repr_html_()
    assert f'<iframe src="{page.address}"' in shown
    assert 'height="300"' in shown
    with opened(page) as tab:
        tab.wait_for(lambda: tab.row("lidar"))
    page.close()
    page.close()
    assert page._repr_html_() == "&lt;tfloom view, closed&gt;"


@pytest.mark.wire
def test_page_of_the_live_graph(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    from tfloom.rmw.backends import open_participant
    from tfloom.rmw.base import NodeName

    monkeypatch.setenv("ROS_DOMAIN_ID", str(domain_id))
    with tfloom.view(displays=["scan"]) as page, opened(page):
        other = open_participant(domain_id)
        try:
            node = NodeName("/", "watching")
            other.add_node(node)
            wait_until(lambda: any("_tfloom_view_" in name.name for name in other.graph.nodes()))
        finally:
            other.close()
    assert not page.is_open


def test_cell_that_runs_again_shows_the_same_page(bag: Path) -> None:
    first = tfloom.view(bag)
    assert tfloom.view(str(bag), height_px=99) is first
    assert 'height="99"' in first._repr_html_()
    other = tfloom.view(bag, fixed_frame="lidar")
    assert other is not first
    first.close()
    again = tfloom.view(bag)
    assert again is not first
    assert again.is_open
    assert first not in inline._pages.values()


def test_only_notebooks_of_this_machine_may_embed_the_page(bag: Path) -> None:
    page = tfloom.view(bag)
    for path in ("", "scene/"):
        with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(page.address + path) as answer:
            policy = answer.headers["Content-Security-Policy"]
        (embedders,) = re.findall(r"frame-ancestors ([^;]*)", policy)
        assert embedders.split()[:2] == ["'self'", "http://localhost:*"]
        assert not {"*", "http:", "https:"} & set(embedders.split())


def test_viser_says_nothing_into_the_cell(
    bag: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """In a notebook rich, by which viser prints its address, takes another way than standard output."""
    import rich.console

    shown: list[object] = []
    monkeypatch.setattr("rich.jupyter.display", lambda *args: shown.append(args))
    monkeypatch.setattr("rich._console", rich.console.Console(force_jupyter=True))
    rich.get_console().print("as viser does")
    assert len(shown) == 1
    with tfloom.view(bag) as page:
        assert page.is_open
    assert len(shown) == 1
    assert "viser" not in "".join(capfd.readouterr())
    assert not rich.get_console().quiet


def test_errors_are_raised_in_the_cell(bag: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(BagError, match="nowhere"):
        tfloom.view(tmp_path / "nowhere")
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        with pytest.raises(ServerError, match=r"can't listen at 127\.0\.0\.1"):
            tfloom.view(bag, port=other.getsockname()[1])
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"history_s": 0.0}, "history_s has to be above 0"),
        ({"history_s": float("nan")}, "history_s has to be above 0"),
        ({"port": 65536}, "port has to be from 0 to 65535, not 65536"),
        ({"height_px": 0}, "height_px has to be from 1"),
    ]
    for arguments, text in wrong:
        with pytest.raises(ValueError, match=text):
            tfloom.view(bag, **arguments)
    with pytest.raises(TypeError, match="list of topics, not the text '/scan'"):
        tfloom.view(bag, displays="/scan")
    assert not [page for page in inline._pages.values() if page.is_open]
    monkeypatch.setattr(extra, "find_spec", lambda _: None)
    with pytest.raises(ImportError) as missing:
        tfloom.view(bag)
    assert str(missing.value) == (
        "tfloom.view() needs viser, which is not installed: pip install 'tfloom[view]'"
    )


def test_viewer_that_fails_later_closes_its_page(monkeypatch: pytest.MonkeyPatch) -> None:
    reports: list[Any] = []
    monkeypatch.setattr(threading, "excepthook", reports.append)
    go_on = threading.Event()

    def serve(set_address: Callable[[str], None], _: Callable[[], bool]) -> None:
        set_address("http://127.0.0.1:1/")
        assert go_on.wait(30)
        raise LookupError("planted")

    page = InlinePage(serve, 600)
    page.start()
    assert page.is_open
    go_on.set()
    wait_until(lambda: not page.is_open and reports)
    assert str(reports[0].exc_value) == "planted"
    page.close()


def test_page_that_nobody_closes_ends_quietly_with_the_program(bag: Path) -> None:
    program = f"import tfloom; print(tfloom.view({str(bag)!r}).is_open)"
    done = run_to_end([sys.executable, "-c", program])
    assert (done.returncode, done.stdout, done.stderr) == (0, "True\n", "")


CELLS = {
    "buffer": (
        "import tfloom, numpy as np\n"
        "from tfloom.tf2.buffer import Buffer\n"
        "buffer = Buffer(None)\n"
        "for i in range(20): buffer.set('map', 'lidar', 10**9 * (1 + i), (i / 10, 0, 0), (0, 0, 0, 1))\n"
        "buffer"
    ),
    "explanation": "buffer.explain('map', 'lidar', 10**12)",
    "trajectory": "buffer.trajectory('map', 'lidar')",
    "scan": (
        "from sensor_msgs.msg import LaserScan\n"
        "LaserScan(ranges=[1.0, 2.0, 3.0], range_max=9.0, angle_increment=0.1)"
    ),
    "canvas": "from tfloom.turtlesim.canvas import Canvas\nCanvas()",
    "print": "print(buffer)",
    "view": "page = tfloom.view(BAG)\npage",
    "fetch": (
        "import urllib.request\n"
        "open_it = urllib.request.build_opener(urllib.request.ProxyHandler({})).open\n"
        "print(open_it(page.address).status)"
    ),
    "without close": "tfloom.view(BAG, fixed_frame='map').is_open",
}
"""Cells of a notebook, the last of which leaves a page open, as people do."""


@pytest.mark.slow
def test_cells_run_in_jupyters_kernel(bag: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nbformat = pytest.importorskip("nbformat", reason="`make setup` installs it")
    client = pytest.importorskip("nbclient", reason="`make setup` installs it")
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    notebook = nbformat.v4.new_notebook()
    notebook.cells = [
        nbformat.v4.new_code_cell(code.replace("BAG", repr(str(bag)))) for code in CELLS.values()
    ]
    client.NotebookClient(notebook, timeout=120).execute()
    outputs = {name: cell.outputs[-1] for name, cell in zip(CELLS, notebook.cells, strict=True)}
    for name, cell in zip(CELLS, notebook.cells, strict=True):
        assert len(cell.outputs) <= 1, (name, cell.outputs)  # viser prints nothing into a cell, either
    html = {name: output.get("data", {}).get("text/html", "") for name, output in outputs.items()}
    assert ">lidar</code>" in html["buffer"]
    assert outputs["buffer"]["data"]["text/plain"].startswith("<Buffer: 2 frames, 20 transforms, from 1.000")
    assert "here" in html["explanation"]
    assert "<polyline" in html["trajectory"]
    assert "<path" in html["scan"]
    assert "image/png" in outputs["canvas"]["data"]
    assert outputs["print"]["text"].startswith("Buffer: 2 frames, 20 transforms")
    assert '<iframe src="http://127.0.0.1:' in html["view"]
    assert outputs["fetch"]["text"] == "200\n"
    assert outputs["without close"]["data"]["text/plain"] == "True"


def test_page_without_a_thread_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    page = InlinePage(lambda *_: None, 100)
    with monkeypatch.context() as patched:
        patched.setattr(threading.Thread, "start", refuse)
        with pytest.raises(RuntimeError, match="showing a page needs a thread: can't start new thread"):
            page.start()
    assert not page.is_open
    assert page._repr_html_() == "&lt;tfloom view, closed&gt;"
    page.close()
