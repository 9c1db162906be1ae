"""Documents opened, kept, exported; older states; the first page."""
