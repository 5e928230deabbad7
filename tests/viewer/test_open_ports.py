"""What `tfloom view` opens, to pages of other sites."""

from __future__ import annotations

import re
from collections.abc import Callable
from urllib.parse import urlsplit

import pytest
from tests.conftest import Program
from tests.viewer.open_ports import answers_to_a_page, open_ports
from viser import __version__

pytestmark = pytest.mark.wire


def test_no_port_of_a_viewer_lets_a_page_in(start_program: Callable[..., Program]) -> None:
    program = start_program("tfloom", "view", "--no-open", "--port", "0")
    printed = program.wait_for("Open http")
    address = urlsplit(re.findall(r"http://\S+", printed)[0])
    own = (str(address.hostname), int(address.port or 0))
    ports = open_ports(program.process.pid)
    assert own in ports
    assert len(ports) == 2, "the page's, and viser's"
    for port in ports:
        for path in ("/api", "/scene/ws?page=", "/", "/image?topic=/camera"):
            answers = answers_to_a_page(port, path, f"viser-v{__version__}")
            if port == own:
                assert answers
                assert all(answer.startswith(b"HTTP/1.1 403") for answer in answers), path
            else:
                assert answers == [], path
