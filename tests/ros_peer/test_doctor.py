"""What `tfloom doctor` reports of participants of both vendors."""

from __future__ import annotations

import json
import sys
from typing import Any

import pytest
from tests.conftest import run_to_end

from tfloom.rmw.cyclone.library import open_library

from .conftest import OURS, THEIRS, StartEnd

pytestmark = pytest.mark.ros


def peers_of_doctor() -> dict[str, Any]:
    """Return the finding of `doctor` on peers."""
    command = [sys.executable, "-m", "tfloom", "doctor", "--json", "--exclude-packages"]
    done = run_to_end(command)
    return next(finding for finding in json.loads(done.stdout) if finding["check"] == "peers")


def test_doctor_names_vendor_version_and_form_of_services(start_end: StartEnd) -> None:
    for vendor, name in ((OURS, "ours"), (THEIRS, "theirs")):
        start_end(vendor, name)
    version = open_library().version
    found = peers_of_doctor()
    # Fast DDS 2.14 announces no version, libddsc 11 does.
    cyclone, fast = f"Cyclone DDS {version}", "Fast DDS of unknown version"
    assert found["verdict"] == "ok"
    assert found["summary"] in {
        f"other participants: 1 on {one}, 1 on {other}; topics and services pass"
        for one, other in ((cyclone, fast), (fast, cyclone))
    }
    assert sorted(found["details"].values()) == [
        f"{cyclone} (/ours); services: header in the message; all passes",
        f"{fast} (/theirs); services: inline QoS; all passes, services translated",
    ]
