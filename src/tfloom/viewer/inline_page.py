"""A page in a cell of a notebook, and the thread that serves it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["InlinePage"]

END_S = 10.0
"""The longest wait for the end of a viewer [s]."""


class InlinePage:
    """A page that is served until `close`, or until the program ends; a notebook shows it in a frame.

    Args:
        serve: Called on the page's thread with a function to call with the address, once the page can be opened, and
            one that says whether it is over; it returns when it is, or raises what was wrong.
        height_px: Height of the frame.
    """

    def __init__(
        self, serve: Callable[[Callable[[str], None], Callable[[], bool]], None], height_px: int
    ) -> None:
        self.address = ""
        """What a browser opens; it may be opened by several."""
        self.height_px = height_px
        self._serve = serve
        self._over = threading.Event()
        self._ready = threading.Event()
        self._error: BaseException | None = None
        """Set by the thread before `_ready`."""
        self._thread = threading.Thread(target=self._run, name="tfloom_view", daemon=True)

    def start(self) -> None:
        """Serve the page, and wait until it can be opened; raise what `serve` raises until then.

        Raises:
            RuntimeError: the system has no thread left.
        """
        try:
            self._thread.start()
        except RuntimeError as error:
            self._over.set()
            raise RuntimeError(f"showing a page needs a thread: {error}") from None
        self._ready.wait()
        if self._error is not None:
            self._thread.join(END_S)
            raise self._error

    def _run(self) -> None:
        try:
            self._serve(self._set_address, self._over.is_set)
        except BaseException as error:
            if self._ready.is_set():
                raise  # threading.excepthook reports it, because nobody waits for it
            self._error = error
        finally:
            self._over.set()
            self._ready.set()

    def _set_address(self, address: str) -> None:
        self.address = address
        self._ready.set()

    @property
    def is_open(self) -> bool:
        """Whether the page is served."""
        return not self._over.is_set()

    def close(self) -> None:
        """Stop serving the page, and leave the graph. Calling it again does nothing."""
        self._over.set()
        if self._thread.ident is not None and self._thread is not threading.current_thread():
            self._thread.join(END_S)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<tfloom view at {self.address}>" if self.is_open else "<tfloom view, closed>"

    def _repr_html_(self) -> str:
        """Return what a notebook shows: the page in a frame."""
        if not self.is_open:
            return escape(repr(self))
        address = escape(self.address)
        return (
            f'<iframe src="{address}" title="tfloom view" width="100%" height="{self.height_px}" '
            'style="border:0" allow="gamepad; fullscreen"></iframe>'
            f'<div style="opacity:.7">{address}, while this kernel runs</div>'
        )
