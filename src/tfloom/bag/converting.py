"""Bags written anew from others: joined, filtered, in another storage, split, compressed."""

from __future__ import annotations

import heapq
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any, NamedTuple

from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.opening import open_bag
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.values import RawMessage, Topic
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.bag.writing.storage import STORAGES
from tfloom.bag.writing.storage_config import storage_settings
from tfloom.node.log.logging import get_logger

__all__ = ["Output", "convert", "read_inputs", "read_outputs"]

_UNUSED = {
    *("rmw_serialization_format", "input_serialization_format", "output_serialization_format", "node_prefix"),
    *(
        "is_discovery_disabled",
        "topic_polling_interval",
        "include_hidden_topics",
        "include_unpublished_topics",
    ),
    *("ignore_leaf_topics", "start_paused", "use_sim_time", "compression_queue_size", "compression_threads"),
    *("compression_threads_priority", "topic_qos_profile_overrides", "disable_keyboard_controls"),
    "snapshot_mode",
}
"""Options of a recording that are accepted and have no effect on a conversion."""
_OF_WRITING = {
    *("storage_preset_profile", "storage_config_uri", "max_bagfile_size", "max_bagfile_duration"),
    *("max_cache_size", "max_cache_duration", "max_bag_files", "snapshot_mode", "custom_data"),
}
"""Options of a storage that have no effect on a bag that is read."""


class Output(NamedTuple):
    """A bag that a conversion writes, and what of the input it gets."""

    folder: Path
    settings: WriterSettings
    choice: TopicChoice
    start_ns: int | None
    end_ns: int | None


def convert(inputs: Sequence[Path], outputs: Sequence[Output]) -> None:
    """Write bags from the messages of others, in the order of log times.

    Raises:
        BagError: a bag can't be read or written.
    """
    with ExitStack() as stack:
        bags = [stack.enter_context(open_bag(path)) for path in inputs]
        for output in outputs:
            _write(bags, output)


def _write(bags: Sequence[Bag], output: Output) -> None:
    topics: dict[str, Topic] = {}
    for bag in bags:
        for topic in bag.topics.values():
            if output.choice.wants(topic.name, topic.type):
                topics.setdefault(topic.name, topic)
    writer = BagWriter(output.folder, output.settings)
    if output.settings.storage_id == "sqlite3":
        get_logger("rosbag2_storage").info(f"Opened database '{writer.file_path}' for READ_WRITE.")
    try:
        numbers = {topic.name: writer.add_topic(topic) for topic in topics.values()}
        for message in _messages(bags, topics, output):
            writer.push(numbers[message.topic], message.data, message.log_time_ns, message.publish_time_ns)
    finally:
        writer.close()


def _messages(bags: Sequence[Bag], topics: Mapping[str, Topic], output: Output) -> Iterator[RawMessage]:
    parts = [
        bag.messages([name for name in topics if name in bag.topics], output.start_ns, output.end_ns)
        for bag in bags
    ]
    return heapq.merge(*parts, key=lambda message: message.log_time_ns)


def read_inputs(path: Path) -> list[Path]:
    """Return the paths of the bags that a YAML file describes: a list under the key `input_bags`.

    Raises:
        BagError: the file can't be read, or an option is unknown or has no valid value.
    """
    bags = _bags(_text(path), path, "input_bags", "Input")
    try:
        return [_input(values) for values in bags]
    except (ValueError, TypeError, AttributeError) as error:
        raise BagError(path, f"an input can't be used: {error}") from None


def read_outputs(path: Path) -> list[Output]:
    """Return the outputs that a YAML file describes: a list under the key `output_bags`.

    Raises:
        BagError: the file can't be read, or an option is unknown or has no valid value.
    """
    return parse_outputs(_text(path), path)


def _text(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except OSError as error:
        raise BagError(path, f"it can't be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise BagError(path, "this isn't UTF-8 text") from None


def parse_outputs(text: str, path: Path) -> list[Output]:
    """Return the outputs that a YAML text describes; `path` is for errors.

    Raises:
        BagError: an option is unknown or has no valid value.
    """
    bags = _bags(text, path, "output_bags", "Output")
    try:
        return [_output(values) for values in bags]
    except (ValueError, TypeError, OverflowError, AttributeError, re.error) as error:
        raise BagError(path, f"an output can't be used: {error}") from None


def _bags(text: str, path: Path, key: str, side: str) -> list[Any]:
    """Return the list under the key of a YAML text."""
    from tfloom.common import yaml as user_yaml

    try:
        document = user_yaml.load(text)
    except user_yaml.YamlError as error:
        raise BagError(path, str(error)) from None
    if not isinstance(document, dict) or not isinstance(document.get(key), list):
        raise BagError(path, f'{side} options must have the key "{key}", with a list of bags')
    return list(document[key])


def _input(values: Mapping[str, Any]) -> Path:
    """Return the path of an input bag, whose storage is found by itself."""
    if "uri" not in values:
        raise ValueError("it has no uri")
    if unknown := values.keys() - {"uri", "storage_id"} - _OF_WRITING:
        raise ValueError(f"no option of an input is {', '.join(sorted(unknown))}")
    storage_id = str(values.get("storage_id") or "")
    if storage_id not in {"", *STORAGES}:
        raise ValueError(f"storage_id is one of {', '.join(STORAGES)}, not {storage_id}")
    return Path(str(values["uri"]))


def _output(values: Mapping[str, Any]) -> Output:
    if "uri" not in values:
        raise ValueError("it has no uri")
    if unknown := values.keys() - _KEYS - _UNUSED:
        raise ValueError(f"unknown option {', '.join(sorted(unknown))}")
    storage_id = str(values.get("storage_id") or "mcap")
    if storage_id not in STORAGES:
        raise ValueError(f"storage_id is one of {', '.join(STORAGES)}, not {storage_id}")
    mode = str(values.get("compression_mode") or "").upper()
    if mode not in {"", "NONE", "FILE", "MESSAGE"}:
        raise ValueError(f"compression_mode is none, file or message, not {values['compression_mode']}")
    settings = WriterSettings(
        storage_id=storage_id,
        storage=storage_settings(
            storage_id,
            str(values.get("storage_preset_profile") or ""),
            str(values.get("storage_config_uri") or ""),
        ),
        max_file_size=int(values.get("max_bagfile_size") or 0),
        max_file_duration_ns=int(values.get("max_bagfile_duration") or 0) * 1_000_000_000,
        cache_size=int(values.get("max_cache_size") or 0),
        compression_mode="" if mode == "NONE" else mode,
        custom_data={str(key): str(value) for key, value in (values.get("custom_data") or {}).items()},
    )
    return Output(
        Path(str(values["uri"])),
        settings,
        _choice(values),
        _time(values.get("start_time_ns")),
        _time(values.get("end_time_ns")),
    )


def _time(value: Any) -> int | None:
    return None if value is None or int(value) < 0 else int(value)


def _choice(values: Mapping[str, Any]) -> TopicChoice:
    """Return which topics an output has; without any that is named, all.

    Raises:
        re.error: an expression is invalid.
    """

    def names(key: str) -> list[str]:
        return [str(item) for item in values.get(key) or []]

    topics, types, services = names("topics"), names("topic_types"), names("services")
    regex = str(values.get("regex") or "")
    excluded = str(values.get("exclude_regex") or values.get("exclude") or "")
    for expression in (regex, excluded):
        re.compile(expression)
    wants_all = bool(values.get("all")) or not (
        topics or types or services or regex or values.get("all_topics") or values.get("all_services")
    )
    return TopicChoice(
        topics=topics,
        topic_types=types,
        services=services,
        all_topics=wants_all or bool(values.get("all_topics")),
        all_services=wants_all or bool(values.get("all_services")),
        regex=regex,
        exclude_regex=excluded,
        exclude_topics=names("exclude_topics"),
        exclude_topic_types=names("exclude_topic_types"),
        exclude_services=names("exclude_services"),
    )


_KEYS = {
    *("uri", "storage_id", "max_bagfile_size", "max_bagfile_duration", "max_cache_size", "custom_data"),
    *("storage_preset_profile", "storage_config_uri", "start_time_ns", "end_time_ns", "compression_mode"),
    *(
        "compression_format",
        "all",
        "all_topics",
        "all_services",
        "topics",
        "topic_types",
        "services",
        "regex",
    ),
    *("exclude", "exclude_regex", "exclude_topics", "exclude_topic_types", "exclude_services"),
}
