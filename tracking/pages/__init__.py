"""Pages and their pictures: the one way in which reports are drawn and written."""

from tracking.pages.axes import Axes, Axis, drawing, group
from tracking.pages.curves import Panel, drawn, look_of, svg
from tracking.pages.elements import Content, Element, element, name
from tracking.pages.folder import check_report_folder, write_report_folder
from tracking.pages.page import page
from tracking.pages.pictures import jpeg_source, picture
from tracking.pages.tables import table

__all__ = [
    "Axes",
    "Axis",
    "Content",
    "Element",
    "Panel",
    "check_report_folder",
    "drawing",
    "drawn",
    "element",
    "group",
    "jpeg_source",
    "look_of",
    "name",
    "page",
    "picture",
    "svg",
    "table",
    "write_report_folder",
]
