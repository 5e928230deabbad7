"""Conversion of structured arrays to plain ones and back, by sensor_msgs_py's names."""

from __future__ import annotations

from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

__all__ = ["structured_to_unstructured", "unstructured_to_structured"]
