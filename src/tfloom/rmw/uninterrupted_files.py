"""The files whose functions a wire's library calls, on any thread, where it would print and drop an exception.

A KeyboardInterrupt is not raised there, but as soon as they have returned: see `node/executing/signals.py`.
"""

from __future__ import annotations

__all__ = ["uninterrupted_files"]

uninterrupted_files: set[str] = set()
"""Named as in code objects; the modules add themselves."""
