"""Which tracker there is to tell of, and how it gets on, in words."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.document.detector_choice import DETECTOR
from app.core.i18n import strip_full_stop, tr
from app.core.keymap import in_brackets, key_or_title
from tracking.errors import TrackwrightError
from tracking.recording import Recording
from tracking.session import Session
from tracking.trackers import TRACKERS, best_tracker, body_part_tracker, require, settings_fields


@dataclass(frozen=True, slots=True)
class TrackerState:
    """What the window says of tracking.

    Attributes:
        name: of the tracker, "" where none can work. status: in a few words.
        no_lanes: said where there are no tracks.
    """

    name: str
    status: str
    no_lanes: str


class TrackerWords:
    """Words for one recording; `best` is its best tracker, or "" for the reason `why_not`."""

    def __init__(self, recording: Recording) -> None:
        try:
            self.best, self.why_not = best_tracker(recording), ""
        except TrackwrightError as error:
            self.best, self.why_not = "", tr(error.message)

    def propose_tracker(self, session: Session | None, *, in_parts: bool) -> str:
        """The tracker to track again with: that of the corrected tracks, else the best.

        Where somebody just chose a failure detector (`in_parts`), it is one that uses it.
        """
        run = session.corrected_run if session is not None else None
        name = run.tracker if run is not None and run.tracker in TRACKERS else self.best
        takes_detector = not in_parts or not self.best or _uses_detector(name)
        return name if takes_detector else body_part_tracker()

    def describe_work(self, name: str, status: str) -> TrackerState:
        """While a tracker is at work."""
        return TrackerState(name, status, tr("Each tracked person gets a lane here."))

    def describe_rest(self, session: Session | None) -> TrackerState:
        """While none is."""
        if session is not None and session.adopted_run is None:
            nobody = tr(
                "Nobody is labelled yet. Draw a person in the image{key}.",
                key=in_brackets("tracks.new"),
            )
            return TrackerState("", tr("labelled by hand"), nobody)
        if session is not None and session.corrected_run is not None:
            name = session.corrected_run.tracker
            return TrackerState(name, tr("tracked"), tr("Nobody was tracked."))
        if not self.best:
            said = tr("No tracks: {why}.", why=strip_full_stop(self.why_not))
            return TrackerState("", tr("no tracker"), said)
        said = tr(
            "No tracks yet. Press {key} to play and track the recording: each person gets a lane "
            "here.",
            key=key_or_title("play.toggle"),
        )
        return TrackerState(self.best, tr("play to track"), said)


def _uses_detector(tracker: str) -> bool:
    spec = TRACKERS.get(tracker)
    fields = settings_fields(spec.settings_type) if spec is not None else ()
    return any(field.name == DETECTOR for field in fields)


def why_not_tracked(name: str, recording: Recording) -> str:
    """Why a tracker that is installed cannot work on a recording; "" where it can."""
    try:
        require(TRACKERS[name], recording)
    except TrackwrightError as error:
        return tr(error.message)
    return ""
