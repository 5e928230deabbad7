"""Why a link to a router can't be made, which Zenoh keeps to itself: found out by our own connection."""

from __future__ import annotations

import json
import socket
from typing import Any

from tfloom.rmw.zenoh.config import endpoints_of

__all__ = ["unlinked_endpoints", "why_no_link", "why_no_links"]

CONNECT_TIMEOUT_S = 2.0
ALERT_TIMEOUT_S = 0.5
"""How long a router may take to refuse a certificate [s]: by TLS 1.3, it does so after the client's handshake."""

_NO_ANSWER = "doesn't answer: is the machine on, and does a firewall let the port through?"


def why_no_links(config: Any) -> str:
    """Return, for each endpoint of a router in a `zenoh.Config`, why there is no link, in one line."""
    return "; ".join(
        f"{endpoint} {why_no_link(endpoint, config)}"
        for endpoint in endpoints_of(config, "connect/endpoints")
    )


def why_no_link(endpoint: str, config: Any) -> str:
    """Return why a router at an endpoint isn't linked, as a predicate: `refuses: nothing listens there`.

    It connects by TCP and, for `tls/…`, shakes hands with the certificates of the configuration.

    Args:
        endpoint: As `tls/robot:7448`.
        config: The `zenoh.Config` of the session.
    """
    protocol, host, port_text = _parts(endpoint)
    if protocol not in {"tcp", "tls"} or not port_text.isdigit():
        return "isn't linked"
    try:
        with socket.create_connection((host, int(port_text)), CONNECT_TIMEOUT_S) as connection:
            if protocol == "tls":
                return _why_no_handshake(connection, host, config)
            return "is open, but doesn't answer as a router: is it stopped, or does it want TLS (tls/…)?"
    except (OSError, OverflowError) as error:
        return _why_no_connection(error)


def unlinked_endpoints(session: Any, config: Any) -> list[str]:
    """Return those endpoints of a router's configuration at whose hosts there is no router that it is linked to.

    Two routers that are to connect to each other have one link, whose end at the other host may have any port.

    Args:
        session: The `zenoh.Session` of a router.
        config: Its `zenoh.Config`.
    """
    routers = {str(zid) for zid in session.info.routers_zid()}
    linked = {_parts(str(link.dst))[1] for link in session.info.links() if str(link.zid) in routers}
    return [
        endpoint
        for endpoint in endpoints_of(config, "connect/endpoints")
        if linked.isdisjoint(_addresses(_parts(endpoint)[1]))
    ]


def _addresses(host: str) -> set[str]:
    try:
        return {str(entry[4][0]) for entry in socket.getaddrinfo(host, None)}
    except OSError:
        return {host}


def _parts(endpoint: str) -> tuple[str, str, str]:
    """Return protocol, host and port of an endpoint."""
    protocol, _, address = endpoint.partition("/")
    host, _, port_text = address.partition("?")[0].partition("#")[0].rpartition(":")
    return protocol, host.strip("[]"), port_text


def _why_no_connection(error: Exception) -> str:
    if isinstance(error, socket.gaierror):
        return f"names no host: {error.strerror}"
    if isinstance(error, ConnectionRefusedError):
        return "refuses: nothing listens there"
    return _NO_ANSWER if isinstance(error, TimeoutError) else f"can't be reached: {error}"


def _why_no_handshake(connection: socket.socket, host: str, config: Any) -> str:
    import ssl

    def setting(name: str) -> Any:
        return json.loads(config.get_json(f"transport/link/tls/{name}"))

    authority, certificate, key = (
        setting(name) for name in ("root_ca_certificate", "connect_certificate", "connect_private_key")
    )
    try:
        context = ssl.create_default_context(cafile=authority)
        if setting("enable_mtls") and certificate:
            context.load_cert_chain(certificate, key)
    except (OSError, ssl.SSLError) as error:
        return f"can't be tried: a file of transport/link/tls ({authority}, {certificate}, {key}): {error}"
    try:
        with context.wrap_socket(connection, server_hostname=host) as link:
            link.settimeout(ALERT_TIMEOUT_S)
            if not link.recv(1):
                return "ends the link after the handshake"
    except ssl.SSLCertVerificationError as error:
        return (
            f"has a certificate that {authority or 'this system'} doesn't vouch for: {error.verify_message}"
        )
    except ssl.SSLError as error:
        return _refusal(str(error.reason), certificate, is_sent=bool(setting("enable_mtls")))
    except TimeoutError:
        return "accepts the certificate, but isn't linked: do its rules or its version differ?"
    return "isn't linked"


def _refusal(reason: str, certificate: str | None, *, is_sent: bool) -> str:
    """Return what an alert of TLS means."""
    if "CERTIFICATE_REQUIRED" in reason or "HANDSHAKE_FAILURE" in reason:
        if certificate and not is_sent:
            return "demands a certificate, which isn't sent: set transport/link/tls/enable_mtls to true"
        return "demands a certificate: name connect_certificate and connect_private_key, and set enable_mtls to true"
    if "UNKNOWN_CA" in reason or "BAD_CERTIFICATE" in reason or "DECRYPT_ERROR" in reason:
        return f"refuses the certificate {certificate}: its authority isn't the router's"
    return f"refuses the handshake: {reason}"
