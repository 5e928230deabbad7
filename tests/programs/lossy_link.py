"""A link between two network namespaces that delays, loses and slows IP packets, as `tc netem` does where it exists.

Arguments: the process whose network is at the far end (the near one is this process's own), the interface's name, the
delay of each way [s], the share of packets that are lost, the rate of each way [bit/s], how long a packet may wait for
its turn [s], the seed of the losses.

Prints `linked`. A line on stdin is answered by `packets N lost N late N`: those sent into the link so far, those that
the dice took, and those for which its queue had no room. The link ends with stdin, or with this process, however that
ends, because a TUN interface lives as long as its descriptor.
"""

from __future__ import annotations

import ctypes
import fcntl
import os
import random
import select
import struct
import sys
import time
from collections import deque
from contextlib import suppress
from pathlib import Path

_CLONE_NEWNET = 0x40000000
_TUNSETIFF = 0x400454CA
_IFF_TUN, _IFF_NO_PI = 0x1, 0x1000
_MAX_PACKET = 65536


def open_tun(interface: str) -> int:
    """Create a TUN interface in this process's network, and return the descriptor of its packets."""
    tun = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
    fcntl.ioctl(tun, _TUNSETIFF, struct.pack("16sH22x", interface.encode(), _IFF_TUN | _IFF_NO_PI))
    return tun


def enter_network_of(pid: str) -> None:
    """Move this thread to another process's network; a TUN that is open stays where it was made."""
    with Path(f"/proc/{pid}/ns/net").open("rb") as network:
        if ctypes.CDLL(None, use_errno=True).setns(network.fileno(), _CLONE_NEWNET):
            error = ctypes.get_errno()
            raise OSError(error, f"can't enter the network of process {pid}: {os.strerror(error)}")


class Way:
    """One way of the link: what comes in at one end, until it is due at the other.

    Args:
        source: The descriptor that packets come from.
        sink: The one that they leave by.
        delay_s: How long each packet takes, after its turn [s].
        loss: The share of packets that are lost.
        rate: Bits a second.
        queue_s: How long a packet may wait for its turn [s]; one that would wait longer is dropped, as by a full queue.
        seed: Of the losses.
    """

    def __init__(
        self,
        source: int,
        sink: int,
        delay_s: float,
        loss: float,
        rate: float,
        queue_s: float,
        seed: str,
    ) -> None:
        self.source = source
        self._sink = sink
        self._delay_s = delay_s
        self._loss = loss
        self._rate = rate
        self._queue_s = queue_s
        self._random = random.Random(seed)
        self._waiting: deque[tuple[float, bytes]] = deque()
        self._free_s = 0.0  # when the last packet has been sent
        self.packets = self.lost = self.late = 0

    def receive(self) -> None:
        """Take all packets that have come in."""
        while True:
            try:
                packet = os.read(self.source, _MAX_PACKET)
            except BlockingIOError:
                return
            self._add(packet, time.monotonic())

    def _add(self, packet: bytes, now_s: float) -> None:
        self.packets += 1
        start_s = max(now_s, self._free_s)
        if start_s - now_s > self._queue_s:
            self.late += 1
            return
        # A packet that is lost in the air has used it.
        self._free_s = start_s + 8 * len(packet) / self._rate
        if self._random.random() < self._loss:
            self.lost += 1
            return
        self._waiting.append((self._free_s + self._delay_s, packet))

    def send_due(self) -> None:
        """Give the other end what is due. The kernel drops a packet while that interface is down."""
        now_s = time.monotonic()
        while self._waiting and self._waiting[0][0] <= now_s:
            with suppress(OSError):
                os.write(self._sink, self._waiting.popleft()[1])

    def wait_s(self) -> float | None:
        """Return the time until a packet is due [s]; None: none waits."""
        return max(0.0, self._waiting[0][0] - time.monotonic()) if self._waiting else None


def forward(ways: tuple[Way, Way]) -> None:
    """Pass packets on until stdin ends."""
    while True:
        waits = [wait for way in ways if (wait := way.wait_s()) is not None]
        ready, _, _ = select.select([0, *(way.source for way in ways)], [], [], min(waits, default=None))
        for way in ways:
            if way.source in ready:
                way.receive()
            way.send_due()
        if 0 in ready:
            if not os.read(0, 1024):
                return
            packets, lost, late = (
                sum(getattr(way, name) for way in ways) for name in ("packets", "lost", "late")
            )
            print("packets", packets, "lost", lost, "late", late, flush=True)


def main() -> None:
    """Make both ends, and forward between them."""
    pid, interface, *numbers, seed = sys.argv[1:]
    delay_s, loss, rate, queue_s = map(float, numbers)
    near = open_tun(interface)
    enter_network_of(pid)
    far = open_tun(interface)
    print("linked", flush=True)
    forward(
        (
            Way(near, far, delay_s, loss, rate, queue_s, f"{seed} out"),
            Way(far, near, delay_s, loss, rate, queue_s, f"{seed} back"),
        )
    )


if __name__ == "__main__":
    main()
