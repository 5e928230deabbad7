"""The functions of `ros2topic.api`: topics on the graph, their classes, and the flags for a QoS."""

from __future__ import annotations

import argparse
import copy
import time
from typing import Any

from tfloom.cli.api.answers import argument_key, positive_float, positive_int
from tfloom.cli.api.nodes import GraphNode, NodeStrategy
from tfloom.cli.shared.names import full_name
from tfloom.node.qos.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    QoSReliabilityPolicy,
)
from tfloom.node.values.duration import Duration
from tfloom.node.values.names import topic_or_service_is_hidden
from tfloom.rmw.qos import POLICIES
from tfloom.rosidl.runtime import get_message
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.workspace.interfaces import known_interfaces

__all__ = [
    "TopicMessagePrototypeCompleter",
    "TopicNameCompleter",
    "TopicTypeCompleter",
    "add_qos_arguments",
    "get_msg_class",
    "get_topic_names",
    "get_topic_names_and_types",
    "message_type_completer",
    "positive_float",
    "positive_int",
    "profile_configure_short_keys",
    "qos_profile_from_short_keys",
]

NamesAndTypes = list[tuple[str, list[str]]]

_POLL_S = 0.1
"""Time between two looks for a topic that isn't on the graph yet [s]."""


def get_topic_names_and_types(*, node: GraphNode, include_hidden_topics: bool = False) -> NamesAndTypes:
    """Return the topics on the graph, with their types."""
    topics: NamesAndTypes = node.get_topic_names_and_types()
    return [
        (name, types)
        for name, types in topics
        if include_hidden_topics or not topic_or_service_is_hidden(name)
    ]


def get_topic_names(*, node: GraphNode, include_hidden_topics: bool = False) -> list[str]:
    """Return the names of the topics on the graph."""
    topics = get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)
    return [name for name, _ in topics]


def get_msg_class(
    node: GraphNode, topic: str, blocking: bool = False, include_hidden_topics: bool = False
) -> Any:
    """Return the class of the messages of a topic.

    Args:
        node: Asks the graph.
        topic: Name of the topic; a relative one is in the node's namespace.
        blocking: Whether to wait until the topic is on the graph.
        include_hidden_topics: Whether hidden topics are found, too.

    Returns:
        None if the topic isn't on the graph.

    Raises:
        RuntimeError: the topic has several types, or one of which there is no class.
    """
    name = _resolved(node, topic)
    types = _types(node, name, include_hidden_topics)
    if blocking and not types:
        print(f"WARNING: topic [{topic}] does not appear to be published yet")
        while not (types := _types(node, name, include_hidden_topics)):
            time.sleep(_POLL_S)
    if not types:
        return None
    if len(types) > 1:
        raise RuntimeError(
            f"Cannot echo topic '{topic}', as it contains more than one type: [{', '.join(types)}]"
        )
    try:
        return get_message(types[0])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The message type '{types[0]}' is invalid") from None


def _resolved(node: GraphNode, topic: str) -> str:
    """Return the full name of a topic."""
    if topic.startswith("/"):
        return topic
    namespace: str = node.get_namespace()
    return full_name(f"{namespace.rstrip('/')}/{topic}")


def _types(node: GraphNode, name: str, include_hidden_topics: bool) -> list[str]:
    topics = get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)
    return next((types for other, types in topics if other == name), [])


def qos_profile_from_short_keys(
    preset_profile: str,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> QoSProfile:
    """Return a copy of a preset profile with some policies replaced, all by their short names.

    Raises:
        KeyError: there is no profile or policy of that name.
    """
    profile = copy.copy(QoSPresetProfiles.get_from_short_key(preset_profile))
    profile_configure_short_keys(
        profile, reliability, durability, depth, history, liveliness, liveliness_lease_duration_s
    )
    return profile


def profile_configure_short_keys(
    profile: QoSProfile | None = None,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> None:
    """Replace policies of a profile by their short names; those that are None stay.

    TRANSIENT_LOCAL with a depth of 0 gets a depth of 1, because a late subscription would get nothing otherwise.

    Raises:
        KeyError: there is no policy of that name.
    """
    if profile is None:
        return
    if history:
        profile.history = QoSHistoryPolicy.get_from_short_key(history)
    if durability:
        profile.durability = QoSDurabilityPolicy.get_from_short_key(durability)
    if reliability:
        profile.reliability = QoSReliabilityPolicy.get_from_short_key(reliability)
    if liveliness:
        profile.liveliness = QoSLivelinessPolicy.get_from_short_key(liveliness)
    if liveliness_lease_duration_s is not None and liveliness_lease_duration_s >= 0:
        profile.liveliness_lease_duration = Duration(seconds=liveliness_lease_duration_s)
    if depth is not None and depth >= 0:
        profile.depth = depth
    elif profile.durability == QoSDurabilityPolicy.TRANSIENT_LOCAL and profile.depth == 0:
        profile.depth = 1


def add_qos_arguments(
    parser: argparse.ArgumentParser, entity_type: str, default_profile_str: str, extra_message: str = ""
) -> None:
    """Add the flags for a QoS.

    Args:
        parser: The verb's parser.
        entity_type: What the QoS is for, as `publish`; in the help.
        default_profile_str: Short name of the profile without flags; in the help.
        extra_message: What the help says after that.
    """
    parser.add_argument(
        "--qos-profile",
        choices=QoSPresetProfiles.short_keys(),
        default=default_profile_str,
        help=f"QoS profile to {entity_type} with (default: {default_profile_str}){extra_message}",
    )
    parser.add_argument(
        "--qos-depth", metavar="N", type=int, default=-1, help=f"number of messages to keep{extra_message}"
    )
    for policy, kind in POLICIES.items():
        parser.add_argument(
            f"--qos-{policy}", choices=kind.short_keys(), help=f"{policy} policy{extra_message}"
        )
    parser.add_argument(
        "--qos-liveliness-lease-duration-seconds",
        type=float,
        help=f"longest time without an assertion of liveliness in seconds{extra_message}",
    )


def message_type_completer(**_: Any) -> list[str]:
    """Return all message types."""
    return known_interfaces("msg")


class TopicNameCompleter:
    """Lists the topics on the graph.

    Args:
        include_hidden_topics_key: The argument that says whether hidden ones are listed.
    """

    def __init__(self, *, include_hidden_topics_key: str | None = None) -> None:
        self.include_hidden_topics_key = include_hidden_topics_key

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the words that may follow on the command line."""
        with NodeStrategy(parsed_args) as node:
            return get_topic_names(
                node=node,
                include_hidden_topics=getattr(
                    parsed_args, argument_key(self.include_hidden_topics_key, "include_hidden_topics"), False
                ),
            )


class TopicTypeCompleter:
    """Lists the types of a topic on the graph; without one, all message types.

    Args:
        topic_name_key: The argument with the topic's name.
    """

    def __init__(self, *, topic_name_key: str | None = None) -> None:
        self.topic_name_key = argument_key(topic_name_key, "topic_name")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the words that may follow on the command line."""
        with NodeStrategy(parsed_args) as node:
            types = _types(node, full_name(getattr(parsed_args, self.topic_name_key)), True)
        return types or message_type_completer()


class TopicMessagePrototypeCompleter:
    """Lists the one value that a message starts as, as YAML.

    Args:
        topic_type_key: The argument with the message's type.
    """

    def __init__(self, *, topic_type_key: str | None = None) -> None:
        self.topic_type_key = argument_key(topic_type_key, "topic_type")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return a message with its defaults."""
        return [message_to_yaml(get_message(getattr(parsed_args, self.topic_type_key))())]
