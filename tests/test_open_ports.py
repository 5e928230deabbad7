"""The table of `docs/security.md` has each module that opens a port, and a test of what a page gets there."""

from __future__ import annotations

import ast
import re
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from tfloom.demos.processes import own_domain
from tfloom.testing import domains

ROOT = Path(__file__).parents[1]
FOLDERS = [ROOT / "src" / "tfloom", *ROOT.glob("packages/*/src")]
OPENERS = {
    *("create_server", "start_server", "start_unix_server", "create_unix_server", "create_datagram_endpoint"),
    *(
        "ViserServer",
        "HTTPServer",
        "ThreadingHTTPServer",
        "TCPServer",
        "ThreadingTCPServer",
        "UDPServer",
        "Listener",
    ),
    *("SimpleXMLRPCServer", "BaseManager", "SyncManager"),
}
CONNECTS_FROM = {"common/inner_port.py"}
"""Modules that bind a socket to connect from there."""


def opened(source: str) -> Iterator[int]:
    """Give the lines of a module at which it opens a port."""
    tree = ast.parse(source)
    from_libraries = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.level == 0 and not str(node.module).startswith("tfloom")
        for alias in node.names
    }
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        match node.func:
            case ast.Attribute(value=ast.Name(id="zenoh"), attr="open"):
                yield node.lineno
            case ast.Attribute(attr="bind") if node.args and isinstance(node.args[0], ast.Tuple):
                yield node.lineno
            case ast.Attribute(attr=name) if name in OPENERS:
                yield node.lineno
            case ast.Name(id=name) if name in from_libraries and (name in OPENERS or name == "serve"):
                yield node.lineno


@pytest.mark.parametrize(
    "source",
    [
        "import socket\nsocket.create_server(address)",
        "receiver.bind((host, port))",
        "from websockets.asyncio.server import serve\nserve(handle)",
        "from http.server import HTTPServer\nHTTPServer(address, Handler)",
        "import zenoh\nzenoh.open(config)",
    ],
)
def test_openings_are_found(source: str) -> None:
    assert list(opened(source))


def test_other_calls_are_no_openings() -> None:
    source = "from tfloom.bag import serve\nserve(a)\nsignature(f).bind(*args)\nopen(path)\nself.serve(a)"
    assert list(opened(source)) == []


def test_table_has_each_module_that_opens_a_port() -> None:
    modules = {
        str(path.relative_to(folder))
        for folder in FOLDERS
        for path in folder.rglob("*.py")
        if list(opened(path.read_text()))
    }
    text = (ROOT / "docs" / "security.md").read_text()
    section = text.partition("## What a page in a browser reaches")[2].partition("\n## ")[0]
    rows = [line.split(" | ") for line in section.splitlines() if line.startswith("| ")][1:]
    assert modules - CONNECTS_FROM == {name for row in rows for name in re.findall(r"`([\w/]+\.py)`", row[1])}
    tests = {name for row in rows for name in re.findall(r"`(tests/[\w/]+\.py)`", row[3])}
    assert all("`tests/" in row[3] for row in rows)
    assert [name for name in sorted(tests) if not (ROOT / name).is_file()] == []


def test_nobody_listens_at_the_locks_of_domains() -> None:
    with own_domain(lambda _: True) as shown, domains.hold_domain() as tested:
        for port in (
            7400 + 250 * shown,
            domains.FIRST_LOCK_PORT + domains.PORTS_OF_A_DOMAIN * tested,
        ):
            with pytest.raises(ConnectionRefusedError):
                socket.create_connection(("127.0.0.1", port), timeout=10.0).close()
