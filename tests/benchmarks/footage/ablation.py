"""What each mechanism of a tracker is worth: `python -m tests.benchmarks.footage.ablation [...]`.

Each mechanism is left out, alone, by a setting or by what stands in its place, and the tracker runs
over footage of all kinds with several seeds. What is told is by how much the scores fall, on the
mean over recordings, and an interval of 95 %: from the differences between seeds, which is how much
of it may be chance; and on how many recordings anything changed, as a rule whose situation does not
arise cannot be judged. flow is not random: its seeds are two spacings of its points.

Figures are kept in docs/results/ablation.json as they come, and docs/results/ablation.md is written
from them.
"""

from __future__ import annotations

import argparse
import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.stats import t as student

from tests.benchmarks.command import one_core, parser_of, real_data, telling
from tests.benchmarks.footage.measures import Figures, figures_of
from tests.benchmarks.footage.mechanisms import MECHANISMS, Mechanism
from tests.benchmarks.footage.recordings import REAL, Footage, all_footage
from tests.benchmarks.pages import DOCS, template
from tests.benchmarks.runner import Case, KeptRun, observations, replacing, runs_over, sources
from tracking.people import Observation
from tracking.pipeline import KeptSteps
from tracking.recording import Recording
from tracking.settings import settings_values
from tracking.trackers import tracker_named
from tracking.tracks.columns import PARTICLE_COLUMNS, empty

FIGURES = DOCS / "results" / "ablation.json"
PAGE = DOCS / "results" / "ablation.md"
SEEDS = (11, 12)
"""Not those of the bench."""
FRAMES = {"steps": (80, 300), "finishing": (200, 300)}
"""Of each recording, real or rendered, from the first, by group of mechanisms: those of steps take
a run each. Rendered scenes are empty at first."""
FOOTAGE = (
    *("towncentre-real", "pets-s2l1-real", "tud-campus-real", "overhead-real"),
    *("rendered-corridor", "rendered-lobby", "rendered-ceiling"),
    *("own-plaza", "own-pillars", "own-corridor"),
)
WITH_ALL = "everything"
"""The row of the tracker as it is."""

Mechanisms = Sequence[Mechanism | None]
Scores = dict[str, Any]
Found = dict[str, dict[str, list[Scores]]]
Group = tuple[str, tuple[Mechanism, ...]]

SCORES = ("MOTA", "IDF1", "box MOTA", "box HOTA")
"""What mechanisms are judged by: on the floor, in boxes where nothing is known of it; in boxes."""


_DIGITS = 5
"""Of scores that are kept."""


def scores_of(figures: Figures) -> Scores:
    """Of one run; where people are only marked by eye, the share of them found is every score."""
    boxes = figures.get("boxes")
    if boxes is None:
        walkers = figures["walkers"]
        return dict.fromkeys(SCORES, walkers["found"] / walkers["of"])
    best = figures.get("floor") or boxes
    both = ((best, "MOTA"), (best, "IDF1"), (boxes, "MOTA"), (boxes, "HOTA"))
    named = zip(SCORES, both, strict=True)
    return {name: round(its[key] or 0.0, _DIGITS) for name, (its, key) in named}


@dataclass(frozen=True, slots=True)
class Worth:
    """By how much scores fall without a mechanism.

    Attributes:
        mean: over recordings and seeds.
        error: half the length of an interval of 95 % of the mean.
    """

    mean: float
    error: float

    @property
    def is_sure(self) -> bool:
        """Whether chance does not explain it."""
        return abs(self.mean) > self.error


def worth_of(with_all: Sequence[Sequence[float]], without: Sequence[Sequence[float]]) -> Worth:
    """The worth of a mechanism by scores (recordings, seeds) with it and without.

    The variance of each recording's mean difference follows from its seeds, pooled over
    recordings.
    """
    fall = np.asarray(with_all, float) - np.asarray(without, float)
    recordings, seeds = fall.shape
    if seeds < 2:
        return Worth(float(fall.mean()), float("inf"))
    freedom = recordings * (seeds - 1)
    variance = fall.var(axis=1, ddof=1).mean() / (recordings * seeds)
    return Worth(float(fall.mean()), float(student.ppf(0.975, freedom) * np.sqrt(variance)))


def measure(tracker: str, mechanisms: Mechanisms, footage: Sequence[Footage], asked: Any) -> Found:
    """Scores by mechanism and recording, one a seed; None is the tracker with all of them."""
    found: Found = {}
    for recording in footage:
        for mechanism, case in _cases(tracker, mechanisms, recording, asked):
            run = runs_over(recording.folder, [case])[case]
            _add(found, mechanism, recording, run)
    return found


def measure_together(
    tracker: str, mechanisms: Mechanisms, footage: Sequence[Footage], asked: Any
) -> Found:
    """The same of mechanisms of finishing, and of a stereo tracker's steps: seen, stepped once."""
    found: Found = {}
    for recording in footage:
        cases = _cases(tracker, mechanisms, recording, asked)
        with telling(f"{recording.name} by {tracker}"), recording.open() as opened:
            steps = _steps_over(opened, sorted({*map(_stepped, cases)}, key=repr))
            for mechanism, case in cases:
                own = steps[_stepped((mechanism, case))]
                with replacing(case.replaced):
                    run = own.run(tracker, settings_values(case.chosen()), case.seed, opened)
                times = {name: np.array([float(own.frames[1])]) for name in _TIMES}
                _add(found, mechanism, recording, KeptRun(run, times))
    return found


_TIMES = ("frames", "seeing_s", "following_s")


def _add(found: Found, mechanism: Mechanism | None, recording: Footage, run: KeptRun) -> None:
    """Add a run's scores; tracks that were scored before are not scored again."""
    name = WITH_ALL if mechanism is None else mechanism.name
    columns = (np.ascontiguousarray(column).tobytes() for column in run.tracks.values())
    tracks = hashlib.sha256(b"".join(columns)).hexdigest()[:8]
    rows = (one for its in found.values() for one in its.get(recording.name, ()))
    known = next((one for one in rows if one["tracks"] == tracks), None)
    scores = known or {**scores_of(figures_of(recording, run)), "tracks": tracks}
    found.setdefault(name, {}).setdefault(recording.name, []).append(scores)


def _cases(
    tracker: str, mechanisms: Mechanisms, recording: Footage, asked: Any
) -> list[tuple[Mechanism | None, Case]]:
    frames = asked.frames[recording.kind != REAL]
    return [(one, _case(tracker, one, seed, frames)) for seed in asked.seeds for one in mechanisms]


def _stepped(one: tuple[Mechanism | None, Case]) -> Case:
    """The case whose steps a mechanism's run is finished from."""
    mechanism, case = one
    finishing = mechanism is not None and mechanism.finishing
    return _case(case.tracker, None, case.seed, case.frames) if finishing else case


def _steps_over(recording: Recording, cases: Sequence[Case]) -> dict[Case, KeptSteps]:
    """The steps of cases that perceive alike.

    A stereo tracker's frames are looked at once; another one tells its perception of people.
    """
    spec, seen = tracker_named(cases[0].tracker), list[Observation]()
    steps = {case: KeptSteps() for case in cases}
    for case in cases:
        with replacing(case.replaced):
            perception, tracker = spec.build(recording, case.chosen(), case.seed)
            wanted = min(case.frames or recording.frame_count, recording.frame_count)
            frames = observations(recording, perception, wanted)
            if spec.needs_stereo:
                seen = seen or list(frames)
            for one in seen or frames:
                step = tracker.step(one)
                steps[case].add([replace(step, particles=empty(PARTICLE_COLUMNS))])
    return steps


def _case(tracker: str, mechanism: Mechanism | None, seed: int, frames: int) -> Case:
    settings = () if tracker != "flow" else (("points.spacing", 0.2 + 0.002 * (seed % 2)),)
    if mechanism is None:
        return Case(tracker, settings, "", seed, frames)
    return Case(tracker, settings + mechanism.settings, "", seed, frames, mechanism.replaced)


def groups_of(tracker: str) -> tuple[Group, Group]:
    """A tracker's mechanisms: those that are run one by one, and those that share a pass."""
    stereo = tracker_named(tracker).needs_stereo
    together = [m for m in MECHANISMS[tracker] if m.finishing or (stereo and not m.seeing)]
    others = tuple(m for m in MECHANISMS[tracker] if m not in together)
    return ("steps", others), ("finishing", tuple(together))


def rows_of(figures: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Of each mechanism measured with the tracker as it is: its worth by kind of footage.

    Args:
        figures: by tracker, group of mechanisms, mechanism and recording, one a seed.
    """
    for tracker, groups in figures.items():
        for group, mechanisms in groups_of(tracker):
            its = groups.get(group, {})
            for mechanism in mechanisms:
                if mechanism.name in its and WITH_ALL in its:
                    worths = _worths(its[WITH_ALL], its[mechanism.name])
                    worths |= {"group": group, "recordings": sorted(its[mechanism.name])}
                    yield {
                        "tracker": tracker,
                        "name": mechanism.name,
                        "what": mechanism.what,
                    } | worths


def _worths(whole: Mapping[str, Any], without: Mapping[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for score in SCORES:
        for kind, chosen in _KINDS.items():
            rows = [r for r in without if r in whole and r.startswith(chosen)]
            both = ([[one[score] for one in which[r]] for r in rows] for which in (whole, without))
            found[f"{score} {kind}"] = worth_of(*both) if rows else None
    changed = [r for r in without if r in whole and not _is_same(whole[r], without[r])]
    return found | {"changed": len(changed)}


def _is_same(one: Sequence[Scores], other: Sequence[Scores]) -> bool:
    return all(a["tracks"] == b["tracks"] for a, b in zip(one, other, strict=True))


_KINDS: Mapping[str, tuple[str, ...]] = {
    "all": ("",),
    "real": ("town", "pets", "tud", "office", "overhead"),
    "other": ("rendered-",),
    "own": ("own-",),
}
"""Beginnings of the names of recordings of a kind."""


def figures() -> dict[str, Any]:
    """What has been measured."""
    if not FIGURES.is_file():
        return {}
    return dict(json.loads(FIGURES.read_text(encoding="utf-8")))


def _keep(asked: Any, found: Found) -> None:
    """Keep figures beside those of the same group, unless these are of other frames.

    What was measured again, on other recordings or with other seeds, stays apart.
    """
    kept, tracker = figures(), asked.tracker
    if asked.again:
        again = {"tracker": tracker, "seeds": [*asked.seeds], "frames": [*asked.frames]}
        kept.setdefault("again", []).append({**again, "found": found})
    else:
        frames = kept.setdefault("frames", {}).setdefault(tracker, {})
        if frames.get(asked.group) != [*asked.frames]:
            kept.setdefault(tracker, {}).pop(asked.group, None)
        frames[asked.group] = [*asked.frames]
        kept.setdefault(tracker, {}).setdefault(asked.group, {}).update(found)
    kept["sources"] = {**kept.get("sources", {}), tracker: sources()[:16]}
    FIGURES.write_text(json.dumps(kept, separators=(",", ":")) + "\n", encoding="utf-8")


def write_page() -> None:
    """Write the page from what was measured."""
    kept = figures()
    rows = list(rows_of({name: its for name, its in kept.items() if name in MECHANISMS}))
    again = [
        {**one, "name": name, "recordings": sorted(its), **_worths(one["found"][WITH_ALL], its)}
        for one in kept.get("again", [])
        for name, its in one["found"].items()
        if name != WITH_ALL
    ]
    known = {"again": again, "groups": _GROUPS, "frames": kept.get("frames", {}), "seeds": SEEDS}
    text = template("footage/ablation.md.j2").render(
        rows=rows, removed=kept.get("removed", []), **known
    )
    PAGE.write_text(text, encoding="utf-8")


_GROUPS = {
    "steps": "Rules that change what the tracker does frame by frame.",
    "finishing": "Rules of finishing a run, and others that are tried on the same frames.",
}


def _lines(row: Mapping[str, Any]) -> str:
    """The worths of a mechanism, those beyond chance with a star."""
    lines = [
        f"{row['tracker']}: {row['name']} (changes {row['changed']} of {len(row['recordings'])})"
    ]
    for score in SCORES:
        cells = [f"{kind} {_cell(row[f'{score} {kind}'])}" for kind in _KINDS]
        lines.append(f"    {score:<9} " + "  ".join(cells))
    return "\n".join(lines)


def _cell(worth: Worth | None) -> str:
    if worth is None:
        return "-"
    return f"{worth.mean:+.4f} ± {worth.error:.4f}{'*' if worth.is_sure else ' '}"


def _options() -> argparse.Namespace:
    parser = parser_of("footage.ablation", __doc__)
    parser.add_argument("--tracker", choices=MECHANISMS, required=True)
    parser.add_argument("--group", choices=FRAMES, help="these mechanisms only")
    parser.add_argument("--only", nargs="+", metavar="MECHANISM", help="these, by their names")
    parser.add_argument("--footage", nargs="+", default=FOOTAGE, metavar="NAME")
    parser.add_argument("--seeds", nargs="+", type=int, default=SEEDS)
    parser.add_argument(
        "--frames", type=int, nargs=2, metavar="N", help=f"of real and rendered ones: {FRAMES}"
    )
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    parser.add_argument("--report", action="store_true", help="keep the figures, write the page")
    parser.add_argument("--again", action="store_true", help="keep them in a table of their own")
    parser.add_argument("--rewrite", action="store_true", help="only write the page")
    return parser.parse_args()


def main() -> None:
    """Read the command line, measure, print or keep."""
    one_core()
    asked = _options()
    if asked.rewrite:
        write_page()
        return
    there = [o for o in all_footage(asked.data, asked.footage) if o.suits(asked.tracker)]
    for group, known in groups_of(asked.tracker):
        if asked.group not in (None, group):
            continue
        chosen = [m for m in known if not asked.only or m.name in asked.only]
        if not chosen:
            continue
        own = argparse.Namespace(**{**vars(asked), "group": group})
        own.frames = asked.frames or FRAMES[group]
        for found in _portions(own, chosen, there):
            if asked.report:
                _keep(own, found)
            told = {asked.tracker: {group: found}}
            print(*(_lines(row) for row in rows_of(told)), sep="\n", flush=True)
    if asked.report:
        write_page()


def _portions(asked: Any, chosen: Sequence[Mechanism], there: Sequence[Footage]) -> Iterator[Found]:
    """What is found, as it comes."""
    if asked.group == "finishing":
        yield measure_together(asked.tracker, [None, *chosen], there, asked)
        return
    whole = measure(asked.tracker, [None], there, asked)
    for mechanism in chosen:
        with telling(f"{asked.tracker} without {mechanism.name}"):
            yield whole | measure(asked.tracker, [mechanism], there, asked)


if __name__ == "__main__":
    main()
