"""What can go wrong with a wire.

WireError (RuntimeError)
├── NoBackendError         the wire asked for, or any wire, isn't installed or isn't known
├── ConfigurationError     an environment variable or an argument holds what the wire can't take
├── ClosedError            an endpoint was used after it had left its topic
├── ForeignPeerError       a service's other end speaks another vendor's form
└── UnsupportedEventError  this wire, or this kind of endpoint, has no such event
"""

from __future__ import annotations


class WireError(RuntimeError):
    """The wire refused something; the message says what and what to do."""


class NoBackendError(WireError):
    """No backend can be had: an unknown name, or a library that isn't installed."""


class ConfigurationError(WireError):
    """A setting can't be used: which one, what it holds, and what it may hold."""


class ClosedError(WireError):
    """A writer was used after it had been closed."""


class ForeignPeerError(WireError):
    """A request would reach a server of another vendor, which would misread it; so it wasn't sent."""


class UnsupportedEventError(WireError):
    """An event that this wire doesn't know, or that the other kind of endpoint has."""
