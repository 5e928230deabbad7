"""Who may open a page."""

from __future__ import annotations

import pytest

from tfloom.viewer.access import Access, is_loopback


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


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "127.0.0.1:8765"},
        {"Host": "localhost:8765", "Origin": "http://localhost:8765"},
        {"Host": "[::1]:8765"},
    ],
)
def test_own_machine_needs_no_token(headers: dict[str, str]) -> None:
    assert Access("127.0.0.1", 8765).refusal("/", headers) == ""


@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"Host": "evil.example:8765"},  # a name that was made to lead to this machine
        {"Host": "127.0.0.1:8765", "Origin": "http://evil.example"},
        {"Host": "127.0.0.1:8765", "Origin": "http://127.0.0.1:9999"},  # another server of this machine
        {"Host": "127.0.0.1:8765", "Origin": "null"},
        {"Host": "[::1", "Origin": "http://[::1"},
    ],
)
def test_page_of_another_site_is_refused(headers: dict[str, str]) -> None:
    assert Access("127.0.0.1", 8765).refusal("/api", headers) != ""


def test_other_address_needs_the_token() -> None:
    access = Access("0.0.0.0", 8765)
    headers = {"Host": "robot:8765"}
    assert len(access.token) >= 32
    assert access.token != Access("0.0.0.0", 8765).token
    assert access.refusal("/", headers) != ""
    assert access.refusal("/?token=wrong", headers) != ""
    assert access.refusal("/?token=é", headers) != ""
    assert access.refusal(f"/?token={access.token}", headers) == ""
    cookie = access.cookie().partition(";")[0]
    assert access.refusal("/api", {**headers, "Cookie": cookie}) == ""
    assert access.refusal("/api", {**headers, "Cookie": "tfloom_view_8765=wrong"}) != ""
    assert access.refusal("/api", {**headers, "Cookie": cookie, "Origin": "http://evil.example"}) != ""
