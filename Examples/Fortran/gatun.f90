! SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
! SPDX-License-Identifier: BSD-3-Clause

!> What a solver needs of gatun.h, which documents it: writing meshes and steps. Structures begin with
!! their size, which the constructors below set; all other members are 0 or null by default.
module gatun
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int), parameter :: GATUN_OK = 0
  integer(c_int), parameter :: GATUN_INT32 = 5, GATUN_INT64 = 7, GATUN_FLOAT32 = 9, GATUN_FLOAT64 = 10
  integer(c_int32_t), parameter :: GATUN_KEEP_POINTS = 1, GATUN_KEEP_CELLS = 2, GATUN_KEEP_CORNERS = 4

  type, bind(c) :: gatun_buffer
    type(c_ptr) :: data = c_null_ptr
    integer(c_int64_t) :: bytes = 0
  end type

  type, bind(c) :: gatun_array
    integer(c_size_t) :: size = 0
    type(c_ptr) :: name = c_null_ptr
    integer(c_int32_t) :: is_cell = 0
    integer(c_int) :: type = 0
    integer(c_int32_t) :: components = 1
    integer(c_int32_t) :: vtk_type = 0
    integer(c_int32_t) :: roles = 0
    type(c_ptr) :: component_names = c_null_ptr
    type(c_ptr) :: keys = c_null_ptr
    integer(c_int32_t) :: key_count = 0
    type(c_ptr) :: error = c_null_ptr
    type(c_ptr) :: values = c_null_ptr
    real(c_double) :: weight = 0
  end type

  type, bind(c) :: gatun_mesh
    integer(c_size_t) :: size = 0
    integer(c_int64_t) :: points = 0
    integer(c_int64_t) :: cells = 0
    integer(c_int) :: coordinate_type = GATUN_FLOAT64
    integer(c_int32_t) :: wide_ids = 0
    integer(c_int32_t) :: is_surface = 0
    type(c_ptr) :: coordinates = c_null_ptr
    type(c_ptr) :: connectivity = c_null_ptr
    type(c_ptr) :: types = c_null_ptr
    type(c_ptr) :: offsets = c_null_ptr
    type(c_ptr) :: face_locations = c_null_ptr
    type(c_ptr) :: faces = c_null_ptr
    integer(c_int64_t) :: faces_size = 0
    type(c_ptr) :: point_array = c_null_ptr
  end type

  type, bind(c) :: gatun_options
    integer(c_size_t) :: size = 0
    integer(c_int32_t) :: keep_order = 0
    integer(c_int) :: profile = 0
    integer(c_int32_t) :: chunk_size = 0
    integer(c_int32_t) :: key_step_interval = 0
    integer(c_int32_t) :: points_move = 0
    integer(c_int32_t) :: boundary = 0
    integer(c_int32_t) :: hierarchy = 0
    integer(c_int32_t) :: levels = 0
    integer(c_int32_t) :: dependencies = 0
    integer(c_int) :: layers = 0
    integer(c_int32_t) :: layer_array = 0
    integer(c_int32_t) :: layer_component = 0
    integer(c_int32_t) :: layer_count = 0
    integer(c_int32_t) :: parts = 0
    type(c_ptr) :: error = c_null_ptr
  end type

  type, bind(c) :: gatun_values
    integer(c_size_t) :: size = 0
    type(c_ptr) :: arrays = c_null_ptr
    integer(c_size_t) :: array_count = 0
    integer(c_int32_t) :: has_time = 0
    real(c_double) :: time = 0
    type(c_ptr) :: coordinates = c_null_ptr
    type(c_ptr) :: fields = c_null_ptr
    integer(c_size_t) :: field_count = 0
    type(c_ptr) :: remaining_cells = c_null_ptr
    integer(c_int64_t) :: remaining_cell_count = 0
    integer(c_int32_t) :: drops_points = 0
    type(c_ptr) :: remaining_points = c_null_ptr
    integer(c_int64_t) :: remaining_point_count = 0
  end type

  interface
    function gatun_create(path, mesh, arrays, array_count, options, progress, user, writer) &
        bind(c) result(status)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(gatun_mesh), intent(in) :: mesh
      type(gatun_array), intent(in) :: arrays(*)
      integer(c_size_t), value :: array_count
      type(gatun_options), intent(in) :: options
      type(c_funptr), value :: progress
      type(c_ptr), value :: user
      type(c_ptr), intent(out) :: writer
      integer(c_int) :: status
    end function

    !> arrays, options: c_null_ptr, or as for gatun_create.
    function gatun_append(path, arrays, array_count, options, writer) bind(c) result(status)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: arrays
      integer(c_size_t), value :: array_count
      type(c_ptr), value :: options
      type(c_ptr), intent(out) :: writer
      integer(c_int) :: status
    end function

    !> first: c_null_ptr, or the values of the first step. number: c_null_ptr, or where the number
    !> of the mesh goes.
    function gatun_add_mesh(writer, mesh, first, progress, user, number) bind(c) result(status)
      import
      type(c_ptr), value :: writer
      type(gatun_mesh), intent(in) :: mesh
      type(c_ptr), value :: first
      type(c_funptr), value :: progress
      type(c_ptr), value :: user
      type(c_ptr), value :: number
      integer(c_int) :: status
    end function

    function gatun_write_step(writer, values, progress, user) bind(c) result(status)
      import
      type(c_ptr), value :: writer
      type(gatun_values), intent(in) :: values
      type(c_funptr), value :: progress
      type(c_ptr), value :: user
      integer(c_int) :: status
    end function

    function gatun_finish(writer, file_bytes) bind(c) result(status)
      import
      type(c_ptr), value :: writer
      integer(c_int64_t), intent(out) :: file_bytes
      integer(c_int) :: status
    end function

    subroutine gatun_discard(writer) bind(c)
      import
      type(c_ptr), value :: writer
    end subroutine

    subroutine gatun_set_threads(threads) bind(c)
      import
      integer(c_int), value :: threads
    end subroutine

    function gatun_error() bind(c) result(text)
      import
      type(c_ptr) :: text
    end function
  end interface

contains

  !> The text of the last failure of this thread.
  function gatun_message() result(message)
    character(len=:), allocatable :: message
    character(kind=c_char), pointer :: text(:)
    integer :: length
    call c_f_pointer(gatun_error(), text, [2048])
    length = 0
    do while (text(length + 1) /= c_null_char)
      length = length + 1
    end do
    allocate (character(len=length) :: message)
    message = transfer(text(1:length), message)
  end function

  function new_array() result(made)
    type(gatun_array) :: made
    made%size = c_sizeof(made)
  end function

  function new_mesh() result(made)
    type(gatun_mesh) :: made
    made%size = c_sizeof(made)
  end function

  function new_options() result(made)
    type(gatun_options) :: made
    made%size = c_sizeof(made)
  end function

  function new_values() result(made)
    type(gatun_values) :: made
    made%size = c_sizeof(made)
  end function

end module
