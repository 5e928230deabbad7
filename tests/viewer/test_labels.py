"""Which names of frames a page shows."""

from __future__ import annotations

import numpy as np
import pytest

from tfloom.viewer.camera import Camera, direction_of, projected
from tfloom.viewer.labels import (
    EM_PX,
    HEIGHT_EM,
    MARGIN_EM,
    MAX_SHOWN,
    SIZES,
    Chosen,
    chosen_labels,
    width_em,
)

SCREEN_PX = (800.0, 400.0)
TOP_DOWN = Camera((0.0, 0.0, 10.0), (1.0, 0.0, 0.0, 0.0), 1.0, 2.0)


def seen(*places: tuple[float, float, float]) -> np.ndarray:
    return np.array(places, np.float64)


def overlaps(places: np.ndarray, widths_em: np.ndarray, chosen: list[Chosen]) -> int:
    """Return how many pairs of labels overlap."""
    numbers = [label.number for label in chosen]
    sizes = np.array([label.size for label in chosen])
    left, bottom = places[numbers, 0] * SCREEN_PX[0], places[numbers, 1] * SCREEN_PX[1]
    right = left + (widths_em[numbers] + MARGIN_EM) * EM_PX * sizes
    top = bottom - HEIGHT_EM * EM_PX * sizes
    apart = (
        (right[:, None] <= left)
        | (left[:, None] >= right)
        | (bottom[:, None] <= top)
        | (top[:, None] >= bottom)
    )
    return int((~apart).sum() - len(numbers)) // 2


def test_of_two_that_overlap_the_nearer_is_shown_unless_the_other_comes_first() -> None:
    places, widths = seen((0.5, 0.5, 3.0), (0.51, 0.5, 2.0), (0.1, 0.1, 9.0)), np.full(3, 5.0)
    assert {label.number for label in chosen_labels(places, widths, SCREEN_PX, 3.0)} == {1, 2}
    assert {label.number for label in chosen_labels(places, widths, SCREEN_PX, 3.0, first=[0])} == {0, 2}
    both = chosen_labels(places, widths, SCREEN_PX, 3.0, first=[0, 1])
    assert {label.number for label in both} == {0, 1, 2}


def test_shown_label_stays_beside_one_that_is_hardly_nearer() -> None:
    places, widths = seen((0.5, 0.5, 3.0), (0.51, 0.5, 2.9)), np.full(2, 5.0)
    assert chosen_labels(places, widths, SCREEN_PX, 3.0)[0].number == 1
    assert chosen_labels(places, widths, SCREEN_PX, 3.0, before={0})[0].number == 0
    places[1, 2] = 1.0
    assert chosen_labels(places, widths, SCREEN_PX, 3.0, before={0})[0].number == 1


def test_what_is_not_seen_has_no_label() -> None:
    behind = projected(
        TOP_DOWN, np.array([(0.0, 0.0, 20.0), (0.0, 0.0, 10.0), (0.0, 0.0, 0.0), (90.0, 0.0, 0.0)])
    )
    assert np.isnan(behind[:2, :2]).all()
    chosen = chosen_labels(behind, np.full(4, 5.0), SCREEN_PX, 10.0, first=[0, 1, 3])
    assert [label.number for label in chosen] == [2]
    assert chosen_labels(np.empty((0, 3)), np.empty(0), SCREEN_PX, 10.0) == []


def test_sizes_follow_the_distance() -> None:
    places = seen(
        *((0.1, 0.15 * number, depth) for number, depth in enumerate((1.0, 4.0, 10.0, 20.0, 90.0), 1))
    )
    sizes = {label.number: label.size for label in chosen_labels(places, np.full(5, 1.0), SCREEN_PX, 10.0)}
    assert [sizes[number] for number in range(5)] == SIZES.tolist()


def test_two_thousand_names_never_overlap_and_as_many_as_fit_are_shown() -> None:
    rng = np.random.default_rng(7)
    for spread_m in (1.0, 3.0, 30.0):
        places = projected(TOP_DOWN, rng.uniform(-spread_m, spread_m, (2000, 3)))
        widths = rng.uniform(2.0, 30.0, 2000)
        chosen = chosen_labels(places, widths, SCREEN_PX, 10.0)
        shown = {label.number for label in chosen}
        assert 3 <= len(shown) <= MAX_SHOWN
        assert overlaps(places, widths, chosen) == 0
        is_seen = ((places[:, :2] >= 0.0) & (places[:, :2] <= 1.0)).all(axis=1)
        assert is_seen[sorted(shown)].all()
        for number in set(np.flatnonzero(is_seen).tolist()) - shown if len(shown) < MAX_SHOWN else ():
            alone = chosen_labels(places[[number]], widths[[number]], SCREEN_PX, 10.0)[0]
            assert overlaps(places, widths, [*chosen, Chosen(number, alone.size)]), number


def test_width_of_a_text() -> None:
    assert width_em("漢字") > width_em("ab") > width_em("a") > 0.0
    assert width_em("") == 0.0


def test_place_on_the_screen_and_back() -> None:
    rng = np.random.default_rng(3)
    camera = Camera((1.0, 2.0, 3.0), (0.18257419, 0.36514837, 0.54772256, 0.73029674), 0.9, 1.7)
    for across, down in rng.uniform(0.0, 1.0, (20, 2)).tolist():
        point = np.array(camera.position) + 4.0 * np.array(direction_of(camera, across, down))
        assert projected(camera, point[np.newaxis])[0] == pytest.approx([across, down, 4.0])
