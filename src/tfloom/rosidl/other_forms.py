"""Messages that Lyrical defines otherwise than the distributions before it, read in either form.

On DDS such a message reaches every subscription, because topics match by the type's name alone, and both forms may have
the same size: it would be read without an error and with wrong values. So its sender's hash decides how it is read.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from tfloom.rosidl.sources import Source

__all__ = ["FORMS", "Form", "converted", "forms_beside", "source_of"]

NS_PER_S = 1_000_000_000
MAX_SEC = 2**31 - 1


class Form:
    """One form of a definition.

    Attributes:
        type_hash: Its hash.
        where: The distributions that have it.
        field: The field by which it is recognised.
    """

    def __init__(self, type_hash: str, where: str, field: str) -> None:
        self.type_hash = type_hash
        self.where = where
        self.field = field

    def __str__(self) -> str:
        return f"with '{self.field}', as {self.where}"


FORMS = {
    "lifecycle_msgs/msg/TransitionEvent": (
        Form(
            "RIHS01_d5f8873a2f0146498f812d7885c7327ce27e463d36811d8792f35ee38c0d6c38",
            "up to Kilted",
            "timestamp",
        ),
        Form(
            "RIHS01_78b19e2be41a797fc009c96bda68944182edabec7852cccd928a40bc06f6f9d7",
            "from Lyrical on",
            "stamp",
        ),
    )
}
"""The older form and the newer one of each message that has two, by its type."""


def forms_beside(type_name: str, type_hash: str) -> tuple[Form, Form] | None:
    """Return the form that has this hash, and the other one; None for a type with one form, or a hash of neither."""
    older, newer = FORMS.get(type_name, (None, None))
    if older is None or newer is None or type_hash not in (older.type_hash, newer.type_hash):
        return None
    return (older, newer) if type_hash == older.type_hash else (newer, older)


def source_of(type_name: str, type_hash: str) -> Source:
    """Return the text of a form, by the hash of one of FORMS."""
    from tfloom.rosidl.definition_files import forms_of
    from tfloom.rosidl.sources import read_source

    number = [form.type_hash for form in FORMS[type_name]].index(type_hash)
    return read_source(forms_of(type_name)[number])


def converted(type_name: str, other: Form, data: bytes) -> bytes:
    """Return a message as bytes of the form that its class has here.

    Args:
        type_name: Its type.
        other: The form that it has.
        data: Its bytes: encapsulation header and CDR.

    Raises:
        DecodeError: the bytes are not of that form.
    """
    from tfloom.rosidl import cdr
    from tfloom.rosidl.recorded import recorded_class
    from tfloom.rosidl.registry import get_message_class

    text = source_of(type_name, other.type_hash).text
    message = cdr.decode(recorded_class(type_name, "ros2msg", text, other.type_hash), data)
    ours = get_message_class(type_name)()
    for field in ours._FIELDS:
        if field in message._FIELDS:
            setattr(ours, field, getattr(message, field))
    _set_time(ours, message)
    return cdr.encode(ours)


def _set_time(ours: Any, theirs: Any) -> None:
    """Set the time of an event: from Lyrical on a message, before a count of nanoseconds; each within its range."""
    if "stamp" in ours._FIELDS:
        sec, ours.stamp.nanosec = divmod(theirs.timestamp, NS_PER_S)
        ours.stamp.sec = min(sec, MAX_SEC)
    else:
        ours.timestamp = max(0, theirs.stamp.sec * NS_PER_S + theirs.stamp.nanosec)
