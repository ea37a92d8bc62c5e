// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyCoefficients
 * @brief Shared handle to the quantized Hartley coefficients of a volume.
 *
 * vtkGatunHartleyReader and vtkGatunHartleyEncoder publish their coefficients under the key
 * COEFFICIENTS() in the information of their output port. vtkGatunHartleyProjection draws them. The
 * reader's coefficients are available after UpdateInformation and are decoded from its open file on
 * demand; those of the encoder are available after Update.
 *
 * The key describes the output of the algorithm that set it. Other filters do not pass it on, since
 * they may change the values.
 *
 * @sa vtkGatunHartleyReader vtkGatunHartleyEncoder vtkGatunHartleyProjection
 */

#ifndef vtkGatunHartleyCoefficients_h
#define vtkGatunHartleyCoefficients_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::shared_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkInformationObjectBaseKey;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class HartleySource;
struct VolumeInput;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNIO_EXPORT vtkGatunHartleyCoefficients : public vtkObject
{
public:
  static vtkGatunHartleyCoefficients* New();
  vtkTypeMacro(vtkGatunHartleyCoefficients, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Key of the coefficients in the information of an output port. The object must not be changed.
   */
  static vtkInformationObjectBaseKey* COEFFICIENTS();

  /**
   * Name of the volume's array; empty if there are no coefficients.
   */
  const char* GetArrayName();

  ///@{
  /**
   * Voxels of a block along each axis (0: one block for the whole volume), and the numbers of
   * blocks and chunks.
   */
  int GetBlockSize();
  vtkIdType GetNumberOfBlocks();
  vtkIdType GetNumberOfChunks();
  ///@}

  /**
   * Smallest and largest voxel before compression.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

#ifndef __VTK_WRAP__
  /**
   * Sets the coefficients and the description of their volume, whose values are not used. The
   * core's types are experimental.
   */
  void SetSource(
    std::shared_ptr<const gatun::HartleySource> source, const gatun::VolumeInput& volume);

  /**
   * The coefficients; null if there are none.
   */
  const std::shared_ptr<const gatun::HartleySource>& GetSource() const;

  /**
   * Name, type and position of the volume.
   */
  const gatun::VolumeInput& GetVolume() const;
#endif

protected:
  vtkGatunHartleyCoefficients();
  ~vtkGatunHartleyCoefficients() override;

private:
  vtkGatunHartleyCoefficients(const vtkGatunHartleyCoefficients&) = delete;
  void operator=(const vtkGatunHartleyCoefficients&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
