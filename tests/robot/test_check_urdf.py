"""check_urdf: what it prints of a robot, as that of urdfdom 3.0 printed it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tfloom.robot.check_urdf import main

# Children are in the order of their joints' names: upper case first.
ORDER = """
<robot name="order">
  <link name="base"/><link name="a"/><link name="b"/><link name="c"/><link name="b1"/><link name="B"/>
  <joint name="j3" type="fixed"><parent link="base"/><child link="a"/></joint>
  <joint name="j1" type="continuous"><parent link="base"/><child link="c"/></joint>
  <joint name="j2" type="fixed"><parent link="base"/><child link="b"/></joint>
  <joint name="J9" type="fixed"><parent link="base"/><child link="B"/></joint>
  <joint name="k" type="fixed"><parent link="b"/><child link="b1"/></joint>
</robot>
"""
ORDER_TREE = """\
robot name is: order
---------- Successfully Parsed XML ---------------
root Link: base has 4 child(ren)
    child(1):  B
    child(2):  c
    child(3):  b
        child(1):  b1
    child(4):  a
"""
ONE = '<robot name="one"><link name="base"/></robot>'
ONE_TREE = """\
robot name is: one
---------- Successfully Parsed XML ---------------
root Link: base has 0 child(ren)
"""


@pytest.mark.parametrize(("text", "tree"), [(ORDER, ORDER_TREE), (ONE, ONE_TREE)])
def test_tree_is_printed_as_by_urdfdom(
    text: str, tree: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(text)
    assert main([str(path)]) == 0
    assert capsys.readouterr().out == tree


def test_long_chain_of_links_is_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    count = 3000
    links = "".join(f'<link name="l{number}"/>' for number in range(count))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{n + 1}"/></joint>'
        for n in range(count - 1)
    )
    path = tmp_path / "robot.urdf"
    path.write_text(f'<robot name="chain">{links}{joints}</robot>')
    assert main([str(path)]) == 0
    assert capsys.readouterr().out.endswith(f"child(1):  l{count - 1}\n")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('<robot name="bad"><link name="a"/>\n<link name="b"/></robot>', ":2: "),
        ("<robot", ":1: "),
        (None, ": No such file or directory"),
    ],
)
def test_what_is_no_robot_fails_as_with_urdfdom(
    text: str | None, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "robot.urdf"
    if text is not None:
        path.write_text(text)
    assert main([str(path)]) == 255
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"Error:   {path}{reason}")
    assert err.endswith("\nERROR: Model Parsing the xml failed\n")


def test_without_a_file_the_usage_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 255
    assert capsys.readouterr().err == "Expect URDF xml file to parse\n"
