"""Publication of a node's log records on /rosout."""

from __future__ import annotations

from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from tfloom.interfaces.builtin_interfaces import msg as builtin_msg
from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.base.node_base import NodeBase, open_endpoint
from tfloom.node.log import log_output
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.node.qos.qos import QoSProfile, qos_profile_rosout_default
from tfloom.node.values.duration import S_TO_NS
from tfloom.node.values.time import check_fits_stamp
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.rmw.base import Writer

__all__ = ["Rosout"]

TOPIC = "/rosout"

_by_context: WeakKeyDictionary[Context, dict[str, list[Rosout]]] = WeakKeyDictionary()
"""What publishes in each context, by the logger's name, the oldest first; changed by single operations."""


class Rosout:
    """Publishes the records of a node's logger, and of the loggers below it.

    Of several nodes of a context with one name, the oldest publishes, because they share the logger.
    """

    def __init__(self, node: NodeBase, qos_profile: QoSProfile = qos_profile_rosout_default) -> None:
        topic = topic_of(rcl_msg.Log, TOPIC)
        # The node destroys it from `open_endpoint` on, even if Ctrl-C ends the rest.
        self._writer: Writer | None = None
        self._twins: list[Rosout] = []
        self._logger_name = node.get_logger().name
        self._writer = open_endpoint(
            node,
            self,
            lambda wire, name: wire.create_writer(name, topic, qos_profile.to_wire()),
        )
        self._twins = _by_context.setdefault(node.context, {}).setdefault(self._logger_name, [])
        if self._twins:
            RcutilsLogger("rcl.logging_rosout").warning(
                f"Publisher already registered for node name: '{node.get_name()}'. If this is due to multiple nodes "
                f"with the same name then all logs for the logger named '{self._logger_name}' will go out over the "
                "existing publisher. As soon as that node is destroyed the next one of that name takes over."
            )
        self._twins.append(self)
        log_output.add_listener(self._logger_name, self._publish)

    def _publish(self, record: log_output.Record) -> None:
        if self._writer is None or self._twins[:1] != [self]:
            return
        check_fits_stamp(record.stamp_ns)
        sec, nanosec = divmod(record.stamp_ns, S_TO_NS)
        message = rcl_msg.Log(
            stamp=builtin_msg.Time(sec=sec, nanosec=nanosec),
            level=int(record.severity),
            name=record.name,
            msg=_encodable(record.message),
            file=record.file,
            function=record.function,
            line=record.line,
        )
        try:
            self._writer.write(cdr.encode(message))
        except ClosedError:  # the context has left the wire; the record still reaches the other listeners
            log_output.remove_listener(self._logger_name, self._publish)

    def destroy(self) -> None:
        """Stop publishing; the node calls this when it is destroyed."""
        if self in self._twins:
            self._twins.remove(self)
        log_output.remove_listener(self._logger_name, self._publish)
        if self._writer is not None:
            self._writer.close()


def _encodable(text: str) -> str:
    """Return a text with its lone surrogates, for example of undecodable file names, written as escapes."""
    return text if text.isascii() else text.encode("utf-8", "backslashreplace").decode("utf-8")
