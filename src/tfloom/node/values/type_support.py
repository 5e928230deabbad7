"""Checks that a class is a message or service class, and the types and type variables of endpoints and actions.

Each type variable has the default Any, so that `Client` alone is a complete type.
"""

from __future__ import annotations

import reprlib
import typing
from typing import TYPE_CHECKING, Any, Protocol

from tfloom.common.text import given_text
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Action, Service

if TYPE_CHECKING:
    from tfloom.interfaces.builtin_interfaces.msg import Time
    from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
    from tfloom.interfaces.unique_identifier_msgs.msg import UUID

__all__ = [
    "Action",
    "ActionT",
    "EventMessage",
    "FeedbackMessage",
    "FeedbackT",
    "GetResultService",
    "GetResultServiceRequest",
    "GetResultServiceResponse",
    "GoalT",
    "ImplT",
    "Msg",
    "MsgT",
    "ResultT",
    "SendGoalService",
    "SendGoalServiceRequest",
    "SendGoalServiceResponse",
    "Srv",
    "SrvRequestT",
    "SrvResponseT",
    "SrvT",
    "TypeVar",
    "WithDefaults",
    "check_for_type_support",
    "check_is_valid_action_type",
    "check_is_valid_msg_type",
    "check_is_valid_srv_type",
    "msg_type_error",
    "wrong_fields",
    "wrong_message",
]

_TYPES = (Message, Service, Action)


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Check that a class is a message, a service or an action.

    Raises:
        AttributeError: it is none of them.
    """
    error = _type_error(msg_or_srv_type, _TYPES, "message or service class, such as std_msgs.msg.String")
    if error is not None:
        raise error


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Check that a class is a message.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a service or an action.
    """
    if (error := msg_type_error(msg_type)) is not None:
        raise error


def msg_type_error(msg_type: Any) -> Exception | None:
    """Return what `check_is_valid_msg_type` raises, or None, for callers whose tracebacks shall be short."""
    return _type_error(msg_type, (Message,), "message class, such as std_msgs.msg.String")


def check_is_valid_srv_type(srv_type: Any) -> None:
    """Check that a class is a service.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a message or an action.
    """
    error = _type_error(srv_type, (Service,), "service class, such as std_srvs.srv.SetBool")
    if error is not None:
        raise error


def check_is_valid_action_type(action_type: Any) -> None:
    """Check that a class is an action.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a message or a service.
    """
    error = _type_error(action_type, (Action,), "action class, such as example_interfaces.action.Fibonacci")
    if error is not None:
        raise error


def wrong_message(msg_type: type[Message], given: Any) -> str:
    """Return the text of an error about something that was published in place of a message of `msg_type`.

    It begins as the reference's does, and ends with what was probably meant.
    """
    name = msg_type.__name__
    if isinstance(given, type):
        return (
            f"Expected {msg_type}, got {type(given)}: publish a message, {given.__name__}(…), not its class"
        )
    if isinstance(given, Message) or not msg_type.get_fields_and_field_types():
        home = msg_type.__module__.partition(".")[0]
        return f"Expected {msg_type}, got {type(given)}: this topic has {home}.msg.{name}"
    return wrong_fields(msg_type, given, "publish a message", name)


def wrong_fields(message_class: type[Message], given: Any, what_to_do: str, written: str) -> str:
    """Return the text of an error about something that was given in place of a `message_class`.

    Args:
        message_class: The class.
        given: What was given.
        what_to_do: As "send a request".
        written: The class as programs write it, as "SetBool.Request".
    """
    text = f"Expected {message_class}, got {type(given)}: {what_to_do}"
    if given is message_class:
        return f"{text}, {written}(…), not its class"
    fields = message_class.get_fields_and_field_types()
    if len(fields) == 1 and given is not None and not isinstance(given, (type, Message)):
        return f"{text}, {written}({next(iter(fields))}={reprlib.repr(given)})"
    return f"{text}, {written}({', '.join(f'{field}=…' for field in fields)})"


def _type_error(candidate: Any, bases: tuple[type, ...], wanted: str) -> Exception | None:
    """Return the error of a class that derives from none of `bases`; `wanted` begins with their kind.

    It is returned rather than raised, so that a program's traceback ends near the program's line.
    """
    if _is_subclass(candidate, bases):
        return None
    if not _is_subclass(candidate, _TYPES):
        article = "an" if wanted.startswith("a") else "a"
        return AttributeError(f"expected {article} {wanted}, got {_describe(candidate)}")
    kind = wanted.partition(" ")[0]
    others = " or ".join(other for other in ("message", "service", "action") if other != kind)
    return RuntimeError(f"The {kind} type provided is not valid ({candidate}), this might be a {others}")


def _is_subclass(candidate: Any, bases: tuple[type, ...]) -> bool:
    return isinstance(candidate, type) and issubclass(candidate, bases)


def _describe(candidate: Any) -> str:
    if isinstance(candidate, type):
        return f"the class {candidate.__module__}.{candidate.__qualname__}"
    given = given_text(candidate)
    is_object = isinstance(candidate, _TYPES)
    return f"{given}: give the class, {type(candidate).__name__}, without brackets" if is_object else given


if TYPE_CHECKING:
    from typing_extensions import TypeVar
else:

    def TypeVar(name: str, *, bound: object = None, **_: object) -> typing.TypeVar:  # noqa: N802  # typing_extensions' name
        """Make a type variable without its default, which `typing.TypeVar` does not take before Python 3.13."""
        return typing.TypeVar(name, bound=bound)


class WithDefaults:
    """Base of generic classes that programs give fewer types than they have variables: `ActionClient[G, R, F]`.

    For type checkers the variables' defaults are the others; here they have none.
    """

    if not TYPE_CHECKING:

        def __class_getitem__(cls, arguments: Any) -> Any:
            given = arguments if isinstance(arguments, tuple) else (arguments,)
            missing = len(cls.__parameters__) - len(given)
            return super().__class_getitem__((*given, *[Any] * missing))


T = TypeVar("T", default=Any)
MsgType = TypeVar("MsgType", bound=Message, default=Any)
SrvType = TypeVar("SrvType", bound=Service, default=Any)
SrvTypeRequest = TypeVar("SrvTypeRequest", default=Any)
SrvTypeResponse = TypeVar("SrvTypeResponse", default=Any)
GoalT = TypeVar("GoalT", default=Any)
ResultT = TypeVar("ResultT", default=Any)
FeedbackT = TypeVar("FeedbackT", default=Any)
FeedbackMessageT = TypeVar("FeedbackMessageT", default=Any)
"""The message that carries feedback, with `.goal_id` and `.feedback`."""
ResultResponseT = TypeVar("ResultResponseT", default=Any)
"""The response that carries a result, with `.status` and `.result`."""

# The same, by the names that later releases give them. What all messages, services or actions have is in these classes'
# bases; the carriers of an action are described by what programs read of them.

Msg = Message
Srv = Service
MsgT = TypeVar("MsgT", bound=Message, default=Any)
SrvT = TypeVar("SrvT", bound=Service, default=Any)
SrvRequestT = TypeVar("SrvRequestT", default=Any)
SrvResponseT = TypeVar("SrvResponseT", default=Any)
ActionT = TypeVar("ActionT", bound=Action, default=Any)
ImplT = TypeVar("ImplT", default=Any)
"""The class of an action that has its carriers, `Action.Impl`."""


class EventMessage(Protocol):
    """The event of a request or a response, as introspection publishes it."""

    info: ServiceEventInfo


class SendGoalServiceRequest(Protocol[GoalT]):
    """The request that carries a goal."""

    goal_id: UUID
    goal: GoalT


class SendGoalServiceResponse(Protocol):
    """The response that tells whether a goal was accepted."""

    accepted: bool
    stamp: Time


class GetResultServiceRequest(Protocol):
    """The request for the result of a goal."""

    goal_id: UUID


class GetResultServiceResponse(Protocol[ResultT]):
    """The response that carries a result."""

    status: int
    result: ResultT


class FeedbackMessage(Protocol[FeedbackT]):
    """The message that carries feedback."""

    goal_id: UUID
    feedback: FeedbackT


SendGoalService = Service[SendGoalServiceRequest[GoalT], SendGoalServiceResponse]
GetResultService = Service[GetResultServiceRequest, GetResultServiceResponse[ResultT]]
