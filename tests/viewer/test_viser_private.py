"""The names that viser doesn't publish: a version that lacks one is found at import."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import msgspec
import pytest
import viser
from viser import _messages
from viser.infra import WebsockServer

from tfloom.viewer import viser_private
from tfloom.viewer.viser_private import missing_names, said_by_scene


class Other:
    """A class whose constructor sets nothing."""

    def __init__(self) -> None:
        pass


def test_installed_version_lacks_nothing() -> None:
    assert missing_names(_messages, viser.ViserServer, WebsockServer) == []


@pytest.mark.parametrize("name", ["ScenePointerMessage", "ShareUrlRequest", "Message"])
def test_message_that_a_version_lacks_is_named(name: str) -> None:
    messages = SimpleNamespace(**{key: value for key, value in vars(_messages).items() if key != name})
    assert missing_names(messages, viser.ViserServer, WebsockServer) == [name]


def test_fields_and_attributes_that_a_version_lacks_are_named() -> None:
    camera = dataclasses.make_dataclass(
        "Camera", ["wxyz", "position", "fov", "look_at", "height", "image_width"]
    )
    messages = SimpleNamespace(**{**vars(_messages), "ViewerCameraMessage": camera})
    names = ["ViewerCameraMessage.image_height", "Other._websock_server", "Other._live_connections"]
    assert missing_names(messages, Other, Other) == names


def test_version_without_its_module_of_messages_lacks_all() -> None:
    names = missing_names(None, viser.ViserServer, WebsockServer)
    assert {*viser_private.SCENE_MESSAGES, "Message", "ShareUrlDisconnect"} <= set(names)


CAMERA: dict[str, Any] = {
    "type": "ViewerCameraMessage",
    "wxyz": (1.0, 0.0, 0.0, 0.0),
    "position": (3.0, 0.0, 0.0),
    "look_at": (0.0, 0.0, 0.0),
    "up_direction": (0.0, 0.0, 1.0),
    "fov": 1.0,
    "near": 0.1,
    "far": 100.0,
    "image_height": 300,
    "image_width": 400,
}


GIZMO = {
    "type": "TransformControlsUpdateMessage",
    "name": "/handles/0",
    "wxyz": (1.0, 0.0, 0.0, 0.0),
    "position": (3.0, 0.0, 0.0),
}


@pytest.mark.parametrize(
    ("message", "expected"),
    [
        (CAMERA, True),
        (CAMERA | {"image_height": 0}, False),
        (CAMERA | {"position": (float("nan"), 0.0, 0.0)}, False),
        (CAMERA | {"type": "ShareUrlRequest"}, False),
        (GIZMO, True),
        (GIZMO | {"position": (float("nan"), 0.0, 0.0)}, False),
        (GIZMO | {"wxyz": (1.0, 0.0, 0.0)}, False),
        (GIZMO | {"wxyz": (1e300, 0.0, 0.0, 0.0)}, False),
        ({"type": "ShareUrlRequest"}, False),
        ({"type": ["a"]}, False),
        ({}, False),
        (["ViewerCameraMessage"], False),
        (7, False),
    ],
)
def test_message_is_passed_on_if_a_scene_may_send_it_and_viser_can_read_it(
    message: Any, expected: bool
) -> None:
    data = msgspec.msgpack.encode(message)
    assert said_by_scene(data) == (data if expected else None)


def test_bytes_that_are_no_message_are_not_passed_on() -> None:
    assert said_by_scene(b"") is None
    assert said_by_scene(b"\x91" * 100_000) is None


@pytest.mark.parametrize(
    ("count", "expected"), [(0, 0), (7, 7), (-3, -3), (True, None), (1.5, None), ("1", None)]
)
def test_number_of_messages_that_are_drawn_is_a_whole_one_and_nothing_for_viser(
    count: Any, expected: int | None
) -> None:
    said = said_by_scene(msgspec.msgpack.encode({"type": viser_private.DRAWN_MESSAGE, "count": count}))
    assert said == expected
    assert type(said) is type(expected)
    assert said_by_scene(msgspec.msgpack.encode({"type": viser_private.DRAWN_MESSAGE})) is None


def test_message_is_decoded_once_beside_viser(monkeypatch: pytest.MonkeyPatch) -> None:
    decoded: list[bytes] = []
    decode = msgspec.msgpack.decode

    def counted(data: bytes) -> Any:
        decoded.append(data)
        return decode(data)

    monkeypatch.setattr(viser_private, "msgspec", SimpleNamespace(msgpack=SimpleNamespace(decode=counted)))
    assert said_by_scene(msgspec.msgpack.encode(CAMERA)) is not None
    assert len(decoded) == 1


def test_points_have_pixels_only_where_the_client_can_be_changed(tmp_path: Path) -> None:
    assert viser_private.HAS_PIXEL_POINTS
    script = (Path(viser_private.__file__).parent / "page" / "scene.js").read_text(encoding="utf-8")
    assert f'"{viser_private.POINT_SIZE}"' in script
    assert not viser_private.has_pixel_points(tmp_path)
    source = tmp_path / "src" / "ThreeAssets.tsx"
    source.parent.mkdir()
    for content, is_known in ((viser_private.POINT_SIZE, True), ("gl_PointSize = 3.0;", False)):
        source.write_text(content, encoding="utf-8")
        assert viser_private.has_pixel_points(tmp_path) == is_known
    source.write_bytes(b"\xff" + viser_private.POINT_SIZE.encode())
    assert not viser_private.has_pixel_points(tmp_path)
