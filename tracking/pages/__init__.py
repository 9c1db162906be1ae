"""Pages and their plots: the one way in which reports are drawn and written."""

from tracking.pages.folder import check_report_folder, write_report_folder
from tracking.pages.plots import Axes, Axis, Bar, Panel, Plot, Shape, path_of, svg
from tracking.pages.templates import render
