// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFaceTable_h
#define gatunFaceTable_h

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Finds the tetrahedra that have a face, however many there are. */
class FaceTable
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;
  using Tet = std::array<std::uint32_t, 4>;
  using Face = std::array<std::uint32_t, 3>;

  explicit FaceTable(std::span<const Tet> tets)
    : Tets(tets)
    , Mask(static_cast<std::uint32_t>(std::bit_ceil(4 * tets.size() + 1) - 1))
    , First(std::size_t{ Mask } + 1, None)
    , Next(4 * tets.size(), None)
  {
    for (std::size_t i = this->Next.size(); i-- > 0;)
    {
      const auto& t = tets[i / 4];
      if (IsDegenerate(t))
      {
        continue;
      }
      const auto slot = Hash(Opposite(t, i % 4)) & this->Mask;
      this->Next[i] = this->First[slot];
      this->First[slot] = static_cast<std::uint32_t>(i);
    }
  }

  /** A tetrahedron that names a vertex twice; it has no faces here. */
  static bool IsDegenerate(const Tet& t)
  {
    return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
      t[2] == t[3];
  }

  /** Calls use(tetrahedron, corner opposite to the face) for each, until it returns true. */
  template <typename Use>
  void Find(const Face& face, Use&& use) const
  {
    const auto wanted = Sorted(face);
    for (auto i = this->First[Hash(face) & this->Mask]; i != None; i = this->Next[i])
    {
      if (Sorted(Opposite(this->Tets[i / 4], i % 4)) == wanted && use(i / 4, i % 4))
      {
        return;
      }
    }
  }

private:
  static Face Opposite(const Tet& t, std::size_t corner)
  {
    return { t[(corner + 1) % 4], t[(corner + 2) % 4], t[(corner + 3) % 4] };
  }

  static Face Sorted(Face f)
  {
    std::sort(f.begin(), f.end());
    return f;
  }

  static std::uint32_t Hash(const Face& f)
  {
    // The same for every order of the corners.
    const auto mix = [](std::uint64_t v)
    {
      v = (v + 1) * 0x9e3779b97f4a7c15u;
      v ^= v >> 29;
      return v * 0xbf58476d1ce4e5b9u;
    };
    return static_cast<std::uint32_t>((mix(f[0]) + mix(f[1]) + mix(f[2])) >> 24);
  }

  std::span<const Tet> Tets;
  std::uint32_t Mask;
  std::vector<std::uint32_t> First;
  std::vector<std::uint32_t> Next;
};
}

#endif
