"""The abstract bases of what a node is and creates, by which both Node and AsyncNode are known.

The classes are registered rather than derived: a program's class that derives from Node and from a class of another
library, as a window, would have two metaclasses otherwise.
"""

from __future__ import annotations

from abc import ABC, abstractmethod

from tfloom.node.clock.clock import Clock
from tfloom.node.endpoints.client import Client
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.service import Service
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.executing.timer import Timer
from tfloom.node.values.time import Time

__all__ = [
    "BaseClient",
    "BaseClock",
    "BaseEntity",
    "BaseNode",
    "BasePublisher",
    "BaseService",
    "BaseSubscription",
    "BaseTimer",
]


class BaseNode(ABC):
    """A Node or an AsyncNode."""

    @abstractmethod
    def destroy_node(self) -> None:
        """Leave the graph."""


class BaseEntity(ABC):
    """What either creates."""

    @abstractmethod
    def destroy(self) -> None:
        """Leave the node."""


class BasePublisher(BaseEntity):
    """A publisher of either."""


class BaseSubscription(BaseEntity):
    """A subscription of either."""


class BaseService(BaseEntity):
    """A service of either."""


class BaseClient(BaseEntity):
    """A client of either."""


class BaseTimer(BaseEntity):
    """A timer of either."""


class BaseClock(ABC):
    """A clock of either."""

    @abstractmethod
    def now(self) -> Time:
        """Return the current time of this clock."""


BasePublisher.register(Publisher)
BaseSubscription.register(Subscription)
BaseService.register(Service)
BaseClient.register(Client)
BaseTimer.register(Timer)
BaseClock.register(Clock)
