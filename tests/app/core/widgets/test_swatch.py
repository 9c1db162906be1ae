from __future__ import annotations

from app.core.colours.palette import TRACK_COLOURS
from app.core.look.theme import Look, apply_look, load_theme
from app.core.widgets.parts import Swatch


def test_a_spot_follows_the_look(qapp, qtbot):
    spot = Swatch()
    qtbot.addWidget(spot)
    spot.resize(20, 20)
    spot.set_track_colour(TRACK_COLOURS[21])
    for look in (Look.LIGHT, Look.DARK):
        apply_look(qapp, look)
        middle = spot.grab().toImage().pixelColor(spot.rect().center())
        assert middle == load_theme(look.value).track(TRACK_COLOURS[21])
