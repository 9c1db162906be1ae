"""`log`: what people did to a session."""

from __future__ import annotations

from pathlib import Path

from app.cli.destination import check_file, check_text_replaced
from app.cli.output import (
    STDOUT,
    print_json,
    print_line,
    print_pieces,
    progress,
    refuse_two_documents,
    text_at,
)
from tracking.editing import Entry, History
from tracking.session import log_as_json, read_history, write_log_csv
from tracking.translation import msg


def run_log(path: Path, csv: Path | None, *, as_json: bool) -> None:
    """Print the log of edits, oldest first, or write it as CSV.

    Edits that wait in the journal are there too; another program may have the session open.
    """
    if csv is None:
        history = read_history(path)
        if as_json:
            print_pieces(log_as_json(history))
            return
        for entry in history:
            print_line(_line(history, entry))
        if not len(history):
            print_line(msg("no edits yet"))
        return
    refuse_two_documents(csv, "--csv", as_json=as_json)
    if csv != STDOUT:
        check_file(csv)
        check_text_replaced(csv, "--csv")
    history = read_history(path)
    with text_at(csv) as place, progress(msg("writing the log")) as told:
        write_log_csv(history, place, told)
    if as_json:
        print_json({"written": str(csv), "edits": len(history)})
    elif csv != STDOUT:
        print_line(csv)


def _line(history: History, entry: Entry) -> str:
    """An edit as it is printed."""
    taker = history.taken_back_by(entry.id)
    text = entry.text
    if entry.undone:
        text = msg("{text} (undone)", text=text)
    elif taker:
        text = msg("{text} (undone by {taker})", text=text, taker=taker)
    return msg(
        "{id:>6}  {time}  {author}  frame {frame}  {text}",
        id=entry.id,
        time=entry.time[:19],
        author=entry.author or "-",
        frame=entry.frame,
        text=text,
    )
