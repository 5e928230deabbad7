"""The service that returns the definitions of a node's types."""

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
from tfloom.node.parameters.parameter import ParameterType
from tfloom.node.values.names import TOPIC_SEPARATOR_STRING

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase
    from tfloom.rosidl import spec

__all__ = ["START_TYPE_DESCRIPTION_SERVICE_PARAM", "TOPIC_SEPARATOR_STRING", "TypeDescriptionService"]

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"


class TypeDescriptionService:
    """Serves the definitions of types below a node's name, unless the node's parameter disables it."""

    def __init__(self, node: NodeBase) -> None:
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
        """Stop serving: destroy the service."""
        if self._service is not None:
            self._node.destroy_service(self._service)
            self._service = None

    def _get(
        self, request: GetTypeDescription_Request, response: GetTypeDescription_Response
    ) -> GetTypeDescription_Response:
        from tfloom.rosidl.registry import find_class

        try:
            type_class = find_class(request.type_name)
            if request.type_hash in ("", type_class._TYPE_HASH):  # ours
                _describe(request.type_name, response, with_sources=request.include_type_sources)
            else:
                response.failure_reason = (
                    f"{request.type_name} is known with the hash {type_class._TYPE_HASH} only"  # ours
                )
        except (
            LookupError,
            ValueError,
            OSError,
        ) as error:  # there is no definition, or its file can't be read
            response.failure_reason = str(error)
        return response


def _describe(name: str, response: GetTypeDescription_Response, *, with_sources: bool) -> None:
    """Fill in a response.

    Raises:
        LookupError, ParseError, UnicodeDecodeError, OSError: a definition is missing, or can't be read.
    """
    from tfloom.rosidl.sources import find_message
    from tfloom.rosidl.type_hash import type_description

    described = type_description(_find_interface(name), find_message)
    referenced = described["referenced_type_descriptions"]
    names = [name, *(description["type_name"] for description in referenced)]
    response.type_sources = [_type_source(type_name) for type_name in names] if with_sources else []
    response.type_description = TypeDescription(
        type_description=_individual_description(described["type_description"]),
        referenced_type_descriptions=[_individual_description(description) for description in referenced],
    )
    response.successful = True


def _find_interface(name: str) -> spec.Interface:
    """Return the spec of a message, service or action, or of a part of one.

    Raises:
        LookupError: there is none.
    """
    from tfloom.rosidl import sources, spec

    definition = sources.find_interface(sources.definition_name(name))
    candidates: list[spec.Interface] = [definition]
    if isinstance(definition, spec.Action):
        candidates += [definition.send_goal, definition.get_result]
    for interface in candidates:
        if interface.name == name:
            return interface
    return sources.find_message(name)


def _type_source(name: str) -> TypeSource:
    """Return the text that defines a type; for a part of a service or action, an empty one."""
    from tfloom.rosidl.sources import definition_name, find_source

    source = find_source(name) if name == definition_name(name) else None
    if source is None:
        return TypeSource(type_name=name, encoding="implicit")
    encoding = "idl" if source.path.endswith(".idl") else name.split("/")[1]
    return TypeSource(type_name=name, encoding=encoding, raw_file_contents=source.text)


def _individual_description(described: dict[str, Any]) -> IndividualTypeDescription:
    fields = [Field(name=field["name"], type=FieldType(**field["type"])) for field in described["fields"]]
    return IndividualTypeDescription(type_name=described["type_name"], fields=fields)
