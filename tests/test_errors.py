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


def test_a_reason_with_an_endless_value_keeps_its_beginning_and_its_end() -> None:
    error = FormatError(f"a.json: '{'9' * 50_000}' is not a number; write one", "or another file")
    assert str(error).startswith("a.json: '999")
    assert str(error).endswith("999' is not a number; write one; or another file")
    assert len(str(error)) < 3000
