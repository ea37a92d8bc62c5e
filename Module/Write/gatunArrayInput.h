// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayInput_h
#define gatunArrayInput_h

#include "gatunArrayCodec.h"
#include "gatunDomain.h"
#include "gatunRoundedArrays.h"
#include "gatunTypes.h"
#include "gatunWithType.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The values of an array at one time step, and the domains that convert them to keys. */
struct ArrayInput
{
  const ArrayDescription* Description = nullptr;
  const std::uint8_t* Now = nullptr;
  const std::uint8_t* Before = nullptr; // the previous step, if it is used for prediction
  std::vector<Domain> Domains;
  RoundedArray* Rounded = nullptr; // has Now, and takes the values that readers will have
  bool IsCopy =
    false; // whether another array, the mesh or the step before has the values: no streams
  bool IsPoints = false;                      // coordinates of points that move
  bool IsLater = false;                       // than the first step of its mesh
  const std::vector<bool>* IsAlive = nullptr; // which tuples count for ranges; null: all

  /** Savings that justify slower decoding of streams: data that change with time are decoded for
   * every frame. */
  ModeChoice GetModeChoice() const
  {
    return this->IsLater ? ModeChoice{ 3, 0.5, true } : ModeChoice{};
  }

  const std::uint8_t* At(const std::uint8_t* values, std::size_t tuple, std::size_t component) const
  {
    return values +
      (tuple * this->Description->Components + component) * SizeOf(this->Description->Type);
  }

  /** The keys of some tuples. */
  std::vector<ComponentKeys> GetKeys(std::span<const std::uint32_t> tupleOf) const
  {
    std::vector<ComponentKeys> keys(this->Domains.size());
    for (std::size_t c = 0; c < keys.size(); ++c)
    {
      keys[c].Now.resize(tupleOf.size());
      for (std::size_t i = 0; i < tupleOf.size(); ++i)
      {
        keys[c].Now[i] = this->Domains[c].Read(this->At(this->Now, tupleOf[i], c));
      }
      if (this->Before)
      {
        keys[c].Before.resize(tupleOf.size());
        for (std::size_t i = 0; i < tupleOf.size(); ++i)
        {
          keys[c].Before[i] = this->Domains[c].Read(this->At(this->Before, tupleOf[i], c));
        }
      }
    }
    return keys;
  }

  /** Takes the keys of tuples that were encoded. */
  void TakeKeys(std::size_t tuple, std::size_t key, const std::vector<ComponentKeys>& keys) const
  {
    for (std::size_t c = 0; this->Rounded && c < keys.size(); ++c)
    {
      this->Rounded->Take(this->Domains[c], tuple, c, keys[c].Now[key]);
    }
  }

  /** A coordinate as it counts for bounds: only if it is finite. */
  static double Finite(double x) { return std::isfinite(x) ? x : std::nan(""); }

  ComponentReader GetReader() const
  {
    return { this->Description->Type, this->Now, this->Description->Components };
  }

  /** Adds tuples to the ranges of the components and of the length. */
  void Include(ArrayRanges& ranges, std::span<const std::uint32_t> tuples) const
  {
    const auto components = this->Description->Components;
    for (std::size_t r = 0; r < ranges.size(); ++r)
    {
      WithComponent(this->Description->Type, this->Now, components,
        r < components ? static_cast<int>(r) : -1,
        [&](auto&& getValue)
        {
          for (const auto tuple : tuples)
          {
            const double value = getValue(tuple);
            if (!this->IsAlive || (*this->IsAlive)[tuple])
            {
              ranges[r].Include(this->IsPoints ? Finite(value) : value);
            }
          }
        });
    }
  }
};
}

#endif
