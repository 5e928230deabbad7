"""The exceptions that a buffer raises beside a real rclpy.

If tf2_py is installed for it, each one derives from tf2_py's exception of that name too, so that a program may catch
`tf2_ros.LookupException`. It always derives from that of `tfloom.tf2.errors`, and has its attributes.
"""

from __future__ import annotations

from tfloom.drop_in import real_ros
from tfloom.tf2 import errors
from tfloom.tf2.errors import (
    BackwardExtrapolationException,
    ConnectivityException,
    ExtrapolationException,
    ForwardExtrapolationException,
    InvalidArgumentException,
    LookupException,
    NoDataForExtrapolationException,
    TimeoutException,
    TransformException,
)

__all__ = [
    "BackwardExtrapolationException",
    "ConnectivityException",
    "ExtrapolationException",
    "ForwardExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "NoDataForExtrapolationException",
    "TimeoutException",
    "TransformException",
    "converted",
]


def _derived() -> dict[str, type[errors.TransformException]]:
    """Return a class for each exception of `tfloom.tf2.errors`, by its name: that class itself without tf2_py.

    With tf2_py, it derives from that class, from tf2_py's of its name if there is one, and from the one for its base.
    """
    tf2_py = real_ros.find("tf2_py")
    classes: dict[str, type[errors.TransformException]] = {}
    # Bases come first: a class has a longer list of bases than each of them.
    for ours in sorted(
        (getattr(errors, name) for name in errors.__all__), key=lambda kind: len(kind.__mro__)
    ):
        name = ours.__name__
        if tf2_py is None:
            classes[name] = ours
            continue
        bases = (classes.get(ours.__base__.__name__), getattr(tf2_py, name, None), ours)
        body = {"__module__": __name__, "__doc__": ours.__doc__, "__reduce__": Exception.__reduce__}
        classes[name] = type(name, tuple(base for base in bases if base is not None), body)
    return classes


_CLASSES = _derived()
globals().update(_CLASSES)


def converted(error: errors.TransformException) -> errors.TransformException:
    """Return the exception to raise in place of one of `tfloom.tf2.errors`: with its text and its attributes."""
    kind = _CLASSES.get(type(error).__name__, type(error))
    if isinstance(error, kind):
        return error
    result = kind(*error.args)
    result.__dict__.update(error.__dict__)
    return result
