"""The reader of CMakeLists.txt: its syntax, variables and conditions, and the plan of a package."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.workspace.conftest import write_files

from tfloom.workspace import cmake_lists
from tfloom.workspace.cmake_lists import read_plan
from tfloom.workspace.cmake_plan import (
    PYTHON_FOLDER,
    Install,
    Pattern,
    Plan,
    PytestTest,
    PythonPackage,
    Remark,
    Resource,
)
from tfloom.workspace.cmake_syntax import CMakeSyntaxError, Form, read_commands
from tfloom.workspace.index import RESOURCE_INDEX

INTERFACES = """\
cmake_minimum_required(VERSION 3.8)
project(my_interfaces)  # the name

if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall -Wextra -Wpedantic)
endif()

find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(geometry_msgs REQUIRED)

set(msg_files
  "msg/Sphere.msg"  # a ball
  msg/Num.msg
)
#[[ a comment
of two lines ]]
rosidl_generate_interfaces(${PROJECT_NAME}
  ${msg_files}
  "srv/Add.srv"
  DEPENDENCIES geometry_msgs std_msgs
  ADD_LINTER_TESTS
)
ament_export_dependencies(rosidl_default_runtime)

if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  set(ament_cmake_copyright_FOUND TRUE)
  ament_lint_auto_find_test_dependencies()
endif()

ament_package()
"""


def plan_of(folder: Path, text: str) -> Plan:
    (folder / "CMakeLists.txt").write_text(text, "utf-8")
    return read_plan(folder, folder / "install")


def lines_of(remarks: list[Remark]) -> list[int]:
    return [remark.line for remark in remarks]


def test_interface_package_is_read(tmp_path: Path) -> None:
    plan = plan_of(tmp_path, INTERFACES)
    assert plan.name == "my_interfaces"
    assert plan.interfaces == ["msg/Sphere.msg", "msg/Num.msg", "srv/Add.srv"]
    assert plan.interfaces_line == 18
    assert plan.dependencies == ["geometry_msgs", "std_msgs"]
    assert plan.found == ["ament_cmake", "rosidl_default_generators", "geometry_msgs"]
    assert plan.unknown == []
    assert plan.compiled == []


def test_installs_are_read(tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path,
        """
project(arm_description)
install(DIRECTORY launch meshes/ DESTINATION share/${PROJECT_NAME}
  FILES_MATCHING PATTERN "*.dae" PATTERN ".svn" EXCLUDE REGEX "/tmp" EXCLUDE)
install(FILES arm.urdf DESTINATION share/${PROJECT_NAME} RENAME robot.urdf)
INSTALL(PROGRAMS scripts/go.py DESTINATION "lib/${PROJECT_NAME}")
install(FILES run.sh PERMISSIONS OWNER_READ OWNER_EXECUTE DESTINATION lib/x)
ament_python_install_package(${PROJECT_NAME} PACKAGE_DIR src/arm)
ament_index_register_resource(plugins CONTENT "a;b")
ament_auto_package(INSTALL_TO_SHARE config)
""",
    )
    share = "share/arm_description"
    excluded = (Pattern("*.dae", False, False), Pattern(".svn", False, True), Pattern("/tmp", True, True))
    assert plan.installs == [
        Install("DIRECTORY", ("launch", "meshes/"), share, 3, None, False, excluded, True),
        Install("FILES", ("arm.urdf",), share, 5, "robot.urdf"),
        Install("PROGRAMS", ("scripts/go.py",), "lib/arm_description", 6),
        Install("PROGRAMS", ("run.sh",), "lib/x", 7),
        Install("DIRECTORY", ("config",), share, 10),
    ]
    assert plan.python_packages == [PythonPackage("arm_description", "src/arm", PYTHON_FOLDER, 8)]
    assert plan.resources == [Resource("plugins", "a;b", 9)]


def test_quotes_brackets_and_escapes_are_read(tmp_path: Path) -> None:
    path = tmp_path / "CMakeLists.txt"
    path.write_text('a(one "two words" [==[three ]] x]==] "q\\"d" (b) k="v w" four\\ five)\n\nb()', "utf-8")
    first, second = read_commands(path)
    assert [(argument.text, argument.form) for argument in first.arguments] == [
        ("one", Form.UNQUOTED),
        ("two words", Form.QUOTED),
        ("three ]] x", Form.BRACKET),
        ('q\\"d', Form.QUOTED),
        ("(", Form.UNQUOTED),
        ("b", Form.UNQUOTED),
        (")", Form.UNQUOTED),
        ('k="v w"', Form.UNQUOTED),
        ("four\\ five", Form.UNQUOTED),
    ]
    assert (second.name, second.line) == ("b", 3)


@pytest.mark.parametrize(
    ("setting", "expected"),
    [
        ("set(v a b)\nlist(APPEND v c)", ["a", "b", "c"]),
        ('set(v "a;b")\nlist(PREPEND v z)', ["z", "a", "b"]),
        ("set(v a b a)\nlist(REMOVE_ITEM v a)", ["b"]),
        ('set(v a.x b.y)\nlist(FILTER v EXCLUDE REGEX "[.]x$")', ["b.y"]),
        ('set(v a.x b.y)\nlist(FILTER v INCLUDE REGEX "[.]x$")', ["a.x"]),
        ("set(n v)\nset(in_v a)\nset(v ${in_${n}}b)", ["ab"]),
        ("set(v a)\nunset(v)", []),
        (r'set(v a\ b "c\"d" "e\tf")', ["a b", 'c"d', "e\tf"]),
        ("set(v a CACHE STRING x)", ["a"]),
        ("foreach(i a b)\nlist(APPEND v msg/${i}.msg)\nendforeach()", ["msg/a.msg", "msg/b.msg"]),
        ("set(l a b)\nforeach(i IN LISTS l ITEMS c)\nlist(APPEND v ${i})\nendforeach()", ["a", "b", "c"]),
        ("file(GLOB v RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)", ["msg/A.msg", "msg/B.msg"]),
        ("file(GLOB v RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} m**/[AB].m**)", ["msg/A.msg", "msg/B.msg"]),
        (
            "file(GLOB_RECURSE v CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} *.msg)",
            ["msg/A.msg", "msg/B.msg"],
        ),
        ("option(USE_A x ON)\nif(USE_A)\nset(v a)\nendif()", ["a"]),
    ],
)
def test_variables_are_followed(setting: str, expected: list[str], tmp_path: Path) -> None:
    (tmp_path / "msg").mkdir()
    for name in ("B", "A"):
        (tmp_path / "msg" / f"{name}.msg").touch()
    plan = plan_of(tmp_path, f"project(p)\n{setting}\nrosidl_generate_interfaces(p ${{v}})")
    assert plan.interfaces == expected
    assert plan.unknown == []


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("BUILD_TESTING", False),
        ("NOT BUILD_TESTING", True),
        ("ON AND yes", True),
        ("OFF OR NOT (FALSE OR 0)", True),
        ("a", False),
        ("set_one", True),
        ("${set_one}", True),
        ('"set_one"', False),
        ("set_one STREQUAL value", False),
        ("set_one STREQUAL 1", True),
        ('"$ENV{NO_SUCH_VARIABLE}" STREQUAL ""', True),
        ("DEFINED set_one AND NOT DEFINED other", True),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt", True),
        ("EXISTS nothing", False),
        ("2.10 VERSION_GREATER 2.9", True),
        ("3 LESS 10", True),
        ("b IN_LIST letters", True),
        ("something-NOTFOUND", False),
        ("TARGET x", False),
    ],
)
def test_conditions_are_followed(condition: str, expected: bool, tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path,
        f"set(set_one 1)\nset(letters a b)\nif({condition})\nfind_package(yes)\nelse()\nfind_package(no)\nendif()",
    )
    assert plan.found == (["yes"] if expected else ["no"])
    assert plan.unknown == []


@pytest.mark.parametrize(
    ("system", "machine", "true", "false"),
    [
        ("Linux", "aarch64", ("UNIX", "LINUX", "CMAKE_HOST_LINUX"), ("APPLE", "WIN32", "CMAKE_HOST_APPLE")),
        ("Darwin", "arm64", ("UNIX", "APPLE", "CMAKE_HOST_APPLE"), ("LINUX", "WIN32")),
        ("Windows", "AMD64", ("WIN32", "CMAKE_HOST_WIN32"), ("UNIX", "LINUX", "CMAKE_HOST_UNIX")),
    ],
)  # fmt: skip
def test_variables_of_the_system_are_set(
    system: str,
    machine: str,
    true: tuple[str, ...],
    false: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("platform.system", lambda: system)
    monkeypatch.setattr("platform.machine", lambda: machine)
    monkeypatch.setattr("platform.release", lambda: "6.1")
    names = [
        *("CMAKE_SYSTEM", "CMAKE_SYSTEM_NAME", "CMAKE_SYSTEM_PROCESSOR", "CMAKE_SYSTEM_VERSION"),
        *("CMAKE_HOST_SYSTEM", "CMAKE_HOST_SYSTEM_NAME", "CMAKE_HOST_SYSTEM_PROCESSOR"),
    ]
    plan = plan_of(
        tmp_path,
        f"""
        foreach(name {" ".join(names)})
          find_package(${{name}}=${{${{name}}}})
        endforeach()
        foreach(name {" ".join(true + false)})
          if(${{name}})
            find_package(${{name}})
          endif()
        endforeach()
        """,
    )
    values = [f"{system}-6.1", system, machine, "6.1", f"{system}-6.1", system, machine]
    assert plan.found == [*(f"{name}={value}" for name, value in zip(names, values, strict=True)), *true]


def test_branches_are_nested(tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path,
        """
if(OFF)
  if(ON)
    find_package(a)
  else()
    find_package(b)
  endif()
elseif(ON)
  if(OFF)
    find_package(c)
  else()
    find_package(d)
  endif()
else()
  find_package(e)
endif()
return()
find_package(f)
""",
    )
    assert plan.found == ["d"]


def test_compiled_code_is_named(tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path,
        """
project(talker)
add_executable(talker src/talker.cpp)
target_include_directories(talker PUBLIC include)
ament_target_dependencies(talker rclcpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
ament_package()
""",
    )
    assert plan.compiled == [Remark(3, "add_executable(talker …)"), Remark(6, "install(TARGETS …)")]
    assert plan.programs == ["talker"]
    assert plan.is_left_out
    assert plan.unknown == []


def test_programs_beside_compiled_code_are_installed(tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path, "add_executable(a a.cpp)\ninstall(PROGRAMS run.py DESTINATION lib/p)\ninstall(TARGETS a)\n"
    )
    assert plan.compiled
    assert not plan.is_cpp
    assert plan.installs == [Install("PROGRAMS", ("run.py",), "lib/p", 2)]


@pytest.mark.parametrize("name", ["CMAKE_CURRENT_BINARY_DIR", "CMAKE_BINARY_DIR", "PROJECT_BINARY_DIR"])
def test_generated_files_are_named_and_others_installed(name: str, tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path,
        f"install(FILES ${{{name}}}/a/b.yaml c.yaml DESTINATION share)\n"
        f"install(DIRECTORY ${{{name}}}/d/ DESTINATION share)\n",
    )
    assert [install.sources for install in plan.installs] == [("c.yaml",), ()]
    reason = "is generated by a command that isn't run, so it is left out"
    assert plan.unknown == [
        Remark(1, f"install(FILES …): a/b.yaml {reason}"),
        Remark(2, f"install(DIRECTORY …): d {reason}"),
    ]


def test_package_of_cpp_with_files_is_no_more_left_out(tmp_path: Path) -> None:
    text = "add_library(a a.cpp)\ninstall(DIRECTORY include/ DESTINATION include/a)\n"
    assert plan_of(tmp_path, text).is_left_out
    plan = plan_of(tmp_path, text + "install(DIRECTORY launch DESTINATION share/a)\n")
    assert plan.is_cpp
    assert not plan.is_left_out


NOT_FOUND = 'find_package(arm_control 4.0.0)\nif({condition})\n  message(FATAL_ERROR "no control")\nendif()\n'


@pytest.mark.parametrize(
    "condition",
    [
        "NOT arm_control_FOUND",
        "NOT ${arm_control_FOUND}",
        "NOT ARM_CONTROL_FOUND",
        "arm_control_VERSION VERSION_LESS 4.0.0",
    ],
)
def test_what_stops_for_want_of_a_package_counts_as_cpp(condition: str, tmp_path: Path) -> None:
    plan = plan_of(tmp_path, NOT_FOUND.replace("{condition}", condition) + "install(FILES a DESTINATION b)\n")
    assert plan.compiled == [Remark(1, "find_package(arm_control …)")]
    assert len(plan.installs) == 1  # what follows is read


@pytest.mark.parametrize(
    ("search", "condition"),
    [
        ("find_library(LASER laser)", "NOT LASER"),
        ("find_path(LASER_DIR laser.h)", 'LASER_DIR STREQUAL "LASER_DIR-NOTFOUND" OR NOT LASER_DIR'),
        ("pkg_check_modules(LASER liblaser)", "NOT LASER_FOUND"),
    ],
)
def test_what_stops_for_want_of_a_library_counts_as_cpp(search: str, condition: str, tmp_path: Path) -> None:
    error = f"if({condition})\nmessage(FATAL_ERROR no)\nendif()\n"
    text = f"{search}\nif({condition})\nelseif(FALSE)\nelse()\nendif()\n{error}"
    (remark,) = plan_of(tmp_path, text).compiled
    assert (remark.line, remark.text) == (1, search.partition(" ")[0] + " …)")


@pytest.mark.parametrize("package", ["geometry_msgs", "ament_cmake", "here_msgs"])
def test_package_that_is_there_is_found(
    package: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_files(tmp_path / "ws" / RESOURCE_INDEX, {"packages/here_msgs": ""})
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "ws"))
    text = f"find_package({package})\nif({package}_FOUND)\ninstall(FILES a DESTINATION b)\nendif()\n"
    plan = plan_of(tmp_path, text + f"if(NOT {package}_FOUND)\nmessage(FATAL_ERROR x)\nendif()\n")
    assert (len(plan.installs), plan.compiled) == (1, [])


def test_other_fatal_errors_stop_the_reading(tmp_path: Path) -> None:
    text = "find_package(arm_control)\nif(NOT arm_control_FOUND)\nendif()\nif(NOT A)\nmessage(FATAL_ERROR no)\nendif()"
    with pytest.raises(CMakeSyntaxError, match=r":5: no$"):
        plan_of(tmp_path, text)


CONFIGURED = """\
name: @PROJECT_NAME@ ${PROJECT_NAME} [@UNSET@]
#cmakedefine SIZE "@SIZE@"
#cmakedefine NOTHING
#  cmakedefine01 SIZE
#cmakedefine01 NOTHING
${A_@A@} @
"""
DEFINED = '#define SIZE "3"\n/* #undef NOTHING */\n#  define SIZE 1\n#define NOTHING 0\n${A_b} @\n'


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (
            "",
            f"name: arm arm []\n{DEFINED}",
        ),
        (
            "@ONLY",
            f"name: arm ${{PROJECT_NAME}} []\n{DEFINED}",
        ),
        ("COPYONLY", CONFIGURED),
    ],
)
def test_files_are_configured(options: str, expected: str, tmp_path: Path) -> None:
    (tmp_path / "a.yaml.in").write_text(CONFIGURED)
    plan = plan_of(
        tmp_path,
        "project(arm)\nset(SIZE 3)\nset(A b)\n"
        f"configure_file(a.yaml.in ${{CMAKE_CURRENT_BINARY_DIR}}/d/a.yaml {options})\n"
        f"configure_file(a.yaml.in a.txt {options})\nconfigure_file(a.yaml.in ${{PROJECT_BINARY_DIR}} {options})\n"
        "install(FILES ${PROJECT_BINARY_DIR}/d/a.yaml ${PROJECT_BINARY_DIR}/no DESTINATION b)\n",
    )
    assert {name: data.decode() for name, data in plan.generated.items()} == dict.fromkeys(
        ("d/a.yaml", "a.txt", "a.yaml.in"), expected
    )
    assert [install.sources for install in plan.installs] == [("<build>/d/a.yaml",)]


def test_a_file_is_configured_neither_into_the_source_nor_without_bounds(tmp_path: Path) -> None:
    (tmp_path / "a.in").write_text("x")
    plan = plan_of(
        tmp_path,
        "configure_file(a.in ${CMAKE_CURRENT_SOURCE_DIR}/a.py)\n"
        "configure_file(a.in ../a.py)\nconfigure_file(no.in b)\n",
    )
    assert plan.generated == {}
    assert [remark.text.partition(" ")[2] for remark in plan.unknown] == [
        f"writes {tmp_path}/a.py, outside of the build folder, and isn't run",
        "writes ../a.py, outside of the build folder, and isn't run",
        "no.in can't be read: No such file or directory",
    ]
    assert not (tmp_path / "a.py").exists()
    (tmp_path / "a.in").write_bytes(b"x" * 1_000_001)
    with pytest.raises(CMakeSyntaxError, match=r"CMakeLists.txt:1: .*a.in has more than 1000000 bytes"):
        plan_of(tmp_path, "configure_file(a.in b)")


@pytest.mark.parametrize(
    "macro", ["nav2_package", "set_compiler_options", "export_windows_symbols", "moveit_package"]
)
def test_macros_without_effect_are_silent(macro: str, tmp_path: Path) -> None:
    assert plan_of(tmp_path, f"{macro}()\n").unknown == []


PYTEST_TESTS = """
if(BUILD_TESTING)
  set(tests test/test_a.py test/deep/b.test.py)
  foreach(path ${tests})
    get_filename_component(name ${path} NAME_WE)
    ament_add_pytest_test(${name} ${path} TIMEOUT 60 WORKING_DIRECTORY ${CMAKE_BINARY_DIR} ENV A=1 APPEND_ENV B=2 C=3)
  endforeach()
  ament_add_pytest_test(skipped test SKIP_TEST)
  ament_add_pytest_test(nameless)
  ament_add_gtest(other x.cpp)
endif()
"""


def test_pytest_tests_are_read_for_testing_only(tmp_path: Path) -> None:
    assert plan_of(tmp_path, PYTEST_TESTS) == Plan()
    plan = read_plan(tmp_path, tmp_path / "install", testing=True)
    rest = ("<build>", ("A=1",), ("B=2", "C=3"), 6)
    assert plan.tests == [
        PytestTest("test_a", "test/test_a.py", *rest),
        PytestTest("b", "test/deep/b.test.py", *rest),
    ]
    assert plan.unknown == [Remark(9, "ament_add_pytest_test(): a name and a path are expected")]


LAUNCH_TESTS = """
if(BUILD_TESTING)
  find_package(launch_testing_ament_cmake)
  add_launch_test(test/a.test.py)
  add_launch_test(test/b.py TARGET b TIMEOUT 60 ARGS "x:=1" y:=2 ENV A=1)
  add_launch_test(test/c.py SKIP_TEST)
  add_launch_test()
endif()
"""


def test_launch_tests_are_read(tmp_path: Path) -> None:
    assert plan_of(tmp_path, LAUNCH_TESTS) == Plan()
    plan = read_plan(tmp_path, tmp_path / "install", testing=True)
    assert plan.tests == [
        PytestTest("test_a.test.py", "test/a.test.py", "", (), (), 4, launches=True),
        PytestTest("b", "test/b.py", "", ("A=1",), (), 5, ("x:=1", "y:=2"), launches=True),
    ]
    assert plan.unknown == [Remark(7, "add_launch_test(): a path is expected")]


@pytest.mark.parametrize(
    ("part", "expected"),
    [("NAME", "x.launch.py"), ("NAME_WE", "x"), ("NAME_WLE", "x.launch"), ("DIRECTORY", "a/b")],
)
def test_parts_of_paths_are_read(part: str, expected: str, tmp_path: Path) -> None:
    plan = plan_of(tmp_path, f"get_filename_component(v a/b/x.launch.py {part})\nfind_package(${{v}})\n")
    assert plan.found == [expected]


def test_what_is_not_understood_is_named_with_its_line(tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path,
        """
project(p)
my_command(x)
function(my_function)
  install(FILES x DESTINATION y)
endfunction()
my_function()
execute_process(COMMAND rm -rf /)
if(x UNHEARD_OF y)
endif()
while(ON)
endwhile()
list(LENGTH a b)
file(WRITE x y)
install(CODE x)
install(FILES x TYPE DATA)
include(cmake/mine.cmake)
include(CTest)
ament_index_register_resource(x CONTENT_FILE y)
""",
    )
    assert lines_of(plan.unknown) == [3, 7, 8, 9, 11, 13, 14, 15, 16, 17, 19]
    assert plan.unknown[0].text == "my_command() isn't understood"
    assert plan.unknown[3].text == "'UNHEARD_OF' isn't understood in a condition; if() is taken as false"
    assert plan.installs == []


@pytest.mark.parametrize(
    ("text", "line", "reason"),
    [
        ("project(p)\nset(a", 2, "the parenthesis of 'set(' isn't closed"),
        ('project(p)\n\nset(a "b)\n', 3, "the quote of an argument of 'set' isn't closed"),
        ("project p", 1, "'(' is expected after 'project'"),
        ("project(p)\n)", 2, "a command's name is expected, not ')'"),
        ("if(ON)\nproject(p)", 1, "if() isn't ended by endif()"),
        ("endif()", 1, "endif() without what it ends"),
        ("foreach()\nendforeach()", 1, "foreach() without a variable"),
        (
            'list(FILTER v EXCLUDE REGEX "*")',
            1,
            "'*' isn't a regular expression: nothing is before '*'",
        ),
        ("a(b\n[[c])", 2, "the bracket of an argument of 'a' isn't closed"),
        ('set(v 1)\nmessage(FATAL_ERROR "version ${v} " "is old")', 2, "version 1 is old"),
        ("\u201cproject\u201d(p)", 1, "a command's name is expected, not '\u201c'"),
    ],
)
def test_broken_file_is_refused_with_its_line(text: str, line: int, reason: str, tmp_path: Path) -> None:
    with pytest.raises(CMakeSyntaxError) as error:
        plan_of(tmp_path, text)
    assert str(error.value) == f"{tmp_path / 'CMakeLists.txt'}:{line}: {reason}"


def test_file_that_is_not_utf8_is_refused(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_bytes(b"project(p)\n# caf\xe9\n")
    with pytest.raises(CMakeSyntaxError, match=r"CMakeLists.txt:2: octet 0xe9 isn't UTF-8 text"):
        read_plan(tmp_path, tmp_path)


def test_endless_loops_end(tmp_path: Path) -> None:
    loops = "set(l a b c d e f g h i j)\n" + "".join(f"foreach(i{n} IN LISTS l)\n" for n in range(7))
    with pytest.raises(CMakeSyntaxError, match="more than 20000 commands"):
        plan_of(tmp_path, loops + "set(x y)\n" + "endforeach()\n" * 7)


def test_names_that_the_system_refuses_are_of_no_file(tmp_path: Path) -> None:
    name = "n" * 300
    text = (
        f"if(EXISTS {name} OR IS_DIRECTORY {name})\nfind_package(a)\nendif()\nfile(GLOB v {name} {name}/*)\n"
    )
    assert plan_of(tmp_path, text) == Plan()


def test_messages_and_flags_add_nothing(tmp_path: Path) -> None:
    plan = plan_of(
        tmp_path, 'project(p)\nmessage(STATUS "hello")\nset_target_properties(a b c)\nset(ENV{A} b)'
    )
    assert lines_of(plan.unknown) == [4]


def _nested(begin: str, end: str, levels: int, inner: str = "") -> str:
    return begin * levels + inner + end * levels


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("set(a x)\n" + "set(a ${a}${a})\n" * 60, "the values of its variables take more than 3000000"),
        ("set(a x;y)\n" + "list(APPEND a ${a})\n" * 60, "the values of its variables take more than 3000000"),
        ("set(a x)\n" + "set(a ${a}${a})\n" * 18 + "if(a STREQUAL b)\nendif()\n" * 50, "the values of its"),
        (
            _nested("foreach(a 1 2 3 4 5 6 7)\n", "endforeach()\n", 12),
            "the file takes more than 20000 commands",
        ),
        (_nested("foreach(a 1)\n", "endforeach()\n", 101), "more than 100 blocks are nested"),
        (_nested("if(1)\n", "endif()\n", 10_000), "too many blocks are in blocks or in loops"),
        (_nested("if(" + "(" * 100_000, ")" * 100_000 + ")\nendif()", 1, "1"), "more than 100 parentheses"),
        (
            'list(APPEND p "(")\n' + "list(APPEND p ${p})\n" * 7 + "if(${p} 1)\nendif()\n",
            "more than 100 par",
        ),
        ("if(" + "NOT " * 100_000 + "1)\nendif()\n", "more than 50000 arguments"),
        (
            f'if({"a" * 3000} MATCHES "{"a?" * 3000 + "a" * 3000}")\nendif()\n',
            "its regular expressions take more",
        ),
        (
            f'list(APPEND v {"ab" * 3000})\nlist(FILTER v INCLUDE REGEX "{"(a|b|c)" * 1000}x")\n',
            "its regular expressions take more",
        ),
        ("a(" + "[[ " * 30_000 + "x" * 900_000 + ")", "the bracket of an argument of 'a' isn't closed"),
        ("file(GLOB_RECURSE v " + "../" * 20 + "usr/*)\n", "list more than 1000 files"),
        ("#" * 1_000_001, "it has 1000001 characters, more than 1000000"),
    ],
)
def test_what_would_take_for_ever_is_named_with_its_line(
    tmp_path: Path, text: str, reason: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cmake_lists, "MAX_LISTED", 1000)
    with pytest.raises(CMakeSyntaxError, match=rf"CMakeLists\.txt:\d+: .*{reason}"):
        plan_of(tmp_path, text)


def test_what_is_merely_large_is_read(tmp_path: Path) -> None:
    names = " ".join(f"msg/Message{number}.msg" for number in range(10_000))
    blocks = _nested("if(1)\n", "endif()\n", 90, "foreach(n ${names})\n  set(b ${n})\nendforeach()\n")
    plan = plan_of(
        tmp_path, f"set(names {names})\n{blocks}install(FILES ${{names}} ${{b}} DESTINATION share)\n"
    )
    assert not plan.unknown
    expression = "^(msg/)+([A-Z][a-z]+)+[0-9]*1[.](msg|srv)$"
    matches = f'foreach(n ${{names}})\nif(n MATCHES "{expression}")\nset(b ${{n}})\nendif()\nendforeach()\n'
    plan = plan_of(
        tmp_path,
        f'set(names {names})\n{matches}list(FILTER names INCLUDE REGEX "99+[.]msg$")\nfind_package(${{b}} ${{names}})',
    )
    assert (plan.found, plan.unknown) == (["msg/Message9991.msg"], [])
    condition = "NOT " * 1000 + "VERSION_X VERSION_LESS " + "9" * 5000
    assert not plan_of(tmp_path, f"if({condition})\nendif()\n").unknown
