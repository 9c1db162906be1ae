import numpy as np
import pytest

from app.core.colours.colour_sight import of_one_hue
from app.core.colours.palette import TRACK_COLOURS
from app.core.scenes.ground_truth import ERROR_COLOURS
from tracking.scoring import ErrorKind

# Machado, Oliveira and Fernandes 2009, severity 1.0: what red- and green-blind people see.
_PROTAN = np.array([[0.152, 1.053, -0.205], [0.115, 0.786, 0.099], [-0.004, -0.048, 1.052]])
_DEUTAN = np.array([[0.367, 0.861, -0.228], [0.280, 0.673, 0.047], [-0.012, 0.043, 0.969]])
_XYZ_FROM_RGB = np.array(
    [[0.4125, 0.3576, 0.1804], [0.2127, 0.7152, 0.0722], [0.0193, 0.1192, 0.9503]]
)


def _lab(linear: np.ndarray) -> np.ndarray:
    xyz = np.clip(linear, 0, 1) @ _XYZ_FROM_RGB.T / (0.9505, 1.0, 1.0888)
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    x, y, z = f.T
    return np.column_stack((116 * y - 16, 500 * (x - y), 200 * (y - z)))


_USUAL = np.eye(3)


def _apart(sights=(_USUAL, _PROTAN, _DEUTAN), colours=TRACK_COLOURS) -> np.ndarray:
    """How far every two colours lie apart for whoever tells them apart least."""
    values = np.array(colours) / 255.0
    linear = np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
    seen = [_lab(linear @ sight.T) for sight in sights]
    return np.min([np.linalg.norm(one[:, None] - one[None], axis=2) for one in seen], axis=0)


def test_the_first_eight_colours_stay_apart_for_the_colour_blind():
    assert _apart()[:8, :8][~np.eye(8, dtype=bool)].min() > 20


@pytest.mark.parametrize(("further", "least"), [(1, 28), (2, 25), (3, 18), (4, 16), (5, 16)])
def test_ids_close_to_each_other_differ_strongly_for_the_colour_blind(further, least):
    apart = _apart()
    assert min(apart[one, (one + further) % 12] for one in range(12)) > least


def test_ids_twelve_apart_differ_in_lightness():
    apart = _apart()
    assert min(apart[one, one + 12] for one in range(12)) > 18
    assert len(set(TRACK_COLOURS)) == 24


def test_no_two_ids_in_twenty_four_look_nearly_the_same():
    others = ~np.eye(24, dtype=bool)
    assert _apart()[others].min() > 8
    assert _apart([_USUAL])[others].min() > 20


@pytest.mark.parametrize("further", range(1, 6))
def test_ids_close_to_each_other_do_not_go_by_one_colours_name(further):
    hues = of_one_hue(TRACK_COLOURS[:12])
    assert max(hues[one, (one + further) % 12] for one in range(12)) < 0.5


@pytest.mark.parametrize("kind", [ErrorKind.MISS, ErrorKind.FALSE_ALARM])
def test_what_is_drawn_around_errors_has_no_tracks_colour(kind):
    colours = (ERROR_COLOURS[kind], *TRACK_COLOURS)
    assert _apart([_USUAL], colours)[0, 1:].min() > 40
    assert _apart(colours=colours)[0, 1:].min() > 8
