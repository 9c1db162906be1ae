"""Who is detected and who is kept, as the papers count."""

from __future__ import annotations

from scenes_of_rows import Row, standing, table

from tracking.scoring import People, score


def counted(truth: list[Row], result: list[Row]) -> People:
    return score(table(truth), table(result)).people


def test_a_person_matched_in_nine_frames_is_not_detected() -> None:
    assert counted(standing(1, range(20)), standing(5, range(9))) == People(0, 0)


def test_a_person_matched_in_ten_frames_is_detected_and_kept() -> None:
    assert counted(standing(1, range(20)), standing(5, range(10))) == People(1, 1)


def test_a_second_id_is_not_kept() -> None:
    result = [*standing(5, range(10)), *standing(6, range(10, 20))]
    assert counted(standing(1, range(20)), result) == People(1, 0)


def test_half_of_the_frames_from_the_first_match_on_are_needed() -> None:
    assert counted(standing(1, range(40)), standing(5, range(15, 27))) == People(1, 0)
    assert counted(standing(1, range(40)), standing(5, range(15, 28))) == People(1, 1)


def test_an_id_borne_by_another_before_is_not_kept() -> None:
    truth = [*standing(1, range(10)), *standing(2, range(10, 25), x=50)]
    result = [*standing(5, range(10)), *standing(5, range(10, 25), x=50)]
    assert counted(truth, result) == People(detected=2, kept=1)


def test_an_id_borne_by_another_between_is_not_kept() -> None:
    truth = [*standing(1, range(20)), *standing(2, range(20), x=50)]
    result = [
        *standing(5, range(8)),
        (8, 5, 50.0, 0.0),
        *standing(5, range(9, 20)),
        *standing(6, range(9, 20), x=50),
    ]
    assert counted(truth, result) == People(detected=2, kept=0)


def test_an_id_handed_on_after_the_last_match_is_kept_by_the_first() -> None:
    truth = [*standing(1, range(12)), *standing(2, range(30), x=50)]
    result = [*standing(5, range(12)), *standing(5, range(12, 30), x=50)]
    assert counted(truth, result) == People(detected=2, kept=1)


def test_an_exchange_of_ids_is_a_failure_of_both() -> None:
    truth = [*standing(1, range(30)), *standing(2, range(30), x=50)]
    result = [
        *standing(5, range(15)),
        *standing(6, range(15), x=50),
        *standing(6, range(15, 30)),
        *standing(5, range(15, 30), x=50),
    ]
    assert counted(truth, result) == People(detected=2, kept=0)


def test_a_false_track_harms_nobody() -> None:
    result = [*standing(5, range(20)), *standing(9, range(20), x=70)]
    assert counted(standing(1, range(20)), result) == People(1, 1)
