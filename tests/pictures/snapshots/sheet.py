"""Contact sheets: all pictures of a group beside each other, and a page that lists them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape
from pathlib import Path

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import QColor, QFont, QImage, QPainter

_WIDE_PX, _HIGH_PX = 1920, 1400
_GAP_PX, _TITLE_PX = 10, 20
_PAPER, _INK = QColor(128, 128, 128), QColor(255, 255, 255)
_CELL = QSize(950, 660)
"""The most that one picture takes: two windows beside each other can be read."""


def write_sheets(folder: Path, groups: Iterable[str]) -> list[Path]:
    """Sheets of the pictures in a folder, "GROUP-N.png" in its `sheets`."""
    sheets = folder / "sheets"
    sheets.mkdir(exist_ok=True)
    made = []
    for group in groups:
        pictures = sorted(folder.glob(f"{group}-*.png"))
        for number, page in enumerate(_pages(pictures)):
            path = sheets / f"{group}-{number + 1}.png"
            _drawn(page).save(str(path))
            made.append(path)
    return made


Placed = tuple[Path, QImage, QPoint]


def _pages(pictures: Sequence[Path]) -> Iterator[list[Placed]]:
    """Pictures in rows, as many as a sheet has room for."""
    page: list[Placed] = []
    at, high = QPoint(_GAP_PX, _GAP_PX), 0
    for path in pictures:
        image = _small(QImage(str(path)))
        if at.x() + image.width() + _GAP_PX > _WIDE_PX:
            at, high = QPoint(_GAP_PX, at.y() + high + _TITLE_PX + _GAP_PX), 0
        if page and at.y() + image.height() + _TITLE_PX > _HIGH_PX:
            yield page
            page, at, high = [], QPoint(_GAP_PX, _GAP_PX), 0
        page.append((path, image, QPoint(at)))
        at.setX(at.x() + image.width() + _GAP_PX)
        high = max(high, image.height())
    if page:
        yield page


def _small(image: QImage) -> QImage:
    image.setDevicePixelRatio(1.0)
    if image.width() <= _CELL.width() and image.height() <= _CELL.height():
        return image
    return image.scaled(
        _CELL, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    )


def _drawn(page: Sequence[Placed]) -> QImage:
    bottom = max(at.y() + image.height() for _, image, at in page) + _TITLE_PX + _GAP_PX
    sheet = QImage(_WIDE_PX, bottom, QImage.Format.Format_RGB32)
    sheet.fill(_PAPER)
    painter = QPainter(sheet)
    painter.setPen(_INK)
    font = QFont()
    font.setPixelSize(_TITLE_PX - 7)
    painter.setFont(font)
    for path, image, at in page:
        painter.drawText(QRect(at, QSize(_CELL.width(), _TITLE_PX)), 0, path.stem)
        painter.drawImage(at + QPoint(0, _TITLE_PX), image)
    painter.end()
    return sheet


def write_index(folder: Path, sheets: Mapping[str, Sequence[Path]], told: Sequence[str]) -> Path:
    """A page with all sheets, by language and scaling, and what the check of texts found."""
    parts = ["<!doctype html><meta charset=utf-8><title>Snapshots</title>"]
    parts += [f"<pre>{escape(chr(10).join(told))}</pre>"] if told else []
    by_name: dict[str, list[tuple[str, Path]]] = defaultdict(list)
    for name, paths in sheets.items():
        for path in paths:
            by_name[path.stem].append((name, path))
    for stem, rows in sorted(by_name.items()):
        parts.append(f"<h2>{escape(stem)}</h2>")
        for name, path in rows:
            where = path.relative_to(folder).as_posix()
            parts.append(f'<p>{escape(name)}<br><img src="{where}" style="max-width:100%"></p>')
    index = folder / "index.html"
    index.write_text("\n".join(parts))
    return index
