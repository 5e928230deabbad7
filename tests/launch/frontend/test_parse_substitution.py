"""The substitutions in a text."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.launch.core.base_classes import Substitution, TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend import expose
from tfloom.launch.frontend.exposed import SUBSTITUTION_MODULES
from tfloom.launch.frontend.parse_substitution import (
    SubstitutionSyntaxError,
    parse_if_substitutions,
    parse_substitution,
    replace_escaped_characters,
)


class Shown(Substitution):
    """Shows how it was written."""

    def __init__(self, arguments: list[list[Substitution]]) -> None:
        self.arguments = arguments

    def perform(self, context: LaunchContext) -> str:
        """Return the arguments, each in brackets."""
        return "".join(f"[{shown(argument)}]" for argument in self.arguments)


def shown(parts: list[Substitution]) -> str:
    """Return the parts of a text with bars between them."""
    return "|".join(part.perform(LaunchContext()) for part in parts)


@pytest.fixture(autouse=True)
def _exposed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(expose.substitution_parse_methods, "s", lambda data: (Shown, {"arguments": data}))


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("", ""),
        ("yes", "yes"),
        ("'yes'", "'yes'"),
        ('"yes" 10e4 (x)', '"yes" 10e4 (x)'),
        ("$0 $1 $", "$0 $1 $"),
        ("a\nb\tc", "a\nb\tc"),
        ("$(s)", ""),
        ("$(s a)", "[a]"),
        ("$(s a b c)", "[a][b][c]"),
        ("$(s  a   b )", "[a][b]"),
        ("a_$(s b)_c_$(s d)", "a_|[b]|_c_|[d]"),
        ("$(s a)$(s b)", "[a]|[b]"),
        ("$(s '$0 $1')", "[$0 $1]"),
        ("$(s '')", "[]"),
        ("$(s '' \"\" x)", "[][][x]"),
        ("$(s 'a b' \"c d\")", "[a b][c d]"),
        ("$(s 'a (b) \"c\"')", '[a (b) "c"]'),
        ('$(s "it\'s")', "[it's]"),
        ("$(s a$(s b)c)", "[a|[b]|c]"),
        ("$(s a$(s b $(s c)) d)", "[a|[b][[c]]][d]"),
        ("$(s 'x $(s b c) y')", "[x |[b][c]| y]"),
        ("$(s \"x $(s 'b') y\")", "[x |['b']| y]"),
        ("$(s 'x $(s \"b\") y')", '[x |["b"]| y]'),
        (r"$(s \"x\" \'y\')", "[\"x\"]['y']"),
        (r"$(s 'it\'s')", "[it's]"),
        (r'$(s "$(s \"b\")")', '[["b"]]'),
        (r"$(s what/\$\(test asd\\\)) 10 10)", r"[what/$(test][asd\)]| 10 10)"),
        (r"\$(s a)", "$(s a)"),
        (r"\\$(s a)", "\\|[a]"),
        (r"\\\$(s a)", r"\$(s a)"),
        (r"a\ b", "a b"),
        ("a\\", "a\\"),
        (r"$(s a\ b)", "[a\\][b]"),
        ("$(s C:/x $1)", "[C:/x][$1]"),
        ("$(s Ä ö€)", "[Ä][ö€]"),
    ],
)
def test_parts_of_a_text(text: str, parts: str) -> None:
    assert shown(parse_substitution(text)) == parts


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("$(", r"no name follows '$(' (for the text itself, write '\$('): column 1 of '$('"),
        ("a $(1)", r"no name follows '$(' (for the text itself, write '\$('): column 3 of 'a $(1)'"),
        ("$(s", "the end is where an argument or ')' should be, in '$(s …': column 4 of '$(s'"),
        ("$(s a", "the end is where an argument or ')' should be, in '$(s …': column 6 of '$(s a'"),
        ("$(s 'a)", "the closing ' is missing: column 5 of '$(s 'a)'"),
        ("$(s it's)", "''' is where an argument or ')' should be, in '$(s …': column 7 of '$(s it's)'"),
        ("$(s 'a'b)", "'b' is where an argument or ')' should be, in '$(s …': column 8 of '$(s 'a'b)'"),
        ("$(s a(b))", "'(' is where an argument or ')' should be, in '$(s …': column 6 of '$(s a(b))'"),
        (
            "$(s (b))",
            r"'(' is where an argument or ')' should be (for the text, write '\('): column 5 of '$(s (b))'",
        ),
        ("$(s:x)", "':' is where an argument or ')' should be, in '$(s …': column 4 of '$(s:x)'"),
    ],
)
def test_incomplete_substitution(text: str, problem: str) -> None:
    with pytest.raises(SubstitutionSyntaxError) as raised:
        parse_substitution(text)
    assert str(raised.value) == problem


def test_deep_nesting_is_an_error() -> None:
    assert parse_substitution("$(s " * 50 + ")" * 50)
    with pytest.raises(SubstitutionSyntaxError, match="nested deeper than 50 levels"):
        parse_substitution("$(s " * 100_000)


def test_unknown_name() -> None:
    with pytest.raises(
        RuntimeError, match=r"^Unknown substitution: vra; did you mean 'var'\? \(in '\$\(vra x\)'\)$"
    ):
        parse_substitution("a $(vra x)")
    with pytest.raises(
        RuntimeError, match=r"find; that is of ROS 1: write \$\(find-pkg-share PACKAGE\) \(in"
    ):
        parse_substitution("$(find my_robot)/launch/robot.launch")
    with pytest.raises(TypeError, match=r"^var substitution expects 1 or 2 arguments \(in '\$\(var\)'\)$"):
        parse_substitution("$(var)")


ARGUMENTS = {
    "all": ["true", "false"],
    "and": ["true", "false"],
    "any": ["true", "false", "true"],
    "eval": ["1 + 1"],
    "equals": ["a", ""],
    "find-pkg-prefix": ["turtlesim"],
    "find-pkg-share": ["turtlesim"],
    "exec-in-package": ["talker", "demo_nodes_py"],
    "exec-in-pkg": ["talker", "demo_nodes_py"],
    "if": ["true", "a", "b"],
    "not-equals": ["a", "b"],
    "or": ["true", "false"],
    "string-join": [".", "a"],
    **{name: [] for name in ("dirname", "filename", "launch_log_dir", "log_dir")},
}


@pytest.mark.parametrize("name", sorted(SUBSTITUTION_MODULES))
def test_each_name_gives_its_substitution(name: str) -> None:
    arguments = "".join(f" '{argument}'" for argument in ARGUMENTS.get(name, ["x"]))
    (substitution,) = parse_substitution(f"$({name}{arguments})")
    assert type(substitution).__module__ == SUBSTITUTION_MODULES[name]


@pytest.mark.parametrize(
    ("text", "result"),
    [
        ("$(all 1 true on)", "true"),
        ("$(any 0 false)", "false"),
        ("$(equals $(var x none) none)", "true"),
        ("$(equals '' '')", "true"),
        (r"$(eval '\'$(var x none)\' == \'none\'')", "True"),
        (r'$(eval "\'asd\' + \'bsd\'")', "asdbsd"),
        ("$(eval 'ceil(1.3)' 'math, sys')", "2"),
        ("$(eval '1' '')", "1"),
        ("$(path-join /a 'b c' d_$(var x y).yaml)", "/a/b c/d_y.yaml"),
        ("$(string-join . a$(var x y) b)", "ay.b"),
        ("$(if $(not false) yes no)", "yes"),
        ("$(env NO_SUCH_VARIABLE 'a b')", "a b"),
    ],
)
def test_performed(text: str, result: str) -> None:
    (substitution,) = parse_substitution(text)
    assert substitution.perform(LaunchContext()) == result


def test_values_with_and_without_substitutions() -> None:
    assert parse_if_substitutions(1) == 1
    assert parse_if_substitutions("a") == "a"
    assert parse_if_substitutions(r"\$(a") == "$(a"
    assert parse_if_substitutions(["a", "b"]) == ["a", "b"]
    assert parse_if_substitutions([1.5, 2.5]) == [1.5, 2.5]
    parts: Any = parse_if_substitutions("[$(s a), 1]")
    assert shown(parts) == "[|[a]|, 1]"
    first, second = parse_if_substitutions(["$(s a)", 1])
    assert (shown(first), second) == ("[a]", 1)
    with pytest.raises(ValueError, match="non-uniform list"):
        parse_if_substitutions(["$(s a)", 1, 1.0])


def test_escapes() -> None:
    assert replace_escaped_characters(r"\a\\b\'" + "\\") == "a\\b'\\"
    assert isinstance(parse_substitution("x")[0], TextSubstitution)
