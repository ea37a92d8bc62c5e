// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileConsumer_h
#define gatunFileConsumer_h

// For consumers of a reader that use its file in place of its output.

#include "gatunPublishedFile.h"
#include "vtkGatunIOModule.h" // For export macro

#include <cstddef>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkInformation;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The handle in the information of an output, for the mesh of the time step that is asked for in
 * it; null if there is none. It lives as long as it is in there. */
VTKGATUNIO_EXPORT const PublishedFile* GetPublishedFile(vtkInformation* info);

/** The same, but null where the file cannot stand in for the output. */
VTKGATUNIO_EXPORT const PublishedFile* GetUsableFile(vtkInformation* info);

/** Makes a consumer of a file ask for nothing that the reader would have to decode: for what its
 * output has already, or for a piece without any cells. Info: that of the consumer's input. */
VTKGATUNIO_EXPORT void RequestNothing(vtkInformation* info);

/** The mesh of the time step that is asked for in the information of an output; the first if no
 * time is. */
VTKGATUNIO_EXPORT std::size_t FindRequestedMesh(const FileReader& file, vtkInformation* info);

/** The last step of a mesh not later than a time, or its first. */
VTKGATUNIO_EXPORT std::size_t FindStep(const FileReader& file, double time);

/** The step of a mesh that is asked for in the information of an output; the first if no time is.
 */
VTKGATUNIO_EXPORT std::size_t GetRequestedStep(const FileReader& file, vtkInformation* info);
}

#endif
