"""The base of all message classes.

A message class states its type in `_TYPE_NAME`, `_TYPE_HASH`, `_FIELDS` and `_DEFAULTS`, and has a slot `_x` for each
field `x`. Everything else, such as construction and the codec's plan, is derived from these at first use.
"""

from __future__ import annotations

import os

from tfloom._native import check_fields_by_default, set_message_hooks
from tfloom.rosidl.class_table import set_message_base
from tfloom.rosidl.type_text import ARRAY_CODES

TYPE_CHECKING = False
if TYPE_CHECKING:
    MessageBase = object  # its native __setattr__ would let type checkers accept any attribute
    from typing import Any, ClassVar

    from typing_extensions import Self

    from tfloom._native import Plan
    from tfloom.rosidl.definition import AbstractType
    from tfloom.rosidl.spec import Value
else:
    from tfloom._native import MessageBase


class _SlotTypes:
    """`SLOT_TYPES`: the type of each field as an object of `tfloom.rosidl.definition`, made on access."""

    def __get__(self, instance: object, owner: type[Message]) -> tuple[AbstractType, ...]:
        from tfloom.rosidl.definition import to_type
        from tfloom.rosidl.parse import parse_type

        return tuple(to_type(parse_type(text)) for text in owner._FIELDS.values())


class _FieldTypes:
    """`_fields_and_field_types`: what `get_fields_and_field_types` returns, by the name that programs read, too."""

    def __get__(self, instance: object, owner: type[Message]) -> dict[str, str]:
        return owner.get_fields_and_field_types()


class _Default:
    """`X__DEFAULT`: what field `x`, whose definition has a default, holds in a new message."""

    def __init__(self, field: str) -> None:
        self._field = field

    def __get__(self, instance: object, owner: type[Message]) -> Any:
        return getattr(owner(), self._field)


class _MessageType(type):
    """The class of message classes: constants of their definitions, and `X__DEFAULT`, can't be assigned."""

    def __setattr__(cls, name: str, value: object) -> None:
        # Definitions spell constants, and nothing else, in capitals. A class that derives from a message's may have
        # its own names.
        if name.isupper() and (home := _home_of_constant(cls, name)) is not None:
            raise AttributeError(f"property '{name}' of 'Metaclass_{home.__name__}' object has no setter")
        super().__setattr__(name, value)

    def __delattr__(cls, name: str) -> None:
        if name.isupper() and (home := _home_of_constant(cls, name)) is not None:
            raise AttributeError(f"property '{name}' of 'Metaclass_{home.__name__}' object has no deleter")
        super().__delattr__(name)


def _home_of_constant(cls: type, name: str) -> type | None:
    """Return the class among a message class and its bases whose definition has a constant; None if none has it."""
    if name.startswith("_"):
        return None
    return next((base for base in cls.__mro__ if name in vars(base) and "_FIELDS" in vars(base)), None)


class Message(MessageBase, metaclass=_MessageType):
    """A ROS message: a plain object with a slot for each field.

    A numeric sequence is an `array.array`, a numeric array of fixed length a numpy array; values assigned to one are
    converted. Values of other fields are stored unchanged and checked when the message is encoded, or on assignment
    with `check_fields=True` or with `ROS_PYTHON_CHECK_FIELDS=1` in the environment.
    """

    __slots__: Any = ()
    __hash__ = None  # type: ignore[assignment]

    _TYPE_NAME: ClassVar[str] = ""
    _TYPE_HASH: ClassVar[str] = ""
    _FIELDS: ClassVar[dict[str, str]] = {}
    """The type of each field, as a definition writes it, with full message names."""
    _DEFAULTS: ClassVar[dict[str, Value]] = {}
    """The default of each field whose definition has one."""
    _PLAN: ClassVar[Plan | None] = None
    _check_fields: bool
    SLOT_TYPES = _SlotTypes()
    _fields_and_field_types = _FieldTypes()

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        if "_FIELDS" not in cls.__dict__:
            return
        set_attribute = type.__setattr__  # without the check, because a program's start sets thousands
        for name, type_text in cls._FIELDS.items():
            member = cls.__dict__[f"_{name}"]
            set_attribute(cls, name, _converting(name, member) if _is_numeric_array(type_text) else member)
        for name in cls._DEFAULTS:
            set_attribute(cls, f"{name.upper()}__DEFAULT", _Default(name))
        set_attribute(cls, "__slots__", [*(f"_{name}" for name in cls._FIELDS), "_check_fields"])
        set_attribute(cls, "_PLAN", None)

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Return the type of each field, by IDL names: `double`, `sequence<uint8>`, `geometry_msgs/Vector3`."""
        from tfloom.rosidl.parse import parse_type
        from tfloom.rosidl.spec import idl_name

        return {name: idl_name(parse_type(text)) for name, text in cls._FIELDS.items()}

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return False
        return all(_equal(getattr(self, name), getattr(other, name)) for name in self._FIELDS)

    def __repr__(self) -> str:
        package, kind, name = self._TYPE_NAME.split("/")
        fields = ", ".join(
            f"{field}={_field_repr(kind, getattr(self, field))}" for field, kind in self._FIELDS.items()
        )
        return f"{package}.{kind}.{name}({fields})"

    def _repr_html_(self) -> str:
        """Return what a notebook shows."""
        from tfloom.rosidl.html import message_html

        return message_html(self)


def _is_numeric_array(type_text: str) -> bool:
    return type_text.endswith("]") and type_text.partition("[")[0] in ARRAY_CODES


def _converting(name: str, member: Any) -> property:
    """Make the property of a numeric array, which converts values on assignment."""

    def assign(self: Message, value: object) -> None:
        member.__set__(self, _convert(type(self), name, value))

    return property(member.__get__, assign)


def _equal(ours: Any, theirs: Any) -> bool:
    # A number of numpy has the shape (), and equals the number of Python that it stands for.
    if getattr(ours, "shape", ()) or getattr(theirs, "shape", ()):
        from tfloom.rosidl.arrays import are_equal

        return are_equal(ours, theirs)
    same = ours == theirs
    # numpy compares a number with each element of a list.
    return same if isinstance(same, bool) else not getattr(same, "shape", ()) and bool(same)


def _field_repr(type_text: str, value: object) -> str:
    """Return the repr of a field's value; of a numeric sequence, that of a list."""
    if type(value).__name__ == "array" and _is_numeric_array(type_text):
        return repr(value.tolist())  # type: ignore[attr-defined]
    return repr(value)


def _convert(cls: type[Message], name: str, value: object) -> object:
    from tfloom.rosidl.arrays import convert

    kind = cls._FIELDS[name]
    try:
        return convert(kind, value)
    except (TypeError, ValueError, OverflowError) as error:
        # A derived class is one of the value's own, or a UnicodeError.
        if type(error) not in (TypeError, ValueError, OverflowError):
            raise
        from tfloom.common.text import given_text

        raise type(error)(f"{error}: {cls.__name__}.{name} is {kind}, got {given_text(value)}") from None


def _compile(cls: type[Message]) -> Plan:
    from tfloom.rosidl.plans import compile_plan

    return compile_plan(cls)


def _check(cls: type[Message], name: str, value: object) -> None:
    from tfloom.rosidl.checks import check_field

    check_field(cls, name.removeprefix("_"), value)


def _check_names(cls: type[Message], kwargs: dict[str, object]) -> None:
    from tfloom.rosidl.checks import check_names

    check_names(cls, kwargs)


def _warn_names(cls: type[Message], kwargs: dict[str, object]) -> None:
    from tfloom.rosidl.checks import warn_of_unknown_names

    warn_of_unknown_names(cls, kwargs)


class EncodeError(ValueError):
    """A message holds a value that does not fit its field's type. The text starts with the field's path."""

    path: str
    """`TransformStamped.transform.translation.x`"""
    reason: str
    offset: None

    def __new__(cls, text: str = "") -> Self:
        """Return an error, which is also a UnicodeEncodeError, as in rclpy, where a text is not valid Unicode."""
        if cls is EncodeError and " text without lone surrogates" in text:
            return UnicodeEncodeError.__new__(_UnencodableTextError)  # type: ignore[return-value]  # a subclass
        return super().__new__(cls, text)


class _UnencodableTextError(EncodeError, UnicodeEncodeError):
    """A message holds a text that UTF-8 can't encode."""

    def __init__(self, text: str) -> None:
        UnicodeEncodeError.__init__(self, "utf-8", "", 0, 1, text)
        self._text = text

    def __str__(self) -> str:
        return self._text


class DecodeError(ValueError):
    """Bytes are not a message of the type. The text starts with the path of the field that can't be decoded."""

    path: str
    reason: str
    offset: int
    """Offset at which decoding failed [bytes from the start of the encapsulation header]."""


set_message_base(Message)
set_message_hooks(
    compile=_compile,
    convert=_convert,
    check=_check,
    check_names=_check_names,
    warn_names=_warn_names,
    encode_error=EncodeError,
    decode_error=DecodeError,
)
check_fields_by_default(os.environ.get("ROS_PYTHON_CHECK_FIELDS") == "1")
