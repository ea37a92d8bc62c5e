// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunAttachedNodes_h
#define gatunAttachedNodes_h

#include "gatunCellBuilder.h"
#include "gatunCellNodes.h"
#include "gatunNumberModel.h"
#include "gatunSharedNames.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace gatun
{
/** Codes the nodes of nonlinear cells. Cells with a common edge or face have its node in common. */
template <typename Coder, typename Side>
class AttachedNodes
{
public:
  AttachedNodes(Coder& coder, CellBuilder<Side>& mesh)
    : Symbols(coder)
    , Mesh(mesh)
  {
  }

  /** Appends the nodes to the corners of a cell. truth: all points of the encoder's cell. */
  void Code(
    const CellNodes& nodes, std::vector<Vertex>& corners, std::span<const std::uint32_t> truth)
  {
    for (std::size_t at = 0; at < nodes.Hosts.size(); at += 1u + nodes.Hosts[at])
    {
      Host host{ NoVertex, NoVertex, NoVertex, NoVertex };
      for (unsigned i = 0; i < nodes.Hosts[at]; ++i)
      {
        host[i] = corners[nodes.Hosts[at + 1 + i]];
      }
      corners.push_back(this->CodeNode(host, Coder::Encoding ? truth[corners.size()] : 0));
    }
  }

private:
  using Host = std::array<Vertex, 4>; // the corners, then NoVertex

  struct HashHost
  {
    std::size_t operator()(const Host& host) const
    {
      std::uint64_t hash = 0;
      for (const auto v : host)
      {
        hash = (hash ^ v) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return static_cast<std::size_t>(hash);
    }
  };

  Vertex CodeNode(const Host& host, std::uint32_t target)
  {
    const unsigned kind = host[2] == NoVertex ? 0 : host[3] == NoVertex ? 1 : 2;
    auto key = host;
    std::sort(key.begin(), key.end());
    const auto found = this->Nodes.find(key);
    const bool has = found != this->Nodes.end();
    const Vertex known = Coder::Encoding ? this->Mesh.Truth.GetMet(target) : NoVertex;
    if (has && this->Symbols.Bit(this->IsHosts[kind], known == found->second))
    {
      return found->second;
    }
    if (!this->Symbols.Bit(this->IsNew[kind * 2 + has], known == NoVertex))
    {
      return CodeIndex(this->Symbols, known, this->Mesh.GetVertices());
    }
    unsigned shared = 0;
    for (unsigned i = 0; i < kind + 2; ++i)
    {
      shared += this->Mesh.GetPlace(host[i]).Users != 0;
    }
    const bool isShared = this->Symbols.Bit(
      this->IsShared[shared], Coder::Encoding && this->Mesh.Truth.IsShared(target));
    const auto vertex = isShared ? this->Mesh.MeetShared(target, this->NameShared(host, target))
                                 : this->Mesh.MeetOwn(target, MakeRecord(host));
    for (unsigned i = 0; i < kind + 2; ++i)
    {
      this->Mesh.LogEdge(host[i], vertex);
    }
    this->Nodes[key] = vertex;
    return vertex;
  }

  /** Looks around the mean of the corners. */
  std::uint32_t NameShared(const Host& host, std::uint32_t target)
  {
    const auto& begin = this->Mesh.GetPlace(host[0]);
    LatticePoint sum;
    float count = 0;
    for (unsigned i = 0; i < 4 && host[i] != NoVertex; ++i)
    {
      const auto& place = this->Mesh.GetPlace(host[i]);
      sum.X += place.X;
      sum.Y += place.Y;
      sum.Z += place.Z;
      count += 1;
    }
    const LatticePoint mean{ sum.X / count, sum.Y / count, sum.Z / count, 0 };
    const Vec3 edge = ToVector(begin) - ToVector(mean);
    return this->Shared.Code(
      this->Symbols, this->Mesh.GetSharedSearch(), mean, Dot(edge, edge), target);
  }

  /** No other record has N1 and opposite vertices without further neighbors. */
  static CellRecord MakeRecord(const Host& host)
  {
    CellRecord record;
    record.Known[CellRecord::N1] = host[0];
    record.Known[CellRecord::D12] = host[1];
    record.Known[CellRecord::D13] = host[2];
    record.Known[CellRecord::D23] = host[3];
    return record;
  }

  Coder& Symbols;
  CellBuilder<Side>& Mesh;
  std::unordered_map<Host, Vertex, HashHost> Nodes;
  std::array<BitModel, 3> IsHosts;
  std::array<BitModel, 6> IsNew;
  std::array<BitModel, 5> IsShared; // by the number of shared corners
  SharedNames Shared;
};
}

#endif
