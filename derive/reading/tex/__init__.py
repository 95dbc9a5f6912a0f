"""Reads LaTeX as authors write it: displays, equations, letters with what is over, below and beside them."""
