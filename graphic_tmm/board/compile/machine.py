"""The text of a loop as a function, by LLVM; its code is kept in the user's cache folder.

Only the translator is needed (llvmlite, which numba brings along), and of a loop that was translated before not
even that works: its code is loaded as it lies, under the hash of all that it was made of. What lies there is
run, so the folder and its files must be the user's own and nobody else may write there; a file that is not
whole, or not what its name says, is thrown away. Where nothing can be kept code is made anew. A file is written
beside its place and moved there, so two processes do not meet.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import hashlib
import os
import re
import stat
import sys
import tempfile
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from graphic_tmm.board.compile.llvm import MAY_CALL, NAME
from graphic_tmm.errors import ConstructionError, installing

VARIABLE = "GRAPHIC_TMM_CACHE"
"""The variable of the environment that names another folder; empty: nothing is kept."""
FORMAT = b"graphic-tmm loop 1\n"
"""How a file begins; then comes the hash of its name and the code, then the code."""
MOST = 256
"""Files that are kept, the newest."""
_SUFFIX, _PART = ".loop", ".part"
_HASH = 32


def folder(environ: Mapping[str, str], system: str = sys.platform) -> Path | None:
    """Return where machine code is kept; None for nowhere."""
    told = environ.get(VARIABLE)
    if told is not None:
        return Path(told) if told else None
    if system == "win32":
        base = environ.get("LOCALAPPDATA")
    elif system == "darwin":
        base = f"{environ['HOME']}/Library/Caches" if environ.get("HOME") else None
    else:
        base = environ.get("XDG_CACHE_HOME")
        if not base or not base.startswith("/"):
            base = f"{environ['HOME']}/.cache" if environ.get("HOME") else None
    return Path(base) / "graphic-tmm" / "loops" if base else None


def kept(name: str, make: Callable[[], bytes], place: Path | None) -> bytes:
    """Return the code of a name: as it lies in a folder, else as it is made; it lies there from then on.

    Parameters
    ----------
    name
        A hash of everything that the code hangs on.
    make
        Makes it.
    place
        The folder; None for none.
    """
    if place is None or not _own_folder(place):
        return make()
    file = place / f"{name}{_SUFFIX}"
    found = _read(file, name)
    if found is None:
        found = make()
        with suppress(OSError):
            _write(file, _sealed(name, found))
            _clear(place)
    return found


def _sealed(name: str, code: bytes) -> bytes:
    return FORMAT + hashlib.sha256(name.encode() + code).digest() + code


def _own_folder(place: Path) -> bool:
    """Make a folder, if it is not there, and return whether it is the user's own."""
    try:
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        found = place.lstat()
    except OSError:
        return False
    return stat.S_ISDIR(found.st_mode) and _own(found)


def _own(found: os.stat_result) -> bool:
    """Whether something is the user's own and nobody else may write it; only some systems tell."""
    if sys.platform == "win32":
        return True
    return found.st_uid == os.geteuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _read(file: Path, name: str) -> bytes | None:
    """Return the code of a file; None if there is none, or none to be trusted: that one is removed."""
    try:
        number = os.open(
            file, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
        )
    except OSError:
        return None
    with os.fdopen(number, "rb") as stream:
        about = os.fstat(stream.fileno())
        fit = stat.S_ISREG(about.st_mode) and _own(about)
        whole = stream.read() if fit else b""
    code = whole[len(FORMAT) + _HASH :]
    if code and whole == _sealed(name, code):
        with suppress(OSError):
            os.utime(file)
        return code
    with suppress(OSError):
        file.unlink()
    return None


def _write(file: Path, whole: bytes) -> None:
    """Write a file whole, or not at all."""
    number, part = tempfile.mkstemp(_PART, dir=file.parent)
    try:
        with os.fdopen(number, "wb") as stream:
            stream.write(whole)
        os.replace(part, file)
    except OSError:
        os.unlink(part)
        raise


def _clear(place: Path) -> None:
    """Remove the oldest files beyond `MOST`; parts of files that were never finished grow old too."""
    files = []
    for file in place.iterdir():
        if file.suffix in (_SUFFIX, _PART):
            with suppress(OSError):
                files.append((file.stat().st_mtime_ns, file.name))
    for _, name in sorted(files)[:-MOST]:
        with suppress(OSError):
            (place / name).unlink()


TYPED = 17
"""The first LLVM whose addresses do not say of what they are."""
_CALLED = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_int64)


class Machine(NamedTuple):
    """What this process runs on: the translator, and the system and the processor by LLVM's names."""

    binding: Any
    triple: str
    processor: str
    features: str

    def target(self) -> Any:
        """Return what makes code for this machine."""
        found = self.binding.Target.from_triple(self.triple)
        # a text has each intermediate once, in vectors: more effort doubles the time and gains nothing
        return found.create_target_machine(
            self.processor, self.features, opt=1, codemodel="jitdefault", jit=True
        )

    def key(self, text: str) -> str:
        """Return the hash of a text and of all that its translation hangs on."""
        version = ".".join(map(str, self.binding.llvm_version_info))
        whole = "\n".join((version, self.triple, self.processor, self.features, text))
        return hashlib.sha256(whole.encode()).hexdigest()


class Run:
    """A loop in machine code; the code lives as long as this does.

    ``call`` works some positions: it takes the address of a frame and the base of its addresses (see `Loop`).
    Other threads run while it does.
    """

    def __init__(self, code: bytes) -> None:
        on = machine()
        self._loader = on.binding.create_mcjit_compiler(_parsed("", on), on.target())
        self._loader.add_object_file(on.binding.ObjectFileRef.from_data(code))
        self._loader.finalize_object()
        self.call: Callable[[int, int], None] = _CALLED(self._loader.get_function_address(NAME))


@cache
def machine() -> Machine:
    """Return the machine that this process runs on.

    Raises
    ------
    ConstructionError
        If llvmlite is not installed.
    """
    try:
        import llvmlite.binding as binding
    except ImportError as error:
        raise ConstructionError(
            f"a compiled log needs llvmlite: install it ({installing('[fast]')}), or run without fast"
        ) from error
    if binding.llvm_version_info[0] < TYPED:
        binding.initialize()
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    _library(binding)
    triple = binding.get_process_triple()
    if sys.platform == "win32":
        # its loader knows the format of other systems only
        triple += "-elf"
    try:
        features = binding.get_host_cpu_features().flatten()
    except RuntimeError:
        features = ""
    return Machine(binding, triple, binding.get_host_cpu_name(), features)


@lru_cache(maxsize=128)
def function_of(text: str) -> Run:
    """Return the loop of a text, as `llvm` writes it."""
    name = machine().key(text)
    return Run(kept(name, lambda: translated(text), folder(os.environ)))


def translated(text: str) -> bytes:
    """Return a text of LLVM's as machine code."""
    on = machine()
    code: bytes = on.target().emit_object(_parsed(text, on))
    return code


def _parsed(text: str, on: Machine) -> Any:
    if on.binding.llvm_version_info[0] >= TYPED:
        text = re.sub(r"(?:double|i64|<\d+ x double>)\*", "ptr", text)
    module = on.binding.parse_assembly(text)
    module.triple = on.triple
    module.verify()
    return module


def _library(binding: Any) -> None:
    """Tell the loader where the functions of the system's library are."""
    library = ctypes.CDLL("ucrtbase" if sys.platform == "win32" else None)
    if not hasattr(library, MAY_CALL[0]):
        library = ctypes.CDLL(ctypes.util.find_library("m"))
    for name in MAY_CALL:
        binding.add_symbol(name, ctypes.cast(getattr(library, name), ctypes.c_void_p).value)
