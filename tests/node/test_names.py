"""Validation and expansion of names."""

from __future__ import annotations

import pytest

from tfloom.node.values.names import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    expand_topic_name,
    topic_or_service_is_hidden,
    validate_full_topic_name,
    validate_namespace,
    validate_node_name,
    validate_topic_name,
)


@pytest.mark.parametrize(
    ("name", "full"),
    [
        ("chatter", "/ns/chatter"),
        ("/chatter", "/chatter"),
        ("~/x", "/ns/me/x"),
        ("~", "/ns/me"),
        ("{node}/x", "/ns/me/x"),
        ("{ns}/x", "/ns/x"),
        ("a/{namespace}", "/ns/a//ns"),
    ],
)
def test_relative_names_are_expanded(name: str, full: str) -> None:
    assert expand_topic_name(name, "me", "/ns") == full


def test_root_namespace_adds_no_prefix() -> None:
    assert expand_topic_name("chatter", "me", "/") == "/chatter"
    assert expand_topic_name("~/x", "me", "/") == "/me/x"


@pytest.mark.parametrize(
    ("name", "index", "text"),
    [
        ("", 0, "empty"),
        ("a/", 1, "end with a forward slash"),
        ("a b", 1, "characters other than"),
        ("a/1b", 2, "start with a number"),
        ("9", 0, "start with a number"),
        ("a{", 1, "curly braces"),
        ("a}b", 1, "curly braces"),
        ("{a-b}", 2, "substitution name must not contain"),
        ("{1b}", 1, "substitution name must not start"),
        ("a/~", 2, "tilde '~' unless it is the first"),
        ("~ab", 1, "not followed by a forward slash"),
    ],
)
def test_invalid_topic_name_error_has_the_index(name: str, index: int, text: str) -> None:
    with pytest.raises(InvalidTopicNameException, match=text) as caught:
        validate_topic_name(name)
    assert caught.value.invalid_index == index
    assert str(caught.value).endswith(f"\n  '{name}'\n   {' ' * index}^")
    with pytest.raises(InvalidServiceNameException):
        validate_topic_name(name, is_service=True)


@pytest.mark.parametrize("name", ["chatter", "/a/b_c", "~/x", "~", "{node}/a", "a/_hidden"])
def test_valid_topic_names_are_accepted(name: str) -> None:
    assert validate_topic_name(name)


@pytest.mark.parametrize("name", ["", "a", "/a/", "/a//b", "/1", "/a-b", "/" + "a" * 300])
def test_invalid_full_names_are_rejected(name: str) -> None:
    with pytest.raises(InvalidTopicNameException):
        validate_full_topic_name(name)


@pytest.mark.parametrize("name", ["", "a/b", "1a", "a b", "ä", "a" * 256])
def test_invalid_node_names_are_rejected(name: str) -> None:
    with pytest.raises(InvalidNodeNameException):
        validate_node_name(name)


@pytest.mark.parametrize("name", ["", "a", "/a/", "/a//b", "/1", "/a b", "/" + "a" * 245])
def test_invalid_namespaces_are_rejected(name: str) -> None:
    with pytest.raises(InvalidNamespaceException):
        validate_namespace(name)


def test_unknown_substitution_is_rejected() -> None:
    with pytest.raises(InvalidTopicNameException, match=r"unknown substitution: \{robot\}"):
        expand_topic_name("/{robot}/x", "me", "/")


def test_names_with_a_leading_underscore_are_hidden() -> None:
    assert topic_or_service_is_hidden("/a/_b/c")
    assert not topic_or_service_is_hidden("/a/b_")


def test_repeated_slashes_have_the_text_of_the_reference() -> None:
    with pytest.raises(InvalidTopicNameException) as topic:
        validate_full_topic_name("/a//b")
    with pytest.raises(InvalidNamespaceException) as namespace:
        validate_namespace("/a//b")
    assert (
        str(topic.value)
        == "Invalid topic name: topic name must not contain repeated '/':\n  '/a//b'\n      ^"
    )
    assert (
        str(namespace.value)
        == "Invalid namespace: namespace must not contain repeated '/':\n  '/a//b'\n      ^"
    )


def test_invalid_names_raise_a_value_error() -> None:
    """The reference raises ValueError itself when it expands a name."""
    for expand in (
        lambda: expand_topic_name("a b", "me", "/"),
        lambda: expand_topic_name("a", "m e", "/"),
        lambda: expand_topic_name("a", "me", "x"),
        lambda: validate_node_name(""),
    ):
        with pytest.raises(
            ValueError, match=r"^((topic|node) name|node namespace) '.*' is invalid: |^Invalid node name: "
        ):
            expand()
