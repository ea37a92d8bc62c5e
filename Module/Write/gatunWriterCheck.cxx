// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterCheck.h"

#include "gatunChunkCodec.h"
#include "gatunError.h"
#include "gatunRoundedArrays.h"
#include "gatunSurfaceCells.h"

#include <algorithm>
#include <string>

namespace gatun
{
namespace
{
void CheckSurface(const MeshInput& mesh, const WriterOptions& options)
{
  if (options.Layers)
  {
    ThrowInvalid("layers are made of tetrahedra, and surfaces have none");
  }
  if (options.Boundary)
  {
    ThrowInvalid("surfaces have no boundary to write");
  }
  if (mesh.Cells > 0 &&
    !(mesh.Types && std::all_of(mesh.Types, mesh.Types + mesh.Cells, IsSurfaceCell)))
  {
    ThrowInvalid("there are cells that are no part of a surface");
  }
}

void CheckLayers(
  const MeshInput& mesh, const std::vector<ArrayDescription>& arrays, const LayerRequest& layers)
{
  if (layers.Array >= arrays.size())
  {
    ThrowInvalid("the array that layers are to be made of is not there");
  }
  const auto& array = arrays[layers.Array];
  if (array.Where != Association::Point)
  {
    ThrowInvalid("layers need a point array, and '" + array.Name + "' is one of cells");
  }
  const auto components = static_cast<int>(array.Components);
  if (layers.Component >= components || layers.Component < (components > 1 ? -1 : 0))
  {
    ThrowInvalid("array '" + array.Name + "' has no component " + std::to_string(layers.Component) +
      " to make layers of");
  }
  if (layers.Count > MaxLayers)
  {
    ThrowInvalid("there must be from 1 to " + std::to_string(MaxLayers) + " layers, not " +
      std::to_string(layers.Count));
  }
  if (layers.Spacing < LayerSpacing::Uniform || layers.Spacing > LayerSpacing::Histogram)
  {
    ThrowInvalid("the spacing of the layers is unknown");
  }
  if (mesh.Points > 0 && !layers.Values)
  {
    ThrowInvalid("layers need the values of array '" + array.Name + "'");
  }
}
}

//------------------------------------------------------------------------------
void CheckWriterInput(
  const MeshInput& mesh, const std::vector<ArrayDescription>& arrays, const WriterOptions& options)
{
  if (!IsFloating(mesh.CoordinateType))
  {
    ThrowInvalid("coordinates must be float or double");
  }
  if ((mesh.Points > 0 && !mesh.Coordinates) || (mesh.Cells > 0 && !mesh.Connectivity))
  {
    ThrowInvalid("the mesh has no coordinates or no connectivity");
  }
  if (mesh.Types && !mesh.Offsets)
  {
    ThrowInvalid("cells of several types need offsets");
  }
  if (mesh.FaceLocations && mesh.FacesSize > 0 && !mesh.Faces)
  {
    ThrowInvalid("the faces of the polyhedra are missing");
  }
  if (options.ChunkSize != 0 && (options.ChunkSize < 64 || options.ChunkSize > MaxChunkTets))
  {
    ThrowInvalid("a chunk must have from 64 to " + std::to_string(MaxChunkTets) + " cells, not " +
      std::to_string(options.ChunkSize));
  }
  if (options.KeyStepInterval < 1)
  {
    ThrowInvalid("the interval of key steps must be at least 1");
  }
  if (options.Keep > KeepAll)
  {
    ThrowInvalid("the order to keep is unknown");
  }
  if (options.Tree && options.Tree->GetNumberOfPoints() != mesh.Points)
  {
    ThrowInvalid("the tree of merges is not that of the mesh");
  }
  if (options.Levels > 0 && !options.Tree)
  {
    ThrowInvalid("base meshes need a tree of merges");
  }
  if (options.Layers)
  {
    CheckLayers(mesh, arrays, *options.Layers);
  }
  if (options.IsSurface)
  {
    CheckSurface(mesh, options);
  }
  CheckArrays(arrays);
  CheckErrors(arrays, options.Errors);
}

//------------------------------------------------------------------------------
void CheckArrays(const std::vector<ArrayDescription>& arrays)
{
  for (const auto& array : arrays)
  {
    if (array.Components < 1 || array.Components > 65536)
    {
      ThrowInvalid("array '" + array.Name + "' must have from 1 to 65536 components");
    }
  }
}
}
