"""ROS names on DDS: `/pose` is `rt/pose`, `turtlesim/msg/Pose` is `turtlesim::msg::dds_::Pose_`."""

from __future__ import annotations

from tfloom.rmw.base import Service, Topic

TOPIC_PREFIX = "rt"
_REQUEST = ("rq", "Request")
_RESPONSE = ("rr", "Reply")
_REQUEST_TYPE = "_Request"
_RESPONSE_TYPE = "_Response"


def topic_to_dds(name: str) -> str:
    """Return the DDS name of a topic's fully qualified name."""
    return TOPIC_PREFIX + name


def topic_from_dds(name: str) -> str | None:
    """Return the fully qualified name of a ROS topic, or None for a DDS topic without ROS's prefix."""
    prefix, slash, rest = name.partition("/")
    return slash + rest if prefix == TOPIC_PREFIX and rest else None


def request_topic(service: Service) -> Topic:
    """Return the topic of a service's requests, by its DDS name: `rq/spawnRequest`."""
    prefix, suffix = _REQUEST
    return Topic(prefix + service.name + suffix, service.type_name + _REQUEST_TYPE, service.request_hash)


def response_topic(service: Service) -> Topic:
    """Return the topic of a service's responses, by its DDS name: `rr/spawnReply`."""
    prefix, suffix = _RESPONSE
    return Topic(prefix + service.name + suffix, service.type_name + _RESPONSE_TYPE, service.response_hash)


def service_from_request_topic(name: str, type_name: str) -> tuple[str, str] | None:
    """Return the name and type of the service that takes requests on a topic, or None if it is not a request topic."""
    prefix, suffix = _REQUEST
    if not (name.startswith(prefix + "/") and name.endswith(suffix) and type_name.endswith(_REQUEST_TYPE)):
        return None
    return name[len(prefix) : -len(suffix)], type_name[: -len(_REQUEST_TYPE)]


def type_to_dds(name: str) -> str:
    """Return the DDS name of a type.

    Raises:
        ValueError: the name isn't of the form `package/msg/Type`.
    """
    parts = name.split("/")
    if len(parts) != 3 or not all(parts):
        raise ValueError(f"a type's name is like 'std_msgs/msg/String', not {name!r}")
    package, kind, type_name = parts
    return f"{package}::{kind}::dds_::{type_name}_"


def type_from_dds(name: str) -> str:
    """Return ROS's name of a type; return any other name unchanged."""
    parts = name.split("::")
    if len(parts) < 3 or parts[-2] != "dds_" or not parts[-1].endswith("_"):
        return name
    return "/".join([*parts[:-2], parts[-1][:-1]])


def key_values(user_data: bytes) -> dict[str, str]:
    """Return an entity's USER_DATA, `enclave=/;typehash=RIHS01_…;`, as a dict; ignore malformed parts."""
    entries = (entry.partition("=") for entry in user_data.decode("utf-8", "replace").split(";"))
    return {key: value for key, equals, value in entries if equals}
