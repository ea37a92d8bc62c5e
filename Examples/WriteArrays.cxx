// Writes a mesh from plain arrays, as a solver has them, without VTK's data model:
//   WriteArrays mesh.gtn
#include <gatunError.h>
#include <gatunFileWriter.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

int main(int argc, char* argv[])
{
  // A lattice of n^3 cubes of the unit cube, six tetrahedra each.
  const std::int64_t n = 16;
  std::vector<float> coordinates, wave;
  std::vector<std::int64_t> connectivity;
  const auto id = [n](std::int64_t i, std::int64_t j, std::int64_t k)
  { return (k * (n + 1) + j) * (n + 1) + i; };
  for (std::int64_t p = 0; p < (n + 1) * (n + 1) * (n + 1); ++p)
  {
    const std::array<std::int64_t, 3> at{ p % (n + 1), p / (n + 1) % (n + 1),
      p / (n + 1) / (n + 1) };
    for (const auto x : at)
    {
      coordinates.push_back(static_cast<float>(x) / n);
    }
    wave.push_back(0.5f + 0.5f * std::sin(0.5f * at[0]) * std::cos(0.3f * at[1] - 0.4f * at[2]));
  }
  constexpr int steps[6][2][3] = { { { 1, 0, 0 }, { 1, 1, 0 } }, { { 1, 1, 0 }, { 0, 1, 0 } },
    { { 0, 1, 0 }, { 0, 1, 1 } }, { { 0, 1, 1 }, { 0, 0, 1 } }, { { 0, 0, 1 }, { 1, 0, 1 } },
    { { 1, 0, 1 }, { 1, 0, 0 } } };
  for (std::int64_t c = 0; c < n * n * n; ++c)
  {
    const std::int64_t i = c % n, j = c / n % n, k = c / n / n;
    for (const auto& [a, b] : steps)
    {
      connectivity.insert(connectivity.end(),
        { id(i, j, k), id(i + a[0], j + a[1], k + a[2]), id(i + b[0], j + b[1], k + b[2]),
          id(i + 1, j + 1, k + 1) });
    }
  }

  gatun::MeshInput mesh;
  mesh.Points = wave.size();
  mesh.Coordinates = coordinates.data();
  mesh.Cells = connectivity.size() / 4;
  mesh.Connectivity = connectivity.data();
  gatun::ArrayDescription array;
  array.Name = "wave";
  array.AttributeRoles = 1; // the active scalars
  try
  {
    gatun::FileWriter writer(argc > 1 ? argv[1] : "mesh.gtn", mesh, { array }, {});
    const void* const values[] = { wave.data() };
    writer.WriteStep(values);
    writer.Finish();
  }
  catch (const gatun::Error& error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
