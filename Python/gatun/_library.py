# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""libgatun by ctypes: its structures and functions, those of gatun.h, and its errors as exceptions."""

from __future__ import annotations

import ctypes
import errno
import os
import sys

from ._build import library as _INSTALLED
from ._exceptions import Error, InputError, NotHere

_API_VERSION = 1

# gatun_status
OK = 0
CANNOT_OPEN = 1
CANNOT_WRITE = 6
INVALID_INPUT = 7
ABORTED = 8
NOT_HERE = 9
NO_MEMORY = 10

# gatun_kind
KIND_NONE = 0
KIND_MESH = 1
KIND_VOLUME = 2
KIND_SURFACE = 3

# Flags of a request
TETRAHEDRA = 1
RESTORE_ORDER = 2
UNUSED_POINTS = 4
BOUNDARY = 8
IN_BOX = 16
IN_RANGE = 32
EXACT = 64
ON_PLANE = 128

SOURCE_NOT_HERE = -1
POINT_ARRAY = 0xFFFFFFFF

#: NumPy's names of gatun_type.
DTYPES = {
    1: "int8",
    2: "uint8",
    3: "int16",
    4: "uint16",
    5: "int32",
    6: "uint32",
    7: "int64",
    8: "uint64",
    9: "float32",
    10: "float64",
}
TYPES = {name: number for number, name in DTYPES.items()}

# ------------------------------------------------------------------------------
# Structures

_POINTER = ctypes.c_void_p
_TEXT = ctypes.c_char_p
_TEXTS = ctypes.POINTER(ctypes.c_char_p)
_NUMBERS = ctypes.POINTER(ctypes.c_double)
_SIZE = ctypes.c_size_t
_I32 = ctypes.c_int32
_U32 = ctypes.c_uint32
_U64 = ctypes.c_uint64
_F64 = ctypes.c_double
_ENUM = ctypes.c_int
_STATUS = ctypes.c_int

Progress = ctypes.CFUNCTYPE(ctypes.c_int, _F64, _POINTER)
Read = ctypes.CFUNCTYPE(ctypes.c_int, _POINTER, _U64, _POINTER, _SIZE)
Close = ctypes.CFUNCTYPE(None, _POINTER)


class _Structure(ctypes.Structure):
    """A structure that begins with its size, which is always set."""

    def __init__(self, **values):
        super().__init__(**values)
        self.size = ctypes.sizeof(self)


def _define(name, *members, base=_Structure):
    """Makes the class of a structure from pairs of names and their type."""
    fields = [(member, kind) for members_, kind in members for member in members_.split()]
    if base is _Structure:
        fields.insert(0, ("size", _SIZE))
    return type(name, (base,), {"_fields_": fields})


Buffer = _define("Buffer", ("data", _POINTER), ("bytes", _U64), base=ctypes.Structure)
Range = _define("Range", ("offset length", _U64), base=ctypes.Structure)
Fetch = ctypes.CFUNCTYPE(ctypes.c_int, _POINTER, ctypes.POINTER(Range), _SIZE)
Source = _define(
    "Source",
    ("bytes", _U64),
    ("read", Read),
    ("close", Close),
    ("user", _POINTER),
    ("name", _TEXT),
    ("fetch", Fetch),
)
Info = _define(
    "Info",
    ("points cells tets", _U64),
    ("bounds", _F64 * 6),
    ("coordinate_type", _ENUM),
    ("arrays steps meshes levels chunks kept_order", _U32),
    (
        "is_surface is_tetrahedral has_time has_hierarchy has_boundary has_wide_ids points_move",
        _I32,
    ),
    ("format_version", _U32),
    ("writer_version", _TEXT),
    ("bytes_read", _U64),
)
Key = _define(
    "Key",
    ("location name", _TEXT),
    ("kind count", _U32),
    ("numbers", ctypes.POINTER(_U64)),
    ("texts", _TEXTS),
)
Array = _define(
    "Array",
    ("name", _TEXT),
    ("is_cell", _I32),
    ("type", _ENUM),
    ("components", _U32),
    ("vtk_type", _I32),
    ("roles", _U32),
    ("component_names", _TEXTS),
    ("keys", ctypes.POINTER(Key)),
    ("key_count", _U32),
    ("error", _TEXT),
    ("values", _POINTER),
    ("weight", _F64),
)
Step = _define(
    "Step", ("time", _F64), ("mesh", _U32), ("points cells", _U64), ("bounds", _F64 * 6)
)
Level = _define("Level", ("points cells", _U64))
Field = _define(
    "Field",
    ("name", _TEXT),
    ("type", _ENUM),
    ("components", _U32),
    ("vtk_type", _I32),
    ("component_names", _TEXTS),
    ("keys", ctypes.POINTER(Key)),
    ("key_count", _U32),
    ("count", _U64),
    ("values", _POINTER),
    ("texts", ctypes.POINTER(_POINTER)),  # which may contain zeros
    ("text_bytes", ctypes.POINTER(_U64)),
)
Request = _define(
    "Request",
    ("step", _U64),
    ("piece pieces ghost_levels flags", _U32),
    ("box", _F64 * 6),
    ("range_array", _U32),
    ("range_component", _I32),
    ("range", _F64 * 2),
    ("origin normal", _F64 * 3),
    ("ratio", _F64),
    ("level", _U32),
    ("arrays", ctypes.POINTER(_U32)),
    ("array_count", _SIZE),
)
Sizes = _define(
    "Sizes",
    ("points cells connectivity faces", _U64),
    ("cell_type", _U32),
    ("coordinate_type", _ENUM),
)
Buffers = _define(
    "Buffers",
    ("points connectivity offsets types face_locations faces", Buffer),
    ("wide_ids", _I32),
    ("point_ids cell_ids point_ghosts cell_ghosts normals", Buffer),
    ("arrays", ctypes.POINTER(Buffer)),
    ("array_count", _SIZE),
)
Contour = _define(
    "Contour",
    ("array", _U32),
    ("component", _I32),
    ("values", _NUMBERS),
    ("value_count", _SIZE),
    ("normals", _I32),
)
Image = _define(
    "Image",
    ("width height", _U32),
    ("step", _U64),
    ("array", _U32),
    ("component", _I32),
    ("level", _U32),
    ("ratio", _F64),
    ("blend", _ENUM),
    ("colors", _NUMBERS),
    ("color_count", _SIZE),
    ("spread_colors", _I32),
    ("opacities", _NUMBERS),
    ("opacity_count", _SIZE),
    ("range", _F64 * 2),
    ("opacity_scale unit_distance", _F64),
    ("shade", _I32),
    ("position focal_point view_up", _F64 * 3),
    ("view_angle parallel_scale", _F64),
    ("direction", _F64 * 3),
    ("zoom", _F64),
)
Mesh = _define(
    "Mesh",
    ("points cells", _U64),
    ("coordinate_type", _ENUM),
    ("wide_ids is_surface", _I32),
    ("coordinates connectivity types offsets face_locations faces", _POINTER),
    ("faces_size", _U64),
    ("point_array", ctypes.POINTER(Array)),
)
Options = _define(
    "Options",
    ("keep_order", _U32),
    ("profile", _ENUM),
    ("chunk_size key_step_interval", _U32),
    ("points_move boundary hierarchy", _I32),
    ("levels", _U32),
    ("dependencies", _I32),
    ("layers", _ENUM),
    ("layer_array", _U32),
    ("layer_component", _I32),
    ("layer_count parts", _U32),
    ("error", _TEXT),
)
Remaining = _define("Remaining", ("is_part drops_points points_moved", _I32))
Values = _define(
    "Values",
    ("arrays", ctypes.POINTER(Buffer)),
    ("array_count", _SIZE),
    ("has_time", _I32),
    ("time", _F64),
    ("coordinates", ctypes.POINTER(Buffer)),
    ("fields", ctypes.POINTER(Field)),
    ("field_count", _SIZE),
    ("remaining_cells", ctypes.POINTER(_U64)),
    ("remaining_cell_count", _U64),
    ("drops_points", _I32),
    ("remaining_points", ctypes.POINTER(_U64)),
    ("remaining_point_count", _U64),
)
VolumeInfo = _define(
    "VolumeInfo",
    ("dimensions", _U32 * 3),
    ("type", _ENUM),
    ("name", _TEXT),
    ("vtk_type", _I32),
    ("origin spacing", _F64 * 3),
    ("direction", _F64 * 9),
    ("first_index", _I32 * 3),
    ("range", _F64 * 2),
    ("rms_error maximum_error", _F64),
    ("is_lossless", _I32),
    ("file_bytes bytes_read", _U64),
)

#: The structures by their names in gatun.h.
STRUCTURES = {
    "gatun_buffer": Buffer,
    "gatun_source": Source,
    "gatun_info": Info,
    "gatun_key": Key,
    "gatun_array": Array,
    "gatun_step": Step,
    "gatun_level": Level,
    "gatun_field": Field,
    "gatun_request": Request,
    "gatun_sizes": Sizes,
    "gatun_range": Range,
    "gatun_buffers": Buffers,
    "gatun_contour": Contour,
    "gatun_image": Image,
    "gatun_mesh": Mesh,
    "gatun_options": Options,
    "gatun_remaining": Remaining,
    "gatun_values": Values,
    "gatun_volume_info": VolumeInfo,
}

# ------------------------------------------------------------------------------
# Functions


def _to(kind):
    return ctypes.POINTER(kind)


_CALL = (Progress, _POINTER)
_TEXT_OUT = (ctypes.c_int, _POINTER, _SIZE, _to(_SIZE))
_RANGES_OUT = (_U64, _to(Range), _SIZE, _to(_SIZE))
_PIECE_OUT = (_to(Sizes), *_CALL, _to(_POINTER))
_VOXELS = (_to(_U32), _to(_U32))

#: Result and parameters of the functions by their names in gatun.h.
FUNCTIONS = {
    "gatun_api_version": (_U32,),
    "gatun_version": (_TEXT,),
    "gatun_error": (_TEXT,),
    "gatun_error_place": (ctypes.c_int, _to(_U64), _to(_U64), _to(ctypes.c_int)),
    "gatun_set_threads": (None, ctypes.c_int),
    "gatun_threads": (ctypes.c_int,),
    "gatun_kind_of": (_ENUM, _TEXT),
    "gatun_open": (_STATUS, _TEXT, _U64, _to(_POINTER)),
    "gatun_open_source": (_STATUS, _to(Source), _U64, _to(_POINTER)),
    "gatun_close": (None, _POINTER),
    "gatun_get_info": (_STATUS, _POINTER, _to(Info)),
    "gatun_describe": (_STATUS, _POINTER, *_TEXT_OUT),
    "gatun_get_array": (_STATUS, _POINTER, _U32, _to(Array)),
    "gatun_get_range": (_STATUS, _POINTER, _U32, _I32, _U64, _NUMBERS),
    "gatun_get_step": (_STATUS, _POINTER, _U64, _to(Step)),
    "gatun_get_level": (_STATUS, _POINTER, _U32, _to(Level)),
    "gatun_get_fields": (_STATUS, _POINTER, _U64, _to(_POINTER), _to(_U32)),
    "gatun_get_field": (_STATUS, _POINTER, _U32, _to(Field)),
    "gatun_free_fields": (None, _POINTER),
    "gatun_verify": (_STATUS, _POINTER, *_CALL),
    "gatun_plan": (_STATUS, _POINTER, _to(Request), *_RANGES_OUT),
    "gatun_prepare": (_STATUS, _POINTER, _to(Request), *_PIECE_OUT),
    "gatun_read": (_STATUS, _POINTER, _to(Buffers), *_CALL),
    "gatun_end": (None, _POINTER),
    "gatun_prepare_contour": (_STATUS, _POINTER, _to(Request), _to(Contour), *_PIECE_OUT),
    "gatun_prepare_slice": (_STATUS, _POINTER, _to(Request), *_PIECE_OUT),
    "gatun_render": (_STATUS, _POINTER, _to(Image), _to(Buffer), *_CALL),
    "gatun_create": (
        _STATUS,
        _TEXT,
        _to(Mesh),
        _to(Array),
        _SIZE,
        _to(Options),
        *_CALL,
        _to(_POINTER),
    ),
    "gatun_append": (_STATUS, _TEXT, _to(Array), _SIZE, _to(Options), _to(_POINTER)),
    "gatun_add_mesh": (_STATUS, _POINTER, _to(Mesh), _to(Values), *_CALL, _to(_U32)),
    "gatun_use_mesh": (_STATUS, _POINTER, _U32),
    "gatun_find_remaining": (
        _STATUS,
        _to(Mesh),
        _to(Mesh),
        _to(Buffer),
        _to(Buffer),
        _to(Remaining),
    ),
    "gatun_round_points": (_STATUS, _to(Mesh), _TEXT, _I32, _to(Buffer), _to(_F64)),
    "gatun_write_step": (_STATUS, _POINTER, _to(Values), *_CALL),
    "gatun_finish": (_STATUS, _POINTER, _to(_U64)),
    "gatun_discard": (None, _POINTER),
    "gatun_create_parts": (_STATUS, _TEXT, _to(Array), _SIZE, _to(Options), _to(_POINTER)),
    "gatun_survey_part": (_STATUS, _POINTER, _to(Mesh), _POINTER, *_CALL),
    "gatun_survey_step": (_STATUS, _POINTER, _to(Values)),
    "gatun_add_part": (_STATUS, _POINTER, _to(Mesh), _POINTER, *_CALL),
    "gatun_open_volume": (_STATUS, _TEXT, _to(_POINTER)),
    "gatun_open_volume_source": (_STATUS, _to(Source), _to(_POINTER)),
    "gatun_close_volume": (None, _POINTER),
    "gatun_get_volume_info": (_STATUS, _POINTER, _to(VolumeInfo)),
    "gatun_describe_volume": (_STATUS, _POINTER, *_TEXT_OUT),
    "gatun_plan_voxels": (_STATUS, _POINTER, *_VOXELS, *_RANGES_OUT),
    "gatun_read_voxels": (_STATUS, _POINTER, *_VOXELS, _to(Buffer), *_CALL),
    "gatun_verify_volume": (_STATUS, _POINTER, *_CALL),
    "gatun_write_volume": (
        _STATUS,
        _TEXT,
        _to(VolumeInfo),
        _to(Buffer),
        _U32,
        _ENUM,
        _F64,
        *_CALL,
        _to(VolumeInfo),
    ),
}


def _list_candidates():
    """The paths and names of the library, in the order to try."""
    name, system = {
        "win32": ("gatun.dll", "gatun.dll"),
        "cygwin": ("gatun.dll", "gatun.dll"),
        "darwin": ("libgatun.dylib", "libgatun.0.dylib"),
    }.get(sys.platform, ("libgatun.so", "libgatun.so.0"))
    folder = os.path.dirname(os.path.abspath(__file__))
    beside, installed = os.path.join(folder, name), os.path.normpath(os.path.join(folder, _INSTALLED))
    if os.path.exists(beside):
        return [beside]
    given = os.environ.get("GATUN_LIBRARY")
    return [given or (installed if _INSTALLED and os.path.exists(installed) else system)]


def _load():
    (path,) = _list_candidates()
    try:
        found = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"gatun cannot load its library: {error}") from None
    for name, (result, *parameters) in FUNCTIONS.items():
        try:
            function = getattr(found, name)
        except AttributeError:
            raise ImportError(f"{path}: is no libgatun that fits, as it has no {name}") from None
        function.restype = result
        function.argtypes = parameters
    if found.gatun_api_version() < _API_VERSION:
        raise ImportError(f"{path}: version {found.gatun_api_version()} of its interface is too old")
    return found


#: The library.
library = _load()


def get_version():
    """The version of the library."""
    return library.gatun_version().decode()


# ------------------------------------------------------------------------------
# Errors

# Code and name of vtkErrorCode and vtkGatunErrorCode for each status.
_CODES = {
    1: (20002, "CannotOpenFileError"),
    2: (20003, "UnrecognizedFileTypeError"),
    3: (40003, "UnsupportedVersionError"),
    4: (20004, "PrematureEndOfFileError"),
    5: (20005, "FileFormatError"),
    6: (20002, "CannotOpenFileError"),
    7: (40007, "InvalidInputError"),
    8: (40008, "AbortedError"),
    11: (20008, "UnknownError"),
}


def check(status, path=None):
    """Raises the exception of a failure.

    Args:
        status: what a function has returned.
        path: the file of which it was, for OSError.
    """
    if status == OK:
        return
    offset, length, system_error = _U64(), _U64(), ctypes.c_int()
    has_offset = library.gatun_error_place(
        ctypes.byref(offset), ctypes.byref(length), ctypes.byref(system_error)
    )
    message = library.gatun_error().decode("utf-8", "replace")
    place = offset.value if has_offset else None
    if status == NO_MEMORY or system_error.value == errno.ENOMEM:
        raise MemoryError(message)
    if system_error.value:
        raise OSError(system_error.value, _shorten(message, system_error.value, path), path)
    if status == NOT_HERE:
        raise NotHere(message, place, length.value)
    kind = Error
    if status == INVALID_INPUT:
        # What is wrong with data does not name the file that they are for.
        start = "" if path is None else f"{os.fsdecode(path)}: "
        kind, message = InputError, message if message.startswith(start) else start + message
    raise kind(message, *_CODES.get(status, (20008, "UnknownError")), place)


def _shorten(message, number, path):
    """A message without the name of the file, which OSError adds."""
    if path is None:
        return message
    start = f"{os.fspath(path)}: "
    return message[len(start) :] if message.startswith(start) else message or os.strerror(number)


class Call:
    """Callbacks of Python during a call of the library, whose exceptions are raised after it.

    ``progress`` is a function of the fraction from 0 to 1 that is done. It stops the call by
    returning False or raising an exception.
    """

    def __init__(self, progress=None):
        self._progress = progress
        self._failure = None
        self.function = Progress(self._report) if progress else Progress()

    @property
    def arguments(self):
        """The last two arguments of a function of the library."""
        return self.function, None

    def _report(self, fraction, _):
        try:
            return 0 if self._progress(fraction) is False else 1
        except BaseException as error:  # pylint: disable=broad-except
            self._failure = error
            return 0

    def check(self, status, path=None):
        """Raises what a callback has raised, or else the failure of the library."""
        if self._failure is not None:
            # A cycle of the exception, its frames and this object would keep arrays alive.
            failure, self._failure = self._failure, None
            try:
                raise failure
            finally:
                del failure
        check(status, path)


def encode(path):
    """A path as the library takes it: UTF-8 on Windows."""
    text = os.fspath(path)
    data = text if isinstance(text, bytes) else None
    if data is None:
        data = text.encode("utf-8") if sys.platform == "win32" else os.fsencode(text)
    if b"\0" in data:
        raise ValueError(f"{path!r}: has a zero")
    return data


def encode_text(text, what):
    """A text as the library takes it."""
    data = text.encode("utf-8", "surrogateescape")
    if b"\0" in data:
        raise ValueError(f"{what}: {text!r} has a zero")
    return data


def decode_text(data):
    """A text of the library, which may be any bytes."""
    return (data or b"").decode("utf-8", "surrogateescape")
