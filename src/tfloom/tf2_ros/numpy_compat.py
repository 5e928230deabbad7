"""Structured arrays to plain ones and back: what sensor_msgs_py.numpy_compat offers, which numpy has by now."""

from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

__all__ = ["structured_to_unstructured", "unstructured_to_structured"]
