"""The verbs about components, with a container in another process over DDS."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program

FIRST, SECOND = 2**63, 2**63 + 1


@pytest.fixture(scope="module", autouse=True)
def container(module_domain_id: int, start_module_program: Callable[..., Program]) -> Program:
    program = start_module_program("python", Path(__file__).with_name("a_container.py"))
    program.wait_for("ready")
    return program


def test_components_are_loaded_listed_and_unloaded(container: Program) -> None:
    assert transcript.run_here("component", "list").text == "/a_container"
    options = ("-r", "a:=b", "-p", "rate:=2", "-p", "word:=x", "-e", "use_intra_process_comms:=true")
    loaded = transcript.run_here(
        *("component", "load", "/a_container", "composition", "composition::Talker"),
        *("--node-namespace", "/ns", "--log-level", "debug", *options),
    )
    assert loaded.text == f"Loaded component {FIRST} into '/a_container' container node as '/ns/talker'"
    container.wait_for("loaded 10 ['a:=b'] {'rate': 2, 'word': 'x'} {'use_intra_process_comms': True}")
    second = transcript.run_here(
        "component", "load", "-q", "/a_container", "composition", "Listener", "-n", "ears"
    )
    assert second.text == f"{SECOND}  /ears"
    assert (
        transcript.run_here("component", "list").text
        == f"/a_container\n  {FIRST}  /ns/talker\n  {SECOND}  /ears"
    )
    assert (
        transcript.run_here("component", "list", "a_container").text
        == f"{FIRST}  /ns/talker\n{SECOND}  /ears"
    )
    assert transcript.run_here("component", "list", "--containers-only").text == "/a_container"
    assert json.loads(transcript.run_here("component", "list", "--json").text) == {
        "/a_container": {str(FIRST): "/ns/talker", str(SECOND): "/ears"}
    }
    unloaded = transcript.run_here("component", "unload", "/a_container", str(FIRST))
    assert unloaded.text == f"Unloaded component {FIRST} from '/a_container' container node"
    assert transcript.run_here("component", "unload", "-q", "/a_container", str(SECOND)).text == str(SECOND)
    assert transcript.run_here("component", "list").text == "/a_container"


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("load", "/a_container", "mine", "Nothing"), "Failed to load component: No such plugin in mine"),
        (
            ("unload", "/a_container", "7"),
            "Failed to unload component 7 from '/a_container' container node\n    No node found with that id",
        ),
        (("list", "/a_containe"), "Unable to find container node '/a_containe'\ndid you mean /a_container?"),
        (
            ("load", "/a_container", "mine", "Talker", "-p", "rate"),
            "'rate' is not a parameter: write name:=value",
        ),
    ],
)
def test_what_fails_says_why(words: tuple[str, ...], text: str) -> None:
    answer = transcript.run_here("component", *words)
    assert (answer.exit_code, answer.text) == (1, text)


@pytest.mark.parametrize(
    "words", [("unload", "/a_container", "-1"), ("load", "/c", "p", "P", "--log-level", "loud")]
)
def test_arguments_out_of_range_are_named(words: tuple[str, ...]) -> None:
    answer = transcript.run_here("component", *words)
    assert answer.exit_code == 2
    assert (
        "-1" in answer.text
        or "must be one of unset, debug, info, warn, error, fatal, not 'loud'" in answer.text
    )
