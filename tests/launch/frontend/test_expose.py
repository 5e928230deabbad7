"""Actions and substitutions that are exposed to launch files."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end

from tfloom.launch.frontend import expose
from tfloom.launch.frontend.exposed import ACTION_MODULES, SUBSTITUTION_MODULES
from tfloom.launch.frontend.parse_substitution import parse_substitution
from tfloom.launch.frontend.parser import Parser

HOUSE = Path(__file__).parents[3] / "src" / "tfloom"


@pytest.fixture(autouse=True)
def _forget() -> Iterator[None]:
    """Take out afterwards what a test has exposed."""
    yield
    for methods, modules in (
        (expose.action_parse_methods, ACTION_MODULES),
        (expose.substitution_parse_methods, SUBSTITUTION_MODULES),
    ):
        for name in set(methods) - set(modules):
            del methods[name]


def exposed_in_sources(decorator: str) -> Iterator[tuple[str, str]]:
    """Yield the names that tfloom's modules expose, and the modules."""
    for path in sorted((HOUSE / "launch").rglob("*.py")):
        module = ".".join(("tfloom", *path.relative_to(HOUSE).with_suffix("").parts))
        text = path.read_text("utf-8")
        for node in ast.walk(ast.parse(text)) if f"@{decorator}" in text else ():
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                for call in node.decorator_list:
                    if isinstance(call, ast.Call) and ast.unparse(call.func) == decorator:
                        yield ast.literal_eval(call.args[0]), module


def test_tables_name_what_the_modules_expose() -> None:
    """Compare both ways, because a name that the tables lack is found by no launch file."""
    assert dict(exposed_in_sources("expose_action")) == ACTION_MODULES
    assert dict(exposed_in_sources("expose_substitution")) == SUBSTITUTION_MODULES


@pytest.mark.parametrize(("name", "module"), ACTION_MODULES.items())
def test_module_exposes_the_action(name: str, module: str) -> None:
    importlib.import_module(module)
    assert name in expose.action_parse_methods


class Plain:
    """Has no method `parse`."""


class Unbound:
    """Has a `parse` that is not a class method."""

    def parse(self, data: Any) -> Any:
        """Return nothing."""


class Good:
    """Has what is needed."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        self.args, self.kwargs = args, kwargs

    @classmethod
    def parse(cls, data: Any) -> Any:
        """Return the class and the arguments."""
        return cls, {"args": data, "more": 1}


class Other(Good):
    """Has a `parse` of its own."""

    @classmethod
    def parse(cls, data: Any) -> Any:
        """Return the class and no arguments."""
        return cls, {}


def function(data: Any) -> Any:
    """Return a class and arguments, as a class's `parse`."""
    return Good, {"data": data}


def test_exposed_substitution() -> None:
    assert expose.expose_substitution("good")(Good) is Good
    assert expose.expose_substitution("good")(Good) is Good  # again, as when a module is loaded twice
    expose.expose_substitution("function")(function)
    made: Any = expose.instantiate_substitution("good", [["a"], ["b"]])
    assert (made.args, made.kwargs) == ((["a"], ["b"]), {"more": 1})
    made = expose.instantiate_substitution("function")
    assert made.kwargs == {"data": []}


@pytest.mark.parametrize("decorator", [expose.expose_action, expose.expose_substitution])
def test_what_cannot_be_exposed(decorator: Any) -> None:
    for wrong in (Plain, Unbound):
        with pytest.raises(RuntimeError, match="Did not find a class method called 'parse'"):
            decorator("wrong")(wrong)
    with pytest.raises(
        RuntimeError, match="parser for wrong is not a callable or a class containing a parse"
    ):
        decorator("wrong")(Good())
    decorator("good")(Good)
    decorator("good")(Good)
    kind = decorator.__name__.removeprefix("expose_")
    with pytest.raises(
        RuntimeError, match=rf"^Two {kind} parsing methods exposed with the same name: \[good\].$"
    ):
        decorator("good")(Other)


def test_a_dictionary_of_its_own_can_be_exposed_in() -> None:
    from launch.frontend.expose import __expose_impl as expose_in

    methods: dict[str, Any] = {}

    @expose_in("mine", methods, "substitution")
    def mine(data: Any) -> Any:
        return str, {"object": data}

    assert methods == {"mine": mine}
    assert "mine" not in expose.substitution_parse_methods
    with pytest.raises(RuntimeError, match=r"Two substitution parsing methods .* same name: \[mine\]"):
        expose_in("mine", methods, "substitution")(lambda _: None)
    with pytest.raises(RuntimeError, match="Did not find a class method called 'parse'"):
        expose_in("plain", methods, "action")(Plain)


def test_names_of_tfloom_cannot_be_exposed_again() -> None:
    with pytest.raises(RuntimeError, match="Two action parsing methods exposed with the same name"):
        expose.expose_action("node")(Good)
    with pytest.raises(RuntimeError, match="Two substitution parsing methods exposed with the same name"):
        expose.expose_substitution("var")(Good)


class EntryPoint:
    """An entry point of an installed package."""

    name = "planted"
    value = "planted:thing"

    def __init__(self, group: str, thing: Any) -> None:
        self.group = group
        self._thing = thing

    def load(self) -> Any:
        """Return the object."""
        if isinstance(self._thing, Exception):
            raise self._thing
        return self._thing() if callable(self._thing) and not isinstance(self._thing, type) else self._thing


@pytest.fixture
def installed(monkeypatch: pytest.MonkeyPatch) -> list[EntryPoint]:
    """Return the list of installed entry points, to add some."""
    entry_points: list[EntryPoint] = []
    monkeypatch.setattr("tfloom.launch.frontend.expose.may_have_entry_points", lambda _: True)
    monkeypatch.setattr(
        "importlib.metadata.entry_points",
        lambda group: [entry_point for entry_point in entry_points if entry_point.group == group],
    )
    monkeypatch.setattr(expose, "_loaded", False)
    monkeypatch.setattr(Parser, "frontend_parsers", None)
    return entry_points


def test_extensions_are_loaded_with_the_first_unknown_name(installed: list[EntryPoint]) -> None:
    def load() -> None:
        expose.expose_substitution("planted")(function)

    installed.append(EntryPoint("launch.frontend.launch_extension", load))
    parse_substitution("$(env HOME)")
    assert "planted" not in expose.substitution_parse_methods
    parse_substitution("$(planted)")
    assert "planted" in expose.substitution_parse_methods


def test_extension_that_fails_is_a_warning(installed: list[EntryPoint]) -> None:
    installed.append(EntryPoint("launch.frontend.launch_extension", ValueError("no")))
    with (
        pytest.warns(UserWarning, match=r"Failed to load the extension .*planted:thing\): ValueError: no"),
        pytest.raises(RuntimeError, match="Unknown substitution: nothing"),
    ):
        parse_substitution("$(nothing)")


def test_parsers_of_other_packages(installed: list[EntryPoint], tmp_path: Path) -> None:
    class Reader(Parser):
        """Reads files of another language."""

        @classmethod
        def get_file_extensions(cls) -> set[str]:
            return {"launch.toml"}

        @classmethod
        def load(cls, file: Any) -> Any:
            return Path(file).read_text("utf-8"), cls()

    installed.append(EntryPoint("launch.frontend.parser", Reader))
    assert Parser.get_parsers_from_filename("a.launch.toml") == [Reader]
    assert Parser.get_parsers_from_filename("a.toml") == []
    assert Parser.is_filename_valid("a.launch.toml")
    assert Parser.get_file_extensions_from_parsers() == {"launch.toml", "xml", "yaml", "yml"}
    (tmp_path / "a.launch.toml").write_text("content")
    root, parser = Parser.load(str(tmp_path / "a.launch.toml"))
    assert (root, type(parser)) == ("content", Reader)


def test_parser_that_fails_to_load_is_a_warning(installed: list[EntryPoint]) -> None:
    installed.append(EntryPoint("launch.frontend.parser", ImportError("no")))
    with pytest.warns(UserWarning, match=r"launch.frontend.parser \(planted:thing\): ImportError: no"):
        Parser.load_parser_implementations()
    assert set(Parser.frontend_parsers or {}) == {"xml", "yaml"}


def test_deprecated_methods_of_the_parser() -> None:
    with pytest.warns(UserWarning, match="use Parser.get_file_extensions_from_parsers instead"):
        assert {"xml", "yaml"} <= set(Parser.get_available_extensions())
    with pytest.warns(UserWarning, match="use Parser.is_filename_valid instead"):
        assert Parser.is_extension_valid("xml")
    with pytest.warns(UserWarning, match="use Parser.get_parsers_from_filename instead"):
        assert Parser.get_parser_from_extension("yaml").__module__ == "tfloom.launch.files.yaml_file"
    with (
        pytest.warns(UserWarning, match="get_parser_from_extension"),
        pytest.raises(RuntimeError, match="Not recognized frontend implementation"),
    ):
        Parser.get_parser_from_extension("toml")


PACKAGE = """
from launch import Action, Substitution
from launch.frontend import expose_action, expose_substitution
from launch.actions import LogInfo

@expose_action("greet")
class Greet(LogInfo):
    @classmethod
    def parse(cls, entity, parser):
        _, kwargs = Action.parse(entity, parser)
        times = entity.get_attr("times", data_type=int, optional=True) or 1
        return cls, {"msg": parser.parse_substitution(entity.get_attr("text") * times), **kwargs}

@expose_substitution("shout")
class Shout(Substitution):
    def __init__(self, text):
        self.text = text

    @classmethod
    def parse(cls, data):
        return cls, {"text": data[0]}

    def perform(self, context):
        return "".join(part.perform(context) for part in self.text).upper()
"""


def test_installed_package_extends_launch_files(tmp_path: Path) -> None:
    """The entry points are those of a package's metadata, in a new process, under ROS's names."""
    (tmp_path / "greetings.py").write_text(PACKAGE)
    metadata = tmp_path / "greetings-1.0.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: greetings\nVersion: 1.0\n")
    (metadata / "entry_points.txt").write_text("[launch.frontend.launch_extension]\ngreetings = greetings\n")
    (tmp_path / "a.launch.xml").write_text(
        '<launch><greet text="$(shout hi) " times="2"/><greet text="x" if="false"/></launch>'
    )
    (tmp_path / "b.launch.yaml").write_text("launch: [{greet: {text: $(shout hi), tone: loud}}]")
    code = (
        "import sys\n"
        "from launch import LaunchContext\n"
        "from launch.frontend import Parser\n"
        "root, parser = Parser.load(sys.argv[1])\n"
        "for action in parser.parse_description(root).entities:\n"
        "    text = ''.join(part.perform(LaunchContext()) for part in action.msg)\n"
        "    print(type(action).__name__, text, action.condition is None)\n"
    )

    def run(name: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", code, name]
        return run_to_end(command, cwd=tmp_path)

    result = run("a.launch.xml")
    assert result.stdout == "Greet HI HI  True\nGreet x False\n", result.stderr
    result = run("b.launch.yaml")
    assert result.stderr.endswith(
        "ValueError: b.launch.yaml:1: Unexpected key(s) found in `greet`: {'tone'}\n"
    ), result.stderr
