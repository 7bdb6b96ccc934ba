"""A photograph read from a file, by Pillow (extra ``photo``): nothing is decompressed before it is measured."""

from __future__ import annotations

import io
import warnings
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.errors import SheetError, TmmError, installing
from graphic_tmm.files import Kind, opened
from graphic_tmm.language.said import said

MOST = 100e6
"""No photograph and no flattened sheet has more pixels."""

PHOTOGRAPH = Kind(
    said("a photograph"), said("name a photograph (JPEG, PNG, TIFF, WebP or BMP)"), 400_000_000
)
FORMATS = ("JPEG", "PNG", "TIFF", "WEBP", "BMP")


class Sent(NamedTuple):
    """A photograph that was read elsewhere: how messages call it, its bytes."""

    name: str
    data: bytes


def read_photo(photo: str | Path | Sent) -> NDArray[np.uint8]:
    """Return a photograph (rows, columns, 3), 0 ... 255, upright as its camera says.

    Raises
    ------
    SheetError
        If Pillow is missing, or the file is no image, damaged, or of more than `MOST` pixels.
    SceneError
        If the file cannot be read (as `files.opened`).
    """
    images, operations = pillow()
    place = Path(photo.name if isinstance(photo, Sent) else photo)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            with (
                _stream(photo) as stream,
                images.open(stream, formats=FORMATS) as image,
            ):
                columns, rows = image.size
                if columns * rows > MOST:
                    raise SheetError(
                        _large(place, said("{columns} × {rows} pixels", columns=columns, rows=rows))
                    )
                operations.exif_transpose(image, in_place=True)
                return _colours(image, images)
        except TmmError:
            raise
        except images.DecompressionBombError as error:
            raise SheetError(_large(place, said("very large"))) from error
        except images.UnidentifiedImageError as error:
            raise SheetError(
                said("{place}: no photograph that can be read: save it as JPEG or PNG", place=place)
            ) from error
        except Exception as error:  # whatever the decoders meet in a damaged file
            raise SheetError(
                said(
                    "{place}: the photograph cannot be read ({error}): save it anew as JPEG or PNG",
                    place=place,
                    error=error,
                )
            ) from error


def _stream(photo: str | Path | Sent) -> BinaryIO:
    return io.BytesIO(photo.data) if isinstance(photo, Sent) else opened(Path(photo), PHOTOGRAPH)


def pillow() -> tuple[Any, Any]:
    """Return Pillow's modules Image and ImageOps; raises SheetError if it is not installed."""
    try:
        from PIL import Image, ImageOps
    except ImportError as error:
        raise SheetError(
            said("a photograph needs the package Pillow: {remedy}", remedy=installing("[photo]"))
        ) from error
    return Image, ImageOps


def _large(place: Path, size: str) -> str:
    return said(
        "{place}: {size}: a photograph has at most 100 megapixels: make it smaller",
        place=place,
        size=size,
    )


def _colours(image: Any, images: Any) -> NDArray[np.uint8]:
    """Return an image of any mode as three colours of 8 bits, what is transparent as white."""
    if image.mode.startswith("I;16"):
        grey = (np.asarray(image) >> 8).astype(np.uint8)
        return np.repeat(grey[..., None], 3, axis=2)
    if image.has_transparency_data:
        image = image.convert("RGBA")
        white = images.new("RGBA", image.size, "white")
        image = images.alpha_composite(white, image)
    return np.asarray(image if image.mode == "RGB" else image.convert("RGB"), dtype=np.uint8)
