"""Measure recordings: reading, writing, recording and playing."""

from __future__ import annotations

from benchmarks.bag import playing, reading, writing

reading.main([])
writing.main([])
playing.main([])
