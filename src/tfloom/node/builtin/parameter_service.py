"""The services that read and set a node's parameters."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.rcl_interfaces.msg import Parameter as ParameterMsg
from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult
from tfloom.interfaces.rcl_interfaces.srv import (
    DescribeParameters,
    DescribeParameters_Request,
    DescribeParameters_Response,
    GetParameters,
    GetParameters_Request,
    GetParameters_Response,
    GetParameterTypes,
    GetParameterTypes_Request,
    GetParameterTypes_Response,
    ListParameters,
    ListParameters_Request,
    ListParameters_Response,
    SetParameters,
    SetParameters_Request,
    SetParameters_Response,
    SetParametersAtomically,
    SetParametersAtomically_Request,
    SetParametersAtomically_Response,
)
from tfloom.node.parameters.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import qos_profile_parameters
from tfloom.node.values.names import TOPIC_SEPARATOR_STRING

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase

__all__ = ["TOPIC_SEPARATOR_STRING", "ParameterService"]


class ParameterService:
    """Serves a node's parameters: six services below its name.

    The response to a request with an undeclared parameter is an empty list, not an error.
    """

    def __init__(self, node: NodeBase) -> None:
        self._node = node
        services: tuple[tuple[type[Any], str, Callable[[Any, Any], Any]], ...] = (
            (DescribeParameters, "describe_parameters", self._describe),
            (GetParameters, "get_parameters", self._get),
            (GetParameterTypes, "get_parameter_types", self._get_types),
            (ListParameters, "list_parameters", self._list),
            (SetParameters, "set_parameters", self._set),
            (SetParametersAtomically, "set_parameters_atomically", self._set_atomically),
        )
        for srv_type, name, callback in services:
            node.create_service(srv_type, f"~/{name}", callback, qos_profile=qos_profile_parameters)

    def _describe(
        self, request: DescribeParameters_Request, response: DescribeParameters_Response
    ) -> DescribeParameters_Response:
        try:
            response.descriptors = self._node.describe_parameters(request.names)
        except ParameterNotDeclaredException:
            response.descriptors = []
        return response

    def _get(
        self, request: GetParameters_Request, response: GetParameters_Response
    ) -> GetParameters_Response:
        try:
            parameters = self._node.get_parameters(request.names)
        except (ParameterNotDeclaredException, ParameterUninitializedException):
            return response
        response.values = [parameter.get_parameter_value() for parameter in parameters]
        return response

    def _get_types(
        self, request: GetParameterTypes_Request, response: GetParameterTypes_Response
    ) -> GetParameterTypes_Response:
        try:
            response.types = self._node.get_parameter_types(request.names)
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list(
        self, request: ListParameters_Request, response: ListParameters_Response
    ) -> ListParameters_Response:
        response.result = self._node.list_parameters(request.prefixes, request.depth)
        return response

    def _set(
        self, request: SetParameters_Request, response: SetParameters_Response
    ) -> SetParameters_Response:
        response.results = [self._set_all([message]) for message in request.parameters]
        return response

    def _set_atomically(
        self, request: SetParametersAtomically_Request, response: SetParametersAtomically_Response
    ) -> SetParametersAtomically_Response:
        response.result = self._set_all(request.parameters)
        return response

    def _set_all(self, messages: list[ParameterMsg]) -> SetParametersResult:
        convert: Callable[[ParameterMsg], Parameter] = Parameter.from_parameter_msg
        try:
            return self._node.set_parameters_atomically([convert(message) for message in messages])
        except (ParameterNotDeclaredException, ValueError) as error:  # ValueError: an unknown type
            return SetParametersResult(successful=False, reason=str(error))
