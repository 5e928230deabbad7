"""How a tag gets its action, and a name after `$(` its substitution.

Other packages add tags and substitutions by entry points.
"""

from __future__ import annotations

import functools
import importlib
import warnings
from collections.abc import Callable, Iterable, Mapping
from types import FunctionType, MethodType
from typing import Any, TypeVar

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.frontend.exposed import ACTION_MODULES, SUBSTITUTION_MODULES
from tfloom.launch.utilities.texts import did_you_mean
from tfloom.ros_imports.distributions import may_have_entry_points

__all__ = [
    "action_parse_methods",
    "expose_action",
    "expose_substitution",
    "instantiate_action",
    "instantiate_substitution",
    "load_entry_points",
    "load_launch_extensions",
    "substitution_parse_methods",
]

_OF_ROS_1 = {
    "arg": "; that is of ROS 1: write $(var NAME)",
    "find": "; that is of ROS 1: write $(find-pkg-share PACKAGE)",
    "optenv": "; that is of ROS 1: write $(env NAME DEFAULT)",
}
"""What ROS 2 has in place of substitutions of ROS 1."""
_TAGS_OF_ROS_1 = {
    "param": "; that is of ROS 1: write <set_parameter name=… value=…/>, or <param> within <node>",
    "remap": "; that is of ROS 1: write <set_remap from=… to=…/>, or <remap> within <node>",
    "rosparam": "; that is of ROS 1: write <param from=…/> within <node>",
    "test": "; that is of ROS 1: write a Python file with generate_test_description(), for launch_testing",
}
"""What ROS 2 has in place of tags of ROS 1."""
_Exposed = TypeVar("_Exposed", bound=Callable[..., Any])

action_parse_methods: dict[str, Any] = {}
"""Method of each tag that has been exposed so far: it returns an action's class and the constructor's arguments."""
substitution_parse_methods: dict[str, Any] = {}
"""Method of each substitution that has been exposed so far: it returns its class and the constructor's arguments."""


def instantiate_action(entity: Entity, parser: ParsesActions) -> Any:
    """Return the action of an element.

    Args:
        entity: The element.
        parser: The parser of its file.

    Raises:
        RuntimeError: no action is exposed for its tag.
        ValueError: it has attributes or elements that the action does not have.
    """
    parse = _parse_method(entity.type_name, action_parse_methods, ACTION_MODULES)
    if parse is None:
        known = {*action_parse_methods, *ACTION_MODULES}
        near = _TAGS_OF_ROS_1.get(entity.type_name) or did_you_mean(entity.type_name, known)
        raise RuntimeError(f"Unrecognized entity of the type: {entity.type_name}{near}")
    action_type, kwargs = parse(entity, parser)
    return action_type(**kwargs)


def instantiate_substitution(
    type_name: str, args: Iterable[SomeSubstitutionsType] | None = None
) -> Substitution:
    """Return the substitution of a name.

    Args:
        type_name: The name.
        args: What follows it, each argument as a list of substitutions.

    Raises:
        RuntimeError: no substitution is exposed with the name.
    """
    parse = _parse_method(type_name, substitution_parse_methods, SUBSTITUTION_MODULES)
    if parse is None:
        known = {*substitution_parse_methods, *SUBSTITUTION_MODULES}
        near = _OF_ROS_1.get(type_name) or did_you_mean(type_name, known)
        raise RuntimeError(f"Unknown substitution: {type_name}{near}")
    substitution_type, kwargs = parse([] if args is None else list(args))
    positional = kwargs.pop("args") if _takes_any_number(substitution_type) and "args" in kwargs else ()
    substitution: Substitution = substitution_type(*positional, **kwargs)
    return substitution


def expose_substitution(name: str) -> Callable[[_Exposed], _Exposed]:
    """Return a decorator for a substitution of launch files.

    It decorates a class with a class method `parse(data)`, or a function like this method, which returns the class and
    the keyword arguments of its constructor. `data` has the arguments in `$(name arg arg)`: lists of substitutions.

    Args:
        name: The name after `$(`.
    """
    return _expose(name, substitution_parse_methods, SUBSTITUTION_MODULES, "substitution")


def expose_action(name: str) -> Callable[[_Exposed], _Exposed]:
    """Return a decorator for an action of launch files.

    It decorates a class with a class method `parse(entity, parser)`, or a function like this method, which returns the
    class and the keyword arguments of its constructor.

    Args:
        name: The tag.
    """
    return _expose(name, action_parse_methods, ACTION_MODULES, "action")


def __expose_impl(
    name: str, parse_methods_map: dict[str, Any], exposed_type: str
) -> Callable[[_Exposed], _Exposed]:
    """Return a decorator that exposes in a dictionary of the caller's own; tests of other parsers use it.

    Args:
        name: The tag, or the name after `$(`.
        parse_methods_map: Gets the method.
        exposed_type: "action" or "substitution".
    """
    return _expose(name, parse_methods_map, {}, exposed_type)


def _parse_method(name: str, methods: Mapping[str, Any], modules: Mapping[str, str]) -> Any:
    """Return the method of a name, or None; modules are imported if it has not been exposed yet."""
    if name not in methods:
        if name in modules:
            importlib.import_module(modules[name])
        else:
            load_launch_extensions()
    return methods.get(name)


def _expose(
    name: str, methods: dict[str, Any], modules: Mapping[str, str], kind: str
) -> Callable[[_Exposed], _Exposed]:
    def decorator(exposed: _Exposed) -> _Exposed:
        parse = _method_of(exposed, name, kind)
        former_method = methods.get(name)
        owner = modules.get(name, exposed.__module__)
        if owner != exposed.__module__ or (
            former_method is not None and getattr(former_method, "__wrapped__", former_method) != parse
        ):
            raise RuntimeError(f"Two {kind} parsing methods exposed with the same name: [{name}].")
        methods[name] = _with_completeness_check(parse) if kind == "action" else parse
        return exposed

    return decorator


def _method_of(exposed: Callable[..., Any], name: str, kind: str) -> Callable[..., Any]:
    if isinstance(exposed, type):
        parse = getattr(exposed, "parse", None)
        if isinstance(parse, MethodType):
            return parse
        raise RuntimeError("Did not find a class method called 'parse' in the class being decorated.")
    if isinstance(exposed, FunctionType):
        return exposed
    raise RuntimeError(
        f"Exposed {kind} parser for {name} is not a callable or a class containing a parse method"
    )


def _with_completeness_check(parse: Callable[..., Any]) -> Callable[..., Any]:
    """Return an action's method that also checks that the action has read all of the element."""

    @functools.wraps(parse)
    def checked(entity: Entity, parser: ParsesActions) -> Any:
        result = parse(entity, parser)
        entity.assert_entity_completely_parsed()
        return result

    return checked


def _takes_any_number(substitution_type: Any) -> bool:
    """Return whether the constructor has `*args`, to which `args` of the keyword arguments then refer."""
    code = getattr(getattr(substitution_type, "__init__", None), "__code__", None)
    if code is None or not code.co_flags & 0x04:  # CO_VARARGS
        return False
    return bool(code.co_varnames[code.co_argcount + code.co_kwonlyargcount] == "args")


_loaded = False


def load_launch_extensions() -> None:
    """Import all modules of the entry points `launch.frontend.launch_extension`, at the first call.

    They expose actions and substitutions. One that cannot be imported is reported by a warning.
    """
    global _loaded  # noqa: PLW0603  # all of the process shares what they expose
    if not _loaded:
        _loaded = True
        load_entry_points("launch.frontend.launch_extension")


def load_entry_points(group: str) -> dict[str, Any]:
    """Return the objects of all entry points of a group, by their names. One that fails is reported by a warning."""
    if not may_have_entry_points(group):
        return {}
    from importlib.metadata import entry_points

    loaded = {}
    for entry_point in entry_points(group=group):
        try:
            loaded[entry_point.name] = entry_point.load()
        except Exception as error:  # of any package
            what = f"the extension '{entry_point.name}' of {group} ({entry_point.value})"
            warnings.warn(f"Failed to load {what}: {type(error).__name__}: {error}", stacklevel=3)
    return loaded
