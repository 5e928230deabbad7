"""Interface definitions as plain values: types, fields, constants, messages, services, actions."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

INTEGER_RANGES = {
    "int8": (-(2**7), 2**7 - 1),
    "uint8": (0, 2**8 - 1),
    "int16": (-(2**15), 2**15 - 1),
    "uint16": (0, 2**16 - 1),
    "int32": (-(2**31), 2**31 - 1),
    "uint32": (0, 2**32 - 1),
    "int64": (-(2**63), 2**63 - 1),
    "uint64": (0, 2**64 - 1),
    "char": (0, 2**8 - 1),
    "byte": (0, 2**8 - 1),
}
"""Least and greatest value of each integer type. `char` is a uint8, and `byte` an octet."""
FLOATS = frozenset({"float32", "float64"})
STRINGS = frozenset({"string", "wstring"})
PRIMITIVES = frozenset({"bool", *INTEGER_RANGES, *FLOATS, *STRINGS})
IDL_PRIMITIVES = {
    "bool": "boolean",
    "byte": "octet",
    "char": "uint8",
    "float32": "float",
    "float64": "double",
}
"""The primitives with another name in IDL."""

EMPTY_FIELD = "structure_needs_at_least_one_member"
"""The uint8 that represents a message without fields on the wire and in the hash."""

Value: TypeAlias = bool | int | float | str | bytes | list["Value"] | None
"""A default or a constant."""


class Type(NamedTuple):
    """The type of a field or a constant."""

    base: str
    """A primitive's name, or a message's: `geometry_msgs/msg/Point`."""
    string_bound: int = 0
    """Greatest length of a string [characters]; 0 if unbounded."""
    shape: str = ""
    """Empty for a single value, `array`, `bounded` or `unbounded`."""
    length: int = 0
    """Length of an array, or the bound of a bounded sequence."""

    @property
    def is_primitive(self) -> bool:
        """Whether the base is a primitive, not a message."""
        return self.base in PRIMITIVES

    @property
    def element(self) -> Type:
        """The type of an element: the same type without its shape."""
        return Type(self.base, self.string_bound)

    def __str__(self) -> str:
        """Return the type as a definition writes it, with full message names."""
        bound = f"<={self.string_bound}" if self.string_bound else ""
        shape = {"": "", "array": f"[{self.length}]", "bounded": f"[<={self.length}]", "unbounded": "[]"}
        return f"{self.base}{bound}{shape[self.shape]}"


class Field(NamedTuple):
    """A field of a message."""

    name: str
    type: Type
    default: Value = None
    """None if the definition has none."""
    comment: str = ""
    position: tuple[int, int] = (0, 0)
    """Line and column of the field's type, for errors."""


class Constant(NamedTuple):
    """A constant of a message."""

    name: str
    type: Type
    value: Value
    comment: str = ""


class Message(NamedTuple):
    """A message, or one part of a service or an action."""

    name: str
    """`geometry_msgs/msg/Point`, `turtlesim/srv/Spawn_Request`."""
    fields: tuple[Field, ...]
    constants: tuple[Constant, ...] = ()
    comment: str = ""

    @property
    def wire_fields(self) -> tuple[Field, ...]:
        """The fields, or `EMPTY_FIELD` where there are none."""
        return self.fields or (Field(EMPTY_FIELD, Type("uint8")),)

    @property
    def references(self) -> list[str]:
        """The names of the message types of its fields, each once, in order of appearance."""
        return list(dict.fromkeys(f.type.base for f in self.fields if not f.type.is_primitive))


class Service(NamedTuple):
    """A service: request, response, and the event that introspection publishes."""

    name: str
    request: Message
    response: Message
    event: Message

    @property
    def messages(self) -> tuple[Message, ...]:
        """All of its messages."""
        return (self.request, self.response, self.event)


class Action(NamedTuple):
    """An action: goal, result and feedback, and the services and message that carry them."""

    name: str
    goal: Message
    result: Message
    feedback: Message
    send_goal: Service
    get_result: Service
    feedback_message: Message

    @property
    def messages(self) -> tuple[Message, ...]:
        """All of its messages."""
        return (
            *(self.goal, self.result, self.feedback),
            *self.send_goal.messages,
            *self.get_result.messages,
            self.feedback_message,
        )


Interface: TypeAlias = Message | Service | Action


def messages_of(interface: Interface) -> tuple[Message, ...]:
    """Return the messages that an interface consists of."""
    return (interface,) if isinstance(interface, Message) else interface.messages


def service(name: str, request: Message, response: Message) -> Service:
    """Complete a service with its event message."""
    event = Message(
        f"{name}_Event",
        (
            Field("info", Type("service_msgs/msg/ServiceEventInfo")),
            Field("request", Type(request.name, shape="bounded", length=1)),
            Field("response", Type(response.name, shape="bounded", length=1)),
        ),
    )
    return Service(name, request, response, event)


def action(name: str, goal: Message, result: Message, feedback: Message) -> Action:
    """Complete an action with the services and the message that carry it."""
    goal_id = Field("goal_id", Type("unique_identifier_msgs/msg/UUID"))
    stamp = Field("stamp", Type("builtin_interfaces/msg/Time"))

    def part(suffix: str, *fields: Field) -> Message:
        return Message(f"{name}_{suffix}", fields)

    return Action(
        name,
        goal,
        result,
        feedback,
        service(
            f"{name}_SendGoal",
            part("SendGoal_Request", goal_id, Field("goal", Type(goal.name))),
            part("SendGoal_Response", Field("accepted", Type("bool")), stamp),
        ),
        service(
            f"{name}_GetResult",
            part("GetResult_Request", goal_id),
            part("GetResult_Response", Field("status", Type("int8")), Field("result", Type(result.name))),
        ),
        part("FeedbackMessage", goal_id, Field("feedback", Type(feedback.name))),
    )


def idl_name(type_: Type) -> str:
    """Return `double[36]`, `sequence<uint8>`, `sequence<double, 3>`, `string<255>`, `geometry_msgs/Vector3`."""
    base = IDL_PRIMITIVES.get(type_.base, type_.base)
    if not type_.is_primitive:
        package, _, name = type_.base.split("/")
        base = f"{package}/{name}"
    if type_.string_bound:
        base = f"{base}<{type_.string_bound}>"
    if type_.shape == "array":
        return f"{base}[{type_.length}]"
    if type_.shape == "bounded":
        return f"sequence<{base}, {type_.length}>"
    return f"sequence<{base}>" if type_.shape else base
