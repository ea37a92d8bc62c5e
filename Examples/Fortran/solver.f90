! SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
! SPDX-License-Identifier: BSD-3-Clause

!> A solver that writes its steps into one file: solver_fortran FILE
program solver
  use gatun
  implicit none

  integer, parameter :: side = 9, steps = 5
  integer, parameter :: points = side**3, cells = (side - 1)**3
  real(c_double), target :: coordinates(3, points), temperature(points)
  integer(c_int32_t), target :: connectivity(8, cells), offsets(cells + 1)
  integer(c_int8_t), target :: types(cells)
  character(kind=c_char), target :: name(12) = [character(kind=c_char) :: &
    't', 'e', 'm', 'p', 'e', 'r', 'a', 't', 'u', 'r', 'e', c_null_char]
  type(gatun_mesh) :: mesh
  type(gatun_array) :: arrays(1)
  type(gatun_options) :: options
  type(gatun_values) :: values
  type(gatun_buffer), target :: buffer
  type(c_ptr) :: writer
  integer(c_int64_t) :: bytes
  character(len=4096) :: path
  integer :: step

  call get_command_argument(1, path)
  call make_mesh()
  mesh = new_mesh()
  mesh%points = points
  mesh%cells = cells
  mesh%coordinates = c_loc(coordinates)
  mesh%connectivity = c_loc(connectivity)
  mesh%offsets = c_loc(offsets)
  mesh%types = c_loc(types)
  arrays(1) = new_array()
  arrays(1)%name = c_loc(name)
  arrays(1)%type = GATUN_FLOAT64
  options = new_options()
  options%keep_order = GATUN_KEEP_POINTS + GATUN_KEEP_CELLS
  call check(gatun_create(trim(path)//c_null_char, mesh, arrays, 1_c_size_t, options, &
    c_null_funptr, c_null_ptr, writer))
  do step = 1, steps
    temperature = sin(0.3d0*coordinates(1, :) + 0.1d0*step)*cos(0.2d0*coordinates(2, :))
    buffer%data = c_loc(temperature)
    buffer%bytes = c_sizeof(temperature)
    values = new_values()
    values%arrays = c_loc(buffer)
    values%array_count = 1
    values%has_time = 1
    values%time = 0.1d0*step
    call check(gatun_write_step(writer, values, c_null_funptr, c_null_ptr))
  end do
  call check(gatun_finish(writer, bytes))
  print '(i0, a, i0, a)', points, ' points, ', steps, ' steps'

contains

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status /= GATUN_OK) then
      print '(a)', gatun_message()
      error stop 1
    end if
  end subroutine

  !> Hexahedra of a cube. Ids count from 0.
  subroutine make_mesh()
    integer :: x, y, z, point, cell
    cell = 0
    do z = 0, side - 1
      do y = 0, side - 1
        do x = 0, side - 1
          point = x + side*(y + side*z)
          coordinates(:, point + 1) = [x, y, z]
          if (max(x, y, z) < side - 1) then
            cell = cell + 1
            connectivity(1:4, cell) = point + [0, 1, side + 1, side]
            connectivity(5:8, cell) = connectivity(1:4, cell) + side*side
          end if
        end do
      end do
    end do
    offsets = 8*[(point, point=0, cells)]
    types = 12 ! VTK_HEXAHEDRON
  end subroutine

end program
