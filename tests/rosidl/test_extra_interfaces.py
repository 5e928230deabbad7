"""The interface packages of the distribution `tfloom-interfaces`, and hashes that real systems have printed."""

from __future__ import annotations

import functools
import importlib
import json
from pathlib import Path

import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore
from tests.each import for_each
from tests.test_facades import ROS_NAMES, RULES, Rule

from tfloom.ros_imports.distributions import INTERFACES, find_prefix
from tfloom.ros_imports.modules import module_leaf
from tfloom.rosidl import cdr, class_table, generate, spec
from tfloom.rosidl.registry import find_class, get_message_class
from tfloom.rosidl.type_hash import type_hash
from tfloom.workspace.get_interfaces import get_interfaces

ROOT = Path(__file__).parents[2]
HOME = ROOT / "packages" / "tfloom-interfaces" / "src" / "tfloom_interfaces"
HASHES = json.loads((ROOT / "tests" / "golden" / "interface_hashes.json").read_text("utf-8"))["hashes"]
own = functools.cache(generate.load_definitions)


@functools.cache
def files() -> dict[str, str]:
    return generate.generate_extra(HOME)


@functools.cache
def extra() -> dict[str, spec.Interface]:
    return generate.load_definitions(HOME / "definitions")


@functools.cache
def specs() -> dict[str, spec.Message]:
    return {
        message.name: message
        for interface in (own() | extra()).values()
        for message in spec.messages_of(interface)
    }


@functools.cache
def listed() -> dict[str, list[str]]:
    return get_interfaces()


def test_the_names_of_its_packages_are_those_in_error_texts() -> None:
    packages = {name.partition("/")[0] for name in extra()}
    assert packages == set(INTERFACES.ros_packages)
    assert not packages & {name.partition("/")[0] for name in own()}


def test_what_is_installed_is_this_checkouts() -> None:
    prefix = find_prefix(INTERFACES)
    assert prefix is not None, "run `make setup`"
    for path in files():
        assert (prefix / path).read_text("utf-8") == files()[path], "run `make setup`"


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_each_facade_keeps_the_rules_of_facades(rule: Rule) -> None:
    prefix = find_prefix(INTERFACES)
    assert prefix is not None
    assert ROS_NAMES.is_dir()
    broken = [
        line for line in rule(prefix / "ros_names") if ": from tfloom_interfaces.interfaces" not in line
    ]
    assert not broken, "\n".join(broken)


@for_each(lambda: sorted(extra()))
def test_each_is_found_by_name_and_by_import(name: str) -> None:
    package, kind, base = name.split("/")
    cls = find_class(name)
    assert type_hash(extra()[name], specs().__getitem__) == cls._TYPE_HASH
    assert getattr(importlib.import_module(f"{package}.{kind}"), base) is cls
    assert cls.__module__ == f"{package}.{kind}.{module_leaf(base)}"
    assert f"{kind}/{base}" in listed()[package]
    for message in spec.messages_of(extra()[name]):
        made = class_table.find(message.name)()
        assert cdr.decode(type(made), cdr.encode(made)) == made


@pytest.mark.parametrize("name", sorted(HASHES))
def test_hashes_that_real_systems_have_printed(name: str) -> None:
    message_class = get_message_class(name)
    assert (name, HASHES[name]) == (message_class._TYPE_NAME, message_class._TYPE_HASH)


def reference_hashes() -> list[dict[str, str]]:
    """Return the hashes that the reference's generator gave the newer packages: of messages and all derived types."""
    text = (ROOT / "tests" / "golden" / "more_type_hashes.jsonl").read_text("utf-8")
    return [json.loads(line) for line in text.splitlines()]


@functools.cache
def interfaces_with_parts() -> dict[str, spec.Interface]:
    """Return the interfaces of this distribution, and the messages and services that they consist of."""
    parts: dict[str, spec.Interface] = dict(extra())
    for interface in extra().values():
        parts |= {message.name: message for message in spec.messages_of(interface)}
        if isinstance(interface, spec.Action):
            parts |= {service.name: service for service in (interface.send_goal, interface.get_result)}
    return parts


@for_each(reference_hashes, name=lambda entry: entry["type"])
def test_hashes_are_those_of_the_references_generator(entry: dict[str, str]) -> None:
    name = entry["type"]
    package, kind, base = name.split("/")
    assert getattr(importlib.import_module(f"{package}.{kind}"), base.partition("_")[0])._TYPE_NAME
    assert type_hash(interfaces_with_parts()[name], specs().__getitem__) == entry["hash"]


def written_parts() -> list[spec.Message]:
    """Return what the definitions write: messages, and requests, responses, goals, results and feedback.

    The parts of services and actions get names of messages, because rosbags hashes those alone.
    """
    parts: list[spec.Message] = []
    for interface in extra().values():
        if isinstance(interface, spec.Service):
            parts += [interface.request, interface.response]
        elif isinstance(interface, spec.Action):
            parts += [interface.goal, interface.result, interface.feedback]
        else:
            parts.append(interface)
    return [part._replace(name=message_name(part.name)) for part in parts]


def message_name(name: str) -> str:
    package, _, base = name.split("/")
    return f"{package}/msg/{base.replace('_', '')}"


@functools.cache
def store() -> Typestore:
    return get_typestore(Stores.EMPTY)


def add_to_store(message: spec.Message) -> None:
    if message.name in store().fielddefs:
        return
    for name in message.references:
        add_to_store(specs()[name])
    text = "".join(f"{field.type} {field.name}\n" for field in message.fields)
    store().register(get_types_from_msg(text, message.name))


@for_each(written_parts(), name=lambda part: part.name)
def test_hashes_are_those_of_rosbags(message: spec.Message) -> None:
    add_to_store(message)
    assert store().hash_rihs01(message.name) == type_hash(message, specs().__getitem__)
