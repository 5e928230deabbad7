"""The classes of types, of which those without a definition here are searched for among the nodes that use them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.rmw.shared.peer_types import TypeSearches
from tfloom.rosidl.class_search import UnknownTypeError, find_class_of_kind
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Service

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["KnownTypes"]

BASES: dict[str, type[Any]] = {"msg": Message, "srv": Service}


class KnownTypes:
    """Finds the classes of types. Used on the node's thread alone.

    Args:
        node: Asks other nodes, and logs once of each type that it can't be found.
    """

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._searches = TypeSearches(*node._wire())  # for tfloom's own nodes
        self._unknown: dict[str, str] = {}
        """By type, why it has no class here; kept, because the nearest names of an unknown one take long to find."""
        self._warned: set[str] = set()

    def find(self, type_name: str, kind: str, without_it: str) -> type[Any] | None:
        """Return the class of a type; None while it is searched for, or if it is not found.

        Args:
            type_name: `package/kind/Name`.
            kind: msg or srv.
            without_it: What is not done without this type, as the beginning of a sentence.
        """
        if type_name not in self._unknown:
            try:
                return find_class_of_kind(type_name, kind, BASES[kind])
            except UnknownTypeError as error:
                self._unknown[type_name] = str(error)
            except (LookupError, ValueError, OSError) as error:
                self._unknown[type_name] = str(error)
                self._warn(type_name, without_it, [])
                return None
        if (reasons := self._searches.reasons(type_name, kind)) is not None:
            self._warn(type_name, without_it, reasons)
        return None

    def _warn(self, type_name: str, without_it: str, reasons: list[str]) -> None:
        if type_name not in self._warned:
            self._warned.add(type_name)
            said = f"{without_it}, because the type {type_name} has no definition here: source its workspace before"
            self._logger.warning("; ".join([said, *reasons]))

    def poll(self) -> bool:
        """Search on; return whether a search has ended. Never waits."""
        ended = self._searches.poll()
        for type_name in ended:
            self._unknown.pop(type_name, None)
        return bool(ended)

    def close(self) -> None:
        """Leave the nodes that are asked."""
        self._searches.close()
