"""What is shown: order, filter, the selected row, the pair that is followed; and what each key does."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tfloom.tf2_tools.top.rows import SORTS, Health, Row

HELP = "q quit  ↑↓ select  s sort  r reverse  / filter  f follow a pair  p pause"


class View:
    """The state that keys change.

    Attributes:
        sort: The name of the order, of SORTS.
        is_reversed: Whether the order is reversed.
        words: What rows must contain, in a name or a note; empty: all rows are shown.
        pair: Target and source frame of the transform that is followed; None: none.
        is_paused: Whether the figures stay as they are.
        is_over: Whether the user has asked to quit.
        selected: The row's number among those that are shown.
    """

    def __init__(self, sort: str = "tree", words: str = "", pair: tuple[str, str] | None = None) -> None:
        self.sort = sort
        self.is_reversed = False
        self.words = words
        self.pair = pair
        self.is_paused = False
        self.is_over = False
        self.selected = 0
        self._first = 0
        self._prompt = ""
        self._typed = ""
        self._shown: list[Row] = []
        self._height = 1
        self._actions: dict[str, Callable[[], None]] = {
            "q": self._quit,
            "end": self._select_last,
            "s": self._sort_by_the_next,
            "r": self._reverse,
            "p": self._pause,
            "/": self._ask_for_words,
            "f": self._ask_for_a_pair,
            "escape": self._show_all,
        }

    def arrange(self, rows: Sequence[Row]) -> list[Row]:
        """Return the rows that match the filter, in order; branches are of a whole tree alone."""
        words = self.words.lower().split()
        shown = [row for row in rows if all(word in _text(row) for word in words)] if words else list(rows)
        if self.sort != "tree":
            shown = sorted((row for row in shown if row.health is not Health.ROOT), key=SORTS[self.sort])
        if self.is_reversed:
            shown.reverse()
        # Branches connect a row with those above it, which now are others or missing.
        if self.sort != "tree" or self.is_reversed or words:
            shown = [row._replace(prefix="") for row in shown]
        self._shown = shown
        self.selected = max(0, min(self.selected, len(shown) - 1))
        return shown

    def window(self, height: int) -> range:
        """Return the numbers of the rows that fit on `height` lines, the selected one among them."""
        self._height = max(1, height)
        # Scroll no further than needed to show the selected row, then fill the screen if the list has become shorter.
        self._first = min(self._first, self.selected)
        self._first = max(self._first, self.selected - self._height + 1)
        self._first = max(0, min(self._first, len(self._shown) - self._height))
        return range(self._first, min(self._first + self._height, len(self._shown)))

    @property
    def prompt(self) -> str:
        """What is being typed, with its question; empty if nothing is."""
        return f"{self._prompt}: {self._typed}▏" if self._prompt else ""

    def press(self, key: str) -> None:
        """Take one key: a letter, or a name as `up` or `enter`."""
        if self._prompt:
            self._type(key)
        elif key in MOVES:
            self.selected = max(0, self.selected + MOVES[key](self._height))
        elif key in self._actions:
            self._actions[key]()

    def _quit(self) -> None:
        self.is_over = True

    def _select_last(self) -> None:
        self.selected = max(0, len(self._shown) - 1)

    def _sort_by_the_next(self) -> None:
        names = list(SORTS)
        self.sort = names[(names.index(self.sort) + 1) % len(names)]

    def _reverse(self) -> None:
        self.is_reversed = not self.is_reversed

    def _pause(self) -> None:
        self.is_paused = not self.is_paused

    def _ask_for_words(self) -> None:
        self._prompt, self._typed = "filter", self.words

    def _ask_for_a_pair(self) -> None:
        self._prompt, self._typed = "follow TARGET SOURCE", self._proposed_pair()

    def _show_all(self) -> None:
        self.words, self.pair = "", None

    def _proposed_pair(self) -> str:
        if self.pair is not None:
            return " ".join(self.pair)
        if not self._shown:
            return ""
        row = self._shown[self.selected]
        return f"{row.parent or row.child} {row.child}"

    def _type(self, key: str) -> None:
        if key == "escape":
            self._prompt = ""
        elif key == "backspace":
            self._typed = self._typed[:-1]
        elif key == "clear":
            self._typed = ""
        elif key == "enter":
            self._accept()
        elif len(key) == 1 and key.isprintable():
            self._typed += key

    def _accept(self) -> None:
        if self._prompt == "filter":
            self.words = self._typed.strip()
            self._prompt = ""
            return
        frames = self._typed.split()
        if len(frames) in {0, 2}:
            self.pair = (frames[0], frames[1]) if frames else None
            self._prompt = ""


MOVES: dict[str, Callable[[int], int]] = {
    "up": lambda _: -1,
    "k": lambda _: -1,
    "down": lambda _: 1,
    "j": lambda _: 1,
    "page up": lambda height: -height,
    "page down": lambda height: height,
    "home": lambda _: -1_000_000,
}
"""By how many rows a key moves the selection, from the number of rows on the screen."""


def _text(row: Row) -> str:
    return f"{row.child}\n{row.parent}\n{row.publisher}\n{row.note}\n{row.health.name}".lower()
