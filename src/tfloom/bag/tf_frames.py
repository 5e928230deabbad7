"""A buffer with the transforms of a recording."""

from __future__ import annotations

import os
from collections.abc import Collection
from contextlib import nullcontext

from tfloom._native import TfRecords
from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.opening import open_bag
from tfloom.bag.progress import progress_line
from tfloom.bag.values import TfTopic, Topic, bounded
from tfloom.tf2.buffer import Buffer

__all__ = ["frames", "insert_frames"]

TF_TYPES = {"tf2_msgs/msg/TFMessage", "tf2_msgs/TFMessage", "tf/tfMessage", "tf/msg/tfMessage"}


def frames(
    bag: str | os.PathLike[str] | Bag,
    *,
    namespace: str = "",
    tf_topics: Collection[str] | None = None,
    static_topics: Collection[str] | None = None,
    start_ns: int | None = None,
    end_ns: int | None = None,
    progress: bool | None = None,
) -> Buffer:
    """Return a buffer with all transforms of a recording, whose history has no limit.

    Only what has transforms is read, by the file's index where it has one.

    Args:
        bag: The path of a recording, as `open_bag` takes it, or an open one.
        namespace: The namespace of the topics tf and tf_static: `/robot1` for `/robot1/tf`.
        tf_topics: The topics of moving transforms; None: `tf` in the namespace.
        static_topics: The topics of static transforms; None: `tf_static` in the namespace.
        start_ns: The least log time of a message with moving transforms [ns since epoch]; None: no bound.
        end_ns: The greatest one [ns since epoch]; None: no bound.
        progress: Whether to show a line of progress on standard error; None: if that is a terminal, after a second.

    Raises:
        BagError: there is no such recording, it is damaged, or it has no transforms; the text names its topics with
            transforms.
    """
    buffer = Buffer(None)
    with nullcontext(bag) if isinstance(bag, Bag) else open_bag(bag) as opened:
        insert_frames(
            buffer,
            opened,
            namespace=namespace,
            tf_topics=tf_topics,
            static_topics=static_topics,
            start_ns=start_ns,
            end_ns=end_ns,
            progress=progress,
        )
    return buffer


def insert_frames(
    buffer: Buffer,
    bag: Bag,
    *,
    namespace: str = "",
    tf_topics: Collection[str] | None = None,
    static_topics: Collection[str] | None = None,
    start_ns: int | None = None,
    end_ns: int | None = None,
    progress: bool | None = None,
) -> int:
    """Store the transforms of a recording in a buffer, as `frames` does; return the number of messages.

    Raises:
        BagError: as `frames`.
    """
    prefix = "/" + namespace.strip("/") if namespace.strip("/") else ""
    moving = _topics(bag, tf_topics, f"{prefix}/tf")
    static = _topics(bag, static_topics, f"{prefix}/tf_static")
    if not moving and not static:
        raise BagError(bag.path, _no_topics_text(bag, prefix))
    records = TfRecords(buffer)
    numbers = {
        topic.name: TfTopic(
            records.add_topic(topic.name, is_static, topic.serialization_format == "ros1"), is_static
        )
        for topics, is_static in ((moving, False), (static, True))
        for topic in topics
    }
    start, end = bounded(start_ns, end_ns)
    with progress_line(f"Reading the transforms of {bag.path}", bag.size, progress) as advance:
        for file in bag.files:
            file.insert_transforms(records, numbers, start, end, advance)
    return records.message_count


def _topics(bag: Bag, names: Collection[str] | None, default: str) -> list[Topic]:
    if names is None:
        topics = [topic for topic in bag.topics.values() if topic.name.lstrip("/") == default[1:]]
    else:
        topics = [bag.topic(name) for name in names]
    for topic in topics:
        if topic.type not in TF_TYPES:
            raise BagError(bag.path, f"the topic {topic.name} has the type {topic.type}, not TFMessage")
    return topics


def _no_topics_text(bag: Bag, prefix: str) -> str:
    others = [topic.name for topic in bag.topics.values() if topic.type in TF_TYPES]
    text = f"there are no topics {prefix}/tf and {prefix}/tf_static"
    if not others:
        return f"{text}, and no others with transforms"
    return f"{text}; transforms are on {', '.join(others)}: give `tf_topics`, `static_topics` or `namespace`"
