"""What the commands of the Review menu do."""

from __future__ import annotations

from dataclasses import replace

from app.shell.again import ask_again, show_runs
from app.shell.recording_controller import RecordingController
from app.shell.recording_handler import RecordingHandler


def _walk(step: int) -> RecordingHandler:
    """N and P: through what differs while two versions are compared, else through the queue.

    While parts are labelled where the detector is least sure: through these.
    """

    def walk(controller: RecordingController) -> None:
        if controller.comparing.shown:
            controller.comparing.walk(step)
        elif controller.labelling.suggests:
            controller.labelling.walk(step)
        else:
            controller.reviewing.walk(step)

    return walk


def _choose_truth(controller: RecordingController) -> None:
    """Ask for a file; the score is shown at once, so that the choice is seen."""
    controller.set_view_options(replace(controller.view_options, score=True, truth=True))
    controller.scoring.ask_truth()


REVIEWING: dict[str, RecordingHandler] = {
    "review.next": _walk(1),
    "review.previous": _walk(-1),
    "review.play": lambda controller: controller.reviewing.play(),
    "review.plays": lambda controller: controller.reviewing.set_plays(
        not controller.reviewing.plays
    ),
    "review.search": lambda controller: controller.reviewing.look_through(),
    "review.measure": lambda controller: controller.reviewing.set_measures(
        not controller.reviewing.measures
    ),
    "review.right": lambda controller: controller.reviewing.decide("right"),
    "review.fix": lambda controller: controller.reviewing.fix(),
    "review.dismiss": lambda controller: controller.reviewing.decide("dismissed"),
    "review.mark": lambda controller: controller.reviewing.mark_watched(),
    "review.mark_all": lambda controller: controller.reviewing.mark_watched(everybody=True),
    "review.unmark": lambda controller: controller.reviewing.unmark_watched(),
    "review.again": ask_again,
    "tracks.runs": show_runs,
    "review.choose_truth": _choose_truth,
    "review.next_error": lambda controller: controller.scoring.walk(1),
    "review.previous_error": lambda controller: controller.scoring.walk(-1),
}
