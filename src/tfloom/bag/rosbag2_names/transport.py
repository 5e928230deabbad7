"""The options of recorder and player, and the conversion of bags."""

from __future__ import annotations

import os
from collections.abc import Sequence
from datetime import timedelta
from enum import IntEnum
from pathlib import Path
from typing import Any

from tfloom.bag.converting import convert, parse_outputs, read_outputs
from tfloom.bag.errors import BagError
from tfloom.bag.playing import play_options as playing
from tfloom.bag.recording import recorded_topics as recording
from tfloom.bag.rosbag2_names.qos import wire_profile
from tfloom.bag.rosbag2_names.storage import StorageOptions
from tfloom.bag.topic_choice import TopicChoice, full_names, read_static_topics
from tfloom.rmw.typed_names import SERVICE_EVENTS
from tfloom.ros_imports import ros_distro

__all__ = ["MessageOrder", "PlayOptions", "RecordOptions", "ServiceRequestsSource", "bag_rewrite"]


class ServiceRequestsSource(IntEnum):
    """Whose recorded requests are sent."""

    SERVICE_INTROSPECTION = 0
    CLIENT_INTROSPECTION = 1


class MessageOrder(IntEnum):
    """By which of their times messages are played."""

    RECEIVED_TIMESTAMP = 0
    SENT_TIMESTAMP = 1


class RecordOptions:
    """What a `Recorder` records: topics, services, and how."""

    def __init__(self) -> None:
        self.all_topics = False
        self.all_services = False
        self.all_actions = False
        self.is_discovery_disabled = False
        self.topics: list[str] = []
        self.topic_types: list[str] = []
        self.services: list[str] = []
        self.actions: list[str] = []
        self.exclude_topics: list[str] = []
        self.exclude_topic_types: list[str] = []
        self.exclude_service_events: list[str] = []
        self.exclude_actions: list[str] = []
        self.rmw_serialization_format = ""
        self.topic_polling_interval = timedelta(milliseconds=100)
        self.regex = ""
        self.exclude_regex = ""
        self.node_prefix = ""
        self.compression_mode = ""
        self.compression_format = ""
        self.compression_queue_size = 1
        self.compression_threads = 0
        self.compression_threads_priority = 0
        self.topic_qos_profile_overrides: dict[str, Any] = {}
        self.include_hidden_topics = False
        self.include_unpublished_topics = False
        self.ignore_leaf_topics = False
        self.start_paused = False
        self.use_sim_time = False
        self.disable_keyboard_controls = False
        self.static_topics_uri = ""
        self.input_serialization_format = ""
        self.output_serialization_format = ""
        self.repeat_transient_local_messages: dict[str, int] = {}
        self.repeat_all_transient_local_depth = 0
        self.statistics_max_publishing_rate = ros_distro.LOSSES_HZ

    def to_options(self) -> recording.RecordOptions:
        """Return the options of a recorder.

        Raises:
            BagError: the file of static topics can't be used, or a serialization format is not cdr.
        """
        for name in (self.input_serialization_format, self.output_serialization_format):
            if name not in {"", "cdr"}:
                raise BagError("rosbag2_py", f"the serialization format is cdr, not '{name}'")
        choice = TopicChoice(
            topics=full_names(self.topics),
            topic_types=self.topic_types,
            services=_services(self.services),
            actions=full_names(self.actions),
            all_topics=self.all_topics,
            all_services=self.all_services,
            all_actions=self.all_actions,
            regex=self.regex,
            exclude_regex=self.exclude_regex,
            exclude_topics=full_names(self.exclude_topics),
            exclude_topic_types=self.exclude_topic_types,
            exclude_services=_services(self.exclude_service_events),
            exclude_actions=full_names(self.exclude_actions),
        )
        return recording.RecordOptions(
            choice=choice,
            is_discovery_disabled=self.is_discovery_disabled,
            polling_interval_s=max(self.topic_polling_interval.total_seconds(), 0.001),
            include_hidden_topics=self.include_hidden_topics,
            include_unpublished_topics=self.include_unpublished_topics,
            ignore_leaf_topics=self.ignore_leaf_topics,
            qos_overrides={name: wire_profile(qos) for name, qos in self.topic_qos_profile_overrides.items()},
            is_start_paused=self.start_paused,
            use_sim_time=self.use_sim_time,
            has_keyboard=not self.disable_keyboard_controls,
            static_topics=read_static_topics(Path(self.static_topics_uri)) if self.static_topics_uri else {},
            losses_hz=self.statistics_max_publishing_rate,
            repeated={
                name: depth
                for topic, depth in self.repeat_transient_local_messages.items()
                for name in full_names([topic])
            },
            repeats_all=self.repeat_all_transient_local_depth,
        )


class PlayOptions:
    """What is played, and how."""

    def __init__(self) -> None:
        self.read_ahead_queue_size = 1000
        self.node_prefix = ""
        self.rate = 1.0
        self.topics_to_filter: list[str] = []
        self.services_to_filter: list[str] = []
        self.actions_to_filter: list[str] = []
        self.regex_to_filter = ""
        self.exclude_regex_to_filter = ""
        self.exclude_topics_to_filter: list[str] = []
        self.exclude_service_events_to_filter: list[str] = []
        self.exclude_actions_to_filter: list[str] = []
        self.topic_qos_profile_overrides: dict[str, Any] = {}
        self.loop = False
        self.topic_remapping_options: list[str] = []
        self.clock_publish_frequency = 0.0
        self.clock_publish_on_topic_publish = False
        self.clock_topics: list[str] = []
        self.delay = 0.0
        self.playback_duration = -1.0
        self.playback_until_timestamp = -1
        self.start_paused = False
        self.start_offset = 0.0
        self.disable_keyboard_controls = False
        self.wait_acked_timeout = -1
        self.disable_loan_message = False
        self.publish_service_requests = False
        self.service_requests_source = ServiceRequestsSource.SERVICE_INTROSPECTION
        self.send_actions_as_client = False
        self.message_order = MessageOrder.RECEIVED_TIMESTAMP
        self.progress_bar_update_rate = 0
        self.progress_bar_separation_lines = 2

    def to_options(self) -> playing.PlayOptions:
        """Return the options of a player."""
        wanted = (
            self.topics_to_filter,
            self.services_to_filter,
            self.actions_to_filter,
            self.regex_to_filter,
        )
        wants_all = not any(wanted)
        choice = TopicChoice(
            topics=full_names(self.topics_to_filter),
            services=_services(self.services_to_filter),
            actions=full_names(self.actions_to_filter),
            all_topics=wants_all,
            all_services=wants_all,
            regex=self.regex_to_filter,
            exclude_regex=self.exclude_regex_to_filter,
            exclude_topics=full_names(self.exclude_topics_to_filter),
            exclude_services=_services(self.exclude_service_events_to_filter),
            exclude_actions=full_names(self.exclude_actions_to_filter),
        )
        # rosbag2 takes them as arguments of a program: `--ros-args`, `--remap` and the like stand between the remaps.
        remaps = [word for word in self.topic_remapping_options if ":=" in word]
        return playing.PlayOptions(
            choice=choice,
            rate=self.rate,
            is_loop=self.loop,
            remaps=playing.parse_remaps(remaps),
            clock_hz=self.clock_publish_frequency,
            clock_topics=full_names(self.clock_topics),
            is_clock_on_all=self.clock_publish_on_topic_publish and not self.clock_topics,
            delay_s=_seconds(self.delay),
            start_offset_s=_seconds(self.start_offset),
            duration_s=_seconds(self.playback_duration),
            until_ns=self.playback_until_timestamp,
            is_start_paused=self.start_paused,
            wait_acked_ms=self.wait_acked_timeout,
            qos_overrides={name: wire_profile(qos) for name, qos in self.topic_qos_profile_overrides.items()},
            read_ahead=self.read_ahead_queue_size,
            has_keyboard=not self.disable_keyboard_controls,
            publishes_requests=self.publish_service_requests,
            sends_goals=self.send_actions_as_client,
            is_client_source=self.service_requests_source == ServiceRequestsSource.CLIENT_INTROSPECTION,
            is_by_sent_time=self.message_order == MessageOrder.SENT_TIMESTAMP,
            progress_hz=self.progress_bar_update_rate,
            progress_lines=self.progress_bar_separation_lines,
        )


def bag_rewrite(arg0: Sequence[StorageOptions], arg1: str) -> None:
    """Write bags from others.

    Args:
        arg0: The bags that are read.
        arg1: The options of the bags that are written, as the YAML that `ros2 bag convert` takes, or as its path.

    Raises:
        BagError: a bag can't be read or written, or an option can't be used.
    """
    is_path = os.path.isfile(arg1)  # noqa: PTH113 - a Path raises OSError for a text longer than names may be
    outputs = read_outputs(Path(arg1)) if is_path else parse_outputs(arg1, Path("output_options"))
    convert([Path(storage_options.uri) for storage_options in arg0], outputs)


def _services(names: Sequence[str]) -> list[str]:
    """Return services, given by their names or by those of their events."""
    return [name.removesuffix(SERVICE_EVENTS) for name in full_names(names)]


def _seconds(value: Any) -> float:
    """Return a duration [s], which is given as a number or as rclpy's Duration."""
    return float(value.nanoseconds / 1e9) if hasattr(value, "nanoseconds") else float(value)
