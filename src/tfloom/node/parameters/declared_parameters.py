"""Read access to the parameters that a node has declared."""

from __future__ import annotations

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.parameters.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from tfloom.node.parameters.parameter import PARAMETER_SEPARATOR_STRING, Parameter, ParameterType
from tfloom.node.values.set_by_init import SET_BY_INIT

__all__ = ["DeclaredParameters"]


class DeclaredParameters:
    """Stores parameters with their descriptors, and returns them; a base of Node.

    The attributes have rclpy's names, because programs read them.
    """

    _parameters: dict[str, Parameter] = SET_BY_INIT
    _descriptors: dict[str, rcl_msg.ParameterDescriptor] = SET_BY_INIT
    _allow_undeclared_parameters: bool = SET_BY_INIT

    def __init__(self, *, allow_undeclared: bool) -> None:
        self._parameters = {}
        self._descriptors = {}
        self._allow_undeclared_parameters = allow_undeclared

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return name in self._parameters

    def get_parameter(self, name: str) -> Parameter:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
            ParameterUninitializedException: it was declared with a type and has no value.
        """
        parameter = self._parameters.get(name)
        if parameter is None:
            if self._allow_undeclared_parameters:
                return Parameter(name, ParameterType.NOT_SET, None)
            raise ParameterNotDeclaredException(name)
        if parameter.type_ is ParameterType.NOT_SET and not self._descriptors[name].dynamic_typing:
            raise ParameterUninitializedException(name)
        return parameter

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Return the parameters of these names, each as `get_parameter` does.

        Raises:
            TypeError: `names` isn't a list of strings.
            ParameterException: as from `get_parameter`.
        """
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter(name) for name in names]

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return a parameter; if it is undeclared or has no value, the alternative (None: one without value)."""
        if alternative_value is None:
            alternative_value = Parameter(name, ParameterType.NOT_SET, None)
        parameter = self._parameters.get(name)
        if parameter is None or parameter.type_ is ParameterType.NOT_SET:
            return alternative_value
        return parameter

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters below a prefix (`a.b`; "" for all), by the part of their names after it."""
        if prefix:
            prefix += PARAMETER_SEPARATOR_STRING
        return {
            name[len(prefix) :]: parameter
            for name, parameter in list(self._parameters.items())
            if name.startswith(prefix)
        }

    def get_parameter_type(self, name: str) -> ParameterType:
        """Return a parameter's type.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
        """
        if name in self._parameters:
            return self._parameters[name].type_
        if self._allow_undeclared_parameters:
            return ParameterType.NOT_SET
        raise ParameterNotDeclaredException(name)

    def get_parameter_types(self, names: list[str]) -> list[ParameterType]:
        """Return the types of parameters, each as `get_parameter_type` does."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter_type(name) for name in names]

    def describe_parameter(self, name: str) -> rcl_msg.ParameterDescriptor:
        """Return a parameter's descriptor.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
        """
        descriptor = self._descriptors.get(name)
        if descriptor is not None:
            return descriptor
        if self._allow_undeclared_parameters:
            return rcl_msg.ParameterDescriptor()
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: list[str]) -> list[rcl_msg.ParameterDescriptor]:
        """Return the descriptors of parameters, each as `describe_parameter` does."""
        return [self.describe_parameter(name) for name in names]

    def list_parameters(self, prefixes: list[str], depth: int) -> rcl_msg.ListParametersResult:
        """Return the names below any of the prefixes ([]: all names), at most `depth` parts deep (0: no limit).

        Raises:
            TypeError: an argument is of the wrong type.
            ValueError: `depth` is negative.
        """
        if isinstance(prefixes, str) or not all(isinstance(prefix, str) for prefix in prefixes):
            raise TypeError("The prefixes argument must be a list of str")
        if not isinstance(depth, int):
            raise TypeError("The depth must be an int")
        if depth < 0:
            raise ValueError("The depth must be greater than or equal to zero")
        result = rcl_msg.ListParametersResult()
        for name in list(self._parameters):
            if any(_is_below(name, prefix, depth) for prefix in prefixes or [""]):
                result.names.append(name)
                parent = name.rpartition(PARAMETER_SEPARATOR_STRING)[0]
                if parent and parent not in result.prefixes:
                    result.prefixes.append(parent)
        return result


def _is_below(name: str, prefix: str, depth: int) -> bool:
    if prefix:
        if name == prefix:
            return True
        if not name.startswith(prefix + PARAMETER_SEPARATOR_STRING):
            return False
        name = name[len(prefix) + 1 :]
    return depth == 0 or name.count(PARAMETER_SEPARATOR_STRING) < depth
