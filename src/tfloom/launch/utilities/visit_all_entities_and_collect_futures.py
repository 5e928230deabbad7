"""The visit of a tree of entities."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from asyncio import Future

__all__ = ["visit_all_entities_and_collect_futures"]


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, Future[Any]]]:
    """Visit an entity, then what its visit returns, depth first; return the futures of those that go on."""
    futures = []
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    if future is not None:
        futures.append((entity, future))
    for each in following or ():
        futures += visit_all_entities_and_collect_futures(each, context)
    return futures
