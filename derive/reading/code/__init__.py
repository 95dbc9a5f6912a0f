"""Formulas that are written as code: lines of Python, C, C++ and MATLAB, parsed and never run."""
