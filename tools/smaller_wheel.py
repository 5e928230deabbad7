"""Compress wheels again, better: `python -m tools.smaller_wheel WHEEL ...`. `make dist` and the release workflow do so.

Zopfli finds a shorter form of the same deflate stream, which every installer reads as fast. Entries of folders, which
auditwheel adds and no installer uses, are left out.
"""

from __future__ import annotations

import struct
import sys
import zipfile
from pathlib import Path

LOCAL_HEADER = struct.Struct("<4s5H3I2H")
CENTRAL_HEADER = struct.Struct("<4s6H3I5H2I")
END = struct.Struct("<4s4H2IH")
NEEDED_VERSION = 20
UTF8 = 0x800


def deflated(content: bytes) -> bytes:
    """Return content as a raw deflate stream."""
    import zopfli.zlib  # the dependency group `release` has it

    return bytes(zopfli.zlib.compress(content))[2:-4]  # without zlib's header and checksum


def compress_again(wheel: Path) -> None:
    """Replace a wheel by a smaller one with the same files: names, contents, times and permissions.

    Raises:
        ValueError: the files of the new one differ; the wheel is unchanged.
    """
    body, directory, count = bytearray(), bytearray(), 0
    with zipfile.ZipFile(wheel) as archive:
        before = {each.filename: each.CRC for each in archive.infolist() if not each.is_dir()}
        for each in archive.infolist():
            if each.is_dir():
                continue
            content, name = archive.read(each), each.filename.encode()
            data, method = deflated(content), zipfile.ZIP_DEFLATED
            if len(data) >= len(content):
                data, method = content, zipfile.ZIP_STORED
            year, month, day, hour, minute, second = each.date_time
            common = (
                NEEDED_VERSION,
                UTF8,
                method,
                hour << 11 | minute << 5 | second // 2,
                (year - 1980) << 9 | month << 5 | day,
                each.CRC,
                len(data),
                len(content),
                len(name),
                0,
            )
            made_by = each.create_system << 8 | NEEDED_VERSION
            directory += CENTRAL_HEADER.pack(
                b"PK\1\2", made_by, *common, 0, 0, 0, each.external_attr, len(body)
            )
            directory += name
            body += LOCAL_HEADER.pack(b"PK\3\4", *common) + name + data
            count += 1
    end = END.pack(b"PK\5\6", 0, 0, count, count, len(directory), len(body), 0)
    smaller = wheel.with_suffix(".part")
    smaller.write_bytes(body + directory + end)
    with zipfile.ZipFile(smaller) as archive:
        if archive.testzip() or {each.filename: each.CRC for each in archive.infolist()} != before:
            smaller.unlink()
            raise ValueError(f"{wheel.name}: the files differ after compression")
    smaller.replace(wheel)


def main() -> int:
    """Compress each wheel again, and print both sizes."""
    for wheel in map(Path, sys.argv[1:]):
        size = wheel.stat().st_size
        compress_again(wheel)
        print(f"{wheel.name}: {size / 1e6:.2f} MB, then {wheel.stat().st_size / 1e6:.2f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
