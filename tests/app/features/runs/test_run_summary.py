from dataclasses import replace
from gettext import NullTranslations

import numpy as np
from two_people import columns
from two_people import run as made_run

from app.features.runs.run_summary import RunSummary, describe_further_run
from tracking.pipeline.nobody_found import why_nobody
from tracking.recording import open_recording
from tracking.recording.options import OpenOptions
from tracking.translation import use_catalogue

ASKED = (0, 100)


def _with_ids(rows, **ids):
    track = rows["track"].copy()
    for old, new in ids.items():
        track[rows["track"] == int(old[1:])] = new
    return {**rows, "track": track}


def test_a_run_that_says_what_was_seen_on_the_way_tells_of_no_other_ids():
    words = RunSummary.of(made_run(), [columns()], ASKED).words(describe_further_run(2))
    assert words.startswith(
        "Tracked 100 frames with stereo-direction. Found 2 tracks. Kept as run 2"
    )


def test_ids_that_were_put_right_afterwards_are_counted():
    summary = RunSummary.of(made_run(), [_with_ids(columns(), t7=9)], ASKED)
    assert (summary.tracks, summary.seen, summary.changed) == (2, 2, 1)
    assert (
        "whole recording: 1 of the 2 ids you saw while it was tracked has changed"
        in summary.words("")
    )


def test_guesses_that_were_left_out_afterwards_are_no_other_ids():
    run = made_run()
    seen = ~run.tracks["predicted"].astype(bool)
    run = replace(run, tracks={name: column[seen] for name, column in run.tracks.items()})
    assert RunSummary.of(run, [columns()], ASKED).changed == 0


def test_rows_may_come_in_pieces():
    rows = columns()
    early = rows["frame"] < 40
    pieces = [{n: c[part] for n, c in rows.items()} for part in (early, np.invert(early))]
    assert RunSummary.of(made_run(), pieces, ASKED) == RunSummary.of(made_run(), [rows], ASKED)


def test_a_tracking_that_was_stopped_says_how_far_it_came():
    words = RunSummary.of(made_run(), [columns()], (0, 300)).words("")
    assert words.startswith("Stopped early: tracked 100 of 300 frames with")


def test_what_is_told_is_made_of_whole_sentences_that_can_be_translated():
    asked = []

    class Listening(NullTranslations):
        def gettext(self, message: str) -> str:
            asked.append(message)
            return message

        def ngettext(self, one: str, many: str, n: int) -> str:
            return self.gettext(one if n == 1 else many)

    use_catalogue(Listening())
    try:
        RunSummary.of(made_run(), [_with_ids(columns(), t7=9)], ASKED).words("")
    finally:
        use_catalogue(None)
    sentences = [text for text in asked if " " in text.strip()]  # and what stands between them
    assert len(sentences) == 3
    assert all(text[0].isupper() and text.endswith(".") for text in sentences)


def test_a_run_without_a_track_says_why_there_may_be_none(tiny_recording):
    empty = {name: column[:0] for name, column in made_run().tracks.items()}
    summary = RunSummary.of(replace(made_run(), tracks=empty), [], ASKED)
    with open_recording(tiny_recording) as recording:
        nobody = why_nobody(recording, "spheroid")
    words = replace(summary, nobody=nobody).words("Kept.")
    assert "Nobody was found; what stands still for half of the footage" in words
    assert "Found 0 tracks" not in words


def test_a_region_is_named_where_nobody_was_found(tiny_recording):
    outline = ((0.0, 0.0), (20.0, 0.0), (20.0, 20.0))
    with open_recording(tiny_recording, OpenOptions(look=(outline,))) as recording:
        assert "must hold their heads, too" in why_nobody(recording, "spheroid")
