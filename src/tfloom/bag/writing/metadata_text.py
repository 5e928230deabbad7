"""The text of metadata.yaml, as rosbag2 writes it."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tfloom.bag.metadata import FileInformation, Metadata
from tfloom.bag.values import Topic

__all__ = [
    "METADATA_VERSION",
    "NO_TIME_NS",
    "metadata_file_text",
    "metadata_text",
    "scalar",
]

METADATA_VERSION = 9
NO_TIME_NS = 0x7FFF_FFFF_FFFF_FFFF
"""The start of a bag without messages [ns]."""
_PLAIN = re.compile(r"[A-Za-z/][A-Za-z0-9_/.]*")
"""What YAML takes for a string, if it is none of `_WORDS`: its numbers and dates begin otherwise."""
_WORDS = {"null", "true", "false", "yes", "no", "on", "off"}
"""What YAML 1.1 takes for null or a boolean, in lower case."""


def metadata_file_text(info: Metadata) -> str:
    """Return the content of metadata.yaml, which has no line break at its end."""
    return "rosbag2_bagfile_information:\n" + _indented(metadata_text(info), 2)


def metadata_text(info: Metadata) -> str:
    """Return the metadata as YAML, without the first key of metadata.yaml; there is no line break at its end."""
    lines = [
        f"version: {info.version}",
        f"storage_identifier: {scalar(info.storage_identifier)}",
        "duration:",
        f"  nanoseconds: {info.duration_ns}",
        "starting_time:",
        f"  nanoseconds_since_epoch: {info.start_ns}",
        f"message_count: {info.message_count}",
        "topics_with_message_count:",
        *([_topic(topic) for topic in info.topics] or ["  []"]),
        f"compression_format: {scalar(info.compression_format)}",
        f"compression_mode: {scalar(info.compression_mode)}",
        "relative_file_paths:",
        *([f"  - {scalar(path)}" for path in info.relative_file_paths] or ["  []"]),
        "files:",
        *([_file(file) for file in info.files] or ["  []"]),
        *_custom_data(info.custom_data),
        f"ros_distro: {scalar(info.ros_distro)}",
    ]
    return "\n".join(lines)


def _topic(topic: Topic) -> str:
    profiles = topic.offered_qos.strip() or "[]"
    return "\n".join(
        (
            "  - topic_metadata:",
            f"      name: {scalar(topic.name)}",
            f"      type: {scalar(topic.type)}",
            f"      serialization_format: {scalar(topic.serialization_format)}",
            "      offered_qos_profiles:",
            _indented(profiles, 8),
            f"      type_description_hash: {scalar(topic.type_hash)}",
            f"    message_count: {topic.message_count}",
        )
    )


def _file(file: FileInformation) -> str:
    return "\n".join(
        (
            f"  - path: {scalar(file.path)}",
            "    starting_time:",
            f"      nanoseconds_since_epoch: {file.start_ns}",
            "    duration:",
            f"      nanoseconds: {file.duration_ns}",
            f"    message_count: {file.message_count}",
        )
    )


def _custom_data(values: Mapping[str, str]) -> list[str]:
    if not values:
        return ["custom_data: ~"]
    return ["custom_data:", *(f"  {scalar(key)}: {scalar(value)}" for key, value in values.items())]


def scalar(value: str) -> str:
    """Return a string as a YAML scalar, in quotes only where they are needed."""
    if not value:
        return '""'
    # Topics, types, hashes and names of files are such, and YAML's parser would take longer than all else: each file
    # of a split recording gets the names of all files before it.
    if _PLAIN.fullmatch(value) and value.lower() not in _WORDS:
        return value
    from tfloom.common import yaml as user_yaml

    try:
        is_plain = "\n" not in value and user_yaml.load(value) == value
    except user_yaml.YamlError:
        is_plain = False
    if is_plain and ": " not in value and " #" not in value and value == value.strip():
        return value
    import json

    return json.dumps(value, ensure_ascii=False)


def _indented(text: str, width: int) -> str:
    return "\n".join(" " * width + line if line else line for line in text.split("\n"))
