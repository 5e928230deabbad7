"""The service that tells what the types are that a node uses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor
from tfloom.interfaces.type_description_interfaces.msg import (
    Field,
    FieldType,
    IndividualTypeDescription,
    TypeDescription,
    TypeSource,
)
from tfloom.interfaces.type_description_interfaces.srv import (
    GetTypeDescription,
    GetTypeDescription_Request,
    GetTypeDescription_Response,
)
from tfloom.node.names import TOPIC_SEPARATOR_STRING
from tfloom.node.parameter import ParameterType

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["START_TYPE_DESCRIPTION_SERVICE_PARAM", "TOPIC_SEPARATOR_STRING", "TypeDescriptionService"]

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"


class TypeDescriptionService:
    """Serves the definitions of types, below a node's name, unless its parameter says not to."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._service = None
        descriptor = ParameterDescriptor(
            type=ParameterType.BOOL.value,
            description="If enabled, start the ~/get_type_description service.",
            read_only=True,
        )
        if not node.has_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM):
            node.declare_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM, True, descriptor)
        if node.get_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM).value:
            self._service = node.create_service(GetTypeDescription, "~/get_type_description", self._get)

    def destroy(self) -> None:
        """Serve no more."""
        if self._service is not None:
            self._node.destroy_service(self._service)
            self._service = None

    def _get(
        self, request: GetTypeDescription_Request, response: GetTypeDescription_Response
    ) -> GetTypeDescription_Response:
        from tfloom.rosidl.registry import find_class

        try:
            known = find_class(request.type_name)
        except LookupError as error:
            response.failure_reason = str(error)
            return response
        if request.type_hash not in ("", known._TYPE_HASH):  # ours
            response.failure_reason = f"{request.type_name} is known with the hash {known._TYPE_HASH} only"
            return response
        _describe(request.type_name, response, with_sources=request.include_type_sources)
        return response


def _describe(name: str, response: GetTypeDescription_Response, *, with_sources: bool) -> None:
    from tfloom.rosidl.parse import parse_interface
    from tfloom.rosidl.registry import definitions_folder
    from tfloom.rosidl.type_hash import type_description

    def read(type_name: str) -> tuple[str, str]:
        package, kind, base = type_name.split("/")
        path = definitions_folder() / package / kind / f"{base}.{kind}"
        return path.read_text("utf-8"), kind

    def find(type_name: str) -> Any:
        return parse_interface(read(type_name)[0], type_name)

    described = type_description(find(name), find)
    response.type_description = TypeDescription(
        type_description=_individual(described["type_description"]),
        referenced_type_descriptions=[
            _individual(each) for each in described["referenced_type_descriptions"]
        ],
    )
    if with_sources:
        text, kind = read(name)
        response.type_sources = [TypeSource(type_name=name, encoding=kind, raw_file_contents=text)]
    response.successful = True


def _individual(described: dict[str, Any]) -> IndividualTypeDescription:
    fields = [Field(name=each["name"], type=FieldType(**each["type"])) for each in described["fields"]]
    return IndividualTypeDescription(type_name=described["type_name"], fields=fields)
