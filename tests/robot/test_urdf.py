"""URDF: what is read of a description, and what is refused, by line."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tfloom.robot.description import JointRange, Limit, Mimic, range_of
from tfloom.robot.joint_tree import from_root
from tfloom.robot.mimicry import Dependence, LoopError, followers, resolve
from tfloom.robot.urdf import UrdfError, parse_urdf

ARM = Path(__file__).parents[1] / "golden" / "arm.urdf"
LIMIT = '<limit lower="-1" upper="2" effort="1" velocity="1"/>'


def joint(name: str, parent: str, child: str, kind: str = "fixed", inside: str = "") -> str:
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}</joint>'
    )


def robot(*parts: str, links: str = "ab") -> str:
    """Return a description whose first part is in line 3, the links in line 2."""
    declared = "".join(f'<link name="{link}"/>' for link in links)
    return "\n".join(['<robot name="r">', declared, *parts, "</robot>"])


def test_the_recorded_arm() -> None:
    arm = parse_urdf(ARM.read_text())
    assert (arm.name, arm.root) == ("arm", "base")
    assert arm.links == ("base", "upper", "lower", "slide", "spin", "tool")
    kinds = [(joint.name, joint.type) for joint in arm.joints.values()]
    assert kinds == [
        ("shoulder", "revolute"),
        ("elbow", "revolute"),
        ("rail", "prismatic"),
        ("roll", "continuous"),
        ("flange", "fixed"),
    ]
    elbow = arm.joints["elbow"]
    assert elbow.mimic == Mimic("shoulder", -0.5, 0.2)
    assert elbow.limit == Limit(-2.0, 2.0)
    assert elbow.axis == (0.0, 1.0, 0.0)
    assert arm.joints["shoulder"].origin.rpy_rad == pytest.approx((0.0, 0.1, 0.0), abs=1e-15)


def test_defaults() -> None:
    parsed = parse_urdf(robot(joint("j", "a", "b", "continuous")))
    found = parsed.joints["j"]
    assert found.origin.translation == (0.0, 0.0, 0.0)
    assert found.origin.rotation_xyzw == (0.0, 0.0, 0.0, 1.0)
    assert found.axis == (1.0, 0.0, 0.0)
    assert found.limit is None
    assert found.mimic is None


def test_axes_get_unit_length() -> None:
    for given in ("3 0 4", "3e200 0 4e200", "3e-200 0 4e-200"):
        parsed = parse_urdf(robot(joint("j", "a", "b", "continuous", f'<axis xyz="{given}"/>')))
        assert parsed.joints["j"].axis == pytest.approx((0.6, 0.0, 0.8), abs=1e-15)


def test_what_display_and_simulation_need_is_not_read() -> None:
    inside = (
        '<inertial><mass value="heavy"/></inertial><visual><geometry><mesh filename="x"/></geometry></visual>'
    )
    parsed = parse_urdf(
        f'<?xml version="1.0"?><!-- x --><robot name="r"><material name="m"/><link name="a">{inside}</link>'
        '<transmission name="t"><joint name="nothing"/></transmission><gazebo/></robot>'
    )
    assert parsed.links == ("a",)
    assert parsed.joints == {}


def test_joint_has_the_limit_of_its_effort() -> None:
    given = '<limit lower="-1" upper="1" effort="7.5" velocity="1"/>'
    parsed = parse_urdf(robot(joint("j", "a", "b", "revolute", given)))
    assert parsed.joints["j"].effort_limit == 7.5
    assert parse_urdf(robot(joint("j", "a", "b", "continuous", ""))).joints["j"].effort_limit is None


def test_a_safety_controller_may_have_one_end() -> None:
    inside = LIMIT + '<safety_controller k_velocity="1" soft_lower_limit="-0.5"/>'
    parsed = parse_urdf(robot(joint("j", "a", "b", "revolute", inside)))
    assert parsed.joints["j"].soft_limit == Limit(-0.5, math.inf)


def test_the_encoding_of_a_file_is_that_of_its_first_line() -> None:
    text = '<?xml version="1.0" encoding="iso-8859-1"?><robot name="Rüssel"><link name="Fuß"/></robot>'
    assert parse_urdf(text.encode("iso-8859-1")).links == ("Fuß",)
    assert parse_urdf(text).name == "Rüssel"


def test_joints_are_ordered_from_the_root() -> None:
    parsed = parse_urdf(robot(joint("2", "b", "c"), joint("1", "a", "b"), joint("3", "a", "d"), links="dcba"))
    assert parsed.root == "a"
    assert [joint.name for joint in from_root(parsed)] == ["1", "2", "3"]


def test_mimic_joints_follow_by_way_of_others() -> None:
    def mimic(of: str, multiplier: float, offset: float) -> str:
        return f'<mimic joint="{of}" multiplier="{multiplier}" offset="{offset}"/>'

    parsed = parse_urdf(
        robot(
            joint("1", "a", "b", "continuous", mimic("2", 2.0, 1.0)),
            joint("2", "b", "c", "continuous", mimic("3", -3.0, 0.5)),
            joint("3", "c", "d", "continuous"),
            links="abcd",
        )
    )
    dependences = followers(parsed.joints)
    assert list(dependences) == ["2", "1"], "what is followed comes first"
    assert [
        (dependence.parent, dependence.factor, dependence.offset) for dependence in dependences.values()
    ] == [
        ("3", -3.0, 0.5),
        ("3", -6.0, 2.0),
    ]


REFUSED = [
    ("", 1, "not well-formed XML: no element found"),
    ("<robot", 1, "not well-formed XML: unclosed token at column 1"),
    ('<robot name="r">\n<link name="a">\n</robot>', 3, "mismatched tag at column 3, within <link> of line 2"),
    ("<model/>", 1, "the outermost element is <model>, not <robot>"),
    ("<robot/>", 1, "the robot has no name"),
    ('<robot name="r">\n</robot>', 1, "the robot has no link"),
    (robot("<link/>"), 3, "a link has no name"),
    (robot('<link name="b"/>'), 3, "the link 'b' exists already: line 2 has it"),
    (robot(joint("j", "a", "b"), joint("j", "a", "b")), 4, "the joint 'j' exists already: line 3 has it"),
    (
        robot(joint("j", "a", "b", "hinge")),
        3,
        "is of type 'hinge', which is none of: fixed, revolute, continuous",
    ),
    (robot('<joint name="j" type="fixed"><child link="b"/></joint>'), 3, "'j' has no <parent> link"),
    (robot(joint("j", "x", "b")), 3, "'j' has the parent link 'x', which does not exist"),
    (robot(joint("j", "a", "x")), 3, "'j' has the child link 'x', which does not exist"),
    (robot(links="ab"), 2, "several are not a joint's child: 'a' (line 2), 'b' (line 2)"),
    (robot(links="abcdefg"), 2, "'e' (line 2) and 2 more"),
    (
        robot(joint("1", "a", "b"), joint("2", "b", "a")),
        4,
        "the joints make a loop of links: 'a' -> 'b' -> 'a'",
    ),
    (robot(joint("1", "b", "c"), joint("2", "c", "b"), links="abc"), 4, "a loop of links: 'b' -> 'c' -> 'b'"),
    (robot(joint("1", "b", "b"), links="ab"), 3, "a loop of links: 'b' -> 'b'"),
    (
        robot(joint("1", "a", "c"), joint("2", "b", "c"), links="abc"),
        4,
        "the link 'c' is the child of two joints, '1' and '2'",
    ),
    (robot(joint("j", "a", "b", "revolute")), 3, "has no <limit>; one without limits is 'continuous'"),
    (robot(joint("j", "a", "b", "prismatic")), 3, "'j' is of type 'prismatic' and has no <limit>"),
    (
        robot(joint("j", "a", "b", "revolute", '<limit velocity="1"/>')),
        3,
        "<limit> of the joint 'j' has no effort",
    ),
    (
        robot(joint("j", "a", "b", "fixed", '\n<origin xyz="1 2"/>')),
        4,
        "xyz of <origin> of the joint 'j' has 2",
    ),
    (robot(joint("j", "a", "b", "fixed", '<origin rpy="0 0 1_0"/>')), 3, "'1_0' is not a number"),
    (robot(joint("j", "a", "b", "fixed", '<origin rpy="0 nan 0"/>')), 3, "'nan' is not a number"),
    (robot(joint("j", "a", "b", "continuous", '<axis xyz="0 0 0"/>')), 3, "has no direction: it is zero"),
    (robot(joint("j", "a", "b", "continuous", "<mimic/>")), 3, "<mimic> of the joint 'j' has no joint"),
    (
        robot(
            joint("j", "a", "b", "continuous", '<mimic joint="k"/>'),
            joint("k", "b", "c", "continuous", '<mimic joint="j"/>'),
            links="abc",
        ),
        3,
        "the joints mimic each other in a loop: 'j' -> 'k' -> 'j'",
    ),
    ('<!DOCTYPE r [\n<!ENTITY e "e">]><robot name="&e;"/>', 2, "the entity 'e' is declared"),
    ('<robot name="r">\n<xacro:arm/></robot>', 2, "this is xacro, not URDF: expand it"),
    (
        robot(joint("j", "a", "b", "fixed", '<origin xyz="${x} 0 0"/>')),
        3,
        "this is xacro, not URDF: expand it",
    ),
]


def fault_of(text: str) -> UrdfError | None:
    try:
        parse_urdf(text)
    except UrdfError as error:
        return error
    return None


def test_each_fault_is_named_with_its_line(deviations: dict[str, dict[str, str]]) -> None:
    assert "rsp-strict-urdf" in deviations
    wrong = []
    for text, line, reason in REFUSED:
        error = fault_of(text)
        if error is None or error.line != line or reason not in error.reason:
            wrong.append(f"{reason!r} at {line}: {error or 'accepted'}")
        else:
            assert str(error) == f"line {line}: {error.reason}"
    assert not wrong, "\n".join(wrong)


def test_hostile_texts_are_refused_quickly() -> None:
    bomb = "".join(f'<!ENTITY e{i + 1} "{f"&e{i};" * 10}">' for i in range(30))
    with pytest.raises(UrdfError, match="entities are not supported"):
        parse_urdf(f'<!DOCTYPE r [<!ENTITY e0 "x">{bomb}]><robot name="&e30;"/>')
    with pytest.raises(UrdfError, match="more than 200 elements are nested"):
        parse_urdf("<robot>" * 100_000)
    with pytest.raises(UrdfError, match="is longer than"):
        parse_urdf(" " * (64 * 1024 * 1024 + 1))
    with pytest.raises(UrdfError, match="can't be decoded"):
        parse_urdf("<robot name='\ud800'/>")
    with pytest.raises(UrdfError, match="the robot has no name"):  # a default would multiply its length
        parse_urdf('<!DOCTYPE robot [<!ATTLIST robot name CDATA "r">]><robot><link name="a"/></robot>')


def test_long_chains_take_time_in_proportion() -> None:
    count = 3_000
    links = "".join(f'<link name="{i}"/>' for i in range(count + 1))
    joints = "".join(
        joint(
            f"j{i}", str(i), str(i + 1), "continuous", f'<mimic joint="j{i + 1}"/>' if i < count - 1 else ""
        )
        for i in range(count)
    )
    parsed = parse_urdf(f'<robot name="r">{links}{joints}</robot>')
    assert len(followers(parsed.joints)) == count - 1
    assert len(from_root(parsed)) == count


def limits(lower: float, upper: float) -> str:
    return f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'


def found(kind: str, inside: str = "", *, zero: float | None = None, soft: bool = True) -> JointRange | None:
    parsed = parse_urdf(robot(joint("j", "a", "b", kind, inside))).joints["j"]
    return range_of(parsed, {} if zero is None else {"j": zero}, use_soft_limits=soft)


def test_ranges() -> None:
    soft = '<safety_controller k_velocity="1" soft_lower_limit="-0.5" soft_upper_limit="9"/>'
    assert found("continuous") == (-math.pi, math.pi, 0.0)
    assert found("continuous", limits(0, 0)) == (-math.pi, math.pi, 0.0)
    assert found("revolute", limits(-1, 2)) == (-1.0, 2.0, 0.0)
    assert found("revolute", limits(-1, 2) + soft) == (-0.5, 2.0, 0.0)
    assert found("revolute", limits(-1, 2) + soft, soft=False) == (-1.0, 2.0, 0.0)
    assert found("prismatic", limits(1, 2)) == (1.0, 2.0, 1.5), "0 is out of range"
    assert found("prismatic", limits(-2, -1)) == (-2.0, -1.0, -1.5)
    assert found("prismatic", limits(1, 2), zero=1.25) == (1.0, 2.0, 1.25)
    assert [found(kind) for kind in ("fixed", "planar", "floating")] == [None] * 3


def test_dependences_by_way_of_others() -> None:
    given = {"a": Dependence("b", 2.0, 1.0), "b": Dependence("c", 3.0, 0.5), "d": Dependence("a")}
    assert resolve(given) == {
        "a": Dependence("c", 6.0, 2.0),
        "b": Dependence("c", 3.0, 0.5),
        "d": Dependence("c", 6.0, 2.0),
    }


def test_loops_are_named() -> None:
    with pytest.raises(LoopError, match=r"Found an infinite recursive mimic chain: \['b', 'c', 'b'\]"):
        resolve({"a": Dependence("b"), "b": Dependence("c"), "c": Dependence("b")})


def test_a_long_chain_takes_time_in_proportion() -> None:
    count = 20_000
    resolved = resolve({str(i): Dependence(str(i + 1), 1.0, 1.0) for i in range(count)})
    assert resolved["0"] == Dependence(str(count), 1.0, float(count))


QUATERNION = (
    '<robot name="r" version="1.2"><link name="a"/><link name="b"/><joint name="j" type="fixed">'
    '<parent link="a"/><child link="b"/><origin xyz="1 2 3" quat_xyzw="0 0 2 2"/></joint></robot>'
)


def test_rotation_of_an_origin_may_be_a_quaternion() -> None:
    description = parse_urdf(QUATERNION)
    origin = description.joints["j"].origin
    assert origin.translation == pytest.approx([1, 2, 3])
    assert origin.rpy_rad == pytest.approx([0, 0, math.pi / 2])
    assert [str(remark) for remark in description.remarks] == [
        "line 1: the version '1.2' of the description is read by ROS 2 Lyrical and later"
    ]


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ('quat_xyzw="0 0 0 1" rpy="0 0 0"', "has both rpy and quat_xyzw"),
        ('quat_xyzw="0 0 1"', "has 3 numbers, not 4"),
        ('quat_xyzw="0 0 0 0"', "has no direction"),
        ('quat_xyzw="0 0 0 a"', "'a' is not a number"),
    ],
)
def test_wrong_quaternion_is_refused(given: str, reason: str) -> None:
    with pytest.raises(UrdfError, match=f"line 1: .*{reason}"):
        parse_urdf(QUATERNION.replace('quat_xyzw="0 0 2 2"', given))
