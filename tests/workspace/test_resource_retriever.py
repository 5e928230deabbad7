"""`resource_retriever`: files named by URLs."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest
from ament_index_python.packages import PackageNotFoundError
from resource_retriever import get, get_filename
from tests.workspace.conftest import write_files


@pytest.fixture
def mesh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a file of the package `arm`, in a folder whose name has a blank."""
    prefix = tmp_path / "a prefix"
    files = {"ament_index/resource_index/packages/arm": "", "arm/meshes/a#b.stl": "solid"}
    write_files(prefix / "share", files)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    return prefix / "share" / "arm" / "meshes" / "a#b.stl"


def test_file_of_a_package(mesh: Path) -> None:
    url = "package://arm/meshes/a#b.stl"
    assert get_filename(url) == f"file://{mesh}"
    assert get_filename(url, use_protocol=False) == str(mesh)
    assert get(url) == get(f"file://{mesh}") == b"solid"
    assert get_filename("http://a/b") == "http://a/b"


def test_what_is_not_there(mesh: Path) -> None:
    with pytest.raises(PackageNotFoundError, match="'nobodys' not found"):
        get_filename("package://nobodys/x")
    with pytest.raises(ValueError, match="names no package"):
        get_filename("package:///x")
    with pytest.raises(FileNotFoundError):
        get("package://arm/nope")
    with pytest.raises(ValueError, match="begins with none of"):
        get("ftp://arm/nope")


class Handler(BaseHTTPRequestHandler):
    """Serves one file."""

    def do_GET(self) -> None:
        self.send_response(200 if self.path == "/x" else 404)
        self.end_headers()
        self.wfile.write(b"served")

    def log_message(self, *_: object) -> None:
        """Print nothing."""


@pytest.fixture
def server() -> Iterator[str]:
    with HTTPServer(("127.0.0.1", 0), Handler) as http:
        thread = threading.Thread(target=http.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{http.server_port}"
        http.shutdown()
        thread.join()


def test_file_of_a_web_server(server: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("no_proxy", "127.0.0.1")
    assert get(f"{server}/x") == b"served"
    with pytest.raises(OSError, match="/y: Not Found"):
        get(f"{server}/y")
