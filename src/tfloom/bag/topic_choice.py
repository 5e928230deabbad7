"""Which topics are recorded or played: names, types, services, actions, regular expressions, exclusions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from tfloom.bag.errors import BagError
from tfloom.rmw.typed_names import CANCEL_GOAL, FEEDBACK, GET_RESULT, SEND_GOAL, SERVICE_EVENTS, STATUS

__all__ = [
    "TopicChoice",
    "action_of",
    "full_names",
    "is_service_event",
    "read_static_topics",
    "service_of_event",
]

_EVENT_TYPE_SUFFIX = "_Event"
_ACTION_SUFFIXES = (
    FEEDBACK,
    STATUS,
    *(service + SERVICE_EVENTS for service in (SEND_GOAL, CANCEL_GOAL, GET_RESULT)),
)


def full_names(names: Iterable[str]) -> list[str]:
    """Return names with a slash before them."""
    return [name if name.startswith("/") else f"/{name}" for name in names]


def is_service_event(topic: str, type_name: str) -> bool:
    """Return whether a topic has the events of a service's introspection."""
    return topic.endswith(SERVICE_EVENTS) and type_name.endswith(_EVENT_TYPE_SUFFIX)


def service_of_event(topic: str) -> str:
    """Return the service of a topic of events: `/add` of `/add/_service_event`."""
    return topic.removesuffix(SERVICE_EVENTS)


def action_of(topic: str) -> str:
    """Return the action whose topic this is, one of its feedback, its status or its services' events; "" if none."""
    suffix = next((suffix for suffix in _ACTION_SUFFIXES if topic.endswith(suffix)), "")
    return topic.removesuffix(suffix) if suffix else ""


STATIC_TOPICS = "static_topics_and_types_list"
"""The key of a file of topics that are recorded from the start."""


def read_static_topics(path: Path) -> dict[str, str]:
    """Return the topics in a file, each with its type: what a recorder subscribes to before anybody publishes.

    The file is YAML: `static_topics_and_types_list: [[/scan, sensor_msgs/msg/LaserScan], …]`.

    Raises:
        BagError: it can't be read, isn't as it must be, or a topic has two types or none.
    """
    from tfloom.common import yaml as user_yaml

    try:
        values = user_yaml.load(path.read_text("utf-8"))
    except OSError as error:
        raise BagError(path, f"it can't be read: {error.strerror}") from None
    except (user_yaml.YamlError, UnicodeDecodeError) as error:
        raise BagError(path, f"it isn't YAML: {error}") from None
    pairs = values.get(STATIC_TOPICS) if isinstance(values, dict) else None
    if not isinstance(pairs, list):
        raise BagError(path, f"it must have '{STATIC_TOPICS}: [[/topic, package/msg/Type], …]'")
    topics: dict[str, str] = {}
    for pair in pairs:
        if not (isinstance(pair, list) and len(pair) == 2 and all(isinstance(word, str) for word in pair)):
            raise BagError(path, f"each of '{STATIC_TOPICS}' must be a topic and its type, not {pair!r}")
        (name,), type_name = full_names(pair[:1]), pair[1]
        if not re.fullmatch(r"\w+/(msg|srv|action)/\w+", type_name):
            raise BagError(path, f"the type of '{name}' must be as package/msg/Type, not '{type_name}'")
        if topics.setdefault(name, type_name) != type_name:
            raise BagError(path, f"'{name}' has two types: {topics[name]} and {type_name}")
    return topics


@dataclass
class TopicChoice:
    """What is wanted, by full names; nothing at first. Exclusions apply to all of it.

    Raises:
        re.error: a regular expression is invalid; raised by `wants`.
    """

    topics: Sequence[str] = ()
    topic_types: Sequence[str] = ()
    services: Sequence[str] = ()
    actions: Sequence[str] = ()
    all_topics: bool = False
    all_services: bool = False
    all_actions: bool = False
    regex: str = ""
    exclude_regex: str = ""
    exclude_topics: Sequence[str] = ()
    exclude_topic_types: Sequence[str] = ()
    exclude_services: Sequence[str] = ()
    exclude_actions: Sequence[str] = ()
    is_whole_match: bool = False
    """Whether expressions must match whole names; otherwise a part of them."""
    _compiled: dict[str, re.Pattern[str]] = field(default_factory=dict, repr=False)

    @property
    def is_by_name_only(self) -> bool:
        """Whether all that is wanted is listed by name."""
        is_open = self.all_topics or self.all_services or self.all_actions or self.regex or self.topic_types
        # An action that is named has topics that may appear later, as the events of its services.
        return not (is_open or self.actions)

    def wanted_names(self) -> set[str]:
        """Return the topics that are listed by name, those of services' events included."""
        return {*self.topics, *(service + SERVICE_EVENTS for service in self.services)}

    def wants(self, topic: str, type_name: str) -> bool:
        """Return whether a topic is wanted: by itself, as the events of a service, or as a part of an action."""
        action = action_of(topic)
        if action in self.exclude_actions or self._matches(
            self.exclude_regex, *filter(None, [action]), topic
        ):
            return False
        if self.wants_as_action(topic):
            return True
        if is_service_event(topic, type_name):
            service = service_of_event(topic)
            if service in self.exclude_services or self._matches(self.exclude_regex, service):
                return False
            return self.all_services or service in self.services or self._matches(self.regex, service, topic)
        is_excluded = topic in self.exclude_topics or type_name in self.exclude_topic_types
        return not is_excluded and (
            self.all_topics
            or topic in self.topics
            or type_name in self.topic_types
            or self._matches(self.regex, topic)
        )

    def wants_as_action(self, topic: str) -> bool:
        """Return whether a topic is wanted for the action that it is a part of, though its name is a hidden one."""
        action = action_of(topic)
        if not action or action in self.exclude_actions:
            return False
        return self.all_actions or action in self.actions

    def _matches(self, expression: str, *names: str) -> bool:
        if not expression:
            return False
        compiled = self._compiled.setdefault(expression, re.compile(expression))
        match = compiled.fullmatch if self.is_whole_match else compiled.search
        return any(match(name) for name in names)
