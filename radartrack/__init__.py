"""Radar tracking formulas that were derived, not copied: conversion, filters, fusion, simulation, verification."""

from radartrack import convert

__all__ = ["convert"]
