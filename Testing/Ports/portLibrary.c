/* SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors */
/* SPDX-License-Identifier: BSD-3-Clause */

/* Compares systems by the C interface alone: portLibrary FILE... prints a line for each .gtn or
 * .ghv file, with the hash of all that is read of it, of an isosurface and a slice, and of the file
 * that is written of its first step. Works in the current folder. See portHashes.cxx for the core.
 */

#include <gatun.h>

#include <math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Umlauts, letters beyond the first 65,536 of Unicode, and with its folder more than the 260
 * characters of Windows. */
#define FORTY "0123456789012345678901234567890123456789"
static const char* const long_name =
  "gr\xC3\xB6\xC3\x9F"
  "e \xE6\xB5\xAA \xF0\x9D\x84\x9E " FORTY FORTY FORTY FORTY FORTY ".gtn";
static const char* const copy_name = "portLibrary.gtn";

static int failures = 0;

static void expect(int holds, const char* what)
{
  if (!holds)
  {
    printf("portLibrary: failed: %s: %s\n", what, gatun_error());
    ++failures;
  }
}

static void stop_unless(gatun_status status)
{
  if (status != GATUN_OK)
  {
    printf("portLibrary: %s\n", gatun_error());
    exit(1);
  }
}

/* FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv */
static uint64_t add_bytes(uint64_t hash, const void* bytes, uint64_t count)
{
  const unsigned char* at = bytes;
  uint64_t i;
  for (i = 0; i < count; ++i)
  {
    hash = (hash ^ at[i]) * 1099511628211u;
  }
  return hash;
}

static const uint64_t first_hash = 14695981039346656037u;

static uint64_t size_of(gatun_type type)
{
  static const uint64_t sizes[] = { 0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8 };
  return sizes[type];
}

static gatun_buffer allocate(uint64_t bytes)
{
  gatun_buffer made;
  made.data = calloc(bytes > 0 ? bytes : 1, 1);
  made.bytes = bytes;
  if (!made.data)
  {
    printf("portLibrary: no memory\n");
    exit(1);
  }
  return made;
}

/* All that is read of a piece. */
typedef struct piece
{
  gatun_sizes sizes;
  gatun_buffers buffers;
  gatun_buffer* arrays;
} piece;

static uint64_t add_buffer(uint64_t hash, const gatun_buffer* buffer)
{
  return add_bytes(hash, buffer->data, buffer->bytes);
}

static uint64_t add_piece(uint64_t hash, const piece* from)
{
  size_t i;
  hash = add_buffer(hash, &from->buffers.points);
  hash = add_buffer(hash, &from->buffers.connectivity);
  hash = add_buffer(hash, &from->buffers.offsets);
  hash = add_buffer(hash, &from->buffers.types);
  hash = add_buffer(hash, &from->buffers.face_locations);
  hash = add_buffer(hash, &from->buffers.faces);
  for (i = 0; i < from->buffers.array_count; ++i)
  {
    hash = add_buffer(hash, &from->arrays[i]);
  }
  return hash;
}

static void free_piece(piece* from)
{
  size_t i;
  free(from->buffers.points.data);
  free(from->buffers.connectivity.data);
  free(from->buffers.offsets.data);
  free(from->buffers.types.data);
  free(from->buffers.face_locations.data);
  free(from->buffers.faces.data);
  for (i = 0; i < from->buffers.array_count; ++i)
  {
    free(from->arrays[i].data);
  }
  free(from->arrays);
}

/* Reads a piece that has been prepared. */
static piece read_piece(
  gatun_file* file, gatun_piece* prepared, const gatun_sizes* sizes, const gatun_request* request)
{
  piece to;
  size_t i;
  memset(&to, 0, sizeof(to));
  to.sizes = *sizes;
  to.buffers.size = sizeof(to.buffers);
  to.buffers.wide_ids = 1;
  to.buffers.points = allocate(3 * sizes->points * size_of(sizes->coordinate_type));
  to.buffers.connectivity = allocate(8 * sizes->connectivity);
  if (sizes->cell_type == 0)
  {
    to.buffers.offsets = allocate(8 * (sizes->cells + 1));
    to.buffers.types = allocate(sizes->cells);
    if (sizes->faces > 0)
    {
      to.buffers.face_locations = allocate(8 * sizes->cells);
      to.buffers.faces = allocate(8 * sizes->faces);
    }
  }
  to.arrays = calloc(request->array_count + 1, sizeof(gatun_buffer));
  for (i = 0; i < request->array_count; ++i)
  {
    gatun_array array = GATUN_INIT(gatun_array);
    stop_unless(gatun_get_array(file, request->arrays[i], &array));
    to.arrays[i] = allocate(
      (array.is_cell ? sizes->cells : sizes->points) * array.components * size_of(array.type));
  }
  to.buffers.arrays = to.arrays;
  to.buffers.array_count = request->array_count;
  stop_unless(gatun_read(prepared, &to.buffers, NULL, NULL));
  gatun_end(prepared);
  return to;
}

static piece read_step(gatun_file* file, const gatun_request* request)
{
  gatun_sizes sizes = GATUN_INIT(gatun_sizes);
  gatun_piece* prepared = NULL;
  stop_unless(gatun_prepare(file, request, &sizes, NULL, NULL, &prepared));
  return read_piece(file, prepared, &sizes, request);
}

/* Bits of NaN that arithmetic makes depend on the system. */
static void unify_nans(const gatun_buffer* buffer, gatun_type type)
{
  float* const narrow = buffer->data;
  double* const wide = buffer->data;
  const uint64_t count = buffer->bytes / size_of(type);
  uint64_t i;
  for (i = 0; i < count && type == GATUN_FLOAT32; ++i)
  {
    narrow[i] = narrow[i] == narrow[i] ? narrow[i] : (float)NAN;
  }
  for (i = 0; i < count && type == GATUN_FLOAT64; ++i)
  {
    wide[i] = wide[i] == wide[i] ? wide[i] : (double)NAN;
  }
}

/* Reads triangles that have been prepared, and adds them. */
static uint64_t add_surface(uint64_t hash, gatun_file* file, gatun_piece* prepared, const gatun_sizes* sizes,
  const gatun_request* request)
{
  piece got = read_piece(file, prepared, sizes, request);
  size_t i;
  unify_nans(&got.buffers.points, sizes->coordinate_type);
  for (i = 0; i < request->array_count; ++i)
  {
    gatun_array array = GATUN_INIT(gatun_array);
    stop_unless(gatun_get_array(file, request->arrays[i], &array));
    unify_nans(&got.arrays[i], array.type);
  }
  hash = add_piece(hash, &got);
  free_piece(&got);
  return hash;
}

/* An isosurface of the first point array at the middle of its values, and a slice through the
 * middle of the mesh. */
static uint64_t hash_surfaces(gatun_file* file, const gatun_info* info, const gatun_request* all)
{
  uint64_t hash = first_hash;
  gatun_request request = *all;
  gatun_sizes sizes = GATUN_INIT(gatun_sizes);
  gatun_piece* prepared = NULL;
  uint32_t number;
  int axis;
  for (number = 0; number < info->arrays; ++number)
  {
    gatun_array array = GATUN_INIT(gatun_array);
    stop_unless(gatun_get_array(file, number, &array));
    if (!array.is_cell)
    {
      gatun_contour contour = GATUN_INIT(gatun_contour);
      double range[2], middle;
      stop_unless(gatun_get_range(file, number, 0, 0, range));
      middle = range[0] + (range[1] - range[0]) / 2;
      contour.array = number;
      contour.values = &middle;
      contour.value_count = range[0] <= range[1] && isfinite(middle);
      stop_unless(gatun_prepare_contour(file, &request, &contour, &sizes, NULL, NULL, &prepared));
      hash = add_surface(hash, file, prepared, &sizes, &request);
      break;
    }
  }
  for (axis = 0; axis < 3; ++axis)
  {
    request.origin[axis] = (info->bounds[2 * axis] + info->bounds[2 * axis + 1]) / 2;
    request.normal[axis] = axis + 1;
  }
  stop_unless(gatun_prepare_slice(file, &request, &sizes, NULL, NULL, &prepared));
  return add_surface(hash, file, prepared, &sizes, &request);
}

/* Writes a step to a file, in its order. */
static gatun_status write_copy(
  gatun_file* file, const gatun_info* info, const piece* from, const char* path)
{
  gatun_mesh mesh = GATUN_INIT(gatun_mesh);
  gatun_options options = GATUN_INIT(gatun_options);
  gatun_values values = GATUN_INIT(gatun_values);
  gatun_array* arrays = calloc(info->arrays + 1, sizeof(gatun_array));
  gatun_writer* writer = NULL;
  gatun_buffer offsets = { NULL, 0 }, types = { NULL, 0 };
  gatun_status status;
  uint64_t i;
  mesh.points = from->sizes.points;
  mesh.cells = from->sizes.cells;
  mesh.coordinate_type = from->sizes.coordinate_type;
  mesh.wide_ids = 1;
  mesh.is_surface = info->is_surface;
  mesh.coordinates = from->buffers.points.data;
  mesh.connectivity = from->buffers.connectivity.data;
  mesh.offsets = from->buffers.offsets.data;
  mesh.types = from->buffers.types.data;
  mesh.face_locations = from->buffers.face_locations.data;
  mesh.faces = from->buffers.faces.data;
  mesh.faces_size = from->sizes.faces;
  if (from->sizes.cell_type == 5) /* without types, all are tetrahedra */
  {
    offsets = allocate(8 * (mesh.cells + 1));
    types = allocate(mesh.cells);
    for (i = 0; i <= mesh.cells; ++i)
    {
      ((int64_t*)offsets.data)[i] = (int64_t)(3 * i);
    }
    memset(types.data, 5, mesh.cells);
    mesh.offsets = offsets.data;
    mesh.types = types.data;
  }
  for (i = 0; i < info->arrays; ++i)
  {
    arrays[i].size = sizeof(gatun_array);
    stop_unless(gatun_get_array(file, (uint32_t)i, &arrays[i]));
  }
  options.keep_order = GATUN_KEEP_POINTS | GATUN_KEEP_CELLS | GATUN_KEEP_CORNERS;
  values.arrays = from->arrays;
  values.array_count = from->buffers.array_count;
  status =
    gatun_create(path, &mesh, arrays, from->buffers.array_count, &options, NULL, NULL, &writer);
  if (status == GATUN_OK)
  {
    status = gatun_write_step(writer, &values, NULL, NULL);
    if (status == GATUN_OK)
    {
      status = gatun_finish(writer, NULL);
    }
    else
    {
      gatun_discard(writer);
    }
  }
  free(offsets.data);
  free(types.data);
  free(arrays);
  return status;
}

static uint64_t hash_file(const char* path)
{
  static unsigned char bytes[65536];
  uint64_t hash = first_hash;
  FILE* const file = fopen(path, "rb");
  size_t got;
  expect(file != NULL, "the copy can be opened");
  while (file && (got = fread(bytes, 1, sizeof(bytes), file)) > 0)
  {
    hash = add_bytes(hash, bytes, got);
  }
  if (file)
  {
    fclose(file);
  }
  return hash;
}

static gatun_request request_all(uint32_t arrays, uint32_t** numbers)
{
  gatun_request request = GATUN_INIT(gatun_request);
  uint32_t i;
  *numbers = calloc(arrays + 1, sizeof(uint32_t));
  for (i = 0; i < arrays; ++i)
  {
    (*numbers)[i] = i;
  }
  request.flags = GATUN_RESTORE_ORDER | GATUN_UNUSED_POINTS;
  request.arrays = *numbers;
  request.array_count = arrays;
  return request;
}

/* The copy has what it was made of, also under a long name in Unicode, and while a reader has it
 * open. */
static void check_copy(gatun_file* file, const gatun_info* info, const piece* from)
{
  const uint64_t wanted = add_piece(first_hash, from);
  gatun_file* copy = NULL;
  uint32_t* numbers = NULL;
  gatun_request request = request_all((uint32_t)from->buffers.array_count, &numbers);
  gatun_status status;
  piece back;
  status = write_copy(file, info, from, "no such folder/copy.gtn");
  expect(status == GATUN_CANNOT_WRITE && strstr(gatun_error(), "no such folder"),
    "a missing folder is told");
  stop_unless(write_copy(file, info, from, long_name));
  expect(gatun_kind_of(long_name) == (info->is_surface ? GATUN_KIND_SURFACE : GATUN_KIND_MESH),
    "the kind");
  stop_unless(gatun_open(long_name, 0, &copy));
  status = write_copy(file, info, from, long_name);
  expect(status == GATUN_OK || strlen(gatun_error()) > 0,
    "a file that is open is replaced, or a text says why not");
  back = read_step(copy, &request);
  expect(add_piece(first_hash, &back) == wanted, "what is read of the copy");
  free_piece(&back);
  gatun_close(copy);
  free(numbers);
}

static void print_mesh(const char* path)
{
  gatun_file* file = NULL;
  gatun_info info = GATUN_INIT(gatun_info);
  uint32_t* numbers = NULL;
  gatun_request request;
  uint64_t step, hash = first_hash;
  piece got;
  stop_unless(gatun_open(path, 0, &file));
  stop_unless(gatun_get_info(file, &info));
  request = request_all(info.steps > 0 ? info.arrays : 0, &numbers);
  for (step = info.steps > 0 ? info.steps : 1; step-- > 0;)
  {
    request.step = step;
    got = read_step(file, &request);
    hash = add_piece(hash, &got);
    if (step > 0)
    {
      free_piece(&got);
    }
  }
  printf(" read %016llx", (unsigned long long)hash);
  if (!info.is_surface)
  {
    printf(" surfaces %016llx", (unsigned long long)hash_surfaces(file, &info, &request));
  }
  if (info.steps > 0)
  {
    stop_unless(write_copy(file, &info, &got, copy_name));
    printf(" written %016llx", (unsigned long long)hash_file(copy_name));
    remove(copy_name);
    check_copy(file, &info, &got);
  }
  free_piece(&got);
  free(numbers);
  gatun_close(file);
}

static void print_volume(const char* path)
{
  gatun_volume* volume = NULL;
  gatun_volume_info info = GATUN_INIT(gatun_volume_info);
  const uint32_t first[3] = { 0, 0, 0 };
  gatun_buffer voxels;
  stop_unless(gatun_open_volume(path, &volume));
  stop_unless(gatun_get_volume_info(volume, &info));
  voxels = allocate(
    (uint64_t)info.dimensions[0] * info.dimensions[1] * info.dimensions[2] * size_of(info.type));
  stop_unless(gatun_read_voxels(volume, first, info.dimensions, &voxels, NULL, NULL));
  printf(" read %016llx", (unsigned long long)add_buffer(first_hash, &voxels));
  free(voxels.data);
  gatun_close_volume(volume);
}

int main(int argc, char* argv[])
{
  gatun_file* none = NULL;
  int i;
  expect(gatun_open("no such file.gtn", 0, &none) == GATUN_CANNOT_OPEN &&
      strstr(gatun_error(), "no such file.gtn"),
    "a missing file is told");
  for (i = 1; i < argc; ++i)
  {
    const char* name = argv[i] + strlen(argv[i]);
    while (name > argv[i] && name[-1] != '/' && name[-1] != '\\')
    {
      --name;
    }
    printf("%s", name);
    if (strcmp(name + strlen(name) - 4, ".ghv") == 0)
    {
      print_volume(argv[i]);
    }
    else
    {
      print_mesh(argv[i]);
    }
    printf("\n");
    fflush(stdout);
  }
  return failures > 0;
}
