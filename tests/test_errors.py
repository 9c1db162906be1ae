"""What errors say, and what they say can be done."""

from __future__ import annotations

from tracking.errors import FormatError, TrackwrightError


def test_a_message_is_the_reason_and_what_to_do_about_it() -> None:
    error = FormatError("a.csv is empty", "name another file")
    assert str(error) == "a.csv is empty; name another file"
    assert str(FormatError("a.csv is empty")) == "a.csv is empty"


def test_who_knows_another_way_tells_it_in_place_of_the_first_one() -> None:
    error: TrackwrightError = FormatError("a.csv; b.csv", "name it (--file PATH)")
    other = error.advising("choose it in the list")
    assert isinstance(other, FormatError)
    assert (other.reason, str(other)) == ("a.csv; b.csv", "a.csv; b.csv; choose it in the list")
