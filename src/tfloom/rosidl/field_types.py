"""The types of numeric arrays, for type checkers: what a field accepts and returns. Not imported at run time."""

from __future__ import annotations

from array import array
from collections.abc import Iterable
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

IntArray = array[int]
FloatArray = array[float]
Integers: TypeAlias = Iterable[int] | bytes | npt.NDArray[Any]
Floats: TypeAlias = Iterable[float] | npt.NDArray[Any]
NumpyArray = np.ndarray[Any, np.dtype[Any]]
