"""The thread that does what forms ask for: it publishes, calls services, and sends goals."""

from __future__ import annotations

import math
import queue
import threading
import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom._native import ReadyQueue
from tfloom.node.values.names import NameValidationException, validate_full_topic_name
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rmw.shared.peer_types import TypeSearch
from tfloom.rmw.shared.service_request import ServiceRequestError
from tfloom.rmw.typed_names import SEND_GOAL, SEND_GOAL_TYPE, topic_of
from tfloom.rosidl.class_search import UnknownTypeError, find_class_of_kind, full_name
from tfloom.rosidl.definition_files import interface_names
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Action, Service
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.driving.driver import TWIST_TYPES
from tfloom.viewer.forms.asking import Call, Goal, Wire
from tfloom.viewer.forms.filling import fill
from tfloom.viewer.forms.publishing import Publication, Repetition
from tfloom.viewer.forms.task import Learning, Task
from tfloom.viewer.forms.type_form import type_form
from tfloom.viewer.page_command import PageError, number, text

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant, Writer

__all__ = ["FORM_COMMANDS", "Sending"]

FORM_COMMANDS = frozenset(("form_names", "form", "send", "cancel"))
"""The commands of pages that are for forms."""
MAX_COMMANDS = 50
"""Number of commands that wait; a further one is refused."""
MAX_OPEN = 50
"""Number of calls and goals that wait for a server; a further one is refused."""
MAX_WRITERS = 50
"""Number of topics that are published on at a time; of more, the first one that nothing under way uses is left."""
MAX_NAMES = 3000
"""Number of names that a page gets."""
MAX_ANSWER = 20_000
"""Length of a response that a page gets [characters]."""
LOOK_S = 0.05
"""Period at which what is open is looked at [s]; what arrives ends the sleep."""
MAX_RATE_HZ = 100.0
ORPHAN_S = 5.0
"""How long a goal is cancelled whose page was closed [s]."""

Answer = Callable[[dict[str, Any]], None]
KINDS: dict[str, tuple[str, type[Any]]] = {
    "topic": ("msg", Message),
    "service": ("srv", Service),
    "action": ("action", Action),
}
"""By what a form is for: the kind of its types, and their base class."""


class _Open(NamedTuple):
    """What is under way for a page."""

    page: str
    key: str
    """The page's own name for it."""
    task: Task
    tell: Callable[[str, str], None]


class Sending:
    """Does what forms of pages ask for, on a separate thread.

    Args:
        participant: The participant that writes and asks.
        node: The node whose ends these are, which was added to the participant.
        now_ns: Returns the time of the word `now` [ns since epoch].
    """

    def __init__(self, participant: Participant, node: NodeName, now_ns: Callable[[], int]) -> None:
        self._participant = participant
        self._node = node
        self._now_ns = now_ns
        self._arrived = ReadyQueue()
        self._wire = Wire(participant, node, self._arrived)
        self._commands: queue.Queue[tuple[str, Mapping[str, Any], Answer]] = queue.Queue(MAX_COMMANDS)
        self._forgotten: queue.SimpleQueue[str] = queue.SimpleQueue()
        """Pages that were closed."""
        self._is_closed = False
        self._is_left = False
        """Whether the writers are to be closed."""
        # The members below are of the thread alone.
        self._writers: dict[tuple[str, str], Writer] = {}
        self._tasks: list[_Open] = []
        self._learned: list[tuple[str, Mapping[str, Any], Answer, list[str]]] = []
        """Commands whose type was searched for, with the reasons why it was not found."""
        self._orphans: list[tuple[Task, float]] = []
        """What is cancelled because its page was closed, each until when [s, monotonic]."""
        self._thread = threading.Thread(target=self._run, name="tfloom_view_forms", daemon=True)
        self._thread.start()

    def ask(self, page: str, command: Mapping[str, Any], answer: Answer) -> None:
        """Do a page's command, and give it answers later, on another thread.

        Raises:
            PageError: too many wait.
        """
        try:
            self._commands.put_nowait((page, command, answer))
        except queue.Full:
            raise PageError("too many forms wait to be sent") from None
        self._arrived.post(0)

    def forget(self, page: str) -> None:
        """Cancel what a page has begun, because it was closed."""
        self._forgotten.put(page)
        self._arrived.post(0)

    def leave_topics(self) -> None:
        """Close the writers, because no page is open."""
        self._is_left = True
        self._arrived.post(0)

    def close(self) -> None:
        """Cancel what is under way, close the writers, and end the thread."""
        self._is_closed = True
        self._arrived.post(0)
        self._thread.join(ORPHAN_S + 1.0)

    # On the thread.

    def _run(self) -> None:
        while not self._is_closed:
            self._take_commands()
            self._step()
            is_idle = not self._tasks and not self._orphans and not self._learned
            self._arrived.wait(-1 if is_idle else int(self._sleep_s() * 1e9))
        for opened in self._tasks:
            self._cancel_orphan(opened.task)
        self._tasks.clear()
        while self._orphans:
            self._step()
            self._arrived.wait(int(LOOK_S * 1e9))
        self._close_writers()

    def _sleep_s(self) -> float:
        """Return how long to sleep at most: no longer than until the next message at a rate [s]."""
        if self._learned:
            return 0.0
        due_s = min((opened.task.due_s for opened in self._tasks), default=math.inf)
        return max(0.0, min(LOOK_S, due_s - time.monotonic()))

    def _close_writers(self) -> None:
        for writer in self._writers.values():
            writer.close()
        self._writers.clear()

    def _take_commands(self) -> None:
        # A page that is forgotten here has asked for everything before. So its commands, which may still wait, are done
        # first, and what they have begun is cancelled with the rest: nobody could cancel it later.
        forgotten = set()
        while not self._forgotten.empty():
            forgotten.add(self._forgotten.get())
        learned, self._learned = self._learned, []
        for page, command, answer, reasons in learned:
            self._try(page, command, answer, reasons)
        while not self._commands.empty():
            self._try(*self._commands.get())
        for opened in [opened for opened in self._tasks if opened.page in forgotten]:
            self._tasks.remove(opened)
            self._cancel_orphan(opened.task)
        if self._is_left:
            self._is_left = False
            if not self._tasks:  # of a page that was opened since
                self._close_writers()

    def _try(
        self, page: str, command: Mapping[str, Any], answer: Answer, reasons: list[str] | None = None
    ) -> None:
        """Do a command, or say why it can't be done; `reasons` as of `_do`."""
        try:
            self._do(page, command, answer, reasons)
        except PageError as error:
            self._refuse(command, answer, str(error))
        except Exception as error:  # of one form: those after it are still sent
            self._refuse(command, answer, f"{type(error).__name__}: {error}")

    @staticmethod
    def _refuse(command: Mapping[str, Any], answer: Answer, reason: str) -> None:
        """Say why a command was not done, at its form where the page has named one."""
        key = command.get("key")
        if isinstance(key, str):
            answer({"sent": {"key": key[:64], "state": "error", "text": shown_text(reason, 2000)}})
        else:
            answer({"error": shown_text(reason, 500)})

    def _cancel_orphan(self, task: Task) -> None:
        if task.cancel():
            task.close()
        else:
            self._orphans.append((task, time.monotonic() + ORPHAN_S))

    def _step(self) -> None:
        for opened in list(self._tasks):
            if self._is_over(opened.task, opened.tell):
                self._tasks.remove(opened)
        for orphan in list(self._orphans):
            task, end_s = orphan
            if time.monotonic() > end_s:
                task.close()
                self._orphans.remove(orphan)
            elif self._is_over(task, lambda *_: None):
                self._orphans.remove(orphan)

    @staticmethod
    def _is_over(task: Task, tell: Callable[[str, str], None]) -> bool:
        try:
            if not task.step():
                return False
        except (PageError, ServiceRequestError) as error:
            tell("error", str(error))
        except Exception as error:  # of one task: the others go on
            tell("error", f"{type(error).__name__}: {error}")
        task.close()
        return True

    def _do(self, page: str, command: Mapping[str, Any], answer: Answer, reasons: list[str] | None) -> None:
        """Do a command; one whose type has no definition here is done when that was searched for.

        Args:
            page: The page.
            command: The command.
            answer: Gives the page answers.
            reasons: Why the type was not found, if it was searched for; else None.

        Raises:
            PageError: it can't be done.
        """
        operation = text(command, "op")
        if operation == "cancel":
            self._cancel(page, text(command, "key"))
            return
        what = text(command, "what")
        if what not in KINDS:
            raise PageError(f"what has to be {', '.join(KINDS)}")
        if operation == "form_names":
            answer({"form_names": self._names(what)})
            return
        name, type_name = self._resolved(what, text(command, "name"), text(command, "type"))
        try:
            interface_class = _class_of(what, type_name)
        except UnknownTypeError as error:
            if reasons is not None:
                raise PageError("; ".join([str(error), *reasons])) from None
            self._learn(page, command, answer, full_name(type_name, KINDS[what][0]), KINDS[what][0])
            return
        if operation == "form":
            try:
                form = type_form(_filled_class(what, interface_class))
            except (LookupError, ValueError) as error:
                raise PageError(str(error)) from None
            answer({"form": {"what": what, "name": name, "type": type_name, **form}})
            return
        self._send(page, command, answer, (what, name, interface_class))

    def _learn(
        self, page: str, command: Mapping[str, Any], answer: Answer, type_name: str, kind: str
    ) -> None:
        """Do a command when a type was searched for."""
        self._expect_place()
        search = TypeSearch(self._participant, self._node, type_name, kind, self._arrived)
        task = Learning(search, lambda reasons: self._learned.append((page, command, answer, reasons)))
        self._tasks.append(
            _Open(
                page,
                str(command.get("key", ""))[:64],
                task,
                lambda _, said: self._refuse(command, answer, said),
            )
        )

    def _expect_place(self) -> None:
        if len(self._tasks) >= MAX_OPEN:
            raise PageError(f"{MAX_OPEN} calls and goals are under way already")

    def _known_types(self, what: str) -> dict[str, str]:
        """Return the types of the topics, services or actions of the graph by their names."""
        graph = self._participant.graph
        if what == "topic":
            return {end.topic.name: end.topic.type_name for end in graph.endpoints()}
        servers = {end.name: end.type_name for end in graph.service_ends() if end.is_server}
        actions = {
            name.removesuffix(SEND_GOAL): type_name.removesuffix(SEND_GOAL_TYPE)
            for name, type_name in servers.items()
            if name.endswith(SEND_GOAL)
        }
        if what == "action":
            return actions
        return {name: type_name for name, type_name in servers.items() if "/_action/" not in name}

    def _names(self, what: str) -> dict[str, Any]:
        known = {name: type_name for name, type_name in self._known_types(what).items() if "/_" not in name}
        types = sorted({*interface_names(KINDS[what][0]), *known.values()})
        return {
            "what": what,
            "names": [[shown_text(name), shown_text(type_name)] for name, type_name in sorted(known.items())][
                :MAX_NAMES
            ],
            "types": list(map(shown_text, types))[:MAX_NAMES],
        }

    def _resolved(self, what: str, name: str, type_name: str) -> tuple[str, str]:
        """Return the full name and the type: where none is given, that of the graph.

        Raises:
            PageError: it is not a name, no type is given or known, or the graph has another one.
        """
        full = name if name.startswith("/") else f"/{name}"
        try:
            validate_full_topic_name(full, is_service=what != "topic")
        except NameValidationException as error:
            raise PageError(" ".join(str(error).split())) from None
        known = self._known_types(what).get(full)
        kind = KINDS[what][0]
        if type_name.count("/") == 1:
            type_name = type_name.replace("/", f"/{kind}/")
        if known is not None and type_name not in {"", known}:
            raise PageError(f"{full} has the type {known}, not {type_name}")
        if not type_name and known is None:
            raise PageError(f"nobody has {full}: say its type")
        return full, type_name or known or ""

    def _cancel(self, page: str, key: str) -> None:
        for opened in [opened for opened in self._tasks if (opened.page, opened.key) == (page, key)]:
            if opened.task.cancel():
                self._tasks.remove(opened)
                opened.task.close()
                opened.tell(*opened.task.last_word)
            else:
                opened.tell("accepted", "the server is asked to cancel the goal")

    def _send(
        self, page: str, command: Mapping[str, Any], answer: Answer, target: tuple[str, str, type[Any]]
    ) -> None:
        what, name, interface_class = target
        key = text(command, "key")[:64]

        def tell(state: str, said: str) -> None:
            answer({"sent": {"key": key, "state": state, "text": shown_text(said, MAX_ANSWER)}})

        self._expect_place()
        rate_hz = number(command, "rate_hz") if "rate_hz" in command else 0.0
        if rate_hz and (what != "topic" or not 0.0 < rate_hz <= MAX_RATE_HZ):
            raise PageError(f"a rate is for topics, and has to be above 0 and at most {MAX_RATE_HZ:g} Hz")
        message = _filled_class(what, interface_class)()
        values = command.get("values")
        data = fill(message, values, self._now_ns())
        task: Task
        if what == "topic":
            first_tell = (lambda _, said: tell("feedback", said)) if rate_hz else tell
            task = self._publication(name, type(message), data, first_tell)
            if rate_hz:
                message_class = type(message)
                moves = message_class._TYPE_NAME in TWIST_TYPES
                task = Repetition(
                    task,
                    lambda: fill(message_class(), values, self._now_ns()),
                    1.0 / rate_hz,
                    tell,
                    (lambda: fill(message_class(), {}, self._now_ns())) if moves else None,
                )
        elif what == "service":
            task = Call(self._wire, name, interface_class, data, tell)
        else:
            task = Goal(self._wire, name, interface_class, message, tell)
        tell("waiting", "")
        self._tasks.append(_Open(page, key, task, tell))

    def _publication(
        self, name: str, message_class: type[Any], data: bytes, tell: Callable[[str, str], None]
    ) -> Publication:
        readers = [
            end
            for end in self._participant.graph.endpoints()
            if not end.is_writer
            and end.topic.name == name
            and end.topic.type_name == message_class._TYPE_NAME
        ]
        key = name, message_class._TYPE_NAME
        writer = self._writers.get(key)
        if writer is None:
            if len(self._writers) >= MAX_WRITERS:
                self._close_a_writer()
            # A writer that keeps its last messages serves both kinds of subscriptions, but what it keeps also comes to
            # those that begin later; so it does that only where a subscription asks for it.
            wants_kept = any(
                end.qos.resolved().durability is DurabilityPolicy.TRANSIENT_LOCAL for end in readers
            )
            durability = DurabilityPolicy.TRANSIENT_LOCAL if wants_kept else DurabilityPolicy.VOLATILE
            topic = topic_of(message_class, name)
            writer = self._participant.create_writer(self._node, topic, QoS(durability=durability))
            self._writers[key] = writer
        own = sum(end.node == self._node for end in readers)
        return Publication(writer, name, data, (len(readers), own), tell)

    def _close_a_writer(self) -> None:
        """Close the first writer that nothing under way uses.

        Raises:
            PageError: all are used.
        """
        tasks = [*(opened.task for opened in self._tasks), *(task for task, _ in self._orphans)]
        for key, writer in self._writers.items():
            if not any(task.uses(writer) for task in tasks):
                del self._writers[key]
                writer.close()
                return
        raise PageError(f"{MAX_WRITERS} topics are published on already")


def _class_of(what: str, type_name: str) -> type[Any]:
    """Return the class of a type.

    Raises:
        UnknownTypeError: it has no definition here.
        PageError: it is of another kind, or its definition can't be read.
    """
    kind, base = KINDS[what]
    try:
        return find_class_of_kind(type_name, kind, base)
    except UnknownTypeError:
        raise
    except (LookupError, ValueError, OSError) as error:
        raise PageError(str(error)) from None


def _filled_class(what: str, interface_class: type[Any]) -> type[Message]:
    """Return the class of what is filled in: a message, a request or a goal."""
    if what == "topic":
        return interface_class
    filled: type[Message] = interface_class.Request if what == "service" else interface_class.Goal
    return filled
