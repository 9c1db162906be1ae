"""`log`: what people did to a session."""

from __future__ import annotations

import sys
from pathlib import Path

from app.cli.destination import check_file, check_text_replaced
from app.cli.output import print_json, progress
from tracking.editing import Entry, History
from tracking.session import log_as_json, read_history, write_log_csv


def run_log(path: Path, csv: Path | None, *, as_json: bool) -> None:
    """Print the log of edits, oldest first, or write it as CSV.

    Edits that wait in the journal are there too; another program may have the session open.
    """
    if csv is None:
        history = read_history(path)
        if not as_json and not len(history):
            print("no edits yet")
        lines = log_as_json(history) if as_json else (_line(history, entry) for entry in history)
        sys.stdout.writelines(lines)
        return
    check_file(csv)
    check_text_replaced(csv, "--csv")
    history = read_history(path)
    with progress("writing the log") as told:
        write_log_csv(history, csv, told)
    if as_json:
        print_json({"written": str(csv), "edits": len(history)})
    else:
        print(csv)


def _line(history: History, entry: Entry) -> str:
    """An edit as it is printed: one line, whatever its text holds."""
    taker = history.taken_back_by(entry.id)
    fate = "undone" if entry.undone else f"taken back by {taker}" if taker else ""
    text = f"{entry.text} ({fate})" if fate else entry.text
    line = f"{entry.id:>6}  {entry.time[:19]}  {entry.author or '-'}  frame {entry.frame}  {text}"
    return "".join(sign if sign.isprintable() else " " for sign in line) + "\n"
