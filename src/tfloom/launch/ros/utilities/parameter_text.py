"""Values of parameters as texts on a command line and in parameter files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

__all__ = ["as_yaml", "parameter_file_text", "parameter_rule"]


def as_yaml(value: Any) -> str:
    """Return a value as YAML on one line, without the end of the document."""
    import yaml

    text = yaml.safe_dump(_as_list(value), default_flow_style=True, allow_unicode=True, width=10**9)
    return text.removesuffix("\n").removesuffix("\n...")


def parameter_rule(name: str, value: Any) -> str:
    """Return `name:=value` for the option -p, such that the value is read with its type.

    Python's text is used where YAML reads the same value from it.
    """
    from tfloom.rosidl.user_yaml import YamlError, load

    text = str(_as_list(value))
    try:
        read = load(text)
    except YamlError:
        read = None
    same = type(read) is type(_as_list(value)) and read == _as_list(value)
    return f"{name}:={text if same else as_yaml(value)}"


def parameter_file_text(node: str, parameters: Mapping[str, Any]) -> str:
    """Return the content of a file with the parameters of a node; the node `/**` is each one."""
    import yaml

    values = {name: _as_list(value) for name, value in parameters.items()}
    return yaml.safe_dump({node: {"ros__parameters": values}}, default_flow_style=False, allow_unicode=True)


def _as_list(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value
