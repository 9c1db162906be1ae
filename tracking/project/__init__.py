"""A project: a folder of recordings and of the sessions that were made of them."""

from tracking.project.fact_store import FactStore
from tracking.project.facts import RecordingFacts, SessionFacts
from tracking.project.folder_scan import FolderScan, ScannedFile, holds_several, scan_folder
from tracking.project.pairing import ProjectRow, SessionRow, pair
from tracking.project.project import Project, ProjectList, Wanted
from tracking.project.reader_process import ReaderProcess
from tracking.project.review_order import next_to_review, worth_of
