"""The bases of service and action classes, which hold their message classes and have no instances."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, ClassVar


class Service:
    """A service type: `Request`, `Response`, and the `Event` that introspection publishes."""

    _TYPE_NAME: ClassVar[str]
    _TYPE_HASH: ClassVar[str]
    Request: ClassVar[type[Any]]
    Response: ClassVar[type[Any]]
    Event: ClassVar[type[Any]]

    def __init__(self) -> None:
        raise NotImplementedError("Service classes can not be instantiated")


class Action:
    """An action type: `Goal`, `Result`, `Feedback`, and in `Impl` the services and messages that carry them."""

    _TYPE_NAME: ClassVar[str]
    _TYPE_HASH: ClassVar[str]
    Goal: ClassVar[type[Any]]
    Result: ClassVar[type[Any]]
    Feedback: ClassVar[type[Any]]
    Impl: ClassVar[type[Any]]

    def __init__(self) -> None:
        raise NotImplementedError("Action classes can not be instantiated")
