"""Test descriptions that are launched several times, with other arguments."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

__all__ = ["Parametrized", "parametrize"]


class Parametrized:
    """A function with several sets of arguments; iterating over it gives, for each, the function and the arguments."""

    __parametrized__ = True

    def __init__(self, function: Callable[..., Any], sets: Sequence[dict[str, Any]]) -> None:
        functools.update_wrapper(self, function)  # its name and its docstring
        self._runs = [(self._bind_arguments(function, arguments), arguments) for arguments in sets]

    @staticmethod
    def _bind_arguments(function: Callable[..., Any], arguments: dict[str, Any]) -> Callable[..., Any]:
        bound = functools.partial(function, **arguments)
        functools.update_wrapper(bound, function)
        return bound

    def __iter__(self) -> Iterator[tuple[Callable[..., Any], dict[str, Any]]]:
        return iter(self._runs)

    def __call__(self) -> Iterator[tuple[Callable[..., Any], dict[str, Any]]]:
        """Return the functions and the arguments; pytest's marks can be set only on what can be called."""
        return iter(self)


def parametrize(
    argnames: str | Sequence[str], argvalues: Iterable[Any]
) -> Callable[[Callable[..., Any]], Parametrized]:
    """Return a decorator of `generate_test_description`, which is then launched once for each of the values.

    Args:
        argnames: Name of an argument, or several, as a sequence or with commas between them. The tests of each launch
            get the values by the same names.
        argvalues: A value for each launch, or a sequence of as many as there are names, as `(1,)` for one name.

    Raises:
        ValueError: there are more or fewer values than names.
    """
    words = argnames.split(",") if isinstance(argnames, str) else argnames
    names = [name.strip() for name in words if name.strip()]
    sets = []
    for values in argvalues:
        is_row = len(names) > 1 or (isinstance(values, (tuple, list)) and len(values) == 1)
        row = list(values) if is_row else [values]
        if len(row) != len(names):
            raise ValueError(
                f"parametrize: {len(names)} names ({', '.join(names)}), but {len(row)} values: {values!r}"
            )
        sets.append(dict(zip(names, row, strict=True)))
    return lambda function: Parametrized(function, sets)
