"""Compiles an archive of sources for this Python, which is that of the browser; run by `compile_modules.mjs`."""

from __future__ import annotations

import marshal
import warnings
import zipfile
from pathlib import PurePosixPath
from types import CodeType

NOT_SHIPPED = {"_system/terminal.py", "_system/output_files.py", "_reports/audit_table.py"}  # they need a terminal


def packed(archive: str) -> bytes:
    """Modules by name, as whether they are packages, where they were and what they do; and files by place."""
    modules: dict[str, tuple[bool, str, bytes]] = {}
    files: dict[str, bytes] = {}
    with zipfile.ZipFile(archive) as sources, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of other people's escapes in strings
        for place in sources.namelist():
            content = sources.read(place)
            path = PurePosixPath(place)
            if path.suffix != ".py":
                files[place] = content
            elif "/".join(path.parts[-2:]) not in NOT_SHIPPED:
                code = _bare(compile(content, place, "exec", dont_inherit=True, optimize=2))
                is_package = path.name == "__init__.py"
                name = ".".join(path.parent.parts if is_package else path.with_suffix("").parts)
                modules[name] = (is_package, place, marshal.dumps(code))
    return marshal.dumps((modules, files))


def _bare(code: CodeType) -> CodeType:
    """Without documentation and line numbers, which are half of what would be sent."""
    inner = tuple(_bare(one) if isinstance(one, CodeType) else one for one in code.co_consts)
    return code.replace(co_linetable=b"", co_consts=inner)
