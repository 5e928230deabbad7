"""The page in a cell of a notebook: `tfloom.view()`."""

from __future__ import annotations

import atexit
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.tf2_tools.watch.model import TOPICS
from tfloom.viewer.extra import MISSING, is_installed
from tfloom.viewer.inline_page import InlinePage

if TYPE_CHECKING:
    from tfloom.viewer.program import Viewer

__all__ = ["open_page"]

EMBEDDERS = (
    "http://localhost:* https://localhost:* http://127.0.0.1:* https://127.0.0.1:* "
    "vscode-webview: vscode-file: https://*.vscode-cdn.net"
)
"""Whose pages may show ours in a frame: servers of notebooks on this machine, and the editor VS Code."""

_Key = tuple[str, str, str, tuple[str, ...], float, int]
_lock = threading.Lock()
_pages: dict[_Key, InlinePage] = {}
"""The open pages by what they show, so that a cell that runs again shows the same; guarded by `_lock`."""


def open_page(
    bag: str | os.PathLike[str] | None = None,
    *,
    fixed_frame: str = "",
    displays: Sequence[str] = (),
    history_s: float = 60.0,
    port: int = 0,
    height_px: int = 600,
) -> InlinePage:
    """Return a page that is served, with the arguments and errors of `tfloom.view`."""
    if not is_installed():
        raise ImportError(MISSING.format(name="tfloom.view()"))
    if isinstance(displays, str):
        raise TypeError(f"displays has to be a list of topics, not the text {displays!r}")
    if not 0.0 < history_s < float("inf"):
        raise ValueError(f"history_s has to be above 0 and finite, not {history_s!r}")
    if not 0 <= port <= 65535:
        raise ValueError(f"port has to be from 0 to 65535, not {port!r}")
    if not 0 < height_px <= 100_000:
        raise ValueError(f"height_px has to be from 1 to 100000, not {height_px!r}")
    path = None if bag is None else Path(bag).absolute()
    topics = tuple(topic if topic.startswith("/") else f"/{topic}" for topic in displays)
    # The graph that a new page would join: another domain is another page.
    graph = f"{os.environ.get('RMW_IMPLEMENTATION', '')} {os.environ.get('ROS_DOMAIN_ID', '')}"
    key = "" if path is None else str(path), graph, fixed_frame, topics, history_s, port
    with _lock:
        page = _pages.get(key)
        if page is None or not page.is_open:
            for other in [other for other, kept in _pages.items() if not kept.is_open]:
                del _pages[other]
            page = _pages[key] = _started(path, fixed_frame, topics, history_s, port, height_px)
            # Functions at exit run in reverse order, and viser's, which prints, would run before an earlier one.
            atexit.unregister(_close_all)
            atexit.register(_close_all)
        page.height_px = height_px
        return page


def _started(
    path: Path | None, fixed_frame: str, topics: Sequence[str], history_s: float, port: int, height_px: int
) -> InlinePage:
    def serve(set_address: Callable[[str], None], is_over: Callable[[], bool]) -> None:
        with _opened(path, fixed_frame, history_s) as viewer:
            viewer.pages.start("127.0.0.1", port, embedders=EMBEDDERS)
            for topic in topics:
                viewer.view.want(topic)
            set_address(viewer.pages.address)
            viewer.run(is_over)

    page = InlinePage(serve, height_px)
    page.start()
    return page


@contextmanager
def _opened(path: Path | None, fixed_frame: str, history_s: float) -> Iterator[Viewer]:
    if path is not None:
        from tfloom.viewer.recorded import recorded_viewer

        with recorded_viewer(path, topics=TOPICS, fixed_frame=fixed_frame) as viewer:
            yield viewer
        return
    from tfloom.rmw.backends import open_participant
    from tfloom.viewer.live import live_viewer

    with (
        closing(open_participant()) as participant,
        live_viewer(participant, topics=TOPICS, history_s=history_s, fixed_frame=fixed_frame) as viewer,
    ):
        yield viewer


def _close_all() -> None:
    for page in list(_pages.values()):
        page.close()
