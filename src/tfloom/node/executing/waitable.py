"""The base class of a program's own waitables."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic

from tfloom.node.values.type_support import T

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.task import Future
    from tfloom.node.executing.wait_set import WaitSet

__all__ = ["NumberOfEntities", "Waitable"]


class NumberOfEntities:
    """Number of items of each kind that a waitable waits for; `+` adds them."""

    __slots__ = (
        "num_clients",
        "num_events",
        "num_guard_conditions",
        "num_services",
        "num_subscriptions",
        "num_timers",
    )

    def __init__(
        self,
        num_subs: int = 0,
        num_gcs: int = 0,
        num_timers: int = 0,
        num_clients: int = 0,
        num_services: int = 0,
        num_events: int = 0,
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        both = type(self)()
        both += self
        both += other
        return both

    def __iadd__(self, other: NumberOfEntities) -> Self:
        for name in NumberOfEntities.__slots__:
            setattr(self, name, getattr(self, name) + getattr(other, name))
        return self

    def __repr__(self) -> str:
        counts = ", ".join(f"{name}={getattr(self, name)}" for name in self.__slots__)
        return f"{type(self).__name__}({counts})"


class Waitable(Generic[T]):
    """Base of classes that wait for guard conditions, subscriptions and the like.

    `Node.add_waitable` adds it to the node's executor. On the thread that spins, the executor calls
    `add_to_wait_set` before it waits, `is_ready` each time it wakes for any reason, and `take_data` if that is true;
    then it calls `execute` with the data on a thread that runs callbacks.

    Args:
        callback_group: Group of `execute`.
    """

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group = callback_group
        self.callback_group.add_entity(self)
        self._futures: list[Future[Any]] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        """Do nothing; a derived class may clean up here."""

    def add_future(self, future: Future[Any]) -> None:
        """Run the callbacks of a future, which `execute` completes, as tasks of the executor."""
        self._futures.append(future)

    def remove_future(self, future: Future[Any]) -> None:
        """Undo `add_future`.

        Raises:
            ValueError: the future was never added.
        """
        self._futures.remove(future)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Return whether there is something to take and execute."""
        raise NotImplementedError("Must be implemented by subclass")

    def take_data(self) -> T:
        """Remove and return the data for `execute`."""
        raise NotImplementedError("Must be implemented by subclass")

    async def execute(self, taken_data: T) -> None:
        """Process the data that `take_data` returned."""
        raise NotImplementedError("Must be implemented by subclass")

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many items of each kind `add_to_wait_set` adds."""
        raise NotImplementedError("Must be implemented by subclass")

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Add the items to wait for, and keep their indices for `is_ready`."""
        raise NotImplementedError("Must be implemented by subclass")
