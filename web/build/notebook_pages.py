"""Notebooks as pages, with the outputs that they have."""

from __future__ import annotations

import re
from base64 import b64encode
from pathlib import Path

from nbconvert import MarkdownExporter

_IMAGE = re.compile(r"!\[(?P<words>[^\]]*)\]\((?P<name>[\w.-]+\.(?P<kind>png|svg|jpg))\)")
_KINDS = {"png": "image/png", "svg": "image/svg+xml", "jpg": "image/jpeg"}


def notebook_page(path: Path) -> str:
    """One notebook in Markdown, its pictures within."""
    text, resources = MarkdownExporter().from_filename(str(path))
    pictures = resources.get("outputs", {})

    def picture(found: re.Match[str]) -> str:
        if found["name"] not in pictures:
            return found[0]
        data = b64encode(pictures[found["name"]]).decode()
        return f'<img alt="{found["words"]}" src="data:{_KINDS[found["kind"]]};base64,{data}">'

    return _IMAGE.sub(picture, str(text)).replace("<style scoped>", "<style>")
