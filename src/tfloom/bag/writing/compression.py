"""Compression of chunks, messages and files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tfloom.bag.reading.compression import COMPRESSED_SUFFIX, lz4_frame, zstd

__all__ = ["compress", "compress_file", "compressor"]

_LEVELS = {
    "zstd": {"Fastest": -5, "Fast": -3, "Default": 1, "Slow": 5, "Slowest": 19},
    "lz4": {"Fastest": -5, "Fast": -3, "Default": 0, "Slow": 5, "Slowest": 12},
}
_BLOCK = 1 << 20


def compress(data: bytes, method: str, level: str = "Default") -> bytes:
    """Return compressed bytes.

    Args:
        data: The bytes.
        method: `lz4` or `zstd`.
        level: Fastest, Fast, Default, Slow or Slowest.

    Raises:
        CompressionError: the library isn't installed.
    """
    number = _LEVELS[method].get(level, _LEVELS[method]["Default"])
    if method == "lz4":
        frame: bytes = lz4_frame().compress(data, compression_level=number)
        return frame
    compressed: bytes = zstd().ZstdCompressor(level=number).compress(data)
    return compressed


def compressor() -> Any:
    """Return an object whose method `compress` compresses a message.

    Raises:
        CompressionError: zstandard isn't installed.
    """
    return zstd().ZstdCompressor(level=1)


def compress_file(path: Path) -> Path:
    """Compress a file to one with the suffix `.zstd` beside it, remove it, and return the new one.

    Raises:
        CompressionError: zstandard isn't installed.
        OSError: the new file can't be written; the original is left.
    """
    target = path.with_name(path.name + COMPRESSED_SUFFIX)
    writer = zstd().ZstdCompressor(level=1).compressobj(size=path.stat().st_size)
    try:
        with path.open("rb") as source, target.open("xb") as file:
            while block := source.read(_BLOCK):
                file.write(writer.compress(block))
            file.write(writer.flush())
    except BaseException:
        target.unlink(missing_ok=True)
        raise
    path.unlink()
    return target
