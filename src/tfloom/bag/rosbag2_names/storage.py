"""The values of rosbag2_py: what a bag is, and how one is opened."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from pathlib import Path

from tfloom.bag.metadata import METADATA_FILE, Metadata, parse_metadata, read_metadata
from tfloom.bag.metadata import FileInformation as File
from tfloom.bag.qos_profiles import parse_profiles, profiles_text
from tfloom.bag.rosbag2_names.qos import QoS, wire_profile
from tfloom.bag.values import Definition, Topic
from tfloom.bag.writing.definition_text import find_definition, find_service_definition, hash_of
from tfloom.bag.writing.metadata_text import METADATA_VERSION, metadata_file_text, metadata_text
from tfloom.common.files import write_file
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import ClockType, Time
from tfloom.rosidl.class_search import full_name

__all__ = [
    "BagMetadata",
    "ConverterOptions",
    "FileInformation",
    "LocalMessageDefinitionSource",
    "MessageDefinition",
    "MetadataIo",
    "ReadOrder",
    "ReadOrderSortBy",
    "StorageFilter",
    "StorageOptions",
    "TopicInformation",
    "TopicMetadata",
    "get_default_storage_id",
]


def _no_time() -> Time:
    return Time(nanoseconds=0, clock_type=ClockType.SYSTEM_TIME)


def _stamp(stamp_ns: int) -> Time:
    return Time(nanoseconds=stamp_ns, clock_type=ClockType.SYSTEM_TIME)


@dataclass
class StorageOptions:
    """Where a bag is, and how it is written."""

    uri: str
    storage_id: str = ""
    max_bagfile_size: int = 0
    max_bagfile_duration: int = 0
    max_cache_size: int = 0
    storage_preset_profile: str = ""
    storage_config_uri: str = ""
    snapshot_mode: bool = False
    start_time_ns: int = -1
    end_time_ns: int = -1
    custom_data: dict[str, str] = field(default_factory=dict)
    max_bag_files: int = 0
    max_cache_duration: int = 0


@dataclass
class ConverterOptions:
    """Serialization formats; `cdr`, or empty for the same."""

    input_serialization_format: str = ""
    output_serialization_format: str = ""


def options_error(call: str, storage: object, converter: object) -> TypeError | None:
    """Return the error of what `call` got in place of its options, or None if it got both."""
    if isinstance(storage, StorageOptions) and isinstance(converter, ConverterOptions):
        return None
    needs = "StorageOptions(uri='…', storage_id='mcap') and ConverterOptions('cdr', 'cdr')"
    given = f"{type(storage).__name__} and {type(converter).__name__}"
    return TypeError(f"{call}() needs {needs}, got {given}")


@dataclass
class StorageFilter:
    """Which topics are read; all, unless topics, events of services, actions or an expression are given."""

    topics: list[str] = field(default_factory=list)
    services_events: list[str] = field(default_factory=list)
    regex: str = ""
    exclude_topics: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    regex_to_exclude: str = ""
    actions: list[str] = field(default_factory=list)
    exclude_actions: list[str] = field(default_factory=list)


class ReadOrderSortBy(IntEnum):
    """By what messages are ordered."""

    ReceivedTimestamp = 0
    PublishedTimestamp = 1
    File = 2


@dataclass
class ReadOrder:
    """The order in which messages are read."""

    sort_by: ReadOrderSortBy = ReadOrderSortBy.ReceivedTimestamp
    reverse: bool = False


class TopicMetadata:
    """A topic of a bag."""

    def __init__(
        self,
        id: int,  # noqa: A002 - ROS's name
        name: str,
        type: str,  # noqa: A002 - ROS's name
        serialization_format: str,
        offered_qos_profiles: Sequence[QoS] = (),
        type_description_hash: str = "",
    ) -> None:
        self.id = id
        self.name = name
        self.type = type
        self.serialization_format = serialization_format
        self.offered_qos_profiles = list(offered_qos_profiles)
        self.type_description_hash = type_description_hash

    def equals(self, arg0: TopicMetadata) -> bool:
        """Return whether name, type and format are equal, and the profiles."""
        return self.to_topic() == arg0.to_topic()

    def __eq__(self, other: object) -> bool:
        return self.equals(other) if isinstance(other, TopicMetadata) else NotImplemented

    __hash__ = None  # type: ignore[assignment]  # it can be changed

    def to_topic(self) -> Topic:
        """Return the topic, with the definition of its type where that is known here."""
        profiles = [wire_profile(profile) for profile in self.offered_qos_profiles]
        return Topic(
            self.name,
            self.type,
            self.serialization_format,
            self.type_description_hash or hash_of(self.type),
            profiles_text(profiles) if profiles else "",
            find_definition(self.type),
        )

    @classmethod
    def from_topic(cls, topic: Topic, number: int = 0) -> TopicMetadata:
        """Return a topic of a bag."""
        profiles = [QoS.from_wire(profile) for profile in parse_profiles(topic.offered_qos)]
        return cls(number, topic.name, topic.type, topic.serialization_format, profiles, topic.type_hash)


@dataclass
class TopicInformation:
    """A topic, and the number of its messages."""

    topic_metadata: TopicMetadata
    message_count: int


@dataclass
class FileInformation:
    """A file of a bag."""

    path: str
    starting_time: Time
    duration: Duration
    message_count: int


@dataclass
class MessageDefinition:
    """The definition of a type."""

    topic_type: str
    encoding: str
    encoded_message_definition: str
    type_hash: str

    @classmethod
    def of_topic(cls, topic: Topic) -> MessageDefinition:
        """Return the definition of a topic's type; its encoding is `unknown` if the bag has none."""
        encoding, text = topic.definition or Definition("unknown", "")
        return cls(topic.type, encoding, text, topic.type_hash)


@dataclass
class BagMetadata:
    """What metadata.yaml says of a bag."""

    version: int = METADATA_VERSION
    bag_size: int = 0
    storage_identifier: str = ""
    relative_file_paths: list[str] = field(default_factory=list)
    files: list[FileInformation] = field(default_factory=list)
    duration: Duration = field(default_factory=lambda: Duration(nanoseconds=0))
    starting_time: Time = field(default_factory=_no_time)
    message_count: int = 0
    topics_with_message_count: list[TopicInformation] = field(default_factory=list)
    compression_format: str = ""
    compression_mode: str = ""
    custom_data: Mapping[str, str] = field(default_factory=dict)
    ros_distro: str = ""

    @classmethod
    def from_metadata(cls, values: Metadata, bag_size: int = 0) -> BagMetadata:
        """Return what a metadata.yaml says."""
        return cls(
            version=values.version,
            bag_size=bag_size,
            storage_identifier=values.storage_identifier,
            relative_file_paths=list(values.relative_file_paths),
            files=[_file_information(file) for file in values.files],
            duration=Duration(nanoseconds=values.duration_ns),
            starting_time=_stamp(values.start_ns),
            message_count=values.message_count,
            topics_with_message_count=[
                TopicInformation(TopicMetadata.from_topic(topic, number), topic.message_count)
                for number, topic in enumerate(values.topics, 1)
            ],
            compression_format=values.compression_format,
            compression_mode=values.compression_mode,
            custom_data=dict(values.custom_data),
            ros_distro=values.ros_distro,
        )

    def to_metadata(self) -> Metadata:
        """Return the values of a metadata.yaml."""
        return Metadata(
            version=self.version,
            storage_identifier=self.storage_identifier,
            duration_ns=self.duration.nanoseconds,
            start_ns=self.starting_time.nanoseconds,
            message_count=self.message_count,
            topics=[_counted_topic(topic) for topic in self.topics_with_message_count],
            compression_format=self.compression_format,
            compression_mode=self.compression_mode,
            relative_file_paths=list(self.relative_file_paths),
            files=[
                File(file.path, file.starting_time.nanoseconds, file.duration.nanoseconds, file.message_count)
                for file in self.files
            ],
            custom_data=dict(self.custom_data),
            ros_distro=self.ros_distro,
        )


def _file_information(file: File) -> FileInformation:
    return FileInformation(
        file.path, _stamp(file.start_ns), Duration(nanoseconds=file.duration_ns), file.message_count
    )


def _counted_topic(information: TopicInformation) -> Topic:
    metadata = information.topic_metadata
    topic = metadata.to_topic()
    return topic._replace(type_hash=metadata.type_description_hash, message_count=information.message_count)


class MetadataIo:
    """Reads and writes metadata.yaml."""

    def write_metadata(self, arg0: str, arg1: BagMetadata) -> None:
        """Write metadata.yaml into a folder.

        Raises:
            OSError: it can't be written.
        """
        write_file(Path(arg0) / METADATA_FILE, metadata_file_text(arg1.to_metadata()))

    def read_metadata(self, arg0: str) -> BagMetadata:
        """Return what a folder's metadata.yaml says.

        Raises:
            BagError: there is none, or it isn't as it must be.
        """
        return BagMetadata.from_metadata(read_metadata(Path(arg0)))

    def metadata_file_exists(self, arg0: str) -> bool:
        """Return whether a folder has a metadata.yaml."""
        return (Path(arg0) / METADATA_FILE).exists()

    def serialize_metadata(self, arg0: BagMetadata) -> str:
        """Return metadata as YAML, as a file of a bag has it."""
        return metadata_text(arg0.to_metadata())

    def deserialize_metadata(self, arg0: str) -> BagMetadata:
        """Return the metadata in a YAML text.

        Raises:
            BagError: it isn't as it must be.
        """
        return BagMetadata.from_metadata(parse_metadata(arg0, Path(METADATA_FILE)))


class LocalMessageDefinitionSource:
    """The definitions that are known here."""

    def get_full_text(self, arg0: str) -> MessageDefinition:
        """Return the definition of a type; its encoding is `unknown` if the type is.

        Args:
            arg0: `package/msg/Name`, or `package/Name` for short, or a service's `package/srv/Name`.
        """
        name = full_name(arg0, "msg")
        definition = find_definition(name) or find_service_definition(name)
        return MessageDefinition.of_topic(Topic(arg0, arg0, "cdr", hash_of(name), "", definition))


def get_default_storage_id() -> str:
    """Return the storage of a bag that is written without another."""
    return "mcap"
