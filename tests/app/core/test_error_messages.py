import logging

from app.core.error_messages import explain
from tracking.errors import FormatError, SessionError


def test_errors_raised_on_purpose_speak_for_themselves():
    assert explain(SessionError("a.h5: damaged; open a backup")) == ("a.h5: damaged; open a backup")


def test_a_bug_is_logged_with_where_it_came_from_and_told_as_one(caplog):
    try:
        raise KeyError("frame")
    except KeyError as error:
        with caplog.at_level(logging.ERROR):
            said = explain(error)
    assert said.startswith("A bug in trackwright: KeyError: 'frame'.")
    assert "safe on disk" in said
    assert caplog.records[0].exc_info[0] is KeyError


def test_options_of_the_command_line_are_left_out():
    error = FormatError("the truth has no boxes", "match by floor distance", option="--match floor")
    assert explain(error) == "the truth has no boxes; match by floor distance"
    assert explain(FormatError("a.txt is unknown")) == "a.txt is unknown"


def test_a_bug_whose_words_end_in_a_full_stop_has_one_alone():
    said = explain(RuntimeError("Internal object already deleted."))
    assert "already deleted. Your edits" in said
