"""What the commands of the View menu do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.features.pictures.bodies import why_nothing
from app.features.timeline.tracks_area import TracksArea
from app.shell.recording_controller import RecordingController
from app.shell.recording_handler import RecordingHandler


def _toggle(name: str) -> RecordingHandler:
    def toggle(controller: RecordingController) -> None:
        now: bool = getattr(controller.view_options, name)
        controller.set_view_options(replace(controller.view_options, **{name: not now}))

    return toggle


def _toggle_parts(name: str) -> RecordingHandler:
    """The same, and where there is nothing to see, what to do about it."""

    def toggle(controller: RecordingController) -> None:
        _toggle(name)(controller)
        if getattr(controller.view_options, name):
            controller.parts.tell_what_is_missing(for_one=name == "part_particles")

    return toggle


def _toggle_bodies(name: str) -> RecordingHandler:
    """Likewise of what trackers of one camera think of."""

    def toggle(controller: RecordingController) -> None:
        _toggle(name)(controller)
        why = why_nothing(controller.document.frame_state(controller.playback.number), name)
        if why and getattr(controller.view_options, name):
            controller.said.emit(why)

    return toggle


def _on_lanes(act: Callable[[TracksArea], None]) -> RecordingHandler:
    return lambda controller: act(controller.window_page.timeline.area)


def _toggle_score(controller: RecordingController) -> None:
    """The panel comes and goes with the truth it is about."""
    on = not controller.view_options.score
    controller.set_view_options(replace(controller.view_options, score=on, truth=on))


def _toggle_truth(controller: RecordingController) -> None:
    """Truth and errors, and where there are none why."""
    _toggle("truth")(controller)
    why = controller.scoring.presenter.why_nothing
    if why and controller.view_options.truth:
        controller.said.emit(why)


VIEWING: dict[str, RecordingHandler] = {
    "view.left": lambda controller: controller.set_cameras("left"),
    "view.both": lambda controller: controller.set_cameras("both"),
    "view.anaglyph": lambda controller: controller.set_cameras("anaglyph"),
    "view.whole": lambda controller: controller.window_page.show_whole(),
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
