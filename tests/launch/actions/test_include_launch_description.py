"""Inclusions: arguments, the place of the current file, and circles."""

from __future__ import annotations

from pathlib import Path

import pytest

from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument
from tfloom.launch.actions.group_action import GroupAction
from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription
from tfloom.launch.actions.launch_configurations import ResetLaunchConfigurations, SetLaunchConfiguration
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.core.circular_includes import CircularIncludeError
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.conditions import IfCondition
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.entities.launch_description_source import LaunchDescriptionSource
from tfloom.launch.ros.actions.node_defaults import SetParameter, SetRemap
from tfloom.launch.substitutions.variables import LaunchConfiguration
from tfloom.launch.utilities.visits import visit_all_entities_and_collect_futures


def visited(*entities: LaunchDescriptionEntity) -> dict[str, str]:
    """Visit entities, and return the launch configurations after them."""
    context = LaunchContext()
    for entity in entities:
        visit_all_entities_and_collect_futures(entity, context)
    assert context.get_locals_as_dict().keys() <= {"included_launch_files"}
    return context.launch_configurations


def source(*entities: LaunchDescriptionEntity) -> LaunchDescriptionSource:
    return LaunchDescriptionSource(LaunchDescription(entities))


def write(path: Path, *lines: str) -> str:
    path.parent.mkdir(exist_ok=True)
    path.write_text("<launch>" + "\n".join(lines) + "</launch>\n")
    return str(path)


def test_arguments_are_configurations_of_the_included_description() -> None:
    include = IncludeLaunchDescription(
        source(DeclareLaunchArgument("a"), DeclareLaunchArgument("b", default_value="2")),
        launch_arguments={"a": "1", "un": "declared"}.items(),
    )
    assert include.launch_arguments == (("a", "1"), ("un", "declared"))
    assert visited(include) == {"a": "1", "b": "2", "un": "declared"}


def test_a_required_argument_without_a_value_is_an_error_before_anything_is_visited() -> None:
    inner = source(
        DeclareLaunchArgument("x", default_value="1"), DeclareLaunchArgument("need", description="d")
    )
    include = IncludeLaunchDescription(inner, launch_arguments=[("other", "1"), ("more", "2")])
    context = LaunchContext()
    with pytest.raises(RuntimeError) as error:
        visit_all_entities_and_collect_futures(include, context)
    assert str(error.value) == (
        "Included launch description missing required argument 'need' (description: 'd'), given: [other, more]"
    )
    assert context.launch_configurations == {}


def test_an_include_that_fails_leaves_the_place_of_the_outer_file() -> None:
    """As with --skip-missing, after which the outer file goes on."""
    context = LaunchContext()
    context.extend_locals({"current_launch_file_path": "/outer.py", "current_launch_file_directory": "/"})
    include = IncludeLaunchDescription(source(DeclareLaunchArgument("need")))
    for _ in range(2):
        with pytest.raises(RuntimeError, match="missing required argument"):
            include.visit(context)
        place = context.get_locals_as_dict()
        assert place["current_launch_file_path"] == "/outer.py"
        assert place["current_launch_file_directory"] == "/"


def test_subclass_with_its_own_visit_ends_its_visit() -> None:
    class OfAUser(IncludeLaunchDescription):
        def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
            return self.execute(context)

    context = LaunchContext()
    visit_all_entities_and_collect_futures(OfAUser(source(SetLaunchConfiguration("a", "1"))), context)
    assert context.launch_configurations == {"a": "1"}


def test_an_argument_that_may_not_be_used_is_not_required() -> None:
    declared = DeclareLaunchArgument("need")
    assert (
        visited(IncludeLaunchDescription(source(GroupAction([declared], condition=IfCondition("false")))))
        == {}
    )
    with pytest.raises(RuntimeError, match='"need" was not provided'):
        visited(IncludeLaunchDescription(source(GroupAction([declared], condition=IfCondition("true")))))


def test_an_argument_that_an_inner_inclusion_gives_is_not_required() -> None:
    inner = source(DeclareLaunchArgument("need"))
    outer = source(IncludeLaunchDescription(inner, launch_arguments=[("need", "1")]))
    assert visited(IncludeLaunchDescription(outer)) == {"need": "1"}


def test_an_argument_that_is_a_configuration_already_is_not_required() -> None:
    inner = IncludeLaunchDescription(source(DeclareLaunchArgument("need")))
    outer = source(DeclareLaunchArgument("need", default_value="1"), inner)
    assert visited(IncludeLaunchDescription(outer)) == {"need": "1"}


def test_arguments_of_a_description_are_found_in_its_inclusions_and_groups() -> None:
    include = IncludeLaunchDescription(source(DeclareLaunchArgument("inner"), DeclareLaunchArgument("both")))
    description = LaunchDescription(
        [
            DeclareLaunchArgument("both", description="the first"),
            GroupAction([include], condition=IfCondition(LaunchConfiguration("both"))),
            DeclareLaunchArgument("if", condition=IfCondition("true")),
            GroupAction([ResetLaunchConfigurations(), DeclareLaunchArgument("hidden")]),
            DeclareLaunchArgument("last"),
        ]
    )
    declarations = description.get_launch_arguments_with_include_launch_description_actions()
    assert [(argument.name, argument._conditionally_included, path) for argument, path in declarations] == [
        ("both", False, None),
        ("inner", True, [include]),
        ("if", True, None),
        ("last", False, None),
    ]
    assert description.get_launch_arguments()[0].description == "the first"


def test_place_of_the_current_file(tmp_path: Path) -> None:
    inner = write(
        tmp_path / "inner" / "b.launch.xml",
        '<let name="inner" value="$(dirname)"/>',
        '<let name="f" value="$(filename)"/>',
    )
    outer = write(
        tmp_path / "a.launch.xml",
        '<include file="$(dirname)/inner/b.launch.xml"><let name="given" value="$(dirname)"/></include>',
        '<let name="outer" value="$(dirname)"/>',
    )
    configurations = visited(IncludeLaunchDescription(outer))
    assert configurations == {
        "inner": str(tmp_path / "inner"),
        "f": inner,
        "outer": str(tmp_path),
        "given": configurations["given"],
    }


def test_a_file_that_includes_itself_is_an_error_that_names_the_circle(tmp_path: Path) -> None:
    one, two = str(tmp_path / "one.launch.xml"), str(tmp_path / "two.launch.yaml")
    write(Path(one), '<include file="$(dirname)/two.launch.yaml"/>', '<arg name="late"/>')
    Path(two).write_text("launch: [{include: {file: $(dirname)/one.launch.xml}}]")
    with pytest.raises(CircularIncludeError) as error:
        visited(IncludeLaunchDescription(one, launch_arguments=[("late", "1")]))
    assert str(error.value).endswith(f"launch files include each other in a circle: {two} -> {one} -> {two}")
    (argument,) = LaunchDescription([IncludeLaunchDescription(one)]).get_launch_arguments()
    assert argument.name == "late"


def test_a_file_may_include_itself_while_its_arguments_change(tmp_path: Path) -> None:
    path = write(
        tmp_path / "down.launch.xml",
        '<arg name="n"/><let name="at_$(var n)" value="yes"/>',
        '<include file="$(filename)" if="$(eval \'$(var n) &gt; 0\')">',
        '<arg name="n" value="$(eval \'$(var n) - 1\')"/></include>',
    )
    configurations = visited(IncludeLaunchDescription(path, launch_arguments=[("n", "3")]))
    assert configurations == {"n": "0", "at_3": "yes", "at_2": "yes", "at_1": "yes", "at_0": "yes"}


def test_a_file_may_be_included_where_parameters_and_remappings_are_set(tmp_path: Path) -> None:
    path = write(tmp_path / "a.launch.xml", '<let name="seen" value="yes"/>')
    again = SetParameter("p", 1), SetRemap("a", "b"), IncludeLaunchDescription(path)
    configurations = visited(*again, *again)
    assert configurations["seen"] == "yes"


def test_a_dictionary_of_arguments_is_an_error_that_says_what_to_give() -> None:
    with pytest.raises(TypeError, match=r"launch_arguments=\{...\}\.items\(\)"):
        IncludeLaunchDescription("a.launch.xml", launch_arguments={"ab": "c"})  # type: ignore[dict-item]


def test_a_path_may_have_substitutions(tmp_path: Path) -> None:
    write(tmp_path / "a.launch.xml", '<let name="seen" value="yes"/>')
    context = LaunchContext()
    context.launch_configurations["folder"] = str(tmp_path)
    include = IncludeLaunchDescription([LaunchConfiguration("folder"), "/a.launch.xml"])
    assert include.get_sub_entities() == []
    visit_all_entities_and_collect_futures(include, context)
    assert context.launch_configurations["seen"] == "yes"
    assert include.launch_description_source.location == str(tmp_path / "a.launch.xml")


def test_a_visit_returns_the_arguments_and_the_description_alone() -> None:
    description = LaunchDescription()
    plain = IncludeLaunchDescription(LaunchDescriptionSource(description, "x"))
    assert plain.visit(LaunchContext()) == [description]
    given = IncludeLaunchDescription(LaunchDescriptionSource(description, "x"), launch_arguments=[("a", "b")])
    settings, *rest = given.visit(LaunchContext()) or []
    assert type(settings) is SetLaunchConfiguration
    assert rest == [description]
    assert given.execute(LaunchContext())[1:] == [description]


def test_the_place_of_the_file_returns_after_each_visit_of_one_action() -> None:
    places: list[object] = []

    def note(context: LaunchContext) -> None:
        places.append(context.get_locals_as_dict().get("current_launch_file_directory"))

    wanted = LaunchConfiguration("wanted")
    inner = LaunchDescriptionSource(LaunchDescription([OpaqueFunction(function=note)]), "inner")
    include = IncludeLaunchDescription(inner, condition=IfCondition(wanted))
    outer = LaunchDescription()
    for value in ("true", "false", "true"):
        outer.add_action(SetLaunchConfiguration("wanted", value))
        outer.add_action(include)
        outer.add_action(OpaqueFunction(function=note))
    context = LaunchContext()
    top = IncludeLaunchDescription(LaunchDescriptionSource(outer, "outer"))
    visit_all_entities_and_collect_futures(top, context)
    note(context)
    assert places == ["inner", "outer", "outer", "inner", "outer", None]


def test_the_place_of_the_file_is_that_of_the_next_visit_after_one_that_failed() -> None:
    failing = IncludeLaunchDescription(source(DeclareLaunchArgument("need")))
    context = LaunchContext()
    with pytest.raises(RuntimeError):
        visit_all_entities_and_collect_futures(failing, context)
    context = LaunchContext()
    context.launch_configurations["need"] = "1"
    context.extend_locals({"current_launch_file_path": "/a/b", "current_launch_file_directory": "/a"})
    visit_all_entities_and_collect_futures(failing, context)
    assert context.get_locals_as_dict()["current_launch_file_directory"] == "/a"
