"""The visit of a tree of entities."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.missing import is_about_missing, skip_text
from tfloom.launch.logs.logging import get_logger

if TYPE_CHECKING:
    from asyncio import Future

__all__ = ["visit_all_entities", "visit_all_entities_and_collect_futures"]


def visit_all_entities(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> Iterator[tuple[LaunchDescriptionEntity, Future[Any]]]:
    """Visit an entity, then what its visit returns, depth first; yield those that go on, each with its future."""
    try:
        following = entity.visit(context)
    except Exception as error:
        if context.run_state.unskippable in (None, entity) or not is_about_missing(error):
            raise
        text = skip_text(error)
        get_logger("launch").warning("%s", text)
        if hasattr(entity, "launch_description_source"):
            context.run_state.skipped_includes.append(text)
        return
    future = entity.get_asyncio_future()
    if future is not None:
        yield entity, future
    for next_entity in following or ():
        yield from visit_all_entities(next_entity, context)
    entity.end_visit(context)


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, Future[Any]]]:
    """Visit an entity, then what its visit returns, depth first; return the futures of those that go on."""
    return list(visit_all_entities(entity, context))
