// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The transfer functions that are built in, for values of 0 to 1.

#include "gtnFailure.h"
#include "gtnText.h"
#include "gtnTransfer.h"

#include "gatunDefaultOpacity.h"

#include <fmt/core.h>

#include <filesystem>

namespace gtn
{
namespace
{

struct Preset
{
  const char* Name;
  Transfer Functions;
};

/** The default colors, as a ramp. */
Transfer GetDusk()
{
  Transfer dusk{ {}, {}, ColorSpace::Lab };
  for (const gatun::DefaultColor& color : gatun::GetDefaultColors())
  {
    dusk.Colors.push_back({ color.Value, color.RGB[0], color.RGB[1], color.RGB[2] });
  }
  for (const gatun::OpacityNode& node : gatun::GetDefaultRamp())
  {
    dusk.Opacities.push_back({ node.Value, node.Opacity });
  }
  return dusk;
}

const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets{
    // Two colors around a pale middle; low values hardly hide high ones.
    { "cool-warm",
      { { { 0, 0.20, 0.28, 0.78 }, { 0.5, 0.88, 0.87, 0.86 }, { 1, 0.74, 0.04, 0.14 } },
        { { 0, 0.05 }, { 0.25, 0.03 }, { 0.5, 0.02 }, { 0.75, 0.15 }, { 1, 0.5 } },
        ColorSpace::Lab } },
    { "dusk", GetDusk() },
    // What is high glows.
    { "heat",
      { { { 0, 0.10, 0.00, 0.02 }, { 0.35, 0.70, 0.06, 0.02 }, { 0.7, 1.00, 0.55, 0.05 },
          { 1, 1.00, 0.98, 0.80 } },
        { { 0, 0 }, { 0.1, 0.01 }, { 0.5, 0.08 }, { 1, 0.40 } }, ColorSpace::RGB } },
    // The same opacity for all values: the front hides the back.
    { "gray",
      { { { 0, 0.08, 0.08, 0.08 }, { 1, 0.96, 0.96, 0.96 } }, { { 0, 0.02 }, { 1, 0.25 } },
        ColorSpace::RGB } },
    // Dense parts are bright, as on an X-ray film; for --mode xray, too.
    { "xray",
      { { { 0, 0.75, 0.85, 1.00 }, { 1, 1.00, 1.00, 1.00 } }, { { 0, 0 }, { 1, 0.06 } },
        ColorSpace::RGB } },
    // Of a scan: air is not seen, soft tissue is a haze, bones are solid.
    { "bone",
      { { { 0, 0.35, 0.10, 0.05 }, { 0.35, 0.80, 0.42, 0.30 }, { 0.55, 0.95, 0.80, 0.62 },
          { 1, 1.00, 0.99, 0.95 } },
        { { 0, 0 }, { 0.25, 0 }, { 0.35, 0.03 }, { 0.5, 0.06 }, { 0.65, 0.5 }, { 1, 0.9 } },
        ColorSpace::RGB } },
  };
  return presets;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::vector<std::string> GetPresetNames()
{
  std::vector<std::string> names;
  for (const Preset& preset : GetPresets())
  {
    names.emplace_back(preset.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
Transfer FindTransfer(const std::string& presetOrFile)
{
  for (const Preset& preset : GetPresets())
  {
    if (presetOrFile == preset.Name)
    {
      return preset.Functions;
    }
  }
  // What looks like a file's name is taken for one, so that a missing file is called that.
  std::error_code ignored;
  if (ExtensionOf(presetOrFile) != ".json" && !std::filesystem::exists(presetOrFile, ignored))
  {
    throw UsageError(fmt::format("--tf: '{}' is neither a preset nor a file; the presets are {}",
      Printable(presetOrFile), Joined(GetPresetNames())));
  }
  return ReadTransfer(presetOrFile);
}
}
