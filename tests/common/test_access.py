"""Who may open a page."""

from __future__ import annotations

import pytest

from tfloom.common.access import Access, ClientAccess, is_loopback, is_origin


@pytest.mark.parametrize(
    ("host", "is_own"),
    [
        ("127.0.0.1", True),
        ("127.9.9.9", True),
        ("::1", True),
        ("localhost", True),
        ("0.0.0.0", False),
        ("192.168.1.2", False),
        ("localhost.evil.example", False),
        ("", False),
    ],
)
def test_loopback_addresses(host: str, is_own: bool) -> None:
    assert is_loopback(host) is is_own


HOST = "127.0.0.1:8765"
Headers = dict[str, str]


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": HOST},
        {"host": HOST, "origin": f"http://{HOST}"},
        {"Host": "localhost:8765", "Origin": "http://localhost:8765"},
        {"Host": "LOCALHOST:8765"},
        {"Host": "[::1]:8765"},
        {"Host": HOST, "Sec-Fetch-Site": "same-origin"},
        {"Host": HOST, "Sec-Fetch-Site": "none"},  # the user's own address bar
    ],
)
def test_own_machine_needs_no_token(headers: Headers) -> None:
    for path in ("/", "/api", "/image?topic=/camera"):
        assert Access("127.0.0.1", 8765).refusal(path, headers.items()) == ""


@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"Host": "evil.example:8765"},  # a name that was made to lead to this machine
        {"Host": HOST, "Origin": "http://evil.example"},
        {"HOST": HOST, "oRIGIN": "http://evil.example"},
        {"Host": HOST, "Origin": "http://127.0.0.1:9999"},  # another server of this machine
        {"Host": HOST, "Origin": f"http://{HOST}@evil.example"},
        {"Host": HOST, "Origin": f"http://{HOST}.evil.example"},
        {"Host": HOST, "Origin": "null"},
        {"Host": HOST, "Origin": ""},
        {"Origin": "null"},
        {"Host": "[::1", "Origin": "http://[::1"},
        {"Host": f"evil.example@{HOST}"},
        {"Host": f"{HOST}/x"},
        {"Host": HOST, "host": HOST},
        {"Host": HOST, "Origin": f"http://{HOST}", "origin": "http://evil.example"},
    ],
)
def test_page_of_another_site_is_refused(headers: Headers) -> None:
    for path in ("/", "/api"):
        assert Access("127.0.0.1", 8765).refusal(path, headers.items()) != ""


@pytest.mark.parametrize("site", ["cross-site", "same-site", "what a later browser says"])
@pytest.mark.parametrize("host", ["127.0.0.1", "0.0.0.0"])
def test_other_sites_lead_to_the_page_and_get_no_file_of_it(site: str, host: str) -> None:
    """A browser sends no Origin when a page of another site shows an image of ours."""
    access = Access(host, 8765)
    headers = {"Host": HOST, "sec-fetch-site": site, "Cookie": access.cookie()}
    assert access.refusal("/", headers.items()) == ""
    assert access.refusal("/?token=", headers.items()) == ""
    for path in ("/image?topic=/camera", "/page.js", "/scene/", "/api"):
        assert access.refusal(path, headers.items()) != ""


@pytest.mark.parametrize("path", ["//evil.example/", "http://evil.example/", "", "evil", "*"])
def test_request_for_another_server_is_refused(path: str) -> None:
    assert Access("127.0.0.1", 8765).refusal(path, [("Host", HOST)]) != ""


def test_other_address_needs_the_token() -> None:
    access = Access("0.0.0.0", 8765)
    headers = {"Host": "robot:8765"}
    assert len(access.token) >= 32
    assert access.token != Access("0.0.0.0", 8765).token

    def is_let_in(path: str, **more: str) -> bool:
        return access.refusal(path, {**headers, **more}.items()) == ""

    assert not is_let_in("/")
    assert not is_let_in("/?token=wrong")
    assert not is_let_in("/?token=é")
    assert not is_let_in("/?token=")
    assert is_let_in(f"/?token={access.token}")
    cookie = access.cookie().partition(";")[0]
    assert is_let_in("/api", Cookie=cookie)
    assert is_let_in("/api", cookie=f"theme=dark; {cookie}")
    assert not is_let_in("/api", Cookie="tfloom_view_8765=wrong")
    assert not is_let_in("/api", Cookie="tfloom_view_8765=")
    assert not is_let_in("/api", Cookie=cookie, Origin="http://evil.example")
    assert not is_let_in("/api", Cookie=cookie, Origin="null")
    assert (
        access.refusal("/api", [("Origin", "null"), ("Cookie", cookie)]) != ""
    )  # no Host, and an Origin without one


def test_two_servers_of_a_host_keep_their_cookies_apart() -> None:
    """A browser sends a host's cookies to all its ports, and one of the same name takes the other's place."""
    first, second = Access("0.0.0.0", 8765), Access("0.0.0.0", 8766)
    jar = dict(access.cookie().partition(";")[0].split("=", 1) for access in (first, second))
    headers = {"Host": "robot:8765", "Cookie": "; ".join(f"{name}={value}" for name, value in jar.items())}
    assert first.refusal("/api", headers.items()) == ""
    assert second.refusal("/api", headers.items()) == ""
    only_first = {"Host": "robot:8766", "Cookie": first.cookie().partition(";")[0]}
    assert second.refusal("/api", only_first.items()) != ""


def test_local_server_sets_no_cookie() -> None:
    assert Access("127.0.0.1", 8765).cookie() == ""
    assert "; HttpOnly; SameSite=Strict" in Access("0.0.0.0", 8765).cookie()


@pytest.mark.parametrize(
    "origin",
    [
        "https://app.foxglove.dev",
        "http://localhost:8080",
        "file://",
        "http://[::1]:8080",
        "vscode-webview://0abc",
        "http://10.0.0.1",
    ],
)
def test_origins(origin: str) -> None:
    assert is_origin(origin)


@pytest.mark.parametrize(
    "text",
    [
        *("", "null", "*", "https://*.example", "https://", "evil.example", "file:///home/page.html"),
        *("https://a.example/", "https://a.example/page", "https://me@a.example", "https://a.example:443"),
        *(
            "http://a.example:80",
            "HTTPS://a.example",
            "https://a.example\n",
            "https://a.example?x",
            "//a.example",
        ),
    ],
)
def test_texts_that_no_browser_sends_as_origin(text: str) -> None:
    assert not is_origin(text)


FOXGLOVE = "https://app.foxglove.dev"


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": HOST},
        {"host": HOST, "origin": FOXGLOVE},
        {"Host": HOST, "Origin": "http://127.0.0.1:9999"},
        {"Host": "localhost", "Origin": "https://localhost:8080"},
        {"Host": "[::1]:8765", "Origin": "http://[::1]:3000"},
        {"Host": HOST, "Origin": FOXGLOVE, "Sec-Fetch-Site": "cross-site"},
        {"Host": HOST, "Sec-Fetch-Site": "none"},
    ],
)
def test_clients_that_may_connect(headers: Headers) -> None:
    assert ClientAccess("127.0.0.1", {FOXGLOVE}).refusal(headers.items()) == ""


@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"Host": "rebound.evil.example:8765"},
        {"Host": "rebound.evil.example:8765", "Origin": FOXGLOVE},
        {"Host": "rebound.evil.example:8765", "Origin": "http://rebound.evil.example:8765"},
        {"Host": HOST, "Origin": "https://evil.example"},
        {"Host": HOST, "ORIGIN": "https://evil.example"},
        {"Host": HOST, "Origin": "null"},
        {"Host": HOST, "Origin": ""},
        {"Host": HOST, "Origin": "file://"},
        {"Host": HOST, "Origin": "http://app.foxglove.dev"},
        {"Host": HOST, "Origin": "https://app.foxglove.dev.evil.example"},
        {"Host": HOST, "Origin": "https://app.foxglove.dev:8443"},
        {"Host": HOST, "Origin": "https://evil-app.foxglove.dev"},
        {"Host": HOST, "Origin": "http://localhost.evil.example"},
        {"Host": HOST, "Origin": "http://localhost@evil.example"},
        {"Host": HOST, "Origin": "chrome-extension://localhost"},
        {"Host": HOST, "Origin": FOXGLOVE, "origin": "https://evil.example"},
        {"Host": HOST, "host": "evil.example"},
        {"Host": HOST, "Sec-Fetch-Site": "cross-site"},
    ],
)
def test_clients_that_may_not_connect(headers: Headers) -> None:
    assert ClientAccess("127.0.0.1", {FOXGLOVE}).refusal(headers.items()) != ""


def test_clients_of_another_address() -> None:
    """It may be asked for by any name there, because Origin tells the page's site."""
    access = ClientAccess("0.0.0.0", {FOXGLOVE})
    robot = ("Host", "robot.lan:8765")
    assert access.refusal([robot]) == ""
    assert access.refusal([robot, ("Origin", FOXGLOVE)]) == ""
    assert access.refusal([robot, ("Origin", "http://robot.lan:8765")]) == (
        "pages of http://robot.lan:8765 may not connect: allowed_origins names the sites whose pages may"
    )
    assert access.refusal([robot, ("Origin", "null")]) == "a page without its own site may not connect"
