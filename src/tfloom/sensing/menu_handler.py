"""Menus of interactive markers: interactive_markers' MenuHandler."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from typing import Any, ClassVar

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerFeedback, MenuEntry
from tfloom.sensing.interactive_marker_server import InteractiveMarkerServer

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
    """A menu, for one marker or several, and what is called when a user selects an entry."""

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
            parent: Handle of the entry above; None: none.
            command_type: What a client does when it is selected, as MenuEntry.FEEDBACK.
            command: What it runs, for other types.
            callback: Called with the feedback, on a thread of the node's executor.

        Returns:
            The entry's handle; None where there is no entry `parent`, with a line on stderr.
        """
        if parent is not None and parent not in self.entry_contexts_:
            print(f"Parent menu entry '{parent}' not found", file=sys.stderr)
            return None
        handle = self.doInsert(title, command_type, command, callback)
        above = self.top_level_handles_ if parent is None else self.entry_contexts_[parent].sub_entries
        above.append(handle)
        return handle

    def doInsert(  # noqa: N802  # their name
        self, title: str, command_type: int, command: str, feedback_cb: Callback | None
    ) -> int:
        """Make an entry that stands in no menu yet, and return its handle."""
        handle = self.current_handle_
        self.current_handle_ += 1
        entry = self.entry_contexts_[handle] = EntryContext()
        entry.title, entry.feedback_cb = title, feedback_cb
        entry.command, entry.command_type = command, command_type
        return handle

    def setVisible(self, handle: int, visible: bool) -> bool:  # noqa: N802  # their name
        """Show or hide an entry with all below it, and return whether there is such an entry."""
        entry = self.entry_contexts_.get(handle)
        if entry is not None:
            entry.visible = visible
        return entry is not None

    def setCheckState(self, handle: int, check_state: int) -> bool:  # noqa: N802  # their name
        """Set an entry's box (`CHECKED`, `UNCHECKED`, `NO_CHECKBOX`), and return whether there is such an entry."""
        entry = self.entry_contexts_.get(handle)
        if entry is not None:
            entry.check_state = check_state
        return entry is not None

    def getCheckState(self, handle: int) -> int | None:  # noqa: N802  # their name
        """Return an entry's box; None where there is no such entry."""
        entry = self.entry_contexts_.get(handle)
        return None if entry is None else entry.check_state

    def getTitle(self, handle: int) -> str | None:  # noqa: N802  # their name
        """Return an entry's text; None where there is no such entry."""
        entry = self.entry_contexts_.get(handle)
        return None if entry is None else entry.title

    def apply(self, server: InteractiveMarkerServer, marker_name: str) -> bool:
        """Give a marker this menu as it is now, and return whether there is such a marker.

        Clients see it after the server's `applyChanges`.
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

    def reApply(self, server: InteractiveMarkerServer) -> bool:  # noqa: N802  # their name
        """Give all markers that have the menu the menu as it is now, and return whether all are still there."""
        all_there = True
        for name in sorted(self.managed_markers_):
            all_there = self.apply(server, name) and all_there
        return all_there

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:  # noqa: N802  # their name
        """Call the callback of the entry that was selected."""
        entry = self.entry_contexts_.get(feedback.menu_entry_id)
        if entry is not None and entry.feedback_cb is not None:
            entry.feedback_cb(feedback)

    def pushMenuEntries(  # noqa: N802  # their name
        self, handles_in: Iterable[int], entries_out: list[MenuEntry], parent_handle: int
    ) -> bool:
        """Append the visible ones of some entries, each with all below it, as messages.

        Returns:
            Whether there are all these entries; else what follows the first that isn't there is left out, with a line
            on stderr.
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

    def makeEntry(self, context: EntryContext, handle: int, parent_handle: int) -> MenuEntry:  # noqa: N802  # their name
        """Return an entry as a message."""
        return MenuEntry(
            id=handle,
            parent_id=parent_handle,
            title=self._BOXES.get(context.check_state, "") + context.title,
            command=context.command,
            command_type=context.command_type,
        )
