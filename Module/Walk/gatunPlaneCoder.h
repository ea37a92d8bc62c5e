// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlaneCoder_h
#define gatunPlaneCoder_h

// Coordinates of vertices of surfaces. The axis that the normal is closest to comes last. It is
// predicted from the others by the plane of the surface, so that its residuals are those along the
// normal. Encoder and decoder compute alike: IEEE binary64 in the order written.

#include "gatunDomain.h"
#include "gatunError.h"
#include "gatunInline.h"
#include "gatunResidual.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Codes vertices beyond an edge of a known triangle. */
template <typename Coder>
class PlaneCoder
{
public:
  using Keys = std::array<Key, 3>;

  /** The numbers of the coordinates of a vertex. */
  using Numbers = std::array<double, 4>;

  /** repeats: whether coordinates may be coded as those of a corner of the triangle. */
  explicit PlaneCoder(bool repeats)
    : Repeats(repeats)
    , Tangential(std::size_t{ 2 } * Groups * 4)
    , Normal(std::size_t{ Levels } * 4)
  {
  }

  /** Whether the triangle of a record is known. */
  static bool CanCode(const CellRecord& record)
  {
    return record.Known[CellRecord::N2] != NoVertex && record.Known[CellRecord::D12] != NoVertex;
  }

  /** Registers the next vertex of a walk. */
  void Meet()
  {
    this->States.push_back(this->Next);
    this->Next = { static_cast<std::uint8_t>(this->Mean >> 4), 0 };
  }

  /** Codes the vertex that is registered next. group: of the rule. predict(): by the rule. numbers,
   * keys: of all vertices met. */
  template <typename DomainType, typename Predict>
  Keys Code(Coder& coder, const std::array<DomainType, 3>& domains, const CellRecord& record,
    unsigned group, Predict&& predict, std::span<const Numbers> numbers, std::span<const Keys> keys,
    const Keys& actual)
  {
    const Numbers place = predict();
    const std::array corners{ record.Known[CellRecord::N1], record.Known[CellRecord::N2],
      record.Known[CellRecord::D12] };
    const Frame frame(numbers[corners[0]], numbers[corners[1]], numbers[corners[2]], place);
    const auto level = (this->States[corners[0]].Level + this->States[corners[1]].Level +
                         this->States[corners[2]].Level + 2u) /
      3u;
    Keys result{};
    unsigned grade = 0;
    double shift = 0;
    std::uint8_t repeated = 0;
    unsigned number = 0; // of repeated axes
    for (unsigned k = 0; k < 3; ++k)
    {
      const auto i = frame.Axes[k];
      if (this->Repeats && this->CodeRepeat(coder, i, number, corners, keys, actual, result[i]))
      {
        repeated |= static_cast<std::uint8_t>(1u << i);
        ++number;
      }
      else
      {
        const bool isLast = k == 2;
        const double predicted = isLast ? frame.GetHeight(place, shift) : place[i];
        auto& models = isLast ? this->Normal : this->Tangential;
        const auto context = isLast ? level : k * Groups + group;
        result[i] = this->CodeAxis(coder, domains[i], predicted, frame.Extent,
          models[context * 4 + grade], actual[i], isLast);
        grade = std::max(grade, models[context * 4 + grade].Grade);
      }
      shift += frame.Normal[i] * (domains[i].ToNumber(result[i]) - place[i]);
    }
    this->Next.Repeated = repeated;
    return result;
  }

private:
  static constexpr unsigned Groups = 32; // of rules
  static constexpr unsigned Levels = 16; // of residuals along the normal

  struct State
  {
    std::uint8_t Level;    // 0 for a residual of 0
    std::uint8_t Repeated; // bit i: axis i
  };

  /** The plane and the size of the triangles at an edge. */
  struct Frame
  {
    /** a, b: the edge; c: the corner behind; d: the predicted one. */
    GATUN_INLINE Frame(const Numbers& a, const Numbers& b, const Numbers& c, const Numbers& d)
    {
      const auto edge = Subtract(b, a);
      const auto ahead = Cross(edge, Subtract(d, a));
      const auto behind = Cross(Subtract(c, a), edge);
      for (unsigned i = 0; i < 3; ++i)
      {
        // The triangle ahead has twice the weight of the one behind.
        this->Normal[i] = 2.0 * ahead[i] + behind[i];
        const double low = std::min(std::min(a[i], b[i]), c[i]);
        const double high = std::max(std::max(a[i], b[i]), c[i]);
        this->Extent = std::max(this->Extent, high - low);
      }
      const std::array sizes{ std::abs(this->Normal[0]), std::abs(this->Normal[1]),
        std::abs(this->Normal[2]) };
      const unsigned first = sizes[1] > sizes[0] ? 1u : 0u;
      const unsigned last = sizes[2] > sizes[first] ? 2u : first;
      this->Axes = { last == 0 ? 1u : 0u, last == 2 ? 1u : 2u, last };
    }

    /** The predicted number of the last axis, if the others are off by shift in the direction of
     * the normal. */
    double GetHeight(const Numbers& place, double shift) const
    {
      const auto last = this->Axes[2];
      const double height = place[last] - shift / this->Normal[last];
      return std::isfinite(height) ? height : place[last];
    }

    std::array<double, 3> Normal{};
    double Extent = 0;
    std::array<unsigned, 3> Axes{};

  private:
    static std::array<double, 3> Subtract(const Numbers& a, const Numbers& b)
    {
      return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
    }

    static std::array<double, 3> Cross(
      const std::array<double, 3>& a, const std::array<double, 3>& b)
    {
      return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
    }
  };

  /** Codes whether a coordinate is that of one of the corners. */
  bool CodeRepeat(Coder& coder, unsigned axis, unsigned number,
    const std::array<Vertex, 3>& corners, std::span<const Keys> keys, const Keys& actual, Key& key)
  {
    const std::array known{ keys[corners[0]][axis], keys[corners[1]][axis],
      keys[corners[2]][axis] };
    const auto isRepeated = [&](unsigned corner)
    { return unsigned{ this->States[corners[corner]].Repeated } >> axis & 1u; };
    const unsigned equal = unsigned{ known[0] == known[1] } + 2 * unsigned{ known[0] == known[2] } +
      4 * unsigned{ known[1] == known[2] };
    const unsigned context = ((number * 2 + isRepeated(0)) * 2 + isRepeated(1)) * 8 + equal;
    const bool isOne =
      actual[axis] == known[0] || actual[axis] == known[1] || actual[axis] == known[2];
    if (!coder.Bit(this->IsRepeated[context], isOne))
    {
      return false;
    }
    // Equal ones are asked for once.
    unsigned chosen = 0;
    if (!coder.Bit(this->IsCorner[0][context], actual[axis] == known[0]))
    {
      chosen = equal == 1 ||
          (equal == 0 && !coder.Bit(this->IsCorner[1][context], actual[axis] == known[1]))
        ? 2
        : 1;
    }
    key = known[chosen];
    return true;
  }

  template <typename DomainType>
  Key CodeAxis(Coder& coder, const DomainType& domain, double number, double extent,
    ResidualModel& model, Key actual, bool isLast)
  {
    const Key predicted = domain.FromNumber(number);
    const Key beyond = domain.FromNumber(number + extent);
    const auto spread = static_cast<unsigned>(
      std::bit_width(beyond > predicted ? beyond - predicted : predicted - beyond));
    const auto residual =
      model.Code(coder, spread, Coder::Encoding ? domain.Subtract(actual, predicted) : 0);
    const Key key = domain.Add(predicted, residual);
    if (!Coder::Encoding && !domain.IsValid(key))
    {
      ThrowCorrupt("a coordinate is not in the palette");
    }
    if (isLast)
    {
      this->AddLevel(spread, residual);
    }
    return key;
  }

  void AddLevel(unsigned spread, std::int64_t residual)
  {
    constexpr int zero = 12;
    const auto size = static_cast<std::uint64_t>(residual);
    const auto length = std::bit_width(residual < 0 ? 0 - size : size);
    const int level = residual == 0
      ? 0
      : std::clamp(static_cast<int>(length) - static_cast<int>(spread) + zero, 1,
          static_cast<int>(Levels) - 1);
    this->Next.Level = static_cast<std::uint8_t>(level);
    this->Mean += static_cast<unsigned>(level) - (this->Mean >> 4);
  }

  const bool Repeats;
  std::vector<ResidualModel> Tangential, Normal;
  std::array<BitModel, std::size_t{ 3 } * 4 * 8> IsRepeated;
  std::array<std::array<BitModel, std::size_t{ 3 } * 4 * 8>, 2> IsCorner;
  std::vector<State> States; // of all vertices met
  unsigned Mean = 128;       // of the levels, times 16
  State Next{ 8, 0 };        // of the vertex that is registered next
};
}

#endif
