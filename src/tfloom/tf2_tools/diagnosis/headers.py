"""Types whose messages begin with a header."""

from __future__ import annotations


def begins_with_header(type_name: str) -> bool:
    """Return whether the messages of a type begin with a std_msgs/msg/Header; False if the type is unknown here."""
    from tfloom.rosidl.registry import get_message_class

    try:
        fields = get_message_class(type_name).get_fields_and_field_types()
    except (LookupError, ValueError):
        return False
    return next(iter(fields.values()), "") == "std_msgs/Header"
