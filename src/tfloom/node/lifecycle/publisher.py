"""Publishers that publish while their lifecycle node is active."""

from __future__ import annotations

from typing import Any

from tfloom.node.endpoints.publisher import MsgType, Publisher
from tfloom.node.lifecycle.managed_entity import SimpleManagedEntity

__all__ = ["LifecyclePublisher"]


class LifecyclePublisher(SimpleManagedEntity, Publisher[MsgType]):
    """Publishes while its node is active, and drops messages otherwise."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)

    def publish(self, msg: MsgType | bytes) -> None:
        """Send a message if the node is active; see `Publisher.publish`."""
        if self.is_activated:
            super().publish(msg)
