"""Limits that clients share, of which none may take so much that nothing is left for another one."""

from __future__ import annotations

import threading

__all__ = ["Load", "Shares"]


class Shares:
    """A limit, of which each client has what it took until it gives it back. Any thread may use it.

    No client has more than is left for others: one alone has half at most, each of two that take all they can a third.

    Args:
        most: The limit.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._lock = threading.Lock()
        """Guards the members below."""
        self._total = 0
        self._taken: dict[int, int] = {}
        """What each client has that has something."""

    def take(self, client: int, amount: int = 1) -> bool:
        """Take an amount for a client, if that is left; return whether it was."""
        with self._lock:
            if self._taken.get(client, 0) + amount > self._most - self._total:
                return False
            self._change(client, amount)
            return True

    def give_back(self, client: int, amount: int = 1) -> None:
        """Give back a part of what a client has taken."""
        with self._lock:
            self._change(client, -amount)

    def _change(self, client: int, amount: int) -> None:
        self._total += amount
        self._taken[client] = self._taken.get(client, 0) + amount
        if not self._taken[client]:
            del self._taken[client]


class Load:
    """What clients have under way: its number and its size each have a limit, as of `Shares`.

    Args:
        most: The number.
        most_bytes: The size [bytes].
    """

    def __init__(self, most: int, most_bytes: int) -> None:
        self._number = Shares(most)
        self._bytes = Shares(most_bytes)

    def take(self, client: int, size: int) -> bool:
        """Begin something of a size [bytes] for a client; return False if that would be too much."""
        if not self._number.take(client):
            return False
        if not self._bytes.take(client, size):
            self._number.give_back(client)
            return False
        return True

    def give_back(self, client: int, size: int) -> None:
        """End it."""
        self._number.give_back(client)
        self._bytes.give_back(client, size)
