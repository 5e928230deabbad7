"""Decompression, limited by the sizes that a file declares. The one place that imports lz4 and zstandard."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

__all__ = [
    "COMPRESSED_SUFFIX",
    "CompressionError",
    "DamagedError",
    "copy_decompressed",
    "decompress",
    "decompress_part",
    "pieces",
]

COMPRESSED_SUFFIX = ".zstd"
"""The end of the name of a file that is compressed as a whole."""
MOST = 1 << 30
"""The greatest size of a chunk or message that is decompressed [bytes]."""
ZSTD_RATIO = 1 << 15
"""By how much zstd compresses at most: a block of 4 bytes repeats one byte 128 KiB."""
PIECE = 1 << 20
"""How much is decompressed at once where not all is kept [bytes]."""
FIRST_PIECE = 1 << 16
"""How much of that at first, because most of what is wrong shows there [bytes]."""
MIN_SIZE = 1 << 18
"""The least declared size of a chunk whose content is looked at before it is held [bytes]."""
MIN_RATIO = 100
"""The least ratio of the declared size to the stored one that is looked at. Empty maps reach 10,000."""
INSTALL = "install it by `pip install 'tfloom[bag]'`"


class CompressionError(ValueError):
    """Bytes can't be decompressed, because the method is unknown or its library isn't installed."""


class DamagedError(CompressionError):
    """Compressed bytes are damaged, cut off, or of another size than declared."""


def decompress(method: str, data: bytes, size: int) -> bytes:
    """Return decompressed bytes.

    Args:
        method: `lz4`, `zstd` or `bz2`; empty: the bytes are not compressed.
        data: The compressed bytes.
        size: The declared size [bytes].

    Raises:
        CompressionError: the method is unknown, or its library isn't installed.
        DamagedError: the bytes are damaged, or they don't have the declared size.
    """
    if method == "zstd" and 0 < size <= min(MOST, len(data) * ZSTD_RATIO):
        module = zstd()
        try:
            if module.frame_content_size(data) == size:  # at once: a stream takes twice as long
                content: bytes = module.ZstdDecompressor().decompress(data)
                return content
        except module.ZstdError as error:
            raise DamagedError(f"the zstd data is damaged: {error}") from None
    content = decompress_part(method, data, size)
    if len(content) != size:
        raise DamagedError(f"{size} bytes are declared, and {len(content)} are there")
    return content


def decompress_part(method: str, data: bytes, size: int) -> bytes:
    """Return the first `size` decompressed bytes; fewer if the bytes end before, because the file is unfinished.

    Raises:
        CompressionError: the method is unknown, or its library isn't installed.
        DamagedError: the bytes are damaged.
    """
    if size > MOST:
        raise DamagedError(f"{size} bytes are declared, more than the {MOST} that are accepted")
    if not method:
        return data[:size]
    if method == "lz4":
        return _part_of_lz4(data, size)
    if method == "zstd":
        return _part_of_zstd(data, size)
    if method == "bz2":
        return _part_of_bz2(data, size)
    raise _unknown(method)


def pieces(method: str, data: bytes) -> Iterator[bytes]:
    """Yield decompressed bytes by parts, up to their end or to where they are cut off.

    Raises:
        CompressionError: the method is unknown, or its library isn't installed.
        DamagedError: the bytes are damaged.
    """
    if method == "zstd":
        yield from _pieces_of_zstd(data)
        return
    if method not in {"lz4", "bz2"}:
        raise _unknown(method)
    stream = lz4_frame().LZ4FrameDecompressor() if method == "lz4" else bz2_module().BZ2Decompressor()
    try:
        # The stream keeps the compressed bytes that it hasn't used yet, so the following calls pass none.
        piece = stream.decompress(data, max_length=FIRST_PIECE)
        while piece:
            yield piece
            piece = b"" if stream.eof else stream.decompress(b"", max_length=PIECE)
    except (RuntimeError, EOFError, MemoryError, OSError, ValueError) as error:
        raise DamagedError(f"the {method} data is damaged: {error}") from None


def _pieces_of_zstd(data: bytes) -> Iterator[bytes]:
    module = zstd()
    try:
        with module.ZstdDecompressor().stream_reader(data) as reader:
            piece = reader.read(FIRST_PIECE)
            while piece:
                yield piece
                piece = reader.read(PIECE)
    except (module.ZstdError, MemoryError) as error:
        raise DamagedError(f"the zstd data is damaged: {error}") from None


def _unknown(method: str) -> CompressionError:
    return CompressionError(f"the compression is '{method[:40]}', which is none of lz4 and zstd")


def decompress_message(data: bytes) -> bytes:
    """Return a message that is compressed by itself, as zstd.

    Raises:
        DamagedError: the bytes are damaged, or too many.
    """
    module = zstd()
    try:
        size = module.frame_content_size(data) if data.startswith(ZSTD_MAGIC) else None
    except module.ZstdError:  # it ends before its size
        size = None
    if size is None:
        raise DamagedError("the message isn't compressed by zstd")
    # A frame needn't declare its size; what comes out of it is then limited by what is accepted at all.
    return decompress_part("zstd", data, MOST) if size < 0 else decompress("zstd", data, size)


ZSTD_MAGIC = b"\x28\xb5\x2f\xfd"


def zstd() -> Any:
    """Return the module zstandard.

    Raises:
        CompressionError: it isn't installed.
    """
    try:
        import zstandard
    except ImportError:
        raise CompressionError(f"zstandard is needed for zstd: {INSTALL}") from None
    return zstandard


def lz4_frame() -> Any:
    """Return the module lz4.frame.

    Raises:
        CompressionError: it isn't installed.
    """
    try:
        import lz4.frame
    except ImportError:
        raise CompressionError(f"lz4 is needed for lz4: {INSTALL}") from None
    return lz4.frame


def _part_of_lz4(data: bytes, size: int) -> bytes:
    module = lz4_frame()
    try:
        content: bytes = module.LZ4FrameDecompressor().decompress(data, max_length=size) if size else b""
    except (RuntimeError, EOFError, MemoryError) as error:
        raise DamagedError(f"the lz4 data is damaged: {error}") from None
    return content


def bz2_module() -> Any:
    """Return the module bz2.

    Raises:
        CompressionError: this Python has none.
    """
    try:
        import bz2
    except ImportError:
        raise CompressionError("this Python has no module bz2") from None
    return bz2


def _part_of_bz2(data: bytes, size: int) -> bytes:
    stream = bz2_module().BZ2Decompressor()
    try:
        content: bytes = stream.decompress(data, max_length=size) if size else b""
    except (OSError, EOFError, ValueError) as error:
        raise DamagedError(f"the bz2 data is damaged: {error}") from None
    return content


def _part_of_zstd(data: bytes, size: int) -> bytes:
    module = zstd()
    try:
        with module.ZstdDecompressor().stream_reader(data) as reader:
            content: bytes = reader.read(min(size, len(data) * ZSTD_RATIO)) if size and data else b""
    except (module.ZstdError, MemoryError) as error:
        raise DamagedError(f"the zstd data is damaged: {error}") from None
    return content


def copy_decompressed(source: Path, target: BinaryIO) -> None:
    """Write the content of a zstd file into another file.

    Raises:
        CompressionError: zstandard isn't installed.
        DamagedError: the file is damaged or cut off.
        OSError: a file can't be read or written.
    """
    module = zstd()
    count = 0
    try:
        with source.open("rb") as file:
            # The declared size, where there is one, also limits what is written: no more than one block beyond it.
            size = module.frame_content_size(file.read(32))
            file.seek(0)
            with module.ZstdDecompressor().stream_reader(file) as reader:
                while (block := reader.read(1 << 20)) and (size < 0 or count <= size):
                    target.write(block)
                    count += len(block)
    except module.ZstdError as error:
        raise DamagedError(f"the zstd data is damaged: {error}") from None
    if 0 <= size != count:
        less = "the file is cut off: " if count < size else ""
        raise DamagedError(f"{less}{size} bytes are declared, and {count} are there")
