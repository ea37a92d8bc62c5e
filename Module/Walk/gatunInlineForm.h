// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunInlineForm_h
#define gatunInlineForm_h

#include "gatunEntropy.h"
#include "gatunFormBuilder.h"
#include "gatunNumberModel.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace gatun
{
/** Codes a form that is in no table, face by face. */
class InlineForm
{
public:
  /**
   * degrees: for each side of the gate, the number of corners of the face that is probably over it,
   * or 0. actual: the encoder's code of the form.
   */
  template <typename Coder>
  void Code(
    Coder& coder, FormBuilder& form, std::span<const std::uint8_t> degrees, const FormCode& actual)
  {
    form.Begin(static_cast<unsigned>(degrees.size()));
    std::size_t at = 1;
    while (form.FindEdge())
    {
      const unsigned size = this->CodeSize(coder, form, degrees, Coder::Encoding ? actual[at] : 0);
      ++at;
      form.BeginFace(size);
      for (unsigned i = 2; i < size; ++i, ++at)
      {
        form.AddCorner(this->CodeCorner(coder, form, size - i, Coder::Encoding ? actual[at] : 0));
      }
    }
  }

private:
  template <typename Coder>
  unsigned CodeSize(
    Coder& coder, const FormBuilder& form, std::span<const std::uint8_t> degrees, unsigned size)
  {
    const auto from = form.GetFrom();
    const auto to = form.GetTo();
    const unsigned hint =
      from < degrees.size() && to == (from + 1) % degrees.size() ? degrees[from] : 0u;
    const unsigned around = std::min(form.CountFaces(from), 3u) + std::min(form.CountFaces(to), 3u);
    auto& tree = this->Sizes[std::min(hint, 9u) * 7 + around];
    const auto coded = tree.Code(coder, std::min(size, 18u) - 3);
    return coded < 15 ? coded + 3 : this->LargeSize.Code(coder, size);
  }

  /** left: the number of corners of the face that are missing, this one included. */
  template <typename Coder>
  unsigned CodeCorner(Coder& coder, const FormBuilder& form, unsigned left, unsigned corner)
  {
    const auto last = form.GetLast();
    const auto next = form.FindNext(last);
    const auto before = left == 1 ? form.FindBefore(form.GetFrom()) : FormBuilder::None;
    const unsigned faces = std::min(form.CountFaces(last), 3u);
    if (before != FormBuilder::None)
    {
      const unsigned begun = std::min(form.CountFaces(form.GetFrom()), 3u);
      if (coder.Bit(this->IsBefore[(begun * 4 + faces) * 2 + (before == next)], corner == before))
      {
        return before;
      }
    }
    if (next != FormBuilder::None && next != before &&
      coder.Bit(this->IsNext[faces * 8 + std::min(left, 7u)], corner == next))
    {
      return next;
    }
    if (coder.Bit(this->IsNew[std::min(left, 7u) * 2 + (next != FormBuilder::None)],
          corner == form.GetCorners()))
    {
      return form.GetCorners();
    }
    return CodeIndex(coder, corner, form.GetCorners());
  }

  std::array<BitTree<4>, std::size_t{ 10 } * 7> Sizes;
  NumberModel LargeSize;
  std::array<BitModel, 32> IsBefore;
  std::array<BitModel, 32> IsNext;
  std::array<BitModel, 16> IsNew;
};
}

#endif
