"""Conversion of plots: what is asked, one plot in plain numbers, many in blocks, and covariances that are such."""
