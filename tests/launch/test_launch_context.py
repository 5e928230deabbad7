"""The context: variables, configurations, environment, handlers and events."""

from __future__ import annotations

import asyncio
import os

import pytest

from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.event_handler import EventHandler
from tfloom.launch.utilities.argument_types import ensure_argument_type, is_a, is_a_subclass, isclassinstance
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions


def test_variables_are_attributes() -> None:
    context = LaunchContext(argv=["a:=b"], noninteractive=True)
    assert (context.argv, context.noninteractive, context.is_shutdown) == (["a:=b"], True, False)
    context.extend_globals({"whole": 1})
    context.extend_locals({"part": 2})
    assert (context.locals.whole, context.locals.part) == (1, 2)
    assert context.get_locals_as_dict() == {"whole": 1, "part": 2}
    with pytest.raises(AttributeError, match=r"context\.locals does not contain attribute 'none'"):
        _ = context.locals.none
    with pytest.raises(ValueError, match="cannot overwrite existing global 'whole'"):
        context.extend_globals({"whole": 3})


def test_what_is_pushed_is_restored(context: LaunchContext) -> None:
    context.extend_locals({"part": 1})
    context.launch_configurations["who"] = "me"
    context._push_locals()
    context._push_launch_configurations()
    context.extend_locals({"part": 2})
    context.launch_configurations["who"] = "you"
    context._pop_locals()
    context._pop_launch_configurations()
    assert context.locals.part == 1
    assert context.launch_configurations == {"who": "me"}
    for pop in (context._pop_locals, context._pop_launch_configurations, context._pop_environment):
        with pytest.raises(RuntimeError, match="unexpectedly empty"):
            pop()


def test_the_environment_is_that_of_the_process(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FIRST", "1")
    context = LaunchContext()
    context._push_environment()
    os.environ["FIRST"] = "2"
    os.environ["SECOND"] = "2"
    assert context.environment["FIRST"] == "2"
    context._pop_environment()
    assert (os.environ["FIRST"], os.environ.get("SECOND")) == ("1", None)
    os.environ["FIRST"] = "3"
    context._reset_environment()
    assert os.environ["FIRST"] == "1"


def test_handlers_are_asked_in_order_and_removed(context: LaunchContext) -> None:
    handlers = [EventHandler(matcher=lambda _: True) for _ in range(3)]
    context.register_event_handler(handlers[0])
    context.register_event_handler(handlers[1])
    context.register_event_handler(handlers[2], append=True)
    assert list(context.run_state.handlers) == [handlers[1], handlers[0], handlers[2]]
    assert context.would_handle_event(Event())
    for handler in handlers:
        context.unregister_event_handler(handler)
    assert not context.would_handle_event(Event())
    with pytest.raises(ValueError, match="not in"):
        context.unregister_event_handler(handlers[0])


def test_a_handler_describes_itself() -> None:
    handler = EventHandler(matcher=lambda _: False, handle_once=True)
    text, entities = handler.describe()
    assert text == "EventHandler(matcher='None', handler='<actions>', handle_once=True)"
    assert entities == []


def test_substitutions_are_performed_in_a_row() -> None:
    parts = normalize_to_list_of_substitutions(["a", TextSubstitution(text="b")])
    assert perform_substitutions(LaunchContext(), parts) == "ab"
    assert [part.describe() for part in parts] == ["'a'", "'b'"]


@pytest.mark.parametrize("wrong", [1, None, ["a", 1], [["a"]]])
def test_what_is_no_substitution_is_refused(wrong: object) -> None:
    with pytest.raises(TypeError, match="ubstitution"):
        normalize_to_list_of_substitutions(wrong)
    with pytest.raises(TypeError, match="expected Text"):
        TextSubstitution(text=wrong)


def test_arguments_are_checked() -> None:
    ensure_argument_type(1, int, "count")
    ensure_argument_type("a", [int, str], "count")
    ensure_argument_type(bool, int, "count")
    with pytest.raises(
        TypeError, match=r"'f' expected 'count' to be one of \[<class 'int'>, <class 'str'>\]"
    ):
        ensure_argument_type(1.5, [int, str], "count", "f")
    with pytest.raises(TypeError, match="not a type"):
        ensure_argument_type(1, ["int"], "count")


def test_instances_are_told_from_classes() -> None:
    assert isclassinstance(1)
    assert not isclassinstance(int)
    assert not isclassinstance(len)
    assert not isclassinstance(os)
    assert is_a(True, int)
    assert not is_a(bool, int)
    assert is_a_subclass(bool, int)
    assert is_a_subclass(True, int)
    assert not is_a_subclass("a", int)


def test_tests_may_set_what_the_service_sets(context: LaunchContext) -> None:
    context._set_is_shutdown(True)
    assert context.is_shutdown
    loop = asyncio.new_event_loop()
    context._set_asyncio_loop(loop)
    assert context.asyncio_loop is loop
    context._set_asyncio_loop(None)
    loop.close()
    assert context.asyncio_loop is None
