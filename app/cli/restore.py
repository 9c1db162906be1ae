"""`restore`: a backup of a session, listed or had back."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import Any

from app.cli.output import print_json, print_line, say
from tracking.errors import SessionError
from tracking.recording.plurals import counted
from tracking.session import (
    Generation,
    Session,
    check_generation,
    generations,
    list_generations,
    replace_damaged,
)


def run_accept(path: Path, *, as_json: bool) -> None:
    """Take a session that was found damaged as it is, so that it is told no more.

    Raises SessionError where it cannot be read, or another program has it.
    """
    with closing(Session.open(path)) as session:
        _refuse_read_only(session, path, "changed")
        count = session.accept_damage()
        if count:
            session.save()
        else:
            say("no damage of it is known; nothing was changed")
    if as_json:
        print_json({"accepted": count, "session": str(path)})
    else:
        print_line(path)


def run_restore(path: Path, number: int, *, only_list: bool, as_json: bool) -> None:
    """List the backups that are kept, or put one in the session's place.

    What the session is now, with edits that were never saved, becomes the newest backup; a
    file that cannot be read is kept beside it instead.
    Raises SessionError where there is none of that number, or another program has the session.
    """
    if only_list:
        _print(path, as_json=as_json)
        return
    with closing(_restored(path, number)) as restored:
        edits = sum(not entry.undone for entry in restored.history)
    if as_json:
        print_json({"restored": number, "session": str(path), "edits": edits})
    else:
        print_line(path)


def _restored(path: Path, number: int) -> Session:
    """The session as it was; where it cannot be opened, its backup takes its place."""
    try:
        session = Session.open(path)
    except SessionError:
        if not path.is_file() or not generations(path.resolve()):
            raise
        restored, kept = replace_damaged(path, number)
        say(f"note: the file that could not be read is kept as {kept}")
        return restored
    with closing(session):
        check_generation(session.path or path, number)
        _refuse_read_only(session, path, "restored")
        return session.restore(number)


def _refuse_read_only(session: Session, path: Path, what: str) -> None:
    if session.read_only:
        why = session.why_read_only.removeprefix(f"{session.path}: ")
        raise SessionError(f"{path} cannot be {what}: {why}")


def _print(path: Path, *, as_json: bool) -> None:
    if not path.is_file():
        raise SessionError(f"{path}: there is no such session; check the path")
    kept = list_generations(path)
    if as_json:
        print_json([_facts(generation) for generation in kept])
        return
    for generation in kept:
        print_line(_line(generation))
    if not kept:
        print_line("no backup is kept yet; every save keeps the one before it")


def _facts(generation: Generation) -> dict[str, Any]:
    return {
        "generation": generation.number,
        "saved": generation.saved or None,
        "size_bytes": generation.size_bytes,
        "edits": generation.edits,
        "undone_edits": generation.undone_edits,
        "tracks": generation.tracks,
        "path": str(generation.path),
        "problem": generation.problem or None,
        "damage": generation.damage or None,
    }


def _line(generation: Generation) -> str:
    if generation.problem:
        return f"{generation.number}  {generation.problem}"
    when = generation.saved[:19].replace("T", " ")
    size = f"{generation.size_bytes / 2**20:.1f} MB"
    held = f"{counted(generation.edits, 'edit')}, {counted(generation.tracks, 'track')}"
    line = f"{generation.number}  saved {when} UTC  {held}  {size}"
    return f"{line}  {generation.damage}" if generation.damage else line
