"""Conversion between arrays with named fields and plain ones, by sensor_msgs_py's names."""

from __future__ import annotations

from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

__all__ = ["structured_to_unstructured", "unstructured_to_structured"]
