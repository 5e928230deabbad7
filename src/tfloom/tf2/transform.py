"""One rigid transform as a value: see `help(Transform)`."""

from __future__ import annotations

from tfloom._native import StampedTransform, Transform

__all__ = ["StampedTransform", "Transform"]
