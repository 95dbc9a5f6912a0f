"""Audits and experiments for people to read: text, tables and HTML pages."""
