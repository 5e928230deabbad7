"""Decompression, limited by the sizes that a file declares. The one place that imports lz4 and zstandard."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
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
        with _told_as_damage("zstd"):
            if module.frame_content_size(data) == size:  # at once: a stream takes twice as long
                content: bytes = module.ZstdDecompressor().decompress(data)
                return content
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
    read = _reader_of(method, data)
    with _told_as_damage(method):
        return read(min(size, len(data) * ZSTD_RATIO) if method == "zstd" else size) if size and data else b""


def pieces(method: str, data: bytes) -> Iterator[bytes]:
    """Yield decompressed bytes by parts, up to their end or to where they are cut off.

    Raises:
        CompressionError: the method is unknown, or its library isn't installed.
        DamagedError: the bytes are damaged.
    """
    read = _reader_of(method, data)
    with _told_as_damage(method):
        piece = read(FIRST_PIECE)
        while piece:
            yield piece
            piece = read(PIECE)


def _reader_of(method: str, data: bytes) -> Callable[[int], bytes]:
    """Return a function that decompresses the next bytes, at most as many as its argument."""
    if method == "zstd":
        reader: Callable[[int], bytes] = zstd().ZstdDecompressor().stream_reader(data).read
        return reader
    if method not in {"lz4", "bz2"}:
        raise CompressionError(f"the compression is '{method[:40]}', which is none of lz4 and zstd")
    stream = lz4_frame().LZ4FrameDecompressor() if method == "lz4" else bz2_module().BZ2Decompressor()
    # The stream keeps the compressed bytes that it hasn't used yet, so only the first call passes any.
    left = [data]

    def read(size: int) -> bytes:
        given = left.pop() if left else b""
        content: bytes = b"" if stream.eof else stream.decompress(given, max_length=size)
        return content

    return read


@contextmanager
def _told_as_damage(method: str) -> Iterator[None]:
    """Raise DamagedError for what the library of a method raises for damaged bytes."""
    of_library = (zstd().ZstdError,) if method == "zstd" else (RuntimeError, EOFError, OSError, ValueError)
    try:
        yield
    except (*of_library, MemoryError) as error:
        raise DamagedError(f"the {method} data is damaged: {error}") from None


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


def copy_decompressed(source: Path, target: BinaryIO) -> None:
    """Write the content of a zstd file into another file.

    Raises:
        CompressionError: zstandard isn't installed.
        DamagedError: the file is damaged or cut off.
        OSError: a file can't be read or written.
    """
    module = zstd()
    count = 0
    with _told_as_damage("zstd"), source.open("rb") as file:
        # The declared size, where there is one, also limits what is written: no more than one block beyond it.
        size = module.frame_content_size(file.read(32))
        file.seek(0)
        with module.ZstdDecompressor().stream_reader(file) as reader:
            while (block := reader.read(1 << 20)) and (size < 0 or count <= size):
                target.write(block)
                count += len(block)
    if 0 <= size != count:
        less = "the file is cut off: " if count < size else ""
        raise DamagedError(f"{less}{size} bytes are declared, and {count} are there")
