"""What the commands of the View menu do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.presenters.pictures.bodies import why_nothing
from app.views.desk.recording_controller import RecordingController
from app.views.timeline.tracks_area import TracksArea
from app.views.window.command_handlers.on_desk import OnDesk


def _toggle(name: str) -> OnDesk:
    def toggle(desk: RecordingController) -> None:
        now: bool = getattr(desk.pictured, name)
        desk.set_pictured(replace(desk.pictured, **{name: not now}))

    return toggle


def _toggle_parts(name: str) -> OnDesk:
    """The same, and where there is nothing to see, what to do about it."""

    def toggle(desk: RecordingController) -> None:
        _toggle(name)(desk)
        if getattr(desk.pictured, name):
            desk.parts.tell_what_is_missing(whose=name == "part_particles")

    return toggle


def _toggle_bodies(name: str) -> OnDesk:
    """Likewise of what trackers of one camera think of."""

    def toggle(desk: RecordingController) -> None:
        _toggle(name)(desk)
        why = why_nothing(desk.document.instant(desk.playback.number), name)
        if why and getattr(desk.pictured, name):
            desk.said.emit(why)

    return toggle


def _on_lanes(act: Callable[[TracksArea], None]) -> OnDesk:
    return lambda desk: act(desk.window_page.timeline.area)


def _toggle_score(desk: RecordingController) -> None:
    """The panel comes and goes with the truth it is about."""
    on = not desk.pictured.score
    desk.set_pictured(replace(desk.pictured, score=on, truth=on))


def _toggle_truth(desk: RecordingController) -> None:
    """Truth and errors, and where there are none why."""
    _toggle("truth")(desk)
    why = desk.scoring.presenter.why_nothing
    if why and desk.pictured.truth:
        desk.said.emit(why)


VIEWING: dict[str, OnDesk] = {
    "view.left": lambda desk: desk.set_eyes("left"),
    "view.both": lambda desk: desk.set_eyes("both"),
    "view.anaglyph": lambda desk: desk.set_eyes("anaglyph"),
    "view.whole": lambda desk: desk.window_page.show_whole(),
    "view.grid": _toggle("grid"),
    "view.particles": _toggle("particles"),
    "view.trails": _toggle("trails"),
    "view.foreground": _toggle("foreground"),
    "view.disparity": _toggle("disparity"),
    "view.time_in": _on_lanes(lambda area: area.stretch.zoom(2.0)),
    "view.time_out": _on_lanes(lambda area: area.stretch.zoom(0.5)),
    "view.time_all": _on_lanes(lambda area: area.stretch.show_all()),
    "view.time_selected": _on_lanes(lambda area: area.stretch.show_selected()),
    "view.time_second": _on_lanes(lambda area: area.stretch.show_second()),
    "view.time_earlier": _on_lanes(lambda area: area.stretch.pan(-0.5)),
    "view.time_later": _on_lanes(lambda area: area.stretch.pan(0.5)),
    "view.lanes_up": _on_lanes(lambda area: area.lanes.scroll(-8)),
    "view.lanes_down": _on_lanes(lambda area: area.lanes.scroll(8)),
    "view.labels": _toggle("labels"),
    "view.parts": _toggle_parts("parts"),
    "view.part_particles": _toggle_parts("part_particles"),
    "view.curves": _toggle("curves"),
    "view.counts": _toggle("counts"),
    "view.score": _toggle_score,
    "view.truth": _toggle_truth,
    "view.counting": _toggle("counting"),
    "view.flow_map": _toggle("flow_map"),
    "view.floor_legend": _toggle("floor_legend"),
    "view.tracklets": _toggle_bodies("tracklets"),
    "view.outlines": _toggle_bodies("outlines"),
    "view.evaluation": _toggle_bodies("evaluation"),
    "view.ramp": _toggle("ramp"),
}
