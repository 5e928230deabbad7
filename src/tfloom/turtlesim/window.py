"""The window that shows the turtles' picture. The only file that imports the window toolkit."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable

from tfloom.turtlesim.picture import Picture

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")

try:
    import pygame
except ImportError as _error:  # the extra `turtlesim` isn't installed
    raise ImportError("no window toolkit: pip install 'tfloom[turtlesim]' brings it") from _error

TITLE = "TurtleSim"
SIDE = 500
"""Width and height at first, in the desktop's units."""


class NoDisplayError(Exception):
    """There is no display for a window; the text has the reason."""


class Window:
    """Shows square pictures in the size of the window and the resolution of its screen. For the main thread.

    Raises:
        NoDisplayError: there is no display.
    """

    def __init__(self) -> None:
        if not has_display():
            raise NoDisplayError("there is no display")
        try:
            pygame.display.init()
            self._window = pygame.Window(TITLE, (SIDE, SIDE), resizable=True, allow_high_dpi=True)
            self._window.minimum_size = (100, 100)
        except pygame.error as error:
            raise NoDisplayError(str(error)) from None
        self._scene: object = None

    def show(self, draw: Callable[[int], Picture], scene: object) -> bool:
        """Show the picture that `draw(size_px)` returns; return False after the window was closed.

        Args:
            draw: Called where the scene is another one than before, or something has happened to the window.
            scene: What the picture shows: of equal scenes, it is the same.
        """
        events = pygame.event.get()
        if any(event.type in {pygame.QUIT, pygame.WINDOWCLOSE} for event in events):
            return False
        # Pictures at the screen's rate take a good part of a core, and most of the time all turtles rest. An event may
        # tell that the window was uncovered or has another size.
        if scene == self._scene and not events:
            return True
        self._scene = scene
        surface = self._window.get_surface()
        size = max(1, min(surface.get_size()))
        picture = draw(size)
        image = pygame.image.frombuffer(picture.tobytes(), picture.size, "RGB")
        surface.fill((0, 0, 0))
        surface.blit(image, ((surface.get_width() - size) // 2, (surface.get_height() - size) // 2))
        self._window.flip()
        return True

    def close(self) -> None:
        """Close the window, and leave the display."""
        self._window.destroy()
        pygame.display.quit()


def has_display() -> bool:
    """Return whether there is a display: on Linux, X or Wayland or a driver that the user selected."""
    if sys.platform in {"win32", "darwin"}:
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"))
