"""Parameters of nodes."""

from __future__ import annotations

import array
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

from tfloom.interfaces.rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    ParameterType,
    SetParametersResult,
)
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterImmutableException,
    ParameterUninitializedException,
)
from tfloom.node.parameters.node_parameters import NodeParameters
from tfloom.node.parameters.parameter import (
    Parameter,
    get_parameter_value,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)
from tfloom.node.qos.qos import qos_profile_parameter_events

Type = Parameter.Type
MakeNode = Callable[..., Node]


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        (None, Type.NOT_SET),
        (True, Type.BOOL),
        (1, Type.INTEGER),
        (1.0, Type.DOUBLE),
        ("a", Type.STRING),
        ([b"a"], Type.BYTE_ARRAY),
        ([True], Type.BOOL_ARRAY),
        ([1], Type.INTEGER_ARRAY),
        ((1.0, 2.0), Type.DOUBLE_ARRAY),
        (array.array("q", [1]), Type.INTEGER_ARRAY),
        (array.array("d", [1.0]), Type.DOUBLE_ARRAY),
        (["a"], Type.STRING_ARRAY),
        ([], Type.BYTE_ARRAY),
    ],
)
def test_types_of_values_are_inferred(value: object, kind: Type) -> None:
    parameter = Parameter("x", value=value)
    assert parameter.type_ is kind
    back = Parameter.from_parameter_msg(parameter.to_parameter_msg())
    assert back.type_ is kind
    if kind.value >= Type.BYTE_ARRAY.value:
        assert list(back.value) == list(value)
    else:
        assert back.value == value


@pytest.mark.parametrize("value", [{}, object(), [1, "a"], [1, 1.0], [[1]], b"ab"])
def test_unsupported_values_raise(value: object) -> None:
    with pytest.raises(TypeError, match="allowed types 'NOT_SET, BOOL"):
        Parameter("x", value=value)


def test_declare_get_set(node: Node) -> None:
    assert node.declare_parameter("a.b", 1).value == 1
    assert node.get_parameter("a.b").value == 1
    assert node.set_parameters([Parameter("a.b", value=2)]) == [SetParametersResult(successful=True)]
    assert node.get_parameters(["a.b"])[0].value == 2
    assert node.get_parameter_type("a.b") == Type.INTEGER.value
    assert node.get_parameters_by_prefix("a")["b"].value == 2
    assert node.get_parameter_or("nope", Parameter("x", value=3)).value == 3
    assert node.get_parameter_or("nope").type_ is Type.NOT_SET
    assert node.describe_parameter("a.b").type == 2


def test_type_is_fixed_by_the_default(node: Node) -> None:
    node.declare_parameter("x", 1)
    (result,) = node.set_parameters([Parameter("x", value="a")])
    assert not result.successful
    assert result.reason == "Wrong parameter type, expected 'Type.INTEGER' got 'Type.STRING'"
    node.declare_parameter("y", 1, ParameterDescriptor(dynamic_typing=True))
    assert node.set_parameters([Parameter("y", value="a")])[0].successful
    assert node.get_parameter_type("y") == Type.STRING.value


def test_parameter_without_default_is_uninitialised(node: Node) -> None:
    node.declare_parameter("x", Type.DOUBLE)
    with pytest.raises(ParameterUninitializedException, match="'x' is not initialized"):
        node.get_parameter("x")
    assert not node.set_parameters([Parameter("x", value=1)])[0].successful
    assert node.set_parameters([Parameter("x", value=1.0)])[0].successful
    assert node.get_parameter("x").value == 1.0
    with pytest.warns(UserWarning, match="only providing its name is deprecated"):
        node.declare_parameter("y")
    with pytest.raises(ValueError, match="NOT_SET"):
        node.declare_parameter("z", Type.NOT_SET)


def test_ranges_and_read_only_are_enforced(node: Node) -> None:
    integers = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=2)])
    node.declare_parameter("i", 4, integers)
    doubles = ParameterDescriptor(
        floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0, step=0.1)]
    )
    node.declare_parameter("d", 0.3, doubles)
    node.declare_parameter("r", 1, ParameterDescriptor(read_only=True))

    def reason(name: str, value: object) -> str:
        (result,) = node.set_parameters([Parameter(name, value=value)])
        return "" if result.successful else result.reason

    assert reason("i", 10) == ""
    assert reason("i", 11) == "Parameter i out of range. Min: 0, Max: 10, value: 11"
    assert "i is not a valid step. Min: 0, max: 10, value: 3, step: 2" in reason("i", 3)
    assert reason("d", 0.7) == ""
    assert "d is not close enough to a valid step. Min: 0.0, max: 1.0, value: 0.75" in reason("d", 0.75)
    assert reason("d", -0.1) == "Parameter d out of range Min: 0.0, Max: 1.0, value: -0.1"
    assert reason("r", 2) == "Trying to set a read-only parameter: r."
    with pytest.raises(ParameterImmutableException):
        node.undeclare_parameter("r")
    with pytest.raises(InvalidParameterValueException, match="out of range"):
        node.declare_parameter("j", 20, ParameterDescriptor(integer_range=integers.integer_range))
    assert not node.has_parameter("j")


def test_overrides_from_the_command_line(make_node: MakeNode) -> None:
    node = make_node(cli_args=["--ros-args", "-p", "x:=5", "-p", "y:=text"])
    assert node.declare_parameter("x", 1).value == 5
    with pytest.raises(
        InvalidParameterTypeException, match="'y' to 'text' of type 'STRING', expecting type 'DOUBLE'"
    ):
        node.declare_parameter("y", 1.0)
    assert node.declare_parameter("y", 2.0, ignore_override=True).value == 2.0
    other = make_node(
        "other",
        cli_args=["--ros-args", "-p", "x:=5"],
        parameter_overrides=[Parameter("x", value=6)],
        automatically_declare_parameters_from_overrides=True,
    )
    assert other.get_parameter("x").value == 6


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        ("fast", "STRING"),
        ("2", "INTEGER"),
        ("true", "BOOL"),
        ("[1.0]", "DOUBLE_ARRAY"),
        ("2020-01-01", "STRING"),
        ("''", "STRING"),
    ],
)
def test_parameter_file_with_wrong_types_raises(
    make_node: MakeNode, tmp_path: Path, value: str, kind: str
) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(f"/**:\n  ros__parameters:\n    rate: {value}\n    good: 5\n")
    node = make_node(cli_args=["--ros-args", "--params-file", str(path)])
    with pytest.raises(InvalidParameterTypeException, match=f"of type '{kind}', expecting type 'DOUBLE'"):
        node.declare_parameter("rate", 1.0)
    assert not node.has_parameter("rate")
    assert node.declare_parameter("good", 1).value == 5


def test_integers_beyond_64_bits_become_doubles(make_node: MakeNode) -> None:
    node = make_node(cli_args=["--ros-args", "-p", f"x:={2**63}", "-p", "y:=-" + "9" * 300])
    assert node.declare_parameter("x", 1.0).value == 2.0**63
    assert node.declare_parameter("y", 1.0).value == -1e300


def test_undeclared_parameters_can_be_allowed(make_node: MakeNode) -> None:
    node = make_node(allow_undeclared_parameters=True)
    assert node.get_parameter("x").type_ is Type.NOT_SET
    assert node.set_parameters([Parameter("x", value=1)])[0].successful
    assert node.set_parameters([Parameter("x", value="a")])[0].successful
    assert node.get_parameter("x").value == "a"
    assert node.set_parameters([Parameter("x", Type.NOT_SET)])[0].successful
    assert not node.has_parameter("x")


def test_callbacks_reject_modify_and_receive_changes(node: Node) -> None:
    node.declare_parameters("", [("x", 1), ("y", 1)])
    heard: list[tuple[str, list[str]]] = []

    def pre(parameters: list[Parameter]) -> list[Parameter]:
        heard.append(("pre", [parameter.name for parameter in parameters]))
        return [*parameters, Parameter("y", value=parameters[0].value)]

    def check(parameters: list[Parameter]) -> SetParametersResult:
        heard.append(("on", [parameter.name for parameter in parameters]))
        return SetParametersResult(successful=parameters[0].value < 10, reason="too big")

    def post(parameters: list[Parameter]) -> None:
        heard.append(("post", [parameter.name for parameter in parameters]))

    node.add_pre_set_parameters_callback(pre)
    node.add_on_set_parameters_callback(check)
    node.add_post_set_parameters_callback(post)
    assert node.set_parameters([Parameter("x", value=5)])[0].successful
    assert heard == [("pre", ["x"]), ("on", ["x", "y"]), ("post", ["x", "y"])]
    assert node.get_parameter("y").value == 5
    (result,) = node.set_parameters([Parameter("x", value=10)])
    assert (result.successful, result.reason) == (False, "too big")
    assert node.get_parameter("x").value == 5
    with pytest.raises(InvalidParameterValueException, match="too big"):
        node.declare_parameter("z", 11)
    node.remove_pre_set_parameters_callback(pre)
    node.remove_on_set_parameters_callback(check)
    node.remove_post_set_parameters_callback(post)
    assert node.set_parameters([Parameter("x", value=10)])[0].successful


def test_a_callback_that_removes_itself_hides_no_other(node: Node) -> None:
    refused = SetParametersResult(successful=False, reason="no")

    def once(_: list[Parameter]) -> SetParametersResult:
        node.remove_on_set_parameters_callback(once)
        return SetParametersResult(successful=True)

    def first(parameters: list[Parameter]) -> list[Parameter]:
        node.remove_pre_set_parameters_callback(first)
        return parameters

    node.declare_parameter("speed", 1)
    node.add_pre_set_parameters_callback(
        lambda parameters: [Parameter("speed", value=parameters[0].value + 1)]
    )
    node.add_pre_set_parameters_callback(first)
    node.set_parameters([Parameter("speed", value=2)])
    assert node.get_parameter("speed").value == 3
    node.add_on_set_parameters_callback(lambda _: refused)
    node.add_on_set_parameters_callback(once)
    (result,) = node.set_parameters([Parameter("speed", value=5)])
    assert (result.reason, node.get_parameter("speed").value) == ("no", 3)


class UndeclaredMeanwhile(str):
    """A name of which the parameter is undeclared, as by another thread, before it is looked up for a second time."""

    __slots__ = ("lookups", "undeclare")

    def __hash__(self) -> int:
        self.lookups = getattr(self, "lookups", 0) + 1
        if self.lookups == 2:
            self.undeclare()
        return super().__hash__()


@pytest.mark.parametrize("default", [None, 3])
def test_a_parameter_that_is_undeclared_meanwhile_is_read_as_before(default: int | None) -> None:
    def read(how: str) -> Any:
        parameters = NodeParameters({}, allow_undeclared=False, publish_event=lambda _: None)
        declaration = ("a", default) if default else ("a", Type.INTEGER)
        parameters.declare_parameters("", [declaration])
        name = UndeclaredMeanwhile("a")
        name.undeclare = lambda: parameters.undeclare_parameter("a")
        return getattr(parameters, how)(name)

    assert read("get_parameter_type") == (Type.INTEGER if default else Type.NOT_SET).value
    if default:
        assert read("get_parameter").value == default
    else:
        with pytest.raises(ParameterUninitializedException):
            read("get_parameter")


def test_callbacks_of_parameters_may_be_added_on_another_thread_while_events_come(node: Node) -> None:
    handler = ParameterEventHandler(node)
    got: list[str] = []

    class Event:
        """An event that is read while another thread adds callbacks."""

        new_parameters: Sequence[Any] = ()
        changed_parameters: Sequence[Any] = tuple(
            Parameter(name, value=1).to_parameter_msg() for name in "ab"
        )

        @property
        def node(self) -> str:
            handler.add_parameter_callback(f"p{len(handler._callbacks.parameter_callbacks)}", "/n", print)
            return "/n"

    for name in ("a", "b"):
        handler.add_parameter_callback(name, "/n", lambda parameter: got.append(parameter.name))
    handler._callbacks.event_callback(cast("ParameterEvent", Event()))
    assert got == ["a", "b"]


def test_atomic_set_is_all_or_none(node: Node) -> None:
    node.declare_parameters("ns", [("x", 1), ("y", 1)])
    bad = [Parameter("ns.x", value=2), Parameter("ns.y", value="a")]
    assert not node.set_parameters_atomically(bad).successful
    assert node.get_parameter("ns.x").value == 1
    results = node.set_parameters(bad)
    assert [result.successful for result in results] == [True, False]


def test_list_returns_names_below_prefixes(node: Node) -> None:
    node.declare_parameters("", [("a.b.c", 1), ("a.d", 1), ("e", 1)])
    assert node.list_parameters(["a"], 0).names == ["a.b.c", "a.d"]
    assert node.list_parameters(["a"], 1).names == ["a.d"]
    assert node.list_parameters(["a"], 1).prefixes == ["a"]
    assert {"a.b.c", "a.d", "e"} <= set(node.list_parameters([], 0).names)
    with pytest.raises(ValueError, match="depth"):
        node.list_parameters([], -1)


def test_descriptor_can_be_replaced(node: Node) -> None:
    node.declare_parameter("x", 5)
    narrow = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=3, step=1)])
    with pytest.raises(InvalidParameterValueException):
        node.set_descriptor("x", narrow)
    assert node.set_descriptor("x", narrow, Parameter("x", value=2).get_parameter_value()).integer_value == 2
    assert not node.set_parameters([Parameter("x", value=4)])[0].successful


def test_parameter_changes_are_published(
    make_node: MakeNode, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    node, watcher = make_node("node", namespace="/ns"), make_node("watcher")
    events: list[ParameterEvent] = []
    watcher.create_subscription(
        ParameterEvent, "/parameter_events", events.append, qos_profile_parameter_events
    )
    executor.add_node(watcher)
    node.declare_parameter("x", 1)
    node.set_parameters([Parameter("x", value=2)])
    spin_until(lambda: len(events) == 2)
    assert events[0].node == "/ns/node"
    assert [parameter.name for parameter in events[0].new_parameters] == ["x"]
    assert events[1].changed_parameters[0].value.integer_value == 2


def test_use_sim_time_parameter_sets_the_clock(
    make_node: MakeNode,
    executor: SingleThreadedExecutor,
    spin_until: Callable[..., None],
    capsys: pytest.CaptureFixture[str],
) -> None:
    from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMsg
    from tfloom.interfaces.rosgraph_msgs.msg import Clock

    node = make_node(cli_args=["--ros-args", "-p", "use_sim_time:=true"])
    publisher = make_node("clock").create_publisher(Clock, "/clock", 10)
    executor.add_node(node)
    assert node.get_clock().now().nanoseconds == 0
    publisher.publish(Clock(clock=TimeMsg(sec=7)))
    spin_until(lambda: node.get_clock().now().nanoseconds == 7 * 10**9)
    publisher.publish(Clock(clock=TimeMsg(sec=-5)))
    spin_until(lambda: "Dropped a time on /clock that is before 0: -5 s" in capsys.readouterr().err)
    assert node.get_clock().now().nanoseconds == 7 * 10**9
    assert node.set_parameters([Parameter("use_sim_time", value=False)])[0].successful
    assert node.get_clock().now().nanoseconds > 10**18
    assert node.count_subscribers("/clock") == 0
    assert not node.set_parameters([Parameter("use_sim_time", value=1)])[0].successful


@pytest.mark.parametrize(
    ("text", "kind"),
    [("1", 2), ("1.0", 3), ("true", 1), ("abc", 4), ("[1,2]", 7), ("{a: 1}", 4), ("[1, a]", 4)],
)
def test_values_are_parsed_from_text(text: str, kind: int) -> None:
    assert get_parameter_value(text).type == kind


def test_parameters_are_read_from_a_file(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/**: {ros__parameters: {w: 1}}\n/a: {ros__parameters: {x: {y: 2}}}\n")
    assert set(parameter_dict_from_yaml_file(str(path), True, ["/a"])) == {"w", "x.y"}
    assert set(parameter_dict_from_yaml_file(str(path), target_nodes=["a"], namespace="n.")) == {"n.x.y"}
    text = r"^Param file does not contain parameters for /b,only for nodes: \['/\*\*', '/a'\] $"
    with pytest.raises(RuntimeError, match=text):
        parameter_dict_from_yaml_file(str(path), target_nodes=["b"])
    path.write_text("/**: {ros__parameters: {w: 1}}\n")
    with pytest.raises(RuntimeError, match=r"^Param file does not contain selected parameters$"):
        parameter_dict_from_yaml_file(str(path))


def test_rules_for_a_node_override_the_wildcard(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/a: {ros__parameters: {x: 2}}\n/**: {ros__parameters: {x: 1, y: 1}}\n")
    parameters = parameter_dict_from_yaml_file(str(path), use_wildcard=True)
    assert {name: parameter.value.integer_value for name, parameter in parameters.items()} == {"x": 2, "y": 1}


REPEATED = """
/**:
  ros__parameters:
    a: 1
    n: {x: 1}
/**:
  ros__parameters:
    b: 2
    n: {y: 2}
/**:
  ros__parameters:
    a: 3
"""


def test_repeated_node_names_are_merged(make_node: MakeNode, tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(REPEATED)
    node = make_node(
        cli_args=["--ros-args", "--params-file", str(path)],
        automatically_declare_parameters_from_overrides=True,
    )
    values = {name: node.get_parameter(name).value for name in ("a", "b", "n.x", "n.y")}
    assert values == {"a": 3, "b": 2, "n.x": 1, "n.y": 2}
    parameters = parameter_dict_from_yaml_file(str(path), use_wildcard=True)
    assert {name: parameter.value.integer_value for name, parameter in parameters.items()} == values


@pytest.mark.parametrize("text", [" ", "  ", "# x", "\n"])
def test_text_without_a_value_is_unchanged(text: str) -> None:
    value = get_parameter_value(text)
    assert (value.type, value.string_value) == (4, text)


STATIC_WITHOUT_VALUE = (
    "^Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET$"
)


@pytest.mark.parametrize("options", [{}, {"cli_args": ["--ros-args", "-p", "x:=5"]}])
def test_typed_descriptor_without_a_value_is_rejected(
    make_node: MakeNode, options: dict[str, object]
) -> None:
    node = make_node(**options)
    typed = ParameterDescriptor(type=ParameterType.PARAMETER_INTEGER)
    with pytest.raises(ValueError, match=STATIC_WITHOUT_VALUE):
        node.declare_parameter("x", descriptor=typed)
    with pytest.raises(ValueError, match=STATIC_WITHOUT_VALUE):
        node.declare_parameter("x", None, ParameterDescriptor(read_only=True))
    assert not node.has_parameter("x")
    typed.dynamic_typing = True
    assert node.declare_parameter("free", descriptor=typed).value is None
    described = node.describe_parameter("free")
    assert (described.name, described.type) == ("free", ParameterType.PARAMETER_NOT_SET)


def test_type_and_dynamic_typing_are_exclusive(node: Node) -> None:
    text = (
        "When declaring parameter {x} passing a descriptor with`dynamic_typing=True` "
        "is not allowed when the parameter type is provided"
    )
    with pytest.raises(ValueError, match=f"^{re.escape(text)}$"):
        node.declare_parameter("x", Parameter.Type.INTEGER, ParameterDescriptor(dynamic_typing=True))


def test_description_without_a_value_has_the_name(node: Node) -> None:
    node.declare_parameter("typed", Parameter.Type.INTEGER)
    with pytest.warns(UserWarning, match="only providing its name is deprecated"):
        node.declare_parameter("bare")
    typed, bare = node.describe_parameters(["typed", "bare"])
    assert (typed.name, typed.type, typed.dynamic_typing) == ("typed", ParameterType.PARAMETER_INTEGER, False)
    assert (bare.name, bare.type, bare.dynamic_typing) == ("bare", ParameterType.PARAMETER_NOT_SET, True)


def test_static_parameters_cannot_be_undeclared_by_setting(node: Node) -> None:
    node.declare_parameter("set", 1)
    node.declare_parameter("unset", Parameter.Type.INTEGER)
    for name in ("set", "unset"):
        (result,) = node.set_parameters([Parameter(name)])
        assert (result.successful, result.reason) == (False, "Static parameter cannot be undeclared")
    assert node.get_parameter("set").value == 1


def test_use_sim_time_of_a_wrong_type_raises(context: Context) -> None:
    with pytest.raises(InvalidParameterTypeException):
        Node("bad", context=context, cli_args=["--ros-args", "-p", "use_sim_time:=5"])
    context.destroy()


def test_event_handler_receives_changes_of_other_nodes(
    make_node: MakeNode, executor: SingleThreadedExecutor, spin_until: Callable[..., None]
) -> None:
    node, watcher = make_node("node", namespace="/ns"), make_node("watcher", namespace="/ns")
    node.declare_parameters("", [("x", 1), ("y", 1)])
    handler = ParameterEventHandler(watcher)
    values: list[object] = []
    events: list[ParameterEvent] = []
    handle = handler.add_parameter_callback(
        "x", "node", lambda message: values.append(parameter_value_to_python(message.value))
    )
    handler.add_parameter_event_callback(events.append)
    executor.add_node(watcher)
    node.set_parameters([Parameter("x", value=2), Parameter("y", value=2)])
    spin_until(lambda: len(events) == 2)
    handler.remove_parameter_callback(handle)
    with pytest.raises(RuntimeError):
        handler.remove_parameter_callback(handle)
    node.set_parameters([Parameter("x", value=3)])
    spin_until(lambda: len(events) == 3)
    assert values == [2]
    handler.destroy()
    assert watcher.count_subscribers("/parameter_events") == 0


@pytest.mark.parametrize("result", [None, True, "yes", [SetParametersResult(successful=True)]], ids=repr)
def test_a_callback_with_another_result_refuses_the_parameter(make_node: MakeNode, result: object) -> None:
    node = make_node()
    node.declare_parameter("speed", 1)
    node.add_on_set_parameters_callback(lambda _: result)  # type: ignore[arg-type, return-value]
    with pytest.warns(UserWarning, match="Callback returned an invalid type.*<lambda>.*returned "):
        (answer,) = node.set_parameters([Parameter("speed", value=2)])
    assert (answer.successful, answer.reason) == (False, "Callback returned an invalid type")
    assert node.get_parameter("speed").value == 1


@pytest.mark.parametrize("default", [[1.0], ["a"], [1], [True], [b"a"]], ids=repr)
def test_an_empty_list_of_an_argument_has_the_declared_type(
    make_node: MakeNode, default: list[object]
) -> None:
    node = make_node(cli_args=["--ros-args", "-p", "x:=[]", "-p", "y:=[]"])
    parameter = node.declare_parameter("x", default)
    assert list(parameter.value) == []
    assert parameter.type_ is Parameter("x", value=default).type_
    with pytest.raises(InvalidParameterTypeException):
        node.declare_parameter("y", 1.0)


@pytest.mark.parametrize(
    ("given", "kind", "value"),
    [
        (np.float64(1.5), Type.DOUBLE, 1.5),
        (np.float16(1.5), Type.DOUBLE, 1.5),
        (np.int32(3), Type.INTEGER, 3),
        (np.uint8(3), Type.INTEGER, 3),
        (np.array(3), Type.INTEGER, 3),
        (np.bool_(True), Type.BOOL, True),
        (np.str_("a"), Type.STRING, "a"),
        (np.array([1.5, 2.0]), Type.DOUBLE_ARRAY, [1.5, 2.0]),
        (np.array([1, 2], np.uint8), Type.INTEGER_ARRAY, [1, 2]),
        (np.array([True]), Type.BOOL_ARRAY, [True]),
        (np.array(["a", "b"]), Type.STRING_ARRAY, ["a", "b"]),
        ([np.int64(1), np.int64(2)], Type.INTEGER_ARRAY, [1, 2]),
        ((np.float32(1.5),), Type.DOUBLE_ARRAY, (1.5,)),
    ],
    ids=str,
)
def test_values_of_numpy_are_those_that_they_stand_for(
    given: object, kind: Type, value: object, node: Node
) -> None:
    parameter = Parameter("x", value=given)
    assert (parameter.type_, parameter.value, repr(parameter.value)) == (kind, value, repr(value))
    assert Parameter("x", kind, given).value == value
    assert node.declare_parameter("declared", given).value == value
    node.declare_parameter("typed", kind)
    assert node.set_parameters([Parameter("typed", value=given)])[0].successful
    assert repr(node.get_parameter("typed").value) == repr(value)
    in_message = parameter_value_to_python(node.get_parameter("declared").get_parameter_value())
    assert in_message == (list(value) if isinstance(value, tuple) else value)


def test_values_of_numpy_without_a_type_are_refused(node: Node) -> None:
    for wrong in (np.bytes_(b"a"), np.array([[1, 2]]), np.complex64(1j), np.array([1, "a"], object)):
        with pytest.raises(TypeError, match="is not one of the allowed types"):
            node.declare_parameter("wrong", wrong)
