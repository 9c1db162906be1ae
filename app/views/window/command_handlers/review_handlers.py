"""What the commands of the Review menu do."""

from __future__ import annotations

from dataclasses import replace

from app.views.desk.again import ask_again, show_runs
from app.views.desk.recording_controller import RecordingController
from app.views.window.command_handlers.on_desk import OnDesk


def _walk(step: int) -> OnDesk:
    """N and P: through what differs while two versions are compared, else through the queue.

    While parts are labelled where the detector is least sure: through these.
    """

    def walk(desk: RecordingController) -> None:
        if desk.comparing.shown:
            desk.comparing.walk(step)
        elif desk.labelling.suggests:
            desk.labelling.walk(step)
        else:
            desk.reviewing.walk(step)

    return walk


def _choose_truth(desk: RecordingController) -> None:
    """Ask for a file; the score is shown at once, so that the choice is seen."""
    desk.set_pictured(replace(desk.pictured, score=True, truth=True))
    desk.scoring.ask_truth()


REVIEWING: dict[str, OnDesk] = {
    "review.next": _walk(1),
    "review.previous": _walk(-1),
    "review.play": lambda desk: desk.reviewing.play(),
    "review.plays": lambda desk: desk.reviewing.set_plays(not desk.reviewing.plays),
    "review.search": lambda desk: desk.reviewing.look_through(),
    "review.measure": lambda desk: desk.reviewing.set_measures(not desk.reviewing.measures),
    "review.right": lambda desk: desk.reviewing.decide("right"),
    "review.fix": lambda desk: desk.reviewing.fix(),
    "review.dismiss": lambda desk: desk.reviewing.decide("dismissed"),
    "review.mark": lambda desk: desk.reviewing.mark_watched(),
    "review.mark_all": lambda desk: desk.reviewing.mark_watched(everybody=True),
    "review.unmark": lambda desk: desk.reviewing.unmark_watched(),
    "review.again": ask_again,
    "tracks.runs": show_runs,
    "review.choose_truth": _choose_truth,
    "review.next_error": lambda desk: desk.scoring.walk(1),
    "review.previous_error": lambda desk: desk.scoring.walk(-1),
}
