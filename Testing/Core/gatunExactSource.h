// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunExactSource_h
#define gatunExactSource_h

// Volumes as Hartley coefficients that nothing was lost of, made by the transform alone.

#include "gatunHartleySource.h"
#include "gatunHartleyTransform.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace gatun::test
{
class ExactSource : public HartleySource
{
public:
  template <typename Value>
  ExactSource(const Value* values, const HartleyLayout::Triple& size, std::uint32_t blockSize)
    : Layout(HartleyLayout::Make(size, blockSize))
    , Values(values, values + std::size_t{ size[0] } * size[1] * size[2])
  {
    const auto [least, most] = std::minmax_element(this->Values.begin(), this->Values.end());
    this->Voxels = { *least, *most };
  }

  const HartleyLayout& GetLayout() const override { return this->Layout; }
  double GetBase() const override { return this->Voxels.Min; }
  Range GetRange() const override { return this->Voxels; }

  std::shared_ptr<const HartleyChunk> GetChunk(std::size_t chunk) const override
  {
    auto made = std::make_shared<HartleyChunk>();
    made->Starts.push_back(0);
    HartleyTransform transform(this->Layout.Block);
    const auto box = this->Layout.GetBlocksOfChunk(chunk);
    for (std::uint32_t z = box.First[2]; z < box.End[2]; ++z)
    {
      for (std::uint32_t y = box.First[1]; y < box.End[1]; ++y)
      {
        for (std::uint32_t x = box.First[0]; x < box.End[0]; ++x)
        {
          auto values = this->GetBlock({ x, y, z });
          transform.Forward(values);
          for (std::uint32_t i = 0; i < values.size(); ++i)
          {
            if (values[i] != 0)
            {
              made->Terms.push_back({ i, static_cast<float>(values[i]) });
            }
          }
          made->Starts.push_back(made->Terms.size());
        }
      }
    }
    return made;
  }

private:
  std::vector<double> GetBlock(const HartleyLayout::Triple& place) const
  {
    const auto& n = this->Layout.Block;
    const auto filled = this->Layout.GetFilled(place);
    std::vector<double> values(this->Layout.GetVoxelsPerBlock(), 0.0);
    for (std::uint32_t z = 0; z < filled[2]; ++z)
    {
      for (std::uint32_t y = 0; y < filled[1]; ++y)
      {
        for (std::uint32_t x = 0; x < filled[0]; ++x)
        {
          const std::size_t from = place[0] * n[0] + x +
            std::size_t{ this->Layout.Size[0] } *
              (place[1] * n[1] + y + std::size_t{ this->Layout.Size[1] } * (place[2] * n[2] + z));
          values[x + std::size_t{ n[0] } * (y + std::size_t{ n[1] } * z)] =
            this->Values[from] - this->Voxels.Min;
        }
      }
    }
    return values;
  }

  HartleyLayout Layout;
  std::vector<double> Values;
  Range Voxels;
};

template <typename Value>
std::shared_ptr<const HartleySource> MakeSource(
  const std::vector<Value>& values, const HartleyLayout::Triple& size, std::uint32_t blockSize)
{
  return std::make_shared<ExactSource>(values.data(), size, blockSize);
}
}

#endif
