"""NumPy archives (NPZ) from anywhere, read within bounds of time and memory.

What the file says of itself is held against the size that it has before anything is unpacked or allocated, and
nothing in it is evaluated: the header of an array is matched, not parsed. The archive's comment is a checksum of all
bytes before it, so that accidents of every kind are seen before the file is taken apart. An archive without a comment,
as NumPy writes it, is read too.
"""

import hashlib
import io
import re
import struct
import zipfile
import zlib
from collections.abc import Mapping
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

ALWAYS_ALLOWED = 2**25  # bytes unpacked
EXPANSION = 16  # times the size of the file; columns of measured numbers hardly shrink
MEMBERS = 64
DIRECTORY = 2**14
_END = struct.Struct("<4s4H2LH")
_CHECKSUM = 64  # hexadecimal digits of a SHA-256
_LOCATOR = 20  # bytes before the end of an archive so large that its list is found in another way
_LARGE = 2**32 - 1
_CHUNK = 2**20
_ENCRYPTED = 1
_HEADER = re.compile(
    rb"\x93NUMPY\x01\x00..\{'descr': '([^']{1,16})', 'fortran_order': False, 'shape': \(([0-9, ]{0,64})\), \} *\n",
    re.DOTALL,
)
_LARGEST_CHARACTER = 0x10FFFF
_DAMAGE = (
    EOFError, KeyError, NotImplementedError, OverflowError, RuntimeError, ValueError,
    struct.error, zipfile.BadZipFile, zlib.error,
)  # fmt: skip


class ArchiveError(ValueError):
    """A file is no archive of arrays, is damaged, or holds more than its size allows."""


class Stored(NamedTuple):
    """An array as it is stored: its type as NumPy writes it (`<f8`), and its values where that is a plain one."""

    descr: str
    shape: tuple[int, ...]
    data: memoryview

    def values(self) -> NDArray[Any]:
        """The array, which cannot be written to.

        Raises:
            ArchiveError: the type is none of float64, int64 and text, or the bytes are not those of such an array.

        """
        if not re.fullmatch(r"<(f8|i8|U[1-9][0-9]{0,6})", self.descr):
            raise ArchiveError(f"arrays of {self.descr} are not read")
        dtype = np.dtype(self.descr)
        count = int(np.prod(self.shape, dtype=object))
        if count * dtype.itemsize != len(self.data):
            raise ArchiveError(f"{len(self.data)} bytes are no array of {self.descr} with shape {self.shape}")
        if dtype.kind == "U" and np.any(np.frombuffer(self.data, "<u4") > _LARGEST_CHARACTER):
            raise ArchiveError("text has characters that there are not")
        return np.ndarray(self.shape, dtype, self.data)


def unpacked(file: BinaryIO) -> dict[str, Stored]:
    """Read all arrays of an archive.

    Raises:
        ArchiveError: it is none, damaged, encrypted, or larger than its size allows: when unpacked, 32 MiB or 16 times
            the size of the file, whichever is more.
        OSError: the file cannot be read.

    """
    size = file.seek(0, io.SEEK_END)
    try:
        _require_end(file, size)
        with zipfile.ZipFile(file) as archive:
            members = archive.infolist()
            for member in members:
                _require_plain(member, size)
            if sum(member.file_size for member in members) > max(ALWAYS_ALLOWED, EXPANSION * size):
                raise ArchiveError("it would unpack to far more than its size")
            return {member.filename.removesuffix(".npy"): _read(archive, member) for member in members}
    except _DAMAGE as error:
        raise ArchiveError(str(error)) from error


def packed(columns: Mapping[str, NDArray[Any]]) -> bytes:
    """An archive that `unpacked` reads; one so large that it must not shrink too much is not compressed."""
    file = io.BytesIO()
    write = np.savez_compressed if sum(column.nbytes for column in columns.values()) < ALWAYS_ALLOWED // 2 else np.savez
    write(file, **dict[str, Any](columns))
    content = file.getvalue()[:-2] + struct.pack("<H", _CHECKSUM)
    return content + hashlib.sha256(content).hexdigest().encode()


def _require_end(file: BinaryIO, size: int) -> None:
    """Check the last bytes, and the checksum, before all that they announce is read into memory.

    Raises:
        ArchiveError: they are not the end of an archive, the list of its members is long, or the checksum is another.

    """
    has_checksum = _bytes_at(file, size - _CHECKSUM - _END.size, 4) == b"PK\5\6"
    start = size - _END.size - has_checksum * _CHECKSUM
    end = _bytes_at(file, start, _END.size)
    if not end.startswith(b"PK\5\6"):
        raise ArchiveError("it does not end as an archive does")
    *_, members, length, offset, comment = _END.unpack(end)
    if members > MEMBERS or length > DIRECTORY or comment != has_checksum * _CHECKSUM:
        raise ArchiveError(f"it announces {members} members, listed in {length} bytes, and a comment of {comment}")
    is_large = _bytes_at(file, start - _LOCATOR, 4) == b"PK\6\7"
    if size < _LARGE and (is_large or offset + length != start):
        raise ArchiveError("its end does not say where the list of its members is")
    if has_checksum and _bytes_at(file, size - _CHECKSUM, _CHECKSUM).decode() != _checksum(file, size - _CHECKSUM):
        raise ArchiveError("it was changed or damaged since it was saved: the checksum does not fit")


def _bytes_at(file: BinaryIO, place: int, count: int) -> bytes:
    """Some bytes of a file, fewer or none where it does not have so many."""
    file.seek(max(place, 0))
    return file.read(count)


def _checksum(file: BinaryIO, count: int) -> str:
    """The checksum of the first bytes of a file."""
    total = hashlib.sha256()
    file.seek(0)
    for start in range(0, count, _CHUNK):
        total.update(file.read(min(_CHUNK, count - start)))
    return total.hexdigest()


def _require_plain(member: zipfile.ZipInfo, size: int) -> None:
    if member.flag_bits & _ENCRYPTED:
        raise ArchiveError(f"{member.filename} is encrypted")
    if member.compress_type not in {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}:
        raise ArchiveError(f"{member.filename} is compressed in a way that is not read")
    if member.header_offset + member.compress_size > size:
        raise ArchiveError(f"{member.filename} is longer than the file")


def _read(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> Stored:
    with archive.open(member) as file:
        content = file.read(member.file_size)  # no more is unpacked, whatever follows
    header = _HEADER.match(content)
    if header is None:
        raise ArchiveError(f"{member.filename} is not an array as NumPy writes it")
    shape = tuple(int(length) for length in header[2].decode().replace(" ", "").split(",") if length)
    return Stored(header[1].decode("ascii"), shape, memoryview(content)[header.end() :])
