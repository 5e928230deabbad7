"""Values of YAML, taken by the type that they have to be of; a mistake has its file, its line and the reason."""

from __future__ import annotations

import reprlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from tfloom.common import yaml as user_yaml
from tfloom.viewer.layout.layout import LayoutError

__all__ = ["PlacedYaml"]

Container = TypeVar("Container", dict[Any, Any], list[Any])
MAX_BYTES = 4 * 1024 * 1024
MAX_VALUES = 20_000
"""Number of keys and values of a file, which take a second: many times those of RViz's files."""


class PlacedYaml:
    """The value of a file of YAML.

    Args:
        path: The file.
        repeating: A key of the outermost mapping by which files are known that may repeat keys; the last value counts.

    Raises:
        LayoutError: it can't be read, is too large, is not YAML, or not a mapping.
    """

    def __init__(self, path: Path, repeating: str | None = None) -> None:
        self._path = path
        try:
            with path.open("rb") as file:
                data = file.read(MAX_BYTES + 1)
            if len(data) > MAX_BYTES:
                raise LayoutError(f"{path}: it has more than {MAX_BYTES} bytes")
            root, self._lines = user_yaml.load_placed(data.decode(), repeating, max_values=MAX_VALUES)
        except OSError as error:
            raise LayoutError(f"{path}: {error.strerror or error}") from None
        except UnicodeDecodeError as error:
            line = error.object[: error.start].count(b"\n") + 1
            raise LayoutError(f"{path}:{line}: it is not encoded in UTF-8") from None
        except user_yaml.YamlError as error:
            place = f"{path}:" if error.line is None else f"{path}:{error.line}:"
            raise LayoutError(f"{place} {error.problem}") from None
        if not isinstance(root, dict):
            raise LayoutError(f"{path}:1: it has to be a mapping, as 'fixed_frame: map'")
        self.root: dict[Any, Any] = root

    def error(self, holder: Any, reason: str) -> LayoutError:
        """Return the error of a mapping or a list of this file."""
        line = self._lines.get(id(holder))
        place = f"{self._path}:" if line is None else f"{self._path}:{line}:"
        return LayoutError(f"{place} {reason}")

    def mapping(self, holder: Mapping[Any, Any], key: str) -> dict[Any, Any]:
        """Return a mapping in a mapping; an empty one where there is none.

        Raises:
            LayoutError: it is none.
        """
        return self._container(holder, key, dict, "a mapping")

    def items(self, holder: Mapping[Any, Any], key: str) -> list[Any]:
        """Return a list in a mapping; an empty one where there is none.

        Raises:
            LayoutError: it is none.
        """
        return self._container(holder, key, list, "a list")

    def _container(self, holder: Mapping[Any, Any], key: str, kind: type[Container], what: str) -> Container:
        value = holder.get(key)
        if value is None:
            return kind()
        if not isinstance(value, kind):
            raise self.error(holder, f"{key} has to be {what}")
        return value

    def text(self, holder: Mapping[Any, Any], key: str, default: str = "") -> str:
        """Return a text of a mapping.

        Raises:
            LayoutError: it is none.
        """
        value = holder.get(key, default)
        if not isinstance(value, str):
            raise self.error(holder, f"{key} has to be a text, not {reprlib.repr(value)}")
        return value

    def flag(self, holder: Mapping[Any, Any], key: str, *, default: bool) -> bool:
        """Return a truth value of a mapping.

        Raises:
            LayoutError: it is none.
        """
        value = holder.get(key, default)
        if not isinstance(value, bool):
            raise self.error(holder, f"{key} has to be true or false, not {reprlib.repr(value)}")
        return value

    def number(self, holder: Mapping[Any, Any], key: str, default: float) -> float:
        """Return a finite number of a mapping.

        Raises:
            LayoutError: it is none.
        """
        value = holder.get(key, default)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) < 1e12:
            raise self.error(holder, f"{key} has to be a finite number, not {reprlib.repr(value)}")
        return float(value)

    def point(self, holder: Mapping[Any, Any], key: str) -> tuple[float, float, float]:
        """Return three finite numbers of a mapping.

        Raises:
            LayoutError: they are none.
        """
        value = holder.get(key)
        if isinstance(value, list) and len(value) == 3:
            numbers = [
                part for part in value if isinstance(part, (int, float)) and not isinstance(part, bool)
            ]
            if len(numbers) == 3 and all(
                abs(part) < 1e12 for part in numbers
            ):  # neither nan nor beyond a float
                return float(numbers[0]), float(numbers[1]), float(numbers[2])
        raise self.error(
            holder, f"{key} has to be three numbers, as [1.0, 2.0, 3.0], not {reprlib.repr(value)}"
        )
