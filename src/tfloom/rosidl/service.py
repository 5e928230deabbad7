"""The bases of service and action classes, which hold their message classes and have no instances.

Type checkers infer from the type arguments what a client returns and what a callback takes.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, ClassVar, Generic, TypeAlias

    from typing_extensions import TypeVar

    RequestT = TypeVar("RequestT", default=Any)
    ResponseT = TypeVar("ResponseT", default=Any)
    GoalT = TypeVar("GoalT", default=Any)
    ResultT = TypeVar("ResultT", default=Any)
    FeedbackT = TypeVar("FeedbackT", default=Any)
    FeedbackMessageT = TypeVar("FeedbackMessageT", default=Any)
    ResultResponseT = TypeVar("ResultResponseT", default=Any)
else:
    RequestT = ResponseT = GoalT = ResultT = FeedbackT = FeedbackMessageT = ResultResponseT = None

    class Generic:
        """Replacement for `typing.Generic`, because importing `typing` takes longer than importing a few messages."""

        def __class_getitem__(cls, arguments: object) -> type:
            return cls


class Service(Generic[RequestT, ResponseT]):
    """A service type: `Request`, `Response`, and the `Event` that introspection publishes."""

    _TYPE_NAME: ClassVar[str]
    _TYPE_HASH: ClassVar[str]
    if TYPE_CHECKING:
        # Aliases, as in each service's class, because pyright rejects annotations by a name that a base declares as a
        # variable.
        Request: TypeAlias = Any
        Response: TypeAlias = Any
        Event: TypeAlias = Any

    def __init__(self) -> None:
        raise NotImplementedError("Service classes can not be instantiated")


class ActionImpl:
    """The base of `Impl` of action types: the services and messages that carry the action."""


class Action(Generic[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]):
    """An action type: `Goal`, `Result`, `Feedback`, and in `Impl` the services and messages that carry them."""

    _TYPE_NAME: ClassVar[str]
    _TYPE_HASH: ClassVar[str]
    if TYPE_CHECKING:
        Goal: TypeAlias = Any
        Result: TypeAlias = Any
        Feedback: TypeAlias = Any
        Impl: TypeAlias = Any

    def __init__(self) -> None:
        raise NotImplementedError("Action classes can not be instantiated")
