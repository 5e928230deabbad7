"""IDL names of field types, as `get_fields_and_field_types` returns them."""

from __future__ import annotations

from tfloom.rosidl.spec import Type

PRIMITIVES = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}
"""The primitives with another name in IDL."""


def idl_name(type_: Type) -> str:
    """Return `double[36]`, `sequence<uint8>`, `sequence<double, 3>`, `string<255>`, `geometry_msgs/Vector3`."""
    base = PRIMITIVES.get(type_.base, type_.base)
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
