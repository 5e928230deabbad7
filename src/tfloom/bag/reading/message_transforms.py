"""The transforms of messages that are read one by one, stored in a buffer."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping

from tfloom._native import TfRecords
from tfloom.bag.values import EARLIEST, LATEST, Progress, RawMessage, TfTopic

__all__ = ["insert_messages"]


def insert_messages(
    messages: Callable[[Collection[str], int, int], Iterable[RawMessage]],
    into: TfRecords,
    topics: Mapping[str, TfTopic],
    times: tuple[int, int],
    progress: Progress,
) -> None:
    """Store the transforms of topics by name; moving ones if their log times are in `times`.

    Args:
        messages: Returns the messages of topics between two log times.
        into: Where they are stored.
        topics: The topics.
        times: The least and the greatest log time of moving transforms [ns since epoch].
        progress: Called with the size of each message.
    """
    for is_static, (start, end) in ((False, times), (True, (EARLIEST, LATEST))):
        names = [name for name, topic in topics.items() if topic.is_static == is_static]
        for message in messages(names, start, end) if names else ():
            into.insert(topics[message.topic].number, message.data)
            progress(len(message.data))
