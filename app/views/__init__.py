"""Qt and pyqtgraph only: draw scenes, report gestures."""
