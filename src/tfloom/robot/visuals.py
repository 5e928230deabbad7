"""What is seen of a robot: the forms, meshes and colours of its links, as its URDF describes them."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple

from tfloom._native import Transform
from tfloom.robot.urdf_faults import UrdfError
from tfloom.robot.urdf_values import number, origin_of, required, vector
from tfloom.robot.xml_elements import Element, read_xml

__all__ = [
    "BallForm",
    "BoxForm",
    "CylinderForm",
    "Form",
    "MeshForm",
    "Visual",
    "read_collisions",
    "read_visuals",
]

GREY = (180, 180, 180)
"""Colour of what has none."""


@dataclass(frozen=True)
class BoxForm:
    """A box around its origin."""

    size: tuple[float, float, float]
    """[m]."""


@dataclass(frozen=True)
class CylinderForm:
    """A cylinder around its origin, along z."""

    radius: float
    """[m]."""
    length: float
    """[m]."""


@dataclass(frozen=True)
class BallForm:
    """A ball around its origin."""

    radius: float
    """[m]."""


@dataclass(frozen=True)
class MeshForm:
    """A file with a mesh."""

    uri: str
    """As `package://my_robot/meshes/base.stl`."""
    scale: tuple[float, float, float]


Form = BoxForm | CylinderForm | BallForm | MeshForm
"""Any of them."""


@dataclass(frozen=True)
class Visual:
    """One form of a link."""

    link: str
    origin: Transform
    """link_from_form."""
    form: Form
    color: tuple[int, int, int] = GREY
    """Red, green and blue, each from 0 to 255."""
    opacity: float = 1.0
    has_color: bool = False
    """Whether the description has the colour; one of a mesh's own counts otherwise."""
    texture: str = ""
    """The picture of its material, as `package://my_robot/meshes/wood.png`, which counts in place of the colour; empty:
    none."""


class _Material(NamedTuple):
    """What a material defines."""

    rgba: tuple[float, ...] | None
    """Each from 0 to 1; None: no colour."""
    texture: str
    """As of `Visual`."""


def read_visuals(text: str | bytes) -> list[Visual]:
    """Return what is seen of a robot, in the order of its URDF. Its joints are not looked at.

    Args:
        text: A str, or the bytes of a file, whose encoding its first line names.

    Raises:
        UrdfError: the text is not a valid description; its message has the line.
    """
    robot = read_xml(text)
    if robot.tag != "robot":
        raise UrdfError(robot.line, f"the outermost element is <{robot.tag}>, not <robot>")
    materials = {
        element.attributes.get("name", ""): material
        for element in robot.all_of("material")
        if (material := _material(element)) is not None
    }
    visuals = []
    for link in robot.all_of("link"):
        name = required(link, "name", "a link")
        for visual in link.all_of("visual"):
            visuals += _visuals(visual, name, materials)
            element = visual.first("material")
            # A material that one link defines may be used by those after it, by its name.
            if element is not None and (material := _material(element)) is not None:
                materials.setdefault(element.attributes.get("name", ""), material)
    return visuals


def read_collisions(text: str | bytes) -> list[Visual]:
    """Return the forms with which the links of a robot collide, in the order of its URDF, without colours.

    They stand in for what can't be seen, so one that is not valid is left out.

    Raises:
        UrdfError: the text is not XML; its message has the line.
    """
    collisions = []
    for link in read_xml(text).all_of("link"):
        name = link.attributes.get("name", "")
        for collision in link.all_of("collision"):
            what = f"a collision of the link '{name}'"
            with suppress(UrdfError):
                collisions += [Visual(name, *placed) for placed in _placed_forms(collision, what)]
    return collisions


def _placed_forms(element: Element, what: str) -> list[tuple[Transform, Form]]:
    """Return the forms of a visual or a collision, each with link_from_form: one, and three of a capsule."""
    geometry = element.first("geometry")
    child = next(iter(geometry.children), None) if geometry else None
    if child is None:
        raise UrdfError(element.line, f"{what} has no geometry")
    origin = origin_of(element, what)
    if child.tag != "capsule":
        return [(origin, _form(child, what))]
    # Its length is that of the cylinder, without the two ends.
    body = _cylinder(child, what)
    ends = [origin @ Transform((0.0, 0.0, side * body.length / 2)) for side in (-1.0, 1.0)]
    return [(origin, body), *((end, BallForm(body.radius)) for end in ends)]


def _visuals(element: Element, link: str, materials: dict[str, _Material]) -> list[Visual]:
    what = f"a visual of the link '{link}'"
    forms = _placed_forms(element, what)
    used = element.first("material")
    material = None
    if used is not None:
        material = _material(used) or materials.get(used.attributes.get("name", ""))
    if material is None:
        return [Visual(link, origin, form) for origin, form in forms]
    visuals = [Visual(link, origin, form, texture=material.texture) for origin, form in forms]
    if material.rgba is None:
        return visuals
    red, green, blue, opacity = (min(max(part, 0.0), 1.0) for part in material.rgba)
    color = round(255 * red), round(255 * green), round(255 * blue)
    return [replace(visual, color=color, opacity=opacity, has_color=True) for visual in visuals]


def _material(element: Element) -> _Material | None:
    """Return what a material defines; None for one that only names another, also by a texture without a name."""
    texture = element.first("texture")
    material = _Material(_rgba(element), texture.attributes.get("filename", "") if texture else "")
    return None if material == (None, "") else material


def _rgba(material: Element) -> tuple[float, ...] | None:
    color = material.first("color")
    if color is None:
        return None
    what = f"the material '{material.attributes.get('name', '')}'"
    words = required(color, "rgba", f"<color> of {what}").split()
    if len(words) != 4:
        raise UrdfError(color.line, f"rgba of {what} has {len(words)} numbers, not 4")
    return tuple(number(Element("color", {"rgba": word}, color.line), "rgba", None, what) for word in words)


def _form(element: Element, what: str) -> Form:
    if element.tag == "box":
        return BoxForm(_sizes(element, vector(element, "size", "", what), what))
    if element.tag == "cylinder":
        return _cylinder(element, what)
    if element.tag == "sphere":
        radius = number(element, "radius", None, what)
        _sizes(element, (radius, 0.0, 0.0), what)
        return BallForm(radius)
    if element.tag == "mesh":
        return MeshForm(required(element, "filename", what), vector(element, "scale", "1 1 1", what))
    raise UrdfError(element.line, f"{what} has the geometry <{element.tag}>, which is not known")


def _cylinder(element: Element, what: str) -> CylinderForm:
    radius, length = number(element, "radius", None, what), number(element, "length", None, what)
    _sizes(element, (radius, length, 0.0), what)
    return CylinderForm(radius, length)


def _sizes(element: Element, sizes: tuple[float, float, float], what: str) -> tuple[float, float, float]:
    if min(sizes) < 0.0:
        raise UrdfError(element.line, f"{what} has a negative size")
    return sizes
