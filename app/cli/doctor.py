"""`doctor`: what is wrong with a recording, or with this installation."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import cv2
import typer

from app.cli.destination import check_folder, is_session, nearest_folder
from app.cli.installation import Check, check_installation, check_sessions
from app.cli.option_groups import Bare
from app.cli.output import print_json, print_line, print_table, progress, say
from app.cli.recordings import open_with_options
from tracking.atomic_output import replace_with
from tracking.doctor import Examination, examine, mend
from tracking.recording import Recording
from tracking.session.info import describe
from tracking.translation import joined, msg, tr


def run_doctor(
    path: Path | None, code: str | None, pictures: Path | None, *, as_json: bool
) -> None:
    """Examine, mend what is asked for, and print what was found."""
    if path is None:
        if code is not None or pictures is not None:
            raise typer.BadParameter(msg("name a recording"), param_hint="RECORDING")
        _print_checks(list(check_installation()), as_json=as_json)
        return
    if path.is_file() and is_session(path):
        if code is not None or pictures is not None:
            raise typer.BadParameter(msg("name a recording"), param_hint="RECORDING")
        _print_session(path, as_json=as_json)
        return
    if pictures is not None:
        check_folder(nearest_folder(pictures))
    with open_with_options(path, Bare()) as recording:
        with progress(msg("reading frames")) as tell:
            examination = examine(recording, tell)
        if pictures is not None:
            _save_pictures(pictures, examination)
        if code is not None:
            _mend(recording, examination, code)
    if as_json:
        print_json(as_document(examination))
    else:
        _print(examination)


def _mend(recording: Recording, examination: Examination, code: str) -> None:
    finding = next((one for one in examination.findings if one.code == code), None)
    if finding is None:
        found = ", ".join(one.code for one in examination.findings) or msg("none")
        raise typer.BadParameter(
            msg("{code!r} was not found here; findings: {found}", code=code, found=found),
            param_hint="--mend",
        )
    for path in mend(recording, finding):
        say(msg("written: {path}", path=path))


def as_document(examination: Examination) -> dict[str, Any]:
    """As the contract names it."""
    return {
        "findings": [
            {
                "code": one.code,
                "title": tr(one.title),
                "evidence": dict(one.evidence),
                "cost_m": one.cost_m,
                "alike": list(one.alike),
                "fix": tr(one.fix),
                "fixable": one.mend is not None,
            }
            for one in examination.findings
        ],
        "checked": list(examination.checked),
        "unchecked": {code: tr(why) for code, why in examination.unchecked.items()},
    }


def _print(examination: Examination) -> None:
    if not examination.findings and examination.is_partial:
        print_line(
            msg(
                "nothing was found, but {count} of {all} checks could not be made",
                count=len(examination.unchecked),
                all=len(examination.unchecked) + len(examination.checked),
            )
        )
    elif not examination.findings:
        print_line(msg("nothing is wrong, as far as the pictures tell"))
    for one in examination.findings:
        print_line(joined(": ", (one.code, one.title)))
        rows: list[tuple[str, object]] = [
            (msg("cost"), msg("{metres:.2f} m on the floor at 5 m", metres=one.cost_m)),
            (msg("what to do"), one.fix),
        ]
        if one.alike:
            rows.append((msg("looks the same"), ", ".join(one.alike)))
        if one.mend is not None:
            rows.append((msg("mend it"), f"--mend {one.code}"))
        rows += [(name, _figure(value)) for name, value in one.evidence.items()]
        print_table([(f"  {tr(name)}", value) for name, value in rows])
    for code, why in examination.unchecked.items():
        say(msg("not checked: {code}: {why}", code=code, why=why))


def _figure(value: float | int | str) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _save_pictures(folder: Path, examination: Examination) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for one in examination.findings:
        if one.picture is not None:
            path = folder / f"{one.code}.png"
            replace_with(path, cv2.imencode(".png", one.picture)[1].tobytes())
            say(msg("written: {path}", path=path))


def _print_session(path: Path, *, as_json: bool) -> None:
    """What is odd with a session; one that cannot be read raises SessionError."""
    checks = list(check_sessions([path]))
    if not checks:
        describe(path)
        checks = [Check(msg("session {name}", name=path.name), True, msg("opens as it should"))]
    _print_checks(checks, as_json=as_json)


def _print_checks(checks: Sequence[Check], *, as_json: bool) -> None:
    if as_json:
        wrong = [
            {
                "code": one.name, "title": tr(one.said), "evidence": {}, "cost_m": 0.0,
                "fix": tr(one.said), "fixable": False, "needed": one.needed,
            }
            for one in checks if not one.is_well
        ]  # fmt: skip
        print_json({"findings": wrong, "checked": [one.name for one in checks]})
        return
    states = {(True, True): msg("ok"), (False, True): msg("WRONG"), (False, False): msg("missing")}
    print_table(
        [
            (one.name, joined(": ", (states[one.is_well, one.needed or one.is_well], one.said)))
            for one in checks
        ]
    )
