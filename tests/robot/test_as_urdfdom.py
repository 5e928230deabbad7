"""Descriptions that the real check_urdf (urdfdom 3.0.1) reads or refuses, with what is wrong with them.

Those that it reads and that are refused here are rows of docs/deviations.md.
"""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from tfloom.robot.check_urdf import FAILED, main
from tfloom.robot.mended_xml import mended
from tfloom.robot.model import RobotModel
from tfloom.robot.urdf import UrdfError, parse_urdf
from tfloom.robot.urdf_faults import Remarks

DECLARATION = '<?xml version="1.0"?>\n'
LIMIT = '<limit effort="1" velocity="1" lower="2" upper="1"/>'


def robot(joint: str = "", kind: str = "continuous", head: str = 'name="r"', more: str = "") -> str:
    """Return a description of two links and a joint between them, whose elements are in line 5; `more` is in line 6."""
    links = '<link name="a"/>\n<link name="b"/>'
    ends = '<parent link="a"/><child link="b"/>'
    return f'<robot {head}>\n{links}\n<joint name="j" type="{kind}">{ends}\n{joint}</joint>\n{more}</robot>'


REFUSED = [
    *(
        (robot(head=f'name="r" version="{version}"'), 1, "version")
        for version in ("1", "2.0", "1.1", "1.0.0", "a", "-1.0", "", "1.", "1.0 ")
    ),
    (robot("<dynamics/>"), 5, "<dynamics> of the joint 'j' has neither damping nor friction"),
    (robot('<dynamics damping="a"/>'), 5, "has damping='a'"),
    (robot('<dynamics damping="1" friction="x"/>'), 5, "has friction='x'"),
    (robot('<dynamics damping=""/>'), 5, "has damping=''"),
    (robot('<safety_controller soft_lower_limit="0"/>'), 5, "has no k_velocity"),
    (robot('<safety_controller k_velocity="a"/>'), 5, "has k_velocity='a'"),
    (robot('<safety_controller k_velocity="1" k_position="x"/>'), 5, "has k_position='x'"),
    (robot('<safety_controller k_velocity="1" soft_upper_limit="1 "/>'), 5, "has soft_upper_limit='1 '"),
    (robot('<calibration rising="x"/>'), 5, "has rising='x'"),
    (robot('<calibration falling="x"/>'), 5, "has falling='x'"),
    (robot('<limit effort=" 1" velocity="1 "/>', "fixed"), 5, "has velocity='1 '"),
    (robot('<origin xyz="0\t0\t0"/>'), 5, "has xyz='0\\t0\\t0', where spaces alone"),
    (robot("<origin rpy='0 0\n0'/>"), 5, "has rpy='0 0\\n0'"),
    (robot('<origin\n xyz="0 0 0\t"/>'), 5, "has xyz='0 0 0\\t'"),
    (robot('<axis xyz = "1\t0\t0"/>'), 5, "has xyz='1\\t0\\t0'"),
    (robot(more='<material name="m"/>\n<material name="m"/>'), 7, "the material 'm' exists already"),
]
READ = [
    robot(head='name="r" version="1.0"'),
    robot(head='name="r" version=" 1.0"'),
    robot('<origin xyz=" 0  0 0 " rpy="\n0 0 \t0"/><axis xyz="1. .5 1e3"/>'),
    robot('<origin\txyz="0 0 0"\n/>'),
    robot('<dynamics damping="1"/>'),
    robot('<dynamics friction=" +1.e2"/>'),
    robot('<safety_controller k_velocity="1"/>'),
    robot("<calibration/>"),
    robot(LIMIT, "revolute"),
    DECLARATION + robot(),
]
THIRD = '<link name="c"/>\n<joint name="k" type="fixed"><parent link="b"/><child link="c"/></joint>'
MENDED = [
    ("\n \t" + DECLARATION + robot(), 2, "the XML declaration is not at the start"),
    ("<!-- licence\n -->" + DECLARATION + robot(), 2, "the XML declaration is not at the start"),
    (robot(more="<!-- a -- b\n--->"), 6, "a comment has '--' in it"),
    (robot(more="<!-- <!-- a -->"), 6, "a comment has '--' in it"),
    (robot(head='name="a & b"'), 1, "& is written as &amp;"),
    (robot(head='name="&foo;"'), 1, "& is written as &amp;"),
    (
        robot(more='<gazebo a="x?a&b=1"/>\n<gazebo a="&"/>'),
        6,
        "& is written as &amp; in XML (1 more such places)",
    ),
    (robot(more='<gazebo a="\x01"/>'), 6, "a control character"),
    (robot().encode() + "<!-- caf\u00e9 -->".encode("latin-1"), 6, "the octet 0xe9 is not text in utf-8"),
    (
        b'<?xml version="1.0" encoding="klingon"?>' + robot().encode(),
        1,
        "the encoding 'klingon' is not known",
    ),
    (b'<?xml version="1.0" encoding="zlib"?>' + robot().encode(), 1, "the encoding 'zlib' is not known"),
    (
        b'<?xml version="1.0" encoding="gbk"?>\n' + robot(more="<!-- \u00e9 -->").encode("latin-1"),
        7,
        "the octet 0xe9 is not text in gbk",
    ),
    (robot(more='<xacro:foo a="1"/>'), 6, "<xacro:foo> is xacro that was not expanded: expand it with"),
    (robot(more='<xacro:property name="x" value="${y}"/>'), 6, "<xacro:property> is xacro"),
    (robot(more='<gazebo a="$(find x)"/>'), 6, "<gazebo> is xacro"),
    (
        robot('<mimic joint="x"/>'),
        4,
        "the joint 'j' follows none, because it mimics 'x', which does not exist",
    ),
    (robot('<mimic joint="k"/>', more=THIRD), 4, "because it mimics 'k', which is of type 'fixed'"),
]


def check(text: str | bytes, folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """Return the exit code of check_urdf, and what it printed on stderr, without the file's path."""
    path = folder / "robot.urdf"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    code = main([str(path)])
    return code, capsys.readouterr().err.replace(f"{path}:", "")


@pytest.mark.parametrize(("text", "line", "reason"), REFUSED)
def test_what_urdfdom_refuses_is_refused_with_its_line(
    text: str, line: int, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, err = check(text, tmp_path, capsys)
    assert code == FAILED
    first, last = err.splitlines()
    assert first.startswith(f"Error:   {line}: ")
    assert reason in first
    assert last == "ERROR: Model Parsing the xml failed"
    # The frames are known all the same, so the other programs only warn.
    (remark,) = parse_urdf(text).remarks
    assert str(remark).endswith("; ROS's own programs refuse the description for it")


@pytest.mark.parametrize("text", READ)
def test_what_urdfdom_reads_draws_no_word(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert check(text, tmp_path, capsys) == (0, "")


@pytest.mark.parametrize(("text", "line", "reason"), MENDED)
def test_what_is_wrong_and_read_by_urdfdom_is_read_with_a_warning(
    text: str | bytes, line: int, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, err = check(text, tmp_path, capsys)
    assert (code, err.count("\n")) == (0, 1)
    assert err.startswith(f"Warning: {line}: ")
    assert reason in err
    assert parse_urdf(text).joints["j"].child == "b"


@pytest.mark.parametrize("encoding", ["gb2312", "gbk", "big5", "shift_jis", "euc-kr"])
def test_declared_encodings_are_read(
    encoding: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    letter = "\uac00" if encoding == "euc-kr" else "\u4e2d"
    head = f'name="{letter}"'
    data = f'<?xml version="1.0" encoding="{encoding}"?>{robot(head=head)}'.encode(encoding)
    assert check(data, tmp_path, capsys) == (0, "")
    assert parse_urdf(data).name == letter


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (robot(more="<!-- -- -->\n<a>"), 7),
        (robot(head='name="a<b"'), 1),
        (robot() + "\n<!-- -- --><b/>", 7),
        (robot(more="<!-- never closed -- "), 6),
    ],
)
def test_what_can_not_be_mended_is_named_with_its_line(text: str, line: int) -> None:
    with pytest.raises(UrdfError, match="not well-formed") as error:
        parse_urdf(text)
    assert error.value.line == line


def test_a_model_warns_of_what_is_wrong() -> None:
    with pytest.warns(UserWarning, match="line 5: <dynamics> of the joint 'j' has neither"):
        RobotModel.from_urdf(robot("<dynamics/>"))
    with pytest.warns(UserWarning, match="follows none"):
        model = RobotModel.from_urdf(robot('<mimic joint="x"/>'))
    assert model.variables == ("j",)


@pytest.mark.parametrize("part", ["<!--", "<?xml ", "&", "&#1", "\x01", "--", "<!-- -- -->"])
def test_hostile_texts_are_mended_in_time_that_grows_with_them(part: str) -> None:
    started = time.process_time()
    mended(part * 400_000, Remarks())
    assert time.process_time() - started < 20.0
