"""Proved bounds of rounding errors: enclosures, error rules, boxes, certificates and what checks these."""
