"""The hash of a type's definition."""

from __future__ import annotations

__all__ = ["TypeHash"]

_SIZE = 32


class TypeHash:
    """A version and 32 bytes; version -1: unknown."""

    __slots__ = ("_value", "_version")

    def __init__(self, version: int = -1, value: bytes = bytes(_SIZE)) -> None:
        self._version = version
        self._value = value

    @classmethod
    def from_text(cls, text: str) -> TypeHash:
        """Return the hash written as `RIHS01_` and 64 hex digits; for any other text, an unknown hash."""
        version, _, digits = text.removeprefix("RIHS").partition("_")
        try:
            value = bytes.fromhex(digits)
            number = int(version, 16)
        except ValueError:
            return cls()
        return cls(number, value) if len(value) == _SIZE else cls()

    @property
    def version(self) -> int:
        """Version of the algorithm; -1: unknown."""
        return self._version

    @property
    def value(self) -> bytes:
        """The hash, 32 bytes."""
        return self._value

    def __str__(self) -> str:
        if self._version == -1 or len(self._value) != _SIZE:
            return "INVALID"
        return f"RIHS{self._version:02x}_{self._value.hex()}"

    def __repr__(self) -> str:
        return f"TypeHash(version={self._version}, value={self._value!r})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TypeHash):
            return False
        return (self._version, self._value) == (other._version, other._value)

    def __hash__(self) -> int:
        return hash((self._version, self._value))
