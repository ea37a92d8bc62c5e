// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnXMLMesh_h
#define gtnXMLMesh_h

// A .vtu file as a mesh that is read by ranges.

#include "gtnRangedMesh.h"
#include "gtnXMLArray.h"
#include "gtnXMLFaces.h"

#include "vtkSmartPointer.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

class vtkXMLDataElement;

namespace gtn
{
class XMLHeaderReader;

/** A .vtu file without its points and cells. */
struct XMLSummary
{
  std::uint64_t Points = 0;
  std::uint64_t Cells = 0;
  std::uint64_t Corners = 0; ///< points of all cells; 8 for each cell if the file does not tell
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< empty, with all arrays and the field data
};

/** Reads it, of any .vtu file. Throws Failure. */
XMLSummary ReadXMLSummary(const std::string& file);

/** A .vtu file with appended data, which may be compressed. It may consist of several pieces. It
 * has one step, without time. */
class XMLMesh : public RangedMesh
{
public:
  /** arrays: the names of those to read; null for all. skip: of those to leave out. Throws Failure,
   * also for a file that VTK can read but that cannot be read by ranges: with text, inline data, or
   * several time steps. */
  XMLMesh(const std::string& file, const std::vector<std::string>* arrays,
    const std::vector<std::string>& skip);
  ~XMLMesh() override;

  std::uint64_t GetNumberOfPoints() const override { return this->PointCount; }
  std::uint64_t GetNumberOfCells() const override { return this->CellCount; }
  bool HasPolyhedra() const override { return this->WithPolyhedra; }

  /** The number of points of all cells, those in the faces of polyhedra included. */
  std::uint64_t CountCorners() const;

  bool HasWideIds() const override { return this->WideIds; }
  std::vector<double> GetTimes() const override { return {}; }
  vtkUnstructuredGrid* GetTemplate(std::size_t step) const override;
  void ReadPoints(std::uint64_t begin, std::size_t count, void* values) override;
  void ReadCells(std::uint64_t begin, std::size_t count, RangedCells& cells) override;
  void ReadArray(int association, int array, std::size_t step, std::uint64_t begin,
    std::size_t count, void* values) override;
  void CheckUnchanged() const override;

private:
  struct Piece;

  [[noreturn]] void Refuse(const std::string& what) const;
  void OpenPiece(int number);
  std::unique_ptr<XMLArray> OpenArray(vtkXMLDataElement* parent, const char* name, int type);
  std::unique_ptr<XMLFaces> OpenFaces(vtkXMLDataElement* cells, std::uint64_t firstCell);
  [[noreturn]] void FailFaces(std::uint64_t cell) const;
  std::size_t CutCells(const Piece& piece, std::uint64_t begin, std::size_t count);
  void ReadFaces(const Piece& piece, std::uint64_t begin, std::size_t count, RangedCells& cells);
  void AppendFaces(const Piece& piece, std::uint64_t cell, std::span<const std::int64_t> values,
    RangedCells& cells) const;

  /** Calls read(array, first value, number of values, first tuple in the range) for each piece. */
  template <typename Find, typename Read>
  void ForEachPiece(
    bool isPoints, std::uint64_t begin, std::size_t count, Find&& find, Read&& read);

  const std::string File;
  vtkSmartPointer<XMLHeaderReader> Reader;
  vtkSmartPointer<vtkUnstructuredGrid> Template;
  XMLData Data;
  std::filesystem::file_time_type Changed;
  std::vector<Piece> Pieces;
  std::uint64_t PointCount = 0;
  std::uint64_t CellCount = 0;
  bool WithPolyhedra = false;
  bool WideIds = false;

  // While cells are read.
  std::vector<std::int64_t> Types;
  std::vector<std::int64_t> Ends;
  std::vector<std::int64_t> Values;
};
}

#endif
