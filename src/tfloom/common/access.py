"""Which requests may open a page or a WebSocket: by the address that it asks for, where it comes from, and a token."""

from __future__ import annotations

import ipaddress
import re
import secrets
from collections.abc import Collection, Iterable
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs, urlsplit

__all__ = ["Access", "ClientAccess", "is_loopback", "is_origin"]

FOR_THIS_MACHINE = "this server is for this machine alone: ask for 127.0.0.1"
NO_ADDRESS = "the Host or Origin of the request is not an address"
OTHER_SITE = "another site's page may not open this one"
_ORIGIN = re.compile(
    r"file://|(?P<scheme>[a-z][a-z\d+.-]{0,30})://(?:[a-z\d_.-]{1,253}|\[[\da-f:.]{2,45}\])(?::(?P<port>\d{1,5}))?"
)


def is_loopback(host: str) -> bool:
    """Return whether an address is this machine's own."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


def is_origin(text: str) -> bool:
    """Return whether a text is the origin of a site as browsers send it, in small letters: `https://viewer.example`.

    `null` is none: each page without its own site sends it, as one from a file or in a sandbox.
    """
    if (match := _ORIGIN.fullmatch(text)) is None:
        return False
    return (match["scheme"], match["port"]) not in {("http", "80"), ("https", "443")}


class _Request:
    """The headers of a request that tell where it comes from, by names that are compared without case.

    Raises:
        ValueError: one of them is given twice, or is not an address.
    """

    def __init__(self, headers: Iterable[tuple[str, str]]) -> None:
        self._headers: dict[str, list[str]] = {}
        for name, value in headers:
            self._headers.setdefault(name.lower(), []).append(value)
        self.host = self._value("host") or ""
        address = urlsplit(f"//{self.host}")
        if address.netloc != self.host or "@" in self.host:
            raise ValueError("more than an address")
        self.host_name = address.hostname or ""
        self.origin = self._value("origin")
        self.is_from_page = self._value("sec-fetch-site") not in {None, "none"}
        """Whether a page asks, and not a user or a program."""
        self.is_from_other_site = self.is_from_page and self._value("sec-fetch-site") != "same-origin"

    def _value(self, name: str) -> str | None:
        values = self._headers.get(name, [])
        if len(values) > 1:
            raise ValueError(f"{name} is given twice")
        return values[0] if values else None

    def cookies(self) -> str:
        return "; ".join(self._headers.get("cookie", []))


class Access:
    """The rules of one server of pages.

    On the loopback interface, any program of this machine may open the page. A page of another site in the same browser
    may not: it would send that site's name as Origin, or, with a name that was made to lead here, as Host. Where it
    loads a file, as an image, it sends no Origin, and browsers say in another header that the site is another one. It
    may lead to the page by a link. On other interfaces a token is needed, which is in the address that is printed; the
    page then has it as a cookie.

    Args:
        host: The address at which the server listens.
        port: Its port.
        token: The token; None: a new one, where the address is not a loopback address.
    """

    def __init__(self, host: str, port: int, token: str | None = None) -> None:
        self.is_local = is_loopback(host)
        self.token = "" if self.is_local else (token or secrets.token_urlsafe(24))
        self._port = port
        # Browsers send a cookie to all ports of a host: without the port, two servers would take each other's away.
        self.cookie_name = f"tfloom_view_{port}"

    def refusal(self, path: str, headers: Iterable[tuple[str, str]]) -> str:
        """Return why a request is refused, as a sentence; empty if it is not.

        Args:
            path: Its path, with the query.
            headers: Its headers.
        """
        try:
            request = _Request(headers)
            is_same_site = request.origin is None or (
                request.host != "" and urlsplit(request.origin).netloc == request.host
            )
        except ValueError:
            return NO_ADDRESS
        if not path.startswith("/") or path.startswith("//"):
            return "the request asks for another server"
        if self.is_local and not is_loopback(request.host_name):
            return FOR_THIS_MACHINE
        is_link = urlsplit(path).path == "/"
        if not is_same_site or (request.is_from_other_site and not is_link):
            return OTHER_SITE
        if self.token and not self._has_token(path, request.cookies()):
            return "the token is missing: open the address that `tfloom view` printed"
        return ""

    def _has_token(self, path: str, cookies: str) -> bool:
        given = [*parse_qs(urlsplit(path).query).get("token", [])]
        try:
            cookie = SimpleCookie(cookies).get(self.cookie_name)
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


class ClientAccess:
    """The rules of a server of WebSockets, for programs, and for pages of some sites.

    A browser says in each request for a WebSocket by Origin of which site the page is, and no page can change that. A
    program that is not a browser sends none, and may connect. So may pages of this machine's own servers.

    Args:
        host: The address at which the server listens. On the loopback interface it has to be asked for by such a name.
        origins: The sites whose pages may connect.
    """

    def __init__(self, host: str, origins: Collection[str]) -> None:
        self._is_local = is_loopback(host)
        self._origins = frozenset(origins)

    def refusal(self, headers: Iterable[tuple[str, str]]) -> str:
        """Return why a request is refused, as a sentence; empty if it is not."""
        try:
            request = _Request(headers)
        except ValueError:
            return NO_ADDRESS
        if self._is_local and not is_loopback(request.host_name):
            return FOR_THIS_MACHINE
        origin = request.origin
        if origin is None:
            # A page's WebSocket has an Origin always: what a browser sends without one is not a WebSocket.
            return OTHER_SITE if request.is_from_page else ""
        if not is_origin(origin):
            return "a page without its own site may not connect"
        if origin in self._origins or _is_page_of_this_machine(origin):
            return ""
        return f"pages of {origin} may not connect: allowed_origins names the sites whose pages may"


def _is_page_of_this_machine(origin: str) -> bool:
    parts = urlsplit(origin)
    return parts.scheme in {"http", "https"} and is_loopback(parts.hostname or "")
