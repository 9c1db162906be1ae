"""`restore`: a backup of a session, listed or restored."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import Any

from app.cli.output import print_json, print_line, say
from app.cli.sessions import refuse_read_only
from tracking.errors import SessionError
from tracking.session import (
    Backup,
    Session,
    check_backup,
    find_backups,
    list_backups,
    replace_damaged,
)
from tracking.translation import N_, count_msg, joined, msg


def run_accept(path: Path, *, as_json: bool) -> None:
    """Take a session that was found damaged as it is, so that it is told no more.

    Raises SessionError where it cannot be read, or another program has it.
    """
    with closing(Session.open(path)) as session:
        refuse_read_only(session, path)
        count = session.accept_damage()
        if count:
            session.save()
        else:
            say(msg("no damage of it is known; nothing was changed"))
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
        if not path.is_file() or not find_backups(path.resolve()):
            raise
        restored, kept = replace_damaged(path, number)
        say(msg("note: the file that could not be read is kept as {kept}", kept=kept))
        return restored
    with closing(session):
        check_backup(session.path or path, number)
        refuse_read_only(session, path, N_("{path} cannot be restored: {why}"))
        return session.restore(number)


def _print(path: Path, *, as_json: bool) -> None:
    if not path.is_file():
        raise SessionError("{path}: there is no such session; check the path", path=path)
    kept = list_backups(path)
    if as_json:
        print_json([_facts(backup) for backup in kept])
        return
    for backup in kept:
        print_line(_line(backup))
    if not kept:
        print_line(msg("no backup is kept yet; every save keeps the one before it"))


def _facts(backup: Backup) -> dict[str, Any]:
    return {
        "backup": backup.number,
        "saved": backup.saved or None,
        "size_bytes": backup.size_bytes,
        "edits": backup.edits,
        "undone_edits": backup.undone_edits,
        "tracks": backup.tracks,
        "path": str(backup.path),
        "problem": backup.problem or None,
        "damage": backup.damage or None,
    }


def _line(backup: Backup) -> str:
    if backup.problem:
        return msg("{number}  {problem}", number=backup.number, problem=backup.problem)
    when = backup.saved[:19].replace("T", " ")
    line = msg(
        "{number}  saved {when} UTC  {edits}, {tracks}  {size:.1f} MB",
        number=backup.number,
        when=when,
        edits=count_msg(backup.edits, "{n} edit", "{n} edits"),
        tracks=count_msg(backup.tracks, "{n} track", "{n} tracks"),
        size=backup.size_bytes / 2**20,
    )
    return joined("  ", filter(None, (line, backup.damage)))
