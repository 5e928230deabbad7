"""Exceptions of a buffer.

The tree of their classes::

    TransformException
    ├── ConnectivityException            the frames are in different trees
    ├── LookupException                  a frame is unknown, or the chain is a loop
    ├── InvalidArgumentException         a frame's name is empty or starts with a slash
    ├── TimeoutException                 a server did not reply in time
    └── ExtrapolationException           the stamp lies outside a frame's history:
        ├── BackwardExtrapolationException       before its oldest sample
        ├── ForwardExtrapolationException        after its newest sample
        └── NoDataForExtrapolationException      there is one sample only, or none

The texts are exactly tf2's; attributes hold the same facts as data.
"""

from __future__ import annotations

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
]


class TransformException(Exception):
    """A transform is not available."""

    __module__ = "tf2"

    frame_id: str | None = None
    """The frame that is missing or whose history is exceeded; None where the error is not about a single frame."""

    def __reduce__(self) -> tuple[object, ...]:
        """Pickle by this module's name, because there is no module `tf2` in which to find the class."""
        return _rebuild, (type(self).__name__, self.args), self.__dict__ or None


class ConnectivityException(TransformException):
    """The frames are in different trees."""

    __module__ = "tf2"


class LookupException(TransformException):
    """A frame is unknown, or the chain is a loop."""

    __module__ = "tf2"


class InvalidArgumentException(TransformException):
    """A frame's name is empty or starts with a slash."""

    __module__ = "tf2"


class TimeoutException(TransformException):
    """A server did not reply in time."""

    __module__ = "tf2"


class ExtrapolationException(TransformException):
    """The stamp lies outside the history of `frame_id`."""

    __module__ = "tf2"

    requested_ns: int | None = None
    """The requested stamp [ns since epoch]."""
    oldest_ns: int | None = None
    """The oldest stamp that `frame_id` has; None if it has no data."""
    newest_ns: int | None = None
    """The newest stamp that `frame_id` has; None if it has no data."""

    @property
    def gap_ns(self) -> int | None:
        """Distance of `requested_ns` from the nearest stamp of `frame_id` [ns]; None if it has no data."""
        if self.requested_ns is None or self.oldest_ns is None or self.newest_ns is None:
            return None
        if self.requested_ns < self.oldest_ns:
            return self.oldest_ns - self.requested_ns
        return self.requested_ns - self.newest_ns


class BackwardExtrapolationException(ExtrapolationException):
    """The stamp lies before the oldest sample of `frame_id`."""

    __module__ = "tf2"


class ForwardExtrapolationException(ExtrapolationException):
    """The stamp lies after the newest sample of `frame_id`."""

    __module__ = "tf2"


class NoDataForExtrapolationException(ExtrapolationException):
    """`frame_id` has one sample only, at another stamp, or none."""

    __module__ = "tf2"


def _rebuild(name: str, arguments: tuple[object, ...]) -> TransformException:
    exception: TransformException = globals()[name](*arguments)
    return exception
