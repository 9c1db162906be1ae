"""Reports on scores: what was measured as a page, as Markdown and as JSON."""

from tracking.scoring.report.data import data_of, people_data, ranges_data
from tracking.scoring.report.distances import NO_PLACES, distance_rows, distances_data
from tracking.scoring.report.findings import (
    Finding,
    ScoreReport,
    Yardstick,
    finding_of,
    report_of,
)
from tracking.scoring.report.page import page_of
from tracking.scoring.report.page_pictures import Shown, shown_of
from tracking.scoring.report.report_writer import check_score_folder, write_score_report
from tracking.scoring.report.subject import Footage, Source, Subject
from tracking.scoring.report.switch_pictures import (
    MOST_SWITCHES,
    SwitchPictures,
    place_picture,
    switch_pictures,
)
