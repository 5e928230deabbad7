"""Who may open a page: by the address that it asks for, where it comes from, and a token."""

from __future__ import annotations

import ipaddress
import secrets
from collections.abc import Mapping
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs, urlsplit

__all__ = ["Access", "is_loopback"]


def is_loopback(host: str) -> bool:
    """Return whether an address is this machine's own."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


class Access:
    """The rules of one server.

    On the loopback interface, any program of this machine may open the page. A page of another site in the same browser
    may not: it would send that site's name as Origin, or, with a name that was made to lead here, as Host. Elsewhere a
    token is needed, which is in the address that is printed; the page then has it as a cookie.

    Args:
        host: The address at which the server listens.
        port: Its port.
        token: The token; None: a new one, where the address is not a loopback address.
    """

    def __init__(self, host: str, port: int, token: str | None = None) -> None:
        self.is_local = is_loopback(host)
        self.token = "" if self.is_local else (token or secrets.token_urlsafe(24))
        self._port = port
        self.cookie_name = f"tfloom_view_{port}"

    def refusal(self, path: str, headers: Mapping[str, str]) -> str:
        """Return why a request is refused, as a sentence; empty if it is not.

        Args:
            path: Its path, with the query.
            headers: Its headers.
        """
        host, origin = headers.get("Host", ""), headers.get("Origin")
        try:
            name = urlsplit(f"//{host}").hostname or ""
            is_same_site = origin is None or urlsplit(origin).netloc == host
        except ValueError:
            return "the Host or Origin of the request is no address"
        if self.is_local and not is_loopback(name):
            return "this server is for this machine alone: ask for 127.0.0.1"
        if not is_same_site:
            return "another site's page may not open this one"
        if self.token and not self._has_token(path, headers):
            return "the token is missing: open the address that `tfloom view` printed"
        return ""

    def _has_token(self, path: str, headers: Mapping[str, str]) -> bool:
        given = [*parse_qs(urlsplit(path).query).get("token", [])]
        try:
            cookie = SimpleCookie(headers.get("Cookie", "")).get(self.cookie_name)
        except CookieError:
            cookie = None
        if cookie is not None:
            given.append(cookie.value)
        return any(secrets.compare_digest(value.encode(), self.token.encode()) for value in given)

    def cookie(self) -> str:
        """Return the header's value that gives a page the token; empty where none is needed."""
        if not self.token:
            return ""
        return f"{self.cookie_name}={self.token}; Path=/; HttpOnly; SameSite=Strict"
