/* SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors */
/* SPDX-License-Identifier: BSD-3-Clause */

/* A solver that writes its steps as they are computed, and reads the last one again:
 *
 *     solver FILE [STEPS]
 *
 * The file can be opened in ParaView between two steps: each run of the loop appends one.
 */

#include <gatun.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
  SIDE = 17, /* points along each axis of a cube */
  POINTS = SIDE * SIDE * SIDE,
  CELLS = (SIDE - 1) * (SIDE - 1) * (SIDE - 1)
};

static float coordinates[3 * POINTS];
static int32_t connectivity[8 * CELLS];
static int32_t offsets[CELLS + 1];
static uint8_t types[CELLS];
static float temperature[POINTS];

static void stop_unless(gatun_status status)
{
  if (status != GATUN_OK)
  {
    fprintf(stderr, "solver: %s\n", gatun_error());
    exit(1);
  }
}

static gatun_mesh make_mesh(void)
{
  static const int corners[8] = { 0, 1, SIDE + 1, SIDE, SIDE * SIDE, SIDE * SIDE + 1,
    SIDE * SIDE + SIDE + 1, SIDE * SIDE + SIDE };
  gatun_mesh mesh = GATUN_INIT(gatun_mesh);
  int i, k, cell = 0;
  for (i = 0; i < POINTS; ++i)
  {
    const int x = i % SIDE, y = i / SIDE % SIDE, z = i / SIDE / SIDE;
    coordinates[3 * i] = (float)x;
    coordinates[3 * i + 1] = (float)y;
    coordinates[3 * i + 2] = (float)z;
    if (x < SIDE - 1 && y < SIDE - 1 && z < SIDE - 1)
    {
      for (k = 0; k < 8; ++k)
      {
        connectivity[8 * cell + k] = i + corners[k];
      }
      types[cell] = 12; /* VTK_HEXAHEDRON */
      ++cell;
      offsets[cell] = 8 * cell;
    }
  }
  mesh.points = POINTS;
  mesh.cells = CELLS;
  mesh.coordinate_type = GATUN_FLOAT32;
  mesh.coordinates = coordinates;
  mesh.connectivity = connectivity;
  mesh.offsets = offsets;
  mesh.types = types;
  return mesh;
}

/* The "solution" of a step. */
static void solve(int step)
{
  int i;
  for (i = 0; i < POINTS; ++i)
  {
    const float* at = coordinates + 3 * i;
    temperature[i] = sinf(0.3f * at[0] + 0.1f * (float)step) * cosf(0.2f * at[1]) + 0.05f * at[2];
  }
}

static void write_step(gatun_writer* writer, double time)
{
  gatun_values values = GATUN_INIT(gatun_values);
  gatun_buffer buffer;
  buffer.data = temperature;
  buffer.bytes = sizeof(temperature);
  values.arrays = &buffer;
  values.array_count = 1;
  values.has_time = 1;
  values.time = time;
  stop_unless(gatun_write_step(writer, &values, NULL, NULL));
}

static void read_step(const char* path, uint64_t step)
{
  static float read[POINTS];
  const uint32_t number = 0;
  gatun_request request = GATUN_INIT(gatun_request);
  gatun_sizes sizes = GATUN_INIT(gatun_sizes);
  gatun_buffers buffers = GATUN_INIT(gatun_buffers);
  gatun_buffer buffer;
  gatun_file* file = NULL;
  gatun_piece* piece = NULL;
  stop_unless(gatun_open(path, 0, &file));
  request.step = step;
  request.flags = GATUN_RESTORE_ORDER | GATUN_UNUSED_POINTS;
  request.arrays = &number;
  request.array_count = 1;
  stop_unless(gatun_prepare(file, &request, &sizes, NULL, NULL, &piece));
  if (sizes.points != POINTS)
  {
    fprintf(stderr, "solver: %s has %lu points\n", path, (unsigned long)sizes.points);
    exit(1);
  }
  buffer.data = read;
  buffer.bytes = sizeof(read);
  buffers.arrays = &buffer;
  buffers.array_count = 1;
  stop_unless(gatun_read(piece, &buffers, NULL, NULL));
  gatun_end(piece);
  gatun_close(file);
  printf("%d points, %d cells, step %d: %s\n", POINTS, CELLS, (int)step,
    memcmp(read, temperature, sizeof(read)) == 0 ? "equal" : "different");
}

int main(int argc, char* argv[])
{
  const int steps = argc > 2 ? atoi(argv[2]) : 4;
  gatun_options options = GATUN_INIT(gatun_options);
  gatun_array array = GATUN_INIT(gatun_array);
  gatun_mesh mesh;
  gatun_writer* writer = NULL;
  int step;
  if (argc < 2)
  {
    fprintf(stderr, "usage: solver FILE [STEPS]\n");
    return 2;
  }
  mesh = make_mesh();
  options.keep_order = GATUN_KEEP_POINTS | GATUN_KEEP_CELLS;
  array.name = "temperature";
  array.type = GATUN_FLOAT32;
  array.components = 1;
  for (step = 0; step < steps; ++step)
  {
    solve(step);
    if (step == 0)
    {
      stop_unless(gatun_create(argv[1], &mesh, &array, 1, &options, NULL, NULL, &writer));
    }
    else
    {
      stop_unless(gatun_append(argv[1], NULL, 0, NULL, &writer));
      stop_unless(gatun_add_mesh(writer, &mesh, NULL, NULL, NULL, NULL));
    }
    write_step(writer, 0.1 * step);
    stop_unless(gatun_finish(writer, NULL));
  }
  read_step(argv[1], (uint64_t)(steps - 1));
  return 0;
}
