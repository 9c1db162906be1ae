"""The tracks of a finished run linked: one id for each person's whole stay."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.appearance import learn_appearance
from tracking.trackers.linking.candidates import find_links
from tracking.trackers.linking.doubts import Doubt, find_doubts
from tracking.trackers.linking.extend_ends import extend_ends
from tracking.trackers.linking.link_selection import least_rows, number_people, select_links
from tracking.trackers.linking.run_ids import rename_tracks
from tracking.trackers.linking.seen_rows import Integers, find_seen_rows
from tracking.trackers.linking.tracklets import Tracklets, cut_tracklets
from tracking.tracks.columns import Columns
from tracking.tracks.run import Run


def link_tracks(
    run: Run,
    view: View,
    fps: float,
    given: Columns | None = None,
    *,
    longest_gap_s: float = np.inf,
) -> Run:
    """The run with one id for each person.

    Trackers decide frame by frame, and where two people meet or somebody is lost they may go on
    with the wrong one. Of a recording it is known what came later: tracks are cut where it is
    doubtful who goes on, and the pieces are linked again over the whole recording at once, by how
    people walk, their appearance and where they come from and go to.

    A person has the lowest of the ids that were first given to it, or else a new one above all
    there are. Rows that stand fast keep theirs, and who is known by an id keeps it.

    Args:
        view: the camera the boxes were seen by. fps: frames a second.
        given: rows of frames before the run's that stand fast, as corrected by people: its people
            go on from there.
        longest_gap_s: gaps up to this are filled, as far as it is known where people walk unseen.
    """
    row, name = _find_ids(run, view, fps, given)
    if not len(row):
        return run
    free = run.detections["track"] == 0
    renamed = rename_tracks(run, row, name, view, fps, longest_gap_s)
    return extend_ends(renamed, free, view, fps)


def _find_ids(
    run: Run, view: View, fps: float, given: Columns | None
) -> tuple[NDArray[np.intp], Integers]:
    """The rows (k,) of the run's tracks that were seen, by track and frame, and their new ids.

    What finding them takes in memory is free again afterwards.
    """
    before = 0 if given is None else len(given["frame"])
    seen, meetings = find_seen_rows(run if given is None else _prepend(given, run), view)
    own = seen.row >= before
    if not own.any():
        return np.zeros(0, np.intp), np.zeros(0, np.int64)
    doubt = find_doubts(seen, meetings, fps)
    doubt[~own & (doubt != Doubt.TRACK)] = Doubt.NONE
    pieces = cut_tracklets(seen, doubt, fps)
    known = max(run.known_tracks, int(seen.track[~own].max(initial=0)))
    fixed = (pieces.doubt == Doubt.TRACK) & (pieces.track <= known)
    links = find_links(seen, pieces, run.tracks, view, fps, run.frames, fixed)
    person = number_people(select_links(links, pieces, learn_appearance(seen, pieces, fps), fps))
    highest = max(known, int(run.tracks["track"].max()))
    name = _ids(pieces, person, highest)[pieces.of_rows]
    rows = np.bincount(person[pieces.of_rows], minlength=int(person.max()) + 1)
    rows[person[fixed]] = least_rows(fps)
    name[(rows < least_rows(fps))[person[pieces.of_rows]]] = 0
    return seen.row[own] - before, name[own]


def _prepend(given: Columns, run: Run) -> Run:
    """The run with the rows given before its own; nothing was noticed of them."""
    tracks = {name: np.concatenate((given[name], column)) for name, column in run.tracks.items()}
    signals = {
        name: np.concatenate((np.full(len(given["frame"]), np.nan, column.dtype), column))
        if column.dtype.kind == "f"
        else np.concatenate((given[name], column))
        for name, column in run.signals.items()
    }
    return replace(run, tracks=tracks, signals=signals)


def _ids(pieces: Tracklets, person: NDArray[np.intp], highest: int) -> Integers:
    """(pieces,) the id of each one's person; new ones are above the highest."""
    begins = pieces.doubt == Doubt.TRACK
    id_of = np.full(int(person.max()) + 1, np.iinfo(np.int64).max)
    np.minimum.at(id_of, person[begins], pieces.track[begins])
    fresh = np.flatnonzero(id_of > highest)
    id_of[fresh] = highest + 1 + np.arange(len(fresh))
    return id_of[person]
