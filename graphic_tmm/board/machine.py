"""The text of a loop as a function, by LLVM.

Only the translator is needed (llvmlite, which numba brings along), and of a loop that was translated before not
even that works: its code is loaded as it lies (`kept`).
"""

from __future__ import annotations

import ctypes
import ctypes.util
import hashlib
import os
import re
import sys
from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any, NamedTuple

from graphic_tmm.board.kept import folder, kept
from graphic_tmm.board.loop_passes import MAY_CALL
from graphic_tmm.board.loop_text import NAME
from graphic_tmm.errors import ConstructionError

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
            'a compiled log needs llvmlite: install it (pip install "graphic-tmm[fast]"), or run without fast'
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
def made(text: str) -> Run:
    """Return the loop of a text, as `loop_text` writes it."""
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
