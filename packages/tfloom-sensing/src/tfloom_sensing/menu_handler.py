"""Menus of interactive markers: interactive_markers' MenuHandler."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from typing import Any, ClassVar

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerFeedback, MenuEntry
from tfloom_sensing.interactive_marker_server import InteractiveMarkerServer

__all__ = ["EntryContext", "MenuHandler"]

Callback = Callable[[InteractiveMarkerFeedback], Any]


class EntryContext:
    """An entry of a menu."""

    def __init__(self) -> None:
        self.title = ""
        self.command = ""
        self.command_type = 0
        self.sub_entries: list[int] = []
        self.visible = True
        self.check_state = MenuHandler.NO_CHECKBOX
        self.feedback_cb: Callback | None = None


class MenuHandler:
    """A menu of one marker or several, with a callback for each entry."""

    NO_CHECKBOX = 0
    CHECKED = 1
    UNCHECKED = 2

    _BOXES: ClassVar = {NO_CHECKBOX: "", CHECKED: "[x] ", UNCHECKED: "[ ] "}

    def __init__(self) -> None:
        self.top_level_handles_: list[int] = []
        self.entry_contexts_: dict[int, EntryContext] = {}
        self.current_handle_ = 1
        self.managed_markers_: set[str] = set()

    def insert(
        self,
        title: str,
        parent: int | None = None,
        command_type: int = MenuEntry.FEEDBACK,
        command: str = "",
        callback: Callback | None = None,
    ) -> int | None:
        """Add an entry at the end of the menu, or of an entry's own menu.

        Args:
            title: Its text.
            parent: Handle of the parent entry; None: the entry is at the top level.
            command_type: Action of the client on selection, as MenuEntry.FEEDBACK.
            command: Command for the other types.
            callback: Called with the feedback, on a thread of the node's executor.

        Returns:
            The entry's handle; None, with a line on stderr, if `parent` does not exist.
        """
        if parent is not None and parent not in self.entry_contexts_:
            print(f"Parent menu entry '{parent}' not found", file=sys.stderr)
            return None
        handle = self.doInsert(title, command_type, command, callback)
        above = self.top_level_handles_ if parent is None else self.entry_contexts_[parent].sub_entries
        above.append(handle)
        return handle

    def doInsert(self, title: str, command_type: int, command: str, feedback_cb: Callback | None) -> int:
        """Create an entry outside of the menu, and return its handle."""
        handle = self.current_handle_
        self.current_handle_ += 1
        entry = self.entry_contexts_[handle] = EntryContext()
        entry.title, entry.feedback_cb = title, feedback_cb
        entry.command, entry.command_type = command, command_type
        return handle

    def setVisible(self, handle: int, visible: bool) -> bool:
        """Show or hide an entry and its descendants, and return whether the entry exists."""
        entry = self.entry_contexts_.get(handle)
        if entry is not None:
            entry.visible = visible
        return entry is not None

    def setCheckState(self, handle: int, check_state: int) -> bool:
        """Set an entry's box (`CHECKED`, `UNCHECKED`, `NO_CHECKBOX`), and return whether the entry exists."""
        entry = self.entry_contexts_.get(handle)
        if entry is not None:
            entry.check_state = check_state
        return entry is not None

    def getCheckState(self, handle: int) -> int | None:
        """Return an entry's box; None if the entry does not exist."""
        entry = self.entry_contexts_.get(handle)
        return None if entry is None else entry.check_state

    def getTitle(self, handle: int) -> str | None:
        """Return an entry's text; None if the entry does not exist."""
        entry = self.entry_contexts_.get(handle)
        return None if entry is None else entry.title

    def apply(self, server: InteractiveMarkerServer, marker_name: str) -> bool:
        """Copy the current menu to a marker, and return whether the marker exists.

        The server's `applyChanges` publishes it.
        """
        marker = server.get(marker_name)
        if marker is None:
            self.managed_markers_.discard(marker_name)
            return False
        marker.menu_entries = []
        self.pushMenuEntries(self.top_level_handles_, marker.menu_entries, 0)
        server.insert(
            marker,
            feedback_callback=self.processFeedback,
            feedback_type=InteractiveMarkerFeedback.MENU_SELECT,
        )
        self.managed_markers_.add(marker_name)
        return True

    def reApply(self, server: InteractiveMarkerServer) -> bool:
        """Copy the current menu to all markers that have it, and return whether all still exist."""
        all_there = True
        for name in sorted(self.managed_markers_):
            all_there = self.apply(server, name) and all_there
        return all_there

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Call the callback of the selected entry."""
        entry = self.entry_contexts_.get(feedback.menu_entry_id)
        if entry is not None and entry.feedback_cb is not None:
            entry.feedback_cb(feedback)

    def pushMenuEntries(
        self, handles_in: Iterable[int], entries_out: list[MenuEntry], parent_handle: int
    ) -> bool:
        """Append the visible entries of `handles_in` and their descendants as messages.

        Returns:
            Whether all handles exist. At the first that does not, the rest is omitted, with a line on stderr.
        """
        for handle in handles_in:
            entry = self.entry_contexts_.get(handle)
            if entry is None:
                print(
                    "Internal error: context handle not found! This is a bug in MenuHandler.", file=sys.stderr
                )
                return False
            if not entry.visible:
                continue
            entries_out.append(self.makeEntry(entry, handle, parent_handle))
            if not self.pushMenuEntries(entry.sub_entries, entries_out, handle):
                return False
        return True

    def makeEntry(self, context: EntryContext, handle: int, parent_handle: int) -> MenuEntry:
        """Return an entry as a message."""
        return MenuEntry(
            id=handle,
            parent_id=parent_handle,
            title=self._BOXES.get(context.check_state, "") + context.title,
            command=context.command,
            command_type=context.command_type,
        )
