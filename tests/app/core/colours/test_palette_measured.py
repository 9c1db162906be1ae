"""The least differences of people's colours by CIEDE2000, as docs/window.md states them."""

import numpy as np
import pytest

from app.core.colours.colour_sight import SIGHTS, differences, of_one_hue, seen_colours
from app.core.colours.palette import NOBODY
from app.core.colours.shown_colours import LEAST_CONTRAST, THEMES, readable_colour
from app.core.scenes.ground_truth import ERROR_COLOURS
from tests.benchmarks.palette import IN_USE, PLACE, least_contrast, measure, write
from tests.benchmarks.palette_search import search
from tracking.scoring import ErrorKind

LEAST = {"pictures and dark": (8.6, 6.3, 6.4, 6.5), "light": (7.8, 6.0, 6.0, 6.3)}
LEAST |= {
    "pictures and dark, first 8": (12.8, 14.4, 10.2, 9.7),
    "light, first 8": (16.5, 9.3, 8.9, 12.1),
}
LEAST |= {
    f"{where}, ids {step} apart": (least,) * 4
    for where in ("pictures and dark", "light")
    for step, least in ((1, 16.8), (2, 12.3), (3, 9.5), (4, 9.3), (5, 7.2))
}


@pytest.mark.parametrize("where", LEAST)
def test_no_two_of_24_people_look_more_alike_than_is_stated(where):
    figures = measure(IN_USE)[where]
    assert list(figures) == list(SIGHTS)
    for least, figure in zip(LEAST[where], figures.values(), strict=True):
        assert figure >= least


def test_every_colour_stands_out_from_every_ground():
    assert least_contrast(IN_USE) >= LEAST_CONTRAST


def test_a_persons_two_colours_go_by_one_name():
    labs = np.stack([seen_colours(one)[0] for one in IN_USE])
    chroma = np.hypot(labs[..., 1], labs[..., 2])
    assert labs[..., 0].min() >= 32  # none is near black
    assert (chroma.min(axis=0) / chroma.max(axis=0)).min() >= 0.55


@pytest.mark.parametrize(("theme", "colours"), list(zip(THEMES, IN_USE, strict=True)))
def test_errors_and_nobody_have_no_persons_colour(theme, colours):
    marks = [NOBODY, *(ERROR_COLOURS[kind] for kind in (ErrorKind.MISS, ErrorKind.FALSE_ALARM))]
    assert differences(colours, [readable_colour(theme, one) for one in marks]).min() >= 6.0


def test_two_colours_that_are_the_same_to_red_blind_eyes_are_told():
    usual, protan, _, _ = differences([(200, 90, 60)], [(122, 111, 58)])[:, 0, 0]
    assert usual > 25
    assert protan < 0.5 * usual


@pytest.mark.parametrize("colours", IN_USE, ids=THEMES)
@pytest.mark.parametrize("further", range(1, 6))
def test_ids_close_to_each_other_do_not_go_by_one_colours_name(colours, further):
    hues = of_one_hue(colours)
    places = np.arange(len(colours))
    assert hues[places, np.roll(places, -further)].max() < 0.7


def test_a_search_finds_colours_that_differ_and_stand_out():
    found = search(6, 1_500, seed=2)
    assert least_contrast(found) >= LEAST_CONTRAST
    for colours in found:
        apart = differences(colours)[:, ~np.eye(6, dtype=bool)]
        assert apart.min() > 12


def test_what_is_found_is_kept_as_it_is_read(tmp_path, monkeypatch):
    before = PLACE.read_text("utf-8")
    kept = tmp_path / "people.toml"
    kept.write_text(before, encoding="utf-8")
    monkeypatch.setattr("tests.benchmarks.palette.PLACE", kept)
    write(IN_USE)
    assert kept.read_text("utf-8") == before
