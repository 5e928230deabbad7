"""Types without a definition here, which a form waits for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from tfloom.viewer.forms.task import Task

if TYPE_CHECKING:
    from tfloom.rmw.shared.peer_types import TypeSearch

__all__ = ["Learning"]


class Learning(Task):
    """A type that is searched for among the nodes that use it.

    Args:
        search: The search.
        tell: Called when it is over, with the reasons why the descriptions of nodes can't be used.
    """

    def __init__(self, search: TypeSearch, tell: Callable[[list[str]], None]) -> None:
        self._search = search
        self._tell = tell

    def step(self) -> bool:
        """Search on; return whether the search is over."""
        if not self._search.step():
            return False
        self._tell(self._search.reasons)
        return True

    def close(self) -> None:
        """Leave the node that is asked."""
        self._search.close()
