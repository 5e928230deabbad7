"""Constants of time."""

from __future__ import annotations

S_TO_NS = 1000 * 1000 * 1000
"""Nanoseconds in a second."""

INT64_MAX = 2**63 - 1
"""The latest time and the longest duration [ns]: both are signed 64-bit counts."""
