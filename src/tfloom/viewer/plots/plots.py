"""The plots that all pages share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.page_command import PageError, fault_text
from tfloom.viewer.plots.field_path import number_at, numeric_paths, parse_path
from tfloom.viewer.plots.series import Series
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_log import START
from tfloom.viewer.topics import TypeNotYetKnownError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tfloom.rosidl.message import Message
    from tfloom.viewer.frames import Span
    from tfloom.viewer.plots.field_path import Path
    from tfloom.viewer.topic_log import Cursor, Entry
    from tfloom.viewer.topics import Topics

__all__ = ["Plots"]

MAX_PLOTS = 12
"""Number of plots."""
READ_S = 0.005
"""How long a topic is read for one picture [s]; one message, or one part of a recording, is read at least."""
PARTS = 200
"""Number of parts of a plot's time, of each of which a page gets the least and the greatest value."""


class _Plot:
    """One field of one topic."""

    def __init__(self, topic: str, field: str, length_ns: int | None) -> None:
        self.topic = topic
        self.field = field
        """Empty: the topic is a path, as of `Plots.seek`."""
        self.series = Series(length_ns)
        self.path: Path | None = None
        """None until the type is known."""
        self.number = START
        """That of the last message it has."""
        self.status = f"nobody publishes {topic} yet"


class Plots:
    """Numeric fields of topics over time. One thread may use it.

    Args:
        topics: The topics.
        length_ns: How long numbers are kept [ns]; None: without limit, as of a recording.
    """

    def __init__(self, topics: Topics, length_ns: int | None) -> None:
        self._topics = topics
        self._length_ns = length_ns
        self._plots: dict[tuple[str, str], _Plot] = {}
        self._cursors: dict[str, Cursor] = {}

    def names(self) -> list[tuple[str, str]]:
        """Return topic and field of each plot whose topic was found."""
        return [(topic, field) for topic, field in self._plots if field]

    def topics(self) -> list[list[str]]:
        """Return the topics with their types, for a page to choose from."""
        return [[shown_text(name), shown_text(kind)] for name, kind in sorted(self._topics.types().items())]

    def fields(self, topic: str) -> list[str]:
        """Return the paths of a topic's numeric fields, of arrays the first element's.

        Raises:
            PageError: there is no such topic, or its type is unknown here.
            TypeNotYetKnownError: its type is searched for.
        """
        try:
            return numeric_paths(self._topics.message_class(topic))
        except TypeNotYetKnownError:
            raise
        except (DisplayError, LookupError, ValueError) as error:
            raise PageError(str(error)) from None

    def add(self, topic: str, field: str, *, is_there: bool = True) -> None:
        """Plot a field.

        Args:
            topic: The topic.
            field: The path of the field.
            is_there: Whether the topic has to be there; if not, it is plotted as soon as it is.

        Raises:
            PageError: there are too many plots, no such topic, or no such field, which is then not plotted.
        """
        if (topic, field) in self._plots:
            return
        if len(self._plots) >= MAX_PLOTS:
            raise PageError(f"there are {MAX_PLOTS} plots already")
        plot = _Plot(topic, field, self._length_ns)
        if is_there:
            try:
                self._open(plot)
            except TypeNotYetKnownError as error:
                plot.status = shown_text(str(error))
        self._plots[topic, field] = plot

    def seek(self, path: str) -> None:
        """Plot what a path of slashes names, as soon as its topic is there.

        Args:
            path: A topic with the names of a field, as `/turtle1/pose/x` or, for several, `/turtle1/pose/x:y`; a topic
                or a message in it alone stands for its numeric fields outside of arrays.

        Raises:
            PageError: there are too many plots.
        """
        self.add(path, "", is_there=False)

    def _find(self, plot: _Plot, types: Mapping[str, str]) -> None:
        """Put the plots that a path means in its place, if its topic is there: the longest name that it begins with."""
        names = (name for name in types if f"{plot.topic}/".startswith(f"{name}/"))
        topic = max(names, key=len, default=None)
        if topic is None:
            return
        *steps, last = plot.topic.removeprefix(topic).removeprefix("/").split("/")
        try:
            fields = self._fields_of(topic, ".".join(steps), last.split(":"))
        except (PageError, DisplayError, LookupError, ValueError) as error:
            plot.status = shown_text(str(error))
            return
        del self._plots[plot.topic, ""]
        for field in fields[: MAX_PLOTS - len(self._plots)]:
            self.add(topic, field, is_there=False)

    def _fields_of(self, topic: str, before: str, last: list[str]) -> list[str]:
        """Return the numeric fields by the end of a path; of a message, those that are outside of arrays.

        Raises:
            PageError: there is no such field.
            DisplayError: the topic's type is not known, or not yet.
        """
        known = self.fields(topic)
        found: list[str] = []
        for name in last:
            field = f"{before}.{name}".strip(".")
            prefix = f"{field}." if field else ""
            within = [
                path for path in known if path.startswith(prefix) and "[" not in path.removeprefix(prefix)
            ]
            if not within and not field:
                raise PageError(f"{topic} has no numbers outside of arrays: name a field")
            if not within:
                parse_path(self._topics.message_class(topic), field)
            found += within or [field]
        return found

    def remove(self, topic: str, field: str) -> None:
        """End a plot."""
        self._plots.pop((topic, field), None)
        if not any(plot.topic == topic for plot in self._plots.values()):
            self._close(topic)

    def _open(self, plot: _Plot) -> None:
        """Begin to read a plot's topic.

        Raises:
            PageError: it can't be read, or has no such field.
            TypeNotYetKnownError: its type is searched for.
        """
        try:
            message_class = self._topics.message_class(plot.topic)
            path = parse_path(message_class, plot.field)
            cursor = self._topics.open(plot.topic)
        except TypeNotYetKnownError:
            raise
        except (DisplayError, LookupError, ValueError) as error:
            raise PageError(str(error)) from None
        # The other plots of the topic have what came so far, which this one lacks.
        others = [other.number for other in self._plots.values() if other.topic == plot.topic]
        cursor.number = min(plot.number, *others) if others else plot.number
        self._close(plot.topic)
        self._cursors[plot.topic] = cursor
        plot.path, plot.status = path, "" if len(plot.series) else "no message yet"
        self._check_others(plot, message_class)

    def _check_others(self, plot: _Plot, message_class: type[Message]) -> None:
        """Look for the fields of a topic's other plots in its type, which may be another one than theirs was."""
        for other in self._plots.values():
            if other.topic == plot.topic and other is not plot and other.path is not None:
                try:
                    other.path = parse_path(message_class, other.field)
                except (PageError, LookupError, ValueError) as error:
                    other.path, other.status = None, shown_text(str(error))

    def _close(self, topic: str) -> None:
        if (cursor := self._cursors.pop(topic, None)) is not None:
            cursor.close()

    def look(self) -> None:
        """Begin to read the topics of plots that are there by now."""
        types = self._topics.types()
        for plot in list(self._plots.values()):
            if not plot.field:
                self._find(plot, types)
            elif plot.topic in types and (plot.path is None or plot.topic not in self._cursors):
                try:
                    self._open(plot)
                except (PageError, TypeNotYetKnownError) as error:
                    plot.status = shown_text(str(error))

    def suspend(self) -> None:
        """End reading topics, because nobody looks; what was read stays."""
        for topic in list(self._cursors):
            self._close(topic)

    def clear(self) -> None:
        """Drop all numbers, and end reading topics until `look`."""
        self.suspend()
        for plot in self._plots.values():
            plot.series.clear()

    def poll(self) -> None:
        """Take what has come, as much as can be read in the time for one picture."""
        for topic, cursor in self._cursors.items():
            plots = [plot for plot in self._plots.values() if plot.topic == topic and plot.path is not None]
            for entry in cursor.read(limit_s=READ_S):
                self._add([plot for plot in plots if plot.number < entry.number], entry)

    def _add(self, plots: list[_Plot], entry: Entry) -> None:
        """Add a message's numbers to the plots that lack them."""
        message, status = None, ""
        if plots:
            try:
                message = entry.message()
            except Exception as error:  # as a DecodeError
                status = shown_text(fault_text(error))
        for plot in plots:
            plot.number, plot.status = entry.number, status
            if entry.begins_anew:
                plot.series.clear()
            if message is not None and plot.path is not None:
                try:
                    plot.series.add(entry.stamp_ns, number_at(message, plot.path))
                except Exception as error:  # of one plot: the others go on
                    plot.status = shown_text(fault_text(error))

    def snapshot(self, span: Span | None, held_ns: int | None) -> list[dict[str, Any]]:
        """Return the plots as values for JSON: all over the same time.

        Args:
            span: The time of the transforms, which the slider has.
            held_ns: The time that is shown [ns since epoch]; None: the newest.
        """
        spans = [plot.series.span for plot in self._plots.values()]
        known = [one for one in spans if one is not None] + ([] if span is None else [tuple(span)])
        end_ns = max((end for _, end in known), default=0)
        start_ns = min((start for start, _ in known), default=0)
        if self._length_ns is not None:
            start_ns = max(start_ns, end_ns - self._length_ns)
        return [self._values(plot, start_ns, end_ns, held_ns) for plot in self._plots.values()]

    def _values(self, plot: _Plot, start_ns: int, end_ns: int, held_ns: int | None) -> dict[str, Any]:
        seconds, values = plot.series.reduced_points(start_ns, end_ns, PARTS)
        status = plot.status
        if not status and values and all(value is None for value in values):
            status = "there is no number at this field: an array is shorter, or the numbers are not finite"
        shown = plot.series.at(held_ns)
        return {
            "topic": shown_text(plot.topic),
            "field": shown_text(plot.field),
            "status": status,
            "length_s": (end_ns - start_ns) / 1e9,
            "end_ns": str(end_ns),
            "seconds": seconds,
            "values": values,
            "shown": None if shown is None else float(f"{shown:.7g}"),
        }
