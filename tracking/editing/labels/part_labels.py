"""Planners of part labels: rectangles of head, torso and hip-leg, and whether they lie on them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from tracking.editing.core.change import Change, LabelState, State
from tracking.editing.core.scope import Scope
from tracking.errors import EditError
from tracking.tracks import PART_NAMES, Labels, PartKey, PartLabel, check_part_label
from tracking.translation import Message, count_msg, msg

SAID_OF_PART = {
    True: msg("on its part"),
    False: msg("off its part"),
    None: msg("unsure"),
}
"""What a part label says, by `PartLabel.on_part`."""


def plan_label_part(labels: Labels, given: PartLabel | Iterable[PartLabel]) -> Change:
    """Label one body part, or several at once; what was said of the same parts is replaced.

    Raises EditError for a rectangle that is none, an unknown part, a part labelled twice, and
    where everything is said already.
    """
    new = [given] if isinstance(given, PartLabel) else list(given)
    keys = [label.key for label in new]
    if len(set(keys)) < len(keys):
        raise EditError("a part is labelled twice in one edit; say one thing of each")
    for label in new:
        check_part_label(label)
    changed = [label for label in new if labels.parts.get(label.key) != label]
    if not changed:
        raise EditError("the parts are labelled so already; nothing to change")
    out = [labels.parts[label.key] for label in changed if label.key in labels.parts]
    text = msg("Label {named}", named=_named(changed))
    if len(changed) == 1:
        text += ": " + SAID_OF_PART[changed[0].on_part]
    return _change("label", text, out, changed)


def plan_unlabel_part(labels: Labels, *keys: PartKey) -> Change:
    """Take back what was said of one part (frame, track, part), or of several at once.

    Raises EditError where nothing was said of one of them.
    """
    gone = []
    for frame, track, part in dict.fromkeys(keys):
        label = labels.parts.get((frame, track, part))
        if label is None:
            raise EditError(
                "part {part} of track {track} has no label in frame {frame}",
                part=part,
                track=track,
                frame=frame,
            )
        gone.append(label)
    if not gone:
        raise EditError("no part is named; choose one that has a label")
    return _change("unlabel", msg("Delete the label of {named}", named=_named(gone)), gone, [])


def with_parts_carried(change: Change, labels: Labels) -> Change:
    """The change with part labels going along where rows go from track to track.

    A label is about the person in the picture, as a row is. What was said of a track in the frames
    where rows arrive was about a row that leaves or is gone: it is taken away.
    """
    if not (len(labels.parts) and len(change.before.stretches)):
        return change
    leaving: dict[PartKey, PartLabel] = {}
    coming: dict[PartKey, PartLabel] = {}
    targets = change.after.stretches[:, 0].tolist()
    for (track, start, end), to in zip(change.before.stretches.tolist(), targets, strict=True):
        for label in labels.parts.of_track(track, start, end):
            leaving[label.key] = label
            moved = replace(label, track=to)
            coming[moved.key] = moved
        leaving.update((label.key, label) for label in labels.parts.of_track(to, start, end))
    if not leaving:
        return change
    before, after = change.before.labels, change.after.labels
    return replace(
        change,
        before=replace(change.before, labels=replace(before, parts=_sorted(leaving.values()))),
        after=replace(change.after, labels=replace(after, parts=_sorted(coming.values()))),
    )


def _named(labels: Sequence[PartLabel]) -> str:
    """One part by its name, several by their number and frames."""
    if len(labels) == 1:
        only = labels[0]
        return msg(
            "the {part} of {track} in frame {frame}",
            part=msg(PART_NAMES[only.part]),
            track=only.track,
            frame=only.frame,
        )
    frames = sorted({label.frame for label in labels})
    where = (
        msg("frame {first}", first=frames[0])
        if len(frames) == 1
        else msg("frames {first} to {last}", first=frames[0], last=frames[-1])
    )
    return count_msg(len(labels), "{n} part in {where}", "{n} parts in {where}", where=where)


def _change(
    kind: str, text: Message, out: Iterable[PartLabel], into: Iterable[PartLabel]
) -> Change:
    before, after = LabelState(parts=_sorted(out)), LabelState(parts=_sorted(into))
    frames = {label.frame for label in (*before.parts, *after.parts)}
    scope = Scope(min(frames), max(frames) + 1)
    return Change(kind, text, scope.start, State(labels=before), State(labels=after), scope)


def _sorted(labels: Iterable[PartLabel]) -> tuple[PartLabel, ...]:
    return tuple(sorted(labels, key=lambda label: label.key))
