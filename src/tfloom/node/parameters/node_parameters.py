"""Declaration and setting of a node's parameters."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.parameters.declared_parameters import DeclaredParameters
from tfloom.node.parameters.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
)
from tfloom.node.parameters.parameter import Parameter, ParameterType
from tfloom.node.parameters.parameter_declaration import Declaration, read_declarations
from tfloom.node.parameters.parameter_rules import check_against_descriptor
from tfloom.node.parameters.validate_parameter_name import validate_parameter_name
from tfloom.node.values.call_all import call_all
from tfloom.node.values.set_by_init import SET_BY_INIT

__all__ = ["NodeParameters"]

_SetCallback = Callable[[list[Parameter]], rcl_msg.SetParametersResult]
_PreCallback = Callable[[list[Parameter]], list[Parameter]]
_PostCallback = Callable[[list[Parameter]], None]


class NodeParameters(DeclaredParameters):
    """Declares and sets parameters; a base of Node.

    Args:
        overrides: First values of parameters, by name.
        allow_undeclared: Whether parameters may be set that aren't declared.
        publish_event: Called with the new, changed and deleted parameters of each setting; it adds stamp and node.
    """

    __pre_set_callbacks: list[_PreCallback] = SET_BY_INIT
    __on_set_callbacks: list[_SetCallback] = SET_BY_INIT
    __post_set_callbacks: list[_PostCallback] = SET_BY_INIT
    __parameters_lock = SET_BY_INIT
    """Held while parameters are declared, undeclared or set; reading takes no lock."""

    def __init__(
        self,
        overrides: dict[str, Parameter],
        *,
        allow_undeclared: bool,
        publish_event: Callable[[rcl_msg.ParameterEvent], None],
    ) -> None:
        DeclaredParameters.__init__(self, allow_undeclared=allow_undeclared)
        self._parameter_overrides = overrides
        self.__publish_event = publish_event
        self.__pre_set_callbacks = []
        self.__on_set_callbacks = []
        self.__post_set_callbacks = []
        self.__parameters_lock = threading.RLock()

    # Declaring

    def declare_parameter(
        self,
        name: str,
        value: Any = None,
        descriptor: rcl_msg.ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter:
        """Declare one parameter, and return it with its initial value.

        Args:
            name: Its name.
            value: Its default, which fixes its type; or a Parameter.Type, for a parameter with no default.
            descriptor: Its description, and the values that it allows.
            ignore_override: Whether the initial value is the default even if the command line gives a value.

        Raises:
            ValueError: there is neither a value nor a type, and the descriptor doesn't allow dynamic typing.
            ParameterAlreadyDeclaredException: it was declared before.
            InvalidParameterException: the name is empty.
            InvalidParameterTypeException: the value given on the command line is of another type.
            InvalidParameterValueException: the initial value is out of range, or rejected by a callback.
        """
        if value is None and descriptor is None:
            return self.declare_parameters("", [(name,)], ignore_override)[0]
        descriptor = rcl_msg.ParameterDescriptor() if descriptor is None else descriptor
        return self.declare_parameters("", [(name, value, descriptor)], ignore_override)[0]

    def declare_parameters(
        self,
        namespace: str,
        parameters: Sequence[tuple[Any, ...]],
        ignore_override: bool = False,
    ) -> list[Parameter]:
        """Declare several parameters; each is a tuple of the first one to three arguments of `declare_parameter`.

        Args:
            namespace: Put before each name, with a dot; "" for none.
            parameters: The tuples.
            ignore_override: As for `declare_parameter`.

        Raises:
            TypeError: a tuple isn't of that form.
            ValueError: a type is NOT_SET, or given together with dynamic typing; or there is neither a value nor a
                type, and no dynamic typing.
            ParameterException: as from `declare_parameter`; the tuples before it in the list are then declared.
        """
        declarations = read_declarations(namespace, parameters)
        with self.__parameters_lock:
            declared_names = [
                declaration.name for declaration in declarations if declaration.name in self._parameters
            ]
            if declared_names:
                raise ParameterAlreadyDeclaredException(declared_names)
            for declaration in declarations:
                validate_parameter_name(declaration.name)
            for declaration in declarations:
                self.__declare(declaration, ignore_override)
            return [self._parameters[declaration.name] for declaration in declarations]

    def __declare(self, declaration: Declaration, ignore_override: bool) -> None:
        parameter = Parameter(declaration.name, value=declaration.default)
        if not ignore_override and declaration.name in self._parameter_overrides:
            parameter = self._parameter_overrides[declaration.name]
        descriptor = declaration.descriptor
        if parameter.type_ is ParameterType.NOT_SET:
            descriptor.name = parameter.name
            self._descriptors[parameter.name] = descriptor
            self._parameters[parameter.name] = parameter
            return
        result = self.__apply([parameter], {parameter.name: descriptor})
        if result.successful:
            return
        if result.reason.startswith("Wrong parameter type"):
            raise InvalidParameterTypeException(parameter, ParameterType(descriptor.type).name)
        raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)

    def undeclare_parameter(self, name: str) -> None:
        """Remove a parameter.

        Raises:
            ParameterNotDeclaredException: it isn't declared.
            ParameterImmutableException: it is read-only.
        """
        with self.__parameters_lock:
            if name not in self._parameters:
                raise ParameterNotDeclaredException(name)
            if self._descriptors[name].read_only:
                raise ParameterImmutableException(name)
            del self._parameters[name]
            del self._descriptors[name]

    # Setting

    def set_parameters(self, parameter_list: list[Parameter]) -> list[rcl_msg.SetParametersResult]:
        """Set parameters one by one, and return a result for each: successful, or rejected with a reason.

        Raises:
            TypeError: an item is not a Parameter.
            ParameterNotDeclaredException: one isn't declared, and the node doesn't allow undeclared ones; those
                before it are then set.
        """
        results: list[rcl_msg.SetParametersResult] = []
        for parameter in parameter_list:
            self.__check_declared([parameter])
            results.append(self.__set_atomically([parameter]))
        return results

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> rcl_msg.SetParametersResult:
        """Set all parameters, or none of them if one is rejected.

        Raises:
            TypeError: an item is not a Parameter.
            ParameterNotDeclaredException: one isn't declared, and the node doesn't allow undeclared ones.
        """
        self.__check_declared(parameter_list)
        return self.__set_atomically(parameter_list)

    def __check_declared(self, parameters: Sequence[Parameter]) -> None:
        if not all(isinstance(parameter, Parameter) for parameter in parameters):
            raise TypeError("parameter must be instance of type 'rclpy.parameter.Parameter'")
        if self._allow_undeclared_parameters:
            return
        undeclared_names = [
            parameter.name for parameter in parameters if parameter.name not in self._parameters
        ]
        if undeclared_names:
            raise ParameterNotDeclaredException(undeclared_names)

    def __set_atomically(self, parameters: list[Parameter]) -> rcl_msg.SetParametersResult:
        with self.__parameters_lock:
            for pre_callback in self.__pre_set_callbacks:
                parameters = pre_callback(parameters)
                if not parameters:
                    reason = (
                        "parameter list cannot be empty, this might be due to pre_set_parameters_callback "
                        "modifying the original parameters list."
                    )
                    return rcl_msg.SetParametersResult(successful=False, reason=reason)
            self.__check_declared(parameters)
            descriptors = {parameter.name: self.__descriptor_for(parameter.name) for parameter in parameters}
            return self.__apply(parameters, descriptors, check_read_only=True)

    def __descriptor_for(self, name: str) -> rcl_msg.ParameterDescriptor:
        return self._descriptors.get(name) or rcl_msg.ParameterDescriptor(name=name, dynamic_typing=True)

    def __apply(
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
        for callback in self.__on_set_callbacks:
            result = callback(parameters)
            if not result.successful:
                return result
        event = rcl_msg.ParameterEvent()
        for parameter in parameters:
            self.__store(parameter, descriptors[parameter.name], event)
        self.__publish_event(event)
        # The parameters are set: each callback is called, and one that raises is reported by its exception.
        call_all([partial(callback, parameters) for callback in self.__post_set_callbacks])
        return result

    def __store(
        self, parameter: Parameter, descriptor: rcl_msg.ParameterDescriptor, event: rcl_msg.ParameterEvent
    ) -> None:
        name = parameter.name
        old = self._parameters.get(name)
        was_set = old is not None and old.type_ is not ParameterType.NOT_SET
        if parameter.type_ is ParameterType.NOT_SET:
            self._parameters.pop(name, None)
            self._descriptors.pop(name, None)
            if was_set:
                event.deleted_parameters.append(parameter.to_parameter_msg())
            return
        self._parameters[name] = parameter
        descriptor.name = name
        if descriptor.dynamic_typing or descriptor.type == ParameterType.NOT_SET.value:
            descriptor.type = parameter.type_.value
        self._descriptors[name] = descriptor
        changes = event.changed_parameters if was_set else event.new_parameters
        changes.append(parameter.to_parameter_msg())

    def set_descriptor(
        self,
        name: str,
        descriptor: rcl_msg.ParameterDescriptor,
        alternative_value: rcl_msg.ParameterValue | None = None,
    ) -> rcl_msg.ParameterValue:
        """Replace a parameter's descriptor; set the alternative value if the descriptor doesn't allow the present one.

        Returns:
            The parameter's new value.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
            ParameterImmutableException: it is read-only.
            InvalidParameterValueException: the descriptor allows neither value.
        """
        with self.__parameters_lock:
            if name not in self._parameters:
                if not self._allow_undeclared_parameters:
                    raise ParameterNotDeclaredException(name)
                return Parameter(name).get_parameter_value()
            if self.describe_parameter(name).read_only:
                raise ParameterImmutableException(name)
            current = self._parameters[name]
            target = current
            if alternative_value is not None:
                as_msg = rcl_msg.Parameter(name=name, value=alternative_value)
                target = Parameter.from_parameter_msg(as_msg)
            if not descriptor.dynamic_typing and descriptor.type == ParameterType.NOT_SET.value:
                descriptor.type = target.type_.value
            result = self.__apply([target], {name: descriptor})
            if not result.successful:
                raise InvalidParameterValueException(name, target.value, result.reason)
            return self._parameters[name].get_parameter_value()

    # Callbacks

    def add_pre_set_parameters_callback(self, callback: _PreCallback) -> None:
        """Set what `callback(parameters)` returns instead of `parameters`; the last added is called first."""
        self.__pre_set_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: _SetCallback) -> None:
        """Set and declare only what `callback(parameters)` accepts; the last added is called first."""
        self.__on_set_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: _PostCallback) -> None:
        """Call `callback(parameters)` after each setting; the last added is called first."""
        self.__post_set_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: _PreCallback) -> None:
        """Undo one `add_pre_set_parameters_callback`.

        Raises:
            ValueError: it wasn't added.
        """
        self.__pre_set_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: _SetCallback) -> None:
        """Undo one `add_on_set_parameters_callback`.

        Raises:
            ValueError: it wasn't added.
        """
        self.__on_set_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: _PostCallback) -> None:
        """Undo one `add_post_set_parameters_callback`.

        Raises:
            ValueError: it wasn't added.
        """
        self.__post_set_callbacks.remove(callback)
