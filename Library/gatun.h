/* SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors */
/* SPDX-License-Identifier: BSD-3-Clause */

/**
 * @file
 * @brief Gatun's C interface: reads and writes .gtn and .ghv files without VTK.
 *
 * - **Results.** Every function that can fail returns a gatun_status. Results come by pointer and
 * are untouched after a failure. gatun_error() is the text of the last failure of the calling
 * thread. No exception, signal or output leaves the library.
 * - **Structures** begin with their size in bytes. Begin with GATUN_INIT, or set all to 0 and size
 * to the size of the structure. The library reads and fills only so many bytes, so that members can
 * be added at the end. Zero is the default of every member. Enumerations get new members only.
 *   Functions never change.
 * - **Memory.** Who allocates frees. The library keeps no pointer of the caller after a call,
 * except the mesh and the arrays of a writer until gatun_finish or gatun_discard, and callbacks
 * with their user pointers. Strings of the library live as long as the object that they come from.
 * - **Buffers** come with their sizes in bytes, and nothing is written behind them. A null pointer
 *   leaves a buffer out.
 * - **Threads.** Any number of threads may use a gatun_file or gatun_volume at once; one at a time
 * may use a gatun_piece, gatun_fields or gatun_writer. gatun_close may precede gatun_end: pieces
 * keep what they need. Progress is reported by the calling thread only; a source is read by any
 * thread, by several at once.
 * - **Text** is UTF-8, also in paths on Windows. Names in files may be any text, and may repeat.
 * - **Hostile input.** For any bytes of a file, functions return. Sizes that they report may be
 * larger than the memory of the caller, who should look at them before allocating.
 * - **Numbers.** Cell types are those of VTK (vtkCellType.h). Ids count from 0. Bounds are xmin,
 * xmax, ymin, ymax, zmin, zmax, with xmin > xmax if there is no point.
 */
#ifndef GATUN_H
#define GATUN_H

#include <stddef.h>
#include <stdint.h>

#define GATUN_API_VERSION 1

#if defined(_WIN32) && defined(GATUN_BUILDING)
#define GATUN_API __declspec(dllexport)
#elif defined(_WIN32)
#define GATUN_API __declspec(dllimport)
#elif defined(__GNUC__)
#define GATUN_API __attribute__((visibility("default")))
#else
#define GATUN_API
#endif

#ifdef __cplusplus
extern "C"
{
#endif

  typedef enum gatun_status
  {
    GATUN_OK = 0,
    GATUN_CANNOT_OPEN = 1, /**< missing, a directory, no permission */
    GATUN_NOT_GATUN = 2,   /**< the file does not begin as a .gtn or .ghv file does */
    GATUN_UNSUPPORTED_VERSION = 3,
    GATUN_TRUNCATED = 4,
    GATUN_CORRUPT = 5,
    GATUN_CANNOT_WRITE = 6,
    GATUN_INVALID_INPUT = 7,
    GATUN_ABORTED = 8,
    GATUN_NOT_HERE = 9, /**< the source of a file does not have the bytes yet */
    GATUN_NO_MEMORY = 10,
    GATUN_INTERNAL = 11
  } gatun_status;

  /** The type of a number. */
  typedef enum gatun_type
  {
    GATUN_INT8 = 1,
    GATUN_UINT8 = 2,
    GATUN_INT16 = 3,
    GATUN_UINT16 = 4,
    GATUN_INT32 = 5,
    GATUN_UINT32 = 6,
    GATUN_INT64 = 7,
    GATUN_UINT64 = 8,
    GATUN_FLOAT32 = 9,
    GATUN_FLOAT64 = 10
  } gatun_type;

  /** What a file is. */
  typedef enum gatun_kind
  {
    GATUN_KIND_NONE = 0,
    GATUN_KIND_MESH = 1,   /**< a .gtn file, whose cells are any */
    GATUN_KIND_VOLUME = 2, /**< a .ghv file */
    GATUN_KIND_SURFACE = 3 /**< a .gtn file of a surface, as vtkPolyData */
  } gatun_kind;

  typedef struct gatun_file gatun_file;
  typedef struct gatun_fields gatun_fields;
  typedef struct gatun_piece gatun_piece;
  typedef struct gatun_volume gatun_volume;
  typedef struct gatun_writer gatun_writer;

  /** Returns 0 to stop the call, which then returns GATUN_ABORTED. fraction: 0 to 1. */
  typedef int (*gatun_progress)(double fraction, void* user);

#define GATUN_INIT(type) \
  {                      \
    sizeof(type)         \
  }

  typedef struct gatun_buffer
  {
    void* data;
    uint64_t bytes;
  } gatun_buffer;

  /* ---- The library ---- */

  /** GATUN_API_VERSION of the library, which counts additions. */
  GATUN_API uint32_t gatun_api_version(void);

  /** The version of the library, "0.1.0". */
  GATUN_API const char* gatun_version(void);

  /** The text of the last failure of this thread, with file, place and problem. Never null. */
  GATUN_API const char* gatun_error(void);

  /** Where that failure is: 1 if the text names a position in a file, and 0 otherwise. length: with
   * GATUN_NOT_HERE the number of missing bytes from there. system_error: a value of errno, or 0.
   * Null pointers are skipped. */
  GATUN_API int gatun_error_place(uint64_t* offset, uint64_t* length, int* system_error);

  /** The number of threads of the whole process; 0 for the default: one for each processor that the
   * affinity of the process and the quota of its container allow. */
  GATUN_API void gatun_set_threads(int threads);
  GATUN_API int gatun_threads(void);

  /** What a file on disk is, by its first bytes; of a .gtn file, those of its directory, too. */
  GATUN_API gatun_kind gatun_kind_of(const char* path);

  /* ---- Files of meshes: opening and description ---- */

  /** Bytes of a file. */
  typedef struct gatun_range
  {
    uint64_t offset, length;
  } gatun_range;

  /** Bytes that come from the caller. */
  typedef struct gatun_source
  {
    size_t size;
    uint64_t bytes; /**< of the file */

    /** Reads all of the bytes. Returns 0, GATUN_SOURCE_NOT_HERE or a value of errno. */
    int (*read)(void* user, uint64_t offset, void* to, size_t length);
    void (*close)(void* user); /**< may be null; called once, also if the file cannot be opened */
    void* user;
    const char* name; /**< of the file, in messages; may be null */

    /** Announces ranges that will be read, by ascending offset, so that few requests over a network
     * bring them. Returns as read does. May be null. */
    int (*fetch)(void* user, const gatun_range* ranges, size_t count);
  } gatun_source;

  enum
  {
    /** The function that needs the bytes returns GATUN_NOT_HERE, and can be called again when they
     * have come. gatun_plan tells what a piece needs. */
    GATUN_SOURCE_NOT_HERE = -1
  };

  /** cache_bytes: memory for decoded parts, which further pieces use; 0: 512 MiB. */
  GATUN_API gatun_status gatun_open(const char* path, uint64_t cache_bytes, gatun_file** file);
  GATUN_API gatun_status gatun_open_source(
    const gatun_source* source, uint64_t cache_bytes, gatun_file** file);
  GATUN_API void gatun_close(gatun_file* file);

  typedef struct gatun_info
  {
    size_t size;
    uint64_t points, cells; /**< of the first mesh, as the next ones */
    uint64_t tets;          /**< of which the cells consist */
    double bounds[6];
    gatun_type coordinate_type;
    uint32_t arrays;
    uint32_t steps; /**< of all meshes */
    uint32_t meshes;
    uint32_t levels; /**< coarser meshes in the file */
    uint32_t chunks;
    uint32_t kept_order; /**< GATUN_KEEP_... */
    int32_t is_surface, is_tetrahedral, has_time, has_hierarchy, has_boundary, has_wide_ids,
      points_move;
    uint32_t format_version;
    const char* writer_version;
    uint64_t bytes_read; /**< of the file, since it was opened */
  } gatun_info;

  GATUN_API gatun_status gatun_get_info(gatun_file* file, gatun_info* info);

  /** The description that `gtn info --json` prints. length: the size of the text with its end, in
   * bytes; text may be null to ask for it. verbose: also each chunk. */
  GATUN_API gatun_status gatun_describe(
    gatun_file* file, int verbose, char* text, size_t capacity, size_t* length);

  /** An information key of an array, such as its unit. */
  typedef struct gatun_key
  {
    size_t size;
    const char* location; /**< the class of VTK that defines it */
    const char* name;
    uint32_t kind;           /**< KeyKind of the file format */
    uint32_t count;          /**< of the numbers or texts */
    const uint64_t* numbers; /**< the bits of 64-bit integers or doubles; null for texts */
    const char* const* texts;
  } gatun_key;

  typedef struct gatun_array
  {
    size_t size;
    const char* name;
    int32_t is_cell; /**< 0: of points */
    gatun_type type;
    uint32_t components;
    int32_t vtk_type;                   /**< as in vtkType.h; 0: unknown */
    uint32_t roles;                     /**< bit i: active attribute i of vtkDataSetAttributes */
    const char* const* component_names; /**< null if there are none */
    const gatun_key* keys;
    uint32_t key_count;

    /* Writing only. */
    const char* error;  /**< "abs:E", "rel:E", "pw:E" or "bits:N", with ",zeros" at its end if zeros
                           stay; null: exact */
    const void* values; /**< at the first step, for a hierarchy or layers */
    double weight;      /**< in the hierarchy, relative to other arrays; if all are 0, the active
                           scalars count, or else all arrays */
  } gatun_array;

/** Stands for the array of the points: its names and keys. */
#define GATUN_POINT_ARRAY UINT32_MAX

  GATUN_API gatun_status gatun_get_array(
    gatun_file* file, uint32_t array, gatun_array* description);

  /** The range of a component of an array at a step, or of the length of the tuples if component is
   * -1. NaN is left out. The first number is larger if there is no value. */
  GATUN_API gatun_status gatun_get_range(
    gatun_file* file, uint32_t array, int32_t component, uint64_t step, double range[2]);

  typedef struct gatun_step
  {
    size_t size;
    double time;   /**< 0 without time */
    uint32_t mesh; /**< the number of the mesh */
    uint64_t points, cells;
    double bounds[6];
  } gatun_step;

  /** A time step; step 0 exists in every file. */
  GATUN_API gatun_status gatun_get_step(gatun_file* file, uint64_t step, gatun_step* description);

  typedef struct gatun_level
  {
    size_t size;
    uint64_t points, cells;
  } gatun_level;

  /** A coarser mesh, from 1 (the finest of them); 0 is the mesh itself. */
  GATUN_API gatun_status gatun_get_level(
    gatun_file* file, uint32_t level, gatun_level* description);

  /** An array of the whole mesh. */
  typedef struct gatun_field
  {
    size_t size;
    const char* name;
    gatun_type type; /**< 0 for texts */
    uint32_t components;
    int32_t vtk_type;
    const char* const* component_names;
    const gatun_key* keys;
    uint32_t key_count;
    uint64_t count; /**< of the numbers, of all components together, or of the texts */
    const void* values;
    const char* const* texts;
    const uint64_t* text_bytes; /**< the lengths of the texts, which may contain zeros; writing:
                                   null if they do not */
  } gatun_field;

  /** The field data of a step. count: of their arrays. To be freed by gatun_free_fields. */
  GATUN_API gatun_status gatun_get_fields(
    gatun_file* file, uint64_t step, gatun_fields** fields, uint32_t* count);
  GATUN_API gatun_status gatun_get_field(gatun_fields* fields, uint32_t index, gatun_field* field);
  GATUN_API void gatun_free_fields(gatun_fields* fields);

  /** Checks all checksums and decodes everything. */
  GATUN_API gatun_status gatun_verify(gatun_file* file, gatun_progress progress, void* user);

  /* ---- Files of meshes: pieces ---- */

  enum
  {
    GATUN_TETRAHEDRA = 1, /**< the tetrahedra of which the cells consist, in place of the cells */
    GATUN_RESTORE_ORDER = 2, /**< the original order, if the file keeps it and the piece is all */
    GATUN_UNUSED_POINTS = 4, /**< also the points that no cell uses, if the piece is all */
    GATUN_BOUNDARY = 8,      /**< the boundary in the file, in place of the mesh */
    GATUN_IN_BOX = 16,       /**< chunks that meet the box */
    GATUN_IN_RANGE = 32,     /**< chunks with values of an array in a range */
    GATUN_EXACT = 64,        /**< of these chunks, only the cells that meet box and range */
    GATUN_ON_PLANE = 128     /**< chunks that meet the plane */
  };

  typedef struct gatun_request
  {
    size_t size;
    uint64_t step;
    uint32_t piece, pieces; /**< piece 0 to pieces - 1; 0 of 0 is all. Pieces are of whole chunks */
    uint32_t ghost_levels;  /**< layers of cells around the piece */
    uint32_t flags;
    double box[6];        /**< with GATUN_IN_BOX */
    uint32_t range_array; /**< with GATUN_IN_RANGE: the array; the component or -1, its values */
    int32_t range_component;
    double range[2];
    double origin[3], normal[3]; /**< with GATUN_ON_PLANE */
    double ratio;           /**< the part of the points to leave out, 0 to 1; needs a hierarchy */
    uint32_t level;         /**< a coarser mesh in the file, in place of a ratio */
    const uint32_t* arrays; /**< numbers of arrays, ascending */
    size_t array_count;
  } gatun_request;

  typedef struct gatun_sizes
  {
    size_t size;
    uint64_t points, cells;
    uint64_t connectivity; /**< the number of its ids */
    uint64_t faces;        /**< the number of values of the faces of polyhedra */
    uint32_t cell_type; /**< tetrahedron (10) or triangle (5) if all cells are; then types, offsets
                           and faces are not wanted. Otherwise 0 */
    gatun_type coordinate_type;
  } gatun_sizes;

  /**
   * The ranges of the file that a piece needs, by ascending offset, without those of the tables
   * that have been read. Ranges with at most gap bytes between them are joined. count: of all; at
   * most capacity of them are written.
   *
   * GATUN_NOT_HERE: tables are missing. The ranges are theirs; when they have come, call it again.
   */
  GATUN_API gatun_status gatun_plan(gatun_file* file, const gatun_request* request, uint64_t gap,
    gatun_range* ranges, size_t capacity, size_t* count);

  /** Prepares a piece and tells its sizes. To be ended by gatun_end. */
  GATUN_API gatun_status gatun_prepare(gatun_file* file, const gatun_request* request,
    gatun_sizes* sizes, gatun_progress progress, void* user, gatun_piece** piece);

  typedef struct gatun_buffers
  {
    size_t size;
    gatun_buffer points;                /**< x, y, z of each point, of coordinate_type */
    gatun_buffer connectivity;          /**< the points of each cell */
    gatun_buffer offsets;               /**< cells + 1 places of the first point of each cell */
    gatun_buffer types;                 /**< uint8 */
    gatun_buffer face_locations, faces; /**< int64, as in vtkUnstructuredGrid */
    int32_t wide_ids;                   /**< connectivity and offsets are int64, or int32 if 0 */
    gatun_buffer point_ids, cell_ids;   /**< int64: original numbers, where the file keeps them */
    gatun_buffer point_ghosts, cell_ghosts; /**< uint8: 1 for those of another piece */
    gatun_buffer normals;                   /**< of isosurfaces: three float32 for each point */
    const gatun_buffer* arrays;             /**< as many as requested, or null */
    size_t array_count;
  } gatun_buffers;

  /** Fills buffers. May be called again. */
  GATUN_API gatun_status gatun_read(
    gatun_piece* piece, const gatun_buffers* buffers, gatun_progress progress, void* user);
  GATUN_API void gatun_end(gatun_piece* piece);

  /* ---- Isosurfaces, slices, images ---- */

  typedef struct gatun_contour
  {
    size_t size;
    uint32_t array; /**< of points */
    int32_t component;
    const double* values; /**< isovalues, ascending */
    size_t value_count;
    int32_t normals; /**< whether they will be read */
  } gatun_contour;

  /** Isosurfaces as a piece of triangles with the arrays of the request; of it count step, piece,
   * level and ratio. Only chunks with the values are decoded. */
  GATUN_API gatun_status gatun_prepare_contour(gatun_file* file, const gatun_request* request,
    const gatun_contour* contour, gatun_sizes* sizes, gatun_progress progress, void* user,
    gatun_piece** piece);

  /** The section with the plane of the request, as a piece of triangles. Only chunks at the plane
   * are decoded. */
  GATUN_API gatun_status gatun_prepare_slice(gatun_file* file, const gatun_request* request,
    gatun_sizes* sizes, gatun_progress progress, void* user, gatun_piece** piece);

  typedef enum gatun_blend
  {
    GATUN_COMPOSITE = 0, /**< color and opacity along the ray */
    GATUN_MAXIMUM = 2,   /**< of the largest value on the ray */
    GATUN_X_RAY = 3      /**< the integral of the opacity */
  } gatun_blend;

  typedef struct gatun_image
  {
    size_t size;
    uint32_t width, height; /**< in pixels */
    uint64_t step;
    uint32_t array; /**< of points or cells */
    int32_t component;
    uint32_t level; /**< as in gatun_request */
    double ratio;
    gatun_blend blend;
    const double* colors; /**< value, red, green, blue (0 to 1) by ascending value; null: violet to
                             yellow over the values of the mesh */
    size_t color_count;
    int32_t spread_colors; /**< whether the values of colors go from 0 to 1, and are spread over the
                              range */
    const double* opacities; /**< value, opacity over the unit distance; null: from the histogram */
    size_t opacity_count;
    double range[2]; /**< the smallest and largest value of default colors and opacities; equal:
                        those of the mesh, with default opacities without a few outliers */
    double opacity_scale; /**< a factor for default opacities, which are at most 1; 0: 1 */
    double unit_distance; /**< 0: a hundredth of the diagonal of the bounds */
    int32_t shade;        /**< a light at the camera shades surfaces of equal values */

    /** The camera. If position and focal_point are equal, the mesh is seen along the direction,
     * just fitting into the image. */
    double position[3], focal_point[3];
    double view_up[3];     /**< all 0: along y, or along z if the camera looks along y */
    double view_angle;     /**< vertical, in degrees; 0: 30 */
    double parallel_scale; /**< above 0: a parallel projection of twice this height */
    double direction[3];   /**< to look along; all 0: -1, -1, -1 */
    double zoom;           /**< the magnification; 0: 1 */
  } gatun_image;

  /** Draws the mesh by casting rays through its cells. rgba: for each pixel, row by row from below,
   * float32 red, green, blue (premultiplied by opacity) and opacity. */
  GATUN_API gatun_status gatun_render(gatun_file* file, const gatun_image* image,
    const gatun_buffer* rgba, gatun_progress progress, void* user);

  /* ---- Writing meshes ---- */

  enum
  {
    GATUN_KEEP_POINTS = 1, /**< points in the original order */
    GATUN_KEEP_CELLS = 2,
    GATUN_KEEP_CORNERS = 4 /**< corners of tetrahedra and triangles in the original order */
  };

  /** A mesh in the layout of vtkUnstructuredGrid. */
  typedef struct gatun_mesh
  {
    size_t size;
    uint64_t points, cells;
    gatun_type coordinate_type; /**< float32 or float64 */
    int32_t wide_ids;           /**< connectivity and offsets are int64, or int32 if 0 */
    int32_t is_surface;         /**< cells in the order of vtkPolyData */
    const void* coordinates;
    const void* connectivity;
    const uint8_t* types; /**< null: all are tetrahedra, and all below but point_array is null */
    const void* offsets;  /**< cells + 1 */
    const int64_t* face_locations;
    const int64_t* faces;
    uint64_t faces_size;
    const gatun_array* point_array; /**< names and keys of the array of the points; may be null */
  } gatun_mesh;

  typedef enum gatun_profile
  {
    GATUN_FAST = 0,
    GATUN_SMALL = 1
  } gatun_profile;

  typedef enum gatun_spacing
  {
    GATUN_NO_LAYERS = 0,
    GATUN_UNIFORM = 1,
    GATUN_NORMAL = 2,
    GATUN_HISTOGRAM = 3
  } gatun_spacing;

  typedef struct gatun_options
  {
    size_t size;
    uint32_t keep_order; /**< GATUN_KEEP_... */
    gatun_profile profile;
    uint32_t chunk_size;        /**< cells in a chunk, 64 to 1048576; 0: by the size of the mesh */
    uint32_t key_step_interval; /**< of steps that need no other one; 0: 8 */
    int32_t points_move;        /**< each step has coordinates */
    int32_t boundary;           /**< store the boundary, too */
    int32_t hierarchy;          /**< for gatun_request::ratio; of tetrahedra or triangles */
    uint32_t levels;            /**< the most coarser meshes to store; above 0: with a hierarchy */
    int32_t dependencies;       /**< of the hierarchy, for view-dependent simplification */
    gatun_spacing layers;       /**< organizes the file by the values of a point array */
    uint32_t layer_array;
    int32_t layer_component;
    uint32_t layer_count; /**< 0: by the size of the mesh */
    uint32_t parts;       /**< about how many there are, for the sizes of chunks; 0: 1 */
    const char* error; /**< as gatun_array::error, of all arrays of floating-point numbers without
                          one of their own; ids and vtkGhostType stay exact */
  } gatun_options;

  /** Begins a file of one mesh. The file appears at its path with gatun_finish; until then, an
   * existing file is untouched. After a failure, only gatun_discard may be called. */
  GATUN_API gatun_status gatun_create(const char* path, const gatun_mesh* mesh,
    const gatun_array* arrays, size_t array_count, const gatun_options* options,
    gatun_progress progress, void* user, gatun_writer** writer);

  /**
   * Adds steps to a file that has time: gatun_add_mesh, then its steps. Times come after those of
   * the file. What is in the file already, as the same mesh, is stored once.
   *
   * arrays: those of the file, in its order, with the errors and weights of the new steps; null:
   * all are exact. options: may be null; the kept order, the profile, the chunk size and the key
   * steps are those of the file.
   */
  GATUN_API gatun_status gatun_append(const char* path, const gatun_array* arrays,
    size_t array_count, const gatun_options* options, gatun_writer** writer);

  typedef struct gatun_values
  {
    size_t size;
    const gatun_buffer* arrays; /**< one for each array */
    size_t array_count;
    int32_t has_time;
    double time;
    const gatun_buffer* coordinates; /**< if the points move; null: those of the mesh */
    const gatun_field* fields;
    size_t field_count;

    /** The numbers of the remaining cells of the mesh, ascending, if some have been deleted; null:
     * all. Values are those of these cells, and with drops_points of these points. */
    const uint64_t* remaining_cells;
    uint64_t remaining_cell_count;
    int32_t drops_points;
    const uint64_t* remaining_points;
    uint64_t remaining_point_count;
  } gatun_values;

  /** Adds a mesh for the next steps, with the arrays and options of the first one. first: the
   * values of its first step, for a hierarchy or layers; null otherwise. number: may be null. */
  GATUN_API gatun_status gatun_add_mesh(gatun_writer* writer, const gatun_mesh* mesh,
    const gatun_values* first, gatun_progress progress, void* user, uint32_t* number);

  /** Selects the mesh of the next steps: the last or the first one. */
  GATUN_API gatun_status gatun_use_mesh(gatun_writer* writer, uint32_t number);

  typedef struct gatun_remaining
  {
    size_t size;
    int32_t is_part;      /**< whether a mesh is what remains of another one; or else all is 0 */
    int32_t drops_points; /**< as in gatun_values */
    int32_t points_moved; /**< all points remain, and some are elsewhere */
  } gatun_remaining;

  /** Finds out whether a mesh is what remains of another one, for gatun_values: at least half of
   * its cells, in the same order and none a polyhedron, with all of its points or only theirs.
   * cells, points: uint64 for each cell and point of part, which get the numbers. */
  GATUN_API gatun_status gatun_find_remaining(const gatun_mesh* mesh, const gatun_mesh* part,
    const gatun_buffer* cells, const gatun_buffer* points, gatun_remaining* found);

  /**
   * Rounds the coordinates of a mesh, before it is written, so that its file becomes smaller.
   * Coordinates that are not finite stay. No cell turns over: places where one would have smaller
   * steps. If that is more than 1 % of the points, the error text suggests another bound.
   *
   * error: "abs:E", "rel:E" (of the longest side of the bounds) or "bits:N", 1 to 31 (of the same).
   * is_part: the mesh is one of several parts, which need an absolute bound. rounded: as many
   * coordinates as the mesh has. largest: the largest difference; may be null.
   */
  GATUN_API gatun_status gatun_round_points(const gatun_mesh* mesh, const char* error,
    int32_t is_part, const gatun_buffer* rounded, double* largest);

  /** Writes a step. A mesh without time has one. */
  GATUN_API gatun_status gatun_write_step(
    gatun_writer* writer, const gatun_values* values, gatun_progress progress, void* user);

  /** Completes the file and frees the writer, also after a failure. file_bytes may be null. */
  GATUN_API gatun_status gatun_finish(gatun_writer* writer, uint64_t* file_bytes);

  /** Frees the writer without a file. */
  GATUN_API void gatun_discard(gatun_writer* writer);

  /**
   * A mesh that comes in parts and never is in memory as a whole. All parts come twice, in the same
   * order: gatun_survey_part with gatun_survey_step for each step, for all parts; then
   * gatun_add_part with gatun_write_step for each step, for all parts; then gatun_finish. Points of
   * several parts are one point if their global ids, or without ids their coordinates, and their
   * values are the same.
   *
   * The hierarchy is that of the whole mesh, as are the levels. They are found by gatun_finish,
   * with temporary files in the folder of the file: 44 bytes a tetrahedron for a field, 70 a point,
   * and the points and values without compression, twice with levels. The
   * boundary is in memory, at some 300 bytes a face, and needs the latter, too.
   */
  GATUN_API gatun_status gatun_create_parts(const char* path, const gatun_array* arrays,
    size_t array_count, const gatun_options* options, gatun_writer** writer);
  GATUN_API gatun_status gatun_survey_part(gatun_writer* writer, const gatun_mesh* part,
    const int64_t* global_ids, gatun_progress progress, void* user);
  GATUN_API gatun_status gatun_survey_step(gatun_writer* writer, const gatun_values* values);
  GATUN_API gatun_status gatun_add_part(gatun_writer* writer, const gatun_mesh* part,
    const int64_t* global_ids, gatun_progress progress, void* user);

  /* ---- Volumes ---- */

  typedef enum gatun_rate
  {
    GATUN_QUALITY = 0,       /**< 1 to 100 */
    GATUN_RMS_ERROR = 1,     /**< at most this root mean square error; 0: lossless */
    GATUN_PSNR = 2,          /**< at least this peak signal to noise ratio, in dB */
    GATUN_BITS_PER_VOXEL = 3 /**< this size */
  } gatun_rate;

  /** A regular volume of scalars. */
  typedef struct gatun_volume_info
  {
    size_t size;
    uint32_t dimensions[3]; /**< voxels along x, y, z */
    gatun_type type;
    const char* name; /**< of the array */
    int32_t vtk_type;
    double origin[3];
    double spacing[3];   /**< writing: all 0 is 1, 1, 1 */
    double direction[9]; /**< rows; writing: all 0 is the identity */
    int32_t first_index[3];
    double range[2];
    double rms_error, maximum_error; /**< of the voxels, measured when the file was written */
    int32_t is_lossless;
    uint64_t file_bytes;
    uint64_t bytes_read; /**< since the file was opened */
  } gatun_volume_info;

  GATUN_API gatun_status gatun_open_volume(const char* path, gatun_volume** volume);
  GATUN_API gatun_status gatun_open_volume_source(
    const gatun_source* source, gatun_volume** volume);
  GATUN_API void gatun_close_volume(gatun_volume* volume);
  GATUN_API gatun_status gatun_get_volume_info(gatun_volume* volume, gatun_volume_info* info);
  GATUN_API gatun_status gatun_describe_volume(
    gatun_volume* volume, int verbose, char* text, size_t capacity, size_t* length);

  /** The ranges of the file that some voxels need; see gatun_plan. */
  GATUN_API gatun_status gatun_plan_voxels(gatun_volume* volume, const uint32_t first[3],
    const uint32_t end[3], uint64_t gap, gatun_range* ranges, size_t capacity, size_t* count);

  /** Reads the voxels from first to end - 1 along each axis, x fastest, in the type of the volume.
   */
  GATUN_API gatun_status gatun_read_voxels(gatun_volume* volume, const uint32_t first[3],
    const uint32_t end[3], const gatun_buffer* values, gatun_progress progress, void* user);
  GATUN_API gatun_status gatun_verify_volume(
    gatun_volume* volume, gatun_progress progress, void* user);

/** The volume is one block. */
#define GATUN_ONE_BLOCK UINT32_MAX

  /** Writes a volume. values: the voxels, x fastest. block_size: 2 to 64 voxels along each axis, or
   * GATUN_ONE_BLOCK; 0 is 8. written: may be null; its errors and file_bytes are set. */
  GATUN_API gatun_status gatun_write_volume(const char* path, const gatun_volume_info* volume,
    const gatun_buffer* values, uint32_t block_size, gatun_rate rate, double rate_value,
    gatun_progress progress, void* user, gatun_volume_info* written);

#ifdef __cplusplus
}
#endif

#endif
