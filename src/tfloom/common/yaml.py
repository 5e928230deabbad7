"""The loader of all YAML that a user gives: in a file, in an argument, on standard input.

YAML's aliases may make a text of a hundred bytes stand for more values than fit into memory, and nested collections
exhaust the stack of a recursive program. So both have limits here. Text without aliases may have any length, unless the
caller gives a limit: a hundred thousand values take seconds. Tabs stand where rcl takes them, see `yaml_scanner`.
Import this module where it is used, because yaml takes 15 ms to load.
"""

from __future__ import annotations

import reprlib
from collections.abc import Callable
from typing import Any

import yaml
from yaml.composer import Composer
from yaml.constructor import SafeConstructor
from yaml.parser import Parser
from yaml.resolver import Resolver

from tfloom.common.text import PlainValue, QuotedText
from tfloom.common.yaml_scanner import TabScanner

__all__ = ["YamlError", "YamlLimitError", "compose_all", "load", "load_placed", "load_plain"]

_STRING_TAG = "tag:yaml.org,2002:str"
"""The tag of strings, `!!str` in a text."""

MAX_EXPANDED_SIZE = 1_000_000
"""Values and characters that all aliases of a text may stand for."""
MAX_DEPTH = 100
"""Levels of collections in collections, aliases expanded."""


class YamlError(ValueError):
    """A text isn't YAML.

    Attributes:
        problem: What is wrong.
        line: Line of the text, from 1; None if it isn't known.
        place: " at line 1, column 2", both from 1; "" if it isn't known.
        snippet: The line, and a mark below the place; "" if it isn't known.
    """

    def __init__(self, problem: str, mark: Any = None) -> None:
        self.problem = problem
        self.line: int | None = mark.line + 1 if mark else None
        self.place = f" at line {mark.line + 1}, column {mark.column + 1}" if mark else ""
        self.snippet = (mark.get_snippet(indent=2, max_length=100) or "") if mark else ""
        super().__init__(f"it is not valid YAML: {problem}{self.place}")


class YamlLimitError(YamlError):
    """A text is YAML, but its value is too large or nested too deep."""

    def __init__(self, problem: str, mark: Any) -> None:
        super().__init__(problem, mark)
        self.args = (f"{problem}{self.place}",)


class _Loader(TabScanner, Parser, Composer, SafeConstructor, Resolver):
    """Loads plain values, and measures them while they are composed."""

    def __init__(self, text: str, max_values: int | None = None) -> None:
        TabScanner.__init__(self, text)
        Parser.__init__(self)
        Composer.__init__(self)
        SafeConstructor.__init__(self)
        Resolver.__init__(self)
        self._max_values = max_values
        self._value_count = 0
        self._level = 0
        self._deepest = 0
        self._total = 0
        self._copied = 0
        self.marks_quoted = False
        self.marks_plain = False
        self.is_text: Callable[[str], bool] | None = None
        self.lines: dict[int, int] = {}  # of each mapping and list: its line from 1, by the id of its value
        self._measured: dict[str, tuple[int, int]] = {}  # of each complete anchor: its size and its levels

    def compose_document(self) -> Any:
        """Return the root node of the next document; its aliases are those of its own anchors."""
        self._measured.clear()
        return super().compose_document()

    def compose_node(self, parent: Any, index: Any) -> Any:
        """Return the next node.

        Raises:
            YamlLimitError: it exceeds a limit.
        """
        event: Any = self.peek_event()  # type: ignore[no-untyped-call]
        mark = event.start_mark
        if isinstance(event, yaml.AliasEvent):
            node = super().compose_node(parent, index)
            self._count_alias(event.anchor, mark)
            return node
        # An anchor may be there again, for what follows.
        self.anchors.pop(event.anchor, None)
        self._measured.pop(event.anchor, None)
        self._value_count += 1
        if self._max_values is not None and self._value_count > self._max_values:
            raise YamlLimitError(f"it has more than {self._max_values} keys and values", mark)
        before, deepest = self._total, self._deepest
        self._total += 1 + len(getattr(event, "value", ""))
        self._enter(1, mark)
        self._level += 1
        self._deepest = self._level
        node = super().compose_node(parent, index)
        self._level -= 1
        if event.anchor is not None:
            self._measured[event.anchor] = self._total - before, self._deepest - self._level
        self._deepest = max(deepest, self._deepest)
        return node

    def compose_scalar_node(self, anchor: Any) -> Any:
        """Return the next node, a scalar; where a text has `!!str` before one, it is as if in quotes.

        A plain scalar that YAML takes for a string has the same tag, but may be no string by another's rules: ROS's.
        """
        event: Any = self.peek_event()  # type: ignore[no-untyped-call]
        node = super().compose_scalar_node(anchor)
        if event.tag == _STRING_TAG and event.value:
            node.style = "'"
        node.has_tag = event.tag is not None  # type: ignore[attr-defined]
        return node

    def _enter(self, levels: int, mark: Any) -> None:
        if self._level + levels > MAX_DEPTH:
            raise YamlLimitError(f"it is nested deeper than {MAX_DEPTH} levels", mark)

    def _count_alias(self, anchor: Any, mark: Any) -> None:
        if anchor not in self._measured:
            raise YamlLimitError(f"the alias *{anchor} contains itself", mark)
        size, levels = self._measured[anchor]
        self._enter(levels, mark)
        self._deepest = max(self._deepest, self._level + levels)
        self._total += size
        self._copied += size
        if self._copied > MAX_EXPANDED_SIZE:
            raise YamlLimitError(
                f"its aliases stand for more than {MAX_EXPANDED_SIZE} values and characters", mark
            )

    def construct_object(self, node: Any, deep: bool = False) -> Any:
        """Return the value of a node.

        Raises:
            ConstructorError: the text isn't of the type of the tag, as in `!!int x` or the date 2026-13-01.
        """
        try:
            value = super().construct_object(node, deep=deep)
        except (ValueError, ArithmeticError, LookupError, AttributeError) as error:
            if isinstance(error, yaml.YAMLError):
                raise
            kind = node.tag.rpartition(":")[2]
            raise yaml.constructor.ConstructorError(
                None, None, f"{reprlib.repr(node.value)} is no {kind}", node.start_mark
            ) from None
        if self.marks_quoted and isinstance(value, str) and node.style in ("'", '"'):
            return QuotedText(value)
        if self.is_text is not None and _is_plain(node) and not isinstance(value, (str, type(None))):
            return node.value if self.is_text(node.value) else value
        if self.marks_plain and isinstance(node, yaml.ScalarNode) and not isinstance(value, str):
            is_merge = node.tag == "tag:yaml.org,2002:merge"
            return value if is_merge or node.style is not None else PlainValue(node.value, value)
        if isinstance(value, (dict, list)):
            self.lines[id(value)] = node.start_mark.line + 1
        return value


def _is_plain(node: Any) -> bool:
    return isinstance(node, yaml.ScalarNode) and node.style is None and not node.has_tag  # type: ignore[attr-defined]


def load(text: str) -> Any:
    """Return the value of a YAML text, by YAML 1.1's rules for scalars; None for an empty one.

    Raises:
        YamlError: it isn't YAML, or more than one document, or a value isn't of the type of its tag.
        YamlLimitError: its aliases stand for too much, an alias contains itself, or it is nested too deep.
    """
    return _read(text, lambda loader: loader.get_single_data())


def load_plain(text: str) -> Any:
    """Return what `load` returns, with each scalar that is not a text as a PlainValue."""

    def read(loader: _Loader) -> Any:
        loader.marks_plain = True
        return loader.get_single_data()

    return _read(text, read)


def load_placed(
    text: str,
    repeating: str | None = None,
    *,
    mark_quoted: bool = False,
    max_values: int | None = None,
    is_text: Callable[[str], bool] | None = None,
) -> tuple[Any, dict[int, int]]:
    """Return the value of a YAML text, and the line of each mapping and list, from 1, by the id of its value.

    Args:
        text: The text.
        repeating: A key of the outermost mapping by which files are known that may repeat keys; the last value counts.
        mark_quoted: Whether texts in quotes are QuotedText.
        max_values: Number of keys and values that it may have, aliases not expanded.
        is_text: Returns whether a plain scalar is a text, though YAML 1.1 takes it for a number or a date, as 12:30.

    Raises:
        YamlError: as `load`, or a mapping has the same key twice.
        YamlLimitError: as `load`, or there are more than `max_values`.
    """
    lines: dict[int, int] = {}

    def read(loader: _Loader) -> Any:
        loader.marks_quoted = mark_quoted
        loader.is_text = is_text
        node = loader.get_single_node()
        if node is None:
            return None
        if repeating is None or not _has_key(node, repeating):
            _refuse_repeated_keys(node)
        value = loader.construct_document(node)
        lines.update(loader.lines)
        return value

    return _read(text, read, max_values), lines


def compose_all(text: str) -> list[Any]:
    """Return the root node of each document of a YAML text, with unresolved scalars.

    A scalar is a string if its style is a quotation mark: it is in quotes, or has the tag `!!str`.

    Raises:
        YamlError, YamlLimitError: as `load`, except that tags are not checked, and that there may be several documents.
    """

    def read(loader: _Loader) -> list[Any]:
        nodes = []
        while loader.check_node():
            nodes.append(loader.get_node())
        return nodes

    nodes: list[Any] = _read(text, read)
    return nodes


def _has_key(node: Any, key: str) -> bool:
    return isinstance(node, yaml.MappingNode) and any(name.value == key for name, _ in node.value)


def _refuse_repeated_keys(root: Any) -> None:
    nodes, seen_ids = [root], set()
    while nodes:
        node = nodes.pop()
        if id(node) in seen_ids or not isinstance(node, yaml.CollectionNode):
            continue
        seen_ids.add(id(node))
        if isinstance(node, yaml.MappingNode):
            keys = set()
            for key, value in node.value:
                if isinstance(key, yaml.ScalarNode) and key.tag != "tag:yaml.org,2002:merge":
                    if (key.tag, key.value) in keys:
                        raise YamlError(f"the key '{key.value}' is there twice", key.start_mark)
                    keys.add((key.tag, key.value))
                nodes += [key, value]
        else:
            nodes += node.value


def _read(text: str, method: Callable[[_Loader], Any], max_values: int | None = None) -> Any:
    try:
        loader = _Loader(text, max_values)
        try:
            return method(loader)
        finally:
            loader.dispose()
    except yaml.MarkedYAMLError as error:
        raise YamlError(
            str(error.problem or error.context), error.problem_mark or error.context_mark
        ) from None
    except yaml.YAMLError as error:
        raise YamlError(" ".join(str(error).split())) from None
