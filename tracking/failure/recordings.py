"""Samples of several recordings together: who is held out in training is told by their names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import count

import numpy as np

from tracking.failure.core.features import PAPER_FEATURES
from tracking.failure.core.samples import NOT_TOLD_APART, Samples

Named = dict[str, str]
"""The names of recordings, and the footage each of them stands for."""


def told_apart(sources: Iterable[tuple[Samples, str, str]]) -> list[Samples]:
    """The samples of each source, different recordings under different names.

    To training, people are told apart within a recording's name. So footage whose name other
    footage had before gets the title of its source, too. Sources of the same footage get one
    name, whatever they call it; those that do not know their footage, as tables, are taken to
    speak of the recording they name, lest somebody is learnt from and held out at once.

    Two sources of one recording may have been tracked each on its own: one's track 3 is the
    other's track 5. Unless truth says who is who, or what they have in common shows the tracks to
    be the same, nobody of such a recording is told apart, and all of them are learnt from or held
    out together.

    Args:
        sources: samples, what their footage is known by ("": not known) and the source's title.
    """
    footage_of: Named = {}
    own: dict[str, str] = {}
    apart = []
    for number, (samples, footage, title) in enumerate(sources):
        given = samples.columns["recording"].tolist()
        if footage and given and footage not in own:
            own[footage] = _free_name(given[0], footage, title, footage_of)
        names = [own.get(footage, name) for name in given]
        session = np.full(len(samples), number, np.int32)
        apart.append(samples.with_columns(recording=np.array(names, object), session=session))
    return _by_tracks_in_common(apart)


def _by_tracks_in_common(apart: list[Samples]) -> list[Samples]:
    """The same, numbered by whose tracks they are; nobody told apart where tracks do not tell.

    A table and the session it was exported from speak of the same tracks: whatever both have of a
    part in a frame is the same there.
    """
    speaking: dict[str, list[int]] = {}
    for number, samples in enumerate(apart):
        for name in set(samples.columns["recording"].tolist()):
            speaking.setdefault(name, []).append(number)
    for name, numbers in speaking.items():
        of_it = [apart[at][apart[at].columns["recording"] == name] for at in numbers]
        said = [_said(samples) for samples in of_it]
        same = [_same_tracks(said[0], other) for other in said]
        known = all((samples.columns["person"] > 0).all() for samples in of_it)
        for at, agrees in zip(numbers, same, strict=True):
            session, person = (apart[at].columns[column].copy() for column in ("session", "person"))
            mine = apart[at].columns["recording"] == name
            session[mine] = numbers[0] if agrees else at
            if not known and not all(same):
                person[mine] = NOT_TOLD_APART
            apart[at] = apart[at].with_columns(session=session, person=person)
    return apart


def _said(samples: Samples) -> dict[tuple[int, ...], bytes]:
    """What samples of a recording say, by track, frame, part and label."""
    names = ("track", "frame", "part", "label")
    keys = zip(*(samples.columns[name].tolist() for name in names), strict=True)
    paper = np.ascontiguousarray(samples.features[:, :PAPER_FEATURES])  # older tables have no more
    return {key: row.tobytes() for key, row in zip(keys, paper, strict=True)}


def _same_tracks(
    one: Mapping[tuple[int, ...], bytes], other: Mapping[tuple[int, ...], bytes]
) -> bool:
    common = one.keys() & other.keys()
    return bool(common) and all(one[key] == other[key] for key in common)


def _free_name(name: str, footage: str, title: str, footage_of: Named) -> str:
    """A name that stands for no other footage; it stands for this one from now on."""
    own = name
    for number in count(1):
        if footage_of.setdefault(own, footage) == footage:
            break
        own = f"{name} ({title})" if number == 1 else f"{name} ({title}, {number})"
    return own
