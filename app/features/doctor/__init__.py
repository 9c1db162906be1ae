"""What is wrong with a recording's cameras, calibration and floor, and its mending."""
