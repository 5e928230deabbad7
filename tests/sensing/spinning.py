"""Nodes spun until something is so."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest
from tests.conftest import TIMEOUT_S

from tfloom.node.executing.executors import Executor


def spin_until(executor: Executor, condition: Callable[[], object]) -> None:
    """Spin until a condition holds; fail the test where it never does."""
    end = time.monotonic() + TIMEOUT_S
    while not condition():
        if time.monotonic() > end:
            pytest.fail(f"gave up after {TIMEOUT_S} s")
        executor.spin_once(timeout_sec=1)
