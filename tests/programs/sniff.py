"""Print each packet on an interface, in either direction: `sniff.py INTERFACE`. Linux alone has such sockets.

`sniff.py INTERFACE HEX` sends a frame to everybody there instead, and ends.
"""

from __future__ import annotations

import socket
import sys

ALL_PROTOCOLS = 0x0003  # ETH_P_ALL of linux/if_ether.h
EVERYBODY, NOBODY = b"\xff" * 6, bytes(6)


def main() -> None:
    packets = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ALL_PROTOCOLS))
    packets.bind((sys.argv[1], 0))
    if len(sys.argv) > 2:
        packets.send(EVERYBODY + NOBODY + bytes.fromhex(sys.argv[2]))
        return
    print("listening", flush=True)
    while True:
        print("packet", packets.recv(65535)[:64].hex(), flush=True)


if __name__ == "__main__":
    main()
