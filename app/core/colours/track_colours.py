"""Which colour each track has: people seen at the same time do not look alike."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from heapq import heappop, heappush
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from app.core.colours.co_occurrence import FAR, CoOccurrences, closeness, find_co_occurrences
from app.core.colours.colour_sight import alike, of_one_hue
from app.core.colours.palette import NOBODY, TRACK_COLOURS, usual_place
from app.core.colours.shown_colours import THEMES, readable_colour
from app.core.scenes import Colour
from tracking.tracks import Columns, Run, TrackTable

ColourOf = Callable[[int], Colour]
"""The colour of a track id."""

_ALIKE = np.max(
    [alike(TRACK_COLOURS)]
    + [alike([readable_colour(one, colour) for colour in TRACK_COLOURS]) for one in THEMES],
    axis=0,
)
"""How much alike every two look where they look most alike: on pictures, or in either theme."""
_ONE_HUE = of_one_hue(TRACK_COLOURS)
_LIKE = _ALIKE**4 + 0.05 * _ONE_HUE
"""How little two go together: what is very much alike outweighs all that is only a little; among
those that differ, another hue is better than another shade of one."""
_TABLE = np.array((*TRACK_COLOURS, NOBODY), np.uint8)
_GREY = len(TRACK_COLOURS)
_TOO_ALIKE = 0.1
"""From here on an id does not take its usual colour."""
_SAME_HUE = 0.2
"""From here on it leaves its usual colour to somebody of that hue, where another hue is free."""
_FEW = 4
"""Times as many people as colours: from there on all are had, which is not looked for again."""
_SOON_FRAMES = 100
"""So long after somebody was seen last nobody else comes up in their colour."""


class TrackColours:
    """Colours of track ids, each kept from the moment it was given.

    An id has the colour of the palette that goes with its number, unless somebody who is there at
    the same time has one that looks like it, or goes by the same name while another hue is free;
    then it has the one least like those of the people around it, above all of those who come near.
    As long as there are colours that nobody has, nobody shares one.
    """

    def __init__(self) -> None:
        self._place: dict[int, int] = {}
        self._seen: dict[int, int] = {}

    @classmethod
    def at_first(cls, run: Run | None, seen: TrackColours | None = None) -> TrackColours:
        """Colours of a session before any edit: of its run's tracks; seen: see `of_run`."""
        if run is not None:
            return cls.of_run(run, seen)
        return cls() if seen is None else seen.copy()

    @classmethod
    def of_run(cls, run: Run, seen: TrackColours | None = None) -> TrackColours:
        """Colours of a run's tracks.

        `seen`: those its ids had while the tracker worked. They keep them, unless two who are
        seen together in the finished run look alike: then who has fewer rows has another.
        """
        colours, co_occurrences = (
            cls() if seen is None else seen.copy(),
            find_co_occurrences(run.tracks),
        )
        if seen is not None:
            colours._yield(run.tracks, co_occurrences)
        colours._settle(co_occurrences)
        return colours

    @classmethod
    def kept(cls, places: Mapping[int, int]) -> TrackColours:
        """Colours as they were kept: see `places`; what is no place of the palette is left out."""
        colours = cls()
        known = range(len(TRACK_COLOURS))
        colours._place = {track: place for track, place in places.items() if place in known}
        return colours

    @property
    def places(self) -> Mapping[int, int]:
        """Place in the palette of each id that was given a colour; it follows what is given."""
        return MappingProxyType(self._place)

    def copy(self) -> TrackColours:
        """The same colours; what is given to either from now on the other has not."""
        colours = TrackColours()
        colours._place, colours._seen = dict(self._place), dict(self._seen)
        return colours

    def and_of(self, table: TrackTable) -> TrackColours:
        """These, with colours for all of a table who have none yet."""
        colours = self.copy()
        if not all(map(colours.has, table.track_ids)):
            colours._settle(find_co_occurrences(table.columns()))
        return colours

    def of(self, track: int) -> Colour:
        """The colour of a track id; grey for 0, which is nobody."""
        if track <= 0:
            return NOBODY
        return TRACK_COLOURS[self._place.get(track, usual_place(track))]

    def of_all(self, tracks: NDArray[np.int32]) -> NDArray[np.uint8]:
        """The colours of (n,) ids as (n, 3) red, green, blue."""
        known, inverse = np.unique(tracks, return_inverse=True)
        places = [
            self._place.get(one, usual_place(one)) if one > 0 else _GREY for one in known.tolist()
        ]
        return np.asarray(_TABLE[np.array(places, np.intp)][inverse])

    def meet(self, rows: Columns) -> None:
        """Give colours to those of a frame's rows who have none yet."""
        ids = rows["track"].tolist()
        if not ids:
            return
        frame = int(rows["frame"][0])
        new = [track for track in ids if track not in self._place]
        if new:
            for track in new:
                self._give(track, {**self._just_seen(frame), **closeness(rows, track)})
        self._seen.update(dict.fromkeys(ids, frame))

    def has(self, track: int) -> bool:
        """Whether a colour was given to a track id."""
        return track in self._place

    def meet_over(self, track: int, looks: Iterable[Columns], beside: Iterable[int] = ()) -> None:
        """Give a colour to an id that has none, in view of who is there in any of its frames.

        Args:
            looks: the rows of frames in which it stands, everybody's.
            beside: others it is to differ from: who goes on before or behind it.
        """
        near = dict.fromkeys(beside, 1.0)
        for rows in looks:
            for other, much in closeness(rows, track).items():
                near[other] = max(near.get(other, 0.0), much)
        self._give(track, near)

    def _just_seen(self, frame: int) -> dict[int, float]:
        soon = _SOON_FRAMES
        return {one: FAR for one, seen in self._seen.items() if abs(frame - seen) <= soon}

    def _settle(self, co_occurrences: CoOccurrences) -> None:
        """Give colours to all who have none, in the order they come up."""
        leaving: list[tuple[int, int]] = []  # last frame and place in ids of those there, a heap
        ids = np.sort([track for _, _, track in co_occurrences.stays])
        places = np.array([self._place.get(one, _GREY) for one in ids.tolist()], np.intp)
        there = np.zeros(len(ids), bool)
        worn = np.zeros(len(TRACK_COLOURS))  # by how many of them
        for first, last, track in co_occurrences.stays:
            while leaving and leaving[0][0] + _SOON_FRAMES < first:
                gone = heappop(leaving)[1]
                worn[places[gone]] -= 1
                there[gone] = False
            at = int(np.searchsorted(ids, track))
            if track not in self._place:
                others, much = co_occurrences.near_of(track)
                near = np.searchsorted(ids, others)
                more = np.where(there[near], much - FAR, much)
                self._choose(track, _taken(places[near], more) + FAR * worn)
            heappush(leaving, (last, at))
            places[at], there[at] = self._place[track], True
            worn[places[at]] += 1

    def _yield(self, rows: Columns, co_occurrences: CoOccurrences) -> None:
        """Of two who look alike and are there together, who has fewer rows has another colour.

        Of equals the later id yields; what would be no better stays as it is.
        """
        stays = sorted(co_occurrences.stays, key=_id)
        first, last, ids = np.array(stays, np.int64).reshape(-1, 3).T
        places = np.array([self._place.get(one, _GREY) for one in ids.tolist()], np.intp)
        settled = np.zeros(len(ids), bool)
        rows_of = np.unique(rows["track"], return_counts=True)[1]
        for at in np.lexsort((ids, -rows_of)).tolist():
            if places[at] == _GREY:
                continue
            near = np.full(len(ids), FAR)
            others, much = co_occurrences.near_of(int(ids[at]))
            near[np.searchsorted(ids, others)] = much
            there = settled & (first <= last[at]) & (last >= first[at])
            if (_ALIKE[places[at], places[there]] * near[there]).max(initial=0.0) > _TOO_ALIKE:
                soon = (first <= last[at] + _SOON_FRAMES) & (last >= first[at] - _SOON_FRAMES)
                soon[at] = False
                places[at] = _better(places[at], _taken(places[soon], near[soon]))
                self._place[int(ids[at])] = int(places[at])
            settled[at] = True

    def _give(self, track: int, near: Mapping[int, float]) -> None:
        """Choose a colour; near: those around, and how near they come."""
        taken = np.zeros(len(TRACK_COLOURS))
        for one, much in near.items():
            if one in self._place:
                taken[self._place[one]] += much
        self._choose(track, taken)

    def _choose(self, track: int, taken: NDArray[np.float64]) -> None:
        place, had = _choice(track, taken), self._had_by_others(track)
        self._place[track] = _unshared(place, taken, had) if had[place] else place

    def _had_by_others(self, track: int) -> NDArray[np.bool_]:
        """(colours,) which of them anybody else has, at whatever time."""
        had = np.zeros(len(TRACK_COLOURS), bool)
        if len(self._place) < len(had) * _FEW:
            had[[place for one, place in self._place.items() if one != track]] = True
        else:
            had[:] = True
        return had


def _choice(track: int, taken: NDArray[np.float64]) -> int:
    """The usual colour, or the one least like others; taken: (colours,) how much each is."""
    usual, other = usual_place(track), int((_LIKE @ taken).argmin())
    if (_ALIKE[usual] * taken).max() > _TOO_ALIKE:
        return other
    named, instead = ((_ONE_HUE[place] * taken).max() for place in (usual, other))
    return other if named > _SAME_HUE > instead else usual


def _unshared(place: int, taken: NDArray[np.float64], had: NDArray[np.bool_]) -> int:
    """A colour that nobody has, where one goes as well with those who are near."""
    free = np.flatnonzero(~had)
    if not len(free):
        return place
    other = int(free[(_LIKE[free] @ taken).argmin()])
    much, before = ((_ALIKE[one] * taken).max() for one in (other, place))
    return other if much <= max(before, _TOO_ALIKE) else place


def _better(place: int, taken: NDArray[np.float64]) -> int:
    """The place of the colour least like others, unless it is no better than the one there is."""
    other = int((_LIKE @ taken).argmin())
    return other if (_ALIKE[other] * taken).max() < (_ALIKE[place] * taken).max() else place


def _taken(places: NDArray[np.intp], near: NDArray[np.float64]) -> NDArray[np.float64]:
    """(colours,) how much each is taken by those who have it, so near each."""
    return np.bincount(places, near, len(TRACK_COLOURS) + 1)[:_GREY].astype(float)


def _id(stay: tuple[int, int, int]) -> int:
    return stay[2]
