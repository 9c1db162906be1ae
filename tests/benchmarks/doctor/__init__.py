"""The doctor: faults put into rendered recordings, and what it says of sound ones."""
