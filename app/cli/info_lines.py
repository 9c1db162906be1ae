"""Facts of `info` as lines for people: names in words, numbers with their units."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

from app.core.fact_texts import fact_text, setting_text
from tracking.translation import N_, Message, joined, msg

_LONGEST, _LONGEST_FACT = 60, 4096
"""Letters of a setting, and of a line: the longest path of a file fits."""
_NAMES: Final = {
    "kind": N_("kind"),
    "path": N_("path"),
    "name": N_("name"),
    "recording": N_("recording"),
    "frames": N_("frames"),
    "fps": N_("frame rate"),
    "size": N_("size"),
    "duration": N_("duration"),
    "stereo": N_("stereo"),
    "depth": N_("stereo by depth"),
    "calibrated": N_("calibrated"),
    "ground": N_("ground"),
    "region": N_("region"),
    "truth_people": N_("people in the ground truth"),
    "tracks": N_("tracks"),
    "rows": N_("rows"),
    "edits": N_("edits"),
    "undone_edits": N_("undone edits"),
    "edits_waiting_in_journal": N_("edits waiting in journal"),
    "occluders": N_("occluders"),
    "lines": N_("lines"),
    "regions": N_("regions"),
    "reviewed_ranges": N_("reviewed ranges"),
    "described_tracks": N_("described tracks"),
    "decided_review_items": N_("decided review items"),
    "notes": N_("notes"),
    "created": N_("created"),
    "modified": N_("modified"),
    "software": N_("software"),
}
_SAID: Final[Mapping[str, Callable[[Any], str]]] = {
    "kind": lambda kind: msg("recording") if kind == "recording" else msg("session"),
    "size": lambda size: msg("{width} x {height} px", width=size[0], height=size[1]),
    "fps": lambda fps: msg("{fps:.6g} frames per second", fps=fps),
    "duration": lambda seconds: msg("{seconds:.6g} s", seconds=seconds),
    "ground": lambda ground: msg(
        "height {height:.6g} m, tilt {tilt:.6g} degrees, roll {roll:.6g} degrees", **ground
    ),
    "region": lambda share: msg("{share:.1%} of the left image", share=share),
}
"""Facts that are more than a number or a name."""


def lines_of(facts: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Name and value of each fact; each run and each kind of label has a line of its own."""
    for name, value in _lines(facts):
        yield name, _short(value, _LONGEST_FACT)


def _lines(facts: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    for name, value in facts.items():
        if name == "runs":
            for number, run in enumerate(value):
                yield msg("run {number}", number=number), _run(run)
                for note in run["notes"]:
                    yield msg("run {number}, note", number=number), note
        elif name == "labels":
            for part, counts in value["parts"].items():
                named = msg("{part} labels", part=msg(part.replace("_", "-")))
                yield named, msg("on {on}, off {off}, unsure {unsure}", **counts)
            yield from _lines({what: count for what, count in value.items() if what != "parts"})
        else:
            told = fact_text if value is None else _SAID.get(name, fact_text)
            yield msg(_NAMES.get(name, name)), told(value)


def _run(run: Mapping[str, Any]) -> Message:
    """How a run was made, in a line."""
    first, end = run["frames"]
    said: list[str] = [
        run["tracker"],
        msg("frames {first} to {last}", first=first, last=end - 1),
        msg("seed {seed}", seed=run["seed"]),
    ]
    if run["detector"]:
        own = run["detector_from"] == "file"
        said.append(
            msg(
                "file detector {detector}" if own else "built-in detector {detector}",
                detector=run["detector"],
            )
        )
    said += [_detections_line(given) for given in run["detections_input"]]
    for name, value in run["settings"].items():
        said.append(msg("{setting} {value}", setting=name, value=_short(setting_text(value))))
    return joined(", ", said)


def _detections_line(given: Mapping[str, Any]) -> str:
    """Whose boxes a run was given."""
    told = {
        "count": given["count"],
        "file": _short(given["file"]),
        "fingerprint": given["fingerprint"][:12],
    }
    if not given["network"]:
        return msg(
            "{count} boxes of {file} ({format}, {fingerprint})", format=given["format"], **told
        )
    if given["format"] == "appearance":
        return msg(
            "{count} crops described by {network} ({file}, {licence}, {fingerprint})",
            network=_short(given["network"]),
            licence=_short(given["licence"]),
            **told,
        )
    return msg(
        "{count} boxes of {network} ({file}, {licence}, {fingerprint})",
        network=_short(given["network"]),
        licence=_short(given["licence"]),
        **told,
    )


def _short(text: str, longest: int = _LONGEST) -> str:
    """Outlines of occluders, as a setting, are longer than anybody reads."""
    return (
        text.cut_by(lambda whole: _cut(whole, longest))
        if isinstance(text, Message)
        else _cut(text, longest)
    )


def _cut(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"
