"""The window, on SDL's driver without a screen."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from PIL import Image

pygame = pytest.importorskip("pygame", reason="the extra `turtlesim` isn't installed")
from tfloom.turtlesim.window import NoDisplayError, Window  # noqa: E402  # only where pygame is


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> Iterator[Window]:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    window = Window()
    yield window
    window.close()


def checked(size_px: int) -> Image.Image:
    picture = Image.new("RGB", (size_px, size_px), (10, 200, 30))
    picture.putpixel((0, 0), (255, 0, 0))
    return picture


def surface_of(window: Window) -> Any:
    return window._window.get_surface()


def test_window_opens_with_the_original_size_and_title(window: Window) -> None:
    assert window._window.title == "TurtleSim"
    assert window._window.size == (500, 500)
    assert window._window.resizable


def test_window_shows_the_picture(window: Window) -> None:
    sizes = []

    def draw(size_px: int) -> Image.Image:
        sizes.append(size_px)
        return checked(size_px)

    assert window.show(draw, 1)
    assert sizes == [500]
    assert surface_of(window).get_at((0, 0))[:3] == (255, 0, 0)
    assert surface_of(window).get_at((250, 250))[:3] == (10, 200, 30)


def test_picture_is_drawn_anew_only_where_the_scene_or_the_window_has_changed(window: Window) -> None:
    sizes: list[int] = []

    def draw(size_px: int) -> Image.Image:
        sizes.append(size_px)
        return checked(size_px)

    def shown(scene: object) -> list[int]:
        sizes.clear()
        assert window.show(draw, scene)
        return sizes

    pygame.event.clear()  # those of the new window
    assert [shown([1]) == [500], shown([1]), shown([2]) == [500], shown([2])] == [True, [], True, []]
    window._window.size = (900, 700)
    assert shown([2]) == [700]
    pygame.event.post(pygame.event.Event(pygame.WINDOWEXPOSED))
    assert shown([2]) == [700]
    assert shown([2]) == []


def test_larger_window_has_a_larger_centred_picture(window: Window) -> None:
    window._window.size = (900, 700)
    assert window.show(checked, 1)
    assert surface_of(window).get_at((100, 0))[:3] == (255, 0, 0)
    assert surface_of(window).get_at((99, 350))[:3] == (0, 0, 0)
    assert surface_of(window).get_at((799, 350))[:3] == (10, 200, 30)


def test_closed_window_ends_the_updates(window: Window) -> None:
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    assert not window.show(checked, 1)


def test_missing_display_raises(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("sys.platform", "linux")
    with pytest.raises(NoDisplayError, match="there is no display"):
        Window()
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonsense")
    with pytest.raises(NoDisplayError):
        Window()
