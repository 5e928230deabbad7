"""What is seen of a robot."""

from __future__ import annotations

import pytest

from tfloom.robot.urdf_faults import UrdfError
from tfloom.robot.visuals import GREY, BallForm, BoxForm, CylinderForm, MeshForm, read_visuals


def robot(link: str, before: str = "") -> str:
    return f'<robot name="r">{before}<link name="base">{link}</link></robot>'


def test_forms_origins_and_colours() -> None:
    text = robot(
        '<visual><origin xyz="1 2 3" rpy="0 0 0"/><geometry><cylinder radius="0.5" length="2"/></geometry>'
        '<material name="blue"/></visual>'
        '<visual><geometry><mesh filename="package://p/m.stl" scale="1 1 2"/></geometry></visual>',
        '<material name="blue"><color rgba="0 0 1 1"/></material>',
    )
    cylinder, mesh = read_visuals(text)
    assert (cylinder.link, cylinder.form, cylinder.color) == ("base", CylinderForm(0.5, 2.0), (0, 0, 255))
    assert cylinder.origin.translation == (1.0, 2.0, 3.0)
    assert (mesh.form, mesh.has_color) == (MeshForm("package://p/m.stl", (1.0, 1.0, 2.0)), False)


def test_material_of_one_link_is_used_by_another() -> None:
    box = "<geometry><box size='1 1 1'/></geometry>"
    yellow = '<material name="m"><color rgba="1 1 0 1"/></material>'
    text = f"""<robot name="r"><link name="a"><visual>{box}{yellow}</visual></link>
    <link name="b"><visual>{box}<material name="m"/></visual></link></robot>"""
    assert [visual.color for visual in read_visuals(text)] == [(255, 255, 0)] * 2
    assert read_visuals(text)[0].form == BoxForm((1.0, 1.0, 1.0))


def test_texture_of_a_material_comes_with_its_colour_and_its_name() -> None:
    box = "<geometry><box size='1 1 1'/></geometry>"
    wood = '<material name="wood"><texture filename="package://p/wood.png"/></material>'
    both = '<material name="both"><color rgba="1 0 0 1"/><texture filename="red.png"/></material>'
    links = [
        '<material name="wood"/>',
        both,
        '<material name="both"/>',
        '<material name="red"><color rgba="1 0 0 1"/><texture filename=""/></material>',  # as of an exporter
        '<material name="wood"><texture/></material>',
        '<material name="red"/>',
        "",
    ]
    text = "".join(
        f'<link name="{number}"><visual>{box}{material}</visual></link>'
        for number, material in enumerate(links)
    )
    visuals = read_visuals(f'<robot name="r">{wood}{text}</robot>')
    assert [(visual.texture, visual.has_color, visual.color) for visual in visuals] == [
        ("package://p/wood.png", False, GREY),
        ("red.png", True, (255, 0, 0)),
        ("red.png", True, (255, 0, 0)),
        ("", True, (255, 0, 0)),
        ("package://p/wood.png", False, GREY),
        ("", True, (255, 0, 0)),
        ("", False, GREY),
    ]


@pytest.mark.parametrize(
    ("link", "reason"),
    [
        ("<visual/>", "has no geometry"),
        ("<visual><geometry/></visual>", "has no geometry"),
        ("<visual><geometry><torus/></geometry></visual>", "the geometry <torus>, which is not known"),
        ("<visual><geometry><box size='1 1'/></geometry></visual>", "has 2 numbers, not 3"),
        ("<visual><geometry><box size='1 1 -1'/></geometry></visual>", "negative size"),
        ("<visual><geometry><sphere radius='nan'/></geometry></visual>", "'nan' is not a number"),
        ("<visual><geometry><mesh/></geometry></visual>", "has no filename"),
        (
            "<visual><geometry><sphere radius='1'/></geometry><material><color rgba='1 0'/></material></visual>",
            "has 2 numbers, not 4",
        ),
    ],
)
def test_wrong_visual_is_refused_with_its_line(link: str, reason: str) -> None:
    with pytest.raises(UrdfError, match=reason):
        read_visuals(robot(link))


def test_capsule_is_a_cylinder_with_two_balls() -> None:
    text = (
        '<robot name="r" version="1.2"><link name="arm"><visual><origin xyz="0 0 1" quat_xyzw="0 0.7071 0 0.7071"/>'
        '<geometry><capsule radius="0.1" length="0.6"/></geometry></visual></link></robot>'
    )
    body, low, high = read_visuals(text)
    assert body.form == CylinderForm(0.1, 0.6)
    assert low.form == high.form == BallForm(0.1)
    # A quarter turn about y leads z to x.
    assert low.origin.translation == pytest.approx([-0.3, 0.0, 1.0])
    assert high.origin.translation == pytest.approx([0.3, 0.0, 1.0])
    with pytest.raises(UrdfError, match=r"line 1: .*has no length"):
        read_visuals(text.replace('length="0.6"', ""))
