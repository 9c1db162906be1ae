"""The legend of the floor stands where nobody is."""

from PySide6.QtCore import QPointF, QRectF, QSizeF

from app.features.pictures.floor_legend import FloorLegend

AREA = QRectF(0, 0, 400, 300)
FOOT = QPointF(20, 280)
SIZE = QSizeF(100, 60)


def _at(legend, *people):
    return legend.place(SIZE, FOOT, AREA, [QRectF(x - 8, y - 8, 16, 16) for x, y in people])


def test_it_stands_in_its_corner_where_nobody_is_there():
    assert _at(FloorLegend(), (200, 150)) == QRectF(20, 220, 100, 60)


def test_it_goes_to_a_free_corner_and_stays_there_while_that_is_free():
    legend = FloorLegend()
    moved = _at(legend, (50, 250))
    assert moved.left() > 200
    assert _at(legend) == moved
    assert _at(legend, (350, 250)) == QRectF(20, 220, 100, 60)


def test_it_goes_where_somebody_is_in_every_corner():
    legend = FloorLegend()
    everywhere = [(x, y) for x in range(0, 400, 20) for y in range(0, 300, 20)]
    assert _at(legend, *everywhere).isEmpty()
    assert not _at(legend).isEmpty()
