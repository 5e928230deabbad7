"""Errors of a wire.

WireError (RuntimeError)
├── NoBackendError         the selected wire is unknown, or not installed
├── ConfigurationError     an environment variable or an argument is invalid for the wire
├── ClosedError            an endpoint was used after it was closed
├── ForkedError            it was opened before this process was forked
├── ForeignPeerError       a service's peer uses another vendor's format
├── CongestedError         servers take no requests, and as many wait as are kept
└── UnsupportedEventError  this wire, or this kind of endpoint, has no such event
"""

from __future__ import annotations


class WireError(RuntimeError):
    """An operation of the wire failed; the text has the reason and the remedy."""


class NoBackendError(WireError):
    """No backend is available: an unknown name, or a library that isn't installed."""


class ConfigurationError(WireError):
    """A setting is invalid; the text has its name, its value and the valid values."""


class ClosedError(WireError):
    """An endpoint was used after it was closed."""


class ForkedError(WireError):
    """A forked process used what its parent had opened; the text has what to do instead."""


class ForeignPeerError(WireError):
    """A request was not sent, because a server of another vendor would misread it."""


class CongestedError(WireError):
    """A request was not sent, because as many as are kept wait for servers that do not take them."""


class UnsupportedEventError(WireError):
    """An event that this wire, or this kind of endpoint, does not have."""
