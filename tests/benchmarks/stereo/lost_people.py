"""Who was not kept, and why.

`python -m tests.benchmarks.stereo.lost_people CLIP... [--tracker NAME]`: a line for each person
of rendered clips (folders with truth.txt and visibility.csv) who was detected and not kept, or
seen for a second and never detected: what went wrong first, in which frames, with whom, and what
was in the way. Frames count from 0. The counts come last.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from tests.benchmarks.command import one_core, parser_of
from tests.benchmarks.runner import Case, run_of
from tests.benchmarks.stereo.reasons import NotKept, not_kept
from tests.benchmarks.stereo.truth import truth_of
from tracking.settings import settings_from_text, settings_values
from tracking.trackers import tracker_named


def main() -> None:
    """Track the clips and print who was not kept."""
    parser = parser_of("stereo.lost_people", __doc__)
    parser.add_argument("clips", nargs="+", type=Path, metavar="CLIP", help="folder of a clip")
    parser.add_argument("--tracker", default="stereo-joint", help="in the catalogue")
    parser.add_argument(
        "--set", action="append", default=[], metavar="NAME=VALUE", help="a setting of the tracker"
    )
    asked = parser.parse_args()
    one_core()
    texts = dict(text.split("=", 1) for text in asked.set)
    values = settings_values(settings_from_text(tracker_named(asked.tracker).settings_type, texts))
    case = Case(asked.tracker, tuple((name, values[name]) for name in texts))
    everybody: list[NotKept] = []
    for folder in asked.clips:
        found = not_kept(truth_of(folder), run_of(folder, case).tracks)
        print(*(f"{folder.name} {line(one)}" for one in found), sep="\n", flush=True)
        everybody += found
    print(*counted(everybody), sep="\n")


def line(one: NotKept) -> str:
    """A person who was not kept, on one line."""
    around = one.context
    other = f" with {one.other}" if one.other else ""
    beside = f" {around.neighbour}" if around.neighbour else ""
    return (
        f"person {one.person:3d}: {one.what}{other}, frames {one.last}-{one.frame}, "
        f"track {one.tracks[0]}->{one.tracks[1]}, {around.where}{beside}, "
        f"{100 * around.share:.0f} % seen"
    )


def counted(everybody: list[NotKept]) -> list[str]:
    """How often what went wrong where."""
    often = Counter((one.what, one.context.where) for one in everybody)
    return [f"{number:4d} {what}, {where}" for (what, where), number in often.most_common()]


if __name__ == "__main__":
    main()
