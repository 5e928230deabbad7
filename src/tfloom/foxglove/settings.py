"""The parameters of foxglove_bridge."""

from __future__ import annotations

import re
import ssl
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.common.access import is_origin
from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.parameters.parameter import Parameter

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["CAPABILITIES", "Settings", "SettingsError"]

CAPABILITIES = ("clientPublish", "parameters", "parametersSubscribe", "services", "connectionGraph", "assets")
"""What clients may do, by default."""
TIME = "time"
"""A further capability; `use_sim_time` implies it."""
ASSETS = r"^package://(?:[-\w%]+/)*[-\w%.]+\.(?:dae|fbx|glb|gltf|jpeg|jpg|mtl|obj|png|stl|tif|tiff|urdf|webp|xacro)$"
PARAMETERS: dict[str, tuple[Any, str]] = {
    "port": (8765, "The port; 0: a free one"),
    "address": ("127.0.0.1", "The address at which to listen"),
    "tls": (False, "Whether connections are encrypted, with certfile and keyfile"),
    "certfile": ("", "The certificate, a PEM file"),
    "keyfile": ("", "Its private key, a PEM file"),
    "allowed_origins": (
        ["https://app.foxglove.dev", "file://"],
        "Sites whose pages may connect, beside those of this machine's own servers",
    ),
    "topic_whitelist": ([".*"], "Regular expressions of the topics that clients see"),
    "service_whitelist": ([".*"], "Regular expressions of the services that clients may call"),
    "param_whitelist": (
        [".*"],
        "Regular expressions of the parameters that clients may get and set: /node.name",
    ),
    "client_topic_whitelist": ([".*"], "Regular expressions of the topics to which clients may publish"),
    "best_effort_qos_topic_whitelist": (["(?!)"], "Regular expressions of topics that are read best effort"),
    "asset_uri_allowlist": ([ASSETS], "Regular expressions of the files that clients may read"),
    "capabilities": (list(CAPABILITIES), "What clients may do"),
    "min_qos_depth": (1, "Depth of a subscription's queue, at least"),
    "max_qos_depth": (25, "Depth of a subscription's queue, at most"),
    "include_hidden": (False, "Whether clients see topics and services with a part that begins with _"),
    "ignore_unresponsive_param_nodes": (True, "Whether a node that didn't answer is asked no more"),
    "message_backlog_size": (
        128,
        "Number of messages that wait for a client; of more, the oldest are dropped",
    ),
    "sysinfo": (False, "Whether CPU and memory of the bridge and of its system are served, as JSON"),
    "sysinfo_topic": ("/foxglove_bridge/sysinfo", "Their topic, which only clients see"),
    "sysinfo_refresh_interval": (500, "Their period [ms]"),
    "debug": (False, "Whether messages of the level DEBUG are logged"),
}
"""Default and description of each parameter."""
WITHOUT_EFFECT: dict[str, Any] = {
    "send_buffer_limit": 10_000_000,
    "use_compression": False,
    "num_threads": 0,
    "disable_load_message": True,
    "publish_client_count": False,
    "remote_access": False,
}
"""Parameters that are accepted and not used, with their defaults."""
LATER_NAMES = {
    name: name.replace("whitelist", "allowlist") for name in PARAMETERS if name.endswith("_whitelist")
}
"""Names that later versions of the bridge have for these parameters; given, they take precedence."""


class SettingsError(Exception):
    """A parameter can't be used; the text says which, and why."""


class Settings:
    """The values of the parameters, which a node declares; they can't be set later.

    Raises:
        SettingsError: a value can't be used.
        InvalidParameterTypeException: a value is of another type.
    """

    def __init__(self, node: Node) -> None:
        values = {
            name: node.declare_parameter(
                name, default, ParameterDescriptor(description=text, read_only=True)
            ).value
            for name, (default, text) in PARAMETERS.items()
        }
        for name, later in LATER_NAMES.items():
            descriptor = ParameterDescriptor(description=f"Another name of {name}", read_only=True)
            given = node.declare_parameter(later, Parameter.Type.STRING_ARRAY, descriptor).value
            if given is not None:
                values[name] = given
        for name, default in WITHOUT_EFFECT.items():
            descriptor = ParameterDescriptor(description="Accepted and not used", read_only=True)
            if node.declare_parameter(name, default, descriptor).value != default:
                node.get_logger().warning(f"The parameter {name} has no effect here")
        if values["debug"]:
            node.get_logger().set_level(LoggingSeverity.DEBUG)
        self.address: str = values["address"]
        self.port = _in_range("port", values["port"], 0, 65535)
        self.topics = Names("topic_whitelist", values["topic_whitelist"])
        self.services = Names("service_whitelist", values["service_whitelist"])
        self.parameters = Names("param_whitelist", values["param_whitelist"])
        self.client_topics = Names("client_topic_whitelist", values["client_topic_whitelist"])
        self.best_effort_topics = Names(
            "best_effort_qos_topic_whitelist", values["best_effort_qos_topic_whitelist"]
        )
        self.assets = Names("asset_uri_allowlist", values["asset_uri_allowlist"])
        self.capabilities = frozenset(values["capabilities"])
        if unknown := sorted(self.capabilities - {*CAPABILITIES, TIME}):
            known = ", ".join((*CAPABILITIES, TIME))
            raise SettingsError(f"parameter capabilities: there is no '{unknown[0]}', only {known}")
        self.min_depth = _in_range("min_qos_depth", values["min_qos_depth"], 1, 10_000)
        self.max_depth = _in_range("max_qos_depth", values["max_qos_depth"], self.min_depth, 10_000)
        self.backlog = _in_range("message_backlog_size", values["message_backlog_size"], 1, 100_000)
        self.sysinfo_topic: str = values["sysinfo_topic"] if values["sysinfo"] else ""
        """Empty: nothing of the system is served."""
        self.sysinfo_s = (
            _in_range("sysinfo_refresh_interval", values["sysinfo_refresh_interval"], 200, 3_600_000) / 1000
        )
        self.include_hidden: bool = values["include_hidden"]
        self.skips_silent_nodes: bool = values["ignore_unresponsive_param_nodes"]
        self.origins = frozenset(_origin(origin) for origin in values["allowed_origins"])
        self.tls = _tls(values["certfile"], values["keyfile"]) if values["tls"] else None

    def shows(self, name: str, names: Names) -> bool:
        """Return whether clients see a topic or a service."""
        return name in names and (self.include_hidden or "/_" not in name)


class Names:
    """The names that one of some regular expressions matches as a whole, in capitals or not."""

    def __init__(self, parameter: str, expressions: list[str]) -> None:
        self._expressions = [_compiled(parameter, expression) for expression in expressions]

    def __contains__(self, name: str) -> bool:
        return any(expression.fullmatch(name) for expression in self._expressions)


def _compiled(parameter: str, expression: str) -> re.Pattern[str]:
    try:
        return re.compile(expression, re.IGNORECASE)
    except re.error as error:
        raise SettingsError(
            f"parameter {parameter}: '{expression}' is not a regular expression: {error}"
        ) from None


def _in_range(parameter: str, value: int, least: int, most: int) -> int:
    if not least <= value <= most:
        raise SettingsError(f"parameter {parameter}: {value} is not from {least} to {most}")
    return value


def _origin(text: str) -> str:
    if not is_origin(origin := text.lower()):
        raise SettingsError(
            f"parameter allowed_origins: '{text}' is not a site as browsers name it, as https://viewer.example"
        )
    return origin


def _tls(certificate: str, key: str) -> ssl.SSLContext:
    """Return with what connections are encrypted."""
    for parameter, path in (("certfile", certificate), ("keyfile", key)):
        if not path:
            raise SettingsError(f"parameter {parameter}: tls needs a file")
        try:
            Path(path).read_bytes()
        except OSError as error:
            raise SettingsError(f"parameter {parameter}: {path}: {error.strerror or error}") from None
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    try:
        # Without a password, OpenSSL would ask for that of an encrypted key at the terminal.
        context.load_cert_chain(certificate, key, password="")
    except (ssl.SSLError, ValueError) as error:
        reason = getattr(error, "reason", None) or error
        raise SettingsError(
            f"parameters certfile and keyfile: {certificate} and {key} are not a pair of a certificate and its key "
            f"without a password, as PEM files: {reason}"
        ) from None
    return context
