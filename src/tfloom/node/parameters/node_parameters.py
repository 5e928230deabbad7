"""The parameters of a node."""

from __future__ import annotations

import threading
import warnings
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from tfloom.common.text import given_text
from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.parameters.exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from tfloom.node.parameters.parameter import (
    PARAMETER_SEPARATOR_STRING,
    Parameter,
    ParameterType,
    no_parameter_error,
)
from tfloom.node.parameters.parameter_declaration import (
    Declaration,
    declaration_error,
    full_name,
    read_declarations,
)
from tfloom.node.parameters.parameter_rules import check_against_descriptor
from tfloom.node.values.callback_errors import call_all

__all__ = ["NodeParameters", "validate_parameter_name"]

_SetCallback = Callable[[list[Parameter]], rcl_msg.SetParametersResult]
_PreCallback = Callable[[list[Parameter]], list[Parameter]]
_PostCallback = Callable[[list[Parameter]], None]


class NodeParameters:
    """The parameters of one node: declared, read and set. Node's methods of the same names describe each of these.

    Args:
        overrides: First values of parameters, by name.
        allow_undeclared: Whether parameters may be set that aren't declared.
        publish_event: Called with the new, changed and deleted parameters of each setting; it adds stamp and node.
    """

    def __init__(
        self,
        overrides: dict[str, Parameter],
        *,
        allow_undeclared: bool,
        publish_event: Callable[[rcl_msg.ParameterEvent], None],
    ) -> None:
        self.parameters: dict[str, Parameter] = {}
        """The declared parameters, by name. Changed under `_lock`, as `descriptors`; reading takes no lock."""
        self.descriptors: dict[str, rcl_msg.ParameterDescriptor] = {}
        """Their descriptors, by name."""
        self.overrides = overrides
        self.allow_undeclared = allow_undeclared
        self._publish_event = publish_event
        # Copied before they are called, because a callback, or another thread, may remove some.
        self.pre_set_callbacks: list[_PreCallback] = []
        self.on_set_callbacks: list[_SetCallback] = []
        self.post_set_callbacks: list[_PostCallback] = []
        self._lock = threading.RLock()
        """Held while parameters are declared, undeclared or set."""

    # Reading

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return name in self.parameters

    def get_parameter(self, name: str) -> Parameter:
        """Return a parameter."""
        parameter = self.parameters.get(name)
        if parameter is None:
            if self.allow_undeclared:
                return Parameter(name, ParameterType.NOT_SET, None)
            raise ParameterNotDeclaredException(name)
        if parameter.type_ is ParameterType.NOT_SET:
            descriptor = self.descriptors.get(name)
            if descriptor is None or not descriptor.dynamic_typing:  # None: undeclared meanwhile
                raise ParameterUninitializedException(name)
        return parameter

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return a parameter; if it is undeclared or has no value, the alternative (None: one without value)."""
        if alternative_value is None:
            alternative_value = Parameter(name, ParameterType.NOT_SET, None)
        parameter = self.parameters.get(name)
        if parameter is None or parameter.type_ is ParameterType.NOT_SET:
            return alternative_value
        return parameter

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters below a prefix (`a.b`; "" for all), by the part of their names after it."""
        if prefix:
            prefix += PARAMETER_SEPARATOR_STRING
        return {
            name[len(prefix) :]: parameter
            for name, parameter in list(self.parameters.items())
            if name.startswith(prefix)
        }

    def get_parameter_type(self, name: str) -> int:
        """Return the number of a parameter's type."""
        parameter = self.parameters.get(name)
        if parameter is not None:
            return parameter.type_.value
        if self.allow_undeclared:
            return ParameterType.NOT_SET.value
        raise ParameterNotDeclaredException(name)

    def get_parameter_types(self, names: list[str]) -> list[int]:
        """Return the types of parameters, each as `get_parameter_type` does."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter_type(name) for name in names]

    def describe_parameter(self, name: str) -> rcl_msg.ParameterDescriptor:
        """Return a parameter's descriptor."""
        descriptor = self.descriptors.get(name)
        if descriptor is not None:
            return descriptor
        if self.allow_undeclared:
            return rcl_msg.ParameterDescriptor()
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: list[str]) -> list[rcl_msg.ParameterDescriptor]:
        """Return the descriptors of parameters, each as `describe_parameter` does."""
        return [self.describe_parameter(name) for name in names]

    def list_parameters(self, prefixes: list[str], depth: int) -> rcl_msg.ListParametersResult:
        """Return the names below any of the prefixes ([]: all names), at most `depth` parts deep (0: no limit)."""
        if isinstance(prefixes, str) or not all(isinstance(prefix, str) for prefix in prefixes):
            raise TypeError("The prefixes argument must be a list of str")
        if not isinstance(depth, int):
            raise TypeError("The depth must be an int")
        if depth < 0:
            raise ValueError("The depth must be greater than or equal to zero")
        result = rcl_msg.ListParametersResult()
        for name in list(self.parameters):
            if any(_is_below(name, prefix, depth) for prefix in prefixes or [""]):
                result.names.append(name)
                parent = name.rpartition(PARAMETER_SEPARATOR_STRING)[0]
                if parent and parent not in result.prefixes:
                    result.prefixes.append(parent)
        return result

    # Declaring

    def declaration_error(self, namespace: str, parameters: Sequence[tuple[Any, ...]]) -> Exception | None:
        """Return what `declare_parameters` raises of its arguments, or None, for callers whose tracebacks are short."""
        if (error := declaration_error(namespace, parameters)) is not None:
            return error
        names = [full_name(namespace, entry[0]) for entry in parameters]
        if declared_names := [name for name in names if name in self.parameters]:
            return ParameterAlreadyDeclaredException(declared_names)
        return None if all(names) else InvalidParameterException("")

    def declare_parameters(
        self,
        namespace: str,
        parameters: Sequence[tuple[Any, ...]],
        ignore_override: bool = False,
    ) -> list[Parameter]:
        """Declare several parameters; each is a tuple of the first one to three arguments of `declare_parameter`."""
        declarations = read_declarations(namespace, parameters)
        with self._lock:
            declared_names = [
                declaration.name for declaration in declarations if declaration.name in self.parameters
            ]
            if declared_names:
                raise ParameterAlreadyDeclaredException(declared_names)
            for declaration in declarations:
                validate_parameter_name(declaration.name)
            for declaration in declarations:
                self._declare(declaration, ignore_override)
            return [self.parameters[declaration.name] for declaration in declarations]

    def _declare(self, declaration: Declaration, ignore_override: bool) -> None:
        parameter = Parameter(declaration.name, value=declaration.default)
        if not ignore_override and declaration.name in self.overrides:
            parameter = self.overrides[declaration.name]
        descriptor = declaration.descriptor
        if parameter.value == [] and descriptor.type > ParameterType.BYTE_ARRAY.value:
            # An empty list in YAML doesn't tell the type of its items.
            parameter = Parameter(parameter.name, ParameterType(descriptor.type), [])
        if parameter.type_ is ParameterType.NOT_SET:
            descriptor.name = parameter.name
            self.descriptors[parameter.name] = descriptor
            self.parameters[parameter.name] = parameter
            return
        result = self._apply([parameter], {parameter.name: descriptor})
        if result.successful:
            return
        if result.reason.startswith("Wrong parameter type"):
            raise InvalidParameterTypeException(parameter, ParameterType(descriptor.type).name)
        raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)

    def undeclare_parameter(self, name: str) -> None:
        """Remove a parameter."""
        with self._lock:
            if name not in self.parameters:
                raise ParameterNotDeclaredException(name)
            if self.descriptors[name].read_only:
                raise ParameterImmutableException(name)
            del self.parameters[name]
            del self.descriptors[name]

    # Setting

    def setting_error(self, parameters: Sequence[Parameter]) -> Exception | None:
        """Return the error of parameters that can't be set, or None, for callers whose tracebacks shall be short."""
        if (error := no_parameter_error(parameters)) is not None:
            return error
        if self.allow_undeclared:
            return None
        undeclared_names = [
            parameter.name for parameter in parameters if parameter.name not in self.parameters
        ]
        return ParameterNotDeclaredException(undeclared_names) if undeclared_names else None

    def set_atomically(self, parameters: list[Parameter]) -> rcl_msg.SetParametersResult:
        """Set all parameters, or none of them if one is rejected; `setting_error` has none of them."""
        with self._lock:
            for pre_callback in list(self.pre_set_callbacks):
                parameters = pre_callback(parameters)
                if not parameters:
                    reason = (
                        "parameter list cannot be empty, this might be due to pre_set_parameters_callback "
                        "modifying the original parameters list."
                    )
                    return rcl_msg.SetParametersResult(successful=False, reason=reason)
            if (error := self.setting_error(parameters)) is not None:
                raise error
            descriptors = {parameter.name: self._descriptor_for(parameter.name) for parameter in parameters}
            return self._apply(parameters, descriptors, check_read_only=True)

    def _descriptor_for(self, name: str) -> rcl_msg.ParameterDescriptor:
        return self.descriptors.get(name) or rcl_msg.ParameterDescriptor(name=name, dynamic_typing=True)

    def _apply(
        self,
        parameters: list[Parameter],
        descriptors: dict[str, rcl_msg.ParameterDescriptor],
        *,
        check_read_only: bool = False,
    ) -> rcl_msg.SetParametersResult:
        """Set the parameters if their descriptors and all callbacks allow it, and publish the change."""
        # Until every check and callback has accepted all of them, nothing is stored: the setting is all or nothing.
        for parameter in parameters:
            reason = check_against_descriptor(
                parameter, descriptors[parameter.name], check_read_only=check_read_only
            )
            if reason is not None:
                return rcl_msg.SetParametersResult(successful=False, reason=reason)
        result = rcl_msg.SetParametersResult(successful=True)
        for callback in list(self.on_set_callbacks):
            result = _answer(callback, parameters)
            if not result.successful:
                return result
        event = rcl_msg.ParameterEvent()
        for parameter in parameters:
            self._store(parameter, descriptors[parameter.name], event)
        self._publish_event(event)
        # The parameters are set: each callback is called, and one that raises is reported by its exception.
        call_all([partial(callback, parameters) for callback in self.post_set_callbacks])
        return result

    def _store(
        self, parameter: Parameter, descriptor: rcl_msg.ParameterDescriptor, event: rcl_msg.ParameterEvent
    ) -> None:
        name = parameter.name
        old = self.parameters.get(name)
        was_set = old is not None and old.type_ is not ParameterType.NOT_SET
        if parameter.type_ is ParameterType.NOT_SET:
            self.parameters.pop(name, None)
            self.descriptors.pop(name, None)
            if was_set:
                event.deleted_parameters.append(parameter.to_parameter_msg())
            return
        self.parameters[name] = parameter
        descriptor.name = name
        if descriptor.dynamic_typing or descriptor.type == ParameterType.NOT_SET.value:
            descriptor.type = parameter.type_.value
        self.descriptors[name] = descriptor
        changes = event.changed_parameters if was_set else event.new_parameters
        changes.append(parameter.to_parameter_msg())

    def set_descriptor(
        self,
        name: str,
        descriptor: rcl_msg.ParameterDescriptor,
        alternative_value: rcl_msg.ParameterValue | None = None,
    ) -> rcl_msg.ParameterValue:
        """Replace a parameter's descriptor, and return the parameter's new value."""
        with self._lock:
            if name not in self.parameters:
                if not self.allow_undeclared:
                    raise ParameterNotDeclaredException(name)
                return Parameter(name).get_parameter_value()
            if self.describe_parameter(name).read_only:
                raise ParameterImmutableException(name)
            current = self.parameters[name]
            target = current
            if alternative_value is not None:
                as_msg = rcl_msg.Parameter(name=name, value=alternative_value)
                target = Parameter.from_parameter_msg(as_msg)
            if not descriptor.dynamic_typing and descriptor.type == ParameterType.NOT_SET.value:
                descriptor.type = target.type_.value
            result = self._apply([target], {name: descriptor})
            if not result.successful:
                raise InvalidParameterValueException(name, target.value, result.reason)
            return self.parameters[name].get_parameter_value()

    # Callbacks

    def add_pre_set_parameters_callback(self, callback: _PreCallback) -> None:
        """Set what `callback(parameters)` returns instead of `parameters`; the last added is called first."""
        self.pre_set_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: _SetCallback) -> None:
        """Set and declare only what `callback(parameters)` accepts; the last added is called first."""
        self.on_set_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: _PostCallback) -> None:
        """Call `callback(parameters)` after each setting; the last added is called first."""
        self.post_set_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: _PreCallback) -> None:
        """Undo one `add_pre_set_parameters_callback`."""
        self.pre_set_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: _SetCallback) -> None:
        """Undo one `add_on_set_parameters_callback`."""
        self.on_set_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: _PostCallback) -> None:
        """Undo one `add_post_set_parameters_callback`."""
        self.post_set_callbacks.remove(callback)


def _answer(callback: _SetCallback, parameters: list[Parameter]) -> rcl_msg.SetParametersResult:
    result: Any = callback(parameters)
    if isinstance(result, rcl_msg.SetParametersResult):
        return result
    name = getattr(callback, "__qualname__", repr(callback))
    warnings.warn(
        f"Callback returned an invalid type, it should return SetParametersResult: {name}, which was given to "
        f"add_on_set_parameters_callback(), returned {given_text(result)}: "
        "write return SetParametersResult(successful=True)",
        stacklevel=2,
    )
    return rcl_msg.SetParametersResult(successful=False, reason="Callback returned an invalid type")


def _is_below(name: str, prefix: str, depth: int) -> bool:
    if prefix:
        if name == prefix:
            return True
        if not name.startswith(prefix + PARAMETER_SEPARATOR_STRING):
            return False
        name = name[len(prefix) + 1 :]
    return depth == 0 or name.count(PARAMETER_SEPARATOR_STRING) < depth


def validate_parameter_name(name: str) -> bool:
    """Return True for a valid parameter name: any text that isn't empty.

    Raises:
        InvalidParameterException: it is empty.
    """
    if not name:
        raise InvalidParameterException(name)
    return True
