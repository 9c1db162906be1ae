"""An edit that waits, in words: what it would do to how many frames, and which keys work now."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from app.core.editing import edits
from app.core.editing.edit_names import option_name, question
from app.core.editing.edit_options import EditScope
from app.core.editing.edit_spec import EditSpec
from app.core.editing.flow import EditFlow
from app.core.i18n import count_text, joined_text, some_of, time_text, tr
from app.core.keymap import key_or_title, shown_key
from app.core.scenes import ChoiceRow, EditPreview, Proposal
from app.core.tracks.edit_context import EditContext
from tracking.editing import Change
from tracking.tracks import Columns, TrackTable, next_track, pairs_of, row_keys

_MOST_NAMED = 4
_CHOOSERS = "tracks.scope", "tracks.way"
"""The commands that go through the options of each row."""
_FAR_APART_M = 1.5
"""Who is never nearer than this was hardly taken for the other."""
Places = NDArray[np.int64]


def preview_scene(
    flow: EditFlow, lines: tuple[str, ...], change: Change | None, on: EditContext
) -> EditPreview:
    """The panel's scene; `lines` are said before what the change does."""
    details = lines if change is None else (*lines, *_details(flow, change, on))
    choices = tuple(row for row in (_choice_row(flow, row) for row in (0, 1)) if row is not None)
    return EditPreview(
        title=_title(flow) if change is None else tr(change.text),
        details=details,
        frame=flow.cut,
        end=flow.end if flow.has_end else None,
        choices=choices,
        other=flow.other if flow.takes_other else None,
        others=_others(flow, on),
        cuts=_cuts(flow) if change is not None else (),
        has_cut=flow.has_cut,
        begins=flow.scope in (EditScope.ON, EditScope.RANGE),
        gives=flow.spec is edits.REASSIGN,
        ready=change is not None,
        hint=_hint(flow, change is not None),
    )


def _title(flow: EditFlow) -> str:
    if not flow.track:
        return tr("Draw a new person")
    return tr(flow.spec.title, a=some_of(flow.everybody, _MOST_NAMED))


# what can be chosen


def _choice_row(flow: EditFlow, row: int) -> ChoiceRow | None:
    """What a key chooses between; None where there is nothing to choose."""
    options = flow.choices[row]
    if len(options) < 2:
        return None
    names = tuple(option_name(option, flow) for option in options)
    return ChoiceRow(row, question(options[0]), names, flow.chosen(row), shown_key(_CHOOSERS[row]))


def _others(flow: EditFlow, on: EditContext) -> tuple[Proposal, ...]:
    """People who may be meant, and for a gift an id nobody has had."""
    if not flow.takes_other:
        return ()
    ids = [(track, str(track)) for track in flow.others]
    if flow.spec is edits.REASSIGN:
        new = next_track(on.table)
        ids.insert(0, (new, tr("new {track}", track=new)))
    return tuple(
        Proposal(track, text, track == flow.other, on.colours.of(track)) for track, text in ids
    )


def _cuts(flow: EditFlow) -> tuple[Proposal, ...]:
    """The frames where the two may have changed over, the likeliest first."""
    return tuple(
        Proposal(number, str(cut.frame), number == flow.cut_number, None, _why(flow, number))
        for number, cut in enumerate(flow.cuts)
    )


def _why(flow: EditFlow, number: int) -> str:
    """Why a frame was found; a share of all found only where there are others to choose from."""
    cut = flow.cuts[number]
    if cut.apart_m > _FAR_APART_M:
        return tr("unlikely here: {why}", why=cut.text)
    if not cut.shown:
        return tr("no clear sign: {why}", why=cut.text)
    if len(flow.cuts) == 1:
        return tr("the only frame found: {why}", why=cut.text)
    return tr("{share} %: {why}", share=round(100 * cut.likelihood), why=cut.text)


# what it does


def _details(flow: EditFlow, change: Change, on: EditContext) -> tuple[str, ...]:
    lines, fps = [], on.geometry.fps
    when = time_text(flow.cut / fps)
    if flow.proposed and flow.cut_number >= 0:
        why = _why(flow, flow.cut_number)
        lines.append(tr("Frame {n} ({when}), {why}", n=flow.cut, when=when, why=why))
    elif flow.has_cut or flow.places:
        lines.append(tr("Frame {n} ({when})", n=flow.cut, when=when))
    if flow.spec is edits.SPLIT:
        lines.append(tr("{a} keeps its id before the cut", a=flow.track))
    lines += _counts(change, on.table)
    if flow.proposed and flow.cut_number == 0 and flow.asked_at not in (-1, flow.cut):
        lines.append(_begins_elsewhere(flow))
    return tuple(lines)


def _begins_elsewhere(flow: EditFlow) -> str:
    """Why the edit does not begin where the user was."""
    return tr(
        "Begins here, not in frame {asked}: of the frames nearby a swap is likeliest here",
        asked=flow.asked_at,
    )


def _counts(change: Change, table: TrackTable) -> list[str]:
    """How many frames of whom are new, go, and become others."""
    new, gone, changed = rows_changed(change, table)
    said = (
        (new, tr("Adds {what}")),
        (changed, tr("Changes {what}")),
        (gone, tr("Deletes {what}")),
    )
    return [text.format(what=_frames_of(counts)) for counts, text in said if counts]


def _frames_of(counts: Mapping[int, int]) -> str:
    named = [
        count_text(n, "{n} frame of {track}", "{n} frames of {track}", track=track)
        for track, n in list(counts.items())[:_MOST_NAMED]
    ]
    rest = sum(list(counts.values())[_MOST_NAMED:])
    if rest:
        named.append(count_text(rest, "{n} frame of others", "{n} frames of others"))
    return joined_text(", ", named)


def rows_changed(
    change: Change, table: TrackTable
) -> tuple[dict[int, int], dict[int, int], dict[int, int]]:
    """How many rows of each track come, go, and are changed or handed to another track."""
    out, into = _places(change.before.rows), _places(change.after.rows)
    both = np.isin(out, into)
    come = _per_track(into[~np.isin(into, out)])
    gone, changed = _per_track(out[~both]), _per_track(out[both])
    for track, start, end in change.before.stretches.tolist():
        first, stop = np.searchsorted(table.frames_of_track(track), (start, end))
        if stop > first:
            changed[track] = changed.get(track, 0) + int(stop - first)
    return come, gone, changed


def _places(rows: Columns) -> Places:
    """(n,) one number for each track and frame."""
    return row_keys(rows["track"], rows["frame"])


def _per_track(places: Places) -> dict[int, int]:
    tracks, counts = np.unique(pairs_of(places)[0], return_counts=True)
    return dict(zip(tracks.tolist(), counts.tolist(), strict=True))


# which keys work


def _hint(flow: EditFlow, ready: bool) -> str:
    if flow.needs_other or not (ready or flow.places):
        return tr("{key} cancels the edit", key=key_or_title("tracks.none"))
    keys = []
    if flow.places:
        keys.append(tr("Arrows move, with Shift ten times as far"))
        if flow.drawing:
            keys.insert(0, tr("Drag over the left image to draw the box"))
        if flow.spec is not edits.FLOOR:
            keys.append(tr("Ctrl+arrows resize"))
    if flow.has_cut:
        keys.append(
            tr(
                "{back} / {on} move the frame",
                back=key_or_title("play.previous"),
                on=key_or_title("play.next"),
            )
        )
    if flow.has_end:
        keys.append(
            tr(
                "{back} / {on} move the end",
                back=key_or_title("play.previous_second"),
                on=key_or_title("play.next_second"),
            )
        )
    up, down = key_or_title("tracks.up"), key_or_title("tracks.down")
    if len(flow.cuts) > 1:
        keys.append(tr("{up} / {down}: other frames found", up=up, down=down))
    if flow.spec is edits.FILL_ALL:
        keys.append(tr("{up} / {down} go through the gaps", up=up, down=down))
    scope, way = key_or_title("tracks.scope"), key_or_title("tracks.way")
    titles = (tr("{key} changes whom to keep", key=scope), tr("{key} fills the gap", key=way))
    for row, of_merge in enumerate(titles):
        if len(flow.choices[row]) > 1:
            other = _far_hint(flow.spec) if row == 0 else tr("{key} changes how", key=way)
            keys.append(of_merge if flow.spec is edits.MERGE else other)
    return joined_text(", ", keys)


def _far_hint(spec: EditSpec) -> str:
    key = key_or_title("tracks.scope")
    if spec is edits.FILL_ALL:
        return tr("{key} changes how long they may be", key=key)
    return tr("{key} changes the scope", key=key)
