"""How well the stereo trackers do, beside their papers: `python -m tests.benchmarks.stereo`."""
