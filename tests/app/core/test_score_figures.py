"""How figures of a score are written, and how they move."""

from types import SimpleNamespace

import pytest

from app.core.scenes.score_figures import Figure

SHARE = Figure("share", "", lambda score: score.value)
COUNT = Figure("count", "", lambda score: score.value, "{:.0f}", -1)


@pytest.mark.parametrize(
    ("figure", "before", "after", "moved"),
    [
        (SHARE, 0.5, 0.512, ("\u25b2 +0.012", 1)),
        (SHARE, 0.5, 0.488, ("\u25bc \u22120.012", -1)),
        (SHARE, 0.5, 0.5003, ("", 0)),
        (SHARE, float("nan"), 0.5, ("", 0)),
        (COUNT, 7, 9, ("\u25b2 +2", -1)),
        (COUNT, 9, 7, ("\u25bc \u22122", 1)),
    ],
)
def test_a_move_has_sign_arrow_and_whether_it_is_better(figure, before, after, moved):
    assert figure.moved(*(SimpleNamespace(value=one) for one in (before, after))) == moved


def test_what_is_not_defined_is_a_dash():
    assert SHARE.text(SimpleNamespace(value=float("nan"))) == "\u2013"
