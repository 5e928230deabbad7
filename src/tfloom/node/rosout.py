"""A node's log records on /rosout."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.interfaces.builtin_interfaces import msg as builtin_msg
from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node import log_output
from tfloom.node.constants import S_TO_NS
from tfloom.node.qos import qos_profile_rosout_default
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["Rosout"]

TOPIC = "/rosout"


class Rosout:
    """Publishes what a logger, and those below it, write."""

    def __init__(self, participant: Participant, node: NodeName, logger_name: str) -> None:
        topic = topic_of(rcl_msg.Log, TOPIC)
        self._writer = participant.create_writer(node, topic, qos_profile_rosout_default.to_wire())
        self._logger_name = logger_name
        log_output.add_listener(logger_name, self._publish)

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
        except ClosedError:  # its context has left the wire; whoever logs by this name now is not to blame
            log_output.remove_listener(self._logger_name, self._publish)

    def close(self) -> None:
        """Publish no more."""
        log_output.remove_listener(self._logger_name, self._publish)
        self._writer.close()


def _encodable(text: str) -> str:
    """Return a text with its lone surrogates, of undecodable file names say, written as escapes."""
    return text if text.isascii() else text.encode("utf-8", "backslashreplace").decode("utf-8")
