"""Whole papers: claims files, their formulas and numbers, decided in processes that can be ended."""
