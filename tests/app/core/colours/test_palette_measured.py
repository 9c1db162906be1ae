"""The least differences of people's colours by CIEDE2000, as docs/window.md states them."""

import pytest

from app.core.colours.colour_sight import SIGHTS, differences
from app.core.colours.palette import TRACK_COLOURS
from tests.benchmarks.palette import measure

LEAST = {"on pictures": (8.4, 6.5, 6.2, 6.5), "dark": (7.2, 3.5, 2.7, 5.9)}
LEAST |= {"light": (5.8, 2.1, 2.1, 4.5), "dark, to the ground": (26, 22, 25, 27)}
LEAST |= {"light, to the ground": (19.2, 14.7, 15.9, 18.7)}


@pytest.mark.parametrize("where", LEAST)
def test_no_two_of_24_people_look_more_alike_than_is_stated(where):
    figures = measure(TRACK_COLOURS)[where]
    assert list(figures) == list(SIGHTS)
    for least, figure in zip(LEAST[where], figures.values(), strict=True):
        assert figure >= least


def test_two_colours_that_are_the_same_to_red_blind_eyes_are_told():
    usual, protan, _, _ = differences([(200, 90, 60)], [(122, 111, 58)])[:, 0, 0]
    assert usual > 25
    assert protan < 0.5 * usual
