// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTypes_h
#define gatunTypes_h

// What a .gtn file describes: arrays, chunks, time steps. No VTK data types.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gatun
{
/** How one value is stored. The numbers are those of the file format. */
enum class ScalarType : std::uint8_t
{
  Int8 = 1,
  UInt8 = 2,
  Int16 = 3,
  UInt16 = 4,
  Int32 = 5,
  UInt32 = 6,
  Int64 = 7,
  UInt64 = 8,
  Float32 = 9,
  Float64 = 10
};

/** Bytes of one value of a type. */
constexpr std::size_t SizeOf(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
    case ScalarType::UInt8:
      return 1;
    case ScalarType::Int16:
    case ScalarType::UInt16:
      return 2;
    case ScalarType::Int32:
    case ScalarType::UInt32:
    case ScalarType::Float32:
      return 4;
    default:
      return 8;
  }
}

constexpr bool IsFloating(ScalarType type)
{
  return type == ScalarType::Float32 || type == ScalarType::Float64;
}

/** What an array's tuples belong to. */
enum class Association : std::uint8_t
{
  Point = 0,
  Cell = 1
};

/** A point or cell array without its values. */
struct ArrayDescription
{
  std::string Name;
  Association Where = Association::Point;
  ScalarType Type = ScalarType::Float32;
  std::uint32_t Components = 1;

  /** The type number that the array had in VTK (vtkType.h), so that char, id and bit arrays return
   * as they were; 0 when unknown. */
  std::int32_t VTKType = 0;

  /** Bit i set: the array was active attribute i of its vtkDataSetAttributes (SCALARS = 0, ...). */
  std::uint32_t AttributeRoles = 0;

  /** One name a component, or empty. */
  std::vector<std::string> ComponentNames;

  bool operator==(const ArrayDescription&) const = default;
};

/** Smallest and largest value; Min > Max when there is none (no tuples, or only NaN). */
struct Range
{
  double Min = 1e300;
  double Max = -1e300;
};

/**
 * The ranges of an array over some tuples: one of each component and, behind them, one of the
 * Euclidean length of the tuple when there is more than one component. NaN is left out.
 */
using ArrayRanges = std::vector<Range>;

/** x, y, z: smallest and largest of the finite coordinates; Min > Max for a mesh without any. */
using Bounds = std::array<Range, 3>;

/** Which original order a file keeps; flags. */
enum KeepOrder : std::uint8_t
{
  KeepNone = 0,
  KeepPoints = 1,  ///< points (and their arrays) in the order of the input
  KeepCells = 2,   ///< tetrahedra (and their arrays) in the order of the input
  KeepCorners = 4, ///< the corners of each tetrahedron in the order of the input
  KeepAll = 7
};

/** A part of the mesh that is decoded by itself. */
struct ChunkInfo
{
  std::uint64_t Tets = 0;
  std::uint64_t OwnPoints = 0;
  std::uint64_t SharedPoints = 0; ///< points that other chunks use too
  std::uint64_t FirstTet = 0;     ///< its tetrahedra are FirstTet ... FirstTet + Tets - 1
  std::uint64_t FirstPoint = 0;   ///< its own points are FirstPoint ... FirstPoint + OwnPoints - 1
  Bounds Box;
  std::vector<std::uint32_t> Neighbours; ///< chunks that share a point with this one, ascending
};

/** Sizes of a file's parts in bytes. */
struct FileStatistics
{
  std::uint64_t FileBytes = 0;
  std::uint64_t ConnectivityBytes = 0;
  std::uint64_t GeometryBytes = 0;       ///< of the chunks' own points
  std::uint64_t SharedGeometryBytes = 0; ///< of the points used by several chunks, and unused
  std::vector<std::uint64_t> ArrayBytes; ///< one an array, all time steps, shared points as well
  std::uint64_t OrderBytes = 0;          ///< what KeepOrder costs
  std::uint64_t FieldDataBytes = 0;
  std::uint64_t TreeBytes = 0;      ///< how the mesh becomes simpler
  std::uint64_t LevelBytes = 0;     ///< base meshes with all that is theirs
  std::uint64_t DirectoryBytes = 0; ///< headers, tables, meta data
};
}

#endif
