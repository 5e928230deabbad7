"""What tests of demonstrations share."""

from __future__ import annotations

import sys
import uuid

import pytest


@pytest.fixture
def mark(monkeypatch: pytest.MonkeyPatch) -> str:
    """An environment variable that marks all processes of the demonstration."""
    if sys.platform != "linux":
        pytest.skip("processes are found in /proc, which Linux has")
    value = str(uuid.uuid4())
    monkeypatch.setenv("TFLOOM_TEST_MARK", value)
    return f"TFLOOM_TEST_MARK={value}"
