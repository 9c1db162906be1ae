"""Networks that find people in pictures: read and run in a program of their own, with limits.

Nothing is imported here: that program needs a few of these modules, and is to start quickly.
"""
