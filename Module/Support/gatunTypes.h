// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTypes_h
#define gatunTypes_h

// Descriptions of arrays, ranges, chunks and statistics. No VTK data types.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace gatun
{
/** Storage type of a value. The numbers are those of the file format. */
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

/** The size of a value in bytes. */
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

/** The elements of the mesh to which the tuples of an array belong. */
enum class Association : std::uint8_t
{
  Point = 0,
  Cell = 1
};

/** What a key of an array holds. The numbers are those of the file format. */
enum class KeyKind : std::uint8_t
{
  Integer = 1,
  Double = 2,
  Id = 3,
  Unsigned = 4,
  Text = 5,
  Integers = 6,
  Doubles = 7,
  Texts = 8,
  Quadrature = 9 ///< numbers of integration schemes
};

constexpr bool IsOfTexts(KeyKind kind)
{
  return kind == KeyKind::Text || kind == KeyKind::Texts;
}

/** An information key of an array, such as its unit, with its value. */
struct ArrayKey
{
  std::string Location; ///< the class that defines the key
  std::string Name;
  KeyKind Kind = KeyKind::Integer;
  std::vector<std::uint64_t> Numbers; ///< the bits of 64-bit integers or of double values
  std::vector<std::string> Texts;     ///< if IsOfTexts

  bool operator==(const ArrayKey&) const = default;
};

/** The array of the points without its values. */
struct PointsDescription
{
  std::string Name = "Points";
  std::vector<std::string> ComponentNames;
  std::vector<ArrayKey> Keys;

  bool operator==(const PointsDescription&) const = default;
};

/** A point or cell array without its values. */
struct ArrayDescription
{
  std::string Name;
  Association Where = Association::Point;
  ScalarType Type = ScalarType::Float32;
  std::uint32_t Components = 1;

  /** The array's type number in VTK (vtkType.h), which restores char, id and bit arrays; 0 if it is
   * unknown. */
  std::int32_t VTKType = 0;

  /** Bit i is set if the array was active attribute i of its vtkDataSetAttributes (SCALARS = 0,
   * ...).
   */
  std::uint32_t AttributeRoles = 0;

  /** One name for each component, or empty. */
  std::vector<std::string> ComponentNames;

  std::vector<ArrayKey> Keys = {};

  bool operator==(const ArrayDescription&) const = default;
};

/** Smallest and largest of some values. NaN is ignored. */
struct Range
{
  // The empty range as files store it. It cannot represent a range of values that are all beyond
  // these limits. Code that must handle infinite values starts with MakeEmpty().
  double Min = 1e300;
  double Max = -1e300;

  /** An empty range for values of any size, infinity included. */
  static constexpr Range MakeEmpty()
  {
    return { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  }

  /** Whether the range holds no value (no tuples, or only NaN). */
  constexpr bool IsEmpty() const { return !(this->Min <= this->Max); }

  constexpr void Include(double value)
  {
    // Comparisons with NaN are false.
    this->Min = value < this->Min ? value : this->Min;
    this->Max = value > this->Max ? value : this->Max;
  }

  constexpr void Include(const Range& other)
  {
    this->Min = other.Min < this->Min ? other.Min : this->Min;
    this->Max = other.Max > this->Max ? other.Max : this->Max;
  }

  bool operator==(const Range&) const = default;
};

/**
 * The ranges of an array over some tuples: one of each component and, behind them, one of the
 * Euclidean length of the tuple when there is more than one component. NaN is left out.
 */
using ArrayRanges = std::vector<Range>;

/** The number of ranges of an array. */
constexpr std::size_t GetRangeCount(std::uint32_t components)
{
  return components > 1 ? std::size_t{ components } + 1 : components;
}

/** The range of a component, or of the length of the tuple if component is -1. */
inline const Range& GetRange(const ArrayRanges& ranges, int component)
{
  return component < 0 ? ranges.back() : ranges[static_cast<std::size_t>(component)];
}

/** Ranges of the finite x, y and z coordinates. */
struct Bounds : std::array<Range, 3>
{
  /** Whether there is no point. */
  constexpr bool IsEmpty() const
  {
    return (*this)[0].IsEmpty() || (*this)[1].IsEmpty() || (*this)[2].IsEmpty();
  }

  constexpr void Include(const std::array<double, 3>& point)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      (*this)[axis].Include(point[axis]);
    }
  }

  constexpr void Include(const Bounds& other)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      (*this)[axis].Include(other[axis]);
    }
  }
};

/** What a file is optimized for. */
enum class Profile : std::uint8_t
{
  Small, ///< size
  Fast   ///< reading speed; takes up to twice the space
};

/** Flags: the parts of the original order that a file keeps. */
enum KeepOrder : std::uint8_t
{
  KeepNone = 0,
  KeepPoints = 1,  ///< points (and their arrays) in the order of the input
  KeepCells = 2,   ///< cells (and their arrays) in the order of the input
  KeepCorners = 4, ///< corners of tetrahedra and triangles, and faces of polyhedra, as the input's;
                   ///< corners of other cells always keep their order
  KeepAll = 7
};

/** The number of cells of a VTK type. */
struct CellTypeCount
{
  std::uint8_t Type = 0;
  std::uint64_t Cells = 0;

  bool operator==(const CellTypeCount&) const = default;
};

/** A part of the mesh that is decoded independently. */
struct ChunkInfo
{
  std::uint64_t Tets = 0; ///< those of which the cells consist: the cells if they are tetrahedra
  std::uint64_t OwnPoints = 0;
  std::uint64_t SharedPoints = 0; ///< points that other chunks use too
  std::uint64_t FirstTet = 0;     ///< its tetrahedra are FirstTet ... FirstTet + Tets - 1
  std::uint64_t Cells = 0;
  std::uint64_t FirstCell = 0;  ///< its cells are FirstCell ... FirstCell + Cells - 1
  bool IsTetrahedral = true;    ///< whether all cells are tetrahedra
  std::uint64_t FirstPoint = 0; ///< its own points are FirstPoint ... FirstPoint + OwnPoints - 1
  Bounds Box;
};

/** What a mesh consists of. */
struct MeshCounts
{
  std::uint64_t Points = 0;
  std::uint64_t Cells = 0;
  std::uint64_t Tets = 0;
};

/** A time step of a file whose mesh changes. */
struct SeriesStep
{
  std::uint32_t Mesh = 0; ///< meshes, and masks of their cells, in the order of their first steps
  double Time = 0;

  bool operator==(const SeriesStep&) const = default;
};

/** Sizes of the parts of a file in bytes. */
struct FileStatistics
{
  std::uint64_t FileBytes = 0;
  std::uint64_t ConnectivityBytes = 0;
  std::uint64_t GeometryBytes = 0;       ///< points that belong to one chunk
  std::uint64_t SharedGeometryBytes = 0; ///< shared and unused points
  std::vector<std::uint64_t> ArrayBytes; ///< each array over all time steps
  std::uint64_t MotionBytes = 0;         ///< coordinates of later time steps, if the points move
  std::uint64_t OrderBytes = 0;          ///< the original order, see KeepOrder
  std::uint64_t FieldDataBytes = 0;
  std::uint64_t TreeBytes = 0;       ///< the merge tree and the ranges after merges
  std::uint64_t DependencyBytes = 0; ///< those between merges
  std::uint64_t LevelBytes = 0;      ///< base meshes with their arrays
  std::uint64_t BoundaryBytes = 0;   ///< the boundary with its arrays
  std::uint64_t OtherMeshBytes = 0;  ///< all but the first mesh of a series, with their arrays
  std::uint64_t DirectoryBytes = 0;  ///< headers, tables, meta data

  /** Counts the bytes of the last array as coordinates, if the points move. */
  void SplitPoints(bool pointsMove)
  {
    if (pointsMove)
    {
      this->MotionBytes = this->ArrayBytes.back();
      this->ArrayBytes.pop_back();
    }
  }
};
}

#endif
