"""The plots that all pages share."""

from __future__ import annotations

import csv
import io
import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.layout.layout import AXES, MAX_PLOT, PlotLayout
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
"""Number of fields that are plotted."""
MAX_CSV_ROWS = 200_000
"""Number of rows of a file of a plot's numbers."""
MIN_LENGTH_S = 1e-6
MAX_LENGTH_S = 1e9
"""Least and greatest length of the time that plots show [s]."""
MAX_STAMP_NS = 2**63 - 1
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
        self.plot = 1
        """Number of the plot in which it is drawn."""
        self.axis = AXES[0]
        self.unroll = False
        """Whether it is an angle that goes on beyond half a turn."""
        self.path: Path | None = None
        """None until the type is known."""
        self.number = START
        """That of the last message it has."""
        self.status = f"nobody publishes {topic} yet"


class _Window(NamedTuple):
    """What pages ask to see of the time."""

    length_ns: int | None = None
    """None: all there is."""
    fixed_ns: tuple[int, int] | None = None
    """Start and end, where the plots are paused or zoomed into [ns since epoch]; None: they follow the newest time."""


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
        self._window = _Window()
        self._zero_ns: int | None = None
        """The time from which pages count while the plots don't follow [ns since epoch]."""

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

    def layout(self) -> tuple[PlotLayout, ...]:
        """Return the plots whose topic was found as a layout has them."""
        return tuple(
            PlotLayout(one.topic, one.field, one.plot, one.axis, one.unroll)
            for one in self._plots.values()
            if one.field
        )

    def add(self, topic: str, field: str, *, number: int = 0, is_there: bool = True) -> None:
        """Plot a field.

        Args:
            topic: The topic.
            field: The path of the field.
            number: Number of the plot, which other fields may share; 0: a plot of its own.
            is_there: Whether the topic has to be there; if not, it is plotted as soon as it is.

        Raises:
            PageError: there are too many plots, no such topic, or no such field, which is then not plotted.
        """
        if (topic, field) in self._plots:
            return
        if len(self._plots) >= MAX_PLOTS:
            raise PageError(f"there are {MAX_PLOTS} plots already")
        plot = _Plot(topic, field, self._length_ns)
        plot.plot = number or min(
            1 + max((other.plot for other in self._plots.values()), default=0), MAX_PLOT
        )
        plot.series.kept_from_ns = self._kept_from_ns
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
                or a message in it alone stands for its numeric fields outside of arrays. They share a plot.

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
            self.add(topic, field, number=plot.plot, is_there=False)

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

    def choose(self, topic: str, field: str, *, number: int, axis: str, unroll: bool) -> None:
        """Choose how a field is drawn.

        Args:
            topic: The topic.
            field: The path of the field.
            number: Number of the plot, which other fields may share.
            axis: The side at which its axis is, one of `AXES`.
            unroll: Whether it is an angle [rad] that goes on beyond half a turn.

        Raises:
            PageError: it is not plotted, or there is no such number or axis.
        """
        if (plot := self._plots.get((topic, field))) is None:
            raise PageError(f"{field} of {topic} is not plotted")
        if not 1 <= number <= MAX_PLOT:
            raise PageError(f"the number of a plot is from 1 to {MAX_PLOT}")
        if axis not in AXES:
            raise PageError(f"the axis of a plot is {' or '.join(AXES)}")
        plot.plot, plot.axis, plot.unroll = number, axis, unroll

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

    def show_time(self, span: Span | None, length_s: float | None, end_ns: int | None) -> None:
        """Show a part of the time in all plots. While it has an end, the numbers of it are kept.

        Args:
            span: The time of the transforms, which the slider has.
            length_s: The length [s]; None: all there is, up to the end.
            end_ns: The end [ns since epoch]; None: the newest time.

        Raises:
            PageError: there is no such length.
        """
        if length_s is not None and not MIN_LENGTH_S <= length_s <= MAX_LENGTH_S:
            raise PageError(f"plots show from {MIN_LENGTH_S:g} s to {MAX_LENGTH_S:g} s")
        whole = self._whole(span)
        length_ns = None if length_s is None else round(1e9 * length_s)
        fixed_ns = None
        if end_ns is None:
            self._zero_ns = None
        else:
            end_ns = min(end_ns, MAX_STAMP_NS)
            fixed_ns = (min(whole[0], end_ns - 1) if length_ns is None else end_ns - length_ns), end_ns
            if self._zero_ns is None:
                self._zero_ns = whole[1]
        self._window = _Window(length_ns, fixed_ns)
        for plot in self._plots.values():
            plot.series.kept_from_ns = self._kept_from_ns

    @property
    def _kept_from_ns(self) -> int | None:
        return None if self._window.fixed_ns is None else self._window.fixed_ns[0]

    def _whole(self, span: Span | None) -> tuple[int, int]:
        """Return the time of all numbers and transforms [ns since epoch]."""
        spans = [plot.series.span for plot in self._plots.values()]
        known = [one for one in spans if one is not None] + ([] if span is None else [tuple(span)])
        end_ns = max((end for _, end in known), default=0)
        start_ns = min((start for start, _ in known), default=0)
        if self._length_ns is not None:
            start_ns = max(start_ns, end_ns - self._length_ns)
        return start_ns, end_ns

    def _shown_time(self, span: Span | None) -> tuple[int, int]:
        """Return the time that the plots show [ns since epoch]."""
        if self._window.fixed_ns is not None:
            return self._window.fixed_ns
        start_ns, end_ns = self._whole(span)
        return (start_ns if self._window.length_ns is None else end_ns - self._window.length_ns), end_ns

    def time(self, span: Span | None) -> dict[str, Any]:
        """Return the time that the plots show as values for JSON, in seconds from a zero.

        The zero is the newest time while the plots follow it, or the time at which they stopped; of a recording, its
        start.

        Args:
            span: The time of the transforms, which the slider has.
        """
        whole, (start_ns, end_ns) = self._whole(span), self._shown_time(span)
        zero_ns = whole[1] if self._zero_ns is None else self._zero_ns
        if self._length_ns is None:
            zero_ns = whole[0]
        return {
            "zero_ns": str(zero_ns),
            "start_s": (start_ns - zero_ns) / 1e9,
            "end_s": (end_ns - zero_ns) / 1e9,
            "whole_s": (whole[1] - whole[0]) / 1e9,
            "is_paused": self._window.fixed_ns is not None,
            "is_zoomed": self._window.length_ns is not None,
        }

    def csv(self, number: int, span: Span | None) -> str:
        """Return the numbers of a plot over the time that is shown, with their times, as comma-separated values.

        Args:
            number: Number of the plot.
            span: The time of the transforms, which the slider has.

        Returns:
            A line with the names of the columns: the time [s since epoch], the time from the first row on [s], and the
            topic and the path of each field; then a line for each stamp. A field without a number there is empty.

        Raises:
            PageError: there is no such plot, or it has more than `MAX_CSV_ROWS` rows.
        """
        fields = [plot for plot in self._plots.values() if plot.plot == number]
        if not fields:
            raise PageError(f"there is no plot {number}")
        window = self._shown_time(span)
        columns = [plot.series.between(*window, unrolls=plot.unroll) for plot in fields]
        stamps = np.unique(np.concatenate([column for column, _ in columns]))
        if len(stamps) > MAX_CSV_ROWS:
            raise PageError(f"there are {len(stamps)} rows, more than {MAX_CSV_ROWS}: zoom in")
        cells = np.full((len(fields), len(stamps)), np.nan)
        for row, (column, values) in zip(cells, columns, strict=True):
            row[np.searchsorted(stamps, column)] = values
        out = io.StringIO()
        writer = csv.writer(out)
        writer.writerow(
            [
                "time [s since epoch]",
                "from the first row [s]",
                *(f"{plot.topic} {plot.field}" for plot in fields),
            ]
        )
        first_ns = int(stamps[0]) if len(stamps) else 0
        for stamp_ns, row in zip(stamps.tolist(), cells.T.tolist(), strict=True):
            texts = ["" if math.isnan(value) else repr(value) for value in row]
            writer.writerow([_seconds_text(stamp_ns), _seconds_text(stamp_ns - first_ns), *texts])
        return out.getvalue()

    def snapshot(self, span: Span | None, held_ns: int | None) -> list[dict[str, Any]]:
        """Return the plots as values for JSON: all over the same time.

        Args:
            span: The time of the transforms, which the slider has.
            held_ns: The time that is shown [ns since epoch]; None: the newest.
        """
        start_ns, end_ns = self._shown_time(span)
        return [self._values(plot, start_ns, end_ns, held_ns) for plot in self._plots.values()]

    def _values(self, plot: _Plot, start_ns: int, end_ns: int, held_ns: int | None) -> dict[str, Any]:
        seconds, values = plot.series.reduced_points(start_ns, end_ns, PARTS, unrolls=plot.unroll)
        status = plot.status
        if not status and values and all(value is None for value in values):
            status = "there is no number at this field: an array is shorter, or the numbers are not finite"
        shown = plot.series.at(held_ns, unrolls=plot.unroll)
        return {
            "topic": shown_text(plot.topic),
            "field": shown_text(plot.field),
            "plot": plot.plot,
            "axis": plot.axis,
            "unroll": plot.unroll,
            "status": status,
            "length_s": (end_ns - start_ns) / 1e9,
            "end_ns": str(end_ns),
            "seconds": seconds,
            "values": values,
            "shown": None if shown is None else float(f"{shown:.7g}"),
        }


def _seconds_text(time_ns: int) -> str:
    """Return a time as seconds with all of its digits, more than a number of 64 bits holds."""
    return f"{time_ns // 1_000_000_000}.{time_ns % 1_000_000_000:09d}"
