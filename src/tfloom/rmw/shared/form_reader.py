"""A reader of a type whose definition differs by distribution: each sample is read by its publisher's definition."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, cast

from tfloom.rosidl.other_forms import Form, converted, forms_beside

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant, Reader, Sample, Topic
    from tfloom.rmw.qos import QoS

__all__ = ["create_reader"]

MAX_PUBLISHERS = 1000
"""How many publishers' hashes are remembered, for samples that are taken after their publisher has left."""


def create_reader(
    participant: Participant, node: NodeName, topic: Topic, qos: QoS, warn: Callable[[str], object]
) -> Reader:
    """Open a reader of a topic. What it takes has the form of the type's definition here.

    Args:
        participant: Where it is opened.
        node: Its node.
        topic: Its topic.
        qos: Its quality of service.
        warn: Called once, with a text, if a publisher doesn't say which form its samples have.
    """
    forms = forms_beside(topic.type_name, topic.type_hash)
    if forms is None:
        return participant.create_reader(node, topic, qos)
    topic = topic._replace(other_hash=forms[1].type_hash)
    return cast("Reader", _FormReader(participant.create_reader(node, topic, qos), topic, forms, warn))


class _FormReader:
    """A wire's reader, but that samples of the other form are converted when they are taken.

    One thread takes at a time. What bypasses `take`, as a sink does, gets the samples as they are.
    """

    def __init__(
        self, reader: Reader, topic: Topic, forms: tuple[Form, Form], warn: Callable[[str], object]
    ) -> None:
        self._reader = reader
        self._topic = topic
        self._own, self._other = forms
        self._warn = warn
        self._is_warned = False
        self._hashes: dict[bytes, str] = {}
        """What publishers have said, by their gids."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._reader, name)

    def take_decoded(self, _message_class: type) -> Sample | None:
        """As `take`: the data are bytes."""
        return self.take()

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample, or None."""
        sample = self._reader.take()
        if sample is None:
            return None
        type_hash = self._hash_of(sample.publisher_gid)
        if type_hash == self._own.type_hash:
            return sample
        if type_hash != self._other.type_hash:
            self._tell(type_hash)
            return sample
        try:
            return sample._replace(data=converted(self._topic.type_name, self._other, sample.data))
        except ValueError:  # it is damaged, which whoever reads it tells
            return sample

    def _hash_of(self, gid: bytes) -> str:
        type_hash = self._hashes.get(gid)
        if type_hash is None:
            type_hash = self._reader.publisher_hash(gid)
            if type_hash:
                if len(self._hashes) >= MAX_PUBLISHERS:
                    self._hashes.clear()
                self._hashes[gid] = type_hash
        return type_hash

    def _tell(self, type_hash: str) -> None:
        if self._is_warned:
            return
        self._is_warned = True
        says = "doesn't say which it has" if not type_hash else "has a third one"
        self._warn(
            f"{self._topic.type_name} has two definitions, and a publisher of {self._topic.name} {says}: it is read "
            f"{self._own}, and not {self._other}"
        )
