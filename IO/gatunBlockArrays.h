// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBlockArrays_h
#define gatunBlockArrays_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAbstractArray;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkStringArray;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The names of the arrays by which vtkGatunMergeBlocks describes blocks. */
///@{
inline constexpr const char* BlockIdName = "BlockId";         ///< of cells and points
inline constexpr const char* BlockNamesName = "BlockNames";   ///< field array
inline constexpr const char* BlockArraysName = "BlockArrays"; ///< field array
///@}

/** An array that a block has. */
struct BlockArray
{
  int Block = 0;
  int Association = 0;     ///< vtkDataObject::POINT or CELL
  std::uint32_t Roles = 0; ///< see AttributeRolesOf
  std::string Merged;      ///< name in the merged grid
  std::string Name;        ///< name in the block
};

/** Returns the array BlockArrays, with the members of BlockArray as components. */
vtkSmartPointer<vtkStringArray> MakeBlockArrays(const std::vector<BlockArray>& arrays);

/** Reads BlockArrays, without what it lists twice; nothing if it is not as MakeBlockArrays makes
 * it.
 */
std::optional<std::vector<BlockArray>> ReadBlockArrays(vtkFieldData* field);

/** Returns the same array under another name. The values are shared where VTK can share them. */
vtkSmartPointer<vtkAbstractArray> Renamed(vtkAbstractArray* array, const std::string& name);

/** Gives arrays without a name one: that of the attribute that they are active as, such as Normals,
 * or else Array, with a number behind it if another array has that. where: "point" or "cell".
 * Returns messages about them. */
VTKGATUNIO_EXPORT std::vector<std::string> NameArrays(
  vtkDataSetAttributes* attributes, const std::string& where);

/**
 * Gives all pieces the same arrays of one association, so that they can be merged.
 *
 * Arrays with equal names that differ in type or in the number of components get names of their
 * own, and so do arrays named BlockId if the pieces are blocks. Pieces that lack an array get one
 * with NaN or 0. String arrays that a piece lacks are removed from all.
 */
class ArrayMatcher
{
public:
  /** blocks: the block of each piece. isComposite: whether the pieces are blocks. */
  ArrayMatcher(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces,
    const std::vector<int>& blocks, bool isComposite, int association);

  /** The arrays of the blocks as they were. */
  const std::vector<BlockArray>& GetBlockArrays() const { return this->Found; }

  /** Messages about what was renamed and filled up. */
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /** The names of arrays that some pieces lacked. */
  const std::vector<std::string>& GetFilled() const { return this->Filled; }

  /** Whether a piece lacked an array. */
  bool IsFilled(std::size_t piece, const std::string& name) const;

private:
  struct Kind;

  std::vector<Kind> FindKinds(const std::vector<int>& blocks);
  void ChooseNames(std::vector<Kind>& kinds) const;
  void Rename(const std::vector<Kind>& kinds);
  void FillUp(const std::vector<Kind>& kinds);

  const std::vector<vtkSmartPointer<vtkDataSet>>& Pieces;
  const bool IsComposite;
  const int Association;
  std::vector<BlockArray> Found;
  std::vector<std::string> Warnings;
  std::vector<std::string> Filled;
  std::vector<std::vector<std::string>> Lacking; ///< of each piece
};
}

#endif
