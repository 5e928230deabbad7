"""Configuration of the sessions and routers of the Zenoh wire, by rmw_zenoh's variables and by the discovery range.

ZENOH_SESSION_CONFIG_URI, ZENOH_ROUTER_CONFIG_URI: a JSON5 file. What it leaves out has rmw_zenoh's values.
ZENOH_CONFIG_OVERRIDE: `key=value;key=value`, with JSON5 values, for sessions and routers, after the file.
ZENOH_ROUTER_CHECK_ATTEMPTS: how often, once a second, a starting program looks for its router; see `router_checks`.
TFLOOM_ZENOH_PORT: the port of the machine's router in place of 7447.
ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_STATIC_PEERS, TFLOOM_LEASE_S: as on the other wire; see `session_settings`.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from typing import Any

from tfloom.common.terminal import report
from tfloom.rmw.cyclone.config import discovery_range, lease_s, why_peers_are_ignored
from tfloom.rmw.errors import ConfigurationError
from tfloom.rmw.zenoh.library import open_library

__all__ = [
    "CHECKS_VARIABLE",
    "OVERRIDE_VARIABLE",
    "PORT_VARIABLE",
    "ROUTER_VARIABLE",
    "SESSION_VARIABLE",
    "configured",
    "default_configuration",
    "endpoints_of",
    "meeting_point_configuration",
    "mode_of",
    "needs_meeting_point",
    "port",
    "reason_of",
    "router_checks",
    "router_configuration",
    "router_settings",
    "session_configuration",
    "session_settings",
]

SESSION_VARIABLE = "ZENOH_SESSION_CONFIG_URI"
ROUTER_VARIABLE = "ZENOH_ROUTER_CONFIG_URI"
OVERRIDE_VARIABLE = "ZENOH_CONFIG_OVERRIDE"
CHECKS_VARIABLE = "ZENOH_ROUTER_CHECK_ATTEMPTS"
PORT_VARIABLE = "TFLOOM_ZENOH_PORT"

DEFAULT_PORT = 7447
LAST_PORT = 65535
MAX_FILE_SIZE = 1 << 20
"""The longest configuration file that is read [bytes]."""
DEFAULT_LEASE_S = 60.0
QUERY_TIMEOUT_MS = 600_000
WAIT_BEFORE_DROP_US = 50_000
"""How long a reliable sample waits for room [us]. With Zenoh's 1 ms, one stopped reader costs all others samples."""
MAX_WAIT_BEFORE_DROP_US = 5_000_000
"""How long one of many parts waits in all [us]; each part adds the wait above. With Zenoh's 50 ms, no image of 10 MB
passes a link of 100 MB/s."""

_MODES = {"router", "peer", "client"}
_PLACE_IN_SOURCES = re.compile(r" at /\S+\.rs:\d+\.?")


def session_configuration() -> Any:
    """Return the configuration of a session, a `zenoh.Config`, for the environment.

    Raises:
        ConfigurationError: a variable is invalid, or the file can't be read.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    return configured(SESSION_VARIABLE, session_settings())


def router_configuration(settings: Mapping[str, object] | None = None) -> Any:
    """Return the configuration of a router, a `zenoh.Config`, for the environment.

    Args:
        settings: Values by key that precede those of the environment, for the arguments of a command.

    Raises:
        ConfigurationError: a variable is invalid, or the file can't be read.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    config = configured(ROUTER_VARIABLE, router_settings())
    for key, setting in (settings or {}).items():
        _insert(config, key, setting, "an argument")
    return config


def session_settings() -> dict[str, object]:
    """Return the values of a session's configuration by key, where neither a file nor an override names them.

    They are rmw_zenoh's, but for these: shared memory is off; nothing waits for a first router, and a lost one is
    sought more often; a reliable sample waits longer for room; the addresses are those of the range. LOCALHOST and
    SYSTEM_DEFAULT are this machine; SUBNET listens on all interfaces and scouts by multicast; OFF neither listens,
    connects nor scouts. A session is linked to this machine's router alone, which is linked to those of
    ROS_STATIC_PEERS: between two sessions that share a router of another machine and have no link of their own, Zenoh
    passes nothing.

    Raises:
        ConfigurationError: a variable is invalid.
    """
    asked = discovery_range()
    is_off, is_open = asked == "OFF", asked == "SUBNET"
    connect = [] if is_off else [f"tcp/127.0.0.1:{port()}"]
    listen = [] if is_off else ["tcp/[::]:0" if is_open else "tcp/127.0.0.1:0"]
    return {
        "mode": "peer",
        "connect/endpoints": connect,
        "listen/endpoints": listen,
        **_common_settings(),
        "connect/retry": {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2},
        "scouting/multicast/enabled": is_open,
        "scouting/gossip/enabled": not is_off,
        "scouting/gossip/target": {"router": ["router", "peer"], "peer": ["router"]},
        "scouting/gossip/autoconnect": {"router": [], "peer": ["router", "peer"]},
        "scouting/gossip/autoconnect_strategy": {
            "peer": {"to_router": "always", "to_peer": "greater-zid"},
        },
    }


def router_settings() -> dict[str, object]:
    """Return the values of a router's configuration by key, where neither a file nor an override names them.

    It listens on 127.0.0.1, with the range SUBNET on all interfaces, and connects to the hosts of ROS_STATIC_PEERS: to
    their routers at the same port, unless they name another.

    Raises:
        ConfigurationError: a variable is invalid.
    """
    host = "[::]" if discovery_range() == "SUBNET" else "127.0.0.1"
    return {
        "mode": "router",
        "connect/endpoints": _peer_endpoints(),
        "listen/endpoints": [f"tcp/{host}:{port()}"],
        **_common_settings(),
        "scouting/multicast/enabled": False,
        "scouting/gossip/enabled": True,
        "scouting/gossip/target": {"router": ["router", "peer"], "peer": ["router"]},
        "scouting/gossip/autoconnect": {"router": [], "peer": ["router", "peer"]},
    }


def _common_settings() -> dict[str, object]:
    asked_lease_s = lease_s()
    return {
        "connect/timeout_ms": {"router": -1, "peer": -1, "client": 0},
        "connect/exit_on_failure": {"router": False, "peer": False, "client": True},
        "connect/retry": {"period_init_ms": 1000, "period_max_ms": 4000, "period_increase_factor": 2},
        "listen/timeout_ms": 0,
        "listen/exit_on_failure": True,
        "open/return_conditions": {"connect_scouted": False, "declares": True},
        "scouting/delay": 0,
        "timestamping/enabled": {"router": True, "peer": True, "client": True},
        "queries_default_timeout": QUERY_TIMEOUT_MS,
        "transport/unicast/open_timeout": 60_000,
        "transport/unicast/accept_timeout": 60_000,
        "transport/unicast/accept_pending": 10_000,
        "transport/unicast/max_sessions": 10_000,
        "transport/link/tx/lease": round(
            1000 * (DEFAULT_LEASE_S if asked_lease_s is None else asked_lease_s)
        ),
        "transport/link/tx/queue/congestion_control/drop/wait_before_drop": WAIT_BEFORE_DROP_US,
        "transport/link/tx/queue/congestion_control/drop/max_wait_before_drop_fragments": MAX_WAIT_BEFORE_DROP_US,
        "transport/shared_memory/enabled": False,
    }


def port() -> int:
    """Return the port of the machine's router: 7447, or TFLOOM_ZENOH_PORT.

    Raises:
        ConfigurationError: TFLOOM_ZENOH_PORT is not a port.
    """
    text = os.environ.get(PORT_VARIABLE, "").strip()
    if not text:
        return DEFAULT_PORT
    if not (text.isascii() and text.isdigit() and 0 < int(text[:6]) <= LAST_PORT):
        raise ConfigurationError(f"{PORT_VARIABLE} must be an integer from 1 to {LAST_PORT}, not {text!r}")
    return int(text)


def meeting_point_configuration() -> Any:
    """Return the configuration of a router inside a session's process, a `zenoh.Config`, for the environment.

    Neither the router's file nor overrides have an effect on it.

    Raises:
        ConfigurationError: a variable is invalid.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    return default_configuration(router_settings())


def default_configuration(settings: Mapping[str, object]) -> Any:
    """Return a `zenoh.Config` of values by key alone, without a file and overrides.

    Raises:
        ConfigurationError: Zenoh refuses a value.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    config = open_library().Config()
    for key, setting in settings.items():
        _insert(config, key, setting, "tfloom's settings")
    return config


def needs_meeting_point(config: Any) -> bool:
    """Return whether a session's configuration seeks its router on this machine alone, at the port of `port`."""
    own = {f"tcp/{host}:{port()}" for host in ("127.0.0.1", "localhost", "[::1]")}
    endpoints = endpoints_of(config, "connect/endpoints")
    return bool(endpoints) and own.issuperset(endpoints) and mode_of(config) != "router"


def router_checks() -> int | None:
    """Return how often a starting program looks for a router, from ZENOH_ROUTER_CHECK_ATTEMPTS: 1 by default.

    None: without end (0). 0: never (a negative number).

    Raises:
        ConfigurationError: it is not an integer.
    """
    text = os.environ.get(CHECKS_VARIABLE, "").strip()
    if not text:
        return 1
    try:
        attempts = int(text)
    except ValueError:
        raise ConfigurationError(
            f"{CHECKS_VARIABLE} must be an integer (0: wait without end, negative: don't look), not {text!r}"
        ) from None
    return max(attempts, 0) if attempts else None


def configured(variable: str, settings: Mapping[str, object]) -> Any:
    """Return a `zenoh.Config` of the file that a variable names, of `settings` where it says nothing, and of overrides.

    Args:
        variable: Name of the environment variable that names the file.
        settings: Values by key.

    Raises:
        ConfigurationError: the file can't be read, or isn't a configuration.
        NoBackendError: eclipse-zenoh isn't installed.
    """
    path = os.environ.get(variable, "").strip()
    config, stated = _read_file(variable, path) if path else (open_library().Config(), {})
    for key, setting in settings.items():
        value = _stated(stated, key)
        whole = setting if value is None else _with_defaults(value, setting)
        if whole != value:
            _insert(config, key, whole, "tfloom's settings")
    for key, value_text in _overrides():
        _override(config, key, value_text)
    return config


def endpoints_of(config: Any, key: str) -> list[str]:
    """Return the endpoints of a `zenoh.Config` for the mode that it has.

    Args:
        config: The configuration.
        key: `connect/endpoints` or `listen/endpoints`.
    """
    endpoints = json.loads(config.get_json(key)) or []
    if isinstance(endpoints, dict):
        endpoints = endpoints.get(mode_of(config), [])
    return [endpoint for endpoint in endpoints if isinstance(endpoint, str)]


def mode_of(config: Any) -> str:
    """Return the mode of a `zenoh.Config`: peer, where it states none, client or router."""
    return str(json.loads(config.get_json("mode")) or "peer")


def reason_of(error: Exception) -> str:
    """Return the text of an error of Zenoh in one line, without the places in its sources."""
    text = _PLACE_IN_SOURCES.sub("", str(error))
    if message := re.search(r'msg: "(.*?)", location', text, re.DOTALL):
        text = message.group(1)
        if place := re.search(r"line: (\d+), column: (\d+)", str(error)):
            text += f" (line {place.group(1)}, column {place.group(2)})"
    return " ".join(text.replace("\\n", " ").replace('\\"', '"').split())


def _insert(config: Any, key: str, setting: object, origin: str) -> None:
    zenoh = open_library()
    try:
        config.insert_json5(key, json.dumps(setting))
    except zenoh.ZError as error:
        raise ConfigurationError(
            f"{origin}: Zenoh refuses {key}={json.dumps(setting)}: {reason_of(error)}"
        ) from None


def _override(config: Any, key: str, value_text: str) -> None:
    """Set a value of ZENOH_CONFIG_OVERRIDE; report one that Zenoh refuses, which then has no effect."""
    zenoh = open_library()
    try:
        config.insert_json5(key, value_text)
    except zenoh.ZError as error:
        report(f"tfloom: {OVERRIDE_VARIABLE}: {key}={value_text} is ignored: {reason_of(error)}")


def _read_file(variable: str, path: str) -> tuple[Any, Any]:
    """Return the `zenoh.Config` of a file, and what the file states, as plain values."""
    zenoh = open_library()
    text = _file_text(variable, path)
    try:
        config = zenoh.Config.from_file(path)
        return config, _json5_values(text) if path.endswith((".json", ".json5")) else _yaml_values(text)
    except (zenoh.ZError, ValueError, RecursionError) as error:
        raise ConfigurationError(
            f"{variable} names {path}, which is not a configuration of Zenoh: {reason_of(error)}"
        ) from None


def _json5_values(text: str) -> Any:
    """Return the values of a text in JSON5, as Zenoh's own parser reads it: as a value that may be anything."""
    scratch = open_library().Config()
    scratch.insert_json5("metadata", text)
    return json.loads(scratch.get_json("metadata"))


def _yaml_values(text: str) -> Any:
    from tfloom.common.yaml import load  # here, because few configurations are in YAML

    return load(text)


def _file_text(variable: str, path: str) -> str:
    try:
        with open(path, "rb") as file:
            data = file.read(MAX_FILE_SIZE + 1)
        text = data.decode()
    except OSError as error:
        raise ConfigurationError(
            f"{variable} names {path}, which can't be read: {error.strerror}; name a file, or unset the variable"
        ) from None
    except UnicodeDecodeError:
        raise ConfigurationError(f"{variable} names {path}, which isn't UTF-8 text") from None
    if len(data) > MAX_FILE_SIZE:
        raise ConfigurationError(f"{variable} names {path}, which is longer than {MAX_FILE_SIZE} bytes")
    return text


def _stated(values: Any, key: str) -> Any:
    """Return what a file's values state at a key, as `connect/endpoints`; None if nothing."""
    for part in key.split("/"):
        values = values.get(part) if isinstance(values, dict) else None
    return values


def _with_defaults(value: Any, setting: object) -> Any:
    """Return a value that a file states, with a setting's parts where it states nothing of them.

    The parts are the members of a group, or the modes: what a file states for a router alone says nothing of a peer.
    """
    if not isinstance(value, dict):
        return value
    is_by_mode = _is_by_mode(value)
    defaults = dict.fromkeys(_MODES, setting) if is_by_mode and not _is_by_mode(setting) else setting
    if not isinstance(defaults, dict) or is_by_mode != _is_by_mode(defaults):
        return value
    return {**defaults, **{part: stated for part, stated in value.items() if stated is not None}}


def _is_by_mode(value: object) -> bool:
    return isinstance(value, dict) and value.keys() <= _MODES


def _overrides() -> list[tuple[str, str]]:
    """Return the pairs of ZENOH_CONFIG_OVERRIDE. One without a key or a value is reported and left out."""
    pairs = []
    for pair in os.environ.get(OVERRIDE_VARIABLE, "").split(";"):
        key, _, value_text = (part.strip() for part in pair.partition("="))
        if key and value_text:
            pairs.append((key, value_text))
        elif pair.strip():
            report(f"tfloom: {OVERRIDE_VARIABLE}: {pair.strip()!r} is ignored, because it isn't key=value")
    return pairs


def _peer_endpoints() -> list[str]:
    """Return the endpoints for ROS_STATIC_PEERS: `host` or `host:port`, and endpoints of Zenoh as they are."""
    if why_peers_are_ignored():
        return []
    endpoints = []
    for peer in os.environ.get("ROS_STATIC_PEERS", "").split(";"):
        host = peer.strip()
        if not host or host in {"127.0.0.1", "localhost", "::1"}:
            continue
        if "/" in host:
            endpoints.append(host)
        elif host.count(":") == 1:
            endpoints.append(f"tcp/{host}")
        else:
            endpoints.append(f"tcp/[{host}]:{port()}" if ":" in host else f"tcp/{host}:{port()}")
    return endpoints
