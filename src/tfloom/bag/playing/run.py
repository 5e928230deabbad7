"""Playing a bag from its start until its end, or until it is stopped."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from pathlib import Path

from tfloom.bag.key_presses import handled_keys
from tfloom.bag.node_running import spin_until
from tfloom.bag.opening import open_bags
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.player import Player
from tfloom.common.terminal import report

__all__ = ["play"]


def play(
    paths: Sequence[Path],
    options: PlayOptions,
    *,
    burst: int | None = None,
    stop: threading.Event | None = None,
) -> None:
    """Play one bag, or several at a time, until the end, a shutdown of the context, by Ctrl-C too, or `stop`.

    The default context is initialised.

    Args:
        paths: The bags.
        options: What is played.
        burst: Number of messages to publish at once before, in the paused state; 0: all. None: none.
        stop: Ends playing.

    Raises:
        BagError: a bag can't be read.
    """
    with open_bags(paths) as bag:
        if bag.message_count == 0:
            report(f"{', '.join(map(str, paths))}: there are no messages in it")
            return
        # Filled when the player is there; until then keys do nothing.
        keys: dict[str, Callable[[], object]] = {}
        with handled_keys(keys, enabled=options.has_keyboard):
            player = Player(bag, options)
            keys.update(player.keys)
            try:
                player.start()
                if burst is not None:
                    player.playback.burst(burst)
                spin_until(player, player.ended.is_set, stop)
            finally:
                player.stop()
                player.destroy_node()
    if player.failure is not None:
        raise player.failure
