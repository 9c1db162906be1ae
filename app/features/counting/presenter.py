"""Counting in the open recording: what is asked for, what came of it, what the views show."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

from app.core.document.document import Document
from app.core.document.track_sources import SHOWN, list_track_sources, version_of
from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.core.scenes.flow_map import FlowScene
from app.core.scenes.labels import LINE_COLOUR, REGION_COLOUR, Tool
from app.core.tracks.frame_state import FrameState
from app.features.counting.flow_scene import flow_scene
from app.features.counting.plots import plots_of
from app.features.counting.scene import CountingScene, CountPlot, TallyRow
from app.features.counting.shape_texts import ShapeTexts, rows_at
from app.features.counting.subject import CountResult, CountSubject
from app.features.counting.tallies import Tallies, people_inside
from tracking.counting import PAPER_STEP_S, CountSettings, Occupancy, density_of
from tracking.tracks import Columns, CountingLine, Labels, Region

_MOST_STEPS = 40
_STEPS_S = (
    PAPER_STEP_S,
    1.0,
    2.0,
    5.0,
    10.0,
    15.0,
    30.0,
    60.0,
    120.0,
    300.0,
    600.0,
    1800.0,
    3600.0,
)


@dataclass(slots=True)
class CountingChoice:
    """What the user has chosen.

    Attributes:
        track_source: `SHOWN` or a run's number. settings: how it is counted.
        picked: the name of what is plotted, and whether it is a line; None: the first there is.
    """

    track_source: int = SHOWN
    settings: CountSettings = field(default_factory=CountSettings)
    picked: tuple[bool, str] | None = None


class CountingPresenter:
    """Says what is to be counted and makes the scenes of what was."""

    def __init__(self, document: Document) -> None:
        self._document = document
        recording = document.recording
        step_s = usual_step_s(recording.frame_count, recording.fps)
        self.choice = CountingChoice(settings=CountSettings(step_s))
        self.counted: CountResult | None = None
        self._refused: tuple[CountSubject, str] | None = None
        self._tallies: Tallies | None = None
        self._plots: tuple[tuple[object, int], tuple[CountPlot, ...]] = ((None, -1), ())
        self._flow: tuple[object, FlowScene | None] = (None, None)

    # what is counted

    @property
    def labels(self) -> Labels:
        """Those of the session; nothing without one."""
        session = self._document.session
        return Labels() if session is None else session.labels

    def current_subject(self, *, mapped: bool) -> CountSubject:
        """What is to be counted now."""
        labels, choice = self.labels, self.choice
        mapped = mapped and self._document.recording.view is not None
        track_source = self.track_source
        version = version_of(self._document, track_source)
        return CountSubject(
            track_source, version, labels.lines, labels.regions, choice.settings, mapped
        )

    @property
    def track_source(self) -> int:
        """`SHOWN` or the number of the run that is counted; a run that is gone is none."""
        session, track_source = self._document.session, self.choice.track_source
        return SHOWN if session is None or track_source >= len(session.runs) else track_source

    @property
    def frames(self) -> tuple[int, int]:
        """The frames that the tracks go over."""
        session, track_source = self._document.session, self.track_source
        if track_source != SHOWN and session is not None:
            return session.runs[track_source].frames
        return self._document.tracks.frames

    def take(self, counted: CountResult) -> None:
        """Show what was counted."""
        self.counted, self._refused = counted, None
        self._tallies = Tallies(counted.counts)

    def refuse(self, subject: CountSubject, error: Exception) -> None:
        """This cannot be counted, and why."""
        self.counted, self._tallies = None, None
        self._refused = (subject, explain(error))

    @property
    def refused(self) -> str:
        """Why what is wanted cannot be counted; "" where nothing says so."""
        if self._refused is None:
            return ""
        subject, why = self._refused
        wanted = self.current_subject(mapped=subject.mapped)
        return why if replace(wanted, version=subject.version) == subject else ""

    # what the views show

    def describe_shape(self, state: FrameState, tool: Tool, number: int) -> str:
        """What stands behind the name of a line or a region in a frame; "": nothing yet."""
        return self.shape_texts().describe(state, tool, number)

    def shape_texts(self) -> ShapeTexts:
        """The same of any frame, by what is counted now; what is drawn or counted later is not."""
        counted, labels = self.counted, self.labels
        known = counted is not None and self._tallies is not None and self._is_theirs(counted)
        places = [counted.place_of(line) for line in labels.lines] if counted and known else []
        return ShapeTexts(self._tallies, tuple(places), tuple(labels.regions), self._tracks)

    def scene(self, state: FrameState, doing: str) -> CountingScene:
        """The panel."""
        document, choice = self._document, self.choice
        rows = (*self._line_rows(state), *self._region_rows(state))
        picked = self._picked(rows)
        return CountingScene(
            rows=rows,
            picked=picked,
            tracks=list_track_sources(self._document),
            track_source=self.track_source + 1,
            step_s=choice.settings.step_s,
            least_step_s=least_step_s(document.recording.fps),
            jitter_m=choice.settings.jitter_m,
            jitter_px=choice.settings.jitter_px,
            jitters=self._jitters,
            plots=self._plots_of(rows, picked),
            counts=self._shown.counts if self._shown is not None else None,
            frame=state.frame,
            frame_count=document.recording.frame_count,
            fps=document.recording.fps,
            doing=doing,
            message=self._message(rows, picked),
        )

    def flow(self) -> FlowScene | None:
        """The flow map; None while there is none. The very same while it stays."""
        counted = self.counted
        found = counted.flow if counted is not None and self._is_theirs(counted) else None
        if self._flow[0] is not found:
            self._flow = (found, flow_scene(found) if found is not None else None)
        return self._flow[1]

    def _message(self, rows: tuple[TallyRow, ...], picked: int) -> str:
        if rows and self.refused:
            return self.refused
        if rows and self._shown is not None:
            return self._shown.why_not(rows[picked].is_line, rows[picked].name)
        if not rows:
            return tr(
                "Draw a counting line{line_key} or a region{region_key} to count who crosses "
                "it and who is inside, in the frame shown and over time.",
                line_key=in_brackets("labels.lines"),
                region_key=in_brackets("labels.regions"),
            )
        return ""

    # rows

    def _line_rows(self, state: FrameState) -> list[TallyRow]:
        return [
            self._line_row(number, line, state.frame)
            for number, line in enumerate(self.labels.lines)
        ]

    def _line_row(self, number: int, line: CountingLine, frame: int) -> TallyRow:
        so_far, counted = self._so_far(number, frame), self.counted
        place = counted.place_of(line) if counted is not None else None
        if so_far is None or counted is None or place is None:
            why = counted.why_not(True, line.name) if counted is not None else ""
            return TallyRow(line.name, True, LINE_COLOUR, ("", "", "", "", ""), why)
        whole = counted.counts.lines[place].totals
        cells = [
            tr("{now} of {most}", now=now, most=most)
            for now, most in zip(so_far, whole, strict=True)
        ]
        hint = tr(
            "{name}: {ahead} of {all_ahead} have passed forward so far, "
            "{back} of {all_back} backward",
            name=line.name,
            ahead=so_far[0],
            back=so_far[1],
            all_ahead=whole[0],
            all_back=whole[1],
        )
        return TallyRow(line.name, True, LINE_COLOUR, (*cells, "", "", ""), hint)

    def _region_rows(self, state: FrameState) -> list[TallyRow]:
        return [
            self._region_row(number, region, state)
            for number, region in enumerate(self.labels.regions)
        ]

    def _region_row(self, number: int, region: Region, state: FrameState) -> TallyRow:
        people = people_inside(region, self._rows(state))
        density = float(density_of(region, np.array([people]))[0])
        speed = self._speed(number, state.frame)
        cells = ("", "", str(people), _text(density, "{:.2f}"), _text(speed, "{:.2f}"))
        steps = self._person_steps(number)
        hint = tr("{name}: {people} inside now", name=region.name, people=people)
        if steps is not None:
            said = tr("{steps} person-steps in all", steps=steps)
            hint = f"{hint}; {said}"
        return TallyRow(region.name, False, REGION_COLOUR, cells, hint)

    def _so_far(self, number: int, frame: int) -> tuple[int, int] | None:
        """None while the line is not counted yet, or cannot be."""
        counted, lines = self.counted, self.labels.lines
        if counted is None or self._tallies is None or not self._is_theirs(counted):
            return None
        place = counted.place_of(lines[number]) if number < len(lines) else None
        return self._tallies.so_far(place, frame) if place is not None else None

    def _speed(self, number: int, frame: int) -> float:
        counted, within = self.counted, self._occupancy(number)
        if counted is None or within is None:
            return math.nan
        steps = counted.counts.steps
        time_s = np.array([frame / steps.fps])
        return float(within.mean_speed[steps.of_time(time_s)[0]])

    def _person_steps(self, number: int) -> int | None:
        within = self._occupancy(number)
        return within.person_steps if within is not None else None

    def _occupancy(self, number: int) -> Occupancy | None:
        """None while the region is not counted yet, or cannot be."""
        counted = self.counted
        if counted is None or not self._is_theirs(counted):
            return None
        return counted.occupancy_of(self.labels.regions[number])

    def _is_theirs(self, counted: CountResult) -> bool:
        """Whether it is of those who are wanted: the same, or a moment before."""
        return counted.subject.track_source == self.track_source

    @property
    def _shown(self) -> CountResult | None:
        """What was counted, where it is over what is drawn now."""
        counted, labels = self.counted, self.labels
        if counted is None or not self._is_theirs(counted):
            return None
        drawn = (labels.lines, labels.regions)
        return counted if (counted.subject.lines, counted.subject.regions) == drawn else None

    @property
    def _jitters(self) -> tuple[bool, bool]:
        """Whether there are lines on the floor, or none at all; and whether some in the picture."""
        in_picture = [line.in_picture for line in self.labels.lines]
        return not all(in_picture) or not in_picture, any(in_picture)

    def _rows(self, state: FrameState) -> Columns:
        """The rows of the frame of those who are counted."""
        return rows_at(state, self._tracks)

    @property
    def _tracks(self) -> Columns | None:
        """Those of the run that is counted; None: those that are shown."""
        session, source = self._document.session, self.track_source
        return None if source == SHOWN or session is None else session.runs[source].tracks

    # plots

    def _picked(self, rows: tuple[TallyRow, ...]) -> int:
        keys = [(row.is_line, row.name) for row in rows]
        if self.choice.picked in keys:
            return keys.index(self.choice.picked)
        return 0 if keys else -1

    def pick(self, is_line: bool, name: str) -> None:
        """Plot another line or region."""
        self.choice.picked = (is_line, name)

    def _plots_of(self, rows: tuple[TallyRow, ...], picked: int) -> tuple[CountPlot, ...]:
        counted = self._shown
        if counted is None or picked < 0:
            return ()
        if self._plots[0] != (counted, picked):
            counts, row = counted.counts, rows[picked]
            names = [(True, one.line.name) for one in counts.lines]
            names += [(False, one.region.name) for one in counts.regions]
            place = names.index((row.is_line, row.name)) if (row.is_line, row.name) in names else -1
            frame_count = self._document.recording.frame_count
            plots = plots_of(counts, place, frame_count, self.frames)
            self._plots = ((counted, picked), plots)
        return self._plots[1]


def least_step_s(fps: float) -> float:
    """The shortest step that can be chosen: a frame, rounded up to hundredths of a second."""
    return math.ceil(100 / fps - 1e-6) / 100


def usual_step_s(frame_count: int, fps: float) -> float:
    """A round step by which footage of this length gives a few dozen of them at most."""
    least_s = max(frame_count / fps / _MOST_STEPS, least_step_s(fps))
    return next((step for step in _STEPS_S if step >= least_s), max(_STEPS_S[-1], least_s))


def _text(number: float, form: str) -> str:
    return form.format(number) if math.isfinite(number) else ""
