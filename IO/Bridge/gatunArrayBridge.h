// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// VTK's arrays and those that a .gtn file describes, in both directions.

#ifndef gatunArrayBridge_h
#define gatunArrayBridge_h

#include "gatunFieldData.h"
#include "gatunTypes.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAbstractArray;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkFieldData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** An array that a file can hold, and its values one tuple after the other. */
struct BridgedArray
{
  ArrayDescription Description;
  const void* Values = nullptr;
  vtkSmartPointer<vtkDataArray> Owner; ///< keeps Values alive
};

/**
 * Describes a numeric array. Arrays that lie in memory tuple by tuple are not copied; others (SOA,
 * implicit, bit arrays) are. Bits become UInt8 0 and 1. Throws gatun::Error (InvalidInput) for
 * arrays that are not numeric.
 */
VTKGATUNIO_EXPORT BridgedArray Bridge(vtkAbstractArray* array, Association where);

/** The array itself, or a copy of the same type, with its values one tuple after the other in
 * memory; of a bit array, a copy with a byte 0 or 1 each. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array);

/** An array of the same type, names included, with the tuples of these ids. */
vtkSmartPointer<vtkAbstractArray> Gather(
  vtkAbstractArray* array, const std::vector<vtkIdType>& tuples);

/** The AttributeRoles of an array: bit i is set if it is active attribute i. */
VTKGATUNIO_EXPORT std::uint32_t AttributeRolesOf(
  vtkDataSetAttributes* attributes, vtkAbstractArray* array);

/**
 * Makes an array of the VTK type that the description tells, or, where that is not what the values
 * are stored as on this machine, of one of the same size.
 */
class VTKGATUNIO_EXPORT ArrayFiller
{
public:
  ArrayFiller(const ArrayDescription& description, vtkIdType tuples);

  /** Where the values go, of the description's Type. */
  void* GetBuffer();

  /** The array, once the values are there. */
  vtkSmartPointer<vtkDataArray> Finish();

private:
  vtkSmartPointer<vtkDataArray> Array;
  bool Bits = false;
  std::vector<unsigned char> Bytes; ///< of a bit array, one each
};

/** Adds an array even if there is one of that name, and gives it its roles. */
VTKGATUNIO_EXPORT void AddWithRoles(
  vtkDataSetAttributes* attributes, vtkAbstractArray* array, std::uint32_t attributeRoles);

/**
 * Field data for a file. Arrays that it cannot hold (of variants) are left out, and named in
 * refused.
 */
FieldData BridgeFieldData(vtkFieldData* field, std::vector<std::string>& refused);

/** Adds a file's field data. Throws gatun::Error (Corrupt) if sizes do not fit. */
void AddFieldData(vtkFieldData* field, const FieldData& arrays);
}

#endif
