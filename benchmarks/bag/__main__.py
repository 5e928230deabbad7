"""Measure recordings: reading."""

from __future__ import annotations

from benchmarks.bag import reading

reading.main([])
