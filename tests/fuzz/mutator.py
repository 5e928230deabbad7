"""Mutations of a corpus, the same for the same seed."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path

CORPUS = Path(__file__).parent / "corpus"
MAX_SIZE = 4096
NOTABLE = b"\0\1\2\4\x08\x7f\x80\xd8\xdc\xff"
WORDS = (
    b"[]",
    b"[3]",
    b"[<=2]",
    b"<=4",
    b"---\n",
    b"=",
    b"#",
    b'"',
    b"'",
    b"\n",
    b": ",
    b"- ",
    b"{",
    b"}",
    b"[",
    b"]",
    b"&a ",
    b"*a",
    b"!!binary ",
    b".nan",
    b"1e309",
    b"-1",
    b"0x",
    b"18446744073709551616",
    b"now",
    b"enclave=",
    b"typehash=RIHS01_",
    b"rt/",
    b"::dds_::",
    b"\xff\xff\xff\xff",
    "é\u2028\U0001f422".encode(),
)


def seeds(target: str) -> list[bytes]:
    """Return the corpus of a target, in order of the files' names."""
    return [path.read_bytes() for path in sorted((CORPUS / target).iterdir())]


def mutations(corpus: list[bytes], seed: int) -> Iterator[bytes]:
    """Yield mutated inputs without end."""
    source = random.Random(seed)
    while True:
        data = bytearray(source.choice(corpus))
        for _ in range(source.randint(1, 4)):
            _change(data, corpus, source)
        yield bytes(data[:MAX_SIZE])


def _change(data: bytearray, corpus: list[bytes], source: random.Random) -> None:
    at = source.randint(0, len(data))
    kind = source.randrange(8)
    if kind == 0 and at < len(data):
        data[at] ^= 1 << source.randrange(8)
    elif kind == 1 and at < len(data):
        data[at] = source.choice(NOTABLE)
    elif kind == 2 and at < len(data):
        data[at] = source.randrange(256)
    elif kind == 3:
        del data[at:]
    elif kind == 4:
        data[at:at] = bytes([source.choice(NOTABLE)]) * source.randint(0, 8)
    elif kind == 5:
        data[at:at] = source.choice(WORDS)
    elif kind == 6:
        end = source.randint(at, min(len(data), at + 40))
        data[at:at] = data[at:end] * source.randint(1, 3)
    else:
        other = source.choice(corpus)
        data[at:] = other[source.randint(0, len(other)) :]
