"""What tests of several runs ask of the window."""

AGAIN_AT = 50
SHIFTED = (58, 72)
"""Frames in which somebody of the run stands a metre beside where he is."""


def items(controller):
    return controller.document.comparison.scene().items


def place(controller, track, frame):
    return float(controller.document.session.tracks.of_track(track, frame, frame + 1)["x"][0])


def boxes(marks):
    return {mark.label: mark.box for mark in marks}
