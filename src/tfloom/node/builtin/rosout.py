"""Publication of a node's log records on /rosout."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.interfaces.builtin_interfaces import msg as builtin_msg
from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.log import log_output
from tfloom.node.qos.qos import qos_profile_rosout_default
from tfloom.node.values.constants import S_TO_NS
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase

__all__ = ["Rosout"]

TOPIC = "/rosout"


class Rosout:
    """Publishes the records of a node's logger, and of the loggers below it."""

    def __init__(self, node: NodeBase) -> None:
        topic = topic_of(rcl_msg.Log, TOPIC)
        self._writer = node._open(  # noqa: SLF001  # opens endpoints that no executor runs
            self, lambda wire, name: wire.create_writer(name, topic, qos_profile_rosout_default.to_wire())
        )
        self._logger_name = node.get_logger().name
        log_output.add_listener(self._logger_name, self._publish)

    def _publish(self, record: log_output.Record) -> None:
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
        log_output.remove_listener(self._logger_name, self._publish)
        self._writer.close()


def _encodable(text: str) -> str:
    """Return a text with its lone surrogates, for example of undecodable file names, written as escapes."""
    return text if text.isascii() else text.encode("utf-8", "backslashreplace").decode("utf-8")
