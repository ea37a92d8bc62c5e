// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume info: what is in a .ghv file, from its directory alone.

#include "gtnDescription.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnVolume.h"

#include "gatunHartleyFile.h"
#include "gatunVolumeDescription.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace gtn
{
namespace
{

struct VolumeInfoOptions
{
  std::string File;
  bool Json = false;
  bool Verify = false;
};

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeInfo(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<VolumeInfoOptions>();
  CLI::App* command = AddCommand(app, settings, "info",
    "Tell what a .ghv file holds. Only its directory is read, unless it is to be verified.",
    "  gtn volume info head.ghv\n"
    "  gtn volume info -v head.ghv          also the chunks\n"
    "  gtn volume info --verify head.ghv\n"
    "  gtn volume info --json head.ghv | jq .bitsPerVoxel");
  command->add_flag("--json", options->Json, "Print JSON");
  command->add_flag(
    "--verify", options->Verify, "Check all checksums, and decode everything without keeping it");
  command->add_option("IN", options->File, "The .ghv file")->required();
  command->callback(
    [options, &settings]
    {
      CheckReadable(options->File);
      const gatun::HartleyFile file(options->File);
      if (options->Verify)
      {
        Progress progress("verifying", settings.ShowProgress);
        file.Verify([&progress](double fraction) { return progress(fraction); });
        CheckInterrupt();
      }
      const Description description =
        gatun::DescribeVolume(file, options->Verify, settings.Verbose);
      fmt::print("{}", options->Json ? WriteJson(description.GetJson()) : description.GetText());
    });
}
}
