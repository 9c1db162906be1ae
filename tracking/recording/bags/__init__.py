"""Bags of ROS 1 and ROS 2 and MCAP files, read in a program of their own."""
