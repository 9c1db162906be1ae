"""Every panel, alone, as large as the window gives it room."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from app.core.widgets.parts import Panel
from app.features.correction.attribute_controller import AttributeController
from app.features.correction.track_panel import TrackPanel
from app.features.counting.controller import CountController
from app.features.counting.panel import CountingPanel
from app.features.history.panel import HistoryPanel
from app.features.labelling.panel import LabellingPanel
from app.features.parts.panel import CurvesPanel
from app.features.playback.transport import TransportBar
from app.features.review.panel import ReviewPanel
from app.features.scoring.controller import ScoreController
from app.features.scoring.panel import ScorePanel
from app.features.timeline.panel import TimelineView
from app.shell.panel_docks import Dock, PanelWindow
from tests.pictures.snapshots.material import SCHEMA
from tests.pictures.snapshots.snapshot import On, snapshot
from tests.pictures.snapshots.stage import Stage
from tracking.editing import SchemaChange

PANELS = "panels"


@snapshot(PANELS, On.SESSION, ReviewPanel)
def review_queue(stage: Stage) -> Iterator[QWidget]:
    yield stage.window.workspace.review


@snapshot(PANELS, On.SESSION, ReviewPanel)
def review_item(stage: Stage) -> Iterator[QWidget]:
    """The queue at an item, with why and the strip of pictures."""
    stage.run("review.next")
    stage.rest(600)
    yield stage.window.workspace.review


@snapshot(PANELS, On.SESSION, TrackPanel)
def track(stage: Stage) -> Iterator[QWidget]:
    """The card of somebody with a name, attributes and notes."""
    _pick_described(stage)
    yield stage.window.workspace.card


def _pick_described(stage: Stage) -> None:
    session = stage.controller.document.session
    assert session is not None
    stage.controller.editing.pick(next(iter(session.labels.tracks)))


@snapshot(PANELS, On.SESSION, TrackPanel)
def track_with_fields(stage: Stage) -> Iterator[QWidget]:
    """Attributes of a schema, one of them set by the digit keys."""
    _pick_described(stage)
    describing = stage.controller.of(AttributeController)
    describing.change(SchemaChange(SCHEMA))
    describing.next_active()
    stage.rest(100)
    yield stage.window.workspace.card
    stage.controller.document.correcting.mode.attribute = ""
    stage.controller.editing.undo()


@snapshot(PANELS, On.SESSION, TrackPanel)
def track_of_several(stage: Stage) -> Iterator[QWidget]:
    a, b = stage.people()[:2]
    stage.controller.editing.pick(a)
    stage.controller.editing.add(b)
    yield stage.window.workspace.card


@snapshot(PANELS, On.SESSION, TrackPanel)
def track_of_nobody(stage: Stage) -> Iterator[QWidget]:
    stage.run("tracks.none")
    yield stage.window.workspace.card


@snapshot(PANELS, On.SESSION, HistoryPanel)
def history(stage: Stage) -> Iterator[QWidget]:
    yield stage.window.workspace.of(HistoryPanel)


@snapshot(PANELS, On.SESSION, CountingPanel)
def counting(stage: Stage) -> Iterator[QWidget]:
    stage.run("view.counting")
    counting = stage.controller.of(CountController)
    stage.wait(lambda: counting.counts is not None and not counting._search.busy)
    yield stage.window.workspace.of(CountingPanel)
    stage.run("view.counting")


@snapshot(PANELS, On.SESSION, CurvesPanel)
def parts_over_time(stage: Stage) -> Iterator[QWidget]:
    stage.run("view.curves")
    stage.rest(300)
    yield stage.window.workspace.of(CurvesPanel)
    stage.run("view.curves")


@snapshot(PANELS, On.SESSION, ScorePanel)
def score(stage: Stage) -> Iterator[QWidget]:
    _begin_score(stage)
    yield stage.window.workspace.of(ScorePanel)
    stage.run("view.score")


@snapshot(PANELS, On.SESSION)
def three_panels_below_the_floor(stage: Stage) -> Iterator[QWidget]:
    """The window with all panels that open open."""
    _begin_score(stage)
    for name in ("curves", "counting"):
        stage.run(f"view.{name}")
    stage.rest(300)
    yield stage.window
    for name in ("curves", "counting", "score"):
        stage.run(f"view.{name}")


def _begin_score(stage: Stage) -> None:
    stage.run("view.score")
    scoring = stage.controller.of(ScoreController)
    stage.wait(lambda: not scoring._search.busy and scoring.known)


@snapshot(PANELS, On.SESSION, PanelWindow)
def panel_in_a_window(stage: Stage) -> Iterator[QWidget]:
    docks = stage.window.workspace.docks
    docks.move("history", Dock.WINDOW)
    yield stage.seen(PanelWindow)
    docks.return_docked("history")


@snapshot(PANELS, On.SESSION)
def menu_of_a_panel(stage: Stage) -> Iterator[QWidget]:
    panel: Panel = stage.window.workspace.review
    menu = next(one.menu() for one in panel.findChildren(QToolButton) if one.menu())
    assert isinstance(menu, QMenu)
    menu.popup(panel.mapToGlobal(QPoint(20, 30)))
    yield menu
    menu.close()


def _labelling(name: str, stage: Stage) -> Iterator[QWidget]:
    stage.run(f"labels.{name}")
    stage.rest(200)
    yield stage.window.workspace.labelling
    stage.controller.labelling.leave()


for _name in ("parts", "occluders", "lines", "regions", "reviewed"):
    snapshot(PANELS, On.SESSION, LabellingPanel, name=f"labelling-{_name}")(
        partial(_labelling, _name)
    )


@snapshot(PANELS, On.SESSION, LabellingPanel)
def labelling_of_parts_in_the_window(stage: Stage) -> Iterator[QWidget]:
    stage.run("labels.parts")
    stage.rest(300)
    yield stage.window
    stage.controller.labelling.leave()


@snapshot(PANELS, On.SESSION, LabellingPanel)
def labelling_where_unsure(stage: Stage) -> Iterator[QWidget]:
    """Parts are labelled where the detector is least sure."""
    stage.run("detector.suggest")
    stage.rest(400)
    yield stage.window.workspace.labelling
    stage.controller.labelling.leave()


@snapshot(PANELS, On.SESSION, TransportBar)
def transport(stage: Stage) -> Iterator[QWidget]:
    yield stage.window.workspace.transport


@snapshot(PANELS, On.SESSION, TimelineView)
def timeline(stage: Stage) -> Iterator[QWidget]:
    yield stage.window.workspace.timeline


@snapshot(PANELS, On.SESSION)
def menu_of_the_timeline(stage: Stage) -> Iterator[QWidget]:
    menu = stage.window.workspace.timeline.area.controls.menu
    menu.popup(stage.window.mapToGlobal(QPoint(20, 30)))
    yield menu
    menu.close()
