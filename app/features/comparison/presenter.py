"""Two versions of the tracks beside each other: what differs, and what of it is taken."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from functools import partial
from typing import Final

import numpy as np

from app.core.colours.track_colours import ColourOf
from app.core.i18n import N_, span_text, tr
from app.core.projection.concern import CONCERNED, Concern
from app.core.scenes import PreviewTrail
from app.core.scenes.queue_rows import ReviewPerson
from app.core.tracks.session_tracks import SessionTracks
from app.core.tracks.two_versions import PointsOf
from app.features.comparison.difference_search import ComparisonResult, search_in
from app.features.comparison.differences_scene import (
    DifferenceItem,
    DifferenceOrder,
    DifferencesScene,
    Side,
)
from tracking.editing import (
    Change,
    Difference,
    differences,
    plan_take,
)
from tracking.editing.tracking_again.alignment import rows_of_table
from tracking.editing.tracking_again.counterparts import Places, counterparts
from tracking.errors import EditError
from tracking.progress import Progress
from tracking.session import Session
from tracking.tracks import Columns, Run, TrackTable

_KINDS: Final = {
    "moved": N_("Elsewhere"),
    "identity": N_("Another id"),
    "added": N_("Added"),
    "removed": N_("Gone"),
}
_AROUND_S = 3.0
"""Trails are shown this long before and after the frame that is shown."""


class Comparison:
    """A run beside the corrected tracks, or beside another run.

    Attributes:
        run: number of the run whose version is drawn dashed. base: that of the other one, drawn
            solid; None: the corrected tracks.
    """

    def __init__(
        self,
        session: Session,
        run: int,
        base: int | None,
        fps: float,
        frames: tuple[int, int] | None = None,
        *,
        everything: bool = False,
        colour_of: ColourOf,
    ) -> None:
        """Of some frames, None for all; `everything` that differs is ticked at first."""
        self.run, self.base = run, base
        # All is ticked that a run which went on from the corrected tracks would change.
        goes_on = base is None and bool(session.runs[run].known_tracks)
        self._everything = everything or goes_on
        self._colour_of = colour_of
        self.order = DifferenceOrder.TIME
        self.person = 0
        self._session, self._fps, self._frames = session, fps, frames
        self._found: ComparisonResult | None = None
        self._shown: tuple[int, ...] = ()
        self._ticked: set[int] = set()
        self._current: int | None = None
        self._solid: SessionTracks | None = None

    # finding

    def search(self) -> Callable[[Progress], ComparisonResult]:
        """What finds the differences of the tracks as they are now; to be called in any thread."""
        return search_in(self._session, self.run, self.base, self._frames, self._fps)

    def take(self, found: ComparisonResult) -> None:
        """Take what differs by now; ticks and the one that is looked at stay where they can."""
        before = self._found.differences if self._found is not None else ()
        ticked = {_same_place(before[number]) for number in self._ticked}
        looked_at = _same_place(before[self._current]) if self._current is not None else None
        first = self._found is None
        self._found = found
        if self.base is not None:
            self._solid = SessionTracks(found.base, self._session.runs[self.base])
        places = [_same_place(one) for one in found.differences]
        free = [number for number, one in enumerate(found.differences) if not one.protected]
        all_of_it = first and self._everything
        self._ticked = {number for number in free if all_of_it or places[number] in ticked}
        self._current = places.index(looked_at) if looked_at in places else None
        self._list()

    # looking

    @property
    def solid(self) -> SessionTracks | None:
        """The version that is drawn solid; None where these are the corrected tracks."""
        return self._solid

    @property
    def base_run(self) -> Run | None:
        """The run whose measurements are those of the solid version; None: no run's."""
        return None if self.base is None else self._session.runs[self.base]

    @property
    def dashed(self) -> TrackTable | None:
        """The run's rows under the ids of the other version; None until they are known."""
        return self._found.dashed if self._found is not None else None

    @property
    def current(self) -> Difference | None:
        """The difference that is looked at."""
        if self._found is None or self._current is None:
            return None
        return self._found.differences[self._current]

    @property
    def offers(self) -> bool:
        """Whether there is anything to take; two runs are looked at whether there is or not."""
        found = self._found.differences if self._found is not None else ()
        return self.base is not None or any(not one.protected for one in found)

    def choose(self, number: int) -> Difference | None:
        """Look at a difference."""
        if self._found is not None and 0 <= number < len(self._found.differences):
            self._current = number
        return self.current

    def walk(self, step: int) -> Difference | None:
        """The next (1) or the previous (-1) one of the list, around at its ends."""
        if not self._shown:
            return None
        if self._current in self._shown:
            place = (self._shown.index(self._current) + step) % len(self._shown)
        else:
            place = min(step, 0)
        return self.choose(self._shown[place])

    def tick(self, numbers: Iterable[int], on: bool) -> None:
        """Tick differences to be taken, or none of them; what is protected cannot be."""
        if self._found is None:
            return
        for number in numbers:
            if on and not self._found.differences[number].protected:
                self._ticked.add(number)
            else:
                self._ticked.discard(number)

    def tick_listed(self, on: bool) -> None:
        """Tick all that are listed, or none of them."""
        self.tick(self._shown, on)

    def narrow(self, person: int) -> None:
        """List what is about one person alone; 0 for all."""
        self.person = person
        self._list()

    def sort(self, order: DifferenceOrder) -> None:
        """List in another order."""
        self.order = order
        self._list()

    def first_shown(self, one: Difference, before: int) -> int:
        """The first frame from so many before a difference in which its people are there."""
        start = max(0, one.start - before)
        if self._found is None:
            return start
        frames = [rows["frame"] for rows in self._versions(one, start, one.end)]
        return int(min((part.min() for part in frames if len(part)), default=one.start))

    def concern_of(self, one: Difference, before: int) -> Concern | None:
        """Its people in both versions, for as long as they are looked at."""
        if self._found is None:
            return None
        start, end = self.first_shown(one, before), min(one.end, one.start + 2 * before + 1)
        versions = self._versions(one, min(start, one.start), end)
        rows = {name: np.concatenate([part[name] for part in versions]) for name in CONCERNED}
        return Concern(rows, min(start, one.start), max(end, start + 1))

    # taking

    def plan(self) -> Change:
        """The edit that takes what is ticked from the run: one step, undone as one.

        Raises:
            EditError: nothing is ticked, or the tracks are others by now.
        """
        session, chosen = self._session, self._chosen()
        return plan_take(
            session.tracks,
            session.labels,
            session.history,
            session.runs[self.run],
            self._frames,
            only=chosen,
            fps=self._fps,
        )

    def plans_from(self, number: int) -> list[Callable[[], Change]]:
        """What takes the ticked stretches of two compared runs from one of them, one by one.

        Each is planned when it is called, on the tracks as the one before has left them.
        """
        return [partial(self._plan_stretch, number, one) for one in self._chosen()]

    def _chosen(self) -> list[Difference]:
        if self._found is None or not self._ticked:
            raise EditError("Nothing is ticked: tick the differences to take")
        return [self._found.differences[number] for number in sorted(self._ticked)]

    def _plan_stretch(self, number: int, stretch: Difference) -> Change:
        """Take the people of a stretch from a run into the corrected tracks."""
        session, frames = self._session, (stretch.start, stretch.end)
        run = session.runs[number]
        about = self._corrected_ids(stretch)
        found = differences(
            session.tracks, session.labels, session.history, run, frames, fps=self._fps
        )
        only = [one for one in found if not one.protected and _is_about(one, about)]
        return plan_take(
            session.tracks,
            session.labels,
            session.history,
            run,
            frames,
            only=only,
            fps=self._fps,
        )

    def _corrected_ids(self, stretch: Difference) -> set[int]:
        """Who of the corrected tracks stands where the people of a stretch do."""
        corrected = rows_of_table(self._session.tracks, stretch.start, stretch.end)
        ids: set[int] = set()
        for rows in self._versions(stretch, stretch.start, stretch.end):
            mate = counterparts(Places.of(rows), Places.of(corrected))
            ids |= set(corrected["track"][mate[mate >= 0]].tolist())
        return ids

    # drawing

    def trails(self, frame: int, points_of: PointsOf) -> tuple[PreviewTrail, ...]:
        """The way of the people in question about a frame in both versions, solid and dashed."""
        looked_at = self.current
        if looked_at is None:
            return ()
        around = round(_AROUND_S * self._fps)
        return tuple(
            trail
            for solid, rows in zip(
                (True, False),
                self._versions(looked_at, max(0, frame - around), frame + around),
                strict=True,
            )
            for trail in self._trails(rows, points_of, solid)
        )

    def _versions(self, one: Difference, start: int, end: int) -> tuple[Columns, Columns]:
        """The rows of its people in both versions, in a half-open range of frames."""
        assert self._found is not None
        found = self._found
        return _rows_of(found.base, one, start, end), _rows_of(found.dashed, one, start, end)

    def _trails(self, rows: Columns, points_of: PointsOf, solid: bool) -> Iterable[PreviewTrail]:
        if not len(rows["track"]):
            return
        points = points_of(rows)
        known = np.isfinite(points).all(axis=1)
        for track in np.unique(rows["track"]).tolist():
            mine = known & (rows["track"] == track)
            if mine.any():
                yield PreviewTrail(points[mine], self._colour_of(track), solid)

    def scene(self, doing: str = "", share: float | None = None) -> DifferencesScene:
        """The comparison as it stands."""
        found = self._found.differences if self._found is not None else ()
        places = list(self._shown)
        return DifferencesScene(
            solid=self._side(self.base),
            dashed=self._side(self.run),
            items=tuple(self._item(number) for number in self._shown),
            current=places.index(self._current) if self._current in self._shown else -1,
            people=tuple(
                self._person(track) for track in sorted({t for one in found for t in one.tracks})
            ),
            person=self.person,
            order=self.order,
            ticked=len(self._ticked),
            takeable=sum(not one.protected for one in found),
            locked=sum(bool(one.protected) for one in found),
            can_drop=self._can_drop,
            doing=doing,
            share=share,
            text="" if found or doing else self._same_words(),
        )

    def _same_words(self) -> str:
        """What is said where nothing differs."""
        if self.base is not None:
            return tr("The two runs are equal in the frames of both.")
        return tr(
            "Nothing differs: the run agrees with the corrected tracks, and continues from the "
            "corrections."
        )

    @property
    def versions(self) -> tuple[str, str]:
        """What is drawn solid and what dashed, by name."""
        return self._side(self.base).title, self._side(self.run).title

    @property
    def _can_drop(self) -> bool:
        session = self._session
        last = self.run == len(session.runs) - 1
        return self.base is None and last and session.adopted_run != self.run

    def _person(self, track: int) -> ReviewPerson:
        return ReviewPerson(track, str(track), self._colour_of(track))

    def _side(self, number: int | None) -> Side:
        if number is None:
            return Side(tr("corrected tracks"), tr("corrected"), can_give=False)
        name = self._session.runs[number].tracker
        short = tr("run {n}", n=number)
        return Side(tr("{run} ({tracker})", run=short, tracker=name), short, can_give=True)

    def _item(self, number: int) -> DifferenceItem:
        assert self._found is not None
        one = self._found.differences[number]
        locked = tr("A person corrected or reviewed this: it stays as it is")
        return DifferenceItem(
            number=number,
            title=self._title(one),
            people=tuple(self._person(track) for track in one.tracks),
            when=span_text(one.start / self._fps, (one.end - 1) / self._fps),
            text=tr(one.text),
            ticked=number in self._ticked,
            locked=locked if one.protected else "",
        )

    def _title(self, one: Difference) -> str:
        """Its kind in a word; of who is gone at one end of their track alone, at which."""
        base = self._found.base if self._found is not None else None
        if one.kind != "removed" or base is None or one.track not in base:
            return tr(_KINDS.get(one.kind, one.kind))
        asked = self._frames or base.frame_range(one.track)
        ranges = (base.frame_range(one.track), self._session.runs[self.run].frames, asked)
        at_start = one.start <= max(start for start, _ in ranges)
        at_end = one.end >= min(stop for _, stop in ranges)
        if at_start == at_end:
            return tr("Gone")
        return tr("Later") if at_start else tr("Earlier")

    def _list(self) -> None:
        found: Sequence[Difference] = self._found.differences if self._found is not None else ()
        if self.person not in {track for one in found for track in one.tracks}:
            self.person = 0
        numbers = [n for n, one in enumerate(found) if self.person in (0, *one.tracks)]
        if self.order is DifferenceOrder.PERSON:
            numbers.sort(key=lambda number: (found[number].track, found[number].start))
        self._shown = tuple(numbers)


def _is_about(one: Difference, tracks: Collection[int]) -> bool:
    return one.kind == "added" or any(track in tracks for track in one.tracks)


def _same_place(one: Difference) -> tuple[object, ...]:
    return one.kind, one.tracks, one.start, one.end


def _rows_of(table: TrackTable, one: Difference, start: int, end: int) -> Columns:
    return table.of_tracks(one.tracks, start, end)
