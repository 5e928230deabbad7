"""Send a forged RTPS sample to UDP ports, and print for each whether the kernel there refused it."""

from __future__ import annotations

import json
import socket
import struct
import sys

REFUSAL_TIMEOUT_S = 1.0


def data_packet(writer_gid: bytes, sequence_number: int, sample: bytes) -> bytes:
    """Return an RTPS message with one DATA submessage, to every reader that is matched with the writer."""
    header = b"RTPS" + bytes((2, 1, 1, 16)) + writer_gid[:12]
    any_reader = bytes(4)
    fields = struct.pack("<HH4s4siI", 0, 16, any_reader, writer_gid[12:], 0, sequence_number)
    little_endian_with_data = 0x05
    submessage = struct.pack("<BBH", 0x15, little_endian_with_data, len(fields) + len(sample))
    return header + submessage + fields + sample


def is_refused(address: tuple[str, int], packet: bytes) -> bool:
    """Send the packet, and return whether the other end answers that nobody listens there."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.settimeout(REFUSAL_TIMEOUT_S)
        sender.connect(address)
        sender.send(packet)
        try:
            sender.recv(1)
        except ConnectionRefusedError:
            return True
        except TimeoutError:
            return False
        return False


host, gid, number, sample, *ports = sys.argv[1:]
packet = data_packet(bytes.fromhex(gid), int(number), bytes.fromhex(sample))
print(json.dumps([is_refused((host, int(port)), packet) for port in ports]))
