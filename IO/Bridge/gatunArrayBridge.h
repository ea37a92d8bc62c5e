// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Conversion between VTK arrays and the arrays of a .gtn file.

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
/** An array that a file can hold, with contiguous values in tuple order. */
struct BridgedArray
{
  ArrayDescription Description;
  const void* Values = nullptr;
  vtkSmartPointer<vtkDataArray> Owner;  ///< keeps Values alive
  std::vector<std::string> RefusedKeys; ///< information keys that a file cannot hold
};

/**
 * Describes a numeric array. Arrays with contiguous tuples are not copied; others (SOA, implicit
 * and bit arrays) are. Bits become UInt8 values 0 and 1. Throws gatun::Error (InvalidInput) if the
 * array is not numeric.
 */
VTKGATUNIO_EXPORT BridgedArray Bridge(vtkAbstractArray* array, Association where);

/** Returns the array itself if its tuples are contiguous in memory, otherwise a contiguous copy of
 * the same type. A bit array is copied to bytes 0 and 1. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array);

/** The description of an array of points. */
PointsDescription DescribePoints(vtkDataArray* points);

/** Gives the array of some points its names and keys. */
void SetDescription(vtkDataArray* points, const PointsDescription& description);

/** Gives an array the name, component names and keys of another one. */
VTKGATUNIO_EXPORT void CopyNames(vtkAbstractArray* from, vtkAbstractArray* to);

/** Returns an array of the same type and names with the given tuples. */
vtkSmartPointer<vtkAbstractArray> Gather(
  vtkAbstractArray* array, const std::vector<vtkIdType>& tuples);

/** Gathers the given tuples of all arrays, which keep their roles. */
void GatherAll(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& tuples, vtkDataSetAttributes* to);

/** Returns ArrayDescription::AttributeRoles of an array: bit i is set if it is active attribute i.
 */
VTKGATUNIO_EXPORT std::uint32_t AttributeRolesOf(
  vtkDataSetAttributes* attributes, vtkAbstractArray* array);

/**
 * Creates an array of the VTK type in the description. If that type has another size on this
 * machine, a type with the size of the stored values is used.
 */
class VTKGATUNIO_EXPORT ArrayFiller
{
public:
  ArrayFiller(const ArrayDescription& description, vtkIdType tuples);

  /** Returns the memory for the values, which have the type Type of the description. */
  void* GetBuffer();

  /** Returns the array once the buffer is filled. */
  vtkSmartPointer<vtkDataArray> Finish();

private:
  vtkSmartPointer<vtkDataArray> Array;
  bool Bits = false;
  std::vector<unsigned char> Bytes; ///< one byte per value of a bit array
};

/** Adds an array, even if another one has the same name, and sets its attribute roles. */
VTKGATUNIO_EXPORT void AddWithRoles(
  vtkDataSetAttributes* attributes, vtkAbstractArray* array, std::uint32_t attributeRoles);

/**
 * Converts field data for a file. Arrays that a file cannot hold (variant arrays) are skipped, and
 * so are such keys; what is skipped is appended to refused.
 */
FieldData BridgeFieldData(vtkFieldData* field, std::vector<std::string>& refused);

/** Whether a file holds two arrays as the same field array, bit for bit. */
VTKGATUNIO_EXPORT bool AreEqual(vtkAbstractArray* a, vtkAbstractArray* b);

/** Adds the field data of a file. Throws gatun::Error (Corrupt) if sizes are inconsistent. */
void AddFieldData(vtkFieldData* field, const FieldData& arrays);
}

#endif
