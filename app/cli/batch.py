"""`batch`: many recordings, on this machine, on a cluster, or as shards of an array job."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence, Set
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import typer

from app.cli.batch_progress import BatchProgress
from app.cli.option_groups import Cost, EachRecording, Order, Sharing, TrackerChoice
from app.cli.output import print_json, print_line, print_lines, say
from app.cli.setting_texts import pairs_of
from tracking.batch import (
    BatchOrder,
    BatchRun,
    BatchState,
    Entry,
    Found,
    Ledger,
    Limits,
    LocalWorkers,
    Outcome,
    Shard,
    State,
    StateFile,
    Workers,
    array_script,
    batch_folder,
    find_recordings,
    ledger_path,
    merge_shard,
    named_entries,
    read_rows,
    report_path,
    shard_of,
    write_batch_report,
)
from tracking.errors import RecordingError, SettingsError
from tracking.translation import Message, count_msg, joined, msg

SOME_FAILED = 3
NONE_DONE = 1
_LEAST_MEMORY_BYTES = 1 << 30
_MEMORY_SHARE = 0.8
"""Of the machine's, which all workers may have together."""
_SCRIPT_MINUTES, _SCRIPT_MEMORY_MB, _PROGRAM_MB = 24 * 60, 4096, 1024


@dataclass(frozen=True, slots=True)
class BatchRequest:
    """What is to be done, as typed.

    Attributes:
        words: recordings, folders, patterns, lists. out: the output folder.
        listed: a file with more of them; None: none.
        retry, force, allow_outside: see `Planner` and `BatchOrder`.
    """

    words: tuple[str, ...]
    out: Path
    listed: Path | None
    choice: TrackerChoice
    each: EachRecording
    sharing: Sharing
    cost: Cost
    retry: bool
    force: bool
    allow_outside: bool

    @property
    def order(self) -> Order:
        """The tracker, for what asks for one recording's."""
        typed = self.choice
        return Order(typed.tracker, typed.setting, typed.seed, typed.detector, typed.model)


def run_batch(request: BatchRequest, *, as_json: bool) -> None:
    """Do what is left of the batch, and tell what became of every recording.

    Raises:
        SettingsError: there is no such tracker or setting. RecordingError: nothing is named.
        OutputError: the output folder cannot be used, or another batch works in it.
        SystemExit: not all is done.
    """
    order = _batch_order(request)
    if request.sharing.job_array is not None:
        words = _words_without(sys.argv[1:], "--job-array")
        limit_mb = request.cost.memory_limit
        # The limit is of what a recording adds; the job also holds the program itself.
        memory_mb = _SCRIPT_MEMORY_MB if not limit_mb else round(1.25 * limit_mb) + _PROGRAM_MB
        script = array_script(
            [sys.argv[0], *words], request.sharing.job_array, _SCRIPT_MINUTES, memory_mb
        )
        print_lines(script.rstrip("\n"))
        return
    shard = parse_shard(request.sharing.shard)
    out = Path(os.path.abspath(request.out))  # noqa: PTH100 - links stay
    found = _found(request, out)
    if not ledger_path(out, shard).exists():
        _check_order(request)  # nothing is left behind of what is wrongly asked for
    with batch_folder(out, shard) as ledger:
        entries = _entries(found, ledger, out, shard)
        entries = entries if shard is None else shard_of(entries, shard.number, shard.count)
        missing = _missing(found)
        shown = BatchProgress(state for state, _ in missing.values())
        outcomes, worked = _worked(request, order, ledger, out, entries, shard, shown)
        page = report_path(out)
        if shard is not None:
            merge_shard(ledger, out)
        elif worked or missing or not page.exists():
            write_batch_report(ledger, out, missing)
    told = shown.told if _one_place() else frozenset()
    _tell(entries, outcomes, missing, page, told, as_json=as_json)


def parse_shard(text: str | None) -> Shard | None:
    """The shard that is typed as, say, 2/8; None: no shard. Raises BadParameter."""
    if text is None:
        return None
    number, _, count = text.partition("/")
    if number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count):
        return Shard(int(number), int(count))
    reason = msg("{text!r} is no shard: give i/n with i from 1 to n, e.g. 2/8", text=text)
    raise typer.BadParameter(reason, param_hint="--shard")


def _batch_order(request: BatchRequest) -> BatchOrder:
    """What is asked for, as it was typed. Raises as `run_batch`."""
    typed = request.order
    if typed.detector is not None or typed.model is not None:
        from app.cli.part_options import texts_of_options  # takes long to import

        texts = texts_of_options(typed)
    else:
        texts = tuple(typed.setting or ())
    return BatchOrder(
        typed.tracker or "",
        tuple(pairs_of(texts).items()),
        typed.seed,
        request.each.detections or "",
        request.each.detections_right or "",
        tuple(dict.fromkeys(request.each.export or ())),
        not request.each.no_pages,
        request.allow_outside,
        request.force,
    )


def _check_order(request: BatchRequest) -> None:
    """Refuse what is no tracker, setting or format, before anything is done.

    Not asked where nothing is left to do, as it takes longer than all the rest.
    """
    from app.cli.part_options import settings_texts
    from app.cli.track import read_settings
    from tracking.formats import FORMATS
    from tracking.trackers import tracker_named

    if request.order.tracker is not None:
        spec = tracker_named(request.order.tracker)
        read_settings(spec, (*settings_texts(spec, request.order), *_boxes(request)))
    else:
        _check_known((*(request.order.setting or ()), *_boxes(request)))
    for name in request.each.export or ():
        if name not in FORMATS or FORMATS[name].write is None:
            known = joined(", ", [one.name for one in FORMATS.values() if one.write is not None])
            reason = msg(
                "format {name!r} is unknown; choose one of: {known}", name=name, known=known
            )
            raise typer.BadParameter(reason, param_hint="--export")


def _boxes(request: BatchRequest) -> tuple[str, ...]:
    """Files of boxes as settings, as far as they are known before a recording is."""
    patterns = {
        "detections.file": request.each.detections or "",
        "detections.file_right": request.each.detections_right or "",
    }
    return tuple(f"{name}={pattern}" for name, pattern in patterns.items() if pattern)


def _check_known(texts: Sequence[str]) -> None:
    """Refuse settings that no tracker takes, where each recording gets the best one for it."""
    from tracking.trackers import TRACKERS, parse_settings

    refusals: list[SettingsError] = []
    for spec in TRACKERS.values():
        try:
            parse_settings(spec, pairs_of(texts))
        except SettingsError as error:
            refusals.append(error)
        else:
            return
    raise refusals[0]


def _found(request: BatchRequest, out: Path) -> Found:
    words = list(request.words)
    found = find_recordings(words, out, request.listed)
    if not (found.paths or found.missing or found.empty):
        raise RecordingError(
            "no recordings are named; give folders, videos, patterns, or a list with --list"
        )
    return found


def _entries(found: Found, ledger: Ledger, out: Path, shard: Shard | None) -> list[Entry]:
    """The recordings with the names they have; one that was moved keeps its name.

    For shards the ledger of the whole counts before their own, so that all call one recording one
    name.
    """
    rows = {row.path: row.name for row in ledger.rows()}
    if shard is not None:
        rows |= {row.path: row.name for row in read_rows(ledger_path(out))}
    wanted = set(found.paths)
    named = {path: name for path, name in rows.items() if path in wanted or path.exists()}
    return named_entries(found.paths, named)


def _worked(
    request: BatchRequest,
    order: BatchOrder,
    ledger: Ledger,
    out: Path,
    entries: Sequence[Entry],
    shard: Shard | None,
    shown: BatchProgress,
) -> tuple[Mapping[str, Outcome], bool]:
    """What became of the recordings, and whether anything was done for it now."""
    count = request.sharing.workers or _cores()
    limits = _limits(request, count)
    places = {entry.name: entry.path for entry in entries}
    with shown, closing(StateFile(out, places, shown)) as told:
        run = BatchRun(
            *(ledger, out, order, limits),
            listener=shown if shard is not None else told,
            retry=request.retry,
            shard=shard,
        )
        try:
            plan = run.plan(entries)
            if not plan.to_do:
                shown.tell_known(run.state)
                return plan.finished, False
            _check_order(request)
            if request.sharing.scheduler is None:
                workers: Workers = LocalWorkers(min(count, len(plan.to_do)), limits)
            else:
                from tracking.batch.cluster import ClusterWorkers  # few have a cluster

                workers = ClusterWorkers(request.sharing.scheduler, limits, out)
            return run.work(workers), True
        except KeyboardInterrupt:
            shown.close()
            _tell_interrupted(run.state)
            raise
        finally:
            _remember(shown.places)


def _remember(places: Mapping[str, Path]) -> None:
    """Note where the recordings stand, so that their sessions find them unasked."""
    if places:
        from app.core.document.document_loader import known_recordings  # takes long to import

        known_recordings().remember_all(places)


def _tell_interrupted(state: BatchState) -> None:
    say(
        msg(
            "{done} of {total} recordings are done; the same command goes on from here",
            done=state.done,
            total=state.total,
        )
    )


def _limits(request: BatchRequest, workers: int) -> Limits:
    memory = request.cost.memory_limit
    memory_bytes = None if memory is None else memory << 20
    if memory is None and request.sharing.scheduler is None:
        memory_bytes = _usual_memory(workers)
    return Limits(
        request.cost.time_limit or None, request.cost.stall_limit or None, memory_bytes or None
    )


def _usual_memory(workers: int) -> int | None:
    """Bytes that a recording may cost, so that all workers fit into the machine."""
    try:
        whole = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (ValueError, OSError, AttributeError):
        return None
    return max(_LEAST_MEMORY_BYTES, int(_MEMORY_SHARE * whole / workers))


def _cores() -> int:
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:
        return os.cpu_count() or 1


def _missing(found: Found) -> dict[str, tuple[State, Message]]:
    """Words that meant no recording, by what the user called them."""
    failed = {str(path): (State.FAILED, why) for path, why in found.missing.items()}
    return failed | {str(path): (State.SKIPPED, why) for path, why in found.empty.items()}


def _tell(
    entries: Sequence[Entry],
    outcomes: Mapping[str, Outcome],
    missing: Mapping[str, tuple[State, Message]],
    page: Path,
    told_before: Set[str],
    *,
    as_json: bool,
) -> None:
    """Print what became of all, and exit with a status that says whether all is done.

    told_before: names of which the reader has seen the reason already.
    """
    names = [entry.name for entry in entries]
    done = [name for name in names if outcomes[name].is_done]
    told: dict[State, dict[str, Message]] = {State.FAILED: {}, State.SKIPPED: {}}
    for name, (state, why) in missing.items():
        told[state][name] = why
    for name in names:
        if not outcomes[name].is_done:
            told[outcomes[name].state][name] = outcomes[name].why
    failed, skipped = told[State.FAILED], told[State.SKIPPED]
    if as_json:
        document: dict[str, Any] = {"done": done, "failed": failed, "skipped": skipped}
        print_json(document | {"report": str(page)})
    else:
        for name, why in failed.items():
            if name not in told_before:
                print_line(msg("failed: {name}: {why}", name=name, why=why))
        for name, why in skipped.items():
            if name not in told_before:
                print_line(msg("skipped: {name}: {why}", name=name, why=why))
        total = len(names) + len(missing)
        counts = count_msg(
            total, "{done} of {n} recording done", "{done} of {n} recordings done", done=len(done)
        )
        print_line(counts)
        print_line(page)
    if not done and (names or missing):  # a shard may have nothing to do
        raise SystemExit(NONE_DONE)
    if failed:
        raise SystemExit(SOME_FAILED)


def _one_place() -> bool:
    """Whether stdout and stderr go to one terminal or file, so that one reader sees both."""
    try:
        out, errors = (os.fstat(stream.fileno()) for stream in (sys.stdout, sys.stderr))
    except (OSError, ValueError, AttributeError):
        return False
    return os.path.samestat(out, errors)


def _words_without(words: Sequence[str], option: str) -> list[str]:
    """What was typed, without an option and its value."""
    kept: list[str] = []
    rest = iter(words)
    for word in rest:
        if word == option:
            next(rest, None)
        elif not word.startswith(f"{option}="):
            kept.append(word)
    return kept
