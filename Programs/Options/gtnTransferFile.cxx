// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Color maps in the files that ParaView exports and imports: a list of maps, of which the first
// one counts. RGBPoints: value, red, green, blue of each node. Points, which may be missing: value,
// opacity, midpoint, sharpness of each node.

#include "gtnTransfer.h"

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnOutput.h"
#include "gtnText.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace gtn
{
namespace
{

// What is said of maps, with the file's name before it.
class MapFile
{
public:
  explicit MapFile(const std::string& file)
    : File(file)
  {
  }

  [[noreturn]] void Fail(const std::string& reason) const { throw Failure(this->File, reason); }

  /** Numbers in groups of four, the first of each ascending, the others 0 to 1. */
  std::vector<double> ReadNodes(const Json::Value& map, const std::string& name) const
  {
    std::vector<double> numbers = NumbersOf(map[name], this->File, name);
    if (numbers.empty() || numbers.size() % 4 != 0)
    {
      this->Fail(fmt::format("{} has {} numbers, not four a node", name, numbers.size()));
    }
    for (std::size_t i = 0; i < numbers.size(); i += 4)
    {
      if (i > 0 && numbers[i] < numbers[i - 4])
      {
        this->Fail(fmt::format("{} is not ascending: {} comes after {}", name, Number(numbers[i]),
          Number(numbers[i - 4])));
      }
      for (std::size_t j = i + 1; j < i + 4; ++j)
      {
        if (!(numbers[j] >= 0 && numbers[j] <= 1))
        {
          this->Fail(fmt::format("{} has {} where 0 to 1 belongs", name, Number(numbers[j])));
        }
      }
    }
    return numbers;
  }

  ColorSpace ReadSpace(const Json::Value& map) const
  {
    constexpr std::array<std::pair<std::string_view, ColorSpace>, 8> known{ {
      { "RGB", ColorSpace::RGB },
      { "HSV", ColorSpace::HSV },
      { "Lab", ColorSpace::Lab },
      { "CIELAB", ColorSpace::Lab },
      { "LabCIEDE2000", ColorSpace::LabCIEDE2000 },
      { "Lab/CIEDE2000", ColorSpace::LabCIEDE2000 },
      { "Diverging", ColorSpace::Diverging },
      { "Step", ColorSpace::Step },
    } };
    const Json::Value& space = map["ColorSpace"];
    if (space.isNull())
    {
      return ColorSpace::RGB;
    }
    const std::string name = space.isString() ? space.asString() : "";
    const auto* const found = std::find_if(
      known.begin(), known.end(), [&name](const auto& entry) { return entry.first == name; });
    if (found == known.end())
    {
      this->Fail(fmt::format("ColorSpace is '{}', not RGB, HSV, Lab, Lab/CIEDE2000, Diverging or "
                             "Step",
        Printable(name)));
    }
    return found->second;
  }

private:
  const std::string File;
};

} // anonymous namespace

//------------------------------------------------------------------------------
Transfer ReadTransfer(const std::string& file)
{
  const Json::Value root = ReadJson(file);
  const MapFile mapFile(file);
  const bool isList = root.isArray() && !root.empty();
  const Json::Value map = isList ? root[0] : root;
  if (!map.isObject() || !map.isMember("RGBPoints"))
  {
    mapFile.Fail("is not a color map: there are no RGBPoints");
  }

  Transfer transfer;
  const std::vector<double> colors = mapFile.ReadNodes(map, "RGBPoints");
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    transfer.Colors.push_back({ colors[i], colors[i + 1], colors[i + 2], colors[i + 3] });
  }
  const double first = transfer.Colors.front().Value;
  const double last = transfer.Colors.back().Value;
  if (!(first < last))
  {
    mapFile.Fail("RGBPoints are all at one value");
  }
  if (map.isMember("Points"))
  {
    const std::vector<double> opacities = mapFile.ReadNodes(map, "Points");
    for (std::size_t i = 0; i < opacities.size(); i += 4)
    {
      transfer.Opacities.push_back(
        { opacities[i], opacities[i + 1], opacities[i + 2], opacities[i + 3] });
    }
  }
  else
  {
    transfer.Opacities = { { first, 0 }, { last, 1 } };
  }
  transfer.Space = mapFile.ReadSpace(map);
  return transfer;
}

//------------------------------------------------------------------------------
void WriteTransfer(vtkVolumeProperty* property, const std::string& name, const std::string& file)
{
  vtkColorTransferFunction* const colors = property->GetRGBTransferFunction();
  vtkPiecewiseFunction* const opacities = property->GetScalarOpacity();
  constexpr std::array<std::pair<int, const char*>, 6> spaces{ {
    { VTK_CTF_RGB, "RGB" },
    { VTK_CTF_HSV, "HSV" },
    { VTK_CTF_LAB, "Lab" },
    { VTK_CTF_LAB_CIEDE2000, "Lab/CIEDE2000" },
    { VTK_CTF_DIVERGING, "Diverging" },
    { VTK_CTF_STEP, "Step" },
  } };
  Json::Value map;
  map["Name"] = name;
  map["ColorSpace"] = std::find_if(spaces.begin(), spaces.end(),
    [&](const auto& space) {
      return space.first == colors->GetColorSpace();
    })->second;
  map["RGBPoints"] = Json::arrayValue;
  for (int i = 0; i < colors->GetSize(); ++i)
  {
    std::array<double, 6> node{}; // value, red, green, blue, midpoint, sharpness
    colors->GetNodeValue(i, node.data());
    std::for_each(node.begin(), node.begin() + 4, [&](double x) { map["RGBPoints"].append(x); });
  }
  map["Points"] = Json::arrayValue;
  for (int i = 0; i < opacities->GetSize(); ++i)
  {
    std::array<double, 4> node{}; // value, opacity, midpoint, sharpness
    opacities->GetNodeValue(i, node.data());
    std::for_each(node.begin(), node.end(), [&](double x) { map["Points"].append(x); });
  }
  Json::Value list(Json::arrayValue);
  list.append(map);
  TemporaryFile temporary(file);
  try
  {
    WriteBytes(temporary.GetName(), JsonText(list));
  }
  catch (const Failure& failure)
  {
    throw Failure(file, failure.what());
  }
  temporary.Commit();
}
}
