// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The values of a volume are those of its voxels, in memory and in a file.

#include "gatunDefaultOpacity.h"
#include "gatunHartleyFile.h"
#include "gatunTestFile.h"
#include "gatunVolumePhantoms.h"
#include "gatunVolumeSurvey.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gatun::test
{
namespace
{
TEST(VolumeSurvey, IsTheSameForALosslessFileAndForAVolumeInMemory)
{
  const auto phantom = MakePhantom<std::uint8_t>({ 70, 50, 30 },
    [](double x, double y, double z)
    { return 20 + 200 * std::exp(-20 * (x * x + y * y + z * z)); });
  VolumeInput input = phantom.GetInput();
  input.Spacing = { 0.5, -2, 1 };
  const ValueSurvey memory = SurveyVolume(input);
  EXPECT_EQ(memory.Values.GetTotal(), 70u * 50 * 30);
  EXPECT_NEAR(memory.Volume, 34.5 * 98 * 29, 1e-6);
  for (const std::uint32_t block : { 0, 5, 8 })
  {
    HartleyWriterOptions options;
    options.BlockSize = block;
    options.RateControl = { HartleyRateMode::RMSError, 0, 0 };
    const std::string path = TempPath("survey.ghv");
    WriteHartleyFile(path, input, options);
    const ValueSurvey file = SurveyVolume(HartleyFile(path));
    EXPECT_EQ(MakeDefaultTransfer(file, 1).Opacities, MakeDefaultTransfer(memory, 1).Opacities);
    EXPECT_EQ(file.Volume, memory.Volume);
  }
  const ValueSurvey part = SurveyVolume(input, Range{ 30, 100 });
  EXPECT_EQ(part.Values.GetRange(), (Range{ 30, 100 }));
}

TEST(VolumeSurvey, VoxelsThatAreNotFiniteDoNotCount)
{
  auto phantom =
    MakePhantom<float>({ 9, 8, 7 }, [](double x, double y, double z) { return x + y * z; });
  phantom.Values[5] = std::nanf("");
  phantom.Values[6] = HUGE_VALF;
  const ValueSurvey survey = SurveyVolume(phantom.GetInput());
  EXPECT_EQ(survey.Values.GetTotal(), 9u * 8 * 7 - 2);
  EXPECT_LT(survey.Values.GetRange().Max, 3);
}
}
}
