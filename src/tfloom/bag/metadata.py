"""metadata.yaml of a recording, of versions 1 to 9."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, NamedTuple

from tfloom.bag.errors import BagError
from tfloom.bag.reading.file_bytes import check_is_file
from tfloom.bag.values import Topic

__all__ = [
    "METADATA_FILE",
    "FileInformation",
    "Metadata",
    "is_message_compression",
    "parse_metadata",
    "read_metadata",
]

METADATA_FILE = "metadata.yaml"
ROOT = "rosbag2_bagfile_information"
_MESSAGE_MODE = re.compile(r"^compression_mode: *[\"']?message\b", re.IGNORECASE | re.MULTILINE)


class FileInformation(NamedTuple):
    """A file of a recording, as metadata.yaml describes it."""

    path: str
    """Its path below the folder."""
    start_ns: int
    """Its least log time [ns since epoch]."""
    duration_ns: int
    """From its least log time to its greatest [ns]."""
    message_count: int
    """Number of its messages."""


class Metadata(NamedTuple):
    """The content of metadata.yaml."""

    version: int
    """Version of its format, 1 to 9."""
    storage_identifier: str
    """`mcap` or `sqlite3`."""
    duration_ns: int
    """From the least log time to the greatest [ns]."""
    start_ns: int
    """The least log time [ns since epoch]."""
    message_count: int
    """Number of messages."""
    topics: list[Topic]
    """The topics, with their numbers of messages."""
    compression_format: str
    """`zstd`; empty if files and messages are not compressed as a whole."""
    compression_mode: str
    """`FILE` or `MESSAGE`, in any case; empty without compression."""
    relative_file_paths: list[str]
    """The files, in the order of recording."""
    files: list[FileInformation]
    """Empty before version 5, and after reindexing."""
    custom_data: dict[str, str]
    """What the recorder was given by `--custom-data`."""
    ros_distro: str
    """Name of the recorder's ROS distribution; empty if the file does not have it."""


def read_metadata(folder: Path) -> Metadata:
    """Return the metadata of a folder.

    Raises:
        BagError: it has none, or the file isn't as it must be.
        OSError: it can't be read.
    """
    path = folder / METADATA_FILE
    try:
        check_is_file(path)
        text = path.read_text("utf-8")
    except FileNotFoundError:
        raise BagError(
            folder,
            f"the folder has no {METADATA_FILE}: `ros2 bag reindex {folder}` writes one from its files",
        ) from None
    except UnicodeDecodeError:
        raise BagError(path, "this isn't UTF-8 text") from None
    return parse_metadata(text, path)


def parse_metadata(text: str, path: Path) -> Metadata:
    """Return the metadata in a YAML text.

    Args:
        text: The content of metadata.yaml, or the `serialized_metadata` of a file of a recording.
        path: Its file, for errors.

    Raises:
        BagError: it isn't as it must be.
    """
    from tfloom.common import yaml as user_yaml

    try:
        document = user_yaml.load(text)
    except user_yaml.YamlError as error:
        raise BagError(path, str(error)) from None
    if isinstance(document, dict):
        document = document.get(ROOT, document)
    try:
        return _metadata(document)
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as error:
        what = f"{error.args[0]!r} is missing" if isinstance(error, KeyError) else str(error)
        raise BagError(
            path, f"this is not metadata of a recording: {what}; `ros2 bag reindex` writes it anew"
        ) from None


def is_message_compression(text: str) -> bool:
    """Return whether the `serialized_metadata` of a file says that each message is compressed by itself.

    It is searched, not parsed, because YAML's parser takes longer to import than a file takes to open.
    """
    return _MESSAGE_MODE.search(text) is not None


def _metadata(document: dict[str, Any]) -> Metadata:
    return Metadata(
        version=int(document["version"]),
        storage_identifier=str(document["storage_identifier"]),
        duration_ns=int(document["duration"]["nanoseconds"]),
        start_ns=int(document["starting_time"]["nanoseconds_since_epoch"]),
        message_count=int(document["message_count"]),
        topics=[_topic(entry) for entry in document["topics_with_message_count"] or []],
        compression_format=str(document.get("compression_format") or ""),
        compression_mode=str(document.get("compression_mode") or ""),
        relative_file_paths=[str(path) for path in document["relative_file_paths"] or []],
        files=[_file(entry) for entry in document.get("files") or []],
        custom_data={str(key): str(value) for key, value in (document.get("custom_data") or {}).items()},
        ros_distro=str(document.get("ros_distro") or ""),
    )


def _topic(entry: dict[str, Any]) -> Topic:
    about = entry["topic_metadata"]
    return Topic(
        name=str(about["name"]),
        type=str(about["type"]),
        serialization_format=str(about["serialization_format"]),
        type_hash=str(about.get("type_description_hash") or ""),
        offered_qos=_qos_text(about.get("offered_qos_profiles")),
        message_count=int(entry["message_count"]),
    )


def _qos_text(profiles: Any) -> str:
    """Return profiles as storages have them; metadata has a list from version 9 on, and a text of YAML before."""
    if not profiles:
        return ""
    if isinstance(profiles, str):
        return profiles
    import yaml

    text: str = yaml.safe_dump(profiles, sort_keys=False, default_flow_style=False)
    return text.rstrip("\n")


def _file(entry: dict[str, Any]) -> FileInformation:
    return FileInformation(
        path=str(entry["path"]),
        start_ns=int(entry["starting_time"]["nanoseconds_since_epoch"]),
        duration_ns=int(entry["duration"]["nanoseconds"]),
        message_count=int(entry["message_count"]),
    )
