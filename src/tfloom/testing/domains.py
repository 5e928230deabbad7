"""DDS domains that one holder at a time has, among all processes of the machine."""

from __future__ import annotations

import gc
import random
import socket
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

__all__ = ["DOMAINS", "held_locks", "hold_domain"]

# By the RTPS port formula, domains up to 100 don't use Linux's ephemeral ports; the rest of them is for programs
# that are started by hand meanwhile.
DOMAINS = range(1, 71)
FIRST_LOCK_PORT = 7400
PORTS_OF_A_DOMAIN = 250
TIMEOUT_S = 300.0

_held: set[int] = set()
"""The descriptors of the locks that this process holds."""


def held_locks() -> tuple[int, ...]:
    """Return the descriptors of the locks of this process, for programs that are to hold them, too.

    A domain then stays in use while such a program outlives its test.
    """
    return tuple(_held)


@contextmanager
def hold_domain(domains: Sequence[int] = DOMAINS, timeout_s: float = TIMEOUT_S) -> Iterator[int]:
    """Hold a domain for the block, and yield its number; if all are in use, wait for one.

    The lock is a bound TCP port of the loopback interface, which only one process of the machine can hold. The ports,
    7650 to 24900, are below the ephemeral ones, and DDS's are of UDP.

    Raises:
        TimeoutError: all domains have been in use for `timeout_s` [s].
        RuntimeError: this process leaves a participant on the domain, which whoever holds it next would discover.
    """
    with _lock_a_domain(domains, timeout_s) as (domain, lock):
        _held.add(lock.fileno())
        try:
            yield domain
        finally:
            _held.discard(lock.fileno())
        _expect_nobody_left(domain)


@contextmanager
def _lock_a_domain(domains: Sequence[int], timeout_s: float) -> Iterator[tuple[int, socket.socket]]:
    end = time.monotonic() + timeout_s
    while True:
        for domain in random.sample(domains, len(domains)):
            with socket.socket() as lock:
                try:
                    lock.bind(("127.0.0.1", FIRST_LOCK_PORT + PORTS_OF_A_DOMAIN * domain))
                except OSError:
                    continue
                yield domain, lock
                return
        if time.monotonic() > end:
            raise TimeoutError(f"all DDS domains have been in use for {timeout_s:g} s")
        time.sleep(0.1)


def _expect_nobody_left(domain: int) -> None:
    wire = sys.modules.get("tfloom.rmw.cyclone.wire")
    if wire is None or not wire.is_joined(domain):
        return
    gc.collect()
    if wire.is_joined(domain):
        raise RuntimeError(
            f"a node or a participant is left on domain {domain}: destroy it before the domain is given away"
        )
